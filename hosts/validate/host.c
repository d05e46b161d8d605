/* SPDX-License-Identifier: Apache-2.0
 * What a host offers: "Every member may be NULL." */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "batch.h"
#include "groups.h"
#include "make.h"
#include "recorder.h"

static kind kinds[KINDS_MOST];
static recorder rec;

static const char *some_preset(subject *s, const kind *k) {
  return k->preset_count ? k->presets[chance_below(s, k->preset_count)]->id : NULL;
}

static const sozai_parameter *first_of(const kind *k, uint32_t of) {
  for (uint32_t p = 0; p < k->parameter_count; p++)
    if (k->parameters[p]->kind == of) return k->parameters[p];
  return NULL;
}

/* Made with this host as the recorder is told, or a failure. */
static bool made_with(subject *s, const kind *k, const char *preset, made *m, const char *what) {
  int32_t r = make(s, k, &rec.abi, preset, NULL, 0, m);
  return EXPECT(r == SOZAI_OK, "%s: create %s gave %s: %s", k->id, what, result_name(r),
                last_error(s));
}

/* ---- all of it, and none --------------------------------------------------------- */

/* "Both or neither"; "free gets what alloc was asked"; "what else they are handed" */
static void services(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t round = 0; round < 4; round++) {
      made m;
      recorder_init(&rec);
      if (!made_with(s, &kinds[i], round ? some_preset(s, &kinds[i]) : NULL, &m,
                     "with all services"))
        continue;
      batch *b = batch_new(s, kinds[i].texture, NULL, 60);
      if (b) batch_run(s, m.texture, b, "of a host with all services");
      batch_free(b);
      unmake(s, &m);
      recorder_judge(&rec, kinds[i].id);
      recorder_empty(&rec, kinds[i].id, "after destroy");
    }
}

/* "Every member may be NULL." */
static void without(subject *s) {
  static const sozai_host empty = {.size = sizeof empty};
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    made plain, m;
    if (make(s, &kinds[i], NULL, NULL, NULL, 0, &plain) != SOZAI_OK) continue;
    int32_t r = make(s, &kinds[i], &empty, NULL, NULL, 0, &m);
    if (EXPECT(r == SOZAI_OK, "%s: create with a host of NULLs gave %s", kinds[i].id,
               result_name(r))) {
      same_bits(s, kinds[i].texture, plain.texture, m.texture, "of a host of NULLs");
      unmake(s, &m);
    }
    for (uint32_t one = 0; one < 6; one++) { /* each of five alone, then none */
      recorder_init(&rec);
      if (one != 0) rec.abi.log = NULL;
      if (one != 1) rec.abi.alloc = NULL, rec.abi.free = NULL;
      if (one != 2) rec.abi.parallel = NULL;
      if (one != 3) rec.abi.progress = NULL;
      if (one != 4) rec.abi.get_service = NULL;
      if (!made_with(s, &kinds[i], NULL, &m, "with one service at most")) continue;
      same_bits(s, kinds[i].texture, plain.texture, m.texture,
                "of a host with one service at most");
      unmake(s, &m);
    }
    unmake(s, &plain);
  }
}

/* "Members past the size given are taken as zero", and those of a newer host not looked at. */
static void sizes(subject *s) {
  static const uint32_t cuts[] = {
      offsetof(sozai_host, user),          offsetof(sozai_host, log),
      offsetof(sozai_host, alloc),         offsetof(sozai_host, parallel),
      offsetof(sozai_host, progress),      offsetof(sozai_host, get_service),
      offsetof(sozai_host, colour_config), offsetof(sozai_host, image_memory)};
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    made m;
    for (uint32_t c = 0; c < COUNT_OF(cuts); c++) {
      unsigned char bytes[sizeof(sozai_host)];
      sozai_host cut;
      recorder_init(&rec);
      memset(bytes, 0xa5, sizeof bytes);
      memcpy(bytes, &rec.abi, cuts[c]);
      memcpy(&cut, bytes, sizeof cut);
      cut.size = cuts[c];
      doing("create of %s with a host of %u bytes", kinds[i].id, cuts[c]);
      int32_t r = make(s, &kinds[i], &cut, NULL, NULL, 0, &m);
      EXPECT(r == SOZAI_OK, "%s: create with a host of %u bytes gave %s", kinds[i].id, cuts[c],
             result_name(r));
      if (r == SOZAI_OK) unmake(s, &m);
    }
    struct {
      sozai_host abi;
      unsigned char later[256];
    } grown;
    recorder_init(&rec);
    memset(&grown, 0xa5, sizeof grown);
    grown.abi = rec.abi;
    grown.abi.size = sizeof grown;
    int32_t r = make(s, &kinds[i], &grown.abi, NULL, NULL, 0, &m);
    EXPECT(r == SOZAI_OK, "%s: create with a host of %u bytes gave %s", kinds[i].id, grown.abi.size,
           result_name(r));
    if (r == SOZAI_OK) unmake(s, &m);
  }
}

