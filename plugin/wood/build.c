/* SPDX-License-Identifier: Apache-2.0
 *
 * From parameters to the kernel's constants and tables.
 */
#include "build.h"

#include <string.h>

#include "../core/colour.h"
#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "age.h"
#include "cone_table.h"
#include "parameters.h"
#include "plies/build.h"
#include "plies/parameters.h"
#include "section.h"
#include "surface/build.h"

/* how bleached the first's and the second's shares are, measured */
#define SPALT_BLEACH 0.724
#define SPALT_BLEACH_SECOND 0.483

#define TWO_PI 6.28318530717958647692

/* Uniform in 0..1 for the k-th number of a stream. */
static double uniform(uint32_t seed, uint32_t stream, uint32_t k) {
  return (hash1(seed ^ hash1(stream * 0x9e3779b9u + k)) + 0.5) / 4294967296.0;
}

enum { STREAM_RINGS = 101, STREAM_LATE, STREAM_OUTLINE, STREAM_ROW_X, STREAM_ROW_Z, STREAM_HEART };

/* Middles of equally likely parts of the normal distribution, scaled so that
 * their standard deviation is 1: for ring widths, and for vessel radii. */
#define QUANTILES 512
static double quantiles[QUANTILES], radius_quantiles[WOOD_RADII];

static void scaled_quantiles(double *out, int count) {
  scalar_normal_quantiles(out, count);
  double square = 0.0;
  for (int i = 0; i < count; i++) square += out[i] * out[i];
  for (int i = 0; i < count; i++) out[i] /= __builtin_sqrt(square / count);
}

void wood_build_prepare(void) {
  scaled_quantiles(quantiles, QUANTILES);
  scaled_quantiles(radius_quantiles, WOOD_RADII);
}

static double normal(uint32_t seed, uint32_t stream, uint32_t k) {
  return quantiles[(uint32_t)(uniform(seed, stream, k) * QUANTILES)];
}

/* ---- cut -------------------------------------------------------------- */

static int32_t build_veneer(wood_constants *w, const settings *s) {
  double radius = number_at(s, P_CUT_DISTANCE);
  if (radius < 1.0) {
    return fail(SOZAI_ERROR_RANGE,
                "cut_distance: %.9g mm is where the knife begins with cut = rotary; 1 to 5000 mm",
                radius);
  }
  if (choice_at(s, P_LAYOUT) != 0) {
    return fail(SOZAI_ERROR_RANGE, "layout: %s of a sheet of veneer (cut = rotary); only none",
                s->list[P_LAYOUT].text);
  }
  w->peeled = 1;
  w->peel_radius = (float)radius;
  w->peel_lead = (float)(number_at(s, P_VENEER) / (0.5 * TWO_PI));
  /* at first the face looks as that of a flat-sawn board does */
  w->peel_turn = (float)(TWO_PI * (0.25 + number_at(s, P_CUT_ROTATION) / 360.0));
  w->shift[1] += (float)number_at(s, P_CUT_HEIGHT);
  return SOZAI_OK;
}

static int32_t build_cut(wood_constants *w, const settings *s) {
  int cut = choice_at(s, P_CUT);
  if (choice_at(s, P_CONSTRUCTION) != CONSTRUCTION_SOLID) return SOZAI_OK; /* each ply its own */
  if (cut == CUT_ROTARY) {
    for (int i = 0; i < 3; i++) w->shift[i] = (float)s->list[P_CUT_OFFSET].number[i];
    return build_veneer(w, s);
  }
  double angle = number_at(s, P_CUT_ROTATION) * TWO_PI / 360.0, d = number_at(s, P_CUT_DISTANCE);
  double c = scalar_cos(angle), n = scalar_sin(angle);
  /* the object's axes in the log, before the turn: columns are x, y, z */
  static const double along[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  static const double end[3][3] = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  /* a board's length leans towards its face and within it */
  const double lean = TWO_PI / 360.0 * number_at(s, P_CUT_TILT);
  const double askew = TWO_PI / 360.0 * number_at(s, P_CUT_SKEW);
  const double ct = scalar_cos(lean), st = scalar_sin(lean), ck = scalar_cos(askew),
               sk = scalar_sin(askew);
  const double tilted[3][3] = {{ck, sk * ct, -sk * st}, {-sk, ck * ct, -ck * st}, {0, st, ct}};
  const double(*axes)[3] = cut == CUT_END ? end : cut == CUT_LOG ? along : tilted;
  static const double half_root = 0.70710678118654752440;
  double place[3] = {0, cut == CUT_LOG ? 0 : number_at(s, P_CUT_HEIGHT), 0};
  if (cut == CUT_FLAT) place[2] = d;
  if (cut == CUT_QUARTER || cut == CUT_END) place[0] = d;
  if (cut == CUT_RIFT) place[0] = place[2] = d * half_root;
  /* about the stem: x towards z, as theta runs */
  const double turn[3][3] = {{c, 0, -n}, {0, 1, 0}, {n, 0, c}};
  for (int i = 0; i < 3; i++) {
    double shift = s->list[P_CUT_OFFSET].number[i];
    for (int j = 0; j < 3; j++) {
      double sum = 0.0;
      for (int k = 0; k < 3; k++) sum += turn[i][k] * axes[k][j];
      w->turn[i][j] = (float)sum;
      if (w->turn[i][j] != (i == j ? 1.0f : 0.0f)) w->turned = 1;
      shift += turn[i][j] * place[j];
    }
    w->shift[i] = (float)shift;
  }
  return SOZAI_OK;
}

/* ---- stem ------------------------------------------------------------- */

static int32_t build_stem(wood_constants *w, const settings *s) {
  w->pith_amplitude = (float)(2.0 * number_at(s, P_PITH_WANDER)); /* the noise stays within half */
  w->pith_frequency = (float)(1.0 / 900.0);
  w->taper = (float)(number_at(s, P_TAPER) / (1000.0 * 100.0));

  /* harmonics fall off as 1/k, and their sum stays within the wobble */
  double total = 0.0;
  for (int k = 1; k <= WOOD_HARMONICS; k++) total += 1.0 / k;
  for (int k = 1; k <= WOOD_HARMONICS; k++) {
    double a = number_at(s, P_OUTLINE) / (k * total);
    double t = TWO_PI * uniform(w->seed, STREAM_OUTLINE, (uint32_t)k);
    w->outline_cos[k - 1] = (float)(a * scalar_cos(t));
    w->outline_sin[k - 1] = (float)(a * scalar_sin(t));
  }

  double u = number_at(s, P_UNDULATION), size = number_at(s, P_UNDULATION_SIZE);
  if (u > 0.0900001 * size) {
    return fail(
        SOZAI_ERROR_RANGE,
        "undulation: %.9g mm is above 0.09 of undulation_size (%.9g mm): rings would cross; "
        "0 to %.9g mm",
        u, size, 0.09 * size);
  }
  static const double weight[2] = {1.0, 0.3}, scale[2] = {1.0, 0.31};
  for (int o = 0; o < 2; o++) {
    w->undulation[o] = (float)(2.0 * u * weight[o]);
    w->undulation_frequency_axis[o] = (float)(1.0 / (3.0 * size * scale[o]));
    w->undulation_size[o] = (float)(size * scale[o]);
    w->undulation_frequency_section[o] = (float)(1.0 / (size * scale[o]));
  }
  w->undulation_core = (float)(0.5 / size);
  return SOZAI_OK;
}

/* ---- rings ------------------------------------------------------------ */

/* Widths that vary about a mean, to a tree's growth at a height, from the year
 * in which its tip was there. After its last year it goes on as it did then. */
static void tree_widths(const knot_source *tree, double height, double mean, double *width) {
  int from = 0, last = (int)tree->age;
  while (from < last && knot_source_radius(tree, height, from + 1.0) <= 0.0) from++;
  double before = 0.0, wide = mean, least = 0.15;
  for (int j = 0; j < WOOD_RINGS; j++) {
    if (from + j < last) {
      double radius = knot_source_radius(tree, height, from + j + 1.0);
      wide = radius - before;
      before = radius;
      if (wide < least) wide = least;
    }
    width[j] *= wide / mean;
  }
}

/* Widths of the table's rings, mm. */
static int32_t ring_widths(const wood_constants *w, const settings *s, const knot_source *tree,
                           double *width) {
  const sozai_buffer *b = s->list[P_RING_WIDTHS].buffer;
  if (b) {
    uint64_t n = b->dims[0] * b->dims[1];
    if (n == 0 || b->dims[1] != 1) {
      return fail(SOZAI_ERROR_RANGE, "ring_widths: a table of %llu x %llu is not one column",
                  (unsigned long long)b->dims[0], (unsigned long long)b->dims[1]);
    }
    for (uint64_t i = 0; i < n; i++) {
      double x = (double)b->data[i];
      if (!(x >= 0.02 && x <= 200.0)) {
        return fail(SOZAI_ERROR_RANGE, "ring_widths: row %llu is %.9g, outside 0.02 to 200 mm",
                    (unsigned long long)i, x);
      }
    }
    for (int j = 0; j < WOOD_RINGS; j++) width[j] = (double)b->data[(uint64_t)j % n];
    return SOZAI_OK;
  }
  double mean = number_at(s, P_RING_WIDTH), sd = number_at(s, P_RING_VARIATION), sum = 0.0,
         before = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    /* good years come together: neighbours correlate by 0.4 */
    double n = normal(w->seed, STREAM_RINGS, (uint32_t)j);
    before = j ? 0.4 * before + 0.9165 * n : n;
    double f = scalar_exp(sd * before - 0.5 * sd * sd);
    width[j] = f < 0.4 ? 0.4 : f > 3.0 ? 3.0 : f;
    sum += width[j];
  }
  for (int j = 0; j < WOOD_RINGS; j++) width[j] *= mean * WOOD_RINGS / sum;
  if (tree->rings.count && number_at(s, P_TREE_RINGS) != 0.0) {
    tree_widths(tree, number_at(s, P_LOG_HEIGHT), mean, width);
  }
  return SOZAI_OK;
}

