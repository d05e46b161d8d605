/* SPDX-License-Identifier: Apache-2.0
 *
 * cycles [ROUNDS [PLUGIN]]: load, use and unload the plugin that many times. Memory stays
 * as it was; valgrind and the leak sanitizer see the same program.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "batch.h"
#include "../resident.h"

static uint32_t rounds = 1000;
static const char *path = SOZAI_TEST_PLUGIN;
static full_batch b;

/* One batch, one single point, one refusal. */
static void use(const plugin *p, uint32_t round) {
  const sozai_texture_info *info = p->textures->find("wood");
  sozai_texture *t = plugin_wood(p, info->presets[round % info->preset_count]->id, NULL);
  assert_non_null(t);
  batch_make(&b, info, 37);
  assert_int_equal(p->textures->evaluate(t, &b.batch), SOZAI_OK);
  assert_int_equal(batch_unfit(&b, 37), 0);
  b.batch.count = 1;
  assert_int_equal(p->textures->evaluate(t, &b.batch), SOZAI_OK);
  sozai_texture *none = NULL;
  const sozai_value wrong = {.id = "object", .kind = SOZAI_KIND_TEXT, .text = "a table"};
  const sozai_value both[2] = {wrong, {.id = "seed", .kind = SOZAI_KIND_INT, .number = {-1}}};
  assert_int_equal(p->textures->create(NULL, "wood", NULL, both, 2, &none), SOZAI_ERROR_RANGE);
  p->textures->destroy(t);
}

static void cycles(void **unused) {
  (void)unused;
  long at[3] = {0}; /* after a fifth, three fifths, all */
  for (uint32_t i = 0; i < rounds; i++) {
    plugin p;
    assert_int_equal(plugin_start(&p, path), 0);
    use(&p, i);
    plugin_stop(&p);
    if (i == rounds / 5) at[0] = resident_kib();
    if (i == rounds / 5 * 3) at[1] = resident_kib();
  }
  at[2] = resident_kib();
  if (at[0] < 0) skip();
  long first = at[1] - at[0], second = at[2] - at[1];
  print_message("%u rounds; from a fifth to three fifths %ld kB more, from there to the end %ld\n",
                rounds, first, second);
  /* What is lost each round is lost in both; the heap may grow once for good. Two hundred
   * bytes a round would show; instrumented memory is another matter. */
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  if (rounds >= 1000) assert_true(first < 64 || second < 64);
#endif
}

int main(int argc, char **argv) {
  if (argc > 1) rounds = (uint32_t)strtoul(argv[1], NULL, 10);
  if (argc > 2) path = argv[2];
  const struct CMUnitTest tests[] = {cmocka_unit_test(cycles)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
