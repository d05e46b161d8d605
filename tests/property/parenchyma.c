/* SPDX-License-Identifier: Apache-2.0
 *
 * Axial parenchyma: at a ring's end, in bands, about vessels and between those of a band; as much
 * of it as asked for, where it belongs, and the same in the mean under a footprint.
 */
#include <math.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "wood.h"

#define PLAIN                                                                                      \
  "undulation=0; taper=0; pith_wander=0; slope_noise=0; section_wobble=0; latewood_stray=0; "
#define EVEN PLAIN "ring_variation=0; ring_width=3; "

#define ONES (ONLY(PARENCHYMA) | ONLY(VESSEL) | ONLY(TIME))

/* A square of the section at radius 40, x along the radius and z along the arc. */
enum { SIDE = 480 };
typedef struct {
  double step;
  float soft[SIDE * SIDE], vessel[SIDE * SIDE], year[SIDE * SIDE];
} section;

static section *look(const char *preset, const char *parameters, double step) {
  sozai_texture *t = wood_make(preset, parameters);
  section *s = malloc(sizeof *s);
  points p = {0};
  s->step = step;
  for (int j = 0; j < SIDE; j++) {
    points_clear(&p);
    for (int i = 0; i < SIDE; i++) {
      unsigned n = points_add(&p, 40 + i * step, 0, (j - SIDE / 2) * step, 0);
      p.normal[1][n] = 1;
      p.normal[2][n] = 0;
    }
    points_ask_only(&p, t, ONES);
    for (int i = 0; i < SIDE; i++) {
      s->soft[j * SIDE + i] = p.out[PARENCHYMA][i];
      s->vessel[j * SIDE + i] = p.out[VESSEL][i];
      s->year[j * SIDE + i] = p.out[TIME][i];
    }
  }
  points_free(&p);
  textures->destroy(t);
  return s;
}

static double mean_of(const float *of) {
  double sum = 0;
  for (int i = 0; i < SIDE * SIDE; i++) sum += (double)of[i] / (SIDE * SIDE);
  return sum;
}

static void at_a_rings_end(void **state) {
  (void)state;
  section *s = look(NULL, EVEN "porosity=none; marginal_parenchyma=240", 0.025);
  double share = mean_of(s->soft), before = 0;
  for (int i = 0; i < SIDE * SIDE; i++) {
    double phase = (double)s->year[i] - floor((double)s->year[i]);
    if (phase < 0.9 && phase > 0.03) before = fmax(before, (double)s->soft[i]);
  }
  CHECK(fabs(share - 0.08) < 0.003, "a line of 240 um in rings of 3 mm: %.4f of the wood (0.08)\n",
        share);
  CHECK(before <= 0, "and %.3f of it anywhere else\n", before);
  free(s);
}

static void in_bands(void **state) {
  (void)state;
  section *s = look(NULL,
                    EVEN "porosity=none; parenchyma_band_width=150; parenchyma_band_spacing=0.5; "
                         "parenchyma_band_waviness=0",
                    0.025);
  double share = mean_of(s->soft), begun = 0;
  for (int j = 0; j < SIDE; j++) {
    for (int i = 1; i < SIDE; i++) {
      const float *q = s->soft + j * SIDE + i;
      begun += q[-1] < 0.5f && q[0] >= 0.5f;
    }
  }
  double bands = begun / SIDE, expected = (SIDE - 1) * 0.025 / 0.5;
  CHECK(fabs(bands - expected) < 0.6, "%.2f bands over 12 mm (%.2f)\n", bands, expected);
  CHECK(fabs(share - 0.3) < 0.01, "that are %.4f of the wood (0.3)\n", share);
  free(s);
  s = look(NULL,
           EVEN "porosity=none; parenchyma_band_width=150; parenchyma_band_spacing=0.5; "
                "parenchyma_band_waviness=0.6",
           0.025);
  share = mean_of(s->soft);
  CHECK(fabs(share - 0.3) < 0.02, "bands that stray and swell: %.4f (0.3)\n", share);
  free(s);
}

/* Of the places so far from a vessel's, along the radius and along the arc: how many are
 * parenchyma or vessel. */
static double beside_vessels(const section *s, int out, int round) {
  double all = 0, soft = 0;
  for (int j = 60; j < SIDE - 60; j++) {
    for (int i = 60; i < SIDE - 60; i++) {
      if (s->vessel[j * SIDE + i] < 0.5f) continue;
      int at = (j + round) * SIDE + i + out;
      all++;
      soft += s->soft[at] + s->vessel[at] > 0.5f;
    }
  }
  return soft / all;
}

#define ROUND_VESSELS                                                                              \
  EVEN "porosity=diffuse; vessel_density=5; vessel_diameter=80; vessel_diameter_spread=0; "        \
       "paratracheal_parenchyma=50; "

