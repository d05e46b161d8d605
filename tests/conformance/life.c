/* SPDX-License-Identifier: Apache-2.0
 *
 * The ABI's life: entry, counted init, unknown ids, what create refuses, what
 * is described, and the values read back.
 */
#include <dlfcn.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "plugin.h"

static plugin p;
static const sozai_textures_1 *textures;
static const sozai_wood_1 *wood;
static const sozai_texture_info *info;

static int said(const char *word) { return strstr(textures->last_error(), word) != NULL; }

/* First of all, and last of all. */
static void outside_init(const char *when) {
  assert_null(p.entry->get_factory(SOZAI_TEXTURES_1));
  assert_null(p.entry->get_factory(SOZAI_WOOD_1));
  if (!textures) return;
  /* tables that a host kept in spite of their owner */
  sozai_texture *t = (sozai_texture *)(uintptr_t)1;
  assert_int_equal(textures->count(), 0);
  assert_null(textures->info(0));
  assert_null(textures->find("wood"));
  assert_int_equal(textures->create(NULL, "wood", NULL, NULL, 0, &t), SOZAI_ERROR_STATE);
  assert_null(t);
  assert_non_null(textures->last_error());
  print_message("refused %s: %s\n", when, textures->last_error());
}

static void counted_init(void **unused) {
  (void)unused;
  assert_int_equal(p.entry->abi_major, SOZAI_ABI_MAJOR);
  outside_init("before init");
  p.entry->deinit(); /* one too many does nothing */
  assert_int_equal(p.entry->init(NULL), SOZAI_OK);
  assert_int_equal(p.entry->init(ALONE), SOZAI_OK);
  textures = p.entry->get_factory(SOZAI_TEXTURES_1);
  assert_non_null(textures);
  p.entry->deinit();
  assert_ptr_equal(p.entry->get_factory(SOZAI_TEXTURES_1), textures);
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "wood", NULL, NULL, 0, &t), SOZAI_OK);
  textures->destroy(t);
  p.entry->deinit();
  outside_init("after the last deinit");
  p.entry->deinit();
  outside_init("after one deinit more");
  assert_int_equal(p.entry->init(ALONE), SOZAI_OK);
  textures = p.entry->get_factory(SOZAI_TEXTURES_1);
  p.textures = textures;
  wood = p.entry->get_factory(SOZAI_WOOD_1);
  info = textures->find("wood");
  assert_non_null(wood);
  assert_non_null(info);
}

static void unknown_ids(void **unused) {
  (void)unused;
  static const char *const ids[] = {"sozai.textures/2", "sozai.textures/", "", "SOZAI.TEXTURES/1",
                                    "sozai.geometry/2"};
  for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) assert_null(p.entry->get_factory(ids[i]));
  assert_null(p.entry->get_factory(NULL));
  assert_null(textures->info(textures->count()));
  assert_null(textures->info(0xffffffffu));
  assert_null(textures->find("woo"));
  assert_null(textures->find(NULL));
}

static int32_t create(const sozai_host *host, const char *id, const char *preset) {
  sozai_texture *t = (sozai_texture *)(uintptr_t)1;
  int32_t r = textures->create(host, id, preset, NULL, 0, &t);
  if (r) assert_null(t);
  if (!r) textures->destroy(t);
  return r;
}

static void *only_alloc(void *user, size_t size, size_t align) {
  (void)user, (void)size, (void)align;
  return NULL;
}

static void create_refuses(void **unused) {
  (void)unused;
  assert_int_equal(textures->create(NULL, "wood", NULL, NULL, 0, NULL), SOZAI_ERROR_ARGUMENT);
  assert_true(said("out"));
  assert_int_equal(create(NULL, NULL, NULL), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(create(NULL, "marble", NULL), SOZAI_ERROR_UNKNOWN);
  assert_true(said("marble"));
  assert_int_equal(create(NULL, "wood", "oak of Dodona"), SOZAI_ERROR_UNKNOWN);
  assert_true(said("oak of Dodona"));
  sozai_host host = {.size = 0};
  assert_int_equal(create(&host, "wood", NULL), SOZAI_ERROR_ARGUMENT);
  assert_true(said("host.size"));
  host.size = 4;
  assert_int_equal(create(&host, "wood", NULL), SOZAI_ERROR_ARGUMENT);
  /* smaller and larger than ours: read up to there; half an allocator is none */
  host.size = offsetof(sozai_host, free);
  host.alloc = only_alloc;
  assert_int_equal(create(&host, "wood", NULL), SOZAI_OK);
  struct {
    sozai_host known;
    uint64_t later[8];
  } grown = {.known = {.size = sizeof grown}};
  memset(grown.later, 0xff, sizeof grown.later);
  assert_int_equal(create(&grown.known, "wood", NULL), SOZAI_OK);
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "wood", NULL, NULL, 3, &t), SOZAI_ERROR_ARGUMENT);
  assert_null(t);
}

