/* SPDX-License-Identifier: Apache-2.0
 *
 * The tree as a generator: the order in which it is grown, and its threads.
 */
#include "generator.h"

#include <string.h>

#include "../core/crew.h"
#include "../core/meter.h"
#include "../core/status.h"
#include "field.h"
#include "lenticels.h"
#include "life.h"
#include "mesh.h"
#include "parameters.h"
#include "report.h"
#include "shoots.h"
#include "species.h"
#include "stem.h"

static const sozai_generator_info *describe(void) {
  static sozai_generator_info info = {
      .size = sizeof(sozai_generator_info),
      .revision = 12,
      .id = "tree",
      .label = "Tree",
      .doc = "A tree grown year by year, or measured: stem, branches, shoots and leaves, and the "
             "knots and rings in its wood.",
      .parameters = tree_parameters,
      .presets = tree_species,
      .tables = tree_table_infos,
      .parameter_count = TREE_PARAMETER_COUNT,
      .table_count = TREE_TABLES,
  };
  if (!info.preset_count) info.preset_count = tree_species_count;
  return &info;
}

/* ---- all shoots, by as many threads as the host has -------------------- */

typedef struct {
  tree *tree;
  const sozai_host *host;
  shoot_room *rooms; /* of each job: what it takes, then where it begins */
  uint32_t jobs;
  int writing, sprigs;
  float thin;
} shoot_crew;

static void run_job(void *context, uint32_t i) {
  shoot_crew *w = context;
  const tree_branch *b = &w->tree->branches[i];
  shoot_pen pen = {.tree = w->tree, .writing = w->writing, .sprigs = w->sprigs, .thin = w->thin};
  if (w->writing) pen.at = w->rooms[i];
  if (i == 0) {
    /* the year's leader is green; measured stems as the species' shoots are */
    if (w->tree->plan.leaf_from <= 2) shoots_leader(&pen, i, 0.06f * b->length);
  } else if (b->nodes && b->death < 0.0f) {
    shoots_on(&pen, i);
  }
  if (!w->writing) w->rooms[i] = pen.used;
}

static int32_t run_crew(shoot_crew *w, int writing, double begin, double end) {
  w->writing = writing;
  return crew_run(w->host, w->jobs, run_job, w, (crew_progress){"growing shoots", begin, end});
}

static shoot_room total_of(const shoot_crew *w) {
  shoot_room sum = {0, 0, 0};
  for (uint32_t i = 0; i < w->jobs; i++) {
    sum.branches += w->rooms[i].branches;
    sum.nodes += w->rooms[i].nodes;
    sum.organs += w->rooms[i].organs;
  }
  return sum;
}

#define LONG_NEEDLE 0.2f /* of the longest shoot: seen one by one, not as the shoot's clothing */
#define THIN_NEEDLES 8.0f

/* Counts what there is room for: every leaf, or fewer and larger ones; short
 * needles, or more than a few times too many, as shoots clothed as one. */
static int32_t count_shoots(shoot_crew *w) {
  const tree_plan *p = &w->tree->plan;
  int needles = p->leaf == LEAF_NEEDLE;
  w->thin = 1.0f;
  w->sprigs = p->foliage == FOLIAGE_SPRIGS && needles;
  int32_t r = run_crew(w, 0, 0.0, 0.1);
  double organs = (double)total_of(w).organs;
  if (r || p->foliage != FOLIAGE_AUTO || organs <= p->leaves_most) return r;
  float thin = (float)((int)(organs / p->leaves_most) + 1);
  int is_long = p->side[0].length > LONG_NEEDLE * p->side[3].length;
  w->sprigs = needles && !(is_long && thin <= THIN_NEEDLES);
  if (!w->sprigs) w->thin = thin;
  return run_crew(w, 0, 0.1, 0.2);
}

