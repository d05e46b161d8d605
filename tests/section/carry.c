/* SPDX-License-Identifier: Apache-2.0
 *
 * The grain carries the picture: what is seen at a point is the picture at the
 * place of the point's fibre in the reference section.
 */
#include "section.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIDE 256

/* Red rises to the right, green downwards: a colour is a place. */
static const char *chart(void) {
  const char *path = section_path("chart.exr");
  float *rgb = malloc(sizeof(float) * 3 * SIDE * SIDE);
  for (int j = 0; j < SIDE; j++) {
    for (int i = 0; i < SIDE; i++) {
      float *p = rgb + 3 * (j * SIDE + i);
      p[0] = ((float)i + 0.5f) / SIDE;
      p[1] = ((float)j + 0.5f) / SIDE;
      p[2] = 0.25f;
    }
  }
  assert_int_equal(host_images_write(path, SIDE, SIDE, rgb), 0);
  free(rgb);
  return path;
}

#define PLAIN "fibre_brightness=0; section_pith=given; section_rim=none; section_width=400; "

static void by_the_grain(void **state) {
  (void)state;
  static const char *const grains[] = {"straight", "spiral", "wavy", "interlocked", "compound"};
  const char *path = chart();
  for (unsigned g = 0; g < 5; g++) {
    char text[1024];
    snprintf(text, sizeof text,
             PLAIN "section_pith_s=0.45; section_pith_t=0.55; grain=%s; section=%s", grains[g],
             path);
    sozai_texture *t = section_make("keyaki", text);
    points p = {0};
    for (int i = 0; i < 4000; i++) {
      double a = 6.2831853 * uniform(), r = 5 + 120 * uniform();
      points_add(&p, r * cos(a), 2000 * uniform() - 1000, r * sin(a), "xyz"[i % 3], 0);
    }
    points_ask(&p, t);
    double worst = 0;
    for (uint32_t i = 0; i < p.count; i++) {
      double s = 0.45 + (double)p.out[REFERENCE][i] / 400;
      double v = 0.55 + (double)p.out[REFERENCE + 1][i] / 400;
      double d = fmax(fabs((double)p.out[ALBEDO][i] - s), fabs((double)p.out[ALBEDO + 1][i] - v));
      worst = fmax(worst, fmax(d, fabs((double)p.out[ALBEDO + 2][i] - 0.25)));
      assert_true(p.out[VESSEL][i] == 0.0f);
    }
    print_message("%s: colour is the fibre's place to %.2g of the picture, %.3f mm\n", grains[g],
                  worst, worst * 400);
    assert_true(worst < 1.5e-3);
    points_free(&p);
    textures->destroy(t);
  }
}

/* At y = 0 the log is the photograph, seen from above: x to the right, z down. */
static void the_right_way_up(void **state) {
  (void)state;
  char text[1024];
  snprintf(text, sizeof text, PLAIN "section=%s", chart());
  sozai_texture *t = section_make(NULL, text);
  points p = {0};
  points_add(&p, 100, 0, 0, 'y', 0);
  points_add(&p, 0, 0, 100, 'y', 0);
  points_ask(&p, t);
  assert_true(fabsf(p.out[ALBEDO][0] - 0.75f) < 2e-3f &&
              fabsf(p.out[ALBEDO + 1][0] - 0.5f) < 2e-3f);
  assert_true(fabsf(p.out[ALBEDO][1] - 0.5f) < 2e-3f &&
              fabsf(p.out[ALBEDO + 1][1] - 0.75f) < 2e-3f);
  points_free(&p);
  textures->destroy(t);
}

/* Beyond the rim the picture is folded back: nothing jumps, and nothing is seen
 * from beyond it. */
static void fold(void **state) {
  (void)state;
  char text[1024];
  snprintf(text, sizeof text,
           PLAIN
           "section_rim=given; section_radius=100; undulation=0; section_wobble=0; section=%s",
           chart());
  sozai_texture *t = section_make(NULL, text);
  points p = {0};
  for (int i = 0; i <= 4000; i++) points_add(&p, 0.8 * i * 0.1, 0, 0.6 * i * 0.1, 'y', 0);
  points_ask(&p, t);
  double most = 0, farthest = 0;
  for (uint32_t i = 0; i < p.count; i++) {
    double ds = (double)p.out[ALBEDO][i] - 0.5, dt = (double)p.out[ALBEDO + 1][i] - 0.5;
    double r = hypot(ds, dt) * 400, at = i * 0.1, m = fmod(at, 200);
    double want = m > 100 ? 200 - m : m;
    farthest = fmax(farthest, r);
    most = fmax(most, fabs(r - want));
  }
  print_message("along a radius of 400 mm, rim at 100: folded to %.3f mm, farthest %.3f mm\n", most,
                farthest);
  assert_true(most < 0.6 && farthest < 100.5);
  points_free(&p);
  textures->destroy(t);
}

