/* SPDX-License-Identifier: Apache-2.0 */
#include "fiber.h"

#include <stdlib.h>
#include "clock.h"
#include "hulls.h"
#include "parallel.h"
#include "pin.h"

static int32_t on_two(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                      void *context) {
  (void)user;
  parallel_for(2, count, task, context);
  return 0;
}

bool fiber_job_open(fiber_job *f, const plugin *p, failure *why) {
  f->table = p->entry->get_factory(SOZAI_GEOMETRY_1);
  if (!f->table) return fail(why, EXIT_FAILURE, "the plugin has no %s", SOZAI_GEOMETRY_1);
  return hull_make_named(&f->hull, "bunny", why);
}

void fiber_job_close(fiber_job *f) { mesh_free(&f->hull); }

bool fiber_job_run(void *context, double *ns, failure *why) {
  const fiber_job *f = context;
  const sozai_buffer b = {.size = sizeof b,
                          .kind = SOZAI_BUFFER_MESH,
                          .dims = {f->hull.point_count, f->hull.triangle_count},
                          .points = f->hull.points,
                          .indices = f->hull.indices};
  const sozai_value values[] = {
      {.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &b},
      {.id = "iterations", .kind = SOZAI_KIND_INT, .number = {f->fitted ? 1000 : 0}}};
  const sozai_host host = {.size = sizeof host, .parallel = f->threads ? on_two : NULL};
  sozai_geometry *g = NULL;
  if (f->threads) pin_release();
  double begin = f->threads ? wall_ns() : thread_ns();
  int32_t code = f->table->grow(&host, "fiber", NULL, values, 2, &g);
  *ns = (f->threads ? wall_ns() : thread_ns()) - begin;
  if (f->threads) pin_to(0);
  if (code != SOZAI_OK) return fail(why, EXIT_FAILURE, "fiber: %s", f->table->last_error());
  f->table->release(g);
  return true;
}
