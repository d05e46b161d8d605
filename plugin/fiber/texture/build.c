/* SPDX-License-Identifier: Apache-2.0
 *
 * From settings to the constants that the kernel reads.
 */
#include "build.h"

#include <string.h>

#include "../../core/hash1.h"
#include "../../core/scalar.h"
#include "light.h"
#include "parameters.h"

#define CERTAIN 4294967296.0
#define FULL (0.7999f * 4294967296.0f) /* presence that leaves room for a bundle to have more */
#define MEASURED 24576u /* points, for means that have no formula; whole blocks of every width */
#define FILL 0.55       /* of space by bundles, less the ends of their strands; about */
#define ON_YARN 4       /* layers */
#define FEW 0.4         /* of what room there is, that strands too seldom take to be counted */
#define LANES_SEEN 1.25 /* that two lanes stand for, of a wide footprint */
#define LANES_SOFT 0.9  /* at which nearness is measured once more */
/* Half of a footprint of which those that are counted tell nothing; where few are taken, up to
 * twice as many. */
#define LANES_TOLD 4.5
#define HULL_LOOKS 4
#define FIELD 2147483648.0  /* a hash's field is within this of 0 */
#define WAVE 8.0            /* over the wave's amplitude */
#define WAVE_SLOPE2 21.3333 /* mean square of the wave's slope: of +-8, evenly */

static double tangent(double a) { return scalar_sin(a) / scalar_cos(a); }

/* ---- the shell --------------------------------------------------------- */

static void place_layer(fibertex_constants *w, int l, double size, double radius, double close,
                        double wanted, double level) {
  fibertex_layer *c = &w->layer[l];
  /* sparse layers have their lanes apart, so that half of them are taken anyway */
  double spacing =
      scalar_most(close * radius, scalar_least(1.1 * FILL * radius / wanted, size / 10.0));
  c->size = (float)size;
  c->inverse_size = (float)(1.0 / size);
  c->reach2 = (float)(0.45 * 0.45 * size * size);
  c->spacing = (float)spacing;
  c->inverse_spacing = (float)(1.0 / spacing);
  c->radius = (float)radius;
  c->inverse_radius = (float)(1.0 / radius);
  c->lattice = l % 3;
  c->presence = (float)(CERTAIN * scalar_least(wanted * spacing / (2.0 * radius * FILL), 0.95));
  c->radius_vary = (float)(radius * (double)w->radius_spread / FIELD);
  c->depth = (float)level;
  c->depth_cells = (float)(level / size);
  c->chord_least = (float)(1e-3 * size);
  c->ends = 1;
  c->seed = hash1(w->seed + 0x9e3779b9u * (uint32_t)(l + 1));
  for (uint32_t k = 0; k < 3; k++) {
    c->offset[k] = (float)(hash1(c->seed + k) >> 8) * (1.0f / 16777216.0f);
  }
}

/* On a yarn: strands side by side that do not end where they can be seen. */
static void place_round(fibertex_constants *w, int l, double radius, double wanted, double level,
                        double twist) {
  fibertex_layer *c = &w->layer[l];
  place_layer(w, l, 40.0 * radius, radius, 4.0, wanted, level);
  double spacing = 4.0 * radius;
  c->spacing = (float)spacing;
  c->inverse_spacing = (float)(1.0 / spacing);
  c->presence = (float)(CERTAIN * scalar_least(wanted * spacing / (2.0 * radius), 0.95));
  c->ends = 0;
  c->twist[0] = (float)scalar_cos(twist);
  c->twist[1] = (float)scalar_sin(twist);
}

/* A strand reaches no further than a lane's width from its lane's middle: the two
 * lanes looked at hold all that may cover a point. */
