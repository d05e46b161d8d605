/* SPDX-License-Identifier: Apache-2.0
 *
 * docs/match.md says why moments do not tell a share, and ranks do. */
#include "shares.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "linear.h"

#define FACES 9              /* a third is left of a share's own deviation from face to face */
#define SEARCH_POINTS 7000.0 /* of each */
#define LEAST 0.002          /* less is none */
#define SCAN 1.8             /* from one value tried to the next */
#define FIRST_STEP 1.25      /* when narrowing, down to the last */
#define LAST_STEP 1.01
#define WELL 0.01 /* a distance that another face of the same stone has */
#define MOST_KNOBS (MOST_SHARES + 1)
#define MOST_KNOWN 900
#define AXIS_SEEN 0.05 /* of the first axis' deviation: along others there is noise alone */

/* What is turned: the shares, then the brightness. */
typedef struct knob {
  const char *id;
  double preset, most;
  bool given;
} knob;

typedef struct setting {
  double of[MOST_KNOBS];
  double distance;
} setting;

typedef struct search {
  const share_search *q;
  const recipe *recipe;
  weighing weighing;
  match_material material; /* without the brightness, which a setting has */
  board thin;
  knob knobs[MOST_KNOBS];
  size_t shares, count;
  size_t axes; /* of the photograph's colours, the principal axes along which they differ */
  double axis[3][3], spread; /* and the deviation along the first */
  float *ranked[3];          /* the photograph along each, rising */
  uint64_t pixels;
  setting known[MOST_KNOWN];
  size_t known_count;
  failure *why;
  bool failed;
} search;

static int rising(const void *a, const void *b) {
  float x = *(const float *)a, y = *(const float *)b;
  return (x > y) - (x < y);
}

/* ---- the photograph ------------------------------------------------------------ */

static bool rank_photo_along(search *s, size_t axis) {
  const photo *p = s->q->photo;
  size_t pixels = (size_t)p->width * p->height;
  float *ranked = s->ranked[axis] = malloc(pixels * sizeof *ranked);
  if (!ranked) return fail(s->why, EXIT_FAILURE, "out of memory");
  s->pixels = 0;
  for (size_t i = 0; i < pixels; i++) {
    if (p->pixel[i] != s->q->pixel) continue;
    double v = 0;
    for (size_t k = 0; k < 3; k++) v += s->axis[axis][k] * (double)p->rgb[3 * i + k];
    ranked[s->pixels++] = (float)v;
  }
  qsort(ranked, s->pixels, sizeof *ranked, rising);
  return true;
}

static bool rank_photo(search *s) {
  double values[3], vectors[9];
  symmetric_eigen(s->q->problem->target->covariance, values, vectors);
  s->spread = sqrt(fmax(values[0], 1e-12));
  for (size_t a = 0; a < 3; a++) {
    if (a && sqrt(fmax(values[a], 0)) < AXIS_SEEN * s->spread) break;
    for (size_t k = 0; k < 3; k++) s->axis[a][k] = vectors[3 * k + a];
    s->axes = a + 1;
    if (!rank_photo_along(s, a)) return false;
  }
  return true;
}

/* ---- the material at a setting ------------------------------------------------------ */

static bool weigh_setting(const search *s, const setting *x, weights *w) {
  recipe copy;
  if (!weights_copy_recipe(&copy, s->recipe, s->why)) return false;
  bool ok = true;
  for (size_t i = 0; ok && i < s->count; i++) {
    char text[32];
    snprintf(text, sizeof text, "%.6f", x->of[i]);
    ok = recipe_set(&copy, s->knobs[i].id, text, 0, s->why);
  }
  ok = ok && weights_take(w, &s->weighing, &copy, s->why);
  recipe_free(&copy);
  return ok;
}

static void fit_setting(const search *s, const weights *w, fit *f) {
  moments m;
  fit_problem problem = *s->q->problem;
  moments_take(&m, w->of, w->stride, w->points, NULL, 0);
  problem.weights = &m;
  problem.has_brightness = false;
  for (size_t i = 0; i < problem.roles; i++)
    problem.fixed[i] = problem.fixed[i] || m.mean[i] < LEAST_WEIGHT;
  fit_palette(&problem, f);
}

static void rank_setting(const search *s, const weights *w, const fit *f, size_t axis,
                         float *ranked) {
  double along[MOST_DIMENSIONS] = {0};
  for (size_t i = 0; i < w->stride; i++)
    for (size_t k = 0; k < 3; k++) along[i] += s->axis[axis][k] * f->colour[i][k];
  for (uint64_t p = 0; p < w->points; p++) {
    double v = 0;
    for (size_t i = 0; i < w->stride; i++) v += along[i] * (double)w->of[p * w->stride + i];
    ranked[p] = (float)v;
  }
  qsort(ranked, w->points, sizeof *ranked, rising);
}

