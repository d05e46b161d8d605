/* SPDX-License-Identifier: Apache-2.0
 *
 * From a tree's tables to the knots that the kernel reads.
 */
#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/meter.h"
#include "../core/status.h"
#include "build.h"
#include "knot_grid.h"
#include "parameters.h"

#define NARROWEST 0.2 /* mm: of a knot's radius */
#define WIDEST                                                                                     \
  0.44 /* of a branch's growth over the stem's: none reaches to the pith's other side */
#define SLOWEST 0.8      /* q */
#define HIGH 0.4         /* of the collar at a knot's side, over its radius */
#define HIGH_RISING 0.6  /* and what is more above and below */
#define LINGERS 5.0      /* radii: how long a dead one may stay beyond the tree's own years */
#define PITH 0.15        /* how far a knot's pith is from its middle, over its radius */
#define WITHOUT_AGE 60.0 /* years, where a table of knots alone tells none */

/* ---- one knot ---------------------------------------------------------- */

/* rho of the stem about a knot, by the year. */
typedef struct {
  const wood_constants *w;
  const knot_source *from;
  double height, birth, scale; /* scale: what taper makes of a radius at that height */
} knot_clock;

static double ring_start(const wood_constants *w, double years) {
  if (years <= 0.0) return 0.0;
  double turns = (double)(int64_t)(years / WOOD_RINGS), left = years - turns * WOOD_RINGS;
  int j = (int)left;
  return turns * (double)w->ring_period + (double)w->start[j] +
         (left - j) / (double)w->inverse_width[j];
}

static double rho_in(const knot_clock *c, double year) {
  if (!c->from->rings.count) return ring_start(c->w, year - c->birth);
  return c->scale * knot_source_radius(c->from, c->height, year);
}

/* q by least squares: share of the stem's growth tau = e + q (e^2 - e). */
static double slowing(const knot_clock *c, const float *row, double born, double length,
                      double radius) {
  double over = 0.0, under = 0.0, last = (double)row[KNOT_RADIUS];
  const float *radii = c->from->radii.rows;
  for (uint64_t i = 0; radii && i < (uint64_t)row[KNOT_COUNT]; i++) {
    const float *at = radii + ((uint64_t)row[KNOT_FIRST] + i) * RADIUS_COLUMNS;
    double e = (double)at[RADIUS_RADIUS] / last;
    double tau = (rho_in(c, (double)at[RADIUS_YEAR]) - born) / length, curve = e * e - e;
    over += (tau - e) * curve;
    under += curve * curve;
  }
  double q = under > 0.0 ? over / under
             : radii     ? 0.0
                         : 0.5,
         most = 1.0 - radius / (WIDEST * length);
  if (most > SLOWEST) most = SLOWEST;
  return q < 0.0 ? 0.0 : q > most ? most : q;
}

static double even(uint32_t seed, uint32_t k) {
  return hash1(seed + k * 0x9e3779b9u) / 4294967296.0;
}

/* How far from its axis a knot has any effect: the collar's, where its section is
 * widest, and the fibres'; and more closely, as a^2 + h^2 / 4. */
static void set_bounds(wood_knot *k) {
  enum { DIRECTIONS = 64 };
  double radius = (double)k->radius, window = (double)KNOT_WINDOW, near = window;
  double far = 1.15 * (double)KNOT_STREAM * __builtin_sqrt(window);
  for (int i = 0; i < DIRECTIONS; i++) {
    double turn = 2.0 * PI * i / DIRECTIONS, a = scalar_cos(turn), h = scalar_sin(turn);
    double p2 = a * a + (double)k->squash * h * h + 2.0 * (double)k->lean * a * h;
    double d = __builtin_sqrt(p2) + (double)k->pith_a * a + (double)k->pith_h * h;
    double collar = 1.01 * (1.0 + (double)KNOT_WIDE + (double)KNOT_WIDE_RISING * h * h) / d;
    double squared = collar * collar * (a * a + 0.25 * h * h);
    if (collar > far) far = collar;
    if (squared > near) near = squared;
  }
  k->bends = (float)(far * radius);
  k->near = (float)(near * radius * radius);
}

/* As high as is asked for, and no higher than rings of the stem, and the branch's
 * own, keep in turn: the branch's growth over the stem's is fastest at the pith. */
static void raise_collar(wood_knot *k, double collar) {
  double fastest = (double)k->radius / ((double)k->length * (1.0 - (double)k->q));
  double side = HIGH * collar, rising = HIGH_RISING * collar;
  double most = 0.85 / (fastest * (1.0 + 3.0 / (double)KNOT_WIDE));
  double most_above = 0.85 / (fastest * (1.0 + 3.0 / (double)(KNOT_WIDE + KNOT_WIDE_RISING)));
  if (side > most) side = most;
  if (side + rising > most_above) rising = most_above - side;
  k->high = (float)side;
  k->high_rising = (float)(rising > 0.0 ? rising : 0.0);
}

