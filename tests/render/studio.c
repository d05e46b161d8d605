/* SPDX-License-Identifier: Apache-2.0
 *
 * Light that nothing is in the way of, against the same scene asked by rays. */
#include "studio.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h> /* after failure.h: it has a macro of that name, fail */

enum { SAMPLES = 1 << 15 };

static const vec normals[] = {{0, 0, 1},         {0, 0, -1},       {1, 0, 0},
                              {0.6f, 0, 0.8f},   {0, 0.8f, -0.6f}, {0.48f, 0.64f, 0.6f},
                              {-0.96f, 0, 0.28f}};
enum { NORMALS = sizeof normals / sizeof normals[0] };

/* A ball, from which rays see all there is, and which is told so or not. */
typedef struct {
  render_job job;
  scene scene;
  studio studio;
} place;

static void open_place(place *p, bool floor) {
  failure why = {0};
  render_job_init(&p->job, NULL, NULL);
  p->job.shape = SHAPE_SPHERE;
  p->job.size[0] = 100;
  p->job.floor = floor;
  p->job.sky = 1.3;
  p->job.light_size = 12;
  assert_true(scene_open(&p->scene, &p->job, &why));
  studio_init(&p->studio, &p->job, &p->scene);
}

static hit on_ball(vec n) {
  hit h = {.what = HIT_SHAPE, .normal = n, .geometric = n, .point = vec_scale(50, n)};
  return h;
}

static vec mean_fill(place *p, vec n, bool told) {
  double sum[3] = {0};
  hit h = on_ball(n);
  p->scene.convex = told;
  for (uint32_t i = 0; i < SAMPLES; i++) {
    vec v = studio_fill(&p->studio, &p->scene, &h, 5, i);
    sum[0] += (double)v.x, sum[1] += (double)v.y, sum[2] += (double)v.z;
  }
  return vec_of(sum[0] / SAMPLES, sum[1] / SAMPLES, sum[2] / SAMPLES);
}

static void fill_is_its_mean(void **state) {
  (void)state;
  float worst = 0;
  for (int floor = 0; floor < 2; floor++) {
    place p;
    open_place(&p, floor);
    for (int k = 0; k < NORMALS; k++) {
      vec sampled = mean_fill(&p, normals[k], false), closed = mean_fill(&p, normals[k], true);
      float off = vec_length(vec_sub(sampled, closed)) / vec_length(sampled);
      print_message("%s normal %5.2f %5.2f %5.2f: by rays %.5f %.5f %.5f, closed %.5f %.5f %.5f\n",
                    floor ? "floor" : "sky  ", (double)normals[k].x, (double)normals[k].y,
                    (double)normals[k].z, (double)sampled.x, (double)sampled.y, (double)sampled.z,
                    (double)closed.x, (double)closed.y, (double)closed.z);
      worst = fmaxf(worst, off);
    }
    scene_close(&p.scene);
  }
  print_message("worst %.6f\n", (double)worst);
  assert_true(worst < 5e-4f);
}

/* Also where the light is partly below the horizon. */
static void key_is_the_same(void **state) {
  (void)state;
  place p;
  open_place(&p, true);
  unsigned differ = 0, partly = 0, sunk = 0;
  for (int k = 0; k < 400; k++) {
    float turn = 6.2831853f * (float)k / 400;
    vec n = vec_add(vec_scale(cosf(turn), p.studio.light), vec_scale(sinf(turn), p.studio.light_s));
    hit h = on_ball(vec_unit(n));
    float lit = 0;
    for (uint32_t i = 0; i < 64; i++) {
      p.scene.convex = true;
      float told = studio_key(&p.studio, &p.scene, &h, 9, i);
      p.scene.convex = false;
      differ += told != studio_key(&p.studio, &p.scene, &h, 9, i);
      lit += told;
    }
    partly += lit > 0 && lit < 64;
    sunk += lit > 0 && vec_dot(h.normal, p.studio.light) < 0;
  }
  scene_close(&p.scene);
  print_message(
      "%u of 25600 differ; %u places see a part of the light, %u of them not its middle\n", differ,
      partly, sunk);
  assert_int_equal(differ, 0);
  assert_true(partly > 8 && sunk > partly / 3);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(fill_is_its_mean),
                                     cmocka_unit_test(key_is_the_same)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
