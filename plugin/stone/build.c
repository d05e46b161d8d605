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

#define MEASURED 8192u     /* points, for means that have no formula; whole blocks of every width */
#define CELLS_WHOLE 0.05f  /* cells: wider looks at that contrast are seen in quarters */
#define SPARSE 0.15f       /* of cells in most places, a body: fewer are asked for first */
#define CLOUDS_WHOLE 0.04f /* the same over the turbidity of what is seen */

static uint32_t seed_of(const settings *s) {
  uint32_t h = hash1((uint32_t)number_at(s, P_SEED) + 0x7f4a7c15u);
  for (const char *t = s->list[P_OBJECT].text; t && *t; t++) {
    h = hash1(h ^ (uint32_t)(unsigned char)*t);
  }
  return h;
}

/* ---- layers of cells -------------------------------------------------- */

typedef struct {
  double size, stretch, grading, interlock, gap, roundness, variation, blur, share[2];
  double depth, cleavage, turbidity, flatness, cluster;
} body;

static void build_cells(stone_cells *c, uint32_t seed, const body *b, int shaped) {
  /* a rotation in whole numbers: no axis, no diagonal */
  static const double aslant[3][3] = {{2.0, 6.0, 9.0}, {6.0, 7.0, -6.0}, {-9.0, 6.0, -2.0}};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      c->turn[i][k] = (float)(aslant[i][k] / 11.0 * (k == 1 ? b->stretch : 1.0) / b->size);
    }
  }
  c->grading = (float)(0.35 * b->grading);
  /* noise's gradient is within +-3 and mostly within +-1 */
  c->warp = (float)(0.2 * b->interlock);
  c->warp_fine = (float)(0.045 * b->interlock);
  c->variation = (float)b->variation;
  c->blur = (float)(b->blur / b->size);
  c->depth = (float)(0.6 * b->depth);
  c->cleavage = (float)b->cleavage;
  c->turbidity = (float)b->turbidity;
  c->seed = hash1(seed);
  c->seed_warp = hash1(seed + 0x51ed270bu);
  c->on = 1;
  c->size = (float)b->size;
  c->shaped = shaped;
  c->fade = 6.0f;
  c->whole = CELLS_WHOLE;
  c->looks = 3.7f;
  c->spread = 0.3f; /* borders within a wide footprint are many, and err either way */
  c->least = 1.45f;
  c->fours = 1.0f;
  c->radius = 9.0f;
  c->thick = 1.0f;
  c->cluster = (float)b->cluster;
  if (shaped) {
    c->erode = (float)(0.5 * b->gap / b->size);
    c->erode_spread = (float)(0.42 * b->grading * (1.0 - b->roundness));
    if (b->roundness > 0.0) {
      c->radius = (float)(0.9 - 0.42 * b->roundness);
      c->radius_spread = (float)(b->grading * b->roundness);
    }
    /* of a ball of a cell's volume, down to a seventh of its thickness */
    if (b->flatness > 0.0) c->thick = (float)(0.62 * (1.0 - 0.85 * b->flatness));
    c->looks = 4.5f;
    c->spread = 0.12f;
    c->least = 1.4f;
    c->grading = 0.0f;
  }
}

/* What part of the cells a share of area takes, their bodies filling `fill`. */
static void set_shares(stone_cells *c, const body *b, double fill) {
  double left = 1.0, sum = 0.0;
  for (int k = 0; k < 2; k++) {
    double p = fill > 1e-6 ? b->share[k] / fill : 0.0;
    if (p > left) p = left;
    left -= p;
    sum += p;
    c->chance[k] = (float)sum;
    c->mean[k] = (float)(p * fill);
  }
  /* where there are most there can be no more than all */
  double most = sum > 0.0 ? 1.0 / sum - 1.0 : 0.0;
  if (most > 0.95) most = 0.95;
  if ((double)c->cluster > most) c->cluster = (float)most;
}

/* Bodies that keep to certain beds, by as much as `share`. Where there are most there can
 * be no more than all. */
