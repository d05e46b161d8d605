/* SPDX-License-Identifier: Apache-2.0
 * The functions of writer.h, handed on to sozai-pictures.so. */
#include "writer.h"

#include "../pictures/module.h"
#include "pictures.h"

bake_writer *writer_open(const char *path, const writer_spec *spec, failure *why) {
  const pictures *p = pictures_load(why);
  return p ? p->writer_open(path, spec, why) : NULL;
}

/* What is open has been loaded. */
static const pictures *here(void) {
  failure unused;
  return pictures_load(&unused);
}

bool writer_next_level(bake_writer *w, uint32_t width, uint32_t height, failure *why) {
  return here()->writer_next_level(w, width, height, why);
}

bool writer_rows(bake_writer *w, uint32_t row, uint32_t rows, const uint8_t *pixels, failure *why) {
  return here()->writer_rows(w, row, rows, pixels, why);
}

bool writer_close(bake_writer *w, failure *why) { return here()->writer_close(w, why); }

void writer_drop(bake_writer *w) {
  if (w) here()->writer_drop(w);
}
