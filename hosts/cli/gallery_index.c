/* SPDX-License-Identifier: Apache-2.0 */
#include "gallery_index.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "gallery_tree.h"
#include "output_file.h"

typedef struct page {
  const easel *easel;
  const picture_list *list;
  const bool *made, *sheets;
  FILE *file;
} page;

static int section_number(const shot *section) { return (int)(section - gallery_shots); }

/* The command that makes the same picture: the best of captions. */
static void write_command(const page *g, const picture *p) {
  const shot *s = &p->shot;
  FILE *to = g->file;
  bool tree = gallery_is_tree(s);
  fprintf(to, "sozai %s %s -o %s.png", tree ? "grow" : "render", shot_material(s), p->name);
  if (p->preset) fprintf(to, " --%s %s", tree ? "species" : "preset", p->preset);
  for (int i = 0; i < SHOT_PARAMS && s->params[i]; i++) fprintf(to, " -p %s", s->params[i]);
  if (s->shape) fprintf(to, " --shape %s", s->shape);
  if (s->size) fprintf(to, " --size %s", s->size);
  if (s->camera) fprintf(to, " --camera %s", s->camera);
  if (s->light) fprintf(to, " --light=%s", s->light);
  if (s->sky > 0) fprintf(to, " --sky %g", s->sky);
  if (s->zoom > 0) fprintf(to, " --zoom %g", s->zoom);
  if (s->ahead != 0) fprintf(to, " --target=0,%g,0", s->ahead);
  if (tree) fprintf(to, " --level %u", GALLERY_TREE_LEVEL);
  fprintf(to, " --res %ux%u --spp %u", s->width, s->height, picture_samples(g->easel, p));
}

static void write_picture(const page *g, const picture *p) {
  fprintf(g->file, "<figure><img src=\"%s.png\" alt=\"%s\">\n<figcaption>%s<br><code>", p->name,
          p->title, p->title);
  write_command(g, p);
  fputs("</code></figcaption></figure>\n", g->file);
}

/* Small pictures stand closer. */
static void begin_section(const page *g, const picture *first) {
  fprintf(g->file, "<h2 id=\"%d\">%s</h2>\n", section_number(first->section),
          first->section->heading);
  fprintf(g->file, "<main style=\"--column: %uem\">\n", first->shot.width < 400 ? 14 : 26);
}

/* The next picture that was made and begins a section, from i on; or the list's end. */
static uint32_t next_section(const page *g, uint32_t i, const shot *current) {
  const picture *p = g->list->pictures;
  while (i < g->list->count && (!g->made[i] || p[i].section == current)) i++;
  return i;
}

static void write_link(const page *g, const shot *section) {
  fprintf(g->file, "<a href=\"#%d\">%s</a>\n", section_number(section), section->heading);
  for (int i = 0; section->sheet && i < GALLERY_SHEETS; i++)
    if (strcmp(section->sheet, gallery_sheets[i].id) == 0 && g->sheets[i])
      fprintf(g->file, "(<a href=\"%s.png\">on one sheet</a>)\n", section->sheet);
}

static void write_page(const page *g) {
  const picture *p = g->list->pictures;
  fputs("<!doctype html>\n<meta charset=\"utf-8\">\n<title>sozai</title>\n<style>\n"
        "body { font: 15px sans-serif; margin: 2em; background: #f4f3f1; color: #333 }\n"
        "main { display: grid; gap: 1.5em;\n"
        "  grid-template-columns: repeat(auto-fill, minmax(var(--column), 1fr)) }\n"
        "nav { line-height: 1.8 } nav a { margin-left: 1em } h2 { margin-top: 2em }\n"
        "figure { margin: 0 } img { width: 100%; display: block }\n"
        "figcaption { padding: .4em 0 } code { font-size: 80%; color: #777 }\n"
        "</style>\n<h1>sozai</h1>\n"
        "<p>Under each picture is the command that draws it.</p>\n<nav>\n",
        g->file);
  const shot *section = NULL;
  for (uint32_t i = next_section(g, 0, NULL); i < g->list->count; i = next_section(g, i, section)) {
    section = p[i].section;
    write_link(g, section);
  }
  fputs("</nav>\n", g->file);
  section = NULL;
  for (uint32_t i = 0; i < g->list->count; i++) {
    if (!g->made[i]) continue;
    if (p[i].section != section) {
      if (section) fputs("</main>\n", g->file);
      begin_section(g, &p[i]);
    }
    section = p[i].section;
    write_picture(g, &p[i]);
  }
  if (section) fputs("</main>\n", g->file);
}

bool gallery_index_write(const easel *e, const picture_list *list, const bool *made,
                         const bool *sheets, failure *why) {
  char path[PICTURE_PATH];
  output_file o;
  if (!picture_path(path, e, "index.html", why) || !output_begin(&o, path, why)) return false;
  page g = {e, list, made, sheets, fopen(o.writing, "w")};
  bool ok = g.file != NULL;
  if (ok) {
    write_page(&g);
    ok = !ferror(g.file);
    ok = fclose(g.file) == 0 && ok;
  }
  if (ok) return output_commit(&o, why);
  fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(errno));
  output_discard(&o);
  return false;
}