/* ---- memory ------------------------------------------------------------------------- */

/* "MEMORY: the allocator gave NULL"; "NULL when anything failed, and then nothing is kept" */
static void allocator_fails(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t round = 0; round < 2 && !enough(); round++) {
      const char *preset = round ? some_preset(s, &kinds[i]) : NULL;
      made m;
      recorder_init(&rec);
      if (!made_with(s, &kinds[i], preset, &m, "with an allocator")) continue;
      unmake(s, &m);
      uint64_t all = atomic_load(&rec.allocations);
      for (uint64_t k = 1; k <= all && k <= (s->thorough ? all : 200); k++) {
        recorder_init(&rec);
        rec.fail_at = k;
        int32_t r = make(s, &kinds[i], &rec.abi, preset, NULL, 0, &m);
        EXPECT(r == SOZAI_ERROR_MEMORY || r == SOZAI_OK,
               "%s: create gave %s where allocation %llu of %llu failed", kinds[i].id,
               result_name(r), (unsigned long long)k, (unsigned long long)all);
        EXPECT(r == SOZAI_OK || !m.texture, "%s: a texture though allocation %llu failed",
               kinds[i].id, (unsigned long long)k);
        if (r == SOZAI_ERROR_MEMORY)
          EXPECT(*last_error(s), "%s: no word of why where memory failed", kinds[i].id);
        if (r == SOZAI_OK) unmake(s, &m);
        recorder_empty(&rec, kinds[i].id, "after a failed allocation");
        recorder_judge(&rec, kinds[i].id);
        if (enough()) break;
      }
    }
}

/* ---- threads, progress ----------------------------------------------------------------- */

/* "Run task(context, i) for every i below count, in any order"; "Whatever it returns, the plugin
 * then runs those itself that have not run" */
static void parallel(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t round = 0; round < 2; round++) {
      const char *preset = round ? some_preset(s, &kinds[i]) : NULL;
      made plain, m;
      if (make(s, &kinds[i], NULL, preset, NULL, 0, &plain) != SOZAI_OK) continue;
      for (uint32_t way = PARALLEL_FORWARD; way < PARALLEL_WAYS; way++) {
        recorder_init(&rec);
        rec.parallel = way;
        if (!made_with(s, &kinds[i], preset, &m, parallel_words[way])) continue;
        same_bits(s, kinds[i].texture, plain.texture, m.texture, parallel_words[way]);
        unmake(s, &m);
      }
      unmake(s, &plain);
    }
}

/* "Long work, 0 to 1. Not 0: cancel."; "CANCELLED: the host asked to stop" */
static void cancelled(subject *s) {
  uint32_t n = subject_textures(s, kinds), reported = 0;
  for (uint32_t i = 0; i < n; i++) {
    made m;
    recorder_init(&rec);
    if (!made_with(s, &kinds[i], NULL, &m, "with progress")) continue;
    unmake(s, &m);
    uint64_t all = atomic_load(&rec.progress_calls);
    reported += all > 0;
    for (uint64_t k = 1; k <= all && k <= 50; k++) {
      recorder_init(&rec);
      rec.cancel_at = k;
      int32_t r = make(s, &kinds[i], &rec.abi, NULL, NULL, 0, &m);
      EXPECT(r == SOZAI_ERROR_CANCELLED, "%s: create gave %s where progress cancelled it",
             kinds[i].id, result_name(r));
      if (r == SOZAI_OK) unmake(s, &m);
      recorder_empty(&rec, kinds[i].id, "after it was cancelled");
    }
  }
  if (n && !reported) skipped("no texture reports progress while it is made");
}