/* A longer copy of an array, which is freed; NULL, and it stays. */
static void *widen(void *array, const sozai_host *host, uint64_t used, uint64_t *room,
                   uint64_t more, size_t each) {
  if (!more && array) return array;
  void *wider = host_alloc(host, (size_t)(used + more + 1) * each, 64);
  if (!wider) return NULL;
  if (used) memcpy(wider, array, (size_t)used * each);
  host_free(host, array, (size_t)*room * each, 64);
  *room = used + more + 1;
  return wider;
}

/* The same, claimed. */
static int32_t claim_wider(const void *array, const sozai_host *host, uint64_t used, uint64_t room,
                           uint64_t more, size_t each) {
  if (!more && array) return SOZAI_OK;
  int32_t r = host_claim(host, (used + more + 1) * each);
  host_unclaim(host, room * each);
  return r;
}

static int32_t claim_all(const tree *t, const sozai_host *host, const shoot_room *more) {
  int32_t r = claim_wider(t->branches, host, t->branch_count, t->branch_room, more->branches,
                          sizeof *t->branches);
  if (!r) {
    r = claim_wider(t->nodes, host, t->node_count, t->node_room, more->nodes, sizeof *t->nodes);
  }
  if (!r) r = claim_wider(t->organs, host, 0, t->organ_room, more->organs, sizeof *t->organs);
  return r;
}

static int32_t widen_all(tree *t, const sozai_host *host, const shoot_room *more) {
  void *wider = widen(t->branches, host, t->branch_count, &t->branch_room, more->branches,
                      sizeof *t->branches);
  if (!wider) return SOZAI_ERROR_MEMORY;
  t->branches = wider;
  wider = widen(t->nodes, host, t->node_count, &t->node_room, more->nodes, sizeof *t->nodes);
  if (!wider) return SOZAI_ERROR_MEMORY;
  t->nodes = wider;
  wider = widen(t->organs, host, 0, &t->organ_room, more->organs, sizeof *t->organs);
  if (!wider) return SOZAI_ERROR_MEMORY;
  t->organs = wider;
  return SOZAI_OK;
}

/* Room for all of it, and where each job begins. */
static int32_t make_room(shoot_crew *w) {
  tree *t = w->tree;
  shoot_room more = total_of(w);
  int32_t r = limit_check(w->host, LIMIT_SHOOTS, t->branch_count + more.branches,
                          "orders, and the spacings of shoots");
  if (!r) r = limit_check(w->host, LIMIT_LEAVES, more.organs, "foliage, and the leaves' spacing");
  if (!r) {
    r = host_has_room(w->host, more.branches * sizeof *t->branches + more.nodes * sizeof *t->nodes +
                                   more.organs * sizeof *t->organs);
  }
  if (!r) {
    r = host_rehearses(w->host) ? claim_all(t, w->host, &more) : widen_all(t, w->host, &more);
  }
  if (r || host_rehearses(w->host)) return r;
  shoot_room at = {t->branch_count, t->node_count, 0};
  for (uint32_t i = 0; i < w->jobs; i++) {
    shoot_room own = w->rooms[i];
    w->rooms[i] = at;
    at.branches += own.branches;
    at.nodes += own.nodes;
    at.organs += own.organs;
  }
  t->branch_count = at.branches;
  t->node_count = at.nodes;
  t->organ_count = at.organs;
  return SOZAI_OK;
}

static int32_t grow_shoots(tree *t, const sozai_host *host) {
  shoot_crew w = {.tree = t, .host = host, .jobs = (uint32_t)t->branch_count};
  size_t bytes = w.jobs * sizeof *w.rooms;
  w.rooms = host_alloc(host, bytes, 64);
  if (!w.rooms) return SOZAI_ERROR_MEMORY;
  int32_t r = count_shoots(&w);
  if (!r) r = make_room(&w);
  if (!r && !host_rehearses(host)) r = run_crew(&w, 1, 0.2, 1.0);
  t->sprigs = w.sprigs;
  host_free(host, w.rooms, bytes, 64);
  return r;
}

/* ---- the whole --------------------------------------------------------- */

