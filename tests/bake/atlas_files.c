/* SPDX-License-Identifier: Apache-2.0
 * Meshes in files: every format gives the same atlas, UVs of no use are left out,
 * and what is of no use at all is refused. */
#include "atlases.h"

#include <math.h>
#include <string.h>
#include <unistd.h>
#include <assimp/cexport.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include "meshes.h"

#define SIDE 200u /* texels of the pictures compared whole */

/* ---- UVs of no use -------------------------------------------------------------- */

static void useless_uvs_are_counted_and_left_out(void **state) {
  (void)state;
  const float t[7][15] = {
      {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.1f, 0.1f, 0.4f, 0.1f, 0.1f, 0.4f},     /* good */
      {0, 0, 5, 1, 0, 5, 0, 1, 5, 0.1f, 0.1f, 0.4f, 0.1f, 0.1f, 0.4f},     /* over it */
      {0, 0, 6, 1, 0, 6, 0, 1, 6, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f},     /* a point */
      {0, 0, 7, 1, 0, 7, 0, 1, 7, 0.5f, 0.5f, 0.6f, 0.6f, 0.7f, 0.7f},     /* a line */
      {0, 0, 8, 1, 0, 8, 0, 1, 8, -0.5f, -0.5f, -0.1f, -0.5f, -0.5f, 0},   /* below 0 */
      {0, 0, 9, 1, 0, 9, 0, 1, 9, 10.5f, 0.5f, 10.9f, 0.5f, 10.5f, 0.9f},  /* past u 10 */
      {0, 0, 4, 1, 0, 4, 0, 1, 4, 1e30f, 0.5f, 10.9f, 0.5f, 10.5f, 1e30f}, /* nowhere */
  };
  atlas *a = atlas_of(t, 7);
  const atlas_counts *c = atlas_counts_of(a);
  assert_int_equal(c->triangles, 7);
  assert_int_equal(c->hidden, 1);
  assert_int_equal(c->degenerate, 2);
  assert_int_equal(c->outside, 2);
  assert_int_equal(c->without, 0);
  assert_int_equal(c->afar, 1);
  assert_int_equal(atlas_udim_count(a), 1);
  char text[256];
  assert_true(atlas_warning(a, text, sizeof text));
  assert_non_null(strstr(text, "of 7 triangles 1 with UVs past 1000000"));
  texels p = texels_of(a, 1001, 20, 20);
  for (int i = 0; i < 400; i++)
    if (p.room.covered[i]) assert_true(p.room.point[2][i] == 0); /* the first of the two */
  texels_free(&p);
  atlas_close(a);
  a = leg_atlas(NULL);
  assert_false(atlas_warning(a, text, sizeof text));
  atlas_close(a);
}

/* UVs that are no numbers are in binary files only: a PLY of three corners. */
static void nan_uvs_are_left_out(void **state) {
  (void)state;
  const float corners[15] = {0, 0, 0, NAN, 0, 1, 0, 0, 1, NAN, 0, 1, 0, INFINITY, 1};
  const int32_t face[3] = {0, 1, 2};
  FILE *file = begin_mesh("nan.ply");
  fputs("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nproperty float s\nproperty float t\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n",
        file);
  fwrite(corners, sizeof corners, 1, file);
  fputc(3, file);
  fwrite(face, sizeof face, 1, file);
  assert_int_equal(fclose(file), 0);
  failure why;
  atlas *a = NULL;
  bool opened = atlas_open(&a, path_of("nan.ply"), 1, &why);
  assert_int_equal(unlink(path_of("nan.ply")), 0);
  assert_false(opened);
  if (!strstr(why.text, "1 without UVs")) fail_msg("%s", why.text);
}