/* "allocates nothing": nothing of the host's either, nor any other service */
static void in_evaluate(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    made m;
    recorder_init(&rec);
    rec.colour = true;
    if (!made_with(s, &kinds[i], some_preset(s, &kinds[i]), &m, "with all services")) continue;
    batch *b = batch_new(s, kinds[i].texture, NULL, 1500);
    uint64_t before = recorder_calls(&rec);
    for (uint32_t k = 0; b && k < 10; k++) {
      batch_from(b, 0, k * 150);
      batch_run(s, m.texture, b, "watched");
    }
    sozai_value v;
    for (uint32_t p = 0; p < kinds[i].parameter_count; p++)
      made_value(s, &m, kinds[i].parameters[p]->id, &v);
    EXPECT(recorder_calls(&rec) == before, "%s: evaluate or value called the host's services",
           kinds[i].id);
    batch_free(b);
    unmake(s, &m);
  }
}

/* ---- colour -------------------------------------------------------------------------------- */

/* "Colours are converted into the working space here, once" */
static void colour(subject *s) {
  uint32_t n = subject_textures(s, kinds), has = 0;
  for (uint32_t i = 0; i < n; i++) {
    if (!first_of(&kinds[i], SOZAI_KIND_COLOUR)) continue;
    made one, other;
    has++;
    recorder_init(&rec);
    rec.colour = true;
    if (!made_with(s, &kinds[i], NULL, &one, "with a colour service")) continue;
    EXPECT(atomic_load(&rec.colour_calls), "%s: the host's colour service was not asked",
           kinds[i].id);
    if (made_with(s, &kinds[i], NULL, &other, "with a colour service")) {
      same_bits(s, kinds[i].texture, one.texture, other.texture, "of the same colour service");
      unmake(s, &other);
    }
    unmake(s, &one);
    recorder_judge(&rec, kinds[i].id);
    recorder_empty(&rec, kinds[i].id, "after destroy");
  }
  if (n && !has) skipped("no texture has a colour");
}

/* "COLOUR: an unknown colour space, or a failing transform" */
static void colour_fails(subject *s) {
  uint32_t n = subject_textures(s, kinds), has = 0;
  for (uint32_t i = 0; i < n; i++) {
    if (!first_of(&kinds[i], SOZAI_KIND_COLOUR)) continue;
    made m;
    has++;
    recorder_init(&rec);
    rec.colour = true;
    rec.colour_result = SOZAI_ERROR_COLOUR;
    int32_t r = make(s, &kinds[i], &rec.abi, NULL, NULL, 0, &m);
    EXPECT(r == SOZAI_ERROR_COLOUR, "%s: create gave %s where the colour service failed",
           kinds[i].id, result_name(r));
    EXPECT(r == SOZAI_OK || (!m.texture && *last_error(s)),
           "%s: a texture, or no word of why, where the colour service failed", kinds[i].id);
    if (r == SOZAI_OK) unmake(s, &m);
    recorder_empty(&rec, kinds[i].id, "after a colour failed");
  }
  if (n && !has) skipped("no texture has a colour");
}

/* Colours that are no numbers, or huge: refused, or the answers are finite. */
static void colour_odd(subject *s) {
  static const float scales[] = {0.0f, 1e38f, -1e38f, __builtin_nanf(""), __builtin_inff()};
  uint32_t n = subject_textures(s, kinds), has = 0;
  for (uint32_t i = 0; i < n; i++) {
    if (!first_of(&kinds[i], SOZAI_KIND_COLOUR)) continue;
    has++;
    for (uint32_t k = 0; k < COUNT_OF(scales); k++) {
      made m;
      recorder_init(&rec);
      rec.colour = true;
      rec.colour_scale = scales[k];
      asked();
      if (make(s, &kinds[i], &rec.abi, NULL, NULL, 0, &m) != SOZAI_OK) continue;
      batch *b = batch_new(s, kinds[i].texture, NULL, 200);
      if (b && batch_run(s, m.texture, b, "of odd colours"))
        for (uint32_t c = 0; c < kinds[i].texture->component_count; c++)
          batch_written(b, c, 0, 200, "where the colour service gives odd colours");
      batch_free(b);
      unmake(s, &m);
    }
  }
  if (n && !has) skipped("no texture has a colour");
}

/* Without a service, an unknown space is refused by that error. */
static void colour_unknown(subject *s) {
  uint32_t n = subject_textures(s, kinds), has = 0;
  for (uint32_t i = 0; i < n; i++) {
    const sozai_parameter *p = first_of(&kinds[i], SOZAI_KIND_COLOUR);
    sozai_value v;
    made m;
    if (!p || !make_default(p, &v)) continue;
    has++;
    v.text = "validate: no such space";
    int32_t r = make(s, &kinds[i], NULL, NULL, &v, 1, &m);
    EXPECT(r == SOZAI_ERROR_COLOUR, "%s: %s in an unknown space gave %s", kinds[i].id, p->id,
           result_name(r));
    if (r == SOZAI_OK) unmake(s, &m);
  }
  if (n && !has) skipped("no texture has a colour");
}