static void set_bedding(stone_cells *c, const stone_constants *w, double share) {
  stone_bedding *b = &c->beds;
  double sum = (double)c->chance[1], most = sum > 0.0 ? 1.0 / sum : 0.0;
  /* in two families of beds: few + 2 more is most; few + 2 part more is 1 */
  double times = (most - 1.0 + share) / share;
  if (times > 3.5) times = 3.5;
  if (times < 1.0) return;
  c->bedded = 1;
  b->few = (float)(1.0 - share);
  b->more = (float)(0.5 * share * times);
  b->part = (float)(1.0 / times);
  for (int k = 0; k < 3; k++) {
    double square = 0.0;
    for (int i = 0; i < 3; i++) square += (double)c->turn[i][k] * (double)c->turn[i][k];
    for (int i = 0; i < 3; i++) b->across[k][i] = (float)((double)c->turn[i][k] / square);
  }
  b->frequency[0] = 0.6f * w->bed_frequency;
  b->frequency[1] = 1.7f * w->bed_frequency;
  b->wave = w->bed_wave;
  b->wave_frequency = w->bed_wave_frequency;
  b->seed = hash1(c->seed + 77u);
  b->seed_wave = w->seed_bed + 7u; /* bands.h: the beds' own */
}

static body grains_of(const settings *s) {
  body b = {.size = number_at(s, P_GRAIN_SIZE),
            .stretch = number_at(s, P_GRAIN_STRETCH),
            .grading = number_at(s, P_GRAIN_GRADING),
            .interlock = number_at(s, P_GRAIN_INTERLOCK),
            .variation = number_at(s, P_VARIATION),
            .blur = number_at(s, P_GRAIN_BLUR),
            .share = {number_at(s, P_SECOND_SHARE), number_at(s, P_THIRD_SHARE)},
            .depth = number_at(s, P_GRAIN_DEPTH),
            .cleavage = number_at(s, P_CLEAVAGE),
            .turbidity = number_at(s, P_TURBIDITY),
            .cluster = number_at(s, P_GRAIN_CLUSTERING)};
  return b;
}

static body inclusions_of(const settings *s) {
  body b = {.size = number_at(s, P_INCLUSION_SIZE),
            .stretch = number_at(s, P_INCLUSION_STRETCH),
            .grading = number_at(s, P_INCLUSION_GRADING),
            .interlock = number_at(s, P_INCLUSION_INTERLOCK),
            .gap = number_at(s, P_INCLUSION_GAP),
            .roundness = number_at(s, P_INCLUSION_ROUNDNESS),
            .variation = number_at(s, P_INCLUSION_VARIATION),
            .blur = 0.3 * number_at(s, P_GRAIN_BLUR),
            .share = {number_at(s, P_INCLUSION_SHARE), number_at(s, P_INCLUSION_SECOND_SHARE)}};
  return b;
}

/* Specks and holes are ragged, and of all sizes up to the largest. */
static body specks_of(const settings *s) {
  body b = {.size = number_at(s, P_SPECK_SIZE),
            .stretch = number_at(s, P_SPECK_STRETCH),
            .grading = 0.8,
            .interlock = 0.6,
            .roundness = 0.4,
            .blur = 0.3 * number_at(s, P_GRAIN_BLUR),
            .share = {number_at(s, P_BLACK_SHARE), number_at(s, P_WHITE_SHARE)},
            .variation = 0.3 * number_at(s, P_CLEAVAGE),
            .cleavage = 3.0 * number_at(s, P_CLEAVAGE),
            .flatness = number_at(s, P_SPECK_FLATNESS),
            .cluster = number_at(s, P_SPECK_CLUSTERING)};
  return b;
}

static body holes_of(const settings *s) {
  body b = {.size = number_at(s, P_HOLE_SIZE),
            .grading = 0.85,
            .interlock = 2.0 * number_at(s, P_HOLE_RAGGEDNESS),
            .roundness = 0.8,
            .share = {number_at(s, P_HOLE_SHARE), 0.0}};
  /* hole_size is across the bed, a cell's size along it */
  b.stretch = number_at(s, P_HOLE_STRETCH);
  b.size *= b.stretch;
  return b;
}

/* ---- how closely a footprint is looked at ------------------------------ */

/* The contrast that 4.5 looks to a body and 3 to a grain, and means from six
 * cells on, were chosen for: that of white granite's feldspar and quartz. */
#define CONTRAST 0.19

/* Relative sd of what is seen within a crystal, of turbidity 1 and of cleavage 1. */
#define CLOUDS_SD 0.06
#define LAMELLAE_SD 0.05

/* Light of a palette's colour, near enough, and the same in whatever space the
 * host renders: from the numbers as they were given, which are encoded. */
static double light_of(const settings *s, int colour, int component) {
  double x = s->list[P_BASE + colour].number[component];
  return x * x;
}

/* Relative sd over the stone of what a layer's cells differ in, the greatest of
 * three components. below: the mean of what they lie in. */
