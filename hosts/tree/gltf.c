/* SPDX-License-Identifier: Apache-2.0
 * glTF 2.0 in one file, its buffer within as base64; a node scales millimetres
 * to glTF's metres. One primitive and one material for each part; where a part's
 * points have colours of their own they are COLOR_0, by which glTF multiplies the
 * material's, which is white then: the part's own colour is its extra. */
#include <stdio.h>
#include "growth.h"
#include "text_file.h"

#define VARYING_MOST 16 /* parts; those past them are of one colour */

typedef struct base64 {
  text_file *to;
  uint8_t waiting[3];
  int count;
} base64;

static void put_four(base64 *b) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  uint32_t bits = (uint32_t)b->waiting[0] << 16 | (uint32_t)b->waiting[1] << 8 | b->waiting[2];
  char out[5] = {letters[bits >> 18], letters[bits >> 12 & 63], letters[bits >> 6 & 63],
                 letters[bits & 63], 0};
  for (int i = b->count + 1; i < 4; i++) out[i] = '=';
  text_put(b->to, out);
  b->count = 0;
  b->waiting[0] = b->waiting[1] = b->waiting[2] = 0;
}

/* Little-endian, as glTF wants it. */
static void put_words(base64 *b, const void *words, uint64_t count) {
  const uint32_t *from = words;
  for (uint64_t i = 0; i < count; i++)
    for (int k = 0; k < 4; k++) {
      b->waiting[b->count++] = (uint8_t)(from[i] >> (8 * k));
      if (b->count == 3) put_four(b);
    }
}