static double within01(double x) { return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x; }

/* The kernel's late_integral, for creation. */
static double late_profile_integral(const wood_constants *w, double f) {
  double before = 6.0 * (double)w->late_sixth, after = (double)w->late_after;
  double past = f - (double)w->late_middle;
  double a = within01((f - (double)w->late_start) / before), b = 1.0 - within01(past / after);
  double full = past > after ? past - after : 0.0;
  double missing = after * (2.0 / 3.0 - b + b * b * b / 3.0) +
                   full * (1.0 - 0.5 * full * (double)w->inverse_late_full);
  return before / 6.0 * a * a * a + after * (5.0 / 6.0 - b + b * b * b / 6.0) + full -
         (double)w->late_deepening * missing;
}

static void build_season(wood_constants *w, const settings *s) {
  double fraction = number_at(s, P_LATE_FRACTION), gradual = 1.0 - number_at(s, P_LATE_ABRUPTNESS);
  double middle = 1.0 - fraction;
  double before = middle * (0.03 + 0.87 * gradual), after = fraction * (0.08 + 0.52 * gradual);
  w->late_middle = (float)middle;
  w->late_start = (float)(middle - before);
  w->inverse_late_before = (float)(1.0 / before);
  w->late_sixth = (float)(before / 6.0);
  w->late_after = (float)after;
  w->inverse_late_after = (float)(1.0 / after);
  w->late_deepening = (float)number_at(s, P_LATE_DEEPENING);
  w->inverse_late_full = (float)(1.0 / (1.0 - middle - after));
}

static int32_t build_rings(wood_constants *w, const settings *s, const knot_source *tree) {
  double width[WOOD_RINGS], total = 0.0, least = 1e30, late = 0.0;
  int32_t r = ring_widths(w, s, tree, width);
  if (r) return r;
  double variation = number_at(s, P_LATE_VARIATION), whole = late_profile_integral(w, 1.0);
  for (int j = 0; j < WOOD_RINGS; j++) {
    w->start[j] = (float)total;
    total += width[j];
    w->start[j + 1] = (float)total;
    /* widths as the kernel sees them: the rounded boundaries' difference */
    width[j] = (double)w->start[j + 1] - (double)w->start[j];
    w->inverse_width[j] = (float)(1.0 / width[j]);
    if (width[j] < least) least = width[j];
    w->late_weight[j + 1] = (float)(1.0 - variation * uniform(w->seed, STREAM_LATE, (uint32_t)j));
    w->late_before[j] = (float)late;
    late += (double)w->late_weight[j + 1] * width[j] * whole;
    w->late_before[j + 1] = (float)late;
  }
  w->ring_period = w->start[WOOD_RINGS];
  w->inverse_ring_period = (float)(1.0 / (double)w->ring_period);
  w->late_weight[0] = w->late_weight[WOOD_RINGS];
  w->late_period = (float)late;
  w->ring_width = (float)(total / WOOD_RINGS);
  w->blur = 0.02f;
  double plateau = 1.0 - (double)w->late_middle - (double)w->late_after;
  double flat = (double)w->late_start < plateau ? (double)w->late_start : plateau;
  w->safe = (float)(flat * least);

  double bins = (double)w->ring_period / (0.9 * least) + 1.0;
  if (bins > WOOD_BINS_MAX) {
    return fail(SOZAI_ERROR_RANGE,
                "ring_widths: the narrowest, %.9g mm, is below a %dth of the mean, %.9g mm", least,
                WOOD_BINS_MAX / WOOD_RINGS, (double)w->ring_width);
  }
  int count = (int)bins;
  w->bin_last = count - 1;
  w->bin_scale = (float)(count / (double)w->ring_period);
  int j = 0;
  for (int b = 0; b < count; b++) {
    /* a little early, so that rounding never puts a point before its bin */
    double at = (b - 0.001) / (double)w->bin_scale;
    while (j + 1 < WOOD_RINGS && (double)w->start[j + 1] <= at) j++;
    w->bin[b][0] = (float)j;
    w->bin[b][1] = j + 1 < WOOD_RINGS ? w->start[j + 1] : 3e38f;
  }
  for (j = 0; j < WOOD_RINGS; j++) {
    const float row[4] = {w->start[j], w->inverse_width[j], w->late_weight[j + 1],
                          w->late_weight[j]};
    memcpy(w->ring_row[j], row, sizeof row);
  }
  return SOZAI_OK;
}

