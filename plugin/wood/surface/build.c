/* SPDX-License-Identifier: Apache-2.0
 *
 * From parameters to the surface's constants.
 */
#include "build.h"

#include <string.h>

#include "../../core/scalar.h"
#include "../../core/status.h"
#include "finishes.h"

/* Of value noise within +-1 whose lattice is 1: the mean of (1 - w)^2 + w^2 over
 * the cubic blend w, and from it the mean square slope along an axis of two, and
 * the standard deviation. */
#define BLEND2 (26.0 / 35.0)
#define NOISE_SLOPE2 (2.0 / 3.0 * 1.2 * BLEND2)
#define NOISE_SD 0.42890
#define HASH_RANGE 2147483648.0

/* The parameter, or what is usual. */
static double usual(const settings *s, int place, double otherwise) {
  double x = number_at(s, place);
  return x < 0.0 ? otherwise : x;
}

static void noise_of(surface_noise *q, double height, double along, double across) {
  const double size[2] = {along, across};
  q->height = (float)(height / HASH_RANGE);
  q->size = (float)(along < across ? along : across);
  for (int i = 0; i < 2; i++) {
    q->frequency[i] = (float)(1.0 / size[i]);
    q->slope2[i] = (float)(height * height / (size[i] * size[i]) * NOISE_SLOPE2);
  }
}

/* Which of the octaves a point's height is counted in: shadows are by slopes. */
static void rank_octaves(surface_noise *q) {
  double sum = 0.0;
  for (int o = 0; o < SURFACE_OCTAVES; o++) sum += (double)(q[o].slope2[0] + q[o].slope2[1]);
  for (int o = 0; o < SURFACE_OCTAVES; o++) {
    double share = (double)(q[o].slope2[0] + q[o].slope2[1]) / sum;
    q[o].rank = (float)(scalar_root(share) / (NOISE_SD * HASH_RANGE));
  }
}

/* ---- tools ------------------------------------------------------------- */

/* Scratches of a grit: as wide as its grains and four times as wide, since the
 * few that stand out scratch most. Finer paper also cuts less deep for its size. */
static void build_scratches(wood_surface *m, const settings *s) {
  double grit = number_at(s, P_SANDING_GRIT);
  /* FEPA P scale, a power law through its 40 and 400; mm */
  double grain = 0.425 * scalar_exp(1.085 * scalar_log(40.0 / grit));
  double height = 0.12 * grain * scalar_exp(0.3 * scalar_log(grain / 0.125));
  double depth = number_at(s, P_MARK_DEPTH);
  if (depth >= 0.0) height = depth / (2.0 * NOISE_SD * 1.12);
  if (height <= 0.0) return;
  noise_of(&m->scratch[0], height, 90.0 * grain, 1.2 * grain);
  noise_of(&m->scratch[1], 0.5 * height, 260.0 * grain, 4.3 * grain);
  rank_octaves(m->scratch);
}

static void build_marks(wood_surface *m, const surface_finish *f, const settings *s) {
  double pitch = number_at(s, P_MARK_PITCH) > 0.0 ? number_at(s, P_MARK_PITCH) : f->pitch;
  double depth = f->depth;
  /* a planer's wave height goes with the pitch's square */
  if (f->marks == MARKS_KNIVES) depth *= pitch * pitch / (f->pitch * f->pitch);
  depth = usual(s, P_MARK_DEPTH, depth);
  double angle = number_at(s, P_MARK_ANGLE) * PI / 180.0;
  m->turn_c = (float)scalar_cos(angle);
  m->turn_s = (float)scalar_sin(angle);
  m->radius = (float)number_at(s, P_SAW_RADIUS);
  if (choice_at(s, P_SURFACE) == SURFACE_SANDED) build_scratches(m, s);
  double torn = usual(s, P_FIBRE_WEAR, f->torn);
  if (f->torn > 0.0 && torn > 0.0) {
    noise_of(&m->scratch[0], 0.65 * torn, 5.0, 0.28);
    noise_of(&m->scratch[1], 0.35 * torn, 2.0, 0.11);
    rank_octaves(m->scratch);
  }
  if (f->marks == MARKS_NONE || depth <= 0.0) return;
  m->marks = f->marks;
  m->pitch = (float)pitch;
  m->inverse_pitch = (float)(1.0 / pitch);
  m->depth = (float)depth;
  m->second = (float)f->second;
  /* mean squares of the slopes of marks.h, of depth 1 and pitch 1: a groove
   * q^2 with q = 4 f (1 - f) has 512 / 105, times the mean square of its own
   * depth; a cusp q has 16 / 3 */
  double own = NOISE_SD * NOISE_SD * 35.0 / 26.0; /* of numbers along one axis */
  double slope2 = 512.0 / 105.0 * (0.6 * 0.6 + 0.4 * 0.4 * own);
  if (f->marks == MARKS_KNIVES) slope2 = 16.0 / 3.0 + 512.0 / 105.0 * 0.35 * 0.35 * own;
  if (f->marks == MARKS_STROKES) slope2 = 2.8; /* measured: property.surface */
  m->slope2 = (float)(slope2 / (pitch * pitch));
  if (f->board > 0.0) {
    double scale = f->depth > 0.0 ? depth / f->depth : 1.0;
    noise_of(&m->washboard, f->board * scale, f->board_a, f->board_b);
  }
}

