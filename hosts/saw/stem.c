/* SPDX-License-Identifier: Apache-2.0 */
#include "stem.h"

#include <math.h>
#include <stdlib.h>

/* Columns of the tables, by their ids once. */
enum { RING_YEAR, RING_HEIGHT, RING_RADIUS, RING_COLUMNS };

static const float *row_of(const sozai_table *t, uint64_t row) {
  return t->data + row * t->info->column_count;
}

bool saw_stem_read(saw_stem *s, const sozai_geometry_1 *table, const sozai_geometry *g,
                   failure *why) {
  *s = (saw_stem){0};
  if (!growth_rows(table, g, "rings", &s->rings, why) ||
      !growth_rows(table, g, "knots", &s->knots, why) ||
      !growth_rows(table, g, "knot_radii", &s->radii, why))
    return false;
  if (s->rings.rows < 2 || s->rings.info->column_count != RING_COLUMNS)
    return fail(why, EXIT_FAILURE, "the tree has no rings to be sawn");
  while (s->heights < s->rings.rows &&
         row_of(&s->rings, s->heights)[RING_YEAR] == row_of(&s->rings, 0)[RING_YEAR])
    s->heights++;
  s->age = (double)row_of(&s->rings, s->rings.rows - 1)[RING_YEAR];
  return true;
}

/* Of the year whose rows begin at `first`. */
static double year_radius(const saw_stem *s, uint64_t first, double height) {
  uint64_t low = first, high = first + s->heights - 1;
  const float *a = row_of(&s->rings, low), *b = row_of(&s->rings, high);
  if (height <= (double)a[RING_HEIGHT]) return (double)a[RING_RADIUS];
  if (height >= (double)b[RING_HEIGHT]) return (double)b[RING_RADIUS];
  while (high - low > 1) {
    uint64_t middle = (low + high) / 2;
    *((double)row_of(&s->rings, middle)[RING_HEIGHT] <= height ? &low : &high) = middle;
  }
  a = row_of(&s->rings, low);
  b = row_of(&s->rings, high);
  double t = (height - (double)a[RING_HEIGHT]) / ((double)b[RING_HEIGHT] - (double)a[RING_HEIGHT]);
  return (double)a[RING_RADIUS] + t * ((double)b[RING_RADIUS] - (double)a[RING_RADIUS]);
}

double saw_stem_radius(const saw_stem *s, double height, double year) {
  uint64_t low = 0, high = s->rings.rows / s->heights; /* low: the first year not before */
  uint64_t years = high;
  while (low < high) {
    uint64_t middle = (low + high) / 2;
    if ((double)row_of(&s->rings, middle * s->heights)[RING_YEAR] < year)
      low = middle + 1;
    else
      high = middle;
  }
  if (low == years) return year_radius(s, (years - 1) * s->heights, height);
  double year_b = (double)row_of(&s->rings, low * s->heights)[RING_YEAR];
  double radius_b = year_radius(s, low * s->heights, height), year_a = 0, radius_a = 0;
  if (low > 0) {
    year_a = (double)row_of(&s->rings, (low - 1) * s->heights)[RING_YEAR];
    radius_a = year_radius(s, (low - 1) * s->heights, height);
  }
  double t = year_b > year_a ? (year - year_a) / (year_b - year_a) : 1;
  return radius_a + fmax(t, 0) * (radius_b - radius_a);
}

double saw_stem_height(const saw_stem *s) {
  return (double)row_of(&s->rings, s->rings.rows - 1)[RING_HEIGHT];
}

double saw_log_volume(const saw_log *log) {
  const int slices = 64;
  double sum = 0;
  for (int i = 0; i < slices; i++) {
    double r =
        saw_stem_radius(log->stem, log->base + log->length * (i + 0.5) / slices, log->stem->age);
    sum += SAW_PI * r * r;
  }
  return sum * log->length / slices;
}

/* ---- knots -------------------------------------------------------------- */

typedef struct knot {
  double birth, end, azimuth, rise, cosine, height, radius;
  uint64_t first, count; /* rows of radii */
} knot;