static void let_stray(fibertex_constants *w, fibertex_layer *c, double waver) {
  double spacing = (double)c->spacing;
  double thick = (double)c->radius * (1.0 + (double)w->radius_spread) / spacing;
  double stray = scalar_least(waver * 0.85, scalar_most(1.0 - 1.2 * thick, 0.0)) * spacing;
  c->widen_most = (float)scalar_most(scalar_least((1.0 - stray / spacing) / thick, 3.0), 1.0);
  c->shift = (float)(0.3 * stray / FIELD);
  c->sway = (float)(WAVE * (c->ends ? 0.4 : 0.6) * stray);
  c->tilt = (float)(c->ends ? 0.3 * stray * 2.0 / (double)c->size / FIELD : 0.0);
  /* Of more than two lanes' width strands are counted. Of a cloth sooner, since one strand's light
   * would stand for too many. */
  int woven = w->structure == STRUCTURE_WOVEN;
  double from = woven ? 0.9 : 1.7, to = woven ? 1.8 : 2.3, seen = LANES_SEEN * spacing;
  c->seen = (float)(0.5 * seen);
  c->seen_inverse = (float)(1.0 / seen);
  c->vague = (float)(from * spacing);
  c->vague_inverse = (float)(1.0 / ((to - from) * spacing));
  double swing = (double)c->sway / WAVE * (double)w->own_frequency, tilt = FIELD * (double)c->tilt;
  c->slope2 = (float)(swing * swing * WAVE_SLOPE2 * 1.053 + tilt * tilt / 3.0);
}

/* Until it is measured, the formula's own: so that the measure is of that. */
static void set_formulas(fibertex_constants *w) {
  for (int l = 0; l < w->layers; l++) {
    fibertex_layer *c = &w->layer[l];
    c->formula = 2.0f * c->radius * c->inverse_spacing * c->presence / (float)CERTAIN;
  }
}

/* Optical depth of a layer at most, and its lanes' distance in radii at least: strands on top
 * need room to stray, or they look combed; below they close what is left. */
static double densest(int k, int count) { return 0.13 + 0.42 * k / (count - 1); }
static double closest(int k, int count) { return 8.0 - 4.6 * k / (count - 1); }

/* From what is wanted to what is: the lanes' presence by a measure of full ones, and by
 * a second what of the layers there is. */
