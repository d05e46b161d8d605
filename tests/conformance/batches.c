/* SPDX-License-Identifier: Apache-2.0
 *
 * What evaluate takes: structs of other sizes, inputs that are missing, any
 * count; and that it writes what was asked for and nothing beside it.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "batch.h"

static plugin p;
static const sozai_texture_info *info;
static sozai_texture *texture;
static full_batch b, whole;

static int32_t evaluate(const sozai_batch *s) { return p.textures->evaluate(texture, s); }

static int same_as_whole(uint32_t count) {
  for (uint32_t o = 0; o < b.components; o++) {
    if (b.out[o] && memcmp(b.out[o], whole.out[o], count * sizeof(float)) != 0) return 0;
  }
  return 1;
}

static void every_count(void **unused) {
  (void)unused;
  batch_make(&whole, info, BATCH_MAX);
  assert_int_equal(evaluate(&whole.batch), SOZAI_OK);
  assert_int_equal(batch_unfit(&whole, BATCH_MAX), 0);
  for (uint32_t n = 0; n <= 70; n++) {
    batch_make(&b, info, n);
    assert_int_equal(evaluate(&b.batch), SOZAI_OK);
    assert_int_equal(batch_spilt(&b, n), 0);
    assert_int_equal(batch_unfit(&b, n), 0);
    assert_true(same_as_whole(n));
  }
}

static void nothing_to_do(void **unused) {
  (void)unused;
  sozai_batch empty = {.size = sizeof empty};
  assert_int_equal(evaluate(&empty), SOZAI_OK);
  empty.count = 5; /* points, but nothing wanted of them */
  assert_int_equal(evaluate(&empty), SOZAI_OK);
  batch_make(&b, info, 5);
  memset(b.out, 0, sizeof b.out);
  assert_int_equal(evaluate(&b.batch), SOZAI_OK);
  assert_int_equal(batch_spilt(&b, 0), 0);
}

static void wrong_sizes(void **unused) {
  (void)unused;
  batch_make(&b, info, 64);
  b.batch.size = 0;
  assert_int_equal(evaluate(&b.batch), SOZAI_ERROR_ARGUMENT);
  assert_non_null(strstr(p.textures->last_error(), "batch.size"));
  b.batch.size = 4;
  assert_int_equal(evaluate(&b.batch), SOZAI_ERROR_ARGUMENT);
  b.batch.size = sizeof(sozai_batch);
  b.batch.out = NULL;
  assert_int_equal(evaluate(&b.batch), SOZAI_ERROR_ARGUMENT);
  assert_non_null(strstr(p.textures->last_error(), "out"));
  assert_int_equal(batch_spilt(&b, 0), 0);
}

/* A struct of every smaller size: members past its end are zero, whatever
 * stands there. */
static void smaller_struct(void **unused) {
  (void)unused;
  for (uint32_t size = 8; size < sizeof(sozai_batch); size++) {
    batch_make(&b, info, 16);
    unsigned char cut[sizeof(sozai_batch)];
    memcpy(cut, &b.batch, sizeof cut);
    memset(cut + size, 0xff, sizeof cut - size);
    memcpy(cut, &size, sizeof size);
    sozai_batch s;
    memcpy(&s, cut, sizeof s);
    int32_t r = evaluate(&s);
    assert_int_equal(r, SOZAI_OK);
    /* without the whole of out_count nothing is wanted */
    if (size < offsetof(sozai_batch, reserved))
      assert_int_equal(batch_spilt(&b, 0), 0);
    else
      assert_true(same_as_whole(16));
  }
}

static void larger_struct(void **unused) {
  (void)unused;
  struct {
    sozai_batch known;
    uint64_t later[16];
  } grown;
  batch_make(&b, info, 16);
  memset(&grown, 0xff, sizeof grown);
  grown.known = b.batch;
  grown.known.size = sizeof grown;
  assert_int_equal(evaluate(&grown.known), SOZAI_OK);
  assert_true(same_as_whole(16));
}

static void fewer_and_more_outputs(void **unused) {
  (void)unused;
  for (uint32_t n = 0; n <= info->component_count; n++) {
    batch_make(&b, info, 33);
    b.batch.out_count = n;
    for (uint32_t o = n; o < b.components; o++) b.out[o] = NULL;
    float *short_list[COMPONENTS];
    for (uint32_t o = 0; o < COMPONENTS; o++) {
      short_list[o] = o < n ? b.out[o] : (float *)(uintptr_t)8; /* not to be read */
    }
    b.batch.out = short_list;
    assert_int_equal(evaluate(&b.batch), SOZAI_OK);
    assert_int_equal(batch_spilt(&b, 33), 0);
    assert_true(same_as_whole(33));
  }
  /* a host of a later revision, with more channels than there are */
  batch_make(&b, info, 33);
  float *longer[COMPONENTS + 8];
  for (uint32_t o = 0; o < COMPONENTS + 8; o++) longer[o] = (float *)(uintptr_t)8;
  memcpy(longer, b.out, info->component_count * sizeof *longer);
  b.batch.out = longer;
  b.batch.out_count = COMPONENTS + 8;
  assert_int_equal(evaluate(&b.batch), SOZAI_OK);
  assert_true(same_as_whole(33));
}

