/* SPDX-License-Identifier: Apache-2.0 */
#include "furrows.h"

#include "../core/hash1.h"
#include "../core/scalar.h"

/* Cells to a plate's mean width along a line, from furrow to furrow where they are lower than half
 * the mean: 1.0 to 1.3 over 0.88 as a mesh shows it, measured, as plates are flat or round. */
#define CELL 0.88f
#define JITTER 0.8f     /* cells: how far a cell's point strays, from edge to edge */
#define BEND 0.45f      /* cells: how far furrows stray from straight, at most */
#define BEND_FINER 0.6f /* how wide that is: cells to a cell */
#define CRACKS 2.6f     /* how many finer cells to one, along an axis */
#define CRACKED 0.22f   /* how deep the finer furrows are, of the whole */
#define UNEVEN 0.3f     /* how much plates differ in height */
#define SHALLOW 0.3f    /* how deep cracks are where cells have grown together */
#define FLAKED 0.4f     /* how much lower a scale may be than another, */
#define LIFTED 0.2f     /* and than its own lower end at its upper one */
#define THICKEST 0.16f  /* of the stem's radius: no bark is thicker */

static uint32_t cell_hash(const int32_t c[3], uint32_t seed) {
  return hash1(seed + (uint32_t)c[0] * 0x9e3779b1u + (uint32_t)c[1] * 0x85ebca77u +
               (uint32_t)c[2] * 0xc2b2ae3du);
}

static float smooth(float t) {
  if (!(t > 0.0f)) return 0.0f;
  return t < 1.0f ? t * t * (3.0f - 2.0f * t) : 1.0f;
}

static float mixed(float a, float b, float t) { return a + (b - a) * t; }

/* Value noise, two of them, within +-1. */
static void bends(const float q[3], uint32_t seed, float out[2]) {
  int32_t c[3];
  float w[3], v[2][8];
  for (int k = 0; k < 3; k++) {
    c[k] = scalar_floor((double)q[k]);
    w[k] = smooth(q[k] - (float)c[k]);
  }
  for (int i = 0; i < 8; i++) {
    int32_t at[3] = {c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2)};
    uint32_t h = cell_hash(at, seed);
    v[0][i] = (float)(h & 0xffffu) * (1.0f / 32767.5f) - 1.0f;
    v[1][i] = (float)(h >> 16) * (1.0f / 32767.5f) - 1.0f;
  }
  for (int n = 0; n < 2; n++) {
    float low = mixed(mixed(v[n][0], v[n][1], w[0]), mixed(v[n][2], v[n][3], w[0]), w[1]);
    float high = mixed(mixed(v[n][4], v[n][5], w[0]), mixed(v[n][6], v[n][7], w[0]), w[1]);
    out[n] = mixed(low, high, w[2]);
  }
}

/* ---- cells -------------------------------------------------------------------- */

typedef struct {
  float sunk;    /* 1 at a border, 0 from `edge` cells on; borders are not alike */
  float up;      /* of the cell's point, in cells along the stem */
  uint32_t hash; /* of the cell */
} plate;

/* Whether two cells have grown together. */
static int are_joined(uint32_t a, uint32_t b, float joined) {
  return (float)(hash1(a ^ b) >> 16) < joined * 65536.0f;
}

/* How deep a crack is whose sides lie that far apart, of which so much along the stem. */
static float across_stem(float along, float square) {
  return smooth((along * along / square - 0.25f) * 2.5f);
}

/* Voronoi's cells of jittered points: of each border the distance to the bisector. */
static plate plate_at(const float q[3], uint32_t seed, float edge, float joined, float ridges) {
  int32_t c[3];
  float from[27][3], nearest = 1e9f;
  uint32_t hash[27], at = 0;
  for (int k = 0; k < 3; k++) c[k] = scalar_floor((double)q[k]);
  for (uint32_t i = 0; i < 27; i++) {
    const int32_t cell[3] = {c[0] + (int32_t)(i % 3) - 1, c[1] + (int32_t)(i / 3 % 3) - 1,
                             c[2] + (int32_t)(i / 9) - 1};
    uint32_t h = hash[i] = cell_hash(cell, seed);
    float sum = 0.0f;
    for (int k = 0; k < 3; k++) {
      float off = ((float)(h >> (10 * k) & 1023u) * (1.0f / 1023.0f) - 0.5f) * JITTER + 0.5f;
      from[i][k] = (float)cell[k] + off - q[k];
      sum += from[i][k] * from[i][k];
    }
    if (sum < nearest) nearest = sum, at = i;
  }
  plate out = {0.0f, -from[at][1], hash[at]};
  float inverse = 1.0f / edge;
  for (uint32_t i = 0; i < 27; i++) {
    if (i == at) continue;
    float dot = 0.0f, apart = 0.0f, d[3];
    for (int k = 0; k < 3; k++) {
      d[k] = from[i][k] - from[at][k];
      dot += 0.5f * (from[i][k] + from[at][k]) * d[k];
      apart += d[k] * d[k];
    }
    /* two points that fall together have no border */
    if (!(apart > 1e-6f)) continue;
    float sunk = 1.0f - smooth(dot * inverse / __builtin_sqrtf(apart));
    if (!(sunk > out.sunk)) continue;
    if (joined > 0.0f && are_joined(hash[i], hash[at], joined)) sunk *= SHALLOW;
    if (ridges > 0.0f) sunk *= 1.0f - ridges * across_stem(d[1], apart);
    if (sunk > out.sunk) out.sunk = sunk;
  }
  return out;
}