/* ---- grain ------------------------------------------------------------ */

/* Irregularity 0..1 of waves of a length. The noises' lattices are no multiples of
 * the wave's, nor of each other's: where they are zero nothing lines up. The phase
 * strays by 0.5 * 1.5 turns at most over 6.3 lengths: its slope stays within 1.3472 *
 * 1.5 / 6.3 = 0.32 of a turn a length, so that waves never run backwards. variance:
 * of the swell's noises, 1/3 times 26/35 for each axis. */
static wood_irregular build_irregular(double amount, double length, double variance) {
  double steady = 1.0 - 0.75 * amount, swell = 1.3 * amount;
  return (wood_irregular){
      .steady = (float)steady,
      .swell = (float)swell,
      .power = (float)(steady * steady + 2.0 * variance * swell * swell),
      .stray = (float)(1.5 * amount),
      .stray_frequency = (float)(1.0 / (6.3 * length)),
      .swell_frequency = (float)(1.0 / (2.7 * length)),
  };
}

static void build_grain(wood_constants *w, const settings *s) {
  int grain = choice_at(s, P_GRAIN), all = grain == GRAIN_COMPOUND;
  if (all || grain == GRAIN_SPIRAL) w->spiral = (float)number_at(s, P_SPIRAL_SLOPE);
  if (all || grain == GRAIN_WAVY) {
    double a = number_at(s, P_WAVE_SLOPE), l = number_at(s, P_WAVE_LENGTH);
    w->has_wave = a > 0.0;
    w->wave_slope = (float)a;
    w->wave_displacement = (float)(a * l / TWO_PI);
    w->wave_frequency = (float)(1.0 / l);
    w->wave_number = (float)(TWO_PI / l);
    double u = number_at(s, P_WAVE_IRREGULARITY);
    w->has_wave_irregularity = u > 0.0;
    w->wave = build_irregular(u, l, 0.184);
    w->wave_inverse_reach = (float)((double)w->ring_width / number_at(s, P_WAVE_REACH));
  }
  if (all || grain == GRAIN_INTERLOCKED) {
    w->has_interlocked = number_at(s, P_INTERLOCKED_SLOPE) > 0.0;
    w->interlocked_slope = (float)number_at(s, P_INTERLOCKED_SLOPE);
    w->interlocked_frequency = (float)(1.0 / number_at(s, P_INTERLOCKED_YEARS));
    w->interlocked_length = (float)number_at(s, P_INTERLOCKED_LENGTH);
    w->interlocked_irregularity = (float)number_at(s, P_INTERLOCKED_IRREGULARITY);
  }
  static const double weight[2] = {0.65, 0.35}, scale[2] = {1.0, 0.37};
  double most = number_at(s, P_SLOPE_NOISE), length = number_at(s, P_SLOPE_NOISE_LENGTH);
  w->has_slope_noise = most > 0.0;
  for (int o = 0; o < 2; o++) {
    double l = length * scale[o];
    /* 1.3472 is AXIAL_SLOPE_BOUND: the sum's slope stays within `most` */
    w->slope_noise[o] = (float)(most * weight[o] * l / 1.3472);
    w->slope_noise_size[o] = (float)l;
    w->slope_noise_frequency[o] = (float)(1.0 / l);
  }
  w->slope_noise_years = 1.0f / 9.0f;
}

/* ---- figure of the growth front ---------------------------------------- */

static int32_t build_curl(wood_constants *w, const settings *s) {
  double slope = number_at(s, P_CURL_SLOPE), length = number_at(s, P_CURL_LENGTH);
  w->has_curl = slope > 0.0;
  w->curl_slope = (float)slope;
  w->curl_height = (float)(slope * length / TWO_PI);
  w->curl_frequency = (float)(1.0 / length);
  double amount = number_at(s, P_CURL_IRREGULARITY), reach = number_at(s, P_CURL_REACH);
  w->curl = build_irregular(amount, length, 0.137);
  w->curl_inverse_reach = (float)(1.0 / reach);
  /* rings keep apart: u changes across the stem by the swell's noises, 3.2 a reach at
   * most each, and by the phase's, 1.5 over CURL_STRAY_REACH */
  double strongest = (double)w->curl.steady + 1.4142 * (double)w->curl.swell;
  double bound = 3.0 * 3.2 * (double)w->curl.swell / TWO_PI +
                 strongest * (double)w->curl.stray * 1.5 / (double)CURL_STRAY_REACH;
  if (slope * length * bound > 0.8000001 * reach) {
    return fail(SOZAI_ERROR_RANGE,
                "curl_slope: %.9g over a curl_length of %.9g mm, a curl_irregularity of %.9g and a "
                "curl_reach of %.9g mm: rings would cross; 0 to %.9g",
                slope, length, amount, reach, 0.8 * reach / (length * bound));
  }
  return SOZAI_OK;
}

static int32_t build_quilt(wood_constants *w, const settings *s) {
  double quilt = number_at(s, P_QUILT_SLOPE), height = number_at(s, P_QUILT_HEIGHT);
  double width = number_at(s, P_QUILT_WIDTH), most = 0.117 * width / height;
  if (quilt > most * 1.0000001) {
    return fail(SOZAI_ERROR_RANGE,
                "quilt_slope: %.9g is above 0.117 of quilt_width (%.9g mm) over quilt_height "
                "(%.9g mm): rings would cross; 0 to %.9g",
                quilt, width, height, most);
  }
  w->has_quilt = quilt > 0.0;
  w->quilt_slope = (float)quilt;
  /* the noise's slope is 0.41, root mean square */
  w->quilt_height = (float)(quilt * height / 0.41);
  w->quilt_frequency = (float)(1.0 / width);
  w->quilt_frequency_axis = (float)(1.0 / height);
  w->quilt_size = (float)(width < height ? width : height);
  return SOZAI_OK;
}

