/* SPDX-License-Identifier: Apache-2.0 */
#include "tree.h"

#include <stdlib.h>
#include <string.h>
#include "clock.h"

static bool grow(const tree_job *t, sozai_geometry **out, failure *why) {
  const sozai_value values[] = {{.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {7}},
                                {.id = "foliage", .kind = SOZAI_KIND_CHOICE, .text = "full"}};
  return t->table->grow(NULL, "tree", t->preset, values, 2, out) == SOZAI_OK ||
         fail(why, EXIT_FAILURE, "tree %s: %s", t->preset, t->table->last_error());
}

bool tree_job_open(tree_job *t, const plugin *p, failure *why) {
  t->table = p->entry->get_factory(SOZAI_GEOMETRY_1);
  if (!t->table) return fail(why, EXIT_FAILURE, "the plugin has no %s", SOZAI_GEOMETRY_1);
  sozai_geometry *g = NULL;
  if (!grow(t, &g, why)) return false;
  sozai_table rows = {.size = sizeof rows};
  t->table->table(g, "statistics", &rows);
  t->branches = 1;
  for (uint32_t i = 0; rows.info && i < rows.info->column_count; i++)
    if (strstr(rows.info->columns[i].id, "_order")) t->branches += (double)rows.data[i];
  t->table->release(g);
  return true;
}

bool tree_job_run(void *context, double *ns, failure *why) {
  const tree_job *t = context;
  double begin = thread_ns();
  sozai_geometry *g = NULL;
  if (!grow(t, &g, why)) return false;
  const sozai_mesh *m = NULL;
  bool ok = !t->meshed || t->table->mesh(g, NULL, &m) == SOZAI_OK ||
            fail(why, EXIT_FAILURE, "tree %s: %s", t->preset, t->table->last_error());
  *ns = thread_ns() - begin;
  t->table->release_mesh(m);
  t->table->release(g);
  return ok;
}
