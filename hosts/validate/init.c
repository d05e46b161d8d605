/* SPDX-License-Identifier: Apache-2.0
 * init and deinit: counted, repeated, from many threads, across fork and dlclose. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "batch.h"
#include "groups.h"

static bool start_init(subject *s, const char *path) {
  doing("init");
  int32_t r = s->entry->init(path);
  return EXPECT(r == SOZAI_OK, "init gave %s", result_name(r));
}

/* "Make ready." */
static void succeeds(subject *s) {
  if (subject_load(s)) start_init(s, s->path);
}

/* "get_factory(SOZAI_TEXTURES_1) gives the table of functions": or geometry alone. */
static void tables(subject *s) {
  if (!subject_load(s) || !start_init(s, s->path)) return;
  subject_tables(s);
  EXPECT(s->textures || s->geometry, "it has neither " SOZAI_TEXTURES_1 " nor " SOZAI_GEOMETRY_1);
}

/* ---- something to compare ------------------------------------------------ */

#define POINTS 32u

/* The answers of a texture's defaults, component by component; NULL: none.
 * Points by a fixed rule, since this runs before and after in other processes. */
static float *answers(subject *s, const sozai_texture_info *info) {
  sozai_texture *t = NULL;
  doing("create of %s", info->id);
  int32_t r = s->textures->create(NULL, info->id, NULL, NULL, 0, &t);
  if (!EXPECT(r == SOZAI_OK, "create of %s gave %s: %s", info->id, result_name(r), last_error(s)))
    return NULL;
  uint64_t kept = s->chance;
  batch *b = batch_new(s, info, NULL, POINTS);
  s->chance = kept;
  float *out = NULL;
  if (b && batch_run(s, t, b, "all inputs")) out = batch_answers(b);
  batch_free(b);
  s->textures->destroy(t);
  return out;
}

static void same_answers(subject *s, const sozai_texture_info *info, const float *before,
                         const char *when) {
  float *after = answers(s, info);
  for (uint32_t c = 0; before && after && c < info->component_count; c++)
    EXPECT(memcmp(&before[batch_place(c, 0)], &after[batch_place(c, 0)], POINTS * sizeof *after) ==
               0,
           "%s: %s has other bits %s", info->id, component_name(info, c), when);
  free(after);
}

static const sozai_texture_info *first_texture(const subject *s) {
  for (uint32_t i = 0; s->textures && i < s->textures->count(); i++) {
    const sozai_texture_info *info = s->textures->info(i);
    if (info && subject_wants(s, info->id)) return info;
  }
  return NULL;
}

/* ---- the checks ---------------------------------------------------------- */

/* "plugin_path: the file this library was loaded from, or NULL" */
static void null_path(subject *s) {
  if (!subject_load(s) || !start_init(s, NULL)) return;
  subject_tables(s);
  const sozai_texture_info *info = first_texture(s);
  if (info) free(answers(s, info));
}

/* "or NULL: unknown, or not initialised" */
static void before_init(subject *s) {
  if (!subject_load(s)) return;
  static const char *const ids[] = {SOZAI_TEXTURES_1, SOZAI_GEOMETRY_1, SOZAI_WOOD_1, "none"};
  for (uint32_t i = 0; i < COUNT_OF(ids); i++) {
    doing("get_factory before init");
    EXPECT(!s->entry->get_factory(ids[i]), "get_factory(\"%s\") gives a table before init", ids[i]);
  }
}

static void after_deinit(subject *s) {
  if (!subject_start(s)) return;
  const sozai_textures_1 *kept = s->textures;
  doing("deinit");
  s->entry->deinit();
  doing("get_factory after the last deinit");
  EXPECT(!s->entry->get_factory(SOZAI_TEXTURES_1),
         "get_factory gives " SOZAI_TEXTURES_1 " after the last deinit");
  EXPECT(!s->entry->get_factory(SOZAI_GEOMETRY_1),
         "get_factory gives " SOZAI_GEOMETRY_1 " after the last deinit");
  /* "SOZAI_ERROR_STATE: called before init or after the last deinit". A table is only valid
   * until then, so ask where it is part of the library itself. */
  Dl_info where, own;
  if (!kept || !dladdr(kept, &where) || !dladdr(s->entry, &own) || where.dli_fbase != own.dli_fbase)
    return;
  sozai_texture *t = (sozai_texture *)(uintptr_t)1;
  doing("create after the last deinit");
  int32_t r = kept->create(NULL, "wood", NULL, NULL, 0, &t);
  EXPECT(r == SOZAI_ERROR_STATE, "create after the last deinit gave %s", result_name(r));
  EXPECT(r == SOZAI_OK || !t, "create after the last deinit left *out as it was");
}

/* "Counted: each init that gave SOZAI_OK wants one deinit." */
static void nested(subject *s) {
  if (!subject_start(s)) return;
  const void *table = s->textures ? (const void *)s->textures : (const void *)s->geometry;
  const char *id = s->textures ? SOZAI_TEXTURES_1 : SOZAI_GEOMETRY_1;
  if (!start_init(s, s->path) || !start_init(s, NULL)) return;
  for (int left = 2; left > 0; left--) {
    doing("deinit, with %d to come", left);
    s->entry->deinit();
    EXPECT(s->entry->get_factory(id) == table, "the table is gone with %d deinit to come", left);
    const sozai_texture_info *info = first_texture(s);
    if (info) free(answers(s, info));
  }
  s->entry->deinit();
  EXPECT(!s->entry->get_factory(id), "as many deinit as init: the table is still there");
}