static int32_t build_eyes(wood_constants *w, const settings *s) {
  double density = number_at(s, P_EYE_DENSITY), diameter = number_at(s, P_EYE_DIAMETER);
  double crowd = 32.0 / (diameter * diameter);
  if (density > crowd * 1.0000001) {
    return fail(
        SOZAI_ERROR_RANGE,
        "eye_density: %.9g/cm2 leaves no room for eyes of eye_diameter = %.9g mm; 0 to %.9g",
        density, diameter, crowd);
  }
  double depth = number_at(s, P_EYE_DEPTH),
         deepest = number_at(s, P_EYE_LENGTH) / (17.5 * diameter);
  if (density > 0.0 && depth > deepest * 1.0000001) {
    return fail(SOZAI_ERROR_RANGE,
                "eye_depth: %.9g of eyes of %.9g mm over an eye_length of %.9g mm: rings would "
                "cross; 0 to %.9g",
                depth, diameter, number_at(s, P_EYE_LENGTH), deepest);
  }
  w->has_eyes = density > 0.0 && depth > 0.0;
  w->eye_radius = (float)(0.5 * diameter);
  w->eye_depth = (float)depth;
  w->eye_length = (float)number_at(s, P_EYE_LENGTH);
  w->inverse_eye_length = (float)(1.0 / number_at(s, P_EYE_LENGTH));
  if (!w->has_eyes) return SOZAI_OK;
  /* in each of four layers a share of the cells have one, and a radius meets three quarters of
   * those, less what has only begun or all but ended */
  double cell = 10.0 * __builtin_sqrt(0.62 * 0.7 / (0.25 * density));
  /* in the mean over a face: the layers' radii squared are 1.07 of the mean's, eyes nine
   * tenths grown; to 0.68 the cells' edges cut, as the filter's test found */
  const double eyes = 0.68 * (double)WOOD_EYE_DARK;
  double area = 3.14159265 * WOOD_EYE_LONG * eyes * w->eye_radius * w->eye_radius;
  w->eye_mean = (float)(0.01 * density * area * WOOD_EYE_MEAN);
  w->eye_cell = (float)cell;
  w->inverse_eye_cell = (float)(1.0 / cell);
  return SOZAI_OK;
}

static int32_t build_figure(wood_constants *w, const settings *s) {
  int32_t r = build_curl(w, s);
  if (!r) r = build_quilt(w, s);
  if (!r) r = build_eyes(w, s);
  return r;
}

/* ---- vessels ---------------------------------------------------------- */

/* Radii of a layer and what follows from them. Returns the mean square of
 * radius over mean radius. */
static double build_radii(wood_vessels *v, double diameter_um, double spread) {
  double square = 0.0;
  for (int i = 0; i < WOOD_RADII; i++) {
    double k = 1.0 + spread * radius_quantiles[i];
    if (k < 0.2) k = 0.2;
    square += k * k;
    v->inverse_square[i] = (float)(1.0 / (k * k));
  }
  v->radius = (float)(0.5e-3 * diameter_um);
  /* disc.top is 2.5 at the most; a little farther, so that rounding leaves
   * nothing beyond it */
  v->farthest = 2.5001f / v->inverse_square[WOOD_RADII - 1];
  return square / WOOD_RADII;
}

/* The longest footprint for which every vessel that could cover it lies
 * within `clear` of its centre: the blurred disc's half length is
 * sqrt(end (R^2 + e^2 / (12 * 0.2552))), end being where it is 0 in q. */
#define END_SHARP 1.25 /* of a disc that is full in its middle */
#define END_CONE 1.48

static float longest_footprint(double clear, double radius, double end) {
  double e2 = (clear * clear / end - radius * radius) * 12.0 * 0.2552;
  double least = radius * radius;
  if (e2 < least) e2 = least;
  return (float)__builtin_sqrt(e2);
}

/* Discs thrown at random over an area leave exp(-c) of it free, c being the
 * sum of their areas over it. */
static void build_overlap(wood_vessels *v) {
  double c = (double)v->coverage;
  double covered = 1.0 - scalar_exp(-c);
  v->overlap = c > 1e-6 ? (float)(1.0 - covered / c) : 0.0f;
  v->coverage = (float)covered;
}

/* The same for the rows, which overlap their neighbours only: they are laid
 * out as the kernel does, and their covered area is counted on a grid. */
static void build_row_overlap(wood_constants *w, double row_density) {
  enum { VESSELS = 24, ACROSS = 6, DEEP = 10 };
  double radius = (double)w->row.radius, spacing = 1.0 / row_density;
  double deep = 2.0 * radius / DEEP, across = spacing / ACROSS;
  int rows = w->rows, lines = (int)(((double)w->row_spacing * rows + 2.0 * radius) / deep) + 1;
  long area = 0, covered = 0;
  for (int i = 0; i < VESSELS * ACROSS; i++) {
    for (int j = 0; j < lines; j++) {
      double px = (i + 0.5) * across, pz = (j + 0.5) * deep - radius;
      int hits = 0;
      for (int m = 0; m < rows; m++) {
        for (int k = i / ACROSS - 1; k <= i / ACROSS + 1; k++) {
          uint32_t id = (uint32_t)(m * (VESSELS + 2) + k + 1);
          double shift = uniform(1, STREAM_ROW_X, 9999u + (uint32_t)m) - 0.5;
          double jx = (uniform(1, STREAM_ROW_X, id) - 0.5) * (double)w->row_jitter_arc;
          double jz = (uniform(1, STREAM_ROW_Z, id) - 0.5) * (double)w->row_jitter_radial;
          double dx = px - (k + 0.5 + shift + jx) * spacing;
          double dz = pz - jz - m * (double)w->row_spacing;
          double square = (double)w->row.inverse_square[(id * 7) % WOOD_RADII];
          hits += (dx * dx + dz * dz) * square < radius * radius;
        }
      }
      area += hits;
      covered += hits > 0;
    }
  }
  w->row.overlap = area ? (float)(1.0 - (double)covered / (double)area) : 0.0f;
  w->row.coverage *= 1.0f - w->row.overlap;
}

/* How much of all rings' latewood lies within `band` of their starts: in narrow rings the rows
 * reach into it. */
