/* SPDX-License-Identifier: Apache-2.0 */
#include "run.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include "clock.h"
#include "load.h"
#include "measure.h"
#include "op_count.h"
#include "parallel.h"
#include "peak.h"
#include "pin.h"
#include "scratch.h"
#include "fiber.h"
#include "tree.h"
#include "walk.h"

#define CREATES 20        /* a repetition */
#define COUNTED_POINTS 64 /* a batch: whole rounds of every kernel */

bool entry_needs_yardstick(const entry *e) {
  return e->kind == ENTRY_POINTS || e->kind == ENTRY_THREADS;
}

/* ---- contestants ------------------------------------------------------ */

typedef struct job {
  const bench *bench;
  const entry *entry;
  sozai_texture *texture;
  walk *walk[2];
  atomic_bool failed;
} job;

static bool run_yardstick(void *context, double *ns, failure *why) {
  const job *j = context;
  return yardstick_run(j->bench->yardstick, &j->bench->board, ns, why);
}

static bool evaluate_failed(const job *j, failure *why) {
  return fail(why, EXIT_FAILURE, "%s: evaluate: %s", j->entry->name,
              j->bench->plugin.textures->last_error());
}

static bool run_points(void *context, double *ns, failure *why) {
  const job *j = context;
  double begin = thread_ns();
  bool ok = walk_rows(j->walk[0], 0, j->bench->board.rows);
  *ns = thread_ns() - begin;
  return ok || evaluate_failed(j, why);
}

/* For the two threads the time that passes counts, and so for the one beside
 * them. */
static bool run_one_thread(void *context, double *ns, failure *why) {
  const job *j = context;
  double begin = wall_ns();
  bool ok = walk_rows(j->walk[0], 0, j->bench->board.rows);
  *ns = wall_ns() - begin;
  return ok || evaluate_failed(j, why);
}

static void run_half(void *context, uint32_t i) {
  job *j = context;
  uint32_t half = j->bench->board.rows / 2;
  if (!pin_to((int)i) || !walk_rows(j->walk[i], i * half, (i + 1) * half))
    atomic_store(&j->failed, true);
}

static bool run_two_threads(void *context, double *ns, failure *why) {
  job *j = context;
  /* A new thread takes over this one's place, and would wait there for its turn. */
  pin_release();
  double begin = wall_ns();
  parallel_for(2, 2, run_half, j);
  *ns = wall_ns() - begin;
  pin_to(0); /* either half may have been this thread's */
  return !atomic_load(&j->failed) || fail(why, EXIT_FAILURE, "%s: a thread failed", j->entry->name);
}

static bool run_create(void *context, double *ns, failure *why) {
  const job *j = context;
  double begin = thread_ns();
  for (int i = 0; i < CREATES; i++) {
    sozai_texture *texture = NULL;
    if (!wood_create(&j->entry->wood, j->bench->picture, &j->bench->plugin, &texture, why))
      return false;
    j->bench->plugin.textures->destroy(texture);
  }
  *ns = (thread_ns() - begin) / CREATES;
  return true;
}

static bool run_load(void *context, double *ns, failure *why) {
  const job *j = context;
  return j->entry->kind == ENTRY_LOAD ? load_once(j->bench->plugin.path, ns, why)
                                      : load_alone(j->bench->plugin.path, ns, why);
}

/* ---- the arithmetic-bound limit --------------------------------------- */

static void step_through(void *context) {
  const job *j = context;
  const board *b = &j->bench->board;
  uint32_t batches = j->bench->counted_batches;
  for (uint32_t i = 0; i < batches; i++) /* spread over the part */
    walk_batch(j->walk[1], b->column + b->columns / batches * i, b->row + b->rows / batches * i);
}

