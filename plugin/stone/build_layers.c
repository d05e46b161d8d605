/* SPDX-License-Identifier: Apache-2.0
 *
 * From settings to the layers of cells, and how closely each is looked at.
 */
#include "build.h"

#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "parameters.h"

#define MEASURED 8192u     /* points, for means that have no formula; whole blocks of every width */
#define CELLS_WHOLE 0.05f  /* cells: wider looks at that contrast are seen in quarters */
#define HOLES_FINE 1.4f    /* the finer bends of holes, over those of crystals as bent */
#define SPECKS_FINE 0.18f  /* cells: the finer bends of specks that are as ragged as can be */
#define SPARSE 0.15f       /* of cells in most places, a body: fewer are asked for first */
#define CLOUDS_WHOLE 0.04f /* the same over the turbidity of what is seen */

typedef struct {
  double size, stretch, grading, interlock, gap, roundness, variation, mixing, blur, share[2];
  double zoning;
  double third; /* share of a third kind */
  double depth, cleavage, turbidity, flatness, cluster, joined, rest, rim, fines, clear;
  int sorted;
} body;

/* Of the ball that bodies are cut to, in cells. */
static double radius_of(double roundness) { return 0.9 - 0.42 * roundness; }

static void build_cells(stone_cells *c, uint32_t seed, const body *b, int shaped) {
  /* a rotation in whole numbers: no axis, no diagonal */
  static const double aslant[3][3] = {{2.0, 6.0, 9.0}, {6.0, 7.0, -6.0}, {-9.0, 6.0, -2.0}};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      c->turn[i][k] = (float)(aslant[i][k] / 11.0 * (k == 1 ? b->stretch : 1.0) / b->size);
    }
  }
  c->grading = (float)(0.35 * b->grading);
  c->jitter = JITTER_OF(CELLS_JITTER);
  /* noise's gradient is within +-3 and mostly within +-1 */
  c->warp = (float)(0.2 * b->interlock);
  c->warp_fine = (float)(0.045 * b->interlock);
  c->variation = (float)b->variation;
  c->mixing = (float)b->mixing;
  c->calm = (float)(1.0 - b->rest);
  c->blur = (float)(b->blur / b->size);
  c->opacity = (float)(1.0 - b->clear);
  c->rim = (float)(b->rim / b->size);
  c->depth = (float)(0.6 * b->depth);
  c->cleavage = (float)b->cleavage;
  c->turbidity = (float)b->turbidity;
  c->zoning = (float)b->zoning;
  c->seed = hash1(seed);
  c->seed_warp = hash1(seed + 0x51ed270bu);
  memcpy(c->bend_turn, c->turn, sizeof c->turn);
  c->bend_scale = 1.0f;
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
  c->joins = (uint32_t)(256.0 * b->joined + 0.5);
  if (shaped) {
    c->erode = (float)(0.5 * b->gap / b->size);
    /* those of a clot touch */
    c->erode_spread = (float)(0.42 * b->grading * (1.0 - b->roundness) * (1.0 - 0.7 * b->joined));
    if (b->roundness > 0.0) {
      c->radius = (float)radius_of(b->roundness);
      c->radius_spread = (float)(b->grading * b->roundness);
      c->fines = (float)b->fines;
    }
    /* of a ball of a cell's volume, down to a seventh of its thickness */
    if (b->flatness > 0.0) c->thick = (float)(0.62 * (1.0 - 0.85 * b->flatness));
    c->looks = 4.5f;
    c->spread = 0.12f;
    c->least = 1.4f;
    c->grading = 0.0f;
    if (b->sorted) {
      /* radii squared are evenly spread, down to that of the least */
      c->sorted = 1;
      c->jitter = JITTER_OF(SORTED_JITTER);
      c->radius = (float)radius_of(b->roundness);
      c->grading = (float)b->grading * c->radius * c->radius;
      c->erode_spread = 0.0f;
    }
  }
}

/* What part of the cells a share of area takes, their bodies filling `fill`. Kinds that ask for
 * more than there is give way alike. */