static void refused(const char *text, const char *name, const char *const *words) {
  FILE *file = begin_mesh(name);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
  failure why = {0};
  atlas *a = NULL;
  bool opened = atlas_open(&a, path_of(name), 1, &why);
  assert_int_equal(unlink(path_of(name)), 0);
  if (opened) fail_msg("%s was opened", name);
  assert_null(a);
  assert_int_equal(why.exit_code, EXIT_BAD_INPUT);
  for (; *words; words++)
    if (!strstr(why.text, *words)) fail_msg("'%s' is not in: %s", *words, why.text);
}

static void meshes_of_no_use_are_refused(void **state) {
  (void)state;
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "bare.obj",
          (const char *const[]){"bare.obj", "no UVs", NULL});
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvt 2 2\nf 1/1 2/2 3/3\n", "line.obj",
          (const char *const[]){"line.obj", "1 without area", NULL});
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt -1 -1\nvt -1 -2\nvt -2 -2\nf 1/1 2/2 3/3\n", "under.obj",
          (const char *const[]){"under.obj", "outside every UDIM tile", NULL});
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1e9 0\nvt 0 1e9\nf 1/1 2/2 3/3\n", "afar.obj",
          (const char *const[]){"afar.obj", "1 with UVs past 1000000", NULL});
  refused("", "empty.obj", (const char *const[]){"empty.obj", NULL});
  refused("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n0",
          "huge.ply", (const char *const[]){"huge.ply", "4000000000", NULL});
  refused("{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{", "cut.gltf",
          (const char *const[]){"cut.gltf", NULL});
  refused("Kaydara FBX Binary  ", "cut.fbx", (const char *const[]){"cut.fbx", NULL});
  failure why;
  atlas *a = NULL;
  assert_false(atlas_open(&a, "/nowhere/at.obj", 1, &why));
  assert_non_null(strstr(why.text, "/nowhere/at.obj"));
}

/* ---- formats ---------------------------------------------------------------------- */

static void export(const char *from, const char *to, const char *format) {
  const struct aiScene *scene = aiImportFile(from, aiProcess_Triangulate);
  assert_non_null(scene);
  assert_int_equal(aiExportScene(scene, format, to, 0), AI_SUCCESS);
  aiReleaseImport(scene);
}

/* Each way through a file gives the same points. */
static void formats_agree(void **state) {
  (void)state;
  static const char *const formats[][2] = {
      {"plyb", "box.ply"}, {"glb2", "box.glb"}, {"fbxa", "box.fbx"}};
  atlas *a = box_atlas(false, NULL);
  FILE *file = begin_mesh("box.obj");
  write_box(file, 20, false);
  assert_int_equal(fclose(file), 0);
  texels want = texels_of(a, 1001, SIDE, SIDE);
  for (int i = 0; i < 3; i++) {
    char from[256];
    snprintf(from, sizeof from, "%s", path_of("box.obj"));
    export(from, path_of(formats[i][1]), formats[i][0]);
    failure why;
    atlas *b = NULL;
    if (!atlas_open(&b, path_of(formats[i][1]), 1, &why)) fail_msg("%s", why.text);
    texels got = texels_of(b, 1001, SIDE, SIDE);
    for (size_t k = 0; k < (size_t)SIDE * SIDE; k++) {
      if (want.room.covered[k] != 1) continue;
      for (int c = 0; c < 3; c++)
        if (!(fabsf(want.room.point[c][k] - got.room.point[c][k]) < 1e-3f))
          fail_msg("%s: texel %zu: %g, not %g", formats[i][1], k, (double)got.room.point[c][k],
                   (double)want.room.point[c][k]);
    }
    texels_free(&got);
    atlas_close(b);
    assert_int_equal(unlink(path_of(formats[i][1])), 0);
  }
  texels_free(&want);
  atlas_close(a);
  assert_int_equal(unlink(path_of("box.obj")), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(useless_uvs_are_counted_and_left_out),
      cmocka_unit_test(nan_uvs_are_left_out),
      cmocka_unit_test(meshes_of_no_use_are_refused),
      cmocka_unit_test(formats_agree),
  };
  return cmocka_run_group_tests(tests, atlas_folder, atlas_no_folder);
}