/* ---- wear -------------------------------------------------------------- */

/* Where a place lies in the table of rings. Those to be found mostly follow one another. */
typedef struct {
  int number;
  double start, end;
} ring_at;

static double late_profile(const wood_constants *w, double rho, ring_at *ring) {
  double total = (double)w->start[WOOD_RINGS];
  while (rho < 0.0) rho += total;
  while (rho >= total) rho -= total;
  if (rho < ring->start || rho >= ring->end) {
    int low = rho < ring->start ? 0 : ring->number;
    while (low + 1 < WOOD_RINGS && (double)w->start[low + 1] <= rho) low++;
    *ring = (ring_at){low, (double)w->start[low], (double)w->start[low + 1]};
  }
  double f = (rho - ring->start) * (double)w->inverse_width[ring->number];
  double after = f - (double)w->late_start, a = after * (double)w->inverse_late_before;
  if (after <= 0.0) return 0.0;
  double b = 1.0 - (f - (double)w->late_middle) * (double)w->inverse_late_after;
  a = a < 0.0 ? 0.0 : a > 1.0 ? 1.0 : a;
  b = b < 0.0 ? 0.0 : b > 1.0 ? 1.0 : b;
  double left =
      1.0 - (f - (double)w->late_middle - (double)w->late_after) * (double)w->inverse_late_full;
  left = left < 0.0 ? 0.0 : left > 1.0 ? 1.0 : left;
  double missing = (double)w->late_deepening * (left - b * b);
  double rise = f < (double)w->late_middle ? 0.5 * a * a : 1.0 - 0.5 * b * b - missing;
  return (double)w->late_weight[ring->number + 1] * rise;
}

/* What of the slopes is at edges, by the profile's moments: a share of the face with a slope that
 * is as uniform as a parabola's, 9/5 of the square of the mean square, has all of it. */
static void build_wear_edges(wood_surface *m, double square, double fourth) {
  double share = fourth > 0.0 ? 1.8 * square * square / fourth : 1.0;
  m->wear_share = (float)(share < 1.0 ? share : 1.0);
}

/* Mean square slope of the rounded profile of wear.h, under boxes from `soft`
 * on, over the whole table. */
static void build_wear_slopes(wood_constants *w) {
  wood_surface *m = &w->surface;
  double total = (double)w->start[WOOD_RINGS];
  for (int k = 0; k < SURFACE_WEAR_STEPS; k++) {
    double e = (double)m->soft * scalar_exp(0.5 * k * 0.69314718055994531), sum = 0.0, fourth = 0.0;
    double wanted = 10.0 * total / e;
    int steps = wanted < 2048.0 ? 2048 : wanted > 65536.0 ? 65536 : (int)wanted;
    ring_at ring[4] = {{0}};
    /* a box as long as all of them leaves nothing */
    for (int i = 0; e < 0.5 * total && i < steps; i++) {
      double rho = (i + 0.5) * total / steps;
      double within = late_profile(w, rho + 0.5 * e, &ring[0]) -
                      late_profile(w, rho - 0.5 * e, &ring[1]),
             about = late_profile(w, rho + e, &ring[2]) - late_profile(w, rho - e, &ring[3]);
      double rise = 0.5 * within + 0.25 * about;
      sum += rise * rise / steps;
      fourth += rise * rise * rise * rise / steps;
    }
    if (k == 0) build_wear_edges(m, sum, fourth);
    m->wear_slope2[k] = (float)(sum / (e * e));
  }
}