static void about_vessels(void **state) {
  (void)state;
  section *s = look(NULL, ROUND_VESSELS "paratracheal_wings=1", 0.01);
  int far = 0;
  for (int j = 10; j < SIDE - 10; j++) {
    for (int i = 10; i < SIDE - 10; i++) {
      if (s->soft[j * SIDE + i] < 0.5f) continue;
      int near = 0;
      for (int b = -7; b <= 7 && !near; b++) {
        for (int a = -7; a <= 7 && !near; a++) {
          near = a * a + b * b <= 49 && s->vessel[(j + b) * SIDE + i + a] > 0.5f;
        }
      }
      far += !near;
    }
  }
  CHECK(far == 0, "sheaths of 50 um: %d places of them farther than 70 um from a vessel\n", far);
  double round = beside_vessels(s, 0, 4), out = beside_vessels(s, 4, 0);
  CHECK(round > 0.98 && out > 0.98, "40 um from a vessel's places %.3f, %.3f are soft or vessel\n",
        round, out);
  free(s);

  s = look(NULL, ROUND_VESSELS "paratracheal_wings=2.1", 0.01);
  round = beside_vessels(s, 0, 14);
  out = beside_vessels(s, 14, 0);
  CHECK(round > 0.6 && out < 0.45 && round > 1.7 * out,
        "with wings, 140 um along the arc %.3f, along the radius %.3f\n", round, out);
  free(s);
}

static void between_vessels(void **state) {
  (void)state;
  static const char *const kinds[] = {"tangential", "radial", "diagonal", "dendritic"};
  for (unsigned k = 0; k < 4; k++) {
    char text[512];
    snprintf(text, sizeof text,
             EVEN "porosity=diffuse; vessel_density=40; vessel_diameter=40; vessel_arrangement=%s; "
                  "vessel_bands=1; vessel_band_spacing=1; vessel_band_parenchyma=1",
             kinds[k]);
    section *s = look(NULL, text, 0.02);
    double in = 0, out = 0, soft = 0, tough = 0;
    /* vessels whose surroundings are parenchyma */
    for (int j = 3; j < SIDE - 3; j++) {
      for (int i = 3; i < SIDE - 3; i++) {
        int at = j * SIDE + i;
        soft += s->soft[at] > 0.5f;
        tough += s->soft[at] + s->vessel[at] < 0.5f;
        if (s->vessel[at] < 0.5f) continue;
        int around = 0, paler = 0;
        for (int b = -3; b <= 3; b++) {
          for (int a = -3; a <= 3; a++) {
            around += s->vessel[at + b * SIDE + a] < 0.5f;
            paler += s->soft[at + b * SIDE + a] > 0.5f;
          }
        }
        if (!around) continue;
        *(2 * paler > around ? &in : &out) += 1;
      }
    }
    double denser = in / soft / (out / tough);
    CHECK(denser > 4, "%s: vessels are %.1f times as dense in their bands' parenchyma as beside\n",
          kinds[k], denser);
    free(s);
  }
}

/* Near and far, and never more than there is room for. */
static void means_are_kept(void **state) {
  (void)state;
  static const char *const woods_of_it[] = {"keyaki", "iroko",    "wenge",   "mahogany", "oak",
                                            "kiri",   "rosewood", "zebrano", "hickory"};
  static const double sizes[] = {0, 0.1, 1, 10, 60};
  for (unsigned k = 0; k < sizeof woods_of_it / sizeof *woods_of_it; k++) {
    double mean[5], most = 0;
    sozai_texture *t = wood_make(woods_of_it[k], "cut=end");
    for (int f = 0; f < 5; f++) {
      points p = {0};
      uniform_seed(81);
      mean[f] = 0;
      for (int i = 0; i < 40000; i++) {
        points_add(&p, 100 * (uniform() - 0.5), 100 * (uniform() - 0.5), 0, sizes[f]);
      }
      points_ask_only(&p, t, ONES);
      for (unsigned i = 0; i < p.count; i++) {
        mean[f] += (double)p.out[PARENCHYMA][i] / p.count;
        most = fmax(most, (double)(p.out[PARENCHYMA][i] + p.out[VESSEL][i]));
      }
      points_free(&p);
    }
    textures->destroy(t);
    double off = 0;
    for (int f = 1; f < 5; f++) off = fmax(off, fabs(mean[f] - mean[0]));
    CHECK(mean[0] > 0.02 && off < 0.015 && most < 1.00001,
          "%s: %.3f of it at points, %.3f under 0.1 mm, %.3f 1, %.3f 10, %.3f 60\n", woods_of_it[k],
          mean[0], mean[1], mean[2], mean[3], mean[4]);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(at_a_rings_end), cmocka_unit_test(in_bands),
      cmocka_unit_test(about_vessels),  cmocka_unit_test(between_vessels),
      cmocka_unit_test(means_are_kept),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