static void set_shares(stone_cells *c, const body *b, double fill, double core) {
  double part[2], third = fill > 1e-6 ? b->third / fill : 0.0, asked = third, sum = 0.0;
  for (int k = 0; k < 2; k++) {
    part[k] = fill > 1e-6 ? b->share[k] / fill : 0.0;
    asked += part[k];
  }
  if (asked > 1.0) third /= asked;
  c->third = (float)third;
  c->third_mean = (float)(third * fill);
  sum = third;
  for (int k = 0; k < 2; k++) {
    double p = asked > 1.0 ? part[k] / asked : part[k];
    sum += p;
    if (sum > 1.0) sum = 1.0; /* by rounding */
    c->chance[k] = (float)sum;
    c->mean[k] = (float)(p * fill);
  }
  c->core = (float)(fill > 1e-6 ? core / fill : 1.0);
  if (c->rim > 0.0f) {
    float rim = c->mean[0] * (1.0f - c->core);
    c->mean[0] -= rim;
    c->mean[1] += rim;
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
  b->lag = w->bed_lag;
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
            .cluster = number_at(s, P_GRAIN_CLUSTERING),
            .joined = number_at(s, P_GRAIN_SERIATE)};
  b.size *= 1.0 - 0.5 * b.joined; /* the cells' */
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
            .mixing = number_at(s, P_INCLUSION_POLYMICT),
            .blur = number_at(s, P_INCLUSION_BLUR),
            .rim = number_at(s, P_INCLUSION_RIM),
            .clear = 1.0 - number_at(s, P_INCLUSION_OPACITY),
            .cleavage = number_at(s, P_INCLUSION_CLEAVAGE),
            .zoning = number_at(s, P_INCLUSION_ZONING),
            .turbidity = number_at(s, P_INCLUSION_TURBIDITY),
            .share = {number_at(s, P_INCLUSION_SHARE), number_at(s, P_INCLUSION_SECOND_SHARE)},
            .third = number_at(s, P_INCLUSION_THIRD_SHARE)};
  b.sorted = choice_at(s, P_INCLUSION_CONTACT) == CONTACT_TANGENTIAL;
  if (b.sorted) b.size /= 2.0 * radius_of(b.roundness); /* the largest ball's, not the spacing */
  return b;
}

/* Specks and holes are ragged, and of all sizes up to the largest. */
static body specks_of(const settings *s) {
  body b = {.size = number_at(s, P_SPECK_SIZE),
            .stretch = number_at(s, P_SPECK_STRETCH),
            .grading = 0.8,
            .interlock = 0.51 + 0.6 * number_at(s, P_SPECK_RAGGEDNESS),
            .roundness = 0.4,
            .blur = 0.3 * number_at(s, P_GRAIN_BLUR),
            .share = {number_at(s, P_BLACK_SHARE), number_at(s, P_WHITE_SHARE)},
            .variation = 0.8 * number_at(s, P_CLEAVAGE),
            .cleavage = 7.0 * number_at(s, P_CLEAVAGE),
            .flatness = number_at(s, P_SPECK_FLATNESS),
            .rest = 0.6, /* light specks differ less than dark ones, for the eye */
            .cluster = number_at(s, P_SPECK_CLUSTERING),
            .joined = number_at(s, P_SPECK_AGGREGATION)};
  return b;
}