/* The mean distance from rank to rank, along all axes, with the palette that is the best for
 * that setting. */
static bool measure(search *s, setting *x) {
  weights w;
  fit f;
  double sum = 0;
  if (!weigh_setting(s, x, &w)) return false;
  fit_setting(s, &w, &f);
  float *ranked = malloc(w.points * sizeof *ranked);
  for (size_t a = 0; ranked && a < s->axes; a++) {
    rank_setting(s, &w, &f, a, ranked);
    for (uint64_t i = 0; i < w.points; i++) {
      double rank = ((double)i + 0.5) / (double)w.points;
      uint64_t place = (uint64_t)(rank * (double)s->pixels);
      sum += fabs((double)ranked[i] - (double)s->ranked[a][place]);
    }
  }
  x->distance = sum / ((double)w.points * s->spread);
  weights_free(&w);
  if (!ranked) return fail(s->why, EXIT_FAILURE, "out of memory");
  free(ranked);
  return true;
}

static double distance_of(search *s, setting *x) {
  const size_t bytes = s->count * sizeof x->of[0];
  for (size_t i = 0; i < s->known_count; i++)
    if (memcmp(s->known[i].of, x->of, bytes) == 0) return x->distance = s->known[i].distance;
  if (s->failed || !measure(s, x)) {
    s->failed = true;
    return x->distance = INFINITY;
  }
  if (s->known_count < MOST_KNOWN) s->known[s->known_count++] = *x;
  return x->distance;
}

/* ---- the search --------------------------------------------------------------------- */

#define ALL (~0u) /* knobs, as bits */

static bool turns(const search *s, unsigned which, size_t i) {
  return (which >> i & 1u) && !s->knobs[i].given;
}

static bool try_at(search *s, setting *best, size_t i, double value) {
  setting at = *best;
  at.of[i] = value;
  if (value > s->knobs[i].most || !(distance_of(s, &at) < best->distance)) return false;
  *best = at;
  return true;
}

/* All over the range of each, since the distance has more than one trough; then
 * from the best of all again. A share taken by itself would make up for the
 * others. */
static void scan(search *s, setting *x, unsigned which) {
  for (size_t round = 0; round < s->shares; round++) {
    setting best = *x;
    size_t moved = s->count;
    for (size_t i = 0; i < s->shares; i++) {
      setting own = *x;
      if (!turns(s, which, i)) continue;
      for (double v = 0; v <= s->knobs[i].most; v = fmax(SCAN * v, LEAST)) try_at(s, &own, i, v);
      if (!(own.distance < best.distance)) continue;
      best = own;
      moved = i;
    }
    if (moved == s->count) return;
    which &= ~(1u << moved);
    *x = best;
  }
}

/* By turns up and down, in ever smaller steps. */
static void narrow(search *s, setting *x, unsigned which) {
  for (double step = FIRST_STEP; step > LAST_STEP; step = sqrt(step))
    for (double before = INFINITY; x->distance < 0.98 * before;) {
      before = x->distance;
      for (size_t i = 0; i < s->count; i++) {
        double from = x->of[i];
        if (!turns(s, which, i) || try_at(s, x, i, fmax(from * step, LEAST))) continue;
        try_at(s, x, i, from > LEAST ? from / step : 0);
      }
    }
}

/* Two at once, from none to more than there is likely to be: with one of them wrong another has a
 * trough of its own. */
static void try_pairs(search *s, setting *x, unsigned which) {
  static const double values[] = {0, 0.1, 0.25, 0.4, 0.55};
  const size_t count = sizeof values / sizeof *values;
  setting best = {{0}, INFINITY};
  for (size_t i = 0; i < s->shares; i++)
    for (size_t j = i + 1; j < s->shares; j++)
      for (size_t k = 0; k < count * count && turns(s, which, i) && turns(s, which, j); k++) {
        setting at = *x;
        at.of[i] = fmin(values[k / count], s->knobs[i].most);
        at.of[j] = fmin(values[k % count], s->knobs[j].most);
        if (distance_of(s, &at) < best.distance) best = at;
      }
  if (best.distance == INFINITY) return;
  narrow(s, &best, which);
  if (best.distance < x->distance) *x = best;
}

/* What the preset has before what it has not: a kind of speck more would make
 * up for another's share. But where such specks are there, nothing without them
 * comes near, and all at once is tried as well. */
static void find_all(search *s, setting *x, unsigned has) {
  setting at_once = *x;
  scan(s, x, has);
  narrow(s, x, has);
  if (x->distance < WELL) return;
  try_pairs(s, x, has);
  if (x->distance < WELL) return;
  scan(s, x, ~has);
  narrow(s, x, ALL);
  if (x->distance < WELL) return;
  scan(s, &at_once, ALL);
  narrow(s, &at_once, ALL);
  if (at_once.distance < x->distance) *x = at_once;
}

