/* SPDX-License-Identifier: Apache-2.0
 * Textures made and destroyed. */
#include <stdlib.h>
#include <string.h>

#include "batch.h"
#include "groups.h"
#include "make.h"
#include "memory.h"

#define POISON ((sozai_texture *)(uintptr_t)0x10)

static kind kinds[KINDS_MOST];

/* "preset: NULL for the parameters' own defaults" */
static void plain(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    sozai_texture *t = POISON;
    doing("create of %s", kinds[i].id);
    int32_t r = s->textures->create(NULL, kinds[i].id, NULL, NULL, 0, &t);
    EXPECT(r == SOZAI_OK, "create of %s gave %s: %s", kinds[i].id, result_name(r), last_error(s));
    if (r != SOZAI_OK) continue;
    if (!EXPECT(t && t != POISON, "create of %s gave SOZAI_OK and no texture", kinds[i].id))
      continue;
    doing("destroy of %s", kinds[i].id);
    s->textures->destroy(t);
  }
}

/* "NULL is allowed." of destroy */
static void destroy_null(subject *s) {
  if (!subject_textures(s, kinds)) return;
  doing("destroy(NULL)");
  s->textures->destroy(NULL);
  asked();
}

/* "ARGUMENT: a NULL, a wrong size"; "UNKNOWN: no texture, preset"; "the texture; NULL when
 * anything failed, and then nothing is kept" */
static void refuses(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const char *id = kinds[i].id;
    const sozai_value lost = {.id = "validate_none", .kind = SOZAI_KIND_FLOAT};
    const sozai_value nameless = {.kind = SOZAI_KIND_FLOAT};
    static const sozai_host no_size;
    const struct {
      const char *what;
      const sozai_host *host;
      const char *id, *preset;
      const sozai_value *values;
      uint32_t count;
      int32_t wanted;
    } calls[] = {
        {"without an id", NULL, NULL, NULL, NULL, 0, SOZAI_ERROR_ARGUMENT},
        {"of an unknown texture", NULL, "validate: none", NULL, NULL, 0, SOZAI_ERROR_UNKNOWN},
        {"of a texture called \"\"", NULL, "", NULL, NULL, 0, SOZAI_ERROR_UNKNOWN},
        {"of an unknown preset", NULL, id, "validate: none", NULL, 0, SOZAI_ERROR_UNKNOWN},
        {"of a preset called \"\"", NULL, id, "", NULL, 0, SOZAI_ERROR_UNKNOWN},
        {"of an unknown parameter", NULL, id, NULL, &lost, 1, SOZAI_ERROR_UNKNOWN},
        {"of a parameter without id", NULL, id, NULL, &nameless, 1, SOZAI_ERROR_ARGUMENT},
        {"of 3 values at NULL", NULL, id, NULL, NULL, 3, SOZAI_ERROR_ARGUMENT},
        {"with a host of size 0", &no_size, id, NULL, NULL, 0, SOZAI_ERROR_ARGUMENT},
    };
    for (uint32_t c = 0; c < COUNT_OF(calls); c++) {
      sozai_texture *t = POISON;
      doing("create of %s, %s", id, calls[c].what);
      int32_t r = s->textures->create(calls[c].host, calls[c].id, calls[c].preset, calls[c].values,
                                      calls[c].count, &t);
      EXPECT(r == calls[c].wanted, "create %s (%s) gave %s, not %s", calls[c].what, id,
             result_name(r), result_name(calls[c].wanted));
      EXPECT(r == SOZAI_OK || !t, "create %s (%s) failed and left *out as it was", calls[c].what,
             id);
      if (r == SOZAI_OK && t != POISON) s->textures->destroy(t);
    }
    doing("create with out NULL");
    int32_t r = s->textures->create(NULL, id, NULL, NULL, 0, NULL);
    EXPECT(r == SOZAI_ERROR_ARGUMENT, "create of %s with out NULL gave %s", id, result_name(r));
  }
}

/* ---- memory ------------------------------------------------------------------ */

#define ROUNDS 40
#define LEAK 4096 /* bytes more after ROUNDS: less is a list that grows now and then */

/* How much more the process holds after many rounds than after a few. */
static void rounds(subject *s, const char *what,
                   void (*once)(subject *s, const kind *k, uint32_t round)) {
  uint32_t n = subject_textures(s, kinds);
  if (!memory_watched()) {
    skipped("a sanitizer has the allocator");
    return;
  }
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t k = 0; k < 4; k++) once(s, &kinds[i], k);
    int64_t before = memory_live();
    for (uint32_t k = 0; k < ROUNDS; k++) once(s, &kinds[i], k);
    int64_t more = memory_live() - before;
    EXPECT(more < LEAK, "%s: %lld bytes more after %d rounds of %s", kinds[i].id, (long long)more,
           ROUNDS, what);
  }
}

static void create_once(subject *s, const kind *k, uint32_t round) {
  sozai_texture *t = NULL;
  const char *preset =
      k->preset_count && round % 2 ? k->presets[round % k->preset_count]->id : NULL;
  doing("create and destroy of %s", k->id);
  s->textures->create(NULL, k->id, round < 4 ? NULL : preset, NULL, 0, &t);
  s->textures->destroy(t);
}

static void churn(subject *s) { rounds(s, "create and destroy", create_once); }

