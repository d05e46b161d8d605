/* SPDX-License-Identifier: Apache-2.0
 * The files' writers on a mesh of hand: colours at its points are written; a plugin of ABI 1.3,
 * whose structs end before them, is read no further and has its parts' colours. */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "growth.h"

/* after failure.h, as cmocka has a macro `fail` */
#include <setjmp.h>
#include <stdarg.h>
#include <cmocka.h>

static const float points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, uv[8] = {0},
                   normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, radii[] = {1, 1, 1, 1},
                   colours[] = {0, 0, 0, 1, 1, 1, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
static const uint32_t owner[4] = {0}, indices[] = {0, 1, 2, 2, 3, 2}, ids[2] = {0, 1};
static const uint64_t first[] = {0, 2, 4};
static const sozai_part parts[] = {{"bark", 0, 1, {0.5f, 0.5f, 0.5f}, 0},
                                   {"leaf", 1, 1, {0.5f, 0.5f, 0.5f}, 0}};
static const sozai_mesh mesh = {.size = sizeof mesh,
                                .part_count = 2,
                                .point_count = 4,
                                .triangle_count = 2,
                                .points = points,
                                .normals = normals,
                                .uv = uv,
                                .owner = owner,
                                .indices = indices,
                                .parts = parts,
                                .colours = colours};
static const sozai_curves curves = {.size = sizeof curves,
                                    .part_count = 2,
                                    .curve_count = 2,
                                    .point_count = 4,
                                    .points = points,
                                    .radii = radii,
                                    .first = first,
                                    .ids = ids,
                                    .parts = parts,
                                    .colours = colours};

/* As ABI 1.3 ends it; what lies behind it there is anything at all. */
static sozai_mesh older_mesh(void) {
  sozai_mesh m = mesh;
  m.size = offsetof(sozai_mesh, colours);
  m.colours = (const float *)(uintptr_t)0x10;
  return m;
}

static sozai_curves older_curves(void) {
  sozai_curves c = curves;
  c.size = offsetof(sozai_curves, colours);
  c.colours = (const float *)(uintptr_t)0x10;
  return c;
}

static char text[65536];

static const char *written(bool gltf, const sozai_mesh *m, const sozai_curves *c) {
  char path[] = "/tmp/sozai-writers-XXXXXX";
  int file = mkstemp(path);
  assert_true(file >= 0);
  failure why = {0};
  bool ok = gltf ? write_gltf(m, path, &why) : write_usda(m, c, path, &why);
  assert_true(ok);
  ssize_t n = read(file, text, sizeof text - 1);
  assert_true(n > 0);
  text[n] = 0;
  close(file);
  unlink(path);
  return text;
}

static void has(const char *words) {
  if (!strstr(text, words)) print_error("no %s in\n%s\n", words, text);
  assert_non_null(strstr(text, words));
}

static void lacks(const char *words) {
  if (strstr(text, words)) print_error("%s in\n%s\n", words, text);
  assert_null(strstr(text, words));
}

static uint8_t sextet(char c) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const char *at = strchr(letters, c);
  return (uint8_t)(at ? at - letters : 0);
}

/* The byte of glTF's buffer. */
static uint8_t byte_at(size_t i) {
  const char *from = strstr(text, "base64,") + 7 + i / 3 * 4;
  uint32_t bits = 0;
  for (int k = 0; k < 4; k++) bits = bits << 6 | sextet(from[k]);
  return (uint8_t)(bits >> (16 - 8 * (i % 3)));
}

static void gltf(void **unused) {
  (void)unused;
  written(true, &mesh, NULL);
  /* bark alone: a leaf's points have its part's colour */
  has("\"TEXCOORD_0\":2,\"COLOR_0\":5},\"indices\":3,\"material\":0}");
  has("\"TEXCOORD_0\":2},\"indices\":4,\"material\":1}");
  has("\"baseColorFactor\":[1.0000,1.0000,1.0000,1]");
  has("\"extras\":{\"colour\":[0.2150,0.2150,0.2150]}");
  has("{\"bufferView\":4,\"componentType\":5123,\"normalized\":true,\"count\":4,\"type\":"
      "\"VEC4\"}");
  has("{\"buffer\":0,\"byteOffset\":152,\"byteLength\":32,\"target\":34962}");
  has("\"byteLength\":184,\"uri\"");
  static const unsigned shares[16] = {0,     0,     0,     65535, 65535, 65535, 65535, 65535,
                                      14090, 14090, 14090, 65535, 14090, 14090, 14090, 65535};
  for (size_t i = 0; i < 16; i++) {
    unsigned got = byte_at(152 + 2 * i) | (unsigned)byte_at(153 + 2 * i) << 8;
    if (abs((int)got - (int)shares[i]) > 2) print_error("share %zu: %u\n", i, got);
    assert_true(abs((int)got - (int)shares[i]) <= 2);
  }
}

static void usd(void **unused) {
  (void)unused;
  static const char at_points[] = "primvars:displayColor = [(0, 0, 0), (1, 1, 1), (0.214, 0.214, "
                                  "0.214), (0.214, 0.214, 0.214)] (\n            interpolation = "
                                  "\"vertex\"";
  written(false, &mesh, NULL);
  has(at_points);
  written(false, NULL, &curves);
  has(at_points);
}

static void of_an_older_plugin(void **unused) {
  (void)unused;
  sozai_mesh m = older_mesh();
  sozai_curves c = older_curves();
  assert_null(growth_mesh_colours(&m));
  assert_null(growth_curves_colours(&c));
  assert_true(growth_mesh_colours(&mesh) == colours && growth_curves_colours(&curves) == colours);
  written(true, &m, NULL);
  lacks("COLOR_0");
  lacks("extras");
  has("\"baseColorFactor\":[0.2150,0.2150,0.2150,1]");
  has("\"byteLength\":152,\"uri\"");
  static const char at_parts[] = "primvars:displayColor = [(0.214, 0.214, 0.214), (0.214, 0.214, "
                                 "0.214)] (\n            interpolation = \"uniform\"";
  written(false, &m, NULL);
  has(at_parts);
  written(false, NULL, &c);
  has(at_parts);
  m = mesh;
  m.colours = NULL;
  written(true, &m, NULL);
  lacks("COLOR_0");
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(gltf), cmocka_unit_test(usd),
                                     cmocka_unit_test(of_an_older_plugin)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