static double late_among_rows(const wood_constants *w, double band) {
  double within = 0.0, all = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    double inverse = (double)w->inverse_width[j], late = (double)w->late_weight[j + 1] / inverse;
    within += late * late_profile_integral(w, scalar_least(band * inverse, 1.0));
    all += late * late_profile_integral(w, 1.0);
  }
  return all > 0.0 ? within / all : 0.0;
}

/* Parts may be longer than reach: what they cut off is tails of the largest pores, where a
 * footprint's middle lies between the cells looked at and the next. The earlywood's vessels
 * fill their place along the row, and their shape under longer parts is less exact. */
#define PART_CLEAR 0.7  /* of a cell */
#define PART_OF_ROW 1.5 /* of a vessel's radius */

/* late: the pores' size at a ring's end, over that at its start. */
static void build_pores(wood_constants *w, const settings *s, double late) {
  double d = number_at(s, P_PORE_DIAMETER), spread = number_at(s, P_PORE_SPREAD);
  double density = number_at(s, P_PORE_DENSITY);
  double square = build_radii(&w->pores, d, spread);
  double largest = (double)w->pores.radius * (1.0 + 2.5 * spread) * (late > 1.0 ? late : 1.0);
  w->pore_cell = (float)(1.0 / __builtin_sqrt(density));
  w->inverse_pore_cell = 1.0f / w->pore_cell;
  w->pore_step = w->pore_cell / 4294967296.0f;
  w->pores.reach = longest_footprint(0.5 * (double)w->pore_cell, largest, END_SHARP);
  double usual = (double)w->pores.radius * (1.0 + spread) * (late > 1.0 ? late : 1.0);
  w->pores.part = longest_footprint(PART_CLEAR * (double)w->pore_cell, usual, END_SHARP);
  w->pores.third = longest_footprint(PART_CLEAR * (double)w->pore_cell, usual, END_CONE);
  w->pores.coverage =
      (float)(0.5 * TWO_PI * (double)w->pores.radius * (double)w->pores.radius * square * density);
  if (!w->has_pores) w->pores.coverage = 0.0f;
  build_overlap(&w->pores);
  w->pore_early = 1.0f;
  w->pore_growth = (float)(late - 1.0);
  double g = late - 1.0;
  w->pore_ring_mean = (float)(1.0 + g + g * g / 3.0);
}

/* What the pores are expected to take of latewood, over what they do where they are full size: the
 * mean of size^2 over the profile, by the midpoint rule. late: as of build_pores. */
static double late_among_pores(const wood_constants *w, double late) {
  double taken = 0.0, tissue = 0.0, g = late - 1.0;
  for (int i = 0; i < 256; i++) {
    double f = (i + 0.5) / 256.0;
    double l = late_profile_integral(w, (i + 1.0) / 256.0) - late_profile_integral(w, i / 256.0);
    double size = 1.0 + g * f;
    taken += l * size * size;
    tissue += l;
  }
  return tissue > 0.0 ? taken / tissue : 1.0;
}

/* band: mm of all rows; narrow rings have room for a part of them alone. */
static void build_row_band(wood_constants *w, double band) {
  double least = 1e30, room = 0.0, whole = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    double width = 1.0 / (double)w->inverse_width[j];
    w->row_before[j] = (float)room;
    room += scalar_least(band, width);
    whole += width;
    if (width < least) least = width;
  }
  w->row_before[WOOD_RINGS] = w->row_period = (float)room;
  w->rows_alone = (float)(0.999 * (double)WOOD_ROWS_ALONE * least);
  w->band = (float)band;
  /* of the latewood within the band, over that of all wood */
  if (w->rows) w->late_row = (float)scalar_least(late_among_rows(w, band) * whole / room, 1.0);
}

static void build_rows(wood_constants *w, const settings *s) {
  double d = number_at(s, P_ROW_DIAMETER), density = number_at(s, P_ROW_DENSITY);
  double square = build_radii(&w->row, d, number_at(s, P_ROW_SPREAD));
  double radius = (double)w->row.radius, spacing = 1.05e-3 * d;
  double largest = radius * (1.0 + 2.5 * number_at(s, P_ROW_SPREAD));
  w->row.reach =
      longest_footprint((1.0 - 0.5 * number_at(s, P_ROW_JITTER)) / density, largest, END_SHARP);
  w->row.part = (float)(PART_OF_ROW * radius);
  if (w->row.part > w->row.reach) w->row.part = w->row.reach;
  double least_square = 1.0;
  for (int i = 0; i < WOOD_RADII; i++) {
    double inverse_square = (double)w->row.inverse_square[i];
    w->row_inverse[i] = (float)__builtin_sqrt(inverse_square);
    w->row_square[i] = (float)(1.0 / inverse_square);
    if (inverse_square < least_square) least_square = inverse_square;
  }
  w->row_largest = (float)(1.12 * radius / __builtin_sqrt(least_square));
  w->row_density = (float)density;
  w->row_spacing = (float)spacing;
  w->row_start = (float)(0.55e-3 * d);
  w->row_jitter_arc = (float)number_at(s, P_ROW_JITTER);
  w->row_jitter_radial = (float)(0.4 * radius * number_at(s, P_ROW_JITTER));
  w->row_step_arc = w->row_jitter_arc / 4294967296.0f;
  w->row_step_radial = w->row_jitter_radial / 4294967296.0f;
  build_row_band(w, w->rows * spacing);
  w->row.coverage = 0.0f;
  if (!w->rows) return;
  w->row.coverage = (float)(density * 0.5 * TWO_PI * radius * radius * square / spacing);
  build_row_overlap(w, density);
}

static void build_vessels(wood_constants *w, const settings *s) {
  int porosity = choice_at(s, P_POROSITY);
  w->has_pores = porosity != POROSITY_NONE;
  w->rows = porosity == POROSITY_RING ? (int32_t)number_at(s, P_ROWS) : 0;
  double late = porosity == POROSITY_SEMI_RING
                    ? number_at(s, P_PORE_DIAMETER_LATE) / number_at(s, P_PORE_DIAMETER)
                    : 1.0;
  build_pores(w, s, late);
  build_rows(w, s);
  w->late_vessel = (float)((double)w->pores.coverage * late_among_pores(w, late));
}

/* ---- rays ------------------------------------------------------------- */

static double limited(double x, double low, double high) {
  return x < low ? low : x > high ? high : x;
}

/* mm from the pith at which a sector has one ray; farther in, some have none. Broad rays show which
 * of them begin together. */
#define RAYS_ONE 20.0
#define RAYS_ONE_BROAD 40.0

