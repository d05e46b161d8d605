/* SPDX-License-Identifier: Apache-2.0
 *
 * Renders the pictures of gallery_table.c, an index.html that shows them, and
 * sheets which show some of them small, with their names. A picture whose
 * parameters the plugin does not know is left out with a line that says so. */
#include "commands.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "folder.h"
#include "gallery_table.h"
#include "gallery_tree.h"
#include "job_options.h"
#include "output_file.h"
#include "progress.h"
#include "session.h"
#include "sheet.h"
#include "ceilings.h"

#define PATH_SIZE 4096

typedef struct gallery {
  session session;
  const char *folder;
  uint32_t spp;
  bool all;
  FILE *index;
  const shot *section; /* its heading, until a picture of it is made */
  bool *begun;         /* of the table's entries, headings that have one */
  sheet sheets[GALLERY_SHEETS];
  uint32_t made, left_out;
} gallery;

static bool path_in(char *path, const gallery *g, const char *name, failure *why) {
  int length = snprintf(path, PATH_SIZE, "%s/%s", g->folder, name);
  return (length > 0 && length < PATH_SIZE) ||
         fail(why, EXIT_BAD_INPUT, "'%s' is too long a path", g->folder);
}

static bool write_film(const gallery *g, const film *f, const char *name, failure *why) {
  char path[PATH_SIZE];
  output_file o;
  if (!path_in(path, g, name, why) || !output_begin(&o, path, why)) return false;
  if (film_write_png(f, o.writing, &g->session.colour, &g->session.shown, 0, 8, why))
    return output_commit(&o, why);
  output_discard(&o);
  return false;
}

static const char *material_of(const shot *s) { return s->material ? s->material : "wood"; }

/* ---- one picture ------------------------------------------------------ */

static bool make_recipe(recipe *r, const shot *s, const char *preset, failure *why) {
  if (!recipe_open(r, material_of(s), why)) return false;
  bool ok = !preset || recipe_set_preset(r, preset, why);
  for (int i = 0; ok && i < SHOT_PARAMS && s->params[i]; i++)
    ok = recipe_set_pair(r, s->params[i], why);
  if (!ok) recipe_free(r);
  return ok;
}

/* A face seen straight on has no edges and no shadows, and its material is
 * filtered: a few samples of each pixel do. */
static uint32_t samples(const gallery *g, const shot *s) {
  bool flat =
      s->shape && strcmp(s->shape, "plane") == 0 && s->camera && strcmp(s->camera, "front") == 0;
  return flat ? (g->spp + 3) / 4 : g->spp;
}

static bool render_texture(gallery *g, const shot *s, const sozai_texture *texture, film *f,
                           failure *why) {
  render_job job;
  render_job_init(&job, g->session.plugin.textures, texture);
  job.threads = g->session.host.threads;
  job.spp = samples(g, s);
  job.width = s->width;
  job.height = s->height;
  if (s->sky > 0) job.sky = s->sky;
  if (s->zoom > 0) job.zoom = s->zoom;
  job.has_target = s->ahead != 0;
  job.target[1] = s->ahead;
  const job_options look = {
      .shape = s->shape, .size = s->size, .camera = s->camera, .light = s->light};
  return job_options_apply(&job, &look, NULL, why) && render(&job, f, why);
}

/* Small pictures stand closer. */
static void begin_section(gallery *g, const shot *first) {
  if (!g->section) return;
  fprintf(g->index, "</main>\n<h2 id=\"%d\">%s</h2>\n", (int)(g->section - gallery_shots),
          g->section->heading);
  fprintf(g->index, "<main style=\"--column: %uem\">\n", first->width < 400 ? 14 : 26);
  g->begun[g->section - gallery_shots] = true;
  g->section = NULL;
}

/* The command that makes the same picture: the best of captions. */
static void write_caption(const gallery *g, const shot *s, const char *file, const char *title,
                          const char *preset) {
  fprintf(g->index, "<figure><img src=\"%s\" alt=\"%s\">\n<figcaption>%s<br><code>", file, title,
          title);
  bool tree = gallery_is_tree(s);
  fprintf(g->index, "sozai %s %s -o %s", tree ? "grow" : "render", material_of(s), file);
  if (preset) fprintf(g->index, " --%s %s", tree ? "species" : "preset", preset);
  for (int i = 0; i < SHOT_PARAMS && s->params[i]; i++) fprintf(g->index, " -p %s", s->params[i]);
  if (s->shape) fprintf(g->index, " --shape %s", s->shape);
  if (s->size) fprintf(g->index, " --size %s", s->size);
  if (s->camera) fprintf(g->index, " --camera %s", s->camera);
  if (s->light) fprintf(g->index, " --light=%s", s->light);
  if (s->sky > 0) fprintf(g->index, " --sky %g", s->sky);
  if (s->zoom > 0) fprintf(g->index, " --zoom %g", s->zoom);
  if (s->ahead != 0) fprintf(g->index, " --target=0,%g,0", s->ahead);
  if (tree) fprintf(g->index, " --level %u", GALLERY_TREE_LEVEL);
  fprintf(g->index, " --res %ux%u --spp %u</code></figcaption></figure>\n", s->width, s->height,
          samples(g, s));
}