static void refused_once(subject *s, const kind *k, uint32_t round) {
  const sozai_value lost = {.id = "validate_none", .kind = SOZAI_KIND_FLOAT};
  sozai_texture *t = NULL;
  bad wrong[BAD_MOST];
  s->textures->create(NULL, k->id, NULL, &lost, 1, &t);
  s->textures->create(NULL, k->id, "validate: none", NULL, 0, &t);
  for (uint32_t p = 0; p < k->parameter_count && p < 8; p++) {
    uint32_t n = make_bad(k->parameters[(p + round) % k->parameter_count], wrong);
    const sozai_value *v = n ? &wrong[round % n].value : &lost;
    if (v->text || v->kind == SOZAI_KIND_FLOAT) s->textures->create(NULL, k->id, NULL, v, 1, &t);
    s->textures->destroy(t);
    t = NULL;
  }
}

static void refused_churn(subject *s) { rounds(s, "refused create", refused_once); }

static void init_once(subject *s, const kind *k, uint32_t round) {
  (void)k, (void)round;
  doing("init and deinit");
  if (s->entry->init(s->path) == SOZAI_OK) s->entry->deinit();
}

static void init_churn(subject *s) { rounds(s, "init and deinit", init_once); }

/* ---- what is told of it ------------------------------------------------------- */

static void told(subject *s, const sozai_texture_info *info, const char *preset, sozai_texture *t) {
  static const char *const sets[] = {"avx512", "avx2", "sse2", "neon", "scalar"};
  const char *name = texture_name(info, preset), *set = s->textures->instruction_set(t);
  EXPECT(s->textures->info_of(t) == info, "%s: info_of is not its kind's info", name);
  uint64_t bytes = s->textures->bytes(t);
  EXPECT(bytes > 0, "%s: bytes() is 0", name);
  EXPECT(bytes == s->textures->bytes(t), "%s: bytes() is another each time", name);
  bool known = false;
  for (uint32_t i = 0; set && i < COUNT_OF(sets); i++) known |= strcmp(set, sets[i]) == 0;
  EXPECT(known, "%s: instruction_set() is '%s'", name, set ? set : "NULL");
}

/* info_of, bytes, instruction_set */
static void tells(subject *s) {
  if (subject_textures(s, kinds)) each_texture(s, 3, told);
}

/* "Bytes of memory it holds." of a texture made through the host's allocator, which knows. */
typedef struct counted {
  int64_t live;
} counted;

static void *count_alloc(void *user, size_t size, size_t align) {
  ((counted *)user)->live += (int64_t)size;
  return aligned_alloc(align < 16 ? 16 : align, (size + (align < 16 ? 15 : align - 1)) /
                                                    (align < 16 ? 16 : align) *
                                                    (align < 16 ? 16 : align));
}

static void count_free(void *user, void *memory, size_t size, size_t align) {
  (void)align;
  ((counted *)user)->live -= (int64_t)size;
  free(memory);
}

static void bytes_held(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    counted c = {0};
    const sozai_host host = {
        .size = sizeof host, .user = &c, .alloc = count_alloc, .free = count_free};
    made m;
    if (make(s, &kinds[i], &host, NULL, NULL, 0, &m) != SOZAI_OK) continue;
    int64_t held = c.live, says = (int64_t)s->textures->bytes(m.texture);
    if (held > 0)
      EXPECT(says >= held / 2 && says <= 2 * held + 65536,
             "%s: bytes() is %lld where it took %lld of the host's allocator", kinds[i].id,
             (long long)says, (long long)held);
    unmake(s, &m);
  }
}

/* "Make a texture, which never changes afterwards." */
static void repeated(subject *s, const sozai_texture_info *info, const char *preset,
                     sozai_texture *t) {
  sozai_texture *other = NULL;
  if (s->textures->create(NULL, info->id, preset, NULL, 0, &other) != SOZAI_OK) return;
  same_bits(s, info, t, other, "of a second texture of the same values");
  s->textures->destroy(other);
}

static void same(subject *s) {
  if (subject_textures(s, kinds)) each_texture(s, 4, repeated);
}

static void beside(subject *s, const sozai_texture_info *info, const char *preset,
                   sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 64);
  if (!b) return;
  float *wanted = batch_run(s, t, b, "alone") ? batch_answers(b) : NULL;
  for (uint32_t i = 0; wanted && i < s->textures->count(); i++) {
    const sozai_texture_info *o = s->textures->info(i);
    sozai_texture *other = NULL;
    const char *p = o->preset_count ? o->presets[chance_below(s, o->preset_count)]->id : NULL;
    if (s->textures->create(NULL, o->id, p, NULL, 0, &other) != SOZAI_OK) continue;
    batch_mark(b);
    if (batch_run(s, t, b, "beside another"))
      batch_all_same(b, wanted, 0, 64, "with another texture beside it");
    s->textures->destroy(other);
    batch_mark(b);
    if (batch_run(s, t, b, "after another"))
      batch_all_same(b, wanted, 0, 64, "after another texture was destroyed");
  }
  free(wanted);
  batch_free(b);
}

static void independent(subject *s) {
  if (subject_textures(s, kinds)) each_texture(s, 2, beside);
}

CHECKS(create, //
       {"create.default", "describe.unique", "every texture can be made of its defaults", plain},
       {"create.destroy-null", "create.default", "destroy(NULL) is allowed", destroy_null},
       {"create.refuses", "create.default",
        "what is missing or unknown is refused by its error, and *out set to NULL", refuses},
       {"create.churn", "create.default", "textures made and destroyed leave no memory behind",
        churn},
       {"create.refused-churn", "create.default", "nor do refused ones", refused_churn},
       {"create.init-churn", "create.default", "nor does init with deinit", init_churn},
       {"create.tells", "create.default", "info_of, bytes and instruction_set say what they should",
        tells},
       {"create.bytes", "create.default",
        "bytes() is about what the host's allocator was asked for", bytes_held},
       {"create.same", "evaluate.answers", "the same values make the same texture, to the bit",
        same},
       {"create.independent", "evaluate.answers", "others beside a texture do not change it",
        independent});