static void measure_layers(fibertex_constants *w, const settings *s, const fibertex_kernel *kernel,
                           const double wanted[FIBERTEX_LAYERS]) {
  fibertex_means full, m;
  for (int l = 0; l < w->layers; l++) {
    w->layer[l].presence = FULL;
    w->layer[l].lift = w->layer[l].pale = 1.0f;
    w->layer[l].counted = w->layer[l].counted_lift = 1.0f;
    w->layer[l].counted_end = (float)(2.0 / LANES_TOLD);
  }
  set_formulas(w);
  kernel->measure(w, MEASURED, 0.0f, 1, &full);
  for (int l = 0; l < w->layers; l++) {
    fibertex_layer *c = &w->layer[l];
    if (full.bright[l] > 0.1) c->lift = (float)(1.0 / full.bright[l]);
    if (full.pale[l] > 0.1) c->pale = (float)(1.0 / full.pale[l]);
    if (full.counted[l].cover > 1e-3) {
      c->counted = (float)(full.point[l] / full.counted[l].cover);
      c->counted_lift = (float)(1.0 / full.counted[l].bright);
    }
    if (full.point[l] > 1e-9)
      c->presence = (float)scalar_least(FULL * wanted[l] / full.point[l], FULL);
  }
  set_formulas(w);
  for (int l = 0; l < w->layers; l++) {
    double taken = scalar_most((double)w->layer[l].presence / FULL, 1e-6);
    w->layer[l].counted_end =
        (float)(2.0 / scalar_least(LANES_TOLD / scalar_root(taken), 2.0 * LANES_TOLD));
    if (full.formula[l] > 0.0) w->layer[l].formula *= (float)(full.point[l] / full.formula[l]);
  }
  kernel->measure(w, MEASURED, 0.0f, 1, &m);
  for (int l = 0; l < w->layers; l++) {
    /* few strands are met too seldom to be counted, but do not lie over one another */
    double share = (double)w->layer[l].presence / FULL;
    if (share > FEW) continue;
    m.point[l] = share * full.point[l];
    m.formula[l] = share * full.point[l];
    m.soft[l] = m.soft[l] > 0.0 ? m.soft[l] : 0.0;
  }
  /* between two strands both are near, and what comes of that ends at 1: of a footprint for its
   * mean alone, so that it finds more. Few strands are seldom two. */
  const double x = LANES_SOFT / LANES_SEEN, parabola = x * (2.0 - x);
  for (int l = 0; l < w->layers; l++) w->layer[l].soft = (float)m.soft[l];
  kernel->measure(w, MEASURED, (float)LANES_SOFT, 0, &full);
  for (int l = 0; l < w->layers; l++) {
    int few = (double)w->layer[l].presence / FULL <= FEW;
    w->layer[l].soft_wide = few ? 0.0f : (float)((full.soft[l] - m.soft[l]) / parabola);
  }
  double above = 0.0, darkening = number_at(s, P_DARKENING);
  double around = 1.3 * (w->pile ? fibertex_pile_met(w) : 1.0);
  for (int l = 0; l < w->layers; l++) {
    fibertex_layer *c = &w->layer[l];
    c->mean = (float)m.point[l];
    if (m.formula[l] > 1e-9) c->formula *= (float)(m.point[l] / m.formula[l]);
    const fibertex_counted *n = &m.counted[l];
    c->counted_near = (float)n->near[1];
    c->beyond_near = (float)n->beyond_near;
    if (n->luck > 0.0) c->counted_luck = (float)((n->near[1] - n->near[0]) / n->luck);
    for (int k = 0; k < 2; k++) c->beyond[k] = (float)(m.point[l] * n->beyond[k]);
    c->beyond_widen = (float)(0.97 / scalar_most((double)c->beyond[0], 0.1));
    c->ambient = (float)(1.0 - darkening * (1.0 - scalar_exp(-around * above)));
    above -= scalar_log(1.0 - scalar_least(m.point[l], 0.99));
  }
  double left = 1.0;
  for (int l = 0; l < w->layers; l++) {
    w->part[l] = (float)(left * (double)w->layer[l].mean);
    left -= (double)w->part[l];
  }
  w->part_deep = (float)left;
  w->flown = 0.0f;
  for (int l = 0; l < w->yarns_from; l++) w->flown += w->part[l];
  /* evenly more from each to the next, which two factors tell the kernel */
  int n = w->layers;
  double ratio = w->structure == STRUCTURE_WOVEN ? 1.0 : densest(1, 2) / densest(0, 2);
  double first = above / (n * 0.5 * (1.0 + ratio));
  w->step = (float)first;
  w->step_more = (float)(first * (ratio - 1.0) / (n - 1));
  w->deep_above = (float)above;
  /* what is too deep to be told apart is darker than the last that is */
  w->deep_ambient =
      (float)((1.0 - darkening * (1.0 - scalar_exp(-around * above))) * (1.0 - 0.4 * darkening));
  w->deep_depth = w->layer[w->layers - 1].depth;
}

/* Strands that stand off lie ten radii apart, lest they look combed: a layer of them covers no more
 * than some 0.08 of the surface, and what is to cover more has more layers. Returns their number.
 */
#define FLOWN_MOST 0.0801
static int place_flown(fibertex_constants *w, double cover, double over, double size, double radius,
                       double wanted[FIBERTEX_LAYERS]) {
  if (!(cover > 0.0)) return 0;
  double depth = -scalar_log(1.0 - cover), most = -scalar_log(1.0 - FLOWN_MOST);
  int count = 1 + (int)scalar_least(depth / most, FIBERTEX_FLOWN - 1);
  for (int l = 0; l < count; l++) {
    double apart = 1.0 - 0.3 * (double)((l * 2) % 5) / 5.0;
    wanted[l] = count == 1 ? cover : 1.0 - scalar_exp(-depth / count);
    place_layer(w, l, 2.6 * size * apart, radius, 10.0, wanted[l], over * l / count);
  }
  return count;
}