/* Not promised, but what a host that errs meets: one deinit too many does nothing. */
static void unbalanced(subject *s) {
  if (!subject_load(s)) return;
  doing("deinit without init");
  s->entry->deinit();
  s->entry->deinit();
  if (!start_init(s, s->path)) return;
  subject_tables(s);
  EXPECT(s->textures || s->geometry, "after a deinit without init, init leads to no table");
}

static void again(subject *s) {
  if (!subject_start(s)) return;
  const sozai_texture_info *info = first_texture(s);
  float *before = info ? answers(s, info) : NULL;
  for (int i = 0; i < 5 && !enough(); i++) {
    doing("deinit and init, %d times", i + 1);
    s->entry->deinit();
    if (!start_init(s, s->path)) break;
    subject_tables(s);
    if (!EXPECT(s->textures || s->geometry, "no table after deinit and init")) break;
    info = first_texture(s);
    if (info) same_answers(s, info, before, "after deinit and init");
  }
  free(before);
}

/* "5. deinit(), dlclose()." */
static void reload(subject *s) {
  if (!subject_start(s)) return;
  const sozai_texture_info *info = first_texture(s);
  float *before = info ? answers(s, info) : NULL;
  for (int i = 0; i < 4 && !enough(); i++) {
    subject_stop(s);
    if (!subject_start(s)) break;
    info = first_texture(s);
    if (info) same_answers(s, info, before, "after dlclose and dlopen");
    asked();
  }
  subject_stop(s);
  free(before);
}

/* A renderer may fork to work in shares: what was made goes on in both. */
static void forked(subject *s) {
  if (!subject_start(s)) return;
  const sozai_texture_info *info = first_texture(s);
  if (!info) {
    skipped("it has no texture");
    return;
  }
  float *before = answers(s, info);
  sozai_texture *t = NULL;
  int32_t r = s->textures->create(NULL, info->id, NULL, NULL, 0, &t);
  if (!EXPECT(r == SOZAI_OK, "create gave %s", result_name(r))) return;
  doing("fork");
  pid_t pid = fork();
  if (pid == 0) {
    same_answers(s, info, before, "in a forked process");
    s->textures->destroy(t);
    s->entry->deinit();
    _exit(0);
  }
  int status = 0;
  EXPECT(pid > 0 && waitpid(pid, &status, 0) == pid, "fork did not work");
  EXPECT(WIFEXITED(status) && WEXITSTATUS(status) == 0,
         "the forked process did not come to its end");
  doing("after fork");
  same_answers(s, info, before, "after a fork");
  s->textures->destroy(t);
  free(before);
}

static void *init_often(void *context) {
  const subject *s = context;
  for (int i = 0; i < 200; i++) {
    if (s->entry->init(s->path) != SOZAI_OK) return context;
    if (!s->entry->get_factory(SOZAI_TEXTURES_1) && !s->entry->get_factory(SOZAI_GEOMETRY_1))
      return context;
    s->entry->deinit();
  }
  return NULL;
}

/* "[thread-safe]" of init, deinit and get_factory. */
static void by_threads(subject *s) {
  if (!subject_load(s)) return;
  pthread_t threads[8];
  doing("init and deinit by 8 threads");
  for (int i = 0; i < 8; i++)
    if (pthread_create(&threads[i], NULL, init_often, s) != 0) return failed("no thread");
  bool good = true;
  for (int i = 0; i < 8; i++) {
    void *bad;
    pthread_join(threads[i], &bad);
    good &= !bad;
  }
  EXPECT(good, "init failed, or no table between init and deinit, on a thread of 8");
  EXPECT(!s->entry->get_factory(SOZAI_TEXTURES_1) && !s->entry->get_factory(SOZAI_GEOMETRY_1),
         "after as many deinit as init a table is still there");
}

CHECKS(init, //
       {"init.succeeds", "version.functions", "init of its own path gives SOZAI_OK", succeeds},
       {"init.tables", "init.succeeds", "it has textures or geometry", tables},
       {"init.null-path", "evaluate.answers", "init(NULL) works too", null_path},
       {"init.before", "version.functions", "there is no table before init", before_init},
       {"init.after", "init.tables",
        "nor after the last deinit; a kept create() gives SOZAI_ERROR_STATE", after_deinit},
       {"init.nested", "evaluate.answers",
        "init is counted: the last deinit ends it, and none before", nested},
       {"init.unbalanced", "init.tables", "one deinit too many does nothing (beyond the header)",
        unbalanced},
       {"init.again", "evaluate.answers", "init after the last deinit gives the same answers",
        again},
       {"init.reload", "evaluate.answers", "so does dlopen after dlclose", reload},
       {"init.fork", "evaluate.answers", "a forked process goes on with what it has", forked},
       {"init.threads", "init.tables", "init and deinit hold from 8 threads at once", by_threads});
