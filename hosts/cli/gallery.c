/* SPDX-License-Identifier: Apache-2.0
 *
 * Renders the pictures of gallery_table.c, an index.html that shows them, and
 * sheets which show some of them small, with their names. A picture whose
 * parameters the plugin does not know is left out with a line that says so.
 *
 * Many pictures are made at once, each on one thread: what a picture cannot share, the
 * making of its texture and the writing of its file, takes a third of its time. */
#include "commands.h"

#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "ceilings.h"
#include "folder.h"
#include "gallery_index.h"
#include "gallery_list.h"
#include "gallery_picture.h"
#include "gallery_tree.h"
#include "parallel.h"
#include "progress.h"
#include "session.h"
#include "sheet.h"

typedef struct gallery {
  easel easel;
  picture_list list;
  uint32_t *order; /* of the list: those that take longest first */
  sheet_picture *small;
  bool *made;
  uint32_t made_count, left_out;
  atomic_bool stopped;
  atomic_uint done;
  pthread_mutex_t lock; /* guards why, the counts and standard error */
  failure why;
} gallery;

/* ---- the pictures ----------------------------------------------------- */

/* A picture by how long it may take: pixels and samples, and for a tree that it is grown. */
static double work_of(const gallery *g, uint32_t i) {
  const picture *p = &g->list.pictures[i];
  double pixels = (double)p->shot.width * p->shot.height * picture_samples(&g->easel, p);
  return gallery_is_tree(&p->shot) ? 1e12 + pixels : pixels;
}

typedef struct ranked {
  double work;
  uint32_t index;
} ranked;

static int longer_first(const void *a, const void *b) {
  const ranked *x = a, *y = b;
  if (x->work != y->work) return x->work > y->work ? -1 : 1;
  return x->index < y->index ? -1 : 1;
}

static bool rank(gallery *g, failure *why) {
  uint32_t n = g->list.count;
  ranked *all = malloc((n + 1) * sizeof *all);
  if (!all) return fail(why, EXIT_FAILURE, "out of memory");
  for (uint32_t i = 0; i < n; i++) all[i] = (ranked){work_of(g, i), i};
  qsort(all, n, sizeof *all, longer_first);
  for (uint32_t i = 0; i < n; i++) g->order[i] = all[i].index;
  free(all);
  return true;
}

/* What cannot be made of the values is no failure of the gallery: see the head. */
static void say_left_out(gallery *g, const picture *p, const failure *why) {
  progress_clear();
  fprintf(stderr, "sozai: left out %s: %s\n", p->name, why->text);
  g->left_out++;
}

static void make_one(void *context, uint32_t index) {
  gallery *g = context;
  if (atomic_load(&g->stopped)) return;
  uint32_t i = g->order[index];
  const picture *p = &g->list.pictures[i];
  failure why = {0};
  picture_result r = picture_make(&g->easel, p, &g->small[i], &why);
  pthread_mutex_lock(&g->lock);
  g->made[i] = r == PICTURE_MADE;
  g->made_count += g->made[i];
  if (r == PICTURE_LEFT_OUT) say_left_out(g, p, &why);
  if (r == PICTURE_FAILED && !atomic_exchange(&g->stopped, true)) g->why = why;
  pthread_mutex_unlock(&g->lock);
  uint32_t done = atomic_fetch_add(&g->done, 1) + 1;
  progress_show((float)done / (float)g->list.count, "drawing the gallery");
}

static bool make_pictures(gallery *g, failure *why) {
  uint32_t threads = g->easel.session->host.threads, count = g->list.count;
  if (!rank(g, why)) return false;
  g->easel.threads = count && count < threads ? threads / count : 1;
  parallel_for(threads, count, make_one, g);
  progress_clear();
  if (atomic_load(&g->stopped)) *why = g->why;
  return !atomic_load(&g->stopped);
}

/* ---- what shows them -------------------------------------------------- */

