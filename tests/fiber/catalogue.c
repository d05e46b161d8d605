/* SPDX-License-Identifier: Apache-2.0
 * Whether every entry of the catalogue is plausible, and strands have the crimp that it names. */
#include <ctype.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "fiber/catalogue.h"
#include "fiber/strand.h"
#include "fiber/texture/arrangements.h"

enum { STRANDS = 600, VERTICES_MOST = 256 };
static double at[STRANDS][3 * VERTICES_MOST];

/* Of all strands, so many segments apart: mean product of the directions, or the root of the mean
 * square distance, mm. */
static double apart(uint32_t vertices, uint32_t lag, int distance) {
  double sum = 0;
  uint32_t n = 0;
  for (int s = 0; s < STRANDS; s++) {
    for (uint32_t i = 0; i + lag + 1 < vertices; i++, n++) {
      const double *p = at[s] + 3 * (size_t)i, *q = p + 3 * (size_t)lag;
      for (int c = 0; c < 3; c++)
        sum += distance ? (q[c] - p[c]) * (q[c] - p[c]) : (p[3 + c] - p[c]) * (q[3 + c] - q[c]);
    }
  }
  return distance ? sqrt(sum / n) : sum / n;
}

typedef struct {
  double waves, height; /* per cm; mm */
} crimp;

/* One wave on, directions are most alike again: the way there, along the strand and straight. */
static crimp crimp_of(const fiber_material *m) {
  strand_shape shape = {.vertices = m->vertices,
                        .seed = 5,
                        .length = m->length,
                        .phi_min = m->phi[0],
                        .phi_max = m->phi[1],
                        .theta_min = m->theta[0],
                        .theta_max = m->theta[1]};
  assert_true(m->vertices <= VERTICES_MOST);
  for (uint32_t s = 0; s < STRANDS; s++) strand_make(&shape, s, at[s]);
  uint32_t k = 1;
  double a[3] = {1, apart(m->vertices, 0, 0), apart(m->vertices, 1, 0)};
  for (int falls = 1; falls || a[2] > a[1];) { /* down to the trough, and up to the crest */
    assert_true(k < m->vertices / 2);
    a[0] = a[1], a[1] = a[2];
    a[2] = apart(m->vertices, ++k, 0);
    if (falls && a[2] > a[1]) falls = 0;
  }
  k--;
  double off = 0.5 * (a[0] - a[2]) / (a[0] - 2 * a[1] + a[2]); /* a parabola's crest */
  double below = apart(m->vertices, off < 0 ? k - 1 : k, 1), part = off < 0 ? 1 + off : off;
  double above = apart(m->vertices, off < 0 ? k : k + 1, 1);
  double along = (k + off) * m->length / (m->vertices - 1);
  double straight = below + part * (above - below);
  return (crimp){10 / straight, sqrt(along * along - straight * straight) / (2 * 3.14159265)};
}

/* As a helix of the crimp's numbers has it: entry.h. */
static void crimps(void **unused) {
  (void)unused;
  int named = 0;
  for (uint32_t i = 0; i < fiber_material_count; i++) {
    const fiber_material *m = fiber_materials[i];
    if (m->crimp <= 0) continue;
    named++;
    double c = 10 / m->crimp / (2 * 3.14159265), r = m->crimp_height;
    double step = m->length / (m->vertices - 1) * 180 / 3.14159265 / (r * r + c * c);
    double theta = 0.5 * (m->theta[0] + m->theta[1]), phi = 0.5 * (m->phi[0] + m->phi[1]);
    crimp grown = crimp_of(m);
    print_message("%-17s theta %.1f of %.1f, phi %.1f of %.1f; %.2f waves a cm of %.2f, %.3f mm "
                  "high of %.3f\n",
                  m->id, theta, r * step, phi, c * step, grown.waves, m->crimp, grown.height, r);
    assert_true(fabs(theta - r * step) < 0.2 && fabs(phi - c * step) < 0.2);
    assert_true(fabs(grown.waves / m->crimp - 1) < 0.06 && fabs(grown.height / r - 1) < 0.06);
    assert_true(r <= 10 / m->crimp / 8); /* else the texture's would be lower */
    /* the texture's preset of that name has the same */
    for (uint32_t k = 0; k < fiber_arrangement_count; k++) {
      const fiber_arrangement *a = &fiber_arrangements[k];
      if (strcmp(a->id, m->id) == 0) assert_true(a->crimp <= 0 && a->crimp_height <= 0);
    }
  }
  assert_int_equal(named, 5);
}

static void entries(void **unused) {
  (void)unused;
  assert_true(fiber_material_count >= 15);
  for (uint32_t i = 0; i < fiber_material_count; i++) {
    const fiber_material *m = fiber_materials[i];
    for (const char *c = m->id; *c; c++) assert_true(islower(*c) || *c == '_');
    for (uint32_t k = 0; k < i; k++) assert_string_not_equal(m->id, fiber_materials[k]->id);
    assert_ptr_equal(fiber_material_find(m->id), m);
    assert_true(strlen(m->label) > 3 && strlen(m->doc) > 10 && strlen(m->source) > 10);
    /* a year in every source */
    const char *year = strpbrk(m->source, "12");
    assert_non_null(strstr(m->source, "19")   ? strstr(m->source, "19")
                    : strstr(m->source, "20") ? strstr(m->source, "20")
                                              : strstr(m->source, "figures"));
    assert_non_null(year);
    assert_true(m->length >= 1 && m->length <= 300);
    assert_true(m->diameter >= 3 && m->diameter <= 400);
    assert_true(m->length * 1000 / m->diameter > 100); /* a fibre: slender */
    assert_true(m->length_spread >= 0 && m->length_spread <= 0.7);
    assert_true(m->diameter_spread >= 0 && m->diameter_spread <= 0.6);
    assert_true(m->taper >= 0 && m->taper <= 1 && m->flatness > 0 && m->flatness <= 1);
    assert_true(m->vertices >= 8 && m->vertices <= 1024);
    assert_true(m->phi[0] <= m->phi[1] && m->theta[0] <= m->theta[1]);
    assert_true(m->theta[1] < 45); /* else the polyline shows */
    assert_true(m->packing > 0 && m->packing < 0.5 && m->density > 0.2 && m->density < 3);
    assert_true(m->share_2 >= 0 && m->share_2 < 0.6 && m->colour_spread >= 0 &&
                m->colour_spread < 0.4);
    assert_true(m->roughness >= 2 && m->roughness <= 30 && m->tilt >= 0 && m->tilt <= 5);
    assert_true(m->index > 1.4 && m->index < 1.7);
  }
  assert_null(fiber_material_find("nothing"));
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(entries), cmocka_unit_test(crimps)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