#define RAY_RAGGED                                                                                 \
  0.009 /* mm: most of a cell's width, by which its rows begin and end unevenly                    \
         */

static void build_rays(wood_constants *w, const settings *s) {
  double density = number_at(s, P_RAY_DENSITY), height = number_at(s, P_RAY_HEIGHT);
  double width = 1e-3 * number_at(s, P_RAY_WIDTH), length = number_at(s, P_RAY_LENGTH);
  w->has_rays = density > 0.0;
  if (!w->has_rays) return;
  /* a cell holds the tallest, one and a half times the mean, with some to spare;
   * a radius meets three quarters of the rays */
  double cell = 1.65 * height, arc = 0.75 / (density * cell);
  w->ray_length = (float)length;
  w->inverse_ray_length = (float)(1.0 / length);
  w->inverse_ray_arc = (float)(1.0 / arc);
  w->inverse_ray_cell = (float)(1.0 / cell);
  w->ray_tall = (float)(0.5 * height / cell);
  /* broad rays are uneven: fibres pass between their cells */
  double broad = limited((height - 3.0) / 9.0, 0.0, 1.0), uneven = 0.55 * broad;
  w->ray_uneven = (float)uneven;
  /* a footprint with few of them in it is not one with their mean */
  w->ray_sides = broad > 0.5 ? 2 : 1;
  double one = RAYS_ONE + (RAYS_ONE_BROAD - RAYS_ONE) * broad;
  double sectors = (int)limited(TWO_PI * one / arc, 8.0, 4096.0);
  w->ray_sectors = (float)sectors;
  w->ray_sector_turn = (float)(TWO_PI / sectors);
  w->ray_per_radius = (float)(TWO_PI / (arc * sectors));
  /* within its cell, whatever it was asked for: 0.33 to each side of where it may
   * stand, for 1.3 times the mean, unevenly */
  double half = 0.5 * width, room = 0.329, ragged = limited(RAY_RAGGED / half, 0.0, 0.35);
  double most = 1.3 * (1.0 + uneven) * (1.0 + ragged);
  if (half > 0.2 * arc) half = 0.2 * arc;
  if (half > room / most * arc) half = room / most * arc;
  w->ray_half = (float)half;
  w->ray_ragged = (float)ragged;
  w->ray_blunt = (float)broad;
  w->ray_room = (float)room;
  w->ray_thickest = (float)(most * half);
  /* Sheets sway along the fibre: fine ones little, broad ones by slopes of some degrees
   * over more than their height, for which a cut along them shows ribbons. Along the
   * radius they are nearly straight. */
  double along = (0.4 + 0.7 * broad) * height, slope = 0.05 + 0.02 * broad;
  w->ray_stray = (float)(slope * along / 2147483648.0);
  w->ray_wave_radial = (float)(1.0 / (8.0 + 3.5 * height));
  w->ray_wave_along = (float)(1.0 / along);
  /* light goes round the edges of a broad ray, which a cut along it leaves wedges of */
  double sharp = limited(0.2 * broad * half, 0.01, 1.0);
  w->ray_sharp2 = (float)(sharp * sharp);
  /* two thirds of a lens's height and width, less what the ends' taper takes; and the mean
   * of thickness times density */
  w->ray_cover = (float)(density * height * 2.0 * half * (2.0 / 3.0 + 2.0 / 15.0 * broad) * 11.0 /
                         12.0 * 0.82);
}

/* ---- canals, cells, spalting ------------------------------------------- */

/* Latewood's share where canals stand, which are the more the later in the ring: the
 * profile's mean over the phases that canals_at gives them, in a ring of the mean width. */
static double late_of_canals(const wood_constants *w) {
  enum { PARTS = 64 };
  double margin = (double)CANAL_MARGIN * (double)w->canal.radius / (double)w->ring_width;
  double low = limited((double)CANAL_LOW, margin, 0.5), high = limited(1.0 - margin, 0.5, 1.0);
  double mean = 0.0, before = low, late = late_profile_integral(w, low);
  for (int i = 1; i <= PARTS; i++) {
    double at = low + (high - low) * i / PARTS, next = late_profile_integral(w, at);
    mean += (next - late) / (at - before) * (2.0 * i - 1.0) / (PARTS * PARTS);
    before = at;
    late = next;
  }
  double whole = late_profile_integral(w, 1.0) * (double)w->ring_period;
  return mean * (whole > 0.0 ? (double)w->late_period / whole : 0.0);
}

static void build_canals(wood_constants *w, const settings *s, const float (*colours)[3]) {
  double density = number_at(s, P_CANAL_DENSITY), diameter = number_at(s, P_CANAL_DIAMETER);
  w->has_canals = density > 0.0;
  w->canal_density = (float)density;
  /* so that neighbours in a row stand farther apart than they are wide */
  int rows = (int)(2.5e-3 * diameter * density * (double)w->ring_width) + 1;
  w->canal_rows = rows < 4 ? rows : 4;
  double square = build_radii(&w->canal, diameter, 0.18), r = (double)w->canal.radius;
  double covered = 0.5 * TWO_PI * r * r * square * density;
  w->canal.coverage = (float)(covered < 1.0 ? covered : 1.0);
  w->canal_late = (float)late_of_canals(w);
  for (int c = 0; c < 3; c++) {
    w->canal_colour[c] = colours[P_CANAL_COLOUR][c];
    w->canal_lumen[c] = 0.55f * colours[P_CANAL_COLOUR][c];
  }
}

/* Of 0..1. */
static double cube_root(double x) {
  double r = 1.0;
  for (int i = 0; i < 40; i++) r = (2.0 * r + x / (r * r)) / 3.0;
  return r;
}