static void nothing_for_null(void **unused) {
  (void)unused;
  textures->destroy(NULL);
  assert_null(textures->info_of(NULL));
  assert_int_equal(textures->bytes(NULL), 0);
  assert_non_null(textures->instruction_set(NULL));
  sozai_batch b = {.size = sizeof b};
  assert_int_equal(textures->evaluate(NULL, &b), SOZAI_ERROR_ARGUMENT);
  sozai_value v;
  assert_int_equal(textures->value(NULL, "seed", &v), SOZAI_ERROR_ARGUMENT);
  float x = 1.0f;
  assert_int_equal(wood->pith(NULL, 1, &x, &x, &x), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(wood->ring_radius(NULL, 1, &x, &x, &x, &x), SOZAI_ERROR_ARGUMENT);
  sozai_texture *t = plugin_wood(&p, NULL, NULL);
  assert_non_null(t);
  assert_int_equal(textures->evaluate(t, NULL), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(textures->value(t, NULL, &v), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(textures->value(t, "seed", NULL), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(textures->value(t, "sede", &v), SOZAI_ERROR_UNKNOWN);
  assert_int_equal(wood->pith(t, 1, NULL, &x, &x), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(wood->ring_radius(t, 1, &x, &x, &x, NULL), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(wood->pith(t, 0, NULL, NULL, NULL), SOZAI_OK);
  assert_ptr_equal(textures->info_of(t), info);
  assert_true(textures->bytes(t) > 0);
  textures->destroy(t);
}

/* ---- descriptions ------------------------------------------------------ */

static void described(void **unused) {
  (void)unused;
  assert_true(info->size >= sizeof *info && info->revision > 0);
  assert_true(info->component_count <= COMPONENTS);
  uint64_t taken = 0;
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *c = info->channels[i];
    uint64_t bits = ((1ull << c->components) - 1) << c->first;
    assert_true(c->id[0] && c->doc[0] && c->unit && c->size >= sizeof *c);
    assert_true(c->components >= 1 && c->first + c->components <= info->component_count);
    assert_true(strlen(c->suffixes) == (c->components == 1 ? 0 : c->components));
    assert_int_equal(taken & bits, 0);
    assert_int_equal((c->needs | c->uses) >> 6, 0);
    assert_int_equal(c->needs & c->uses, 0);
    taken |= bits;
  }
  assert_true(taken == (1ull << info->component_count) - 1);
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *q = info->parameters[i];
    assert_true(q->id[0] && q->label[0] && q->group[0] && q->doc[0] && q->unit);
    assert_true(strspn(q->id, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(q->id));
    for (uint32_t k = 0; k < i; k++) assert_string_not_equal(q->id, info->parameters[k]->id);
    int ranged = q->kind == SOZAI_KIND_FLOAT || q->kind == SOZAI_KIND_INT ||
                 q->kind == SOZAI_KIND_FLOAT3 || q->kind == SOZAI_KIND_COLOUR;
    if (ranged) {
      assert_true(q->hard_min < q->hard_max);
      assert_true(q->soft_min >= q->hard_min && q->soft_max <= q->hard_max);
      assert_true(q->soft_min < q->soft_max);
      int numbers = q->kind >= SOZAI_KIND_FLOAT3 ? 3 : 1;
      for (int c = 0; c < numbers; c++) {
        assert_true(q->default_number[c] >= q->hard_min && q->default_number[c] <= q->hard_max);
      }
    }
    if (q->kind == SOZAI_KIND_CHOICE) assert_true(q->default_number[0] < q->choice_count);
    if (q->kind == SOZAI_KIND_BUFFER) assert_true(q->buffer_kind >= SOZAI_BUFFER_TABLE);
  }
}

static const sozai_parameter *parameter(const char *id) {
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    if (strcmp(info->parameters[i]->id, id) == 0) return info->parameters[i];
  }
  return NULL;
}

/* Every preset is told of in full, can be made, and says what it was told. */
static void presets(void **unused) {
  (void)unused;
  assert_true(info->preset_count > 0);
  for (uint32_t i = 0; i < info->preset_count; i++) {
    const sozai_preset *s = info->presets[i];
    assert_true(s->id[0] && s->label[0] && s->doc[0] && s->source[0] && s->value_count > 0);
    for (uint32_t k = 0; k < i; k++) assert_string_not_equal(s->id, info->presets[k]->id);
    sozai_texture *t = plugin_wood(&p, s->id, NULL);
    assert_non_null(t);
    for (uint32_t k = 0; k < s->value_count; k++) {
      const sozai_value *given = &s->values[k];
      sozai_value v;
      assert_non_null(parameter(given->id));
      assert_int_equal(textures->value(t, given->id, &v), SOZAI_OK);
      assert_int_equal(v.kind, parameter(given->id)->kind);
      if (v.kind == SOZAI_KIND_CHOICE) {
        assert_string_equal(v.text, given->text);
      } else {
        assert_memory_equal(v.number, given->number, sizeof v.number);
      }
    }
    textures->destroy(t);
  }
}

/* ---- values ------------------------------------------------------------ */

static void same_value(const sozai_value *a, const sozai_value *b) {
  assert_int_equal(a->kind, b->kind);
  assert_memory_equal(a->number, b->number, sizeof a->number);
  assert_int_equal(a->text != NULL, b->text != NULL);
  if (a->text) assert_string_equal(a->text, b->text);
}

/* Every parameter's value comes back, by default and when it is set. */
static void values(void **unused) {
  (void)unused;
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    const sozai_parameter *q = info->parameters[i];
    sozai_texture *t = plugin_wood(&p, NULL, NULL);
    sozai_value v, set = {.id = q->id, .kind = q->kind};
    assert_int_equal(textures->value(t, q->id, &v), SOZAI_OK);
    assert_string_equal(v.id, q->id);
    assert_int_equal(v.kind, q->kind);
    if (q->kind != SOZAI_KIND_IMAGE) {
      assert_memory_equal(v.number, q->default_number, sizeof v.number);
    }
    if (q->kind == SOZAI_KIND_CHOICE) {
      assert_string_equal(v.text, q->choices[(uint32_t)q->default_number[0]]);
    }
    if (q->default_text) assert_string_equal(v.text, q->default_text);
    textures->destroy(t);
    if (q->kind == SOZAI_KIND_IMAGE) continue; /* wants a service: tests/section */

    static const float widths[2] = {1.0f, 3.0f};
    const sozai_buffer b = {
        .size = sizeof b, .kind = q->buffer_kind, .dims = {2, 1}, .data = widths};
    for (int c = 0; c < 3; c++) set.number[c] = 0.5 * (q->default_number[c] + q->soft_max);
    if (q->kind == SOZAI_KIND_INT) set.number[0] = q->hard_max;
    if (q->kind == SOZAI_KIND_BOOL) set.number[0] = 0;
    if (q->kind == SOZAI_KIND_FLOAT || q->kind == SOZAI_KIND_INT || q->kind == SOZAI_KIND_BOOL)
      set.number[1] = set.number[2] = 0;
    if (q->kind == SOZAI_KIND_TEXT) set.text = "something";
    if (strcmp(q->id, "tree") == 0) set.text = "sugi";
    if (strcmp(q->id, "tree_field") == 0) set.text = "trunk\n100 0 90 5\n";
    /* tables of another shape: tests/property/knots.c */
    if (strcmp(q->id, "knots") == 0 || strcmp(q->id, "knot_radii") == 0 ||
        strcmp(q->id, "stem_rings") == 0)
      continue;
    if (q->kind == SOZAI_KIND_CHOICE) {
      set.text = q->choices[q->choice_count - 1];
      set.number[0] = q->choice_count - 1.0;
      set.number[1] = set.number[2] = 0;
    }
    if (q->kind == SOZAI_KIND_COLOUR) set.text = "lin_rec709";
    if (q->kind == SOZAI_KIND_BUFFER) set.buffer = &b;
    int32_t r = textures->create(NULL, "wood", NULL, &set, 1, &t);
    if (r) fail_msg("%s: %s", q->id, textures->last_error());
    assert_int_equal(textures->value(t, q->id, &v), SOZAI_OK);
    if (q->kind == SOZAI_KIND_BUFFER) {
      assert_ptr_not_equal(v.buffer, &b);
      assert_memory_equal(v.buffer->data, widths, sizeof widths);
    } else {
      if (q->kind == SOZAI_KIND_TEXT) memset(set.number, 0, sizeof set.number);
      same_value(&v, &set);
    }
    textures->destroy(t);
  }
}

static int start(void **unused) {
  (void)unused;
  return plugin_open(&p, SOZAI_TEST_PLUGIN);
}

static int stop(void **unused) {
  (void)unused;
  p.entry->deinit();
  return dlclose(p.library);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(counted_init),   cmocka_unit_test(unknown_ids),
      cmocka_unit_test(create_refuses), cmocka_unit_test(nothing_for_null),
      cmocka_unit_test(described),      cmocka_unit_test(presets),
      cmocka_unit_test(values)};
  return cmocka_run_group_tests(tests, start, stop);
}