/* Returns its optical depth. */
static double build_shell(fibertex_constants *w, const settings *s, const fibertex_kernel *kernel) {
  double d = 0.001 * number_at(s, P_DIAMETER), thickness = number_at(s, P_THICKNESS);
  /* what rises out of the surface covers less of it */
  double flat = 1.0 / __builtin_sqrt(1.0 + (double)w->lean * (double)w->lean + (double)w->rise2);
  double total = number_at(s, P_PACKING) * thickness / (d * PI / 4.0) * flat;
  double flown = number_at(s, P_FLYAWAY), over = flown > 0.0 ? number_at(s, P_FLYAWAY_HEIGHT) : 0.0;
  double elevation = number_at(s, P_ELEVATION) * RADIANS, waver = number_at(s, P_WAVER);
  double size =
      scalar_most(number_at(s, P_BUNDLE) * scalar_most(scalar_cos(elevation), 0.2), 6.0 * d) / 0.9;
  double wanted[FIBERTEX_LAYERS] = {0};
  int woven = w->structure == STRUCTURE_WOVEN;
  int bulk = place_flown(w, flown, over, size, 0.5 * d, wanted);
  int count = woven ? ON_YARN : FIBERTEX_HULL - (bulk > 0);
  w->layers = bulk + count;
  w->yarns_from = woven ? bulk : 0;
  /* a pile's are so dense where it is looked at from the side, and have room for it */
  double thin = w->pile ? 1.0 / fibertex_pile_met(w) : 1.0;
  double apart_most = w->pile ? 2.0 : 0.0, most_of = 0.0;
  for (int k = 0; k < count; k++) most_of += thin * densest(k, count);
  double scale = scalar_least(1.0, total / most_of), seen = 0.0, shown = thickness / total;
  for (int k = 0; k < count; k++) {
    int l = bulk + k;
    double each = woven ? 0.4 : scale * thin * densest(k, count);
    wanted[l] = 1.0 - scalar_exp(-each);
    if (woven) {
      double twist = number_at(s, P_TWIST) * RADIANS + 0.12 * ((k * 3) % 5 - 2.0) / 2.0;
      place_round(w, l, 0.5 * d, wanted[l], over + d * k, twist);
    } else { /* sizes apart, lest lattices of one layer and the next keep step */
      double apart = 0.8 + 0.4 * (double)((k * 5) % 7) / 6.0;
      place_layer(w, l, size * apart, 0.5 * d, closest(k, count) + apart_most, wanted[l],
                  over + shown * (seen + 0.5 * each));
      /* the lower, the more end where the next bundle begins: nobody sees them so sharply, and
       * gaps between bundles of all layers would be cobbles from afar */
      w->layer[l].reach2 *= (float)(1.0 + 1.1 * scalar_least(1.0, 1.5 * k / (count - 2)));
    }
    seen += each;
  }
  for (int l = 0; l < w->layers; l++) let_stray(w, &w->layer[l], waver);
  measure_layers(w, s, kernel, wanted);
  double rest = woven ? 40.0 : scalar_most(total - (double)w->deep_above, 0.0);
  w->deep = (float)(1.0 - scalar_exp(-rest));
  w->deep_above += (float)(0.5 * scalar_least(rest, 1.0));
  /* one bundle stands for as much as it is wide */
  const fibertex_layer *last = &w->layer[w->layers - 1];
  w->far[0] = last->spacing + 0.1f * last->size;
  w->far[1] = 4.0f * last->spacing + 0.6f * last->size;
  return woven ? rest : total;
}