static void build_cells(wood_constants *w, const settings *s) {
  double contrast = number_at(s, P_CELL_CONTRAST);
  w->has_cells = contrast > 0.0;
  double width = 1e-3 * number_at(s, P_CELL_WIDTH), early = 1e-3 * number_at(s, P_CELL_DEPTH);
  double late = 1e-3 * number_at(s, P_CELL_DEPTH_LATE);
  w->inverse_cell_width = (float)(1.0 / width);
  w->inverse_cell_early = (float)(1.0 / early);
  w->inverse_cell_late = (float)(1.0 / late);
  w->inverse_cell_length = (float)(1.0 / number_at(s, P_CELL_LENGTH));
  w->cell_gone = (float)(4.0 * (width > early ? width : early));
  /* walls: latewood's are up to twice the mean's share, and the ring's sum is the
   * density's */
  double share = limited(number_at(s, P_BASIC_DENSITY) / 1500.0, 0.08, 0.92);
  double part = late_profile_integral(w, 1.0);
  double thick = late < 0.7 * early ? 2.0 * share : 1.15 * share;
  thick = limited(thick, share, share > 0.85 ? share : 0.85);
  w->wall_late = (float)thick;
  w->wall_early = (float)limited((share - part * thick) / (1.0 - part + 1e-9), 0.08, share);
  w->cell_bend = (float)((double)CELL_BEND_BY * number_at(s, P_CELL_IRREGULARITY));
  /* to a file, one in every so many mm of its height */
  double pitch = number_at(s, P_FINE_RAYS) * width;
  pitch = limited(pitch, 0.0, 0.6 / (double)FINE_RAY_TALL);
  w->inverse_fine_pitch = (float)pitch;
  w->fine_tall = (float)(pitch * (double)FINE_RAY_TALL);
  w->fine_open = (float)cube_root(1.0 - (double)w->wall_early);
  double most = 1.0 / (1.0 - (double)w->wall_early);
  w->cell_white = (float)(0.97 * most / (1.0 + number_at(s, P_FIBRE_BRIGHTNESS)));
  w->cell_open = (float)most;
  w->cell_end = (float)(0.65 * contrast);
  w->cell_side = (float)(0.26 * contrast);
  w->tyloses = (float)(1.1 * number_at(s, P_TYLOSES) * contrast);
  w->inverse_tylose = (float)(1.0 / (0.45e-3 * number_at(s, P_ROW_DIAMETER)));
  double wide = 1.2e-3 * number_at(s, P_ROW_DIAMETER), apart = (double)w->pore_cell;
  w->rim_squares = (float)(1.0 / (w->rows && apart < wide ? wide : apart));
  w->inverse_element = (float)(1.0 / number_at(s, P_ELEMENT_LENGTH));
}

/* Of a colony whose edge is at `level` of a noise with the first octave at `scale`: the
 * share of wood within, and mm of edge to a mm^2 of wood, times the colonies' size; returns
 * the noise's variance. The noise is nearly normal, and its slope does not depend on it: a level
 * set's area is the density times the mean slope (S. O. Rice, 1944). */
static double spalt_expect(double level, double scale, double *within, double *edge) {
  double variance = (double)SPALT_VARIANCE, slope = (double)SPALT_SLOPE * scale * scale;
  for (int o = 1; o < SPALT_OCTAVES; o++) {
    double weight = (double)spalt_weight[o], steep = weight * (double)spalt_scale[o];
    variance += (double)SPALT_VARIANCE * weight * weight;
    slope += (double)SPALT_SLOPE * steep * steep;
  }
  double density = scalar_exp(-0.5 * level * level / variance) * 0.39894228;
  /* the mean length of a normal gradient that is 2.5 times flatter along the fibre */
  *edge = density * scalar_root(slope / variance) * 1.30;
  double z = level / scalar_root(variance), t = 1.0 / (1.0 + 0.33267 * z);
  *within = density * t * (0.4361836 + t * (-0.1201676 + 0.937298 * t));
  return variance;
}

static void build_spalt(wood_constants *w, const settings *s) {
  double amount = number_at(s, P_SPALT), size = number_at(s, P_SPALT_SIZE);
  double width = number_at(s, P_SPALT_WIDTH), within[2], edge[2];
  w->has_spalt = amount > 0.0;
  w->spalt_frequency = (float)(1.0 / size);
  w->spalt_width = (float)width;
  double level = 0.46 - 0.42 * amount, other = 0.5 - 0.42 * amount;
  w->spalt_level = (float)level;
  w->spalt_other = (float)other;
  double variance = spalt_expect(level, 1.0, &within[0], &edge[0]);
  spalt_expect(other, (double)SPALT_SECOND, &within[1], &edge[1]);
  double left = 1.0 - within[0], outside = left * (1.0 - within[1]);
  /* beyond the first colonies their own octave is low, which thins the second's lines and
   * bleaching: the mean of a normal number below a level */
  double spread = scalar_root(variance);
  double low = (double)SPALT_DEVIATION / spread * 0.39894228 *
               scalar_exp(-0.5 * level * level / variance) / left;
  double longest = edge[0] + left * edge[1];
  double lines = (edge[0] + left * edge[1] * (1.0 - (double)SPALT_SWELL * low)) * width / size;
  w->spalt_line_mean = (float)(lines < 1.0 ? lines : 1.0);
  w->spalt_bleach_mean = (float)(SPALT_BLEACH * within[0] +
                                 SPALT_BLEACH_SECOND * left * within[1] * (1.0 - 0.3 * low));
  /* how stains lie between colonies: measured */
  w->spalt_stain_mean = (float)(longest * (double)SPALT_STAIN * (0.046 + 0.51 * outside));
}

/* ---- fibres, colour, figure ------------------------------------------- */

/* The fibres' noise's variance over its bound's square: a third from each corner, and
 * 26/35 of that is left between them along each axis. */
#define FIBRE_VARIANCE 0.1839

static void build_fibres(wood_constants *w, const settings *s) {
  static const double size[WOOD_FIBRE_OCTAVES] = {1.0, 7.0, 60.0};
  static const double weight[WOOD_FIBRE_OCTAVES] = {0.34, 0.33, 0.33};
  /* of the growth front: a cell more or less in a radial file of them, and bundles */
  static const double bundle[WOOD_FIBRE_OCTAVES] = {0.25, 0.4, 0.35};
  double most = 0.25 * number_at(s, P_RING_WIDTH), stray = number_at(s, P_LATE_STRAY);
  if (stray > most) stray = most;
  w->has_front = stray > 0.0;
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    double l = number_at(s, P_FIBRE_WIDTH) * size[o];
    w->fibre_scale[o] = (float)(number_at(s, P_FIBRE_BRIGHTNESS) * weight[o] / 2147483648.0);
    w->fibre_frequency[o] = (float)(1.0 / l);
    w->fibre_blur[o] = (float)(0.125 / (l * l));
    double front = stray * bundle[o];
    w->fibre_front[o] = (float)(front / 2147483648.0);
    w->fibre_variance[o] = (float)(front * front * FIBRE_VARIANCE);
  }
}

