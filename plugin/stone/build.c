/* SPDX-License-Identifier: Apache-2.0
 *
 * From settings to the constants that the kernel reads.
 */
#include "build.h"

#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "paper_table.h"
#include "parameters.h"

/* ---- what varies slowly ----------------------------------------------- */

/* The slope of the beds' two waves (bands.h) along one axis, sd, over height by length: of value
 * noise it is 1.8 sd to a cell, and the lesser wave's is 0.4 by 2.7 of the other's. */
#define BEDS_STEEP (0.224 * 1.8 * 1.47)
#define BEDS_LAG_MOST 50.0 /* steeper, waves would be finer than what they move */

/* Across the first family a direction with equal chances, by its height and azimuth; the
 * others' at angles to it at which fractures of several strains cross, and to each other. */
static void build_vein_frame(stone_constants *w, uint32_t seed) {
  static const double lean[VEIN_FAMILIES] = {0.0, 1.05, 1.31},
                      turn[VEIN_FAMILIES] = {0.0, 0.0, 1.9};
  uint32_t h = hash1(seed);
  double y = (double)(h >> 16) / 32768.0 - 1.0, r = __builtin_sqrt(1.0 - y * y),
         t = 6.283185307179586 * (double)(h & 65535u) / 65536.0,
         about = 6.283185307179586 * (double)(hash1(seed + 1u) >> 16) / 65536.0;
  double m[3] = {r * scalar_cos(t), y, r * scalar_sin(t)},
         u[3] = {-scalar_sin(t), 0.0, scalar_cos(t)},
         v[3] = {-y * scalar_cos(t), r, -y * scalar_sin(t)};
  for (int f = 0; f < VEIN_FAMILIES; f++) {
    double a = about + turn[f], c = scalar_cos(lean[f]), d = scalar_sin(lean[f]);
    for (int k = 0; k < 3; k++) {
      double out = scalar_cos(a) * u[k] + scalar_sin(a) * v[k];
      w->vein_frame[f][0][k] = (float)(c * m[k] + d * out);
      w->vein_frame[f][1][k] = (float)(c * out - d * m[k]);
      w->vein_frame[f][2][k] = (float)(scalar_cos(a) * v[k] - scalar_sin(a) * u[k]);
    }
  }
}

/* How nearly veins lie along a face that is square to an axis: over 1 there are places, as they
 * wander, where it cuts them into blots. */
static float vein_frame_along(const stone_constants *w) {
  static const float most[VEIN_FAMILIES] = {0.8f, 0.86f, 0.9f};
  float along = 0.0f;
  for (int f = 0; f < VEIN_FAMILIES; f++) {
    for (int k = 0; k < 3; k++) {
      float x = w->vein_frame[f][0][k];
      x = (x < 0.0f ? -x : x) / most[f];
      if (x > along) along = x;
    }
  }
  return along;
}

#define VEIN_FRAMES 64u

/* A block is sawn across its veins: of directions by chance the first that no face of a cuboid lies
 * along, or the one that does so least. */
static void build_vein_frames(stone_constants *w) {
  float least = 1e9f;
  uint32_t best = 0;
  for (uint32_t i = 0; i < VEIN_FRAMES && least > 1.0f; i++) {
    build_vein_frame(w, w->seed + 211u + 2u * i * 0x9e3779b9u);
    float along = vein_frame_along(w);
    if (along >= least) continue;
    least = along;
    best = i;
  }
  build_vein_frame(w, w->seed + 211u + 2u * best * 0x9e3779b9u);
}

static void build_bands(stone_constants *w, const settings *s) {
  w->bed_contrast = (float)number_at(s, P_BED_CONTRAST);
  w->bed_frequency = (float)(1.0 / number_at(s, P_BED_THICKNESS));
  w->bed_wave = (float)number_at(s, P_BED_WAVE);
  w->bed_wave_frequency = (float)(1.0 / number_at(s, P_BED_WAVELENGTH));
  double steep = BEDS_STEEP * number_at(s, P_BED_WAVE) / number_at(s, P_BED_WAVELENGTH);
  double lag = number_at(s, P_BED_PINCHING);
  lag = lag < BEDS_LAG_MOST * steep ? lag / steep : 0.0;
  w->bed_lag = (float)lag;
  w->has_beds = w->bed_contrast > 0.0f;
  w->mottle = (float)number_at(s, P_MOTTLE);
  w->mottle_frequency = (float)(1.0 / number_at(s, P_MOTTLE_SIZE));
  w->has_mottle = w->mottle > 0.0f;
  w->vein_width = (float)number_at(s, P_VEIN_WIDTH);
  w->vein_soft = (float)number_at(s, P_VEIN_SOFTNESS);
  w->vein_frequency = (float)(1.0 / number_at(s, P_VEIN_SPACING));
  w->vein_warp = (float)number_at(s, P_VEIN_WARP);
  w->vein_crossing = (float)number_at(s, P_VEIN_CROSSING);
  w->vein_variation = (float)number_at(s, P_VEIN_VARIATION);
  build_vein_frames(w);
  w->has_veins = w->vein_width > 0.0f;
  w->seed_bed = hash1(w->seed + 101u);
  w->seed_vein = hash1(w->seed + 102u);
  w->seed_mottle = hash1(w->seed + 103u);
  w->seed_relief = hash1(w->seed + 104u);
}