static void build_bundles(fibertex_constants *w, const settings *s) {
  double bundle = number_at(s, P_BUNDLE), per_mm = 0.1 * number_at(s, P_CRIMP);
  double height =
      per_mm > 0.0 ? scalar_least(number_at(s, P_CRIMP_HEIGHT), 1.0 / (8.0 * per_mm)) : 0.0;
  w->crimp = (float)(WAVE * height);
  w->crimp_frequency = (float)per_mm;
  w->crimp_vary = (float)(0.25 * per_mm / FIELD);
  w->own_frequency = (float)(2.2 / bundle);
  w->own_vary = (float)(0.4 * 2.2 / bundle / FIELD);
  w->contact = (float)(0.75 * number_at(s, P_DARKENING));
  w->curl = (float)(0.7 / bundle / FIELD);
  w->radius_spread = (float)number_at(s, P_DIAMETER_SPREAD);
  double steep = height * per_mm, arc = 0.7 * 0.25;
  w->slope2 = (float)(steep * steep * WAVE_SLOPE2 * 1.02 + arc * arc / 9.0);
  double mean = number_at(s, P_ELEVATION) * RADIANS;
  double up = scalar_least(mean + number_at(s, P_ELEVATION_SPREAD) * RADIANS, 82.0 * RADIANS);
  w->lean = (float)tangent(mean);
  w->rise = (float)(tangent(up) - tangent(mean));
  w->rise2 = (float)((double)w->rise * (double)w->rise / 3.0);
  w->pile = w->structure == STRUCTURE_AGGREGATE && w->lean > 0.0f;
  w->steep2 = w->lean * w->lean + w->rise2;
  /* a direction that strays by an angle turns about the normal by more of it, the steeper it is;
   * and of its elevation's tangent that is so much more or less */
  double drift = number_at(s, P_NAP_DRIFT) * RADIANS, flat = scalar_cos(mean);
  w->nap = (float)scalar_least(drift / flat, 60.0 * RADIANS);
  w->nap_steeper =
      w->pile ? (float)scalar_least(drift / (flat * scalar_sin(mean) * 0.693147), 1.0) : 0.0f;
  w->nap_frequency = (float)(1.0 / number_at(s, P_NAP_REACH));
  w->nap_seed = hash1(w->seed ^ 0x6e6170u);
}

/* Variance of an angle whose tangent is spread evenly with that variance. */
static double angle2(double slope2) {
  double sum = 0.0, widest = __builtin_sqrt(3.0 * slope2);
  for (int i = 0; i < 16; i++) {
    double x = widest * (i + 0.5) / 16.0, a = x / (1.0 + 0.28 * x * x);
    sum += a * a / 16.0;
  }
  return sum;
}

/* ---- cloth ------------------------------------------------------------- */

typedef struct {
  int repeat, over, shift, pair;
} weave;

static const weave weaves[WEAVES] = {
    [WEAVE_PLAIN] = {2, 1, 1, 0},     [WEAVE_BASKET] = {2, 1, 1, 1},
    [WEAVE_TWILL_2_1] = {3, 2, 1, 0}, [WEAVE_TWILL_3_1] = {4, 3, 1, 0},
    [WEAVE_TWILL_2_2] = {4, 2, 1, 0}, [WEAVE_SATIN] = {5, 4, 2, 0},
};

