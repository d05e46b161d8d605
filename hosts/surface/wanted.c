/* SPDX-License-Identifier: Apache-2.0 */
#include "wanted.h"

#include <string.h>

static bool is_wanted(const sozai_channel *c, const sozai_batch *b) {
  if (c->first + c->components > b->out_count) return false;
  for (uint32_t k = c->first; k < c->first + c->components; k++)
    if (b->out[k]) return true;
  return false;
}

void wanted_find(wanted *w, const surface_material *m, const sozai_batch *b) {
  const sozai_texture_info *info = m->textures->info_of(m->texture);
  w->channel_count = w->components = 0;
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *c = info->channels[i];
    if (!is_wanted(c, b) || w->components + c->components > SURFACE_COMPONENTS) continue;
    w->channels[w->channel_count++] = c;
    w->components += c->components;
  }
  w->most = surface_fit(w->components, WANTED_PART);
}

void wanted_place(const wanted *w, float *room, float **out) {
  for (uint32_t k = 0; k < SURFACE_COMPONENTS; k++) out[k] = NULL;
  for (uint32_t i = 0; i < w->channel_count; i++)
    for (uint32_t c = 0; c < w->channels[i]->components; c++, room += w->most)
      out[w->channels[i]->first + c] = room;
}

sozai_batch wanted_part(const sozai_batch *b, uint32_t first, uint32_t most, float **out) {
  sozai_batch part = *b;
  part.count = b->count - first < most ? b->count - first : most;
  for (int c = 0; c < 3; c++) {
    part.point[c] += first;
    if (part.normal[c]) part.normal[c] += first;
  }
  part.footprint += first;
  for (uint32_t k = 0; k < b->out_count; k++) out[k] = b->out[k] ? b->out[k] + first : NULL;
  part.out = out;
  return part;
}

bool wanted_filtered(const sozai_channel *c) {
  return (c->uses | c->needs) & SOZAI_INPUT_FOOTPRINT;
}
