/* SPDX-License-Identifier: Apache-2.0 */
#include "fiber.h"

#include "parallel.h"

sozai_buffer buffer_of(const mesh *m) {
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_MESH,
                        .dims = {m->point_count, m->triangle_count},
                        .points = m->points,
                        .indices = m->indices};
}

int32_t grow_buffer(const sozai_host *host, const char *preset, const sozai_buffer *hull,
                    const char *text, sozai_geometry **out) {
  char copy[1024];
  sozai_value values[48];
  uint32_t count = values_of(text, copy, values, 47);
  const char *id = hull && hull->kind == SOZAI_BUFFER_POINTS ? "hull_points" : "hull";
  if (hull) values[count++] = (sozai_value){.id = id, .kind = SOZAI_KIND_BUFFER, .buffer = hull};
  return geometry()->grow(host, "fiber", preset, values, count, out);
}

int32_t grow_code(const sozai_host *host, const mesh *hull, const char *values,
                  sozai_geometry **out) {
  sozai_buffer b = buffer_of(hull);
  return grow_buffer(host, NULL, &b, values, out);
}

static int32_t run_parallel(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                            void *context) {
  (void)user;
  parallel_for(2, count, task, context);
  return 0;
}

sozai_host two_threads(void) {
  return (sozai_host){.size = sizeof(sozai_host), .parallel = run_parallel};
}

sozai_geometry *grow(const mesh *hull, const char *values) {
  sozai_geometry *g = NULL;
  sozai_host host = two_threads();
  int32_t r = grow_code(&host, hull, values, &g);
  return expect_grown(r, g);
}

mesh hull_of(const char *name) {
  mesh m;
  failure why;
  assert_true(hull_make_named(&m, name, &why));
  return m;
}

mesh box_of(double x, double y, double z) {
  mesh m;
  failure why;
  const double size[3] = {x, y, z};
  assert_true(hull_make_box(&m, size, 1, &why));
  return m;
}

const sozai_curves *curves_of(const sozai_geometry *g) {
  const sozai_curves *c = NULL;
  assert_int_equal(geometry()->curves(g, NULL, &c), SOZAI_OK);
  return c;
}
