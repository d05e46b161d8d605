/* SPDX-License-Identifier: Apache-2.0
 *
 * Where a slider should end, as the header has it of soft ranges: nothing that a preset or a
 * default is made with lies beyond it.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#include "plugin.h"

static unsigned looked_at, beyond;

static void look(const char *of, const char *preset, const sozai_parameter *q, const double *x) {
  int numbers = q->kind == SOZAI_KIND_FLOAT3 || q->kind == SOZAI_KIND_COLOUR ? 3 : 1;
  for (int i = 0; i < numbers; i++) {
    looked_at++;
    if (x[i] == q->hard_min) continue; /* a height far below all says that there is none */
    if (x[i] >= q->soft_min && x[i] <= q->soft_max) continue;
    beyond++;
    print_error("%s, %s: %s is %g, usually %g to %g\n", of, preset, q->id, x[i], q->soft_min,
                q->soft_max);
  }
}

static int has_range(const sozai_parameter *q) {
  return q->kind == SOZAI_KIND_FLOAT || q->kind == SOZAI_KIND_INT || q->kind == SOZAI_KIND_FLOAT3 ||
         q->kind == SOZAI_KIND_COLOUR;
}

static void look_at_all(const char *of, const sozai_parameter *const *parameters, uint32_t count,
                        const sozai_preset *const *presets, uint32_t preset_count) {
  for (uint32_t i = 0; i < count; i++) {
    const sozai_parameter *q = parameters[i];
    if (!has_range(q)) continue;
    look(of, "default", q, q->default_number);
    for (uint32_t k = 0; k < preset_count; k++) {
      for (uint32_t v = 0; v < presets[k]->value_count; v++) {
        const sozai_value *given = &presets[k]->values[v];
        if (strcmp(given->id, q->id) == 0) look(of, presets[k]->id, q, given->number);
      }
    }
  }
}

static void presets_in_reach(void **unused) {
  (void)unused;
  plugin p;
  assert_int_equal(plugin_start(&p, SOZAI_TEST_PLUGIN), 0);
  for (uint32_t i = 0; i < p.textures->count(); i++) {
    const sozai_texture_info *t = p.textures->info(i);
    look_at_all(t->id, t->parameters, t->parameter_count, t->presets, t->preset_count);
  }
  const sozai_geometry_1 *g = p.entry->get_factory(SOZAI_GEOMETRY_1);
  assert_non_null(g);
  for (uint32_t i = 0; i < g->count(); i++) {
    const sozai_generator_info *t = g->info(i);
    look_at_all(t->id, t->parameters, t->parameter_count, t->presets, t->preset_count);
  }
  plugin_stop(&p);
  print_message("%u of %u numbers of presets and defaults lie beyond their usual range\n", beyond,
                looked_at);
  assert_true(looked_at > 5000);
  assert_int_equal(beyond, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(presets_in_reach)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