static body holes_of(const settings *s) {
  body b = {.size = number_at(s, P_HOLE_SIZE),
            .grading = 0.85,
            .interlock = 2.0 * number_at(s, P_HOLE_RAGGEDNESS),
            .roundness = 0.8,
            .fines = number_at(s, P_HOLE_FINES),
            .variation = number_at(s, P_HOLE_VARIATION),
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

/* The contrasts, of crystals and of flakes, whose cells are counted for as long as any are, and
 * from COUNTED_FROM on; those of lesser contrast sooner and not as long, by what they err by. Of
 * other bodies' areas less is known. Which block is rich means know themselves (clusters.h), and
 * kinds that do not cluster lie so evenly that the mean comes sooner still. */
#define COUNTED_CRYSTALS 0.21
#define COUNTED_FLAKES 0.53
#define COUNTED_BODIES 0.15
#define COUNTED_FROM 7.0 /* cells: under narrower footprints looks tell more */
#define COUNTED_SOONEST 2.5
#define COUNTED_LEAST 2.0f    /* of the fade, */
#define COUNTED_CLUSTERS 0.8f /* and what is left of it */
#define COUNTED_EVEN 0.65f
#define COUNTED_LARGE 0.8f  /* of bodies that are no flakes, of full contrast */
#define COUNTED_JOINED 0.7f /* longer by so much where all cells are of joined crystals */
#define NEVER_COUNTED 1e9f

/* Relative sd of what is seen within a crystal, of turbidity 1 and of cleavage 1. */
#define CLOUDS_SD 0.06
#define LAMELLAE_SD 0.05
#define ZONES_SD 0.12 /* the same of zoning */

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
      light[i] = below[k] + (double)c->opacity * (light[i] - below[k]);
      mean += (double)c->mean[i] * (light[i] - below[k]);
      square += (double)c->mean[i] * (light[i] * light[i] - below[k] * below[k]);
    }
    double apart =
        (double)(c->mixing * c->opacity) * (light_of(s, first, k) - light_of(s, second, k));
    square += apart * apart * (double)(c->mean[0] + c->mean[1]);
    if (c->third > 0.0f) {
      double own = light_of(s, COLOUR_INCLUSION_THIRD, k) - below[k], light3 = 0.0;
      light3 = below[k] + (double)c->opacity * own;
      mean += (double)c->third_mean * (light3 - below[k]);
      square += (double)c->third_mean * (light3 * light3 - below[k] * below[k]);
      apart = (double)c->mixing * (light3 - 0.5 * (light[0] + light[1]));
      square += apart * apart * (double)c->third_mean;
    }
    double clouds = CLOUDS_SD * (double)c->turbidity, lamellae = LAMELLAE_SD * (double)c->cleavage;
    double zones = ZONES_SD * (double)c->zoning, within = clouds * clouds + lamellae * lamellae;
    square += ((double)(c->variation * c->variation) + within + zones * zones) *
              (double)(c->opacity * c->opacity) * mean * mean;
    double variance = square - mean * mean;
    double sd = variance > 0.0 ? __builtin_sqrt(variance / (mean + 0.01)) : 0.0;
    if (sd > most) most = sd;
  }
  return most;
}

#define FLAKES_ONCE 0.18f /* cells: what one look at flakes can tell, in quarters */

/* Flakes are looked at once for as long as the crystals are: where both are several times, how they
 * lie together is known, too. Crystals are the first layer. */
static void look_once(stone_cells *c, const stone_cells *grains) {
  float single = grains->single * grains->size / c->size;
  if (single > FLAKES_ONCE) single = FLAKES_ONCE;
  if (!grains->on || single < c->single) return;
  c->single = single;
  c->least = 1.999f - single * c->looks;
}

#define CONTRASTED 0.75 /* the root of CONTRAST's share */
#define SHEARED 0.018f  /* cells, over the bends' warp */
#define SHEARED_FLAKES 0.006f
#define RAGGED 0.25f

/* From which width on a look sees how the bends shear it: of what is thin sooner. Of what differs
 * little it does not matter, but for what is as ragged as travertine's holes. */
static float sheared_from(const stone_cells *c, double share) {
  if (share <= CONTRASTED && c->warp <= RAGGED) return 1e9f;
  return (c->shaped && c->thick < 1.0f ? SHEARED_FLAKES : SHEARED) / (c->warp + 1e-6f);
}

/* Where cells are counted. A mean over many cells errs as the contrast, and as the width, and so
 * does a count; bodies err otherwise. widest: the fade of full contrast. */