static bool keep_picture(gallery *g, const shot *s, const film *f, const char *name,
                         const char *title, const char *preset, failure *why) {
  char file[256];
  snprintf(file, sizeof file, "%s.png", name);
  if (!write_film(g, f, file, why)) return false;
  for (int i = 0; s->sheet && i < GALLERY_SHEETS; i++)
    if (strcmp(s->sheet, gallery_sheets[i].id) == 0 && !sheet_add(&g->sheets[i], f, title, why))
      return false;
  begin_section(g, s);
  write_caption(g, s, file, title, preset);
  g->made++;
  return true;
}

/* What cannot be made of the values is no failure of the gallery: see the head. */
static bool leave_out(gallery *g, const char *name, const failure *why) {
  if (why->exit_code != EXIT_BAD_INPUT) return false;
  progress_clear();
  fprintf(stderr, "sozai: left out %s: %s\n", name, why->text);
  g->left_out++;
  return true;
}

static bool make_picture(gallery *g, const shot *s, const char *name, const char *title,
                         const char *preset, failure *why) {
  film f;
  if (gallery_is_tree(s)) {
    if (!gallery_tree_render(&g->session, s, samples(g, s), &f, why))
      return leave_out(g, name, why);
  } else {
    recipe r;
    if (!make_recipe(&r, s, preset, why)) return false;
    sozai_texture *texture = NULL;
    const sozai_textures_1 *textures = g->session.plugin.textures;
    bool made = recipe_create(&r, textures, &g->session.host.abi, &texture, why);
    recipe_free(&r);
    if (!made) return leave_out(g, name, why);
    bool ok = render_texture(g, s, texture, &f, why);
    textures->destroy(texture);
    if (!ok) return false;
  }
  bool ok = keep_picture(g, s, &f, name, title, preset, why);
  film_free(&f);
  return ok;
}

static bool gives(const sozai_preset *preset, const char *id) {
  for (uint32_t i = 0; i < preset->value_count; i++)
    if (strcmp(preset->values[i].id, id) == 0) return true;
  return false;
}

static bool is_of(const shot *s, const sozai_preset *preset) {
  if (s->with && !gives(preset, s->with)) return false;
  return !s->without || !gives(preset, s->without);
}

static bool has_parameter(const sozai_texture_info *info, const char *id) {
  for (uint32_t i = 0; info && i < info->parameter_count; i++)
    if (strcmp(info->parameters[i]->id, id) == 0) return true;
  return false;
}

static void add_param(shot *s, const char *param) {
  for (int k = 0; k < SHOT_PARAMS; k++) {
    if (s->params[k]) continue;
    s->params[k] = param;
    return;
  }
}

/* The `count` shots that every preset of a material has, of one preset after
 * another. */
static bool make_of_each(gallery *g, const shot *shots, uint32_t count, failure *why) {
  const sozai_texture_info *info = g->session.plugin.textures->find(material_of(shots));
  bool seeds = has_parameter(info, "seed"), offsets = has_parameter(info, "cut_offset");
  for (uint32_t i = 0; info && i < info->preset_count; i++)
    for (const shot *s = shots; s < shots + count; s++) {
      char name[128], title[256], seed[32], offset[48];
      if (!is_of(s, info->presets[i])) continue;
      shot own = *s;
      snprintf(seed, sizeof seed, "seed=%u", i + 1);
      if (s->own_log && seeds) add_param(&own, seed);
      if (s->aside > 0.0 && offsets) {
        /* as many to the left as to the right, and none after its like */
        double place = fmod(0.618034 * (i + 1), 1.0) * 2.0 - 1.0;
        snprintf(offset, sizeof offset, "cut_offset=%.1f 0 0", place * s->aside);
        add_param(&own, offset);
      }
      snprintf(name, sizeof name, "%s-%s", s->name, info->presets[i]->id);
      snprintf(title, sizeof title, "%s, %s", info->presets[i]->label, s->title);
      if (!make_picture(g, &own, name, title, info->presets[i]->id, why)) return false;
    }
  return true;
}