static int32_t build_colour(wood_constants *w, const sozai_host *host, const settings *s,
                            const float (*colours)[3]) {
  memcpy(w->early, colours[P_EARLY_COLOUR], sizeof w->early);
  memcpy(w->late, colours[P_LATE_COLOUR], sizeof w->late);
  memcpy(w->vessel, colours[P_VESSEL_COLOUR], sizeof w->vessel);
  memcpy(w->ray, colours[P_RAY_COLOUR], sizeof w->ray);
  memcpy(w->sap_early, colours[P_SAP_EARLY], sizeof w->sap_early);
  memcpy(w->sap_late, colours[P_SAP_LATE], sizeof w->sap_late);
  memcpy(w->pigment, colours[P_PIGMENT_COLOUR], sizeof w->pigment);
  pigment_build(w, s);
  memcpy(w->streak, colours[P_STREAK_COLOUR], sizeof w->streak);
  double streaks = number_at(s, P_STREAK_SHARE);
  if (streaks > 0.0) {
    tubes_filling(&w->streaks, 0.5 * number_at(s, P_STREAK_WIDTH), number_at(s, P_STREAK_LENGTH),
                  0.75, streaks / (double)WOOD_STREAK);
  }
  w->heart_years = (float)number_at(s, P_HEART_YEARS);
  w->heart_edge = (float)number_at(s, P_HEART_EDGE);
  w->heart_stray = (float)number_at(s, P_HEART_STRAY);
  for (int k = 1; k <= 3; k++) {
    double t = TWO_PI * uniform(w->seed, STREAM_HEART, (uint32_t)k);
    double a = number_at(s, P_HEART_STRAY) / (k * (1.0 + 1.0 / 2.0 + 1.0 / 3.0));
    w->heart_cos[k - 1] = (float)(a * scalar_cos(t));
    w->heart_sin[k - 1] = (float)(a * scalar_sin(t));
  }
  w->diffuse = (float)number_at(s, P_DIFFUSE);
  w->specular = (float)number_at(s, P_SPECULAR);
  w->shininess = (float)number_at(s, P_SHININESS);
  /* the kernel's own operations, in its own precision */
  w->roughness = __builtin_sqrtf(2.0f / (w->shininess + 2.0f));
  float hue[3];
  int32_t r = colour_hue(host, wood_parameters[P_EARLY_COLOUR], &s->list[P_EARLY_COLOUR], hue);
  if (r) return r;
  double tint = number_at(s, P_TINT);
  for (int c = 0; c < 3; c++) w->tint_colour[c] = (float)(1.0 + tint * ((double)hue[c] - 1.0));
  return SOZAI_OK;
}

static void build_cone(wood_constants *w, const settings *s) {
  w->cone = choice_at(s, P_REFLECTION) == REFLECTION_CONE;
  w->ior = (float)number_at(s, P_IOR);
  w->inverse_ior = 1.0f / w->ior;
  w->cone_width = (float)(number_at(s, P_CONE_WIDTH) * TWO_PI / 360.0);
  for (int c = 0; c < 3; c++) {
    double k = number_at(s, P_FIBRE_REFLECTANCE) * surface_fibres(s) * (double)w->tint_colour[c];
    w->fibre_colour[c] = (float)(k > 0.0 ? k : 0.0);
  }
  if (w->cone) cone_table_build(w);
}

/* What a tree may have a say in. */
static int32_t build_grown(wood_constants *w, const sozai_host *host, const settings *s,
                           const float (*colours)[3]) {
  knot_source tree;
  int32_t r = knot_source_open(&tree, host, s);
  if (r) return r;
  r = build_stem(w, s);
  if (!r) r = build_rings(w, s, &tree);
  if (!r) r = wood_build_knots(w, host, s, &tree, colours);
  knot_source_close(&tree, host);
  return r;
}

/* Once all of it is known. Products as the kernels of many lanes round them. */
static void build_fours(wood_constants *w) {
  wood_fours *q = &w->fours;
  for (int i = 0; i < 4; i++) {
    int both = i & 1, twice = i >> 1; /* which of two: both of them twice; each of them twice */
    q->pith[i] = i < 2 ? w->pith_amplitude : w->pith_amplitude * w->pith_frequency;
    q->pith_seed[i] = w->seeds[twice ? SEED_PITH_Z : SEED_PITH_X];
    q->section[i] = w->undulation_frequency_section[twice];
    q->axis[i] = w->undulation_frequency_axis[twice];
    q->height[i] = w->undulation[both];
    q->slope_y[i] = i < 2 ? 1.0f : w->undulation_frequency_axis[both];
    q->slope[i] = w->undulation_frequency_section[both];
    q->undulation_seed[i] = w->seeds[SEED_UNDULATION + twice];
    q->often[i] = w->slope_noise_frequency[twice];
    q->far[i] = w->slope_noise[both] * (i < 2 ? 1.0f : w->slope_noise_frequency[both]);
    q->by_years[i] = w->slope_noise[both] * w->slope_noise_years;
    q->slope_seed[i] = w->seeds[SEED_SLOPE + twice];
    if (i == WOOD_FIBRE_OCTAVES) break;
    q->blur[i] = w->fibre_blur[i];
    q->blur2[i] = w->fibre_blur[i] * w->fibre_blur[i];
    q->frequency[i] = w->fibre_frequency[i];
    q->scale[i] = w->fibre_scale[i];
    q->front[i] = w->fibre_front[i];
    q->variance[i] = w->fibre_variance[i];
    q->fibre_seed[i] = w->seeds[SEED_FIBRE + i];
  }
}

int32_t wood_build(wood_constants *w, const sozai_host *host, const settings *s,
                   const float (*colours)[3], const image_set *images) {
  w->seed = hash1_named((uint32_t)number_at(s, P_SEED) + 0x51ed270bu, s->list[P_OBJECT].text);
  for (uint32_t i = 0; i < WOOD_SEEDS; i++) w->seeds[i] = hash1(w->seed + 0x9e3779b9u * (i + 1));
  int32_t r = build_cut(w, s);
  if (r) return r;
  build_season(w, s);
  r = build_grown(w, host, s, colours);
  if (r) return r;
  build_grain(w, s);
  r = build_figure(w, s);
  if (r) return r;
  build_vessels(w, s);
  build_rays(w, s);
  build_fibres(w, s);
  r = build_colour(w, host, s, colours);
  if (r) return r;
  r = surface_build(w, s);
  if (r) return r;
  age_build(w, s, colours);
  w->shade = (float)number_at(s, P_END_SHADE);
  w->ray_shade = (float)number_at(s, P_RAY_SHADE);
  w->has_ends = w->shade > 0.0f || w->ray_shade > 0.0f;
  surface_build_colour(w, s, colours);
  build_canals(w, s, colours);
  build_cells(w, s);
  build_spalt(w, s);
  build_cone(w, s);
  r = wood_build_boards(w, s, colours);
  if (!r) r = plies_build(w, s, colours);
  if (!r && images->service && images->list[P_SECTION]) {
    r = section_build(w, host, s, images->service, images->list[P_SECTION]);
  }
  build_fours(w);
  return r;
}