static double layer_contrast(const settings *s, const stone_cells *c, int first, int second,
                             const double below[3]) {
  double most = 0.0;
  for (int k = 0; k < 3; k++) {
    double light[2] = {light_of(s, first, k), light_of(s, second, k)};
    double mean = below[k], square = mean * mean;
    for (int i = 0; i < 2; i++) {
      mean += (double)c->mean[i] * (light[i] - below[k]);
      square += (double)c->mean[i] * (light[i] * light[i] - below[k] * below[k]);
    }
    double clouds = CLOUDS_SD * (double)c->turbidity, lamellae = LAMELLAE_SD * (double)c->cleavage;
    square += ((double)(c->variation * c->variation) + clouds * clouds + lamellae * lamellae) *
              mean * mean;
    double variance = square - mean * mean;
    double sd = variance > 0.0 ? __builtin_sqrt(variance / (mean + 0.01)) : 0.0;
    if (sd > most) most = sd;
  }
  return most;
}

/* What differs little needs few looks, and is soon its mean. A look's edges are seen in
 * quarters, so that most of what it errs by is what lies beyond the cells that it has found:
 * that goes as the contrast, and as its width or little more. */
static void set_looks(stone_constants *w, const settings *s) {
  static const int first[STONE_LAYERS] = {COLOUR_SECOND, COLOUR_INCLUSION, COLOUR_BLACK,
                                          COLOUR_HOLE},
                   second[STONE_LAYERS] = {COLOUR_THIRD, COLOUR_INCLUSION_SECOND, COLOUR_WHITE,
                                           COLOUR_HOLE};
  double base[3], ground[3];
  const float *mean = w->layer[LAYER_GRAINS].mean;
  for (int k = 0; k < 3; k++) {
    base[k] = ground[k] = light_of(s, COLOUR_BASE, k);
    ground[k] += (double)mean[0] * (light_of(s, COLOUR_SECOND, k) - base[k]) +
                 (double)mean[1] * (light_of(s, COLOUR_THIRD, k) - base[k]);
  }
  for (int l = 0; l < STONE_LAYERS; l++) {
    stone_cells *c = &w->layer[l];
    double contrast = layer_contrast(s, c, first[l], second[l], l == LAYER_GRAINS ? base : ground);
    double share = __builtin_sqrt(contrast / CONTRAST);
    if (!c->on) continue;
    if (share < 0.01) share = 0.01;
    /* bodies of which two cells tell (bodies.h); of low contrast fours would be too wide */
    c->grouped = (!c->shaped || c->thick < 1.0f) && share > 0.75;
    if (share < 1.0) {
      c->fours = (float)(c->shaped ? share : share * share);
      /* three crystals to a look err less for each */
      if (!c->shaped) c->looks = (float)(share * (double)c->looks);
      c->whole = (float)((double)c->whole / (share * share));
      c->looks = (float)(__builtin_sqrt(share) * share * (double)c->looks);
      c->fade = (float)(share * (double)c->fade);
    }
    /* nor do clouds within crystals go by how much crystals differ */
    if (c->turbidity * c->whole > CLOUDS_WHOLE) c->whole = CLOUDS_WHOLE / c->turbidity;
    c->single = (1.999f - c->least) / c->looks; /* rounded to one: footprint.h */
    if (c->single > 0.6f * c->fade) c->single = 0.6f * c->fade;
    if (c->shaped && c->single > 0.5f) c->single = 0.5f;
  }
}

static void build_layers(stone_constants *w, const settings *s, stone_measure *measure) {
  const body bodies[STONE_LAYERS] = {grains_of(s), inclusions_of(s), specks_of(s), holes_of(s)};
  for (int l = 0; l < STONE_LAYERS; l++) {
    const body *b = &bodies[l];
    if (l != LAYER_GRAINS && b->share[0] + b->share[1] <= 0.0) continue;
    build_cells(&w->layer[l], w->seed + 0x9e3779b9u * (uint32_t)(l + 1), b, l != LAYER_GRAINS);
  }
  w->layer[LAYER_HOLES].least = 1.55f; /* of those the slope is seen, too */
  stone_means m;
  measure(w, MEASURED, &m);
  m.fill[LAYER_GRAINS] = 1.0;
  w->vein_mean = (float)m.veins;
  for (int l = 0; l < STONE_LAYERS; l++) {
    set_shares(&w->layer[l], &bodies[l], m.fill[l]);
    if (m.fill[l] > 1e-6 && m.seen[l] > m.fill[l]) {
      w->layer[l].swell = (float)(m.seen[l] / m.fill[l] - 1.0);
    }
  }
  double bedding = number_at(s, P_HOLE_BEDDING);
  if (w->layer[LAYER_HOLES].on && bedding > 0.0) set_bedding(&w->layer[LAYER_HOLES], w, bedding);
  set_looks(w, s);
  for (int l = 0; l < STONE_LAYERS; l++) {
    stone_cells *c = &w->layer[l];
    float chance = c->chance[1] * (c->bedded ? c->beds.few : 1.0f);
    c->sparse = c->on && c->shaped && bodies[l].roundness > 0.0 && chance < SPARSE;
  }
}