static bool make_sheet(const gallery *g, const shot_sheet *of, bool *there, failure *why) {
  sheet s = {0};
  film f;
  char name[64];
  bool ok = true;
  for (uint32_t i = 0; ok && i < g->list.count; i++) {
    const picture *p = &g->list.pictures[i];
    if (g->made[i] && p->shot.sheet && strcmp(p->shot.sheet, of->id) == 0)
      ok = sheet_add(&s, &g->small[i], p->title, why);
  }
  *there = s.count > 0;
  if (ok && *there) {
    snprintf(name, sizeof name, "%s.png", of->id);
    ok = sheet_finish(&s, of->columns, &f, why);
    if (ok) {
      ok = picture_write(&g->easel, &f, name, why);
      film_free(&f);
    }
  }
  sheet_free(&s);
  return ok;
}

static bool show_pictures(const gallery *g, failure *why) {
  bool sheets[GALLERY_SHEETS], ok = true;
  for (int i = 0; ok && i < GALLERY_SHEETS; i++)
    ok = make_sheet(g, &gallery_sheets[i], &sheets[i], why);
  return ok && gallery_index_write(&g->easel, &g->list, g->made, sheets, why);
}

static bool make_folder(const char *folder, failure *why) {
  return folder_make(folder) || fail(why, EXIT_BAD_INPUT, "--output: cannot make folder '%s': %s",
                                     folder, strerror(errno));
}

/* ---- the command ------------------------------------------------------ */

static bool make_all(gallery *g, failure *why) {
  uint32_t n = g->list.count;
  g->order = calloc(n + 1, sizeof *g->order);
  g->small = calloc(n + 1, sizeof *g->small);
  g->made = calloc(n + 1, sizeof *g->made);
  if (!g->order || !g->small || !g->made) return fail(why, EXIT_FAILURE, "out of memory");
  return make_pictures(g, why) && show_pictures(g, why);
}

static void free_all(gallery *g) {
  for (uint32_t i = 0; g->small && i < g->list.count; i++) sheet_picture_free(&g->small[i]);
  free(g->order);
  free(g->small);
  free(g->made);
  picture_list_free(&g->list);
}

static bool make_gallery(const session_options *shared, const char *folder, uint32_t spp, bool all,
                         failure *why) {
  session s;
  if (!folder) return fail(why, EXIT_BAD_INPUT, "gallery: no output is given: -o DIR");
  if (!session_open(&s, shared, why)) return false;
  gallery g = {.easel = {.session = &s, .folder = folder, .spp = spp},
               .lock = PTHREAD_MUTEX_INITIALIZER};
  bool ok = make_folder(folder, why) && picture_list_make(&g.list, s.plugin.textures, all, why) &&
            make_all(&g, why);
  free_all(&g);
  session_close(&s);
  if (!ok) return false;
  printf("%s/index.html: %u pictures", folder, g.made_count);
  if (g.left_out) printf(", %u left out", g.left_out);
  putchar('\n');
  return true;
}

int run_gallery(int argc, char **argv) {
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc, &why)) return report(&why);
  const char *folder = NULL;
  uint32_t spp = 16;
  bool all = false;
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &folder, "DIR", "folder for the pictures; made if need be", 0,
       0},
      {"all", 0, OPTION_FLAG, &all, NULL,
       "every picture: some minutes; without it a choice of them", 0, 0},
      {"spp", 0, OPTION_COUNT, &spp, "N", "samples per pixel (default: 16)", 1, VIEW_MOST_SAMPLES},
      SESSION_DISPLAY_OPTIONS(shared),
      SESSION_RUN_OPTIONS(shared)};
  const command_line line = {
      .usage = "gallery -o DIR [options]",
      .about = "Renders woods, stones, cloth, floors, paving and trees into a folder with "
               "an index.html;\nwith --all every preset of every material, and "
               "what each can do.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0]};
  int parsed = options_parse(&line, argc, argv, NULL, &why);
  int code = 0;
  if (parsed == OPTIONS_BAD ||
      (parsed == OPTIONS_RUN && !make_gallery(&shared, folder, spp, all, &why)))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
