/* SPDX-License-Identifier: Apache-2.0
 * That descriptions keep their address and content. */
#include "describe.h"

#include <pthread.h>
#include <string.h>

static kind kinds[KINDS_MOST];

/* A digest of all that is described, by its contents and not its addresses. */
static uint64_t digest(uint64_t h, const void *bytes, size_t n) {
  for (size_t i = 0; i < n; i++) h = (h ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3u;
  return h;
}

static uint64_t digest_text(uint64_t h, const char *text) {
  return text ? digest(h, text, strlen(text) + 1) : digest(h, "", 1) + 1;
}

static uint64_t digest_kind(const kind *k) {
  uint64_t h = 0xcbf29ce484222325u;
  h = digest_text(digest_text(digest_text(h, k->id), k->label), k->doc);
  for (uint32_t i = 0; i < k->parameter_count; i++) {
    const sozai_parameter *p = k->parameters[i];
    h = digest_text(digest_text(digest_text(h, p->id), p->unit), p->doc);
    h = digest_text(digest(h, &p->hard_min, 7 * sizeof(double)), p->default_text);
    h = digest(digest(h, &p->kind, 4), &p->choice_count, 4);
    for (uint32_t c = 0; p->choices && c < p->choice_count; c++) h = digest_text(h, p->choices[c]);
  }
  for (uint32_t i = 0; i < k->preset_count; i++) {
    h = digest_text(h, k->presets[i]->id);
    h = digest(h, &k->presets[i]->value_count, 4);
  }
  for (uint32_t i = 0; k->texture && i < k->texture->channel_count; i++) {
    const sozai_channel *c = k->texture->channels[i];
    h = digest_text(h, c->id);
    h = digest(h, &c->first, 16);
  }
  return h;
}

static void *count_other(void *context) {
  static kind other[KINDS_MOST];
  const subject *s = context;
  uint32_t n = subject_kinds(s, other), differ = 0;
  for (uint32_t i = 0; i < n; i++)
    differ += other[i].texture != kinds[i].texture || other[i].generator != kinds[i].generator;
  return differ ? context : NULL;
}

/* "A kind of texture. Lives until the last deinit." */
void describe_stable(subject *s) {
  uint32_t n = subject_all(s, kinds);
  static uint64_t before[KINDS_MOST];
  for (uint32_t i = 0; i < n; i++) before[i] = digest_kind(&kinds[i]);
  EXPECT(!count_other(s), "info() gives another address when it is asked again");
  pthread_t thread;
  void *other = NULL;
  if (pthread_create(&thread, NULL, count_other, s) == 0) pthread_join(thread, &other);
  EXPECT(!other, "info() gives another address on another thread");
  for (uint32_t i = 0; i < n; i++) {
    sozai_texture *t = NULL;
    if (!kinds[i].texture) continue;
    doing("create of %s", kinds[i].id);
    s->textures->create(NULL, kinds[i].id, NULL, NULL, 0, &t);
    s->textures->destroy(t);
  }
  EXPECT(!count_other(s), "info() gives another address after create()");
  for (uint32_t i = 0; i < n; i++)
    EXPECT(digest_kind(&kinds[i]) == before[i], "the description of %s changed", kinds[i].id);
}