/* One channel of all, and one input taken away. */
static void missing_inputs(void **unused) {
  (void)unused;
  static const struct {
    uint32_t bit;
    size_t at;
    const char *name;
  } inputs[] = {{SOZAI_INPUT_POINT, offsetof(sozai_batch, point), "point"},
                {SOZAI_INPUT_NORMAL, offsetof(sozai_batch, normal), "normal"},
                {SOZAI_INPUT_LIGHT, offsetof(sozai_batch, light), "light"},
                {SOZAI_INPUT_LIGHT_COLOUR, offsetof(sozai_batch, light_colour), "light_colour"},
                {SOZAI_INPUT_VIEW, offsetof(sozai_batch, view), "view"},
                {SOZAI_INPUT_FOOTPRINT, offsetof(sozai_batch, footprint), "footprint"}};
  uint32_t refused = 0;
  for (uint32_t c = 0; c < info->channel_count; c++) {
    const sozai_channel *k = info->channels[c];
    for (size_t i = 0; i < sizeof inputs / sizeof *inputs; i++) {
      /* all three arrays, or the last one of them */
      for (int part = 0; part < (inputs[i].bit == SOZAI_INPUT_FOOTPRINT ? 1 : 2); part++) {
        batch_make(&b, info, 19);
        for (uint32_t o = 0; o < b.components; o++) {
          if (o < k->first || o >= k->first + k->components) b.out[o] = NULL;
        }
        const float **at = (const float **)(void *)((char *)&b.batch + inputs[i].at);
        if (part) at[2] = NULL;
        if (!part) memset(at, 0, (inputs[i].bit == SOZAI_INPUT_FOOTPRINT ? 1 : 3) * sizeof *at);
        int32_t r = evaluate(&b.batch);
        if (k->needs & inputs[i].bit) {
          assert_int_equal(r, SOZAI_ERROR_ARGUMENT);
          assert_int_equal(batch_spilt(&b, 0), 0);
          assert_int_equal(batch_unfit(&b, 19), 19 * k->components); /* none was written */
          if (!strstr(p.textures->last_error(), k->id) ||
              !strstr(p.textures->last_error(), inputs[i].name)) {
            fail_msg("%s without %s: %s", k->id, inputs[i].name, p.textures->last_error());
          }
          refused++;
        } else {
          if (r) fail_msg("%s without %s: %s", k->id, inputs[i].name, p.textures->last_error());
          assert_int_equal(batch_unfit(&b, 19), 0);
          assert_int_equal(batch_spilt(&b, 19), 0);
        }
      }
    }
  }
  print_message("%u missing inputs refused\n", refused);
  assert_true(refused > 0);
}

/* With several channels wanted, one of which lacks its input: none is written. */
static void all_or_nothing(void **unused) {
  (void)unused;
  batch_make(&b, info, 40);
  b.batch.light[0] = NULL;
  assert_int_equal(evaluate(&b.batch), SOZAI_ERROR_ARGUMENT);
  for (uint32_t o = 0; o < b.components; o++) b.out[o] = NULL;
  assert_int_equal(batch_spilt(&b, 0), 0);
}

/* Scattered, and in stretches of up to so many. */
static void active_mask(void **unused) {
  (void)unused;
  uint8_t active[BATCH_MAX];
  for (uint32_t n = 1; n <= BATCH_MAX; n += n < 20 ? 1 : n < 70 ? 7 : 159) {
    batch_make(&b, info, n);
    for (uint32_t i = 0, from = 0; i < n; i++) {
      int long_ones = n > 70 && n % 2;
      if (long_ones && i - from > mix64(from) % 120u) from = i;
      uint64_t draw = mix64(n * 1000 + (long_ones ? from : i));
      active[i] = (uint8_t)(draw % 3u ? 255u : 0u);
    }
    b.batch.active = active;
    assert_int_equal(evaluate(&b.batch), SOZAI_OK);
    for (uint32_t o = 0; o < b.components; o++) {
      for (uint32_t i = 0; i < n; i++) {
        if (active[i]) assert_memory_equal(&b.out[o][i], &whole.out[o][i], sizeof(float));
        if (!active[i]) assert_true(isnan(b.out[o][i]));
      }
    }
    assert_int_equal(batch_spilt(&b, n), 0);
  }
}

static int start(void **unused) {
  (void)unused;
  if (plugin_start(&p, SOZAI_TEST_PLUGIN)) return -1;
  info = p.textures->find("wood");
  texture = plugin_wood(&p, "keyaki", "compound");
  return texture ? 0 : -1;
}

static int stop(void **unused) {
  (void)unused;
  p.textures->destroy(texture);
  plugin_stop(&p);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_count),    cmocka_unit_test(nothing_to_do),
      cmocka_unit_test(wrong_sizes),    cmocka_unit_test(smaller_struct),
      cmocka_unit_test(larger_struct),  cmocka_unit_test(fewer_and_more_outputs),
      cmocka_unit_test(missing_inputs), cmocka_unit_test(all_or_nothing),
      cmocka_unit_test(active_mask)};
  return cmocka_run_group_tests(tests, start, stop);
}