static void put_format(text_file *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void put_format(text_file *t, const char *format, ...) {
  char text[1024];
  __builtin_va_list list;
  __builtin_va_start(list, format);
  vsnprintf(text, sizeof text, format, list);
  __builtin_va_end(list);
  text_put(t, text);
}

/* Which parts have colours at their points; any: one at least. */
typedef struct varying {
  bool any, part[VARYING_MOST];
} varying;

static varying varying_of(const sozai_mesh *m) {
  varying v = {0};
  for (uint32_t k = 0; k < m->part_count && k < VARYING_MOST; k++)
    v.any |= v.part[k] = growth_part_varies(m, k);
  return v;
}

static bool varies(const varying *v, uint32_t part) { return part < VARYING_MOST && v->part[part]; }

static double linear(float code) {
  double x = (double)code;
  return x * (x * (x * 0.305306011 + 0.682171111) + 0.012522878); /* sRGB's, within 0.002 */
}

static void put_material(text_file *t, const sozai_part *p, bool at_points) {
  double rgb[3], white[3] = {1, 1, 1};
  for (int c = 0; c < 3; c++) rgb[c] = linear(p->colour[c]);
  const double *base = at_points ? white : rgb;
  put_format(t,
             "{\"name\":\"%s\",\"doubleSided\":true,\"pbrMetallicRoughness\":{"
             "\"baseColorFactor\":[%.4f,%.4f,%.4f,1],\"metallicFactor\":0,"
             "\"roughnessFactor\":0.8}",
             p->id, base[0], base[1], base[2]);
  if (at_points) put_format(t, ",\"extras\":{\"colour\":[%.4f,%.4f,%.4f]}", rgb[0], rgb[1], rgb[2]);
  text_put(t, "}");
}

/* Accessors and views: points, normals, uv, the parts' indices, colours. */
static void put_parts(text_file *t, const sozai_mesh *m, const varying *v) {
  text_put(t, "\"meshes\":[{\"name\":\"tree\",\"primitives\":[");
  for (uint32_t k = 0; k < m->part_count; k++) {
    put_format(t, "%s{\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"TEXCOORD_0\":2", k ? "," : "");
    if (varies(v, k)) put_format(t, ",\"COLOR_0\":%u", m->part_count + 3);
    put_format(t, "},\"indices\":%u,\"material\":%u}", k + 3, k);
  }
  text_put(t, "]}],\"materials\":[");
  for (uint32_t k = 0; k < m->part_count; k++) {
    if (k) text_put(t, ",");
    put_material(t, &m->parts[k], varies(v, k));
  }
  text_put(t, "],");
}

/* n points, so many bytes of indices. */
static void put_views(text_file *t, unsigned long long n, unsigned long long indices,
                      bool colours) {
  put_format(t,
             "],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":%llu,"
             "\"target\":34962},{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,"
             "\"target\":34962},{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,"
             "\"target\":34962},{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,"
             "\"target\":34963}",
             12 * n, 12 * n, 12 * n, 24 * n, 8 * n, 32 * n, indices);
  if (colours)
    put_format(t, ",{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,\"target\":34962}",
               32 * n + indices, 8 * n);
  put_format(t,
             "],\"buffers\":[{\"byteLength\":%llu,\"uri\":\"data:application/octet-stream;base64,",
             32 * n + indices + (colours ? 8 * n : 0));
}

/* Linear, four shares of 65535: the fourth, which is alpha, keeps each point's at whole words. */
static void put_colours(base64 *b, const float *colours, uint64_t count) {
  for (uint64_t i = 0; i < count; i++) {
    uint32_t share[4] = {0, 0, 0, 65535};
    for (uint64_t c = 0; c < 3; c++)
      share[c] = (uint32_t)(linear(colours[3 * i + c]) * 65535 + 0.5);
    const uint32_t words[2] = {share[0] | share[1] << 16, share[2] | share[3] << 16};
    put_words(b, words, 2);
  }
}

static void put_accessors(text_file *t, const sozai_mesh *m, bool colours) {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  for (uint64_t i = 0; i < m->point_count; i++)
    for (int c = 0; c < 3; c++) {
      double x = (double)m->points[3 * i + (uint64_t)c];
      if (i == 0 || x < low[c]) low[c] = x;
      if (i == 0 || x > high[c]) high[c] = x;
    }
  unsigned long long n = m->point_count;
  put_format(t,
             "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%llu,"
             "\"type\":\"VEC3\",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]},"
             "{\"bufferView\":1,\"componentType\":5126,\"count\":%llu,\"type\":\"VEC3\"},"
             "{\"bufferView\":2,\"componentType\":5126,\"count\":%llu,\"type\":\"VEC2\"}",
             n, low[0], low[1], low[2], high[0], high[1], high[2], n, n);
  for (uint32_t k = 0; k < m->part_count; k++)
    put_format(t,
               ",{\"bufferView\":3,\"byteOffset\":%llu,\"componentType\":5125,\"count\":%llu,"
               "\"type\":\"SCALAR\"}",
               12ull * m->parts[k].first, 3ull * m->parts[k].count);
  if (colours)
    put_format(t,
               ",{\"bufferView\":4,\"componentType\":5123,\"normalized\":true,\"count\":%llu,"
               "\"type\":\"VEC4\"}",
               n);
  put_views(t, n, 12ull * m->triangle_count, colours);
}

bool write_gltf(const sozai_mesh *m, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"sozai\"},\"scene\":0,"
               "\"scenes\":[{\"nodes\":[0]}],"
               "\"nodes\":[{\"name\":\"tree\",\"mesh\":0,\"scale\":[0.001,0.001,0.001]}],");
  varying v = varying_of(m);
  put_parts(&t, m, &v);
  put_accessors(&t, m, v.any);
  base64 b = {.to = &t};
  put_words(&b, m->points, 3 * m->point_count);
  put_words(&b, m->normals, 3 * m->point_count);
  put_words(&b, m->uv, 2 * m->point_count);
  put_words(&b, m->indices, 3 * m->triangle_count);
  if (v.any) put_colours(&b, growth_mesh_colours(m), m->point_count);
  if (b.count) put_four(&b);
  text_put(&t, "\"}]}\n");
  return text_close(&t, why);
}