/* ---- pictures ------------------------------------------------------------------------------ */

static sozai_value picture(const sozai_parameter *p) {
  return (sozai_value){
      .id = p->id, .kind = SOZAI_KIND_IMAGE, .text = "/validate/no such picture.png"};
}

/* "pictures are opened here"; "FILE: missing, unreadable or malformed", "UNSUPPORTED ... for a
 * picture where there is no image service" */
static void picture_missing(subject *s) {
  uint32_t n = subject_textures(s, kinds), has = 0;
  for (uint32_t i = 0; i < n; i++) {
    const sozai_parameter *p = first_of(&kinds[i], SOZAI_KIND_IMAGE);
    made m;
    if (!p) continue;
    has++;
    sozai_value v = picture(p);
    int32_t r = make(s, &kinds[i], NULL, NULL, &v, 1, &m);
    EXPECT(r == SOZAI_ERROR_FILE || r == SOZAI_ERROR_UNSUPPORTED,
           "%s: %s of a missing file gave %s", kinds[i].id, p->id, result_name(r));
    if (r == SOZAI_OK) unmake(s, &m);
  }
  if (n && !has) skipped("no texture takes a picture");
}

/* The host's own service, which opens and which refuses. */
static void picture_service(subject *s) {
  uint32_t n = subject_textures(s, kinds), has = 0;
  for (uint32_t i = 0; i < n; i++) {
    const sozai_parameter *p = first_of(&kinds[i], SOZAI_KIND_IMAGE);
    made m;
    if (!p) continue;
    has++;
    sozai_value v = picture(p);
    recorder_init(&rec);
    rec.images = true;
    rec.colour = true;
    rec.image_result = SOZAI_ERROR_FILE;
    int32_t r = make(s, &kinds[i], &rec.abi, NULL, &v, 1, &m);
    EXPECT(r == SOZAI_ERROR_FILE, "%s: create gave %s where the image service found no file",
           kinds[i].id, result_name(r));
    if (r == SOZAI_OK) unmake(s, &m);
    recorder_empty(&rec, kinds[i].id, "after a picture failed");
    if (p->default_number[0] > 1) continue; /* this service has one channel */
    recorder_init(&rec);
    rec.images = true;
    rec.colour = true;
    r = make(s, &kinds[i], &rec.abi, NULL, &v, 1, &m);
    if (r != SOZAI_OK) continue; /* it may want more than any picture */
    EXPECT(atomic_load(&rec.image_opens), "%s: the host's image service was not asked",
           kinds[i].id);
    batch *b = batch_new(s, kinds[i].texture, NULL, 200);
    if (b && batch_run(s, m.texture, b, "with a picture"))
      for (uint32_t c = 0; c < kinds[i].texture->component_count; c++)
        batch_written(b, c, 0, 200, "with a picture");
    batch_free(b);
    unmake(s, &m);
    recorder_judge(&rec, kinds[i].id);
    recorder_empty(&rec, kinds[i].id, "after destroy");
  }
  if (n && !has) skipped("no texture takes a picture");
}

CHECKS(
    host, //
    {"host.services", "evaluate.answers",
     "services are handed their user, texts, fractions, sizes and alignments", services},
    {"host.without", "evaluate.answers", "every service may be missing, with the same answers",
     without},
    {"host.sizes", "create.default", "a host's struct may be smaller or larger", sizes},
    {"host.allocator-fails", "create.default", "where any allocation fails create does, cleanly",
     allocator_fails},
    {"host.parallel", "evaluate.answers",
     "whatever the order of tasks, refused or dropped: the same bits", parallel},
    {"host.cancelled", "create.default", "create stops where progress says so, cleanly", cancelled},
    {"host.in-evaluate", "evaluate.answers", "evaluate and value call no service", in_evaluate},
    {"host.colour", "evaluate.answers", "colours are converted by the host's service", colour},
    {"host.colour-fails", "create.default", "where that fails, create gives COLOUR", colour_fails},
    {"host.colour-odd", "evaluate.answers", "colours that are not finite do no harm", colour_odd},
    {"host.colour-unknown", "create.default", "an unknown colour space gives COLOUR",
     colour_unknown},
    {"host.picture-missing", "create.default", "a missing picture gives FILE or UNSUPPORTED",
     picture_missing},
    {"host.pictures", "evaluate.answers",
     "pictures come from the host's service, opened and closed", picture_service});