static void build_yarns(fibertex_constants *w, const settings *s) {
  const weave *v = &weaves[choice_at(s, P_WEAVE)];
  w->repeat = (float)v->repeat;
  w->inverse_repeat = (float)(1.0 / v->repeat);
  w->over = v->over;
  w->shift = v->shift;
  w->pair = v->pair;
  double spacing[2] = {number_at(s, P_YARN_SPACING), number_at(s, P_WEFT_SPACING)};
  if (spacing[1] <= 0.0) spacing[1] = spacing[0];
  double thin =
      scalar_least(spacing[0], spacing[1]) * scalar_least(number_at(s, P_YARN_WIDTH), 1.0);
  double rise = 0.3 * thin * number_at(s, P_YARN_FLATNESS), slub = number_at(s, P_SLUB);
  /* the yarn that floats crowds over the one that it hides */
  double over = rise * 0.9 * (2.0 * v->over / v->repeat - 1.0);
  for (int i = 0; i < 2; i++) {
    fibertex_yarn *y = &w->yarn[i];
    double half = 0.5 * spacing[i] * number_at(s, P_YARN_WIDTH);
    y->spacing = (float)spacing[i];
    y->inverse_spacing = (float)(1.0 / spacing[i]);
    y->half = (float)half;
    y->inverse_half = (float)(1.0 / half);
    y->height = (float)(0.5 * thin * number_at(s, P_YARN_FLATNESS));
    y->edge = number_at(s, P_YARN_WIDTH) < 1.0 ? y->height * y->inverse_half : 0.0f;
    y->rise = (float)rise;
    y->over = (float)(i ? -over : over);
    y->swell = (float)(0.5 * number_at(s, P_YARN_SWELL));
    y->wander = (float)(WAVE * 0.16 * slub);
    y->sway = (float)(WAVE * 0.1 * slub * spacing[i]);
    y->course = (float)(0.17 / spacing[i]);
    y->tone = (float)(0.22 * slub / FIELD);
    y->frequency = (float)(0.11 / spacing[i]);
  }
  double high = rise + over + (double)w->yarn[0].height, low = 0.1 * high;
  w->low = (float)low;
  w->inverse_range = (float)(1.0 / (high - low));
  w->hollow = (float)number_at(s, P_HOLLOW);
}

/* What is spread about 0 as two places, one on either side, and a variance about each: so that the
 * second moment and the fourth are what they are. Plain weave's slopes are mostly the steepest;
 * those of floats mostly none. */
typedef struct {
  double at, variance;
} two_places;

static two_places places_of(double second, double fourth) {
  double of = 0.5 * (3.0 * second * second - fourth);
  double at2 = of > 0.0 ? scalar_least(__builtin_sqrt(of), second) : 0.0;
  return (two_places){__builtin_sqrt(at2), second - at2};
}

/* Two faces stand for a yarn's, as its ellipse has them, and two directions for what stands off. */
static void look_at_yarns(fibertex_constants *w, const fibertex_kernel *kernel, double twist) {
  fibertex_cloth_means m;
  kernel->measure_cloth(w, 2 * MEASURED, &m);
  double all = scalar_most(m.yarn[0] + m.yarn[1], 1e-9), co = scalar_cos(twist),
         si = scalar_sin(twist);
  w->solid = (float)all;
  double gap = 1.0;
  for (int i = 0; i < 2; i++) {
    gap *=
        scalar_most(1.0 - 2.0 * (double)w->yarn[i].half * (double)w->yarn[i].inverse_spacing, 0.0);
  }
  w->gaps = (float)(gap > 0.0 ? (1.0 - scalar_least(all, 1.0)) / gap : 0.0);
  w->warp_share = (float)(m.yarn[0] / all);
  for (int i = 0; i < 2; i++) {
    w->parts.inverse_mean[i] = m.shaded[i] > 0.0 ? (float)(all / m.shaded[i]) : 0.0f;
  }
  w->lean_rms = (float)scalar_root((m.lean2[0] + m.lean2[1]) / all);
  w->slope_rms = (float)scalar_root((m.slope2[0] + m.slope2[1]) / all);
  w->looks = FIBERTEX_LOOKS;
  w->below[0] = (float)co;
  w->below[1] = (float)si;
  for (int k = 0; k < w->looks; k++) {
    fibertex_look *o = &w->look[k];
    *o = (fibertex_look){.weft = k < FIBERTEX_FACES ? k / 2 : k - FIBERTEX_FACES};
    double side[2] = {o->weft ? -1.0 : 0.0, o->weft ? 0.0 : 1.0};
    double way[2] = {o->weft ? 0.0 : 1.0, o->weft ? 1.0 : 0.0};
    if (k >= FIBERTEX_FACES) {
      for (int c = 0; c < 2; c++) {
        o->along[c] = (float)way[c];
        o->across[c] = (float)side[c];
      }
      o->up[2] = 1.0f;
      o->share = 0.5f;
      o->across2 = (float)(PI * PI / 48.0); /* a quarter turn, evenly */
      o->up2 = w->scatter_up;
      continue;
    }
    double share = m.yarn[o->weft] / all, seen = scalar_most(m.yarn[o->weft], 1e-9);
    two_places lean = places_of(m.lean2[o->weft] / seen, m.lean4[o->weft] / seen);
    double f = k % 2 ? lean.at : -lean.at, top = __builtin_sqrt(1.0 - f * f);
    /* and as it goes up and down: one of the two as it rises, one as it falls */
    two_places slope = places_of(m.slope2[o->weft] / seen, m.slope4[o->weft] / seen);
    double rise = slope.at, level = __builtin_sqrt(1.0 - rise * rise);
    if (k == 0 || k == 3) rise = -rise;
    for (int c = 0; c < 3; c++) {
      double sideways = c < 2 ? side[c] : 0.0, along = c < 2 ? way[c] * level : rise;
      double lift = c < 2 ? -rise * way[c] : level, round = sideways * top - lift * f;
      o->up[c] = (float)(sideways * f + lift * top);
      o->along[c] = (float)(along * co + round * si);
      o->across[c] = (float)(round * co - along * si);
    }
    for (int c = 0; c < 2; c++) o->tip[c] = o->up[c] / o->up[2];
    o->share = (float)(share * 0.5);
    o->lit = (float)(m.shaded[o->weft] / all * 0.5);
    o->level = (float)(m.level[o->weft] / all * 0.5);
    o->across2 = w->scatter + 0.009f; /* layers on a yarn are turned a little */
    o->up2 = (float)((double)w->scatter_up + co * co * slope.variance + si * si * lean.variance);
  }
}

