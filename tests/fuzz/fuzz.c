/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* memmem, nftw */
#include "fuzz.h"

#include <fcntl.h>
#include <ftw.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

uint8_t take_u8(bytes *b) {
  if (b->left == 0) return 0;
  b->left--;
  return *b->at++;
}

uint32_t take_u32(bytes *b) {
  uint32_t n = 0;
  for (int i = 0; i < 4; i++) n |= (uint32_t)take_u8(b) << 8 * i;
  return n;
}

uint32_t take_below(bytes *b, uint32_t count) {
  uint32_t n = take_u8(b);
  if (count > 256) n |= (uint32_t)take_u8(b) << 8;
  return n % count;
}

float take_float(bytes *b) {
  uint32_t bits = take_u32(b);
  float f;
  memcpy(&f, &bits, sizeof f);
  return f;
}

double take_number(bytes *b, double low, double high) {
  const double special[] = {0,
                            low,
                            high,
                            nextafter(high, INFINITY),
                            -0.0,
                            NAN,
                            INFINITY,
                            -INFINITY,
                            1e30,
                            -1e300,
                            5e-324,
                            4294967296.0,
                            0.5,
                            0x1p63,
                            nextafter(low, -INFINITY)};
  uint8_t kind = take_u8(b);
  if (kind < sizeof special / sizeof *special) return special[kind];
  if (kind < 24) return (double)take_float(b);
  double share = (take_u8(b) * 256.0 + take_u8(b)) / 65535;
  double wide = high - low, x = low + share * (isfinite(wide) ? wide : 1e6);
  return kind & 1 ? floor(x) : x;
}

char *take_text(bytes *b, size_t most) {
  size_t length = take_u8(b);
  if (length > most) length = most;
  if (length > b->left) length = b->left;
  char *text = malloc(length + 1);
  CHECK(text);
  for (size_t i = 0; i < length; i++) text[i] = b->at[i] ? (char)b->at[i] : ' ';
  text[length] = '\0';
  b->at += length;
  b->left -= length;
  return text;
}

char *take_piece(const uint8_t *data, size_t size, uint32_t index, size_t *length) {
  const uint8_t *at = data, *end = data + size, *stop = end;
  for (uint32_t piece = 0; at; piece++) {
    const uint8_t *mark =
        (size_t)(end - at) >= 3 ? memmem(at, (size_t)(end - at), "%%\n", 3) : NULL;
    stop = mark ? mark : end;
    if (piece == index) break;
    at = mark ? mark + 3 : NULL;
  }
  size_t n = at ? (size_t)(stop - at) : 0;
  char *text = malloc(n + 1);
  CHECK(text);
  if (n) memcpy(text, at, n);
  text[n] = '\0';
  if (length) *length = n;
  return text;
}

/* ---- files ----------------------------------------------------------------- */

static char folder[64];
static long owner;

static int remove_one(const char *path, const struct stat *s, int kind, struct FTW *f) {
  (void)s, (void)kind, (void)f;
  return remove(path);
}

static void remove_folder(void) {
  if (owner == getpid()) nftw(folder, remove_one, 8, FTW_DEPTH | FTW_PHYS);
}

const char *scratch_path(const char *name) {
  static char path[4][128];
  static uint32_t turn;
  if (!folder[0]) {
    static const char *const places[] = {"/dev/shm", "/tmp"}; /* memory is faster */
    char *made = NULL;
    for (int i = 0; i < 2 && !made; i++) {
      snprintf(folder, sizeof folder, "%s/sozai-fuzz-XXXXXX", places[i]);
      made = mkdtemp(folder);
    }
    CHECK(made);
    owner = getpid();
    atexit(remove_folder);
  }
  char *to = path[turn++ % 4];
  snprintf(to, sizeof path[0], "%s/%s", folder, name);
  return to;
}

const char *scratch_file(const char *name, const void *data, size_t size) {
  const char *path = scratch_path(name);
  int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  CHECK(file >= 0);
  CHECK(write(file, size ? data : "", size) == (ssize_t)size);
  close(file);
  return path;
}