/* A host's own service is asked, and asked for what is wanted alone. */
static void asked(void **state) {
  (void)state;
  char text[1024];
  snprintf(text, sizeof text, PLAIN "section=%s", chart());
  sozai_texture *t = section_make(NULL, text);
  float x[100] = {0}, y[100] = {0}, z[100] = {0}, a[100];
  float *out[OUTS] = {0};
  for (int i = 0; i < 100; i++) x[i] = (float)i;
  sozai_batch b = {
      .size = sizeof b, .count = 100, .point = {x, y, z}, .out = out, .out_count = OUTS};
  uint64_t before = host_images_lookups();
  out[TIME] = a;
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
  out[TIME] = NULL;
  out[REFERENCE] = a;
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
  assert_int_equal(host_images_lookups(), before);
  out[REFERENCE] = NULL;
  out[ALBEDO] = a;
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
  assert_int_equal(host_images_lookups(), before + 100);
  textures->destroy(t);
}

/* The same bits whatever the instruction set and the batch. */
static void same_bits(void **state) {
  (void)state;
  static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512", "neon"};
  char text[1024];
  snprintf(text, sizeof text,
           "section_pith=given; section_rim=given; section_radius=120; "
           "section_width=300; section_detail=1.5; grain=compound; section=%s",
           chart());
  float *first[OUTS] = {0};
  int tried = 0;
  for (unsigned k = 0; k < 5; k++) {
    setenv("SOZAI_CPU", sets[k], 1);
    sozai_texture *t = section_wood("keyaki", text);
    unsetenv("SOZAI_CPU");
    if (!t) continue;
    points p = {0};
    for (int i = 0; i < 20000; i++) {
      uint32_t h = (uint32_t)i * 2654435761u;
      points_add(&p, (double)(h & 1023) / 4 - 128, (double)(h >> 10 & 1023), (double)(h >> 20) / 32,
                 "xyz"[i % 3], i % 7 ? 0.02 * (i % 50) : 0);
    }
    points_ask(&p, t);
    for (int c = 0; c < OUTS; c++) {
      if (!tried) {
        first[c] = malloc(p.count * sizeof(float));
        memcpy(first[c], p.out[c], p.count * sizeof(float));
      }
      assert_memory_equal(first[c], p.out[c], p.count * sizeof(float));
    }
    tried++;
    points_free(&p);
    textures->destroy(t);
  }
  for (int c = 0; c < OUTS; c++) free(first[c]);
  print_message("%d instruction sets, 20,000 points each\n", tried);
  assert_true(tried >= 2);
}

static void refusals(void **state) {
  (void)state;
  assert_null(section_wood(NULL, "section=/nowhere/none.tif"));
  assert_non_null(
      strstr(textures->last_error(), "section: the host cannot read /nowhere/none.tif"));
  char text[1024];
  snprintf(text, sizeof text, "section=%s", chart());
  section_serve(0);
  assert_null(section_wood(NULL, text));
  assert_non_null(strstr(textures->last_error(), "section: a picture needs an image service"));
  section_serve(1);
  /* a picture without a stripe in it */
  float grey[3 * 64 * 64];
  for (int i = 0; i < 3 * 64 * 64; i++) grey[i] = 0.4f;
  const char *path = section_path("grey.exr");
  assert_int_equal(host_images_write(path, 64, 64, grey), 0);
  snprintf(text, sizeof text, "section=%s", path);
  assert_null(section_wood(NULL, text));
  assert_non_null(strstr(textures->last_error(), "no pith"));
  /* one pixel */
  path = section_path("one.exr");
  assert_int_equal(host_images_write(path, 1, 1, grey), 0);
  snprintf(text, sizeof text, "section_pith=given; section=%s", path);
  sozai_texture *t = section_make(NULL, text);
  points p = {0};
  points_add(&p, 30, 20, 10, 'z', 0.1);
  points_ask(&p, t);
  assert_true(fabsf(p.out[ALBEDO][0] - 0.4f) < 0.2f);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(by_the_grain), cmocka_unit_test(the_right_way_up),
      cmocka_unit_test(fold),         cmocka_unit_test(asked),
      cmocka_unit_test(same_bits),    cmocka_unit_test(refusals)};
  return cmocka_run_group_tests(tests, section_setup, section_teardown);
}