furrow_place furrows_at(const furrows *f, const float p[3]) {
  float q[3] = {p[0] * f->across, p[1] * f->along, p[2] * f->across}, wide[3], bend[2];
  for (int k = 0; k < 3; k++) wide[k] = BEND_FINER * q[k];
  bends(wide, f->seed ^ 0x51ed270bu, bend);
  q[0] += BEND * bend[0];
  q[2] += BEND * bend[1];
  plate whole = plate_at(q, f->seed, f->edge, f->joined, f->ridges);
  for (int k = 0; k < 3; k++) q[k] *= CRACKS;
  plate fine = plate_at(q, f->seed ^ 0x2c1b3c6du, 0.3f, 0.0f, 0.0f);
  float level = 1.0f - UNEVEN * (float)(whole.hash >> 24) * (1.0f / 255.0f);
  float cracks = 1.0f - CRACKED * fine.sunk, own = (float)(fine.hash >> 16) * (1.0f / 65535.0f);
  /* a scale stands off at its lower end */
  float up = fine.up < -0.5f ? 0.0f : fine.up < 0.5f ? 0.5f + fine.up : 1.0f;
  float scale = f->scales * (FLAKED * own + LIFTED * up);
  float kind = (float)(whole.hash >> 8 & 0xffffu) * (1.0f / 65535.0f);
  return (furrow_place){(1.0f - whole.sunk) * level * cracks * (1.0f - scale),
                        1.5f * (kind - 0.5f) + 0.5f * (own - 0.5f)};
}

float furrows_depth(const furrows *f, float old, float r) {
  float most = THICKEST * r, depth = f->depth < most ? f->depth : most;
  return depth * old;
}

float furrows_cut(const furrows *f, float y) {
  if (!(y < f->reach)) return 0.0f;
  return smooth(2.0f * (f->reach - y) / f->reach);
}

void furrows_steps(const furrows *f, float out[2]) {
  out[0] = 0.23f / f->across;
  if (out[0] < 5.0f) out[0] = 5.0f;
  out[1] = 0.16f / f->along;
  if (out[1] < out[0]) out[1] = out[0];
  if (out[1] > 3.0f * out[0]) out[1] = 3.0f * out[0];
}

/* Places enough for the mean to be known to a hundredth. */
#define PLACES 4096u

furrows furrows_of(const tree_plan *p) {
  furrows f = {.across = 1.0f / (CELL * p->bark_width),
               .along = 1.0f / (CELL * p->bark_length),
               .edge = 0.36f - 0.18f * p->bark_plates,
               /* a tree too young for any wants no mean of them */
               .depth = p->age > (double)p->rhytidome_from ? p->bark_depth : 0.0f,
               .joined = p->bark_joined,
               .ridges = p->bark_ridges,
               .scales = p->bark_scales,
               .shade = p->bark_shade,
               .reach = p->bark_reach,
               .seed = hash1(p->seed ^ 0x7feb352du)};
  if (!(f.depth > 0.0f)) return f;
  float sum = 0.0f;
  for (uint32_t i = 0; i < PLACES; i++) {
    uint32_t h = hash1(i), g = hash1(h);
    const float at[3] = {(float)(h & 0xffffu) * (1.0f / 1024.0f) / f.across,
                         (float)(h >> 16) * (1.0f / 1024.0f) / f.along,
                         (float)(g >> 16) * (1.0f / 1024.0f) / f.across};
    sum += furrows_at(&f, at).height;
  }
  f.mean = sum * (1.0f / (float)PLACES);
  return f;
}
