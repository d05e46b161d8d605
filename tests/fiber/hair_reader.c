/* SPDX-License-Identifier: Apache-2.0
 * .hair: http://www.cemyuksel.com/research/hairmodels, its table of the header. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "readers.h"

static uint32_t word(const unsigned char *p) {
  return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static float number(const unsigned char *p) {
  uint32_t w = word(p);
  float f;
  memcpy(&f, &w, sizeof f);
  return f;
}

static float *floats(const unsigned char **at, const unsigned char *end, size_t n) {
  if ((size_t)(end - *at) < 4 * n) return NULL;
  float *out = malloc((n + 1) * sizeof *out);
  for (size_t i = 0; i < n; i++, *at += 4) out[i] = number(*at);
  return out;
}

static bool parse(strands_read *s, const unsigned char *file, size_t size) {
  const unsigned char *at = file + 128, *end = file + size;
  if (size < 128 || memcmp(file, "HAIR", 4) != 0) return false;
  s->curves = word(file + 4);
  s->points = word(file + 8);
  uint32_t arrays = word(file + 12), total = 0;
  if (!(arrays & 2)) return false; /* points there must be */
  s->counts = malloc((s->curves + 1) * sizeof *s->counts);
  for (uint32_t i = 0; i < s->curves; i++) {
    uint32_t segments = word(file + 16);
    if (arrays & 1) {
      if (end - at < 2) return false;
      segments = at[0] | (uint32_t)at[1] << 8;
      at += 2;
    }
    s->counts[i] = segments + 1;
    total += segments + 1;
  }
  if (total != s->points) return false;
  s->at = floats(&at, end, 3 * (size_t)s->points);
  if (arrays & 4) s->widths = floats(&at, end, s->points);
  if (arrays & 8) free(floats(&at, end, s->points));
  if (arrays & 16) {
    float *colours = floats(&at, end, 3 * (size_t)s->points);
    if (!colours) return false;
    memcpy(s->colour, colours, sizeof s->colour);
    free(colours);
  }
  return s->at && s->widths && at == end; /* nothing left over */
}

bool read_hair(strands_read *s, const char *path) {
  memset(s, 0, sizeof *s);
  FILE *f = fopen(path, "rb");
  if (!f) return false;
  fseek(f, 0, SEEK_END);
  long size = ftell(f);
  rewind(f);
  unsigned char *file = malloc((size_t)size + 1);
  bool ok = fread(file, 1, (size_t)size, f) == (size_t)size && parse(s, file, (size_t)size);
  fclose(f);
  free(file);
  return ok;
}

void strands_read_free(strands_read *s) {
  free(s->counts);
  free(s->at);
  free(s->widths);
  free(s->ids);
  memset(s, 0, sizeof *s);
}
