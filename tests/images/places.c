/* SPDX-License-Identifier: Apache-2.0 */
#include "places.h"

#include <math.h>

/* splitmix64 */
float random_unit(uint64_t *seed) {
  uint64_t x = *seed += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return (float)((x ^ (x >> 31)) >> 40) * 0x1p-24f;
}

static float footprint(uint64_t *seed, float least) {
  return expf(logf(least) * random_unit(seed));
}

void places_make(places *p, uint64_t seed, int pixels, float low, float high) {
  const float least = 0.02f / (float)pixels;
  for (int i = 0; i < PLACES; i++) {
    p->s[i] = low + (high - low) * random_unit(&seed);
    p->t[i] = low + (high - low) * random_unit(&seed);
    float a = 6.2831853f * random_unit(&seed), b = 6.2831853f * random_unit(&seed);
    float x = footprint(&seed, least), y = footprint(&seed, least);
    p->dsdx[i] = x * cosf(a);
    p->dtdx[i] = x * sinf(a);
    p->dsdy[i] = y * cosf(b);
    p->dtdy[i] = y * sinf(b);
  }
}

int32_t places_look(const services *s, const sozai_image *image, const places *p, uint32_t first,
                    uint32_t count, float (*out)[PLACES], uint32_t channels) {
  float *to[4] = {0};
  for (uint32_t c = 0; c < channels; c++) to[c] = out[c] + first;
  return s->images->sample(s->images->self, image, count, p->s + first, p->t + first,
                           p->dsdx + first, p->dtdx + first, p->dsdy + first, p->dtdy + first, to);
}

float *random_pixels(size_t count, uint64_t seed) {
  float *data = malloc(count * sizeof *data);
  assert_non_null(data);
  for (size_t i = 0; i < count; i++) data[i] = random_unit(&seed);
  return data;
}