static knot knot_at(const saw_stem *s, uint64_t i) {
  double inclination = growth_number(&s->knots, i, "inclination");
  double shed = growth_number(&s->knots, i, "shed"); /* a dead one stands in the wood till then */
  return (knot){.birth = growth_number(&s->knots, i, "birth"),
                .end = shed < 0 ? s->age : fmin(shed, s->age),
                .azimuth = growth_number(&s->knots, i, "azimuth"),
                .rise = tan(inclination),
                .cosine = cos(inclination),
                .height = growth_number(&s->knots, i, "height"),
                .radius = growth_number(&s->knots, i, "radius"),
                .first = (uint64_t)growth_number(&s->knots, i, "first"),
                .count = (uint64_t)growth_number(&s->knots, i, "count")};
}

static double knot_radius(const saw_stem *s, const knot *k, double year) {
  double before_year = k->birth, before = 0;
  for (uint64_t i = 0; i < k->count; i++) {
    const float *row = row_of(&s->radii, k->first + i);
    double at = (double)row[1], radius = (double)row[2];
    if (year <= at)
      return at > before_year
                 ? before + (radius - before) * fmax(0, year - before_year) / (at - before_year)
                 : radius;
    before_year = at;
    before = radius;
  }
  return k->radius;
}

/* A face: a plane with its middle, and half its sides. */
typedef struct face_plane {
  double centre[3], along[3], out[3], half_width, half_length;
} face_plane;

static face_plane plane_of(const saw_log *log, const saw_board *b) {
  double along[2], out[2], t = 0.5 * b->thickness;
  saw_board_axes(b, along, out);
  return (face_plane){
      .centre = {b->centre[0] + t * out[0], 0.5 * log->length, b->centre[1] + t * out[1]},
      .along = {along[0], 0, along[1]},
      .out = {out[0], 0, out[1]},
      .half_width = 0.5 * b->width,
      .half_length = 0.5 * log->length};
}

/* The log's pith at a height above its lower end. */
static void pith_at(const saw_log *log, double y, double out[2]) {
  double at = fmin(fmax(y / log->length, 0), 1) * (SAW_PITH - 1);
  int i = (int)fmin(at, SAW_PITH - 2);
  for (int c = 0; c < 2; c++) {
    double low = (double)log->pith[c][i], high = (double)log->pith[c][i + 1];
    out[c] = low + (high - low) * (at - i);
  }
}

/* Whoever wants to know where a knot may be. */
typedef struct listener {
  saw_knot_seen seen;
  void *context;
  uint32_t number; /* the knot's */
} listener;

/* Tell of places on what the face has of the chord that a knot's disc, `u` from the
 * pith and square to its axis, cuts from it: its middle and its quarters, for where a
 * knot ends it is rounder than a disc. */
enum { ON_CHORD = 3 };
static void tell_of_disc(const saw_log *log, const face_plane *f, const knot *k, double u,
                         double radius, const listener *to) {
  double c = cos(k->azimuth), s = sin(k->azimuth), off = 0, lean = 0, square = 0;
  const double axis[3] = {k->cosine * c, k->cosine * k->rise, k->cosine * s};
  double y = k->height - log->base + u * k->rise, pith[2];
  pith_at(log, y, pith);
  const double from[3] = {pith[0] + u * c - f->centre[0], y - f->centre[1],
                          pith[1] + u * s - f->centre[2]};
  for (int i = 0; i < 3; i++) {
    off += from[i] * f->out[i];
    lean += axis[i] * f->out[i];
  }
  double across = 1 - lean * lean; /* square of the face's normal within the disc */
  if (across < 1e-6) across = 1e-6;
  square = radius * radius - off * off / across;
  if (square < 0) return;
  /* along the chord, in the face: across it and up the stem */
  const double way[3] = {axis[1] * f->out[2] - axis[2] * f->out[1],
                         axis[2] * f->out[0] - axis[0] * f->out[2],
                         axis[0] * f->out[1] - axis[1] * f->out[0]};
  double at[2] = {0, 0}, step[2] = {0, 0}, low = -sqrt(square), high = sqrt(square);
  for (int i = 0; i < 3; i++) {
    double foot = from[i] - off / across * (f->out[i] - lean * axis[i]);
    at[0] += foot * f->along[i];
    step[0] += way[i] * f->along[i] / sqrt(across);
    if (i != 1) continue;
    at[1] = foot;
    step[1] = way[1] / sqrt(across);
  }
  const double half[2] = {f->half_width, f->half_length};
  for (int i = 0; i < 2; i++) {
    if (fabs(step[i]) < 1e-9) {
      if (fabs(at[i]) > half[i]) return;
      continue;
    }
    double a = (-half[i] - at[i]) / step[i], b = (half[i] - at[i]) / step[i];
    low = fmax(low, fmin(a, b));
    high = fmin(high, fmax(a, b));
  }
  if (low > high) return;
  for (int n = 1; n <= ON_CHORD; n++) {
    double t = low + (high - low) * n / (ON_CHORD + 1), point[3];
    for (int i = 0; i < 3; i++)
      point[i] =
          f->centre[i] + (at[0] + t * step[0]) * f->along[i] + (i == 1 ? at[1] + t * step[1] : 0);
    to->seen(to->context, to->number, point);
  }
}