static void find_limit(const job *j, result *out) {
  op_count count;
  peak most = peak_of(out->instruction_set);
  out->peak_gops = most.lanes ? most.gops : NAN;
  if (!most.lanes || !op_count_run(step_through, (void *)(uintptr_t)j, &count)) return;
  uint32_t batch = out->batch < COUNTED_POINTS ? out->batch : COUNTED_POINTS;
  double lanes_a_point = (double)most.lanes / ((double)batch * j->bench->counted_batches);
  out->float_ops = (double)count.floating * lanes_a_point;
  out->ops = (double)(count.floating + count.integer) * lanes_a_point;
  out->limit_ns = out->ops / out->peak_gops;
}

/* ---- entries ---------------------------------------------------------- */

static bool open_walk(job *j, int which, uint32_t batch, failure *why) {
  const entry *e = j->entry;
  walk_plan plan = {.textures = j->bench->plugin.textures,
                    .texture = j->texture,
                    .components = wood_components(&e->wood, &j->bench->plugin),
                    .edge = e->wood.edge,
                    .masked = e->masked,
                    .board = &j->bench->board,
                    .batch = batch,
                    .footprint = e->footprint > 0 ? e->footprint : TEXEL_MM};
  if (e->channel && !(plan.channel = wood_channel(&j->bench->plugin, e->channel)))
    return fail(why, EXIT_FAILURE, "wood has no channel %s", e->channel);
  j->walk[which] = walk_open(&plan, why);
  return j->walk[which] != NULL;
}

static void take_yardstick(const bench *b, const timing *t, result *out) {
  double points = (double)board_points(&b->board);
  out->yardstick_ns = t->median / points;
  out->yardstick_min = t->min / points;
  out->ratio = out->yardstick_ns / out->ns;
}

static bool run_on_points(job *j, result *out, failure *why) {
  const bench *b = j->bench;
  double points = (double)board_points(&b->board);
  uint32_t counted = out->batch < COUNTED_POINTS ? out->batch : COUNTED_POINTS;
  contestant who[] = {{run_yardstick, j}, {run_points, j}};
  timing t[2];
  if (!open_walk(j, 0, out->batch, why) || !open_walk(j, 1, counted, why) ||
      !measure(who, 2, b->repetitions, t, why))
    return false;
  out->ns = t[1].median / points;
  out->ns_min = t[1].min / points;
  take_yardstick(b, &t[0], out);
  /* A point alone is no work for vectors: their limit says nothing about it. */
  /* And of a picture's texture system it would count every step. */
  if (out->batch > 1 && !j->entry->wood.pictured) find_limit(j, out);
  return true;
}

static bool run_on_threads(job *j, result *out, failure *why) {
  const bench *b = j->bench;
  double points = (double)board_points(&b->board);
  contestant who[] = {{run_yardstick, j}, {run_one_thread, j}, {run_two_threads, j}};
  timing t[3];
  if (!open_walk(j, 0, out->batch, why) || !open_walk(j, 1, out->batch, why) ||
      !measure(who, 3, b->repetitions, t, why))
    return false;
  out->ns = t[2].median / points;
  out->ns_min = t[2].min / points;
  out->speedup = t[1].median / t[2].median;
  out->speedup_best = t[1].min / t[2].min;
  take_yardstick(b, &t[0], out);
  return true;
}

static bool run_alone(job *j, result *out, failure *why) {
  contestant who = {j->entry->kind == ENTRY_CREATE ? run_create : run_load, j};
  timing t;
  if (!measure(&who, 1, j->bench->repetitions, &t, why)) return false;
  out->ns = t.median;
  out->ns_min = t.min;
  out->yardstick_ns = out->yardstick_min = CREATE_GOAL_NS;
  out->ratio = out->yardstick_ns / out->ns;
  return true;
}

static bool run_sozai_tiles(void *context, double *ns, failure *why) {
  return tile_read_sozai(context, ns, why);
}

static bool run_baked_tiles(void *context, double *ns, failure *why) {
  return tile_read_baked(context, ns, why);
}

