/* SPDX-License-Identifier: Apache-2.0
 *
 * Where a smooth mesh turns away from the light: as the round thing it stands for, and not as its
 * triangles, which turn away one by one. */
#include "studio.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h> /* after failure.h: it has a macro of that name, fail */

#include "samples.h"

#define RADIUS 50.0f
enum { SIDES = 18, TALL = 8, RAYS = 40000 };

/* An upright tube with normals of a round one: or, inward, the hollow of one. */
static mesh tube(bool hollow) {
  mesh m;
  failure why = {0};
  assert_true(mesh_allocate(&m, (TALL + 1) * SIDES, 2 * TALL * SIDES, &why));
  float to = hollow ? -1 : 1;
  for (uint32_t i = 0; i <= TALL; i++)
    for (uint32_t k = 0; k < SIDES; k++) {
      float a = 6.2831853f * (float)k / SIDES;
      size_t at = 3 * (size_t)(i * SIDES + k);
      const float p[3] = {RADIUS * cosf(a), RADIUS * sinf(a), 40.0f * (float)i};
      const float n[3] = {to * cosf(a), to * sinf(a), 0};
      for (size_t c = 0; c < 3; c++) m.points[at + c] = p[c], m.normals[at + c] = n[c];
    }
  uint32_t *t = m.indices;
  for (uint32_t i = 0; i < TALL; i++)
    for (uint32_t k = 0; k < SIDES; k++) {
      uint32_t a = i * SIDES + k, b = i * SIDES + (k + 1) % SIDES;
      const uint32_t two[6] = {a, b, b + SIDES, a, b + SIDES, a + SIDES};
      for (int c = 0; c < 6; c++) *t++ = two[c];
    }
  return m;
}

typedef struct {
  render_job job;
  scene scene;
  studio studio;
  mesh mesh;
} place;

static void open_place(place *p, bool hollow) {
  failure why = {0};
  render_job_init(&p->job, NULL, NULL);
  p->mesh = tube(hollow);
  p->job.shape = SHAPE_GIVEN;
  p->job.given = &p->mesh; /* the scene's from here on */
  p->job.floor = false;
  p->job.light_azimuth = 0;
  p->job.light_elevation = 10;
  p->job.light_size = 0.5;
  assert_true(scene_open(&p->scene, &p->job, &why));
  studio_init(&p->studio, &p->job, &p->scene);
}

static void round_tube_has_a_straight_edge(void **state) {
  (void)state;
  place p;
  open_place(&p, false);
  unsigned seen = 0, dark = 0, lit = 0, away = 0, bulging = 0;
  for (uint32_t i = 0; i < RAYS; i++) {
    float u, v;
    sample_pair(7, i, PAIR_PIXEL, &u, &v);
    float a = 6.2831853f * u;
    vec from = {300 * cosf(a), 300 * sinf(a), 80 + 160 * v};
    hit h = scene_trace(&p.scene, from, (vec){-cosf(a), -sinf(a), 0});
    if (h.what != HIT_SHAPE) continue;
    float rise = vec_dot(h.normal, p.studio.light);
    bool key = studio_key(&p.studio, &p.scene, &h, 3, i) > 0;
    bulging += h.bulges;
    if (rise > 0.02f) seen++, dark += !key;
    if (rise < -0.02f) away++, lit += key;
  }
  scene_close(&p.scene);
  print_message("%u of %u places that face the light are dark, %u of %u that do not are lit\n",
                dark, seen, lit, away);
  assert_true(seen > RAYS / 3 && away > RAYS / 3 && bulging > RAYS / 2);
  assert_true(dark < seen / 500 && lit == 0);
}

/* What a hollow's triangles hide stays hidden: they are not lifted. */
static void hollow_is_not_lifted(void **state) {
  (void)state;
  place p;
  open_place(&p, true);
  unsigned seen = 0, bulging = 0, lit = 0;
  for (uint32_t i = 0; i < RAYS; i++) {
    float u, v;
    sample_pair(7, i, PAIR_PIXEL, &u, &v);
    float a = 6.2831853f * u;
    hit h = scene_trace(&p.scene, (vec){0, 0, 80 + 60 * v}, (vec){cosf(a), sinf(a), 0});
    assert_int_equal(h.what, HIT_SHAPE);
    seen++;
    bulging += h.bulges;
    lit += studio_key(&p.studio, &p.scene, &h, 3, i) > 0;
  }
  scene_close(&p.scene);
  /* the sun stands too low to reach in */
  print_message("%u places in a hollow: %u lifted, %u lit\n", seen, bulging, lit);
  assert_true(bulging == 0 && lit == 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(round_tube_has_a_straight_edge),
                                     cmocka_unit_test(hollow_is_not_lifted)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
