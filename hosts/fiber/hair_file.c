/* SPDX-License-Identifier: Apache-2.0
 * The .hair format, after its published description: a header of 128 bytes,
 * then arrays, little-endian:
 *   0 "HAIR", 4 strands, 8 points, 12 which arrays there are (1 segments,
 *   2 points, 4 thickness, 8 transparency, 16 colours), 16 segments of a strand
 *   where there is no such array, 20 thickness, 24 transparency, 28 colour, 40
 *   88 bytes of text. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "curve_files.h"
#include "ceilings.h"

#define CHUNK 4096u

static void put32(unsigned char *to, uint32_t x) {
  for (int i = 0; i < 4; i++) to[i] = (unsigned char)(x >> 8 * i);
}

static void put_float(unsigned char *to, float x) {
  uint32_t bits;
  memcpy(&bits, &x, sizeof bits);
  put32(to, bits);
}

static bool put_header(FILE *f, const sozai_curves *c) {
  unsigned char h[128] = "HAIR";
  put32(h + 4, (uint32_t)c->curve_count);
  put32(h + 8, (uint32_t)c->point_count);
  put32(h + 12, 1 | 2 | 4 | 16);
  put_float(h + 20, c->point_count ? 2 * c->radii[0] : 0);
  for (int a = 0; a < 3; a++) put_float(h + 28 + 4 * a, c->part_count ? c->parts[0].colour[a] : 0);
  strcpy((char *)h + 40, "sozai fiber; mm, +y up; thickness: diameter; colours: sRGB");
  return fwrite(h, sizeof h, 1, f) == 1;
}

static bool put_segments(FILE *f, const sozai_curves *c) {
  for (uint64_t i = 0; i < c->curve_count; i++) {
    uint64_t n = c->first[i + 1] - c->first[i] - 1;
    unsigned char two[2] = {(unsigned char)n, (unsigned char)(n >> 8)};
    if (fwrite(two, 2, 1, f) != 1) return false;
  }
  return true;
}

/* count numbers of v times a factor. */
static bool put_floats(FILE *f, const float *v, uint64_t count, float by) {
  unsigned char out[4 * CHUNK];
  for (uint64_t i = 0; i < count; i += CHUNK) {
    uint64_t n = count - i < CHUNK ? count - i : CHUNK;
    for (uint64_t k = 0; k < n; k++) put_float(out + 4 * k, by * v[i + k]);
    if (cancel_requested() || fwrite(out, 4, n, f) != n) return false;
  }
  return true;
}

static bool put_colours(FILE *f, const sozai_curves *c) {
  for (uint32_t k = 0; k < c->part_count; k++) {
    const sozai_part *p = &c->parts[k];
    uint64_t points = c->first[p->first + p->count] - c->first[p->first];
    for (uint64_t i = 0; i < points; i++)
      if (!put_floats(f, p->colour, 3, 1)) return false;
  }
  return true;
}

bool curves_write_hair(const sozai_curves *c, const char *path, failure *why) {
  if (c->point_count >> 32 || c->curve_count >> 32)
    return fail(why, EXIT_BAD_INPUT, "--output: .hair holds 2^32 points at most, not %llu",
                (unsigned long long)c->point_count);
  for (uint64_t i = 0; i < c->curve_count; i++)
    if (c->first[i + 1] - c->first[i] > HAIR_MOST_SEGMENTS)
      return fail(why, EXIT_BAD_INPUT, "--output: .hair holds %u segments a strand at most",
                  HAIR_MOST_SEGMENTS);
  FILE *f = fopen(path, "wb");
  if (!f) return fail(why, EXIT_FAILURE, "cannot write '%s': %s", path, strerror(errno));
  bool ok = put_header(f, c) && put_segments(f, c) &&
            put_floats(f, c->points, 3 * c->point_count, 1) &&
            put_floats(f, c->radii, c->point_count, 2) && put_colours(f, c);
  ok = fclose(f) == 0 && ok;
  if (cancel_requested()) return fail(why, EXIT_FAILURE, "cancelled");
  return ok || fail(why, EXIT_FAILURE, "cannot write '%s': %s", path, strerror(errno));
}
