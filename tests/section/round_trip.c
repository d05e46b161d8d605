/* SPDX-License-Identifier: Apache-2.0
 *
 * A grown section is drawn as a picture, the picture is read back as the
 * section, and boards of the two woods are compared: what is lost is what
 * pixels lose.
 */
#include "photograph.h"

#include <math.h>
#include <stdlib.h>

typedef struct {
  double rms, mean, deviation; /* of albedo; the grown board's own deviation */
} likeness;

/* Boards of log space: faces square to z at several distances and heights, to `tall` up and down.
 */
static void board(points *p, double footprint, double reach, double tall) {
  points_clear(p);
  for (int i = 0; i < 20000; i++) {
    double x = reach * (2 * uniform() - 1), y = tall * (2 * uniform() - 1);
    double z = (i & 3) * 0.15 * reach + 2;
    points_add(p, 0.8 * x, y, z, 'z', footprint);
  }
}

/* The log of the picture stands with its found pith at 0: dx, dz is how far off
 * that is. */
static likeness compare(sozai_texture *grown, sozai_texture *pictured, points *p, double dx,
                        double dz) {
  points_ask(p, grown);
  float *kept[3];
  for (int c = 0; c < 3; c++) {
    kept[c] = p->out[ALBEDO + c];
    p->out[ALBEDO + c] = malloc(p->room * sizeof(float));
  }
  for (uint32_t i = 0; i < p->count; i++) {
    p->in[0][i] -= (float)dx;
    p->in[2][i] -= (float)dz;
  }
  points_ask(p, pictured);
  double square = 0, mean = 0, level = 0, spread = 0, n = 3.0 * p->count;
  for (int c = 0; c < 3; c++) {
    for (uint32_t i = 0; i < p->count; i++) {
      double a = (double)kept[c][i], d = (double)p->out[ALBEDO + c][i] - a;
      square += d * d / n;
      mean += d / n;
      if (c == 1) {
        level += a / p->count;
        spread += a * a / p->count;
      }
    }
    free(kept[c]);
  }
  return (likeness){sqrt(square), mean, sqrt(spread - level * level)};
}

/* A picture is taken for the wood's colour on every face, whatever end grain it was taken of, and
 * knows nothing of how that drifts along the stem. */
#define FACE "end_shade=0; ray_shade=0; drift=0; "

/* tall: mm, within the bolt whose vessels are those of the picture; a stem whose grain does not
 * part is one bolt. */
static void one(const char *preset, const char *parameters, const char *how, double tall,
                double rms_most) {
  photograph q = {preset, parameters, 3000, 3000, 240, 0.5, 0.5, 0, 0, 0, 0};
  /* 0.08 mm a pixel, the wood fills the picture; or a disc on a ground */
  int found = how[0] == 'f';
  if (found) q.years = 100.0 / 2.5, q.background = 0.95f;
  static int pictures;
  char name[32];
  snprintf(name, sizeof name, "grown%d.exr", pictures++);
  const char *path = photograph_take(&q, name);
  char text[1024];
  snprintf(text, sizeof text, "%s; section_width=240; section=%s%s", parameters, path,
           found ? "" : "; section_pith=given; section_rim=none");
  sozai_texture *grown = section_make(preset, parameters), *pictured = section_make(preset, text);
  double dx = 0, dz = 0;
  if (found) {
    assert_int_equal(sscanf(section_log(), "section: pith found at s = %lf, t = %lf", &dx, &dz), 2);
    dx = (dx - 0.5) * 240;
    dz = (dz - 0.5) * 240;
    print_message("%-10s pith off by %.2f, %.2f mm\n", preset, dx, dz);
  }
  points p = {0};
  for (int k = 0; k < 3; k++) {
    static const double footprint[] = {0.15, 0.5, 3};
    board(&p, footprint[k], 70, tall);
    likeness l = compare(grown, pictured, &p, dx, dz);
    print_message("%-10s %-5s footprint %-4g mm: rms %.4f, mean %+.5f (the board varies by %.4f)\n",
                  preset, how, footprint[k], l.rms, l.mean, l.deviation);
    assert_true(l.rms < rms_most && fabs(l.mean) < 0.002);
  }
  points_free(&p);
  textures->destroy(grown);
  textures->destroy(pictured);
}

static void given(void **state) {
  (void)state;
  one("keyaki", FACE "grain=spiral; ring_width=2.5", "given", 110, 0.025);
  one("sugi", FACE "grain=wavy; ring_width=2.5", "given", 500, 0.025);
  one("onigurumi", FACE "grain=compound; ring_width=2.5", "given", 16, 0.025);
}

static void found(void **state) {
  (void)state;
  one("keyaki", FACE "grain=spiral; ring_width=2.5; section_wobble=0.06", "found", 110, 0.035);
  one("sugi", FACE "grain=straight; ring_width=2.5; section_wobble=0.06", "found", 500, 0.035);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(given), cmocka_unit_test(found)};
  return cmocka_run_group_tests(tests, section_setup, section_teardown);
}
