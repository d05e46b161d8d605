/* SPDX-License-Identifier: Apache-2.0
 *
 * The functions of sozai.textures/1, for every material alike.
 */
#include <string.h>
#if defined(__x86_64__)
#include <emmintrin.h>
#endif

#include "core/colour.h"
#include "core/float_mode.h"
#include "core/images.h"
#include "core/meter.h"
#include "core/status.h"
#include "material.h"

#define COMPONENTS_MAX 64
#define CHANNEL_KINDS_MAX 8

struct sozai_texture {
  const material *kind;
  const sozai_texture_info *info;
  sozai_host host;
  settings given;
  image_set images;
  void *state;
  /* which components need which inputs, one entry for each set of inputs */
  struct {
    uint64_t channels;
    uint32_t inputs;
  } needs[CHANNEL_KINDS_MAX];
  uint32_t kinds, all_needs; /* of all kinds together */
};

static uint32_t count(void) { return textures_ready() ? registry_count : 0; }

static const sozai_texture_info *info(uint32_t index) {
  return index < count() ? registry[index]->describe() : NULL;
}

static const material *material_of(const char *id) {
  for (uint32_t i = 0; id && i < count(); i++) {
    if (strcmp(registry[i]->describe()->id, id) == 0) return registry[i];
  }
  return NULL;
}

static const sozai_texture_info *find(const char *id) {
  const material *m = material_of(id);
  return m ? m->describe() : NULL;
}

static int32_t build_state(sozai_texture *t, const sozai_host *host) {
  size_t bytes = t->info->parameter_count * sizeof(float[3]);
  float(*colours)[3] = host_alloc(host, bytes, 64);
  if (!colours) return SOZAI_ERROR_MEMORY;
  int32_t r = colour_convert(host, t->info, &t->given, colours);
  if (!r) r = images_open(&t->images, host, t->info, &t->given);
  if (!r) {
    t->state = host_alloc(host, t->kind->state_bytes, 64);
    r = t->state ? t->kind->build(t->state, host, &t->given, (const float(*)[3])colours, &t->images)
                 : SOZAI_ERROR_MEMORY;
  }
  host_free(host, colours, bytes, 64);
  return r;
}

static void destroy(sozai_texture *t) {
  if (!t) return;
  sozai_host host = t->host;
  if (t->state && t->kind->release) t->kind->release(t->state, &host);
  host_free(&host, t->state, t->kind->state_bytes, 64);
  images_close(&t->images, &host);
  settings_free(&t->given, &host);
  host_free(&host, t, sizeof *t, 64);
}

static void collect_needs(sozai_texture *t) {
  for (uint32_t i = 0; i < t->info->channel_count; i++) {
    const sozai_channel *c = t->info->channels[i];
    uint32_t k = 0;
    while (k < t->kinds && t->needs[k].inputs != c->needs && k < CHANNEL_KINDS_MAX - 1) k++;
    if (k == t->kinds) t->kinds++;
    t->needs[k].inputs |= c->needs;
    t->all_needs |= c->needs;
    t->needs[k].channels |= ((1ull << c->components) - 1) << c->first;
  }
}

/* Makes it, or rehearses that: then *out is NULL, and *memory what it would take. */
static int32_t make_in_mode(const sozai_host *host, const char *id, const char *preset,
                            const sozai_value *values, uint32_t value_count, sozai_texture **out,
                            sozai_memory *memory) {
  if (!textures_ready()) return fail(SOZAI_ERROR_STATE, "create: called before init");
  if (!id) return fail(SOZAI_ERROR_ARGUMENT, "create: the texture's id is NULL");
  if (host && host->size < 8) {
    return fail(SOZAI_ERROR_ARGUMENT, "create: host.size is %u: set it to sizeof(sozai_host)",
                host->size);
  }
  const material *m = material_of(id);
  if (!m) return fail(SOZAI_ERROR_UNKNOWN, "there is no texture \"%.80s\"", id);
  sozai_host own = host_copy(host), h;
  meter counted;
  int32_t r = meter_open(&counted, &own, LIMIT_TEXTURE_BYTES, &h);
  if (r) return r;
  counted.rehearsing = memory != NULL;
  sozai_texture *t = host_alloc(&h, sizeof *t, 64);
  if (!t) return meter_result(&counted, SOZAI_ERROR_MEMORY, id);
  t->kind = m;
  t->info = m->describe();
  t->host = own;
  collect_needs(t);
  r = settings_make(&t->given, &h, t->info, preset, values, value_count);
  if (!r) r = build_state(t, &h);
  if (!r && memory) {
    memory->held = atomic_load(&counted.held);
    memory->peak = atomic_load(&counted.peak);
  }
  if (r || memory) {
    destroy(t);
    return meter_result(&counted, r, id);
  }
  *out = t;
  return SOZAI_OK;
}

