/* SPDX-License-Identifier: Apache-2.0 */
#include "temp.h"

#include "library.h"

#include <ftw.h>
#include <unistd.h>

enum { PATHS = 8 };

static char folder[64];

void temp_make(void) {
  strcpy(folder, "/tmp/sozai-images-XXXXXX");
  assert_non_null(mkdtemp(folder));
}

static int remove_one(const char *path, const struct stat *status, int type, struct FTW *at) {
  (void)status, (void)type, (void)at;
  return remove(path);
}

void temp_remove(void) { nftw(folder, remove_one, 8, FTW_DEPTH | FTW_PHYS); }

const char *temp_path(const char *name) {
  static char paths[PATHS][256];
  static unsigned used;
  char *path = paths[used++ % PATHS];
  snprintf(path, sizeof paths[0], "%s/%s", folder, name);
  return path;
}

void temp_write(const char *path, const void *data, size_t size) {
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(data, 1, size, file), size);
  assert_int_equal(fclose(file), 0);
}

unsigned char *temp_read(const char *path, size_t *size) {
  FILE *file = fopen(path, "rb");
  assert_non_null(file);
  fseek(file, 0, SEEK_END);
  *size = (size_t)ftell(file);
  rewind(file);
  unsigned char *data = malloc(*size + 1);
  assert_non_null(data);
  assert_int_equal(fread(data, 1, *size, file), *size);
  fclose(file);
  return data;
}