/* ---- finish ----------------------------------------------------------- */

/* Heights and sizes of each octave in mm, sizes of 0 or less in grains; GGX's
 * alpha of what is finer. After the ranges of roughness that stone standards
 * and makers give for dressed faces (DIN 18500; JIS A 5003): polished below
 * 0.01 mm, flamed 1 to 3 mm, bush hammered 2 to 4 mm, split 10 mm and more. */
typedef struct {
  double alpha, height[STONE_RELIEF], size[STONE_RELIEF];
  int pitted;
  double sheet[CLEFT_FAMILIES], reach[CLEFT_FAMILIES]; /* mm: steps' height, a terrace's length */
  double ledge[CLEFT_FAMILIES], thick[CLEFT_FAMILIES]; /* mm: of edges, height; two sheets */
  double facet[FACET_SIZES], steep[FACET_SIZES];       /* mm: a cell; heights, of that */
} finish;

static const finish finishes[FINISHES] = {
    [FINISH_SAWN] = {.alpha = 0.55, .height = {0.05, 0.03}, .size = {6.0, 0.8}},
    [FINISH_POLISHED] = {.alpha = 0.04, .height = {0.0008}, .size = {-1.0}},
    [FINISH_HONED] = {.alpha = 0.28, .height = {0.006, 0.003}, .size = {-1.0, 0.4}},
    [FINISH_FLAMED] = {.alpha = 0.6,
                       .height = {0.9, 0.8, 0.35, 0.12},
                       .size = {-5.0, -1.8, -0.7, -0.25}},
    [FINISH_BUSH] = {.alpha = 0.65,
                     .height = {0.9, 0.5, 0.3, 0.1},
                     .size = {5.5, 3.1, 1.2, 0.4},
                     .pitted = 1},
    [FINISH_SPLIT] = {.alpha = 0.6,
                      .height = {16.0, 5.0},
                      .size = {130.0, 47.0},
                      .facet = {26.0, 8.0, 2.5},
                      .steep = {0.2, 0.15, 0.1}},
    [FINISH_RIVEN] = {.alpha = 0.5,
                      .height = {1.6, 0.5, 0.2, 0.1},
                      .size = {160.0, 30.0, 8.0, 2.2},
                      .sheet = {2.4, 0.8},
                      .reach = {130.0, 48.0},
                      .ledge = {0.6, 0.22},
                      .thick = {5.0, 1.6}},
};

/* Variance of one component of gradient noise's gradient, and of that times
 * -5 times its value, over all points: property.stone_relief measures both. */
#define SLOPE2 0.248
#define SLOPE2_PITTED 0.212

/* Of a step of height 1 in a family of frequency 1, over all points (property.stone_relief). */
#define SLOPE2_CLEFT 59.0
/* Likewise of a ledge, of a face square to the sheets. */
#define SLOPE2_LEDGE 1.81
#define LEDGE_ALONG 0.05 /* how fast ledges change along the sheets, of across */

#define WATER_IOR 1.333
#define SOAKS_FROM 0.35 /* alpha: rougher faces are open, and water darkens them in full */

static void build_cleft(stone_constants *w, const finish *f, double scale) {
  for (int i = 0; i < CLEFT_FAMILIES && f->sheet[i] > 0.0; i++) {
    stone_cleft *c = &w->cleft[i];
    double slope = scale * f->sheet[i] / f->reach[i];
    c->height = (float)(scale * f->sheet[i]);
    c->frequency = (float)(1.0 / f->reach[i]);
    c->slope2 = (float)(slope * slope * SLOPE2_CLEFT);
    c->seed = hash1(w->seed_relief + 31u * (uint32_t)(i + 1));
    w->relief_steep += c->slope2;
    w->is_cleft = 1;
    stone_ledges *e = &w->ledges[i];
    slope = scale * f->ledge[i] / f->thick[i];
    e->height = (float)(scale * f->ledge[i]);
    e->across = (float)(1.0 / f->thick[i]);
    e->along = (float)(LEDGE_ALONG / f->thick[i]);
    e->slope2 = (float)(slope * slope * SLOPE2_LEDGE);
    e->seed = hash1(c->seed);
  }
}

static void build_facets(stone_constants *w, const finish *f, double scale) {
  for (int i = 0; i < FACET_SIZES && f->facet[i] > 0.0; i++) {
    stone_facets *c = &w->facets[i];
    double steep = scale * f->steep[i];
    c->height = (float)(steep * f->facet[i]);
    c->frequency = (float)(1.0 / f->facet[i]);
    c->slope2 = (float)(steep * steep * (double)FACET_SLOPE2);
    c->seed = hash1(w->seed_relief + 57u * (uint32_t)(i + 1));
    w->relief_steep += c->slope2;
    w->faceted = 1;
  }
}

