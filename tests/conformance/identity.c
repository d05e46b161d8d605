/* SPDX-License-Identifier: Apache-2.0
 *
 * The same bits whatever the instruction set, batch size, alignment, mask,
 * choice of channels, number of threads and (--against) compiler, optimisation
 * or processor: identity_worker in a process of its own for each way, because
 * SOZAI_CPU is read once.
 *
 *   identity                              all ways of the plugin built here
 *   identity --against PLUGIN             another build, as the one built here
 *   identity --against PLUGIN --worker W [--runner R ARG...]
 *                                         one for another processor
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <cmocka.h>

#define MANY 10000000u
#define SOME 1000000u
#define FEW 131072u /* each wood and fibre, and some stones; emulation is slow */

/* instrumented code is many times slower, and its bits are the same */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHARE 20u
#else
#define SHARE 1u
#endif

#define SKIPPED 77

typedef struct {
  unsigned long long points, hash;
  char isa[16];
} answer;

static const char *plugin_path = SOZAI_TEST_PLUGIN, *worker = SOZAI_TEST_WORKER;
static char **runner;
static int runner_count;

static void exec_worker(const char *cpu, const char *path, const char *program, int foreign,
                        unsigned points, unsigned batch, unsigned threads, const char *ways) {
  char number[3][16], words[64], *argv[32];
  int n = 0;
  for (int i = 0; foreign && i < runner_count; i++) argv[n++] = runner[i];
  snprintf(number[0], sizeof number[0], "%u", points);
  snprintf(number[1], sizeof number[1], "%u", batch);
  snprintf(number[2], sizeof number[2], "%u", threads);
  snprintf(words, sizeof words, "%s", ways);
  argv[n++] = (char *)(uintptr_t)program;
  argv[n++] = (char *)(uintptr_t)path;
  for (int i = 0; i < 3; i++) argv[n++] = number[i];
  for (char *w = strtok(words, " "); w; w = strtok(NULL, " ")) argv[n++] = w;
  argv[n] = NULL;
  setenv("SOZAI_CPU", cpu, 1);
  execvp(argv[0], argv);
  perror(argv[0]);
  _exit(127);
}

/* 0, or the worker's exit code. */
static int run(const char *cpu, int foreign, unsigned points, unsigned batch, unsigned threads,
               const char *ways, answer *out) {
  int ends[2];
  assert_int_equal(pipe(ends), 0);
  struct timespec before, after;
  clock_gettime(CLOCK_MONOTONIC, &before);
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    exec_worker(cpu, foreign ? plugin_path : SOZAI_TEST_PLUGIN,
                foreign ? worker : SOZAI_TEST_WORKER, foreign, points, batch, threads, ways);
  }
  close(ends[1]);
  char text[256] = "";
  size_t got = 0;
  for (ssize_t k; (k = read(ends[0], text + got, sizeof text - 1 - got)) > 0;) got += (size_t)k;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  clock_gettime(CLOCK_MONOTONIC, &after);
  memset(out, 0, sizeof *out);
  sscanf(text, "%llu %llx %15s", &out->points, &out->hash, out->isa);
  int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  print_message("%-6s batches of %-4u threads %u %-24s %9llu points  %016llx  %.1f s%s\n", cpu,
                batch, threads, ways, out->points, out->hash,
                (double)(after.tv_sec - before.tv_sec) +
                    1e-9 * (double)(after.tv_nsec - before.tv_nsec),
                code == SKIPPED ? "  not on this machine" : "");
  if (code == 0) assert_string_equal(out->isa, cpu);
  return code;
}

static int failures;

static void expect(const answer *a, const answer *wanted) {
  if (a->points == wanted->points && a->hash == wanted->hash) return;
  print_error("  ^ not %llu points with the hash %016llx\n", wanted->points, wanted->hash);
  failures++;
}

