/* SPDX-License-Identifier: Apache-2.0
 *
 * How random the hashes are: avalanche, and correlation between neighbours on
 * lattices whose terms are added up as noise_axial3 adds them.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "core_kernels.h"

#define CHUNK 4096u
#define SIDE 64
#define POINTS (SIDE * SIDE * SIDE)

static float a[CHUNK], r[CHUNK];
static const float *const in[CORE_INPUTS] = {a, a, a, a};
static float *const out[CORE_OUTPUTS] = {r, r, r, r};

/* counters, as well as random numbers: counters are what a lattice gives */
static uint32_t word(uint32_t i, int counters, uint64_t *state) {
  return counters ? i : core_random(state);
}

static void avalanche(int f, uint32_t out_mask, int counters, double allowed) {
  enum { BATCHES = 64 };
  double worst = 0.0;
  for (uint32_t bit = 0; bit < 32; bit++) {
    uint32_t flips[32] = {0};
    uint64_t state = 7;
    for (uint32_t c = 0; c < BATCHES; c++) {
      uint32_t plain[CHUNK];
      uint64_t again = state;
      for (uint32_t i = 0; i < CHUNK; i++) {
        a[i] = core_float(word(c * CHUNK + i, counters, &state));
      }
      core_scalar_1.run[f](CHUNK, in, out);
      for (uint32_t i = 0; i < CHUNK; i++) plain[i] = core_bits(r[i]);
      state = again;
      for (uint32_t i = 0; i < CHUNK; i++) {
        a[i] = core_float(word(c * CHUNK + i, counters, &state) ^ (1u << bit));
      }
      core_scalar_1.run[f](CHUNK, in, out);
      for (uint32_t i = 0; i < CHUNK; i++) {
        uint32_t changed = plain[i] ^ core_bits(r[i]);
        for (uint32_t o = 0; o < 32; o++) flips[o] += changed >> o & 1u;
      }
    }
    for (uint32_t o = 0; o < 32; o++) {
      double p = flips[o] / (double)(BATCHES * CHUNK);
      if (out_mask >> o & 1u) worst = fmax(worst, fabs(p - 0.5));
    }
  }
  print_message("%s, %s: bits %08x flip with 0.5 +- %.4f\n", core_descriptions[f].name,
                counters ? "counters" : "random words", out_mask, worst);
  assert_true(worst < allowed);
}

static void mix_flips_half(void **unused) {
  (void)unused;
  avalanche(CORE_hash_mix, 0xffffffffu, 0, 0.02);
  avalanche(CORE_hash_mix, 0xffffffffu, 1, 0.02);
}

/* hash_upper, which leaves out the last step, is for the upper bits alone: the
 * lower a bit of a product is, the fewer bits of its factors it depends on. */
static void upper_flips_half(void **unused) {
  (void)unused;
  avalanche(CORE_hash_upper, 0xffffffe0u, 0, 0.06);
  avalanche(CORE_hash_upper, 0xffff0000u, 0, 0.02);
}

/* The multipliers of hash.h: a lattice point's term is a sum of these. */
static const uint32_t axis[3] = {0x6a09e667u, 0xbb67ae85u, 0x3c6ef373u};

static double lattice[SIDE][SIDE][SIDE];

static void fill_lattice(int f, uint32_t seed, const int32_t origin[3]) {
  double *at = &lattice[0][0][0];
  for (uint32_t i = 0; i < POINTS; i += CHUNK) {
    for (uint32_t k = 0; k < CHUNK; k++) {
      int32_t x = origin[0] + (int32_t)((i + k) / (SIDE * SIDE));
      int32_t y = origin[1] + (int32_t)((i + k) / SIDE % SIDE);
      int32_t z = origin[2] + (int32_t)((i + k) % SIDE);
      a[k] = core_float((uint32_t)x * axis[0] + (uint32_t)z * axis[2] +
                        ((uint32_t)y * axis[1] + seed));
    }
    core_scalar_1.run[f](CHUNK, in, out);
    for (uint32_t k = 0; k < CHUNK; k++) {
      at[i + k] = f == CORE_hash_signed ? (double)r[k] / 2147483648.0
                                        : core_bits(r[k]) / 2147483648.0 - 1.0;
    }
  }
}

static double correlation(int dx, int dy, int dz) {
  double ab = 0, aa = 0, bb = 0, sa = 0, sb = 0, n = 0;
  for (int x = 0; x < SIDE - dx; x++) {
    for (int y = dy < 0 ? -dy : 0; y < SIDE - (dy > 0 ? dy : 0); y++) {
      for (int z = dz < 0 ? -dz : 0; z < SIDE - (dz > 0 ? dz : 0); z++) {
        double u = lattice[x][y][z], v = lattice[x + dx][y + dy][z + dz];
        ab += u * v, aa += u * u, bb += v * v, sa += u, sb += v, n += 1;
      }
    }
  }
  return (ab - sa * sb / n) / sqrt((aa - sa * sa / n) * (bb - sb * sb / n));
}

/* The thirteen directions to a neighbour; the other thirteen are the same. */
static double worst_neighbour(int where[3]) {
  double worst = 0.0;
  for (int dx = 0; dx <= 1; dx++) {
    for (int dy = -1; dy <= 1; dy++) {
      for (int dz = -1; dz <= 1; dz++) {
        if (dx * 9 + dy * 3 + dz <= 0) continue;
        double c = fabs(correlation(dx, dy, dz));
        if (c > worst) {
          worst = c;
          where[0] = dx, where[1] = dy, where[2] = dz;
        }
      }
    }
  }
  return worst;
}

/* Several seeds, at the origin and far out. */
static void neighbours(int f) {
  uint64_t state = 11;
  double worst = 0.0, mean = 0.0, spread = 0.0;
  int where[3] = {0, 0, 0};
  enum { TRIES = 8 };
  for (int t = 0; t < TRIES; t++) {
    int32_t origin[3] = {-SIDE / 2, -SIDE / 2, -SIDE / 2};
    for (int c = 0; c < 3 && t % 2; c++) origin[c] = (int32_t)(core_random(&state) >> 4);
    fill_lattice(f, t ? core_random(&state) : 0u, origin);
    double sum = 0.0, square = 0.0;
    for (int i = 0; i < POINTS; i++) {
      double v = (&lattice[0][0][0])[i];
      sum += v, square += v * v;
    }
    mean = fmax(mean, fabs(sum / POINTS));
    spread = fmax(spread, fabs(square / POINTS - 1.0 / 3.0));
    int at[3] = {0, 0, 0};
    double c = worst_neighbour(at);
    if (c > worst) worst = c, where[0] = at[0], where[1] = at[1], where[2] = at[2];
  }
  print_message("%s: neighbours correlate by %.4f at most, towards (%d, %d, %d); mean within %.4f "
                "of 0, variance within %.4f of 1/3\n",
                core_descriptions[f].name, worst, where[0], where[1], where[2], mean, spread);
  assert_true(worst < 0.01);
  assert_true(mean < 0.01 && spread < 0.01);
}

static void neighbours_of_signed(void **unused) {
  (void)unused;
  neighbours(CORE_hash_signed);
}

static void neighbours_of_mix(void **unused) {
  (void)unused;
  neighbours(CORE_hash_mix);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(mix_flips_half), cmocka_unit_test(upper_flips_half),
      cmocka_unit_test(neighbours_of_signed), cmocka_unit_test(neighbours_of_mix)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
