/* SPDX-License-Identifier: Apache-2.0
 *
 * A fuzz target without libFuzzer, for builds by any compiler: every file of the given
 * folders, then mutations of them, always the same for a seed.
 *
 *   replay [-n MUTATIONS] [-s SEED] FOLDER|FILE...
 *
 * Where an input ends the process, it is left in the file ./crash-TARGET, and its number and
 * the seed are said. */
#include "fuzz.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_INPUTS 4096
#define LONGEST 65536u /* bytes of a mutation */

typedef struct input {
  uint8_t *data;
  size_t size;
} input;

static input inputs[MOST_INPUTS];
static size_t count;
static uint64_t state;

/* ---- what is under way, for whoever has to look at a crash ------------------ */

static const uint8_t *now;
static size_t now_size;
static char left[128], message[256];

static void leave(void) {
  int file = open(left, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file >= 0 && write(file, now, now_size) == (ssize_t)now_size) close(file);
  if (write(STDERR_FILENO, message, strlen(message)) < 0) return;
}

static void on_signal(int number) {
  leave();
  signal(number, SIG_DFL);
  raise(number);
}

#if defined(__has_feature)
#if __has_feature(address_sanitizer) && !defined(__SANITIZE_ADDRESS__)
#define __SANITIZE_ADDRESS__ 1 /* as GCC says it */
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
void __asan_set_death_callback(void (*)(void));
#endif

static void watch(const char *program) {
  const char *name = strrchr(program, '/');
  snprintf(left, sizeof left, "crash-%.100s", name ? name + 1 : program);
#if defined(__SANITIZE_ADDRESS__)
  __asan_set_death_callback(leave);
  const int signals[] = {SIGABRT}; /* the others are the sanitizer's */
#else
  const int signals[] = {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
#endif
  for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) signal(signals[i], on_signal);
}

/* A copy without room behind it, so that a byte past the end is past the block's. */
static void run(const uint8_t *data, size_t size, const char *what, size_t number, uint64_t seed) {
  uint8_t *copy = malloc(size ? size : 1);
  CHECK(copy);
  if (size) memcpy(copy, data, size);
  now = copy;
  now_size = size;
  snprintf(message, sizeof message, "\n%s %zu (seed %llu) ended it; it is kept in %s\n", what,
           number, (unsigned long long)seed, left);
  LLVMFuzzerTestOneInput(copy, size);
  free(copy);
}

/* ---- inputs ----------------------------------------------------------------- */

static void add_file(const char *path) {
  FILE *file = fopen(path, "rb");
  CHECK(file && count < MOST_INPUTS);
  uint8_t *data = malloc(LONGEST);
  CHECK(data);
  inputs[count++] = (input){data, fread(data, 1, LONGEST, file)};
  fclose(file);
}

static int by_name(const void *a, const void *b) {
  return strcmp(*(char *const *)a, *(char *const *)b);
}

/* By name, whatever order the folder has them in. */
static void add(const char *path) {
  struct stat s;
  if (stat(path, &s) != 0) return; /* no regressions yet */
  if (!S_ISDIR(s.st_mode)) {
    add_file(path);
    return;
  }
  char *names[MOST_INPUTS];
  size_t found = 0;
  DIR *folder = opendir(path);
  CHECK(folder);
  for (struct dirent *e; (e = readdir(folder)) && found < MOST_INPUTS;)
    if (e->d_name[0] != '.') CHECK(names[found++] = strdup(e->d_name));
  closedir(folder);
  qsort(names, found, sizeof *names, by_name);
  for (size_t i = 0; i < found; i++) {
    char file[4096];
    snprintf(file, sizeof file, "%s/%s", path, names[i]);
    add(file);
    free(names[i]);
  }
}

/* ---- mutations: splitmix64 decides ------------------------------------------ */

static uint32_t chance(uint32_t below) {
  uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return (uint32_t)((z ^ z >> 31) >> 32) % below;
}

static size_t mutate(uint8_t *to, size_t size) {
  static const char *const words[] = {"nan",  "inf",  "-1", "1e308", "0",  "99999999999", "\n",
                                      "%%\n", "\xff", "[",  "{",     ": ", "@",           ","};
  uint8_t piece[256];
  uint32_t length, at = chance((uint32_t)size + 1);
  switch (chance(6)) {
  case 0: /* a bit */
    if (at < size) to[at] ^= (uint8_t)(1u << chance(8));
    return size;
  case 1: /* a byte */
    if (at < size) to[at] = (uint8_t)chance(256);
    return size;
  case 2: /* cut off */
    return at;
  case 3: { /* out of the middle */
    length = chance(32) + 1;
    if (at + length > size) return size;
    memmove(to + at, to + at + length, size - at - length);
    return size - length;
  }
  case 4: { /* a word in the middle */
    const char *word = words[chance(sizeof words / sizeof *words)];
    length = (uint32_t)strlen(word);
    memcpy(piece, word, length);
    break;
  }
  default: { /* a piece of another */
    const input *other = &inputs[chance((uint32_t)count)];
    length = chance(sizeof piece);
    if (length > other->size) length = (uint32_t)other->size;
    if (length) memcpy(piece, other->data + chance((uint32_t)(other->size - length) + 1), length);
  }
  }
  if (size + length > LONGEST) return size;
  memmove(to + at + length, to + at, size - at);
  memcpy(to + at, piece, length);
  return size + length;
}

int main(int argc, char **argv) {
  uint64_t mutations = 0, seed = 1;
  watch(argv[0]);
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "-n") == 0 && i + 1 < argc)
      mutations = strtoull(argv[++i], NULL, 10);
    else if (strcmp(argv[i], "-s") == 0 && i + 1 < argc)
      seed = strtoull(argv[++i], NULL, 10);
    else
      add(argv[i]);
  }
  if (count == 0) {
    fprintf(stderr, "no input: replay [-n MUTATIONS] [-s SEED] FOLDER|FILE...\n");
    return 2;
  }
  for (size_t i = 0; i < count; i++) run(inputs[i].data, inputs[i].size, "file", i, seed);
  uint8_t *data = malloc(LONGEST);
  CHECK(data);
  state = seed;
  for (uint64_t i = 0; i < mutations; i++) {
    const input *from = &inputs[chance((uint32_t)count)];
    size_t size = from->size;
    if (size) memcpy(data, from->data, size);
    for (uint32_t k = chance(4) + 1; k > 0; k--) size = mutate(data, size);
    run(data, size, "mutation", (size_t)i, seed);
  }
  printf("%zu inputs and %llu mutations of them, seed %llu\n", count, (unsigned long long)mutations,
         (unsigned long long)seed);
  free(data);
  for (size_t i = 0; i < count; i++) free(inputs[i].data);
  return 0;
}
