/* SPDX-License-Identifier: Apache-2.0
 *
 * Pith and rim are found in photographs where both are known.
 */
#include "photograph.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where the log says it found them. */
static void read_log(double *s, double *t, double *rim, char *how) {
  if (sscanf(section_log(), "section: pith found at s = %lf, t = %lf; rim: %31[^,], %lf", s, t, how,
             rim) != 4) {
    fail_msg("the log says: %s", section_log());
  }
}

/* Mean radius of the surface of a year in the reference section. */
static double mean_radius(const photograph *q) {
  sozai_texture *t = section_make(q->preset, q->parameters);
  double sum = 0;
  for (int k = 0; k < 360; k++) {
    float year = (float)q->years, angle = (float)(k * 6.2831853 / 360), y = 0, r;
    assert_int_equal(woods->ring_radius(t, 1, &year, &angle, &y, &r), SOZAI_OK);
    sum += (double)r / 360;
  }
  textures->destroy(t);
  return sum;
}

static const photograph cases[] = {
    {"keyaki", "", 1024, 1024, 300, 0.5, 0.5, 40, 0.8f, 0, 0},
    {"keyaki", "seed=7; section_wobble=0.08", 1024, 900, 300, 0.44, 0.55, 40, 0.02f, 0.1f, 0},
    {"sugi", "seed=3", 900, 1200, 260, 0.55, 0.46, 30, 0.9f, 0.2f, 3},
    {"mizunara", "seed=5", 2048, 2048, 400, 0.47, 0.52, 70, 0.6f, 0.1f, 2},
    {"hinoki", "seed=9", 640, 480, 320, 0.5, 0.5, 40, 0.03f, 0.1f, 1},
    {"onigurumi", "seed=2", 1024, 1024, 280, 0.52, 0.5, 38, 0.95f, 0.05f, 0},
    /* no background: the wood fills the picture; and the pith near a corner */
    {"sugi", "seed=4", 1024, 1024, 200, 0.4, 0.45, 0, 0, 0.05f, 0},
    {"keyaki", "seed=8", 1200, 800, 240, 0.12, 0.8, 0, 0, 0.05f, 0},
};

static void pith_and_rim(void **state) {
  (void)state;
  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
    const photograph *q = &cases[i];
    char text[1024], how[32], name[32];
    snprintf(name, sizeof name, "log%u.%s", i, i % 2 ? "jpg" : "png");
    snprintf(text, sizeof text, "section_width=%g; section=%s", q->mm, photograph_take(q, name));
    sozai_texture *t = section_make(NULL, text);
    double s, v, rim;
    read_log(&s, &v, &rim, how);
    double tall = q->mm * q->height / q->width;
    double off = hypot((s - q->pith_s) * q->mm, (v - q->pith_t) * tall);
    print_message("%-10s pith off by %.2f mm of %g", q->preset, off, q->mm);
    assert_true(off < 0.01 * q->mm);
    if (q->years > 0) {
      /* the plugin keeps a margin of 1.5 % from the background */
      double want = 0.985 * mean_radius(q);
      print_message("; rim %s at %.2f mm, %.2f wanted", how, rim, want);
      assert_string_equal(how, "found");
      assert_true(fabs(rim - want) < 0.012 * want);
    } else {
      assert_string_equal(how, "the largest circle");
    }
    print_message("\n");
    textures->destroy(t);
  }
}

/* Nothing of the background is ever seen: it is green, which no wood is. */
static void no_background(void **state) {
  (void)state;
  enum { SIDE = 512 };
  photograph q = cases[1];
  q.width = q.height = SIDE;
  q.background = 0.5f;
  q.noise = 0;
  char text[1024];
  const char *path = photograph_take(&q, "plain.exr");
  /* the same picture with a green ground: grey of exactly one half is ground */
  points p = {0};
  snprintf(text, sizeof text, "section_width=%g; fibre_brightness=0; grain=compound; section=%s",
           q.mm, path);
  sozai_texture *t = section_make("keyaki", text);
  for (int i = 0; i < 40000; i++) {
    points_add(&p, 500 * uniform() - 250, 300 * uniform(), 500 * uniform() - 250, "xyz"[i % 3],
               i % 2 ? 0 : 0.5);
  }
  points_ask(&p, t);
  int grey = 0;
  for (uint32_t i = 0; i < p.count; i++) {
    double r = (double)p.out[ALBEDO][i], b = (double)p.out[ALBEDO + 2][i];
    /* keyaki has three times more red than blue; the ground has as much of both */
    if (b > 0.75 * r) grey++;
  }
  print_message("%d of %u points show the background\n", grey, p.count);
  assert_int_equal(grey, 0);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(pith_and_rim),
                                     cmocka_unit_test(no_background)};
  return cmocka_run_group_tests(tests, section_setup, section_teardown);
}