static int32_t make(const sozai_host *host, const char *id, const char *preset,
                    const sozai_value *values, uint32_t value_count, sozai_texture **out,
                    sozai_memory *memory) {
  uint64_t mode = float_mode_enter();
  int32_t r = make_in_mode(host, id, preset, values, value_count, out, memory);
  float_mode_leave(mode);
  return r;
}

static int32_t create(const sozai_host *host, const char *id, const char *preset,
                      const sozai_value *values, uint32_t value_count, sozai_texture **out) {
  if (!out) return fail(SOZAI_ERROR_ARGUMENT, "create: out is NULL");
  *out = NULL;
  return make(host, id, preset, values, value_count, out, NULL);
}

int32_t texture_memory(const sozai_host *host, const char *id, const char *preset,
                       const sozai_value *values, uint32_t value_count, sozai_memory *out) {
  int32_t r = memory_clear(out, "texture");
  sozai_texture *none = NULL;
  return r ? r : make(host, id, preset, values, value_count, &none, out);
}

static inline uint32_t missing(const float *const v[3]) {
  return (uint32_t)(v[0] == NULL) + (uint32_t)(v[1] == NULL) + (uint32_t)(v[2] == NULL);
}

/* Bits of what there is; part: not 0 where of a vector but the point a part is missing. */
static inline uint32_t inputs_of(const sozai_batch *b, uint32_t *part) {
  uint32_t point = missing(b->point), normal = missing(b->normal), light = missing(b->light);
  uint32_t colour = missing(b->light_colour), view = missing(b->view), has = 0;
  if (!point) has |= SOZAI_INPUT_POINT;
  if (!normal) has |= SOZAI_INPUT_NORMAL;
  if (!light) has |= SOZAI_INPUT_LIGHT;
  if (!colour) has |= SOZAI_INPUT_LIGHT_COLOUR;
  if (!view) has |= SOZAI_INPUT_VIEW;
  if (b->footprint) has |= SOZAI_INPUT_FOOTPRINT;
  /* 1 and 2, but not 0 and 3 */
  *part = ((normal + 1) | (light + 1) | (colour + 1) | (view + 1)) & 2;
  return has;
}

static const char *input_name(uint32_t bit) {
  switch (bit & (~bit + 1u)) {
  case SOZAI_INPUT_POINT:
    return "point";
  case SOZAI_INPUT_NORMAL:
    return "normal";
  case SOZAI_INPUT_LIGHT:
    return "light";
  case SOZAI_INPUT_LIGHT_COLOUR:
    return "light_colour";
  case SOZAI_INPUT_VIEW:
    return "view";
  default:
    return "footprint";
  }
}

static int32_t missing_input(const sozai_texture *t, uint64_t wanted, uint32_t has) {
  for (uint32_t k = 0; k < t->info->channel_count; k++) {
    const sozai_channel *c = t->info->channels[k];
    uint64_t bits = ((1ull << c->components) - 1) << c->first;
    if ((wanted & bits) && (c->needs & ~has)) {
      return fail(SOZAI_ERROR_ARGUMENT, "evaluate: channel %s needs the input %s", c->id,
                  input_name(c->needs & ~has));
    }
  }
  return fail(SOZAI_ERROR_ARGUMENT, "evaluate: an input is missing");
}

/* Bit k says that out[k] is NULL, of sixteen. */
static inline uint32_t absent16(float *const *out) {
#if defined(__x86_64__)
  /* a pointer is NULL where both its halves together are 0 */
  const __m128 *at = (const __m128 *)(const void *)out;
  __m128i zero = _mm_setzero_si128(), four[4];
  for (int k = 0; k < 4; k++) {
    __m128 a = _mm_loadu_ps((const float *)(at + 2 * k));
    __m128 b = _mm_loadu_ps((const float *)(at + 2 * k + 1));
    __m128 both = _mm_or_ps(_mm_shuffle_ps(a, b, 0x88), _mm_shuffle_ps(a, b, 0xdd));
    four[k] = _mm_cmpeq_epi32(_mm_castps_si128(both), zero);
  }
  __m128i low = _mm_packs_epi32(four[0], four[1]), high = _mm_packs_epi32(four[2], four[3]);
  return (uint32_t)_mm_movemask_epi8(_mm_packs_epi16(low, high));
#else
  uint32_t absent = 0;
  for (int k = 0; k < 16; k++) absent |= (uint32_t)(out[k] == NULL) << k;
  return absent;
#endif
}