/* ---- all of them ------------------------------------------------------ */

static bool make_folder(const char *folder, failure *why) {
  return folder_make(folder) || fail(why, EXIT_BAD_INPUT, "--output: cannot make folder '%s': %s",
                                     folder, strerror(errno));
}

static bool make_sheets(const gallery *g, failure *why) {
  for (int i = 0; i < GALLERY_SHEETS; i++) {
    char name[64];
    film f;
    if (g->sheets[i].count == 0) continue;
    snprintf(name, sizeof name, "%s.png", gallery_sheets[i].id);
    if (!sheet_finish(&g->sheets[i], gallery_sheets[i].columns, &f, why)) return false;
    bool ok = write_film(g, &f, name, why);
    film_free(&f);
    if (!ok) return false;
  }
  return true;
}

static bool make_pictures(gallery *g, failure *why) {
  const shot *end = gallery_shots + gallery_shot_count;
  for (const shot *s = gallery_shots; s < end;) {
    uint32_t each = 0;
    if (s->heading) {
      g->section = s++;
      continue;
    }
    while (s + each < end && s[each].each_preset && s[each].more == s->more &&
           strcmp(material_of(s + each), material_of(s)) == 0)
      each++;
    if (s->more && !g->all) {
      s += each ? each : 1;
      continue;
    }
    if (each ? !make_of_each(g, s, each, why)
             : !make_picture(g, s, s->name, s->title, s->preset, why))
      return false;
    s += each ? each : 1;
  }
  return make_sheets(g, why);
}

/* Links to the sections that have come to be, and to their sheets. They are written last and
 * shown first. */
static void write_contents(const gallery *g) {
  fputs("<nav>\n", g->index);
  for (uint32_t k = 0; k < gallery_shot_count; k++) {
    const shot *s = &gallery_shots[k];
    if (!g->begun[k]) continue;
    fprintf(g->index, "<a href=\"#%u\">%s</a>\n", k, s->heading);
    for (int i = 0; s->sheet && i < GALLERY_SHEETS; i++)
      if (strcmp(s->sheet, gallery_sheets[i].id) == 0 && g->sheets[i].count > 0)
        fprintf(g->index, "(<a href=\"%s.png\">on one sheet</a>)\n", s->sheet);
  }
  fputs("</nav>\n", g->index);
}

static bool make_index(gallery *g, failure *why) {
  char path[PATH_SIZE];
  output_file o;
  if (!path_in(path, g, "index.html", why) || !output_begin(&o, path, why)) return false;
  g->index = fopen(o.writing, "w");
  bool ok = g->index || fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(errno));
  if (ok) {
    fputs("<!doctype html>\n<meta charset=\"utf-8\">\n<title>sozai</title>\n<style>\n"
          "body { font: 15px sans-serif; margin: 2em; background: #f4f3f1; color: #333;\n"
          "  display: flex; flex-direction: column }\n"
          "main { display: grid; gap: 1.5em;\n"
          "  grid-template-columns: repeat(auto-fill, minmax(var(--column), 1fr)) }\n"
          "nav { order: -1; line-height: 1.8 } nav a { margin-left: 1em } h2 { margin-top: 2em }\n"
          "figure { margin: 0 } img { width: 100%; display: block }\n"
          "figcaption { padding: .4em 0 } code { font-size: 80%; color: #777 }\n"
          "</style>\n<h1>sozai</h1>\n"
          "<p>Under each picture is the command that draws it.</p>\n<main>\n",
          g->index);
    ok = make_pictures(g, why);
    fputs("</main>\n", g->index);
    write_contents(g);
    if (fclose(g->index) != 0 && ok)
      ok = fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(errno));
  }
  if (ok) return output_commit(&o, why);
  output_discard(&o);
  return false;
}

static bool make_gallery(const session_options *shared, const char *folder, uint32_t spp, bool all,
                         failure *why) {
  gallery g = {.folder = folder, .spp = spp, .all = all};
  if (!folder) return fail(why, EXIT_BAD_INPUT, "gallery: no output is given: -o DIR");
  if (!session_open(&g.session, shared, why)) return false;
  g.begun = calloc(gallery_shot_count, sizeof *g.begun);
  if (!g.begun) {
    session_close(&g.session);
    return fail(why, EXIT_FAILURE, "out of memory");
  }
  bool ok = make_folder(folder, why) && make_index(&g, why);
  for (int i = 0; i < GALLERY_SHEETS; i++) sheet_free(&g.sheets[i]);
  session_close(&g.session);
  free(g.begun);
  if (!ok) return false;
  printf("%s/index.html: %u pictures", folder, g.made);
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