static void build_wear(wood_constants *w, const surface_finish *f, const settings *s) {
  wood_surface *m = &w->surface;
  m->soft = (float)(f->soft > 0.0 ? f->soft : 0.25);
  m->erosion = (float)usual(s, P_EROSION, f->erosion);
  if (m->erosion > 0.0f) build_wear_slopes(w);
  /* the two octaves' greatest heights add up to the parameter */
  double fibre = f->torn > 0.0 ? 0.0 : usual(s, P_FIBRE_WEAR, f->fibre),
         size = f->fibre_size > 0 ? f->fibre_size : 0.4;
  if (fibre > 0.0) {
    noise_of(&m->fibre[0], 0.68 * fibre, size, size);
    noise_of(&m->fibre[1], 0.32 * fibre, size / 2.7, size / 2.7);
    rank_octaves(m->fibre);
  }
  m->fibre_late = (float)f->latewood;
  if (f->fibre_stain > 0.0 && fibre > 0.0) {
    m->fibre_stain = (float)(f->fibre_stain / fibre);
    m->stains = 1;
  }
}

/* ---- grooves ----------------------------------------------------------- */

/* Troughs of radius r (mean square over its square: square), so many to a mm^2
 * of the section: grooves.h. */
static surface_grooves grooves_of(double depth, double r, double square, double density) {
  surface_grooves g;
  g.depth = (float)depth;
  g.slope2 = (float)(density * 2.0 * PI * 1.6 * 1.6 * depth * depth);
  g.mean = (float)(depth * density * PI * r * r * square);
  return g;
}

static double mean_square(const wood_vessels *v) {
  double sum = 0.0;
  for (int i = 0; i < WOOD_RADII; i++) sum += 1.0 / (double)v->inverse_square[i];
  return sum / WOOD_RADII;
}

static void build_vessels(wood_constants *w, const surface_finish *f, const settings *s) {
  wood_surface *m = &w->surface;
  double filled = choice_at(s, P_FINISH) == FINISH_LACQUERED ? 0.0 : f->vessels;
  double deep = 0.625 * usual(s, P_OPEN_VESSELS, filled);
  if (deep <= 0.0) return;
  if (w->has_pores) {
    double r = (double)w->pores.radius, square = mean_square(&w->pores);
    square *= (double)w->pore_ring_mean;
    m->pores = grooves_of(deep * r, r, square, number_at(s, P_PORE_DENSITY));
  }
  if (w->rows) {
    double r = (double)w->row.radius;
    double density = w->rows * number_at(s, P_ROW_DENSITY) / (double)w->ring_width;
    m->rows = grooves_of(deep * r, r, mean_square(&w->row), density);
  }
}

static void build_checks(wood_surface *m, const surface_finish *f, const settings *s) {
  double count = 0.01 * usual(s, P_CHECKS, f->checks), r = 0.5 * number_at(s, P_CHECK_WIDTH);
  if (count <= 0.0) return;
  /* of many sizes, most of them small */
  tubes_met(&m->checks, r, number_at(s, P_CHECK_LENGTH), 0.3, count);
  m->check_depth = (float)(f->check_depth > 0.0 ? f->check_depth : 0.5);
  m->check_dark = 0.45f;
  m->stains = 1;
}

