/* SPDX-License-Identifier: Apache-2.0 */
#include "gallery_picture.h"

#include <stdio.h>
#include <string.h>
#include "gallery_tree.h"
#include "job_options.h"
#include "output_file.h"

bool picture_path(char path[PICTURE_PATH], const easel *e, const char *name, failure *why) {
  int length = snprintf(path, PICTURE_PATH, "%s/%s", e->folder, name);
  return (length > 0 && length < PICTURE_PATH) ||
         fail(why, EXIT_BAD_INPUT, "'%s' is too long a path", e->folder);
}

bool picture_write(const easel *e, const film *f, const char *name, failure *why) {
  char path[PICTURE_PATH];
  output_file o;
  if (!picture_path(path, e, name, why) || !output_begin(&o, path, why)) return false;
  if (film_write_png(f, o.writing, &e->session->colour, &e->session->shown, 0, 8, why))
    return output_commit(&o, why);
  return output_failed(&o, why);
}

/* A plane has no edges but its own and shadows nothing, and its material is filtered: a few
 * samples of each pixel do, the fewer where all of it is as far away. */
uint32_t picture_samples(const easel *e, const picture *p) {
  const shot *s = &p->shot;
  if (!s->shape || strcmp(s->shape, "plane") != 0) return e->spp;
  bool straight = s->camera && strcmp(s->camera, "front") == 0;
  return straight ? (e->spp + 3) / 4 : (e->spp + 1) / 2;
}

static bool make_recipe(recipe *r, const picture *p, failure *why) {
  if (!recipe_open(r, shot_material(&p->shot), why)) return false;
  bool ok = !p->preset || recipe_set_preset(r, p->preset, why);
  for (int i = 0; ok && i < SHOT_PARAMS && p->shot.params[i]; i++)
    ok = recipe_set_pair(r, p->shot.params[i], why);
  if (!ok) recipe_free(r);
  return ok;
}

static bool render_texture(const easel *e, const picture *p, const sozai_texture *texture, film *f,
                           failure *why) {
  const shot *s = &p->shot;
  render_job job;
  render_job_init(&job, e->session->plugin.textures, texture);
  job.threads = e->threads;
  job.quiet = true;
  job.spp = picture_samples(e, p);
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

static picture_result draw_texture(const easel *e, const picture *p, film *f, failure *why) {
  const session *s = e->session;
  recipe r;
  if (!make_recipe(&r, p, why)) return PICTURE_FAILED;
  sozai_texture *texture = NULL;
  bool made = recipe_create(&r, s->plugin.textures, &s->host.abi, &texture, why);
  recipe_free(&r);
  if (!made) return why->exit_code == EXIT_BAD_INPUT ? PICTURE_LEFT_OUT : PICTURE_FAILED;
  bool ok = render_texture(e, p, texture, f, why);
  s->plugin.textures->destroy(texture);
  return ok ? PICTURE_MADE : PICTURE_FAILED;
}

static picture_result draw_tree(const easel *e, const picture *p, film *f, failure *why) {
  const gallery_tree tree = {&p->shot, picture_samples(e, p), e->threads};
  if (gallery_tree_render(e->session, &tree, f, why)) return PICTURE_MADE;
  return why->exit_code == EXIT_BAD_INPUT ? PICTURE_LEFT_OUT : PICTURE_FAILED;
}

picture_result picture_make(const easel *e, const picture *p, sheet_picture *small, failure *why) {
  film f;
  char file[sizeof p->name + 4];
  *small = (sheet_picture){0};
  picture_result r =
      gallery_is_tree(&p->shot) ? draw_tree(e, p, &f, why) : draw_texture(e, p, &f, why);
  if (r != PICTURE_MADE) return r;
  snprintf(file, sizeof file, "%s.png", p->name);
  bool ok = picture_write(e, &f, file, why) && (!p->shot.sheet || sheet_shrink(small, &f, why));
  film_free(&f);
  return ok ? PICTURE_MADE : PICTURE_FAILED;
}