static void build_finish(stone_constants *w, const settings *s) {
  const finish *f = &finishes[choice_at(s, P_FINISH)];
  double scale = number_at(s, P_RELIEF), grain = number_at(s, P_GRAIN_SIZE);
  if (grain < 0.4) grain = 0.4; /* heat and hammers take more than a single fine grain */
  w->pitted = f->pitted;
  for (int o = 0; o < STONE_RELIEF && f->size[o] != 0.0; o++) {
    double size = f->size[o] < 0.0 ? -f->size[o] * grain : f->size[o], height = f->height[o];
    /* a coarse stone spalls deeper */
    if (f->size[o] < 0.0 && choice_at(s, P_FINISH) == FINISH_FLAMED) height *= grain / 3.0;
    double slope = scale * height / size;
    w->relief[o] = (float)(scale * height);
    w->relief_frequency[o] = (float)(1.0 / size);
    w->relief_slope2[o] = (float)(slope * slope * (f->pitted && o < 2 ? SLOPE2_PITTED : SLOPE2));
    w->relief_steep += w->relief_slope2[o];
    w->relief_octaves = o + 1;
  }
  build_facets(w, f, scale);
  build_cleft(w, f, scale);
  /* normal distributions and gravel's domes; steps are few and steep */
  w->leaning = w->is_cleft ? 20.0f : 5.5f;
  w->glancing = w->is_cleft ? 0.4f : w->faceted ? 1.0f : 0.8f;
  double alpha = f->alpha * number_at(s, P_ROUGHNESS);
  if (alpha > 1.0) alpha = 1.0;
  if (alpha < 0.02) alpha = 0.02;
  w->alpha2 = (float)(alpha * alpha);
  double n = number_at(s, P_IOR), r = (n - 1.0) / (n + 1.0);
  w->specular = (float)(r * r);
  double below = (n - WATER_IOR) / (n + WATER_IOR);
  w->specular_wet = (float)(below * below);
  double open = alpha / SOAKS_FROM;
  w->soaks = (float)(open < 1.0 ? open : 1.0);
}

/* ---- the paper's colours ---------------------------------------------- */

static int32_t build_paper(stone_constants *w, const sozai_host *host, const settings *s) {
  w->mode = choice_at(s, P_MODE);
  if (w->mode == MODE_FABRIC) return SOZAI_OK;
  w->texel = (float)number_at(s, P_PAPER_TEXEL);
  w->inverse_texel = (float)(1.0 / number_at(s, P_PAPER_TEXEL));
  for (int c = 0; c < 3; c++) {
    w->base[c] = (float)s->list[P_PAPER_BASE].number[c];
    w->spread[c] = (float)s->list[P_PAPER_VARIATION].number[c];
  }
  /* Rec.709's weights, of encoded numbers: luma */
  w->luma = (float)(0.2126 * (double)w->base[0] + 0.7152 * (double)w->base[1] +
                    0.0722 * (double)w->base[2]);
  w->lightness = (float)number_at(s, P_PAPER_LIGHTNESS);
  w->chroma = (float)number_at(s, P_PAPER_CHROMA);
  double black = number_at(s, P_PAPER_BLACK), white = number_at(s, P_PAPER_WHITE);
  if (black + white > 1.0) white = 1.0 - black;
  w->black = (float)black;
  w->white = (float)(black + white);
  return paper_build(w, host);
}

enum { BED_X, BED_Y, BED_Z, BED_USUAL };

/* Which axis of the object lies across the bed. */
static int bed_axis(const settings *s) {
  int bed = choice_at(s, P_BED);
  if (bed != BED_USUAL) return bed;
  return choice_at(s, P_LAYOUT) == LAYOUT_NONE ? BED_Y : BED_Z;
}

int32_t stone_build(stone_constants *w, const sozai_host *host, const settings *s,
                    const float (*colours)[3], const stone_kernel *kernel) {
  w->seed = hash1_named((uint32_t)number_at(s, P_SEED) + 0x7f4a7c15u, s->list[P_OBJECT].text);
  w->swap = bed_axis(s);
  for (int c = 0; c < 3; c++) w->offset[c] = (float)s->list[P_OFFSET].number[c];
  memcpy(w->colour, colours[P_BASE], sizeof w->colour); /* they stand together in both */
  build_bands(w, s);
  build_finish(w, s);
  stone_build_layers(w, s, kernel->measure);
  w->hole_depth = (float)(number_at(s, P_HOLE_SIZE) * number_at(s, P_HOLE_DEPTH));
  int32_t r = stone_build_paving(w, s, colours, kernel->measure_laid);
  if (!r) r = build_paper(w, host, s);
  if (!r) r = paper_build_tile(w, s, kernel->scan);
  w->hollow = (float)scalar_least((double)HOLLOW * scalar_root((double)w->relief_steep), 1.0);
  return r;
}