/* Bit k says that out[k] is not NULL. */
static inline uint64_t wanted_of(float *const *out, uint32_t components) {
  uint64_t absent = 0;
  uint32_t i = 0;
  for (; i + 16 <= components; i += 16) absent |= (uint64_t)absent16(out + i) << i;
  for (; i < components; i++) absent |= (uint64_t)(out[i] == NULL) << i;
  return absent ^ ~0ull >> (64 - components);
}

/* On the path of every single point: a look at each wanted output, and no
 * more. Structs of another size, or with parts missing, take the long way. */
static int32_t evaluate(const sozai_texture *t, const sozai_batch *batch) {
  if (!t || !batch) return fail(SOZAI_ERROR_ARGUMENT, "evaluate: texture or batch is NULL");
  sozai_batch copy;
  if (batch->size != sizeof copy) {
    if (batch->size < 8) {
      return fail(SOZAI_ERROR_ARGUMENT, "evaluate: batch.size is %u: set it to sizeof(sozai_batch)",
                  batch->size);
    }
    memset(&copy, 0, sizeof copy);
    memcpy(&copy, batch, whole_members(batch->size, sizeof copy, PAIR_AT(sozai_batch, out_count)));
    batch = &copy;
  }
  uint32_t components = t->info->component_count, count = batch->out_count;
  float *const *out = batch->out;
  if (count && !out) return fail(SOZAI_ERROR_ARGUMENT, "evaluate: batch.out is NULL");
  float *padded[COMPONENTS_MAX];
  if (count < components) {
    memset(padded, 0, sizeof padded);
    if (count) memcpy(padded, out, count * sizeof *out);
    out = padded;
  }
  uint64_t wanted = wanted_of(out, components);

  uint32_t part, has = inputs_of(batch, &part);
  if (t->all_needs & ~has) {
    uint32_t needs = 0;
    for (uint32_t k = 0; k < t->kinds; k++) {
      if (wanted & t->needs[k].channels) needs |= t->needs[k].inputs;
    }
    if (needs & ~has) return missing_input(t, wanted, has);
  }
  if (part) {
    /* a vector with a part missing is none */
    if (batch != &copy) {
      copy = *batch;
      batch = &copy;
    }
    if (!(has & SOZAI_INPUT_NORMAL)) memset(copy.normal, 0, sizeof copy.normal);
    if (!(has & SOZAI_INPUT_LIGHT)) memset(copy.light, 0, sizeof copy.light);
    if (!(has & SOZAI_INPUT_LIGHT_COLOUR)) memset(copy.light_colour, 0, sizeof copy.light_colour);
    if (!(has & SOZAI_INPUT_VIEW)) memset(copy.view, 0, sizeof copy.view);
  }
  if (!wanted || !batch->count) return SOZAI_OK;
  if (t->images.count) images_forget();
  uint64_t mode = float_mode_enter();
  t->kind->evaluate(t->state, batch, out, wanted);
  float_mode_leave(mode);
  return t->images.count ? images_looked() : SOZAI_OK;
}

static int32_t value(const sozai_texture *t, const char *id, sozai_value *out) {
  if (!t || !id || !out) return fail(SOZAI_ERROR_ARGUMENT, "value: an argument is NULL");
  return settings_value(&t->given, t->info, id, out);
}

static const sozai_texture_info *info_of(const sozai_texture *t) { return t ? t->info : NULL; }

static uint64_t bytes(const sozai_texture *t) {
  if (!t) return 0;
  uint64_t held = t->kind->bytes ? t->kind->bytes(t->state) : 0;
  return sizeof *t + t->given.bytes + t->kind->state_bytes + images_bytes(&t->images) + held;
}

static const char *instruction_set(const sozai_texture *t) {
  return t ? t->kind->instruction_set(t->state) : "";
}

const void *texture_state(const sozai_texture *t, const material *m) {
  return t && t->kind == m ? t->state : NULL;
}

const sozai_textures_1 textures_table = {count,       info,  find,    create, destroy,
                                         evaluate,    value, info_of, bytes,  instruction_set,
                                         fail_message};