/* One instruction set against the reference, in every way. */
static void every_way(const char *cpu, const answer *some, const answer *many) {
  static const unsigned batches[] = {1, 3, 17, 1000, 4096};
  static const struct {
    unsigned batch, threads;
    const char *ways;
  } ways[] = {{4096, 2, ""},       {16, 5, "misaligned"}, {5, 2, "masked"},
              {4096, 1, "subset"}, {2, 5, "subset"},      {1000, 5, "misaligned masked subset"}};
  answer a;
  int code = run(cpu, 0, SOME / SHARE, 4096, 1, "", &a);
  if (code == SKIPPED) return;
  failures += code != 0;
  for (size_t i = 0; i < sizeof batches / sizeof *batches; i++) {
    failures += run(cpu, 0, SOME / SHARE, batches[i], 1, "", &a) != 0;
    expect(&a, some);
  }
  for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
    failures += run(cpu, 0, SOME / SHARE, ways[i].batch, ways[i].threads, ways[i].ways, &a) != 0;
    expect(&a, some);
  }
  if (strcmp(cpu, "scalar") == 0) return;
  failures += run(cpu, 0, MANY / SHARE, 1000, 2, "misaligned", &a) != 0;
  expect(&a, many);
}

#if defined(__aarch64__)
static const char *const sets[] = {"scalar", "neon"};
#else
static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512"};
#endif
#define SETS (sizeof sets / sizeof *sets)

static void same_here(void **unused) {
  (void)unused;
  answer some, many;
  assert_int_equal(run("scalar", 0, SOME / SHARE, 4096, 1, "", &some), 0);
  assert_int_equal(run("scalar", 0, MANY / SHARE, 4096, 2, "", &many), 0);
  assert_true(some.hash != many.hash && some.points >= SOME / SHARE);
  failures = 0;
  for (size_t i = 0; i < SETS; i++) every_way(sets[i], &some, &many);
  assert_int_equal(failures, 0);
}

/* A build for this machine, by another compiler or with other options. */
static void same_as_other_build(void **unused) {
  (void)unused;
  answer some, a;
  assert_int_equal(run("scalar", 0, SOME / SHARE, 4096, 1, "", &some), 0);
  failures = 0;
  for (size_t i = 0; i < SETS; i++) {
    static const unsigned batches[] = {4096, 17, 1};
    for (int k = 0; k < 3; k++) {
      int code = run(sets[i], 1, SOME / SHARE, batches[k], 1, "", &a);
      if (code == SKIPPED) break;
      failures += code != 0;
      expect(&a, &some);
    }
  }
  assert_int_equal(failures, 0);
}

static void same_as_other_processor(void **unused) {
  (void)unused;
  static const char *const other[] = {"scalar", "neon"};
  answer few, a;
  assert_int_equal(run("scalar", 0, FEW, 4096, 1, "", &few), 0);
  failures = 0;
  for (int i = 0; i < 2; i++) {
    failures += run(other[i], 1, FEW, 4096, 1, "", &a) != 0;
    expect(&a, &few);
  }
  /* the ways that are not the processor's are shown at home */
  failures += run(other[1], 1, FEW, 3, 1, "misaligned masked", &a) != 0;
  expect(&a, &few);
  assert_int_equal(failures, 0);
}

int main(int argc, char **argv) {
  int processor = 0, other = 0;
  for (int i = 1; i + 1 < argc; i++) {
    if (strcmp(argv[i], "--against") == 0) plugin_path = argv[i + 1], other = 1;
    if (strcmp(argv[i], "--worker") == 0) worker = argv[i + 1], processor = 1;
    if (strcmp(argv[i], "--runner") == 0) {
      runner = argv + i + 1;
      runner_count = argc - i - 1;
      break;
    }
  }
  const struct CMUnitTest here[] = {cmocka_unit_test(same_here)};
  const struct CMUnitTest build[] = {cmocka_unit_test(same_as_other_build)};
  const struct CMUnitTest foreign[] = {cmocka_unit_test(same_as_other_processor)};
  if (processor) return cmocka_run_group_tests(foreign, NULL, NULL);
  if (other) return cmocka_run_group_tests(build, NULL, NULL);
  return cmocka_run_group_tests(here, NULL, NULL);
}