/* ---- what varies slowly ----------------------------------------------- */

static void build_bands(stone_constants *w, const settings *s) {
  w->bed_contrast = (float)number_at(s, P_BED_CONTRAST);
  w->bed_frequency = (float)(1.0 / number_at(s, P_BED_THICKNESS));
  w->bed_wave = (float)number_at(s, P_BED_WAVE);
  w->bed_wave_frequency = (float)(1.0 / number_at(s, P_BED_WAVELENGTH));
  w->has_beds = w->bed_contrast > 0.0f;
  w->mottle = (float)number_at(s, P_MOTTLE);
  w->mottle_frequency = (float)(1.0 / number_at(s, P_MOTTLE_SIZE));
  w->has_mottle = w->mottle > 0.0f;
  w->vein_width = (float)number_at(s, P_VEIN_WIDTH);
  w->vein_soft = (float)number_at(s, P_VEIN_SOFTNESS);
  w->vein_frequency = (float)(1.0 / number_at(s, P_VEIN_SPACING));
  w->vein_warp = (float)(1.3 * number_at(s, P_VEIN_WARP));
  for (uint32_t f = 0; f < 2; f++) {
    /* a direction with equal chances, by its height and azimuth */
    uint32_t h = hash1(w->seed + 211u + f);
    double y = (double)(h >> 16) / 32768.0 - 1.0,
           t = 6.283185307179586 * (double)(h & 65535u) / 65536.0;
    double r = __builtin_sqrt(1.0 - y * y);
    w->vein_direction[f][0] = (float)(r * scalar_cos(t));
    w->vein_direction[f][1] = (float)y;
    w->vein_direction[f][2] = (float)(r * scalar_sin(t));
  }
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
} finish;

static const finish finishes[FINISHES] = {
    [FINISH_SAWN] = {0.55, {0.05, 0.03}, {6.0, 0.8}, 0},
    [FINISH_POLISHED] = {0.04, {0.0008}, {-1.0}, 0},
    [FINISH_HONED] = {0.28, {0.006, 0.003}, {-1.0, 0.4}, 0},
    [FINISH_FLAMED] = {0.6, {0.9, 0.8, 0.35, 0.12}, {-5.0, -1.8, -0.7, -0.25}, 0},
    [FINISH_BUSH] = {0.65, {0.9, 0.5, 0.3, 0.1}, {5.5, 3.1, 1.2, 0.4}, 1},
    [FINISH_SPLIT] = {0.6, {16.0, 6.0, 2.5, 0.9, 0.3}, {130.0, 47.0, 17.0, 6.0, 2.0}, 0},
};

/* Variance of one component of gradient noise's gradient, and of that times
 * -5 times its value, over all points: property.stone_relief measures both. */
#define SLOPE2 0.248
#define SLOPE2_PITTED 0.212

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
  double alpha = f->alpha * number_at(s, P_ROUGHNESS);
  if (alpha > 1.0) alpha = 1.0;
  if (alpha < 0.02) alpha = 0.02;
  w->alpha2 = (float)(alpha * alpha);
  double n = number_at(s, P_IOR), r = (n - 1.0) / (n + 1.0);
  w->specular = (float)(r * r);
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

int32_t stone_build(stone_constants *w, const sozai_host *host, const settings *s,
                    const float (*colours)[3], const stone_kernel *kernel) {
  static const int swap[3] = {0, 1, 2};
  w->seed = seed_of(s);
  w->swap = swap[choice_at(s, P_BED)];
  for (int c = 0; c < 3; c++) w->offset[c] = (float)s->list[P_OFFSET].number[c];
  memcpy(w->colour, colours[P_BASE], sizeof w->colour); /* they stand together in both */
  build_bands(w, s);
  build_finish(w, s);
  build_layers(w, s, kernel->measure);
  w->hole_depth = (float)(number_at(s, P_HOLE_SIZE) * number_at(s, P_HOLE_DEPTH));
  int32_t r = stone_build_paving(w, s, colours, kernel->measure_laid);
  if (!r) r = build_paper(w, host, s);
  return r ? r : paper_build_tile(w, s, kernel->scan);
}
