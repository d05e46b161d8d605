/* SPDX-License-Identifier: Apache-2.0
 * Whether every entry of the catalogue is plausible. */
#include <ctype.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "fiber/catalogue.h"

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
  const struct CMUnitTest tests[] = {cmocka_unit_test(entries)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