static void set_counts(stone_cells *c, double contrast, double widest) {
  const int flakes = c->shaped && c->thick < 1.0f;
  double most = c->shaped ? COUNTED_FLAKES : COUNTED_CRYSTALS;
  c->fade_counted = c->fade;
  if (contrast < most && (!c->shaped || flakes)) {
    float fade = (float)(widest * contrast / most);
    if (fade < COUNTED_LEAST) fade = COUNTED_LEAST;
    if (fade < c->fade) c->fade_counted = fade;
  }
  float left = c->cluster > 0.0f ? COUNTED_CLUSTERS : COUNTED_EVEN;
  if (c->shaped && !flakes) {
    most = COUNTED_BODIES;
    double full = (double)c->fade / widest, square = full * full;
    left += (COUNTED_LARGE - COUNTED_EVEN) * (float)(square * square);
  }
  c->fade_counted *= left;
  if (!c->shaped) c->fade_counted *= 1.0f + (float)c->joins * (COUNTED_JOINED / 256.0f);
  double from = COUNTED_FROM * contrast / most;
  if (from > COUNTED_FROM) from = COUNTED_FROM;
  if (from < COUNTED_SOONEST) from = COUNTED_SOONEST;
  c->counted_from = from < SECTIONS_KEEP * (double)c->fade ? (float)from : NEVER_COUNTED;
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
    const double widest = (double)c->fade;
    if (!c->on) continue;
    if (share < 0.01) share = 0.01;
    /* bodies of which two cells tell (bodies.h); of low contrast fours would be too wide */
    c->grouped = (!c->shaped || c->thick < 1.0f) && share > CONTRASTED;
    if (share < 1.0) {
      c->fours = (float)(c->shaped ? share : share * share);
      c->whole = (float)((double)c->whole / (share * share));
      double root = __builtin_sqrt(share), power = c->shaped ? __builtin_sqrt(root) : root;
      c->looks = (float)(power * share * share * (double)c->looks);
      c->fade = (float)(share * (double)c->fade);
    }
    set_counts(c, contrast, widest);
    /* nor do clouds within crystals go by how much crystals differ */
    if (c->turbidity * c->whole > CLOUDS_WHOLE) c->whole = CLOUDS_WHOLE / c->turbidity;
    c->single = (1.999f - c->least) / c->looks; /* rounded to one: footprint.h */
    if (c->grouped && c->shaped) look_once(c, &w->layer[LAYER_GRAINS]);
    if (c->single > 0.6f * c->fade) c->single = 0.6f * c->fade;
    if (c->shaped && c->single > 0.5f) c->single = 0.5f;
    c->sheared = sheared_from(c, share);
  }
}

#define BENDS_ALIKE 1.7f /* how much the sizes of layers may differ that share what bends them */

/* Flakes among crystals of about their size are bent as these are: the noises are half of what it
 * takes to place a look. */
static void share_bends(stone_cells *grains, const body *crystals, stone_cells *specks,
                        const body *b) {
  double scale = b->size / crystals->size;
  if (!specks->on || b->stretch != crystals->stretch || scale > BENDS_ALIKE ||
      scale < 1.0 / BENDS_ALIKE)
    return;
  memcpy(specks->bend_turn, grains->turn, sizeof grains->turn);
  specks->bend_scale = (float)scale;
  specks->seed_warp = grains->seed_warp;
  specks->bends_shared = grains->bends_shared = 1;
}

#define PITTED_DEEP 0.19f /* of a hammer's bumps, most of which is on top: property.stone_light */

/* How deep the mean place lies, as surface_below has it of heights that domes have and not a normal
 * distribution. share: of the face that is domes. */
static void set_depth(stone_constants *w, const stone_means *m, double share) {
  double square = (double)w->raise_sd * (double)w->raise_sd, low = 0.0, level = 1.0;
  for (int o = 0; o < w->relief_octaves; o++)
    square += 0.0365 * (double)w->relief[o] * (double)w->relief[o];
  double per = -1.702 / __builtin_sqrt(square + 1e-12), mean = (double)w->raise_mean;
  for (int b = 0; b < DOME_BINS; b++) {
    double part = share * m->dome_high[b], high = (double)w->raise * (b + 0.5) / DOME_BINS;
    low += part / (1.0 + scalar_exp(per * (high - mean)));
    level -= part;
  }
  low += level / (1.0 + scalar_exp(-per * mean));
  w->hollow_deep = (float)(1.0 - low);
}

