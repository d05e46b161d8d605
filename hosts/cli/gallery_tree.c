/* SPDX-License-Identifier: Apache-2.0 */
#include "gallery_tree.h"

#include <stddef.h>
#include <string.h>
#include "growth.h"
#include "tree_view.h"

bool gallery_is_tree(const shot *s) { return s->material && strcmp(s->material, "tree") == 0; }

static bool draw(session *g, const sozai_geometry_1 *table, const sozai_geometry *tree,
                 const gallery_tree *t, film *out, failure *why) {
  const shot *s = t->shot;
  const sozai_detail detail = {.size = sizeof detail, .level = GALLERY_TREE_LEVEL};
  const sozai_mesh *m = NULL;
  int32_t code = table->mesh(tree, &detail, &m);
  if (code != SOZAI_OK) return growth_failed(table, code, why);
  tree_view v = TREE_VIEW_DEFAULT;
  v.size[0] = s->width;
  v.size[1] = s->height;
  v.spp = t->spp;
  v.threads = t->threads;
  v.quiet = true;
  if (s->camera) v.camera = s->camera;
  if (s->zoom > 0) v.zoom = s->zoom;
  bool ok = tree_view_render(&v, m, g, out, why);
  table->release_mesh(m);
  return ok;
}

bool gallery_tree_render(session *g, const gallery_tree *t, film *out, failure *why) {
  const shot *s = t->shot;
  const sozai_geometry_1 *table = growth_table(g->plugin.entry, why);
  if (!table) {
    why->exit_code = EXIT_BAD_INPUT; /* a plugin that grows nothing is no failure of the gallery */
    return false;
  }
  size_t count = 0;
  while (count < SHOT_PARAMS && s->params[count]) count++;
  sozai_geometry *tree = NULL;
  if (!growth_grow(table, &g->host.abi, "tree", s->preset, s->params, count, NULL, &tree, why))
    return false;
  bool ok = draw(g, table, tree, t, out, why);
  table->release(tree);
  return ok;
}