/* A texel is a point, and the baked tile the yardstick. */
static bool run_tiles(const bench *b, const entry *e, result *out, failure *why) {
  scratch s = {0};
  if (!scratch_open(&s, "unused", why)) return false;
  tile *t = tile_open(&e->tile, s.folder, b->plugin.path, why);
  contestant who[] = {{run_baked_tiles, t}, {run_sozai_tiles, t}};
  timing times[2];
  bool ok = t && measure(who, 2, b->repetitions, times, why);
  tile_close(t);
  scratch_close(&s);
  if (!ok) return false;
  const double texels = (double)TILE_COUNT * TILE_SIDE * TILE_SIDE;
  out->ns = times[1].median / texels;
  out->ns_min = times[1].min / texels;
  out->yardstick_ns = times[0].median / texels;
  out->yardstick_min = times[0].min / texels;
  out->ratio = out->yardstick_ns / out->ns;
  return true;
}

static bool run_job(job *j, result *out, failure *why) {
  switch (j->entry->kind) {
  case ENTRY_POINTS:
    return run_on_points(j, out, why);
  case ENTRY_THREADS:
    return run_on_threads(j, out, why);
  default:
    return run_alone(j, out, why);
  }
}

/* Without the host's threads: one core. */
static bool run_tree(job *j, result *out, failure *why) {
  tree_job t = {.preset = j->entry->tree, .meshed = j->entry->kind == ENTRY_TREE_MESH};
  if (!tree_job_open(&t, &j->bench->plugin, why)) return false;
  contestant who = {tree_job_run, &t};
  timing time;
  if (!measure(&who, 1, j->bench->repetitions, &time, why)) return false;
  bool each = j->entry->kind == ENTRY_TREE_BRANCHES;
  double share = each ? 1 / t.branches : 1;
  out->ns = share * time.median;
  out->ns_min = share * time.min;
  out->yardstick_ns = out->yardstick_min = each ? TREE_BRANCH_GOAL_NS : TREE_GOAL_NS;
  out->ratio = out->yardstick_ns / out->ns;
  return true;
}

static bool run_fiber(job *j, result *out, failure *why) {
  int kind = j->entry->kind;
  fiber_job f = {.fitted = kind != ENTRY_FIBER_PLACE, .threads = kind == ENTRY_FIBER_THREADS};
  if (!fiber_job_open(&f, &j->bench->plugin, why)) return false;
  contestant who = {fiber_job_run, &f};
  timing time;
  bool ok = measure(&who, 1, j->bench->repetitions, &time, why);
  fiber_job_close(&f);
  if (!ok) return false;
  out->ns = time.median;
  out->ns_min = time.min;
  out->yardstick_ns = out->yardstick_min = f.threads ? FIBER_GOAL_NS : 2 * FIBER_GOAL_NS;
  out->ratio = out->yardstick_ns / out->ns;
  return true;
}

bool entry_run(const bench *b, const entry *e, result *out, bool *skipped, failure *why) {
  *out = (result){.name = e->name,
                  .instruction_set = "",
                  .batch = e->batch,
                  .speedup = NAN,
                  .speedup_best = NAN,
                  .ops = NAN,
                  .float_ops = NAN,
                  .peak_gops = NAN,
                  .limit_ns = NAN};
  *skipped = false;
  if (e->kind == ENTRY_TILE) return run_tiles(b, e, out, why);
  job j = {.bench = b, .entry = e};
  atomic_init(&j.failed, false);
  *skipped = (e->kind == ENTRY_THREADS || e->kind == ENTRY_FIBER_THREADS) && pin_cpu_count() < 2;
  if (*skipped) return true;
  if (e->kind >= ENTRY_FIBER_PLACE) return run_fiber(&j, out, why);
  if (e->tree) return run_tree(&j, out, why);
  if (!wood_create(&e->wood, b->picture, &b->plugin, &j.texture, why)) return false;
  *skipped = j.texture == NULL;
  if (*skipped) return true;
  /* the plugin's own text, which outlives the texture */
  out->instruction_set = b->plugin.textures->instruction_set(j.texture);
  bool ok = run_job(&j, out, why);
  walk_close(j.walk[0]);
  walk_close(j.walk[1]);
  b->plugin.textures->destroy(j.texture);
  return ok;
}