/* First without the spare share, which would as soon stand for one of the others. */
static void find(search *s, setting *x) {
  const char *spare = s->q->weighing->material->spare_share;
  unsigned has = 1u << s->shares, without = 0;
  setting fewer = *x;
  for (size_t i = 0; i < s->shares; i++) {
    has |= (unsigned)(s->knobs[i].preset > 0) << i;
    if (!spare || strcmp(s->knobs[i].id, spare) != 0 || s->knobs[i].given) continue;
    without = 1u << i;
    fewer.of[i] = 0;
  }
  if (without) {
    distance_of(s, &fewer);
    scan(s, &fewer, has & ~without);
    narrow(s, &fewer, has & ~without);
  }
  if (!without || !(fewer.distance < WELL)) find_all(s, x, has);
  if (without && fewer.distance < fmax(x->distance, WELL)) *x = fewer;
}

/* ---- all of it ------------------------------------------------------------------------- */

static bool read_knob(search *s, const sozai_texture *texture, const char *id) {
  const sozai_textures_1 *textures = s->thin.textures;
  const sozai_parameter *p = parameter_of(s->q->info, id);
  sozai_value v;
  if (!p) return fail(s->why, EXIT_FAILURE, "no parameter %s", id);
  if (textures->value(texture, id, &v) != SOZAI_OK)
    return fail(s->why, EXIT_FAILURE, "%s: %s", id, textures->last_error());
  s->knobs[s->count++] = (knob){id, v.number[0], p->hard_max, recipe_sets(s->recipe, id)};
  return true;
}

static bool read_knobs(search *s) {
  const match_material *m = s->q->weighing->material;
  sozai_texture *texture = NULL;
  recipe r;
  if (!weights_copy_recipe(&r, s->recipe, s->why)) return false;
  bool ok = recipe_create(&r, s->thin.textures, &s->thin.host->abi, &texture, s->why);
  recipe_free(&r);
  if (!ok) return false;
  for (size_t i = 0; ok && i < MOST_SHARES && m->shares[i]; i++)
    ok = read_knob(s, texture, m->shares[i]);
  s->shares = s->count;
  if (ok && m->brightness) ok = read_knob(s, texture, m->brightness);
  s->thin.textures->destroy(texture);
  return ok;
}

static void begin(search *s, const share_search *q, const recipe *r, failure *why) {
  const board *b = q->weighing->board;
  double step = ceil(sqrt((double)b->width * b->height / SEARCH_POINTS));
  s->q = q;
  s->recipe = r;
  s->why = why;
  s->thin = *b;
  s->thin.step = (uint32_t)fmax(b->step, step);
  s->thin.faces = FACES;
  s->material = *q->weighing->material;
  s->material.brightness = NULL;
  s->weighing = *q->weighing;
  s->weighing.board = &s->thin;
  s->weighing.material = &s->material;
}

static void tell(const search *s, const setting *preset, const setting *x, match_shares *out) {
  out->count = s->shares;
  for (size_t i = 0; i < s->shares; i++)
    out->of[i] = (match_share){s->knobs[i].id, s->knobs[i].preset, x->of[i], s->knobs[i].given};
  out->found = true;
  out->has_brightness = s->count > s->shares;
  if (out->has_brightness) out->brightness = x->of[s->shares];
  out->preset_distance = preset->distance;
  out->distance = x->distance;
}

static bool keep(const search *s, const setting *x, recipe *r) {
  bool ok = true;
  for (size_t i = 0; ok && i < s->count; i++) {
    char text[32];
    snprintf(text, sizeof text, "%.4f", x->of[i]);
    if (!s->knobs[i].given) ok = recipe_set(r, s->knobs[i].id, text, 0, s->why);
  }
  return ok;
}

static bool search_all(search *s, recipe *r, match_shares *out) {
  setting x = {{0}, 0};
  bool any = false;
  if (!read_knobs(s)) return false;
  for (size_t i = 0; i < s->count; i++) {
    x.of[i] = s->knobs[i].preset;
    any = any || (i < s->shares && !s->knobs[i].given);
  }
  if (!any) return true;
  if (!rank_photo(s)) s->failed = true;
  distance_of(s, &x);
  const setting preset = x;
  find(s, &x);
  for (size_t a = 0; a < 3; a++) free(s->ranked[a]);
  tell(s, &preset, &x, out);
  return !s->failed && keep(s, &x, r);
}

bool shares_fit(const share_search *q, recipe *r, match_shares *out, failure *why) {
  memset(out, 0, sizeof *out);
  if (!q->weighing->material->shares[0]) return true;
  search *s = calloc(1, sizeof *s);
  if (!s) return fail(why, EXIT_FAILURE, "out of memory");
  begin(s, q, r, why);
  bool ok = search_all(s, r, out);
  free(s);
  return ok;
}