#define STEP 0.1    /* years: stems grow by less than a millimetre in it */
#define BEYOND 15.0 /* mm: wood's rings may carry a knot so much farther than the tree's */

static void on_board(const saw_log *log, const saw_board *b, const knot *k, uint32_t number,
                     saw_knot_seen seen, void *context) {
  face_plane f = plane_of(log, b);
  const listener to = {seen, context, number};
  double bark = saw_stem_radius(log->stem, k->height, log->stem->age);
  double last = saw_stem_radius(log->stem, k->height, k->end);
  for (double year = k->birth; year <= k->end; year += STEP) {
    double u = saw_stem_radius(log->stem, k->height, year);
    double radius = log->knot_size * knot_radius(log->stem, k, year);
    tell_of_disc(log, &f, k, u, radius, &to);
  }
  for (double u = last; u <= fmin(last + BEYOND, bark); u += 0.5)
    tell_of_disc(log, &f, k, u, log->knot_size * k->radius, &to);
}

/* The first year in which the stem is thicker than that, where the knot is. */
static double year_of(const saw_log *log, const knot *k, double radius) {
  double low = k->birth, high = k->end;
  while (high - low > 0.01) {
    double middle = 0.5 * (low + high);
    *(saw_stem_radius(log->stem, k->height, middle) < radius ? &low : &high) = middle;
  }
  return low;
}

/* The knife comes by a knot once a turn, and half its width earlier and later. */
static void on_sheet(const saw_log *log, const saw_board *b, const knot *k, uint32_t number,
                     saw_knot_seen seen, void *context) {
  double t = b->thickness, middle = hypot(b->centre[0], b->centre[1]);
  double at = 0.25 + b->rotation / 360 - k->azimuth / (2 * SAW_PI); /* turns from its middle */
  double begin = (middle - b->from) / t, end = (middle - b->to) / t;
  double last = saw_stem_radius(log->stem, k->height, k->end) + BEYOND;
  for (double turn = ceil(begin - at - 1); turn <= end - at + 1; turn++) {
    double u = middle - (turn + at) * t;
    if (u <= 0 || u > last) continue;
    double radius = log->knot_size * knot_radius(log->stem, k, year_of(log, k, u));
    double nearest = fmin(fmax(turn + at, begin), end), away = nearest - turn - at;
    double y = fmin(fmax(k->height - log->base + u * k->rise, 0), log->length);
    double high = y - (k->height - log->base + u * k->rise), wide = away * 2 * SAW_PI * u;
    if (hypot(high, wide) > radius) continue;
    double a = k->azimuth - away * 2 * SAW_PI, r = middle - nearest * t;
    const double point[3] = {r * cos(a), y, r * sin(a)};
    seen(context, number, point);
  }
}

void saw_knot_places(const saw_log *log, const saw_board *b, saw_knot_seen seen, void *context) {
  for (uint64_t i = 0; i < log->stem->knots.rows; i++) {
    knot k = knot_at(log->stem, i);
    double far = 2000 + fabs(k.rise) * 500;
    if (k.height < log->base - far || k.height > log->base + log->length + far) continue;
    (b->plan == SAW_ROTARY ? on_sheet : on_board)(log, b, &k, (uint32_t)i, seen, context);
  }
}