/* ---- directions -------------------------------------------------------- */

/* The angle from the axis below which a share t of all lie, -1 to 1. */
static double quantile(double alignment, double t) {
  double a = t < 0.0 ? -t : t;
  return 0.5 * PI * t * (1.0 - alignment + alignment * 0.18 * a * a);
}

static void build_directions(fibertex_constants *w, double alignment) {
  for (int i = 0; i < FIBERTEX_DIRECTIONS; i++) {
    double a = quantile(alignment, (2.0 * i + 1.0) / FIBERTEX_DIRECTIONS - 1.0);
    w->turn[0][i] = (float)scalar_cos(a);
    w->turn[1][i] = (float)scalar_sin(a);
  }
}

/* Of an aggregate, as it is seen from afar; its layers are known. */
static void look_at_hull(fibertex_constants *w, double alignment) {
  w->looks = HULL_LOOKS;
  const fibertex_layer *bulk = &w->layer[w->layers - (FIBERTEX_HULL - 1)];
  for (int m = 0; m < HULL_LOOKS; m++) {
    fibertex_look *o = &w->look[m];
    double from = quantile(alignment, 2.0 * m / HULL_LOOKS - 1.0);
    double to = quantile(alignment, 2.0 * (m + 1) / HULL_LOOKS - 1.0);
    double a = quantile(alignment, (2.0 * m + 1.0) / HULL_LOOKS - 1.0);
    double steep = __builtin_sqrt(1.0 / (1.0 + (double)w->lean * (double)w->lean));
    double out = (double)w->lean * steep, co = scalar_cos(a), si = scalar_sin(a);
    o->along[0] = (float)(co * steep);
    o->along[1] = (float)(si * steep);
    o->along[2] = (float)out;
    o->across[0] = (float)-si;
    o->across[1] = (float)co;
    o->up[0] = (float)(-co * out);
    o->up[1] = (float)(-si * out);
    o->up[2] = (float)steep;
    o->share = o->lit = (float)(1.0 / HULL_LOOKS);
    o->across2 = (float)((to - from) * (to - from) / 12.0 +
                         angle2((double)w->slope2 + (double)bulk->slope2));
    o->up2 = w->scatter_up;
  }
}

/* From afar a texture is as bright as its points: looks that stand for all are given what of it
 * goes by more than the moments they have. Amounts are known. */