static void count_orders(tree *t) {
  memset(t->order_counts, 0, sizeof t->order_counts);
  for (uint64_t i = 0; i < t->branch_count; i++) {
    if (t->branches[i].nodes) t->order_counts[t->branches[i].order & 3u]++;
  }
  t->order_counts[4] = t->organ_count;
}

/* fit: what the plan was fitted to, or NULL. */
static int32_t grow_by_years(tree *t, const sozai_host *host, const field_fit *fit) {
  tree_bud *buds = NULL;
  uint32_t count = 0, room = 0;
  int32_t r = life_make(&t->plan, host, &buds, &count, &room);
  if (!r) r = stem_grow(t, host, buds, count);
  if (!r) r = grow_shoots(t, host);
  if (!r) count_orders(t);
  if (!r) r = report_make(t, host, buds, count, NULL, fit);
  host_free(host, buds, room * sizeof *buds, 64);
  return r;
}

/* fit: NULL if there is too little to fit. */
static int32_t grow_measured(tree *t, const sozai_host *host, const tree_field *f,
                             const field_fit *fit) {
  int32_t r = field_grow(t, host, f);
  if (!r) r = grow_shoots(t, host);
  if (!r) count_orders(t);
  if (!r) r = report_make(t, host, NULL, 0, f, fit);
  return r;
}

static int32_t grow_of_field(tree *t, const sozai_host *host, const tree_field *f, int sibling) {
  fit_data data;
  field_fit fit;
  int32_t r = fit_data_make(&data, host, f);
  int32_t fitted = r ? r : fit_make(&fit, &data, &t->plan);
  if (!r && sibling) r = fitted;
  if (!r && sibling) sibling_plan(&t->plan, &fit, &data);
  fit_data_free(&data, host);
  if (r) return r;
  return sibling ? grow_by_years(t, host, &fit) : grow_measured(t, host, f, fitted ? NULL : &fit);
}

static int32_t grow(void *state, const sozai_host *host, const settings *s) {
  tree *t = state;
  plan_make(&t->plan, s);
  int32_t r = lenticels_check(&t->plan);
  if (!r) r = host_progress(host, 0.0, "growing");
  if (r) return r;
  const char *text = s->list[T_FIELD].text;
  if (!text || !*text) return grow_by_years(t, host, NULL);
  tree_field f = {0};
  r = field_read(&f, host, text);
  if (!r) r = grow_of_field(t, host, &f, choice_at(s, T_RESAMPLE) == RESAMPLE_SIBLING);
  field_free(&f, host);
  return r;
}

static void release(void *state, const sozai_host *host) {
  tree *t = state;
  host_free(host, t->branches, (size_t)t->branch_room * sizeof *t->branches, 64);
  host_free(host, t->nodes, (size_t)t->node_room * sizeof *t->nodes, 64);
  host_free(host, t->organs, (size_t)t->organ_room * sizeof *t->organs, 64);
  for (int i = 0; i < TREE_TABLES; i++) {
    host_free(host, t->tables[i].data, (size_t)t->tables[i].room * sizeof(float), 64);
  }
}

static const float *table(const void *state, uint32_t index, uint64_t *rows) {
  const tree *t = state;
  *rows = t->tables[index].rows;
  return t->tables[index].data;
}

static uint64_t bytes(const void *state) {
  const tree *t = state;
  uint64_t n = t->branch_room * sizeof *t->branches + t->node_room * sizeof *t->nodes +
               t->organ_room * sizeof *t->organs;
  for (int i = 0; i < TREE_TABLES; i++) n += t->tables[i].room * sizeof(float);
  return n;
}

static int32_t mesh(const void *state, const sozai_host *host, uint32_t level, mesh_block **out) {
  return tree_mesh(state, host, level, out);
}

static int32_t curves(const void *state, const sozai_host *host, uint32_t level,
                      curves_block **out) {
  return tree_curves(state, host, level, out);
}

const generator tree_generator = {describe, sizeof(tree), grow,  release,
                                  mesh,     curves,       table, bytes};