static void build_splits(wood_surface *m, const surface_finish *f, const settings *s) {
  double count = 0.01 * usual(s, P_END_CHECKS, f->end_checks);
  double length = number_at(s, P_END_CHECK_LENGTH), half = 0.5 * number_at(s, P_END_CHECK_WIDTH);
  if (count <= 0.0) return;
  /* a ring meets a check in 0.65 of the cells that have one */
  double cell = (double)SPLIT_LAYERS * (double)SPLIT_CHANCE * 0.65 / count;
  if (half > 0.1 * cell) half = 0.1 * cell;
  m->split_half = (float)half;
  m->split_depth = (float)(2.0 * half);
  m->inverse_split_length = (float)(1.0 / length);
  m->split_cells = (float)(2.0 * PI * length / cell);
  m->split_mean = (float)((double)SPLIT_MEAN * half);
  m->split_steep2 = (float)((double)SPLIT_STEEP2 / ((double)SPLIT_SHOULDER * half * half));
  m->stains = 1;
}

#define PLATE_TILT 0.11 /* slope of a plate of wood that is all char */

static void build_cracks(wood_constants *w, const surface_finish *f, const settings *s) {
  wood_surface *m = &w->surface;
  /* char cracks once it is thick */
  double how = (number_at(s, P_CHARRING) - 0.5) * 2.0, cell = number_at(s, P_CHAR_CELL);
  if (f->crack_depth <= 0.0 || how <= 0.0) return;
  double width = 0.22 * cell, depth = f->crack_depth * how * cell / 7.0;
  double across = 1.0 / cell, along = 1.0 / (1.5 * cell);
  m->crack_frequency[0] = (float)across;
  m->crack_frequency[1] = (float)along;
  m->crack_depth = (float)depth;
  m->crack_width = (float)width;
  /* what is not yet black shows less of them */
  m->crack_stain = (float)(0.8 * how * how);
  /* Cracks across are met `along` times a mm of the fibre, hairlines 2.6 times
   * as often; columns have 2 `across` of edge to a mm^2 of section. A crack is
   * narrower by a factor that is uniform from 1 to 2, 2 to 3.5 and 1.2 to 2.2:
   * its area goes with the mean of the inverse, its slope's square with the
   * mean. Then the integrals of cracks.h's profile, less what overlaps. */
  double hairs = 2.6 * 0.59 * 0.72; /* there are, and not too near a crack */
  double lines = along * (0.693 + hairs * 0.373) + 2.0 * across * 0.606;
  double steep = along * (1.5 + hairs * 2.75) + 2.0 * across * 1.7 * 0.5;
  m->crack_mean = (float)(0.8 * lines * 2.0 * width * (0.45 / 3.0 + 0.55 / 12.0));
  m->crack_dark = (float)(0.8 * lines * 2.0 * width / 8.0);
  /* a plate's slopes are uniform, and end at its rims */
  double tilt = PLATE_TILT * how;
  m->plate_tilt = (float)(tilt / depth);
  double plates = tilt * tilt * 2.0 / 3.0 * 0.7;
  m->crack_gentle2 = (float)(1.5 * plates); /* and the outer part of their shoulders */
  double share = 0.8 * lines * 2.0 * width * 0.55;
  m->crack_slope2 = (float)(0.85 * depth * depth * steep * 2.0 / width * 2.791 / share);
  m->crack_share = (float)share;
  m->stains = 1;
}

int32_t surface_build(wood_constants *w, const settings *s) {
  const surface_finish *f = &surface_finishes[choice_at(s, P_SURFACE)];
  wood_surface *m = &w->surface;
  double pitch = number_at(s, P_MARK_PITCH);
  if (pitch > 0.0 && pitch < 0.05) {
    return fail(
        SOZAI_ERROR_RANGE,
        "mark_pitch: %.9g mm is finer than any tool's; 0 for what is usual, or 0.05 to 200 mm",
        pitch);
  }
  build_marks(m, f, s);
  build_wear(w, f, s);
  build_vessels(w, f, s);
  build_checks(m, f, s);
  build_splits(m, f, s);
  if (choice_at(s, P_SURFACE) == SURFACE_CHARRED) build_cracks(w, f, s);
  m->relief = m->marks || m->scratch[0].height > 0.0f || m->erosion > 0.0f ||
              m->fibre[0].height > 0.0f || m->pores.depth > 0.0f || m->rows.depth > 0.0f ||
              m->check_depth > 0.0f || m->split_depth > 0.0f || m->crack_depth > 0.0f;
  return SOZAI_OK;
}