static void level_looks(fibertex_constants *w, const fibertex_kernel *kernel) {
  fibertex_both f;
  int woven = w->structure == STRUCTURE_WOVEN;
  kernel->measure_both(w, woven ? MEASURED : MEASURED / 2, &f);
  for (int m = 0; woven && m < FIBERTEX_FACES; m++) {
    fibertex_look *o = &w->look[m];
    if (f.far[o->weft] > 0.0) o->level *= (float)(f.near[o->weft] / f.far[o->weft]);
  }
  for (int i = 0; !woven && i < 3; i++) {
    w->from_afar[i] = f.far[i] > 0.0 ? (float)scalar_least(f.near[i] / f.far[i], 1.5) : 1.0f;
  }
}

/* Footprints, mm, between which one way of seeing a cloth's yarns gives way to the next: a yarn's
 * own light to that of all (`far`, of the warp's spacing); and of the narrower spacing the yarn at
 * the middle to 2 x 2 parts (`near`), those to 3 x 3 (`finer`), those to the mean of all (`far`).
 * Fitted to the contrast that the catalogue's cloths have. */
static void set_footprints(fibertex_constants *w) {
  fibertex_parts *p = &w->parts;
  float warp = w->yarn[0].spacing, weft = w->yarn[1].spacing, narrow = warp < weft ? warp : weft;
  w->far[0] = 0.3f * warp;
  w->far[1] = 1.2f * warp;
  p->near[0] = 0.32f * narrow;
  p->near[1] = 0.5f * narrow;
  p->finer[0] = 0.8f * narrow;
  p->finer[1] = 1.2f * narrow;
  p->far[0] = 2.0f * narrow;
  p->far[1] = 4.0f * narrow;
  if (p->far[1] < w->far[1]) p->far[1] = w->far[1];
}

int32_t fibertex_build(fibertex_constants *w, const sozai_host *host, const settings *s,
                       const float (*colours)[3], const fibertex_kernel *kernel) {
  w->seed = hash1_named((uint32_t)number_at(s, P_SEED) + 0x1b873593u, s->list[P_OBJECT].text);
  for (int c = 0; c < 3; c++) w->offset[c] = (float)s->list[P_OFFSET].number[c];
  w->axis[choice_at(s, P_AXIS)] = 1.0f;
  memcpy(w->colour, colours[P_COLOUR], sizeof w->colour); /* they stand together in both */
  w->axis_index = choice_at(s, P_AXIS);
  w->second_chance = (int32_t)(256.0 * number_at(s, P_SECOND_SHARE) + 0.5);
  w->second_share = (float)w->second_chance / 256.0f;
  w->variation = (float)number_at(s, P_VARIATION);
  w->cloud = (float)number_at(s, P_MOTTLE);
  w->cloud_frequency = (float)(1.0 / number_at(s, P_MOTTLE_SIZE));
  w->cloud_seed = hash1(w->seed ^ 0x6d6f74u);
  w->structure = choice_at(s, P_STRUCTURE);
  w->solid = 1.0f;
  build_bundles(w, s);
  build_directions(w, number_at(s, P_ALIGNMENT));
  if (w->structure == STRUCTURE_WOVEN) build_yarns(w, s);
  double depth = build_shell(w, s, kernel);
  w->scatter = (float)angle2((double)w->layer[w->layers - 1].slope2);
  /* of a rise that leans, the angle is less */
  double lean2 = 1.0 + (double)w->lean * (double)w->lean;
  w->scatter_up = (float)angle2((double)w->rise2 / (lean2 * lean2));
  if (w->structure == STRUCTURE_WOVEN) {
    set_footprints(w);
    look_at_yarns(w, kernel, number_at(s, P_TWIST) * RADIANS);
  } else {
    look_at_hull(w, number_at(s, P_ALIGNMENT));
  }
  int32_t r = fibertex_build_light(w, host, s, depth);
  if (r == SOZAI_OK) level_looks(w, kernel);
  return r;
}
