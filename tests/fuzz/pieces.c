/* SPDX-License-Identifier: Apache-2.0
 * What a bake left behind and another takes up: bake.txt, the input's first piece, and a
 * journal, all that follows. */
#include "fuzz.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "pieces.h"

#define UNITS 5
#define JOB "bake: 1\nsize: 64x64\n"
#define UNIT_BYTES 24

static void use(pieces *p, failure *why) {
  unsigned char pixels[UNIT_BYTES];
  for (uint64_t u = 0; u < UNITS; u++)
    if (pieces_has(p, u)) pieces_read(p, u, pixels, UNIT_BYTES, why);
}

/* Resuming throws a damaged end away, adds what is missing, and has then everything. */
static void go_on(const char *folder, const char *job) {
  pieces p;
  failure why = {0, ""};
  if (!pieces_open(&p, folder, job, UNITS, PIECES_RESUME, &why)) {
    CHECK(*why.text && !strchr(why.text, '\n'));
    return;
  }
  use(&p, &why);
  CHECK(pieces_write_as(&p, 1, 2, &why));
  unsigned char pixels[UNIT_BYTES];
  for (uint64_t u = 0; u < UNITS; u++) {
    memset(pixels, (int)u, sizeof pixels);
    if (pieces_has(&p, u) && pieces_read(&p, u, pixels, UNIT_BYTES, &why)) continue;
    memset(pixels, (int)u, sizeof pixels);
    CHECK(pieces_add(&p, u, pixels, UNIT_BYTES, &why));
  }
  pieces_close(&p, false);
  CHECK(pieces_open(&p, folder, job, UNITS, PIECES_MERGE, &why) && pieces_lock(&p, &why));
  for (uint64_t u = 0; u < UNITS; u++)
    CHECK(pieces_has(&p, u) && pieces_read(&p, u, pixels, UNIT_BYTES, &why));
  pieces_close(&p, true);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  size_t length;
  char *text = take_piece(data, size, 0, &length);
  size_t after = length + 3 < size ? length + 3 : size;
  char folder[128];
  snprintf(folder, sizeof folder, "%s", scratch_path("pieces"));
  mkdir(folder, 0700);
  scratch_file("pieces/bake.txt", text, length);
  scratch_file("pieces/1-of-2.pieces", data + after, size - after);
  /* of the same bake, whatever it is, and of another */
  pieces p;
  failure why = {0, ""};
  if (pieces_open(&p, folder, JOB, UNITS, PIECES_MERGE, &why)) {
    use(&p, &why);
    pieces_close(&p, false);
  }
  if (strlen(text) == length) go_on(folder, text);
  unlink(scratch_path("pieces/1-of-2.pieces"));
  free(text);
  return 0;
}