/* Inclusions over the face; of the paper's colours there are none. */
static void set_raise(stone_constants *w, const settings *s, const stone_means *m) {
  const stone_cells *c = &w->layer[LAYER_INCLUSIONS];
  double share = (double)c->mean[0] + (double)c->mean[1] + (double)c->third_mean,
         high = (double)w->raise;
  double mean = share * m->dome, square = share * m->dome_square;
  double stretch = number_at(s, P_INCLUSION_STRETCH);
  double steep2 = m->dome_steep2 * (2.0 + stretch * stretch) / 3.0; /* in the mean of all ways */
  w->dome_mean = (float)m->dome;
  w->dome_steep = (float)__builtin_sqrt(steep2);
  w->raise_mean = (float)(high * mean);
  w->raise_sd = (float)(__builtin_fabs(high) * __builtin_sqrt(square - mean * mean));
  w->relief_steep += (float)(share * high * high * steep2);
  set_depth(w, m, share);
  w->glancing = 0.0f; /* domes lean at their rims, in each other's shade */
}

void stone_build_layers(stone_constants *w, const settings *s, stone_measure *measure) {
  const body bodies[STONE_LAYERS] = {grains_of(s), inclusions_of(s), specks_of(s), holes_of(s)};
  for (int l = 0; l < STONE_LAYERS; l++) {
    const body *b = &bodies[l];
    if (l != LAYER_GRAINS && b->share[0] + b->share[1] + b->third <= 0.0) continue;
    build_cells(&w->layer[l], w->seed + 0x9e3779b9u * (uint32_t)(l + 1), b, l != LAYER_GRAINS);
  }
  share_bends(&w->layer[LAYER_GRAINS], &bodies[LAYER_GRAINS], &w->layer[LAYER_SPECKS],
              &bodies[LAYER_SPECKS]);
  w->layer[LAYER_HOLES].warp_fine *= HOLES_FINE;
  w->layer[LAYER_SPECKS].warp_fine = SPECKS_FINE * (float)number_at(s, P_SPECK_RAGGEDNESS);
  w->layer[LAYER_HOLES].least = 1.55f; /* of those the slope is seen, too */
  const stone_cells *raised = &w->layer[LAYER_INCLUSIONS];
  if (raised->on && choice_at(s, P_MODE) == MODE_FABRIC)
    w->raise = (float)number_at(s, P_INCLUSION_RELIEF);
  stone_means m;
  measure(w, MEASURED, &m);
  m.fill[LAYER_GRAINS] = m.core[LAYER_GRAINS] = 1.0;
  for (int f = 0; f < VEIN_FAMILIES; f++) w->vein_mean[f] = (float)m.veins[f];
  for (int l = 0; l < STONE_LAYERS; l++) {
    set_shares(&w->layer[l], &bodies[l], m.fill[l], m.core[l]);
    if (m.fill[l] > 1e-6 && m.seen[l] > m.fill[l]) {
      w->layer[l].swell = (float)(m.seen[l] / m.fill[l] - 1.0);
    }
  }
  w->hollow_deep = w->pitted ? PITTED_DEEP : 0.5f;
  if (w->raise != 0.0f) set_raise(w, s, &m);
  double bedding = number_at(s, P_HOLE_BEDDING);
  if (w->layer[LAYER_HOLES].on && bedding > 0.0) set_bedding(&w->layer[LAYER_HOLES], w, bedding);
  set_looks(w, s);
  for (int l = 0; l < STONE_LAYERS; l++) {
    stone_cells *c = &w->layer[l];
    float chance = c->chance[1] * (c->bedded ? c->beds.few : 1.0f);
    c->sparse = c->on && c->shaped && bodies[l].roundness > 0.0 && chance < SPARSE;
  }
}
