/* SPDX-License-Identifier: Apache-2.0
 * glTF 2.0 in one file, its buffer within as base64; a node scales millimetres
 * to glTF's metres. One primitive and one material for each part. */
#include <stdio.h>
#include "growth.h"
#include "text_file.h"

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

static double linear(float code) {
  double x = (double)code;
  return x * (x * (x * 0.305306011 + 0.682171111) + 0.012522878); /* sRGB's, within 0.002 */
}

static void put_parts(text_file *t, const sozai_mesh *m) {
  text_put(t, "\"meshes\":[{\"name\":\"tree\",\"primitives\":[");
  for (uint32_t k = 0; k < m->part_count; k++)
    put_format(t,
               "%s{\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"TEXCOORD_0\":2},\"indices\":%u,"
               "\"material\":%u}",
               k ? "," : "", k + 3, k);
  text_put(t, "]}],\"materials\":[");
  for (uint32_t k = 0; k < m->part_count; k++) {
    const sozai_part *p = &m->parts[k];
    put_format(t,
               "%s{\"name\":\"%s\",\"doubleSided\":true,\"pbrMetallicRoughness\":{"
               "\"baseColorFactor\":[%.4f,%.4f,%.4f,1],\"metallicFactor\":0,"
               "\"roughnessFactor\":0.8}}",
               k ? "," : "", p->id, linear(p->colour[0]), linear(p->colour[1]),
               linear(p->colour[2]));
  }
  text_put(t, "],");
}

static void put_accessors(text_file *t, const sozai_mesh *m) {
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
  unsigned long long indices = 12ull * m->triangle_count;
  put_format(t,
             "],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":%llu,"
             "\"target\":34962},{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,"
             "\"target\":34962},{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,"
             "\"target\":34962},{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu,"
             "\"target\":34963}],",
             12 * n, 12 * n, 12 * n, 24 * n, 8 * n, 32 * n, indices);
  put_format(t, "\"buffers\":[{\"byteLength\":%llu,\"uri\":\"data:application/octet-stream;base64,",
             32 * n + indices);
}

bool write_gltf(const sozai_mesh *m, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"sozai\"},\"scene\":0,"
               "\"scenes\":[{\"nodes\":[0]}],"
               "\"nodes\":[{\"name\":\"tree\",\"mesh\":0,\"scale\":[0.001,0.001,0.001]}],");
  put_parts(&t, m);
  put_accessors(&t, m);
  base64 b = {.to = &t};
  put_words(&b, m->points, 3 * m->point_count);
  put_words(&b, m->normals, 3 * m->point_count);
  put_words(&b, m->uv, 2 * m->point_count);
  put_words(&b, m->indices, 3 * m->triangle_count);
  if (b.count) put_four(&b);
  text_put(&t, "\"}]}\n");
  return text_close(&t, why);
}