/* 0: there is nothing of it in the wood. */
static int make_knot(wood_knot *k, const wood_constants *w, const knot_source *from,
                     const settings *s, const float *row, uint32_t seed) {
  double low = number_at(s, P_LOG_HEIGHT), height = (double)row[KNOT_HEIGHT];
  double lean = 1.0 + (double)w->taper * (height - low);
  double size = number_at(s, P_KNOT_SIZE), age = from->age > 0.0 ? from->age : WITHOUT_AGE;
  knot_clock c = {w, from, height, (double)row[KNOT_BIRTH], lean < 0.1 ? 0.1 : lean};
  int lives = row[KNOT_DEATH] < 0.0f, stays = lives || row[KNOT_SHED] < 0.0f;
  double born = rho_in(&c, c.birth), now = rho_in(&c, age);
  double end = lives ? now : rho_in(&c, (double)row[KNOT_DEATH]);
  double radius = size * (double)row[KNOT_RADIUS], length = end - born;
  if (radius > WIDEST * length) radius = WIDEST * length;
  if (radius < NARROWEST || length < 1.0) return 0;
  memset(k, 0, sizeof *k);
  double azimuth = (double)row[KNOT_AZIMUTH], rise = (double)row[KNOT_INCLINATION];
  k->c = (float)scalar_cos(azimuth);
  k->s = (float)scalar_sin(azimuth);
  k->cosine = (float)scalar_cos(rise);
  k->slope = (float)(scalar_sin(rise) / scalar_cos(rise));
  k->height = (float)(height - low);
  /* oblong by up to a seventh, in a direction of its own */
  double oblong = 0.14 * even(seed, 1), turn = 2.0 * PI * even(seed, 2);
  k->squash = (float)(1.0 + oblong * scalar_cos(turn));
  k->lean = (float)(0.5 * oblong * scalar_sin(turn));
  k->upright = (float)__builtin_sqrt((double)k->squash - (double)k->lean * (double)k->lean);
  /* compression wood below a conifer's branch, tension wood above a broadleaf's; the
   * wind's a little to the side */
  double up = PITH * (0.6 + 0.6 * even(seed, 5)), side = 0.4 * PITH * (even(seed, 6) - 0.5);
  if (choice_at(s, P_POROSITY) != POROSITY_NONE) up = -0.7 * up;
  k->pith_a = (float)side;
  k->pith_h = (float)up;
  k->pith_x = (float)side;
  k->pith_y = (float)((up - (double)k->lean * side) / (double)k->upright);
  double px = (double)k->pith_x, py = (double)k->pith_y, inner = 1.0 - px * px - py * py;
  k->middle_x = (float)(-px / inner);
  k->middle_y = (float)(-py / inner);
  k->round = (float)(1.0 / __builtin_sqrt(inner * __builtin_sqrt(inner)));
  k->born = (float)born;
  k->length = (float)length;
  k->inverse_length = (float)(1.0 / length);
  k->radius = (float)radius;
  k->inverse_radius = (float)(1.0 / radius);
  k->q = (float)slowing(&c, row, born, length, radius);
  k->death = (float)end;
  /* a board may be wider than the stem has grown: there branches have died since, and the wood
   * closed over them */
  double later = now + LINGERS * radius * even(seed, 8);
  k->end = (float)(stays ? later : rho_in(&c, (double)row[KNOT_SHED]));
  /* no part of the stub's end lies within what it was when it died */
  double stub = end + 1.1 * (double)(KNOT_ROUND + KNOT_SLANT) * radius;
  if ((double)k->end < stub) k->end = (float)stub;
  /* a scar closes within three radii */
  k->reach = (float)((double)k->end + 12.0 * radius);
  set_bounds(k);
  double sees = radius + number_at(s, P_KNOT_BARK), resin = (1.0 + (double)KNOT_HALO) * radius;
  double off = __builtin_sqrt(px * px + py * py);
  k->sees = (float)(1.02 * (sees > resin ? sees : resin) / (1.0 - off) + 0.2);
  raise_collar(k, number_at(s, P_KNOT_COLLAR));
  k->check_c = (float)scalar_cos(2.0 * PI * even(seed, 4));
  k->check_s = (float)scalar_sin(2.0 * PI * even(seed, 4));
  double turned = 2.0 * PI * (even(seed, 4) + 0.17 + 0.16 * even(seed, 7));
  k->split_c = (float)scalar_cos(turned);
  k->split_s = (float)scalar_sin(turned);
  k->tone = (float)(KNOT_TONE * (2.0 * even(seed, 9) - 1.0));
  k->apart = (float)(300.0 + 3000.0 * even(seed, 3));
  return 1;
}

int32_t wood_build_knots(wood_constants *w, const sozai_host *host, const settings *s,
                         const knot_source *from, const float (*colours)[3]) {
  double stain = number_at(s, P_KNOT_STAIN);
  w->knot_stain = (float)stain;
  for (int c = 0; c < 3; c++) {
    w->knot_early[c] = colours[P_KNOT_COLOUR][c];
    w->knot_late[c] = 0.6f * colours[P_KNOT_COLOUR][c];
    w->knot_bark[c] = colours[P_KNOT_BARK_COLOUR][c];
  }
  if (!from->knots.count) return SOZAI_OK;
  size_t bytes = (size_t)from->knots.count * sizeof(wood_knot);
  wood_knot *list = host_alloc(host, bytes, 64);
  if (!list) return SOZAI_ERROR_MEMORY;
  wood_knots plan = {.grain = (float)(0.85 * number_at(s, P_KNOT_GRAIN)),
                     .bark = (float)number_at(s, P_KNOT_BARK),
                     .check = (float)(0.08 * number_at(s, P_KNOT_CHECKS))};
  for (uint64_t i = 0; i < from->knots.count; i++) {
    const float *row = from->knots.rows + i * KNOT_COLUMNS;
    uint32_t seed = hash1(w->seeds[SEED_KNOTS] + 0x9e3779b9u * (uint32_t)i);
    plan.count += (uint32_t)make_knot(&list[plan.count], w, from, s, row, seed);
  }
  int32_t r = SOZAI_OK;
  if (plan.count) {
    r = knot_grid_make(&w->knots, &plan, host, list, from->height);
  }
  host_free(host, list, bytes, 64);
  return r;
}

void wood_release_knots(wood_constants *w, const sozai_host *host) {
  if (w->knots) host_free(host, w->knots, w->knots->bytes, 64);
  w->knots = NULL;
}
