/* SPDX-License-Identifier: Apache-2.0
 * Wavefront OBJ: v, vt, vn, and a group and material name for each part. Units
 * are millimetres; OBJ itself has none. */
#include "growth.h"
#include "text_file.h"

static void put_triple(text_file *t, const char *word, const float *v, bool fine) {
  text_put(t, word);
  for (int c = 0; c < 3; c++) {
    text_put(t, " ");
    if (fine)
      text_fine(t, (double)v[c]);
    else
      text_number(t, (double)v[c]);
  }
  text_put(t, "\n");
}

static void put_corner(text_file *t, uint32_t index) {
  text_put(t, " ");
  for (int i = 0; i < 3; i++) {
    if (i) text_put(t, "/");
    text_whole(t, (uint64_t)index + 1);
  }
}

bool write_obj(const sozai_mesh *m, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "# sozai tree; millimetres, +y up\n");
  for (uint64_t i = 0; i < m->point_count; i++) put_triple(&t, "v", m->points + 3 * i, false);
  for (uint64_t i = 0; i < m->point_count; i++) {
    text_put(&t, "vt ");
    text_fine(&t, (double)m->uv[2 * i]);
    text_put(&t, " ");
    text_fine(&t, (double)m->uv[2 * i + 1]);
    text_put(&t, "\n");
  }
  for (uint64_t i = 0; i < m->point_count; i++) put_triple(&t, "vn", m->normals + 3 * i, true);
  for (uint32_t k = 0; k < m->part_count; k++) {
    const sozai_part *part = &m->parts[k];
    text_put(&t, "g ");
    text_put(&t, part->id);
    text_put(&t, "\nusemtl ");
    text_put(&t, part->id);
    text_put(&t, "\n");
    for (uint64_t i = part->first; i < part->first + part->count; i++) {
      text_put(&t, "f");
      for (uint64_t c = 0; c < 3; c++) put_corner(&t, m->indices[3 * i + c]);
      text_put(&t, "\n");
    }
  }
  return text_close(&t, why);
}
