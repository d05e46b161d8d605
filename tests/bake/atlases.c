/* SPDX-License-Identifier: Apache-2.0 */
#include "atlases.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "meshes.h"

static char folder[] = "/tmp/sozai-atlas-XXXXXX";

int atlas_folder(void **state) {
  (void)state;
  return mkdtemp(folder) ? 0 : -1;
}

int atlas_no_folder(void **state) {
  (void)state;
  return rmdir(folder);
}

const char *path_of(const char *name) {
  static char path[256];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

FILE *begin_mesh(const char *name) {
  FILE *file = fopen(path_of(name), "w");
  assert_non_null(file);
  return file;
}

atlas *open_mesh(FILE *file, const char *name, mesh *also) {
  failure why;
  atlas *a = NULL;
  assert_int_equal(fclose(file), 0);
  if (!atlas_open(&a, path_of(name), 1, &why)) fail_msg("%s", why.text);
  if (also) assert_true(mesh_read(also, path_of(name), 1, &why));
  assert_int_equal(unlink(path_of(name)), 0);
  return a;
}

atlas *box_atlas(bool udim, mesh *also) {
  FILE *file = begin_mesh("box.obj");
  write_box(file, 20, udim);
  return open_mesh(file, "box.obj", also);
}

atlas *leg_atlas(mesh *also) {
  FILE *file = begin_mesh("leg.obj");
  write_leg(file, 24, 32);
  return open_mesh(file, "leg.obj", also);
}

atlas *atlas_of(const float (*t)[15], unsigned count) {
  FILE *file = begin_mesh("few.obj");
  for (unsigned i = 0; i < count; i++) {
    for (int k = 0; k < 3; k++)
      fprintf(file, "v %.9g %.9g %.9g\nvt %.9g %.9g\n", (double)t[i][3 * k],
              (double)t[i][3 * k + 1], (double)t[i][3 * k + 2], (double)t[i][9 + 2 * k],
              (double)t[i][10 + 2 * k]);
    fputs("f -3/-3 -2/-2 -1/-1\n", file);
  }
  return open_mesh(file, "few.obj", NULL);
}

texels texels_room(uint32_t w, uint32_t h) {
  texels t = {.w = w, .h = h};
  size_t n = (size_t)w * h;
  t.memory = malloc(7 * n * sizeof *t.memory + 1);
  t.room.covered = malloc(n + 1);
  assert_true(t.memory && t.room.covered);
  memset(t.memory, 0x7f, 7 * n * sizeof *t.memory);
  memset(t.room.covered, 0x7f, n);
  for (size_t k = 0; k < 3; k++) {
    t.room.point[k] = t.memory + k * n;
    t.room.normal[k] = t.memory + (3 + k) * n;
  }
  t.room.footprint = t.memory + 6 * n;
  return t;
}

void texels_free(texels *t) {
  free(t->memory);
  free(t->room.covered);
}

texels texels_of(const atlas *a, int udim, uint32_t w, uint32_t h) {
  texels t = texels_room(w, h);
  assert_true(atlas_texels(a, udim, w, h, 0, 0, w, h, &t.room));
  return t;
}
