/* SPDX-License-Identifier: Apache-2.0
 *
 * The same bits whatever the instruction set, batch size, alignment, mask,
 * choice of channels, number of threads and (--against) compiler, optimisation
 * or processor: identity_worker in a process of its own for each instruction
 * set, because SOZAI_CPU is read once.
 *
 *   identity                              all ways of the plugin built here
 *   identity --long                       with ten million points, and a million
 *                                         in each of the ways: the target
 *                                         identity-long
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
#define SOME 1000000u /* 245 blocks: every wood, fibre and stone */
#define PART 262144u  /* every wood, some fibres and stones */
#define FEW 98304u    /* sixteen woods, four stones and four fibres; emulation is slow, */
#define FEWER 24576u  /* and four woods, a stone and a fibre do for what it is not meant for */
/* instrumented code is many times slower, and its bits are the same */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHARE 20u
#else
#define SHARE 1u
#endif

#define SKIPPED 77

typedef struct {
  unsigned long long points, hash;
} answer;

static const char *plugin_path = SOZAI_TEST_PLUGIN, *worker = SOZAI_TEST_WORKER;
static char **runner;
static int runner_count;
static int at_length;

typedef struct {
  unsigned points, batch, threads;
  const char *words; /* ",misaligned" and the like */
  const answer *wanted;
} way;

#define WAYS_MOST 16
#define RUNNER_MOST 16 /* words of its command */
typedef struct {
  const char *cpu;
  int foreign; /* the other build's plugin */
  way list[WAYS_MOST];
  int count;
} ways;

static void add(ways *w, unsigned points, unsigned batch, unsigned threads, const char *words,
                const answer *wanted) {
  assert_true(w->count < WAYS_MOST);
  w->list[w->count++] = (way){points, batch, threads, words, wanted};
}

static void exec_worker(const ways *w) {
  char texts[WAYS_MOST][80], *argv[RUNNER_MOST + WAYS_MOST + 3];
  int n = 0;
  if (runner_count > RUNNER_MOST) _exit(126);
  for (int i = 0; w->foreign && i < runner_count; i++) argv[n++] = runner[i];
  argv[n++] = (char *)(uintptr_t)(w->foreign ? worker : SOZAI_TEST_WORKER);
  argv[n++] = (char *)(uintptr_t)(w->foreign ? plugin_path : SOZAI_TEST_PLUGIN);
  for (int i = 0; i < w->count; i++) {
    const way *k = &w->list[i];
    snprintf(texts[i], sizeof texts[i], "%u,%u,%u%s", k->points, k->batch, k->threads, k->words);
    argv[n++] = texts[i];
  }
  argv[n] = NULL;
  setenv("SOZAI_CPU", w->cpu, 1);
  execvp(argv[0], argv);
  perror(argv[0]);
  _exit(127);
}

static int failures;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A way's line against what is wanted of it, where that is known. */
static void judge(const ways *w, const way *k, const char *line, answer *out) {
  char isa[16] = "";
  answer a = {0};
  sscanf(line, "%llu %llx %15s", &a.points, &a.hash, isa);
  print_message("%-6s batches of %-4u threads %u %-26s %9llu points  %016llx\n", w->cpu, k->batch,
                k->threads, k->words, a.points, a.hash);
  if (out) *out = a;
  const int same = !k->wanted || (a.points == k->wanted->points && a.hash == k->wanted->hash);
  if (same && strcmp(isa, w->cpu) == 0 && a.points >= k->points) return;
  if (!same)
    print_error("  ^ not %llu points with the hash %016llx\n", k->wanted->points, k->wanted->hash);
  else
    print_error("  ^ on '%s'\n", isa);
  failures++;
}

/* All ways; out, if not NULL: an answer for each. 0 where the machine lacks the
 * instruction set. */
static int run(const ways *w, answer *out) {
  int ends[2];
  assert_int_equal(pipe(ends), 0);
  double begun = now();
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    exec_worker(w);
  }
  close(ends[1]);
  FILE *said = fdopen(ends[0], "r");
  assert_non_null(said);
  char line[256];
  int lines = 0;
  for (; fgets(line, sizeof line, said); lines++)
    if (lines < w->count) judge(w, &w->list[lines], line, out ? &out[lines] : NULL);
  fclose(said);
  int status = 0;
  waitpid(child, &status, 0);
  int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (code == SKIPPED && lines == 0) {
    print_message("%-6s not on this machine\n", w->cpu);
    return 0;
  }
  print_message("%-6s %.1f s\n", w->cpu, now() - begun);
  if (code != 0 || lines != w->count) {
    print_error("  ^ exit code %d after %d of %d ways\n", code, lines, w->count);
    failures++;
  }
  return 1;
}

/* What one lane says of each number of points. */
typedef struct {
  answer part, some, many;
} reference;

/* One instruction set against the reference, in every way. */
static void every_way(const char *cpu, const reference *r) {
  static const unsigned batches[] = {1, 3, 17, 1000, 4096};
  static const struct {
    unsigned batch, threads;
    const char *words;
  } others[] = {{4096, 2, ""},     {16, 5, ",misaligned"},
                {5, 2, ",masked"}, {4096, 1, ",subset"},
                {2, 5, ",subset"}, {1000, 5, ",misaligned,masked,subset"},
                {1, 3, ",subset"}};
  const unsigned points = (at_length ? SOME : PART) / SHARE;
  const answer *wanted = at_length ? &r->some : &r->part;
  ways w = {.cpu = cpu};
  for (size_t i = 0; i < sizeof batches / sizeof *batches; i++)
    add(&w, points, batches[i], 1, "", wanted);
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    add(&w, points, others[i].batch, others[i].threads, others[i].words, wanted);
  add(&w, SOME / SHARE, 1000, 2, ",misaligned", &r->some);
  if (at_length && strcmp(cpu, "scalar") != 0)
    add(&w, MANY / SHARE, 1000, 2, ",misaligned", &r->many);
  run(&w, NULL);
}

#if defined(__aarch64__)
static const char *const sets[] = {"scalar", "neon"};
#else
static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512"};
#endif
#define SETS (sizeof sets / sizeof *sets)

/* Whether the other build has kernels of its own for it: other.sh. */
static int is_asked(const char *cpu) {
  const char *only = getenv("SOZAI_TEST_SETS");
  return !only || strstr(only, cpu);
}

/* On one lane, of this build. */
static void refer(reference *r, int with_many) {
  ways w = {.cpu = "scalar"};
  answer a[3] = {{0}};
  add(&w, PART / SHARE, 4096, 1, "", NULL);
  add(&w, SOME / SHARE, 4096, 1, "", NULL);
  if (with_many) add(&w, MANY / SHARE, 4096, 2, "", NULL);
  assert_true(run(&w, a));
  assert_int_equal(failures, 0);
  *r = (reference){a[0], a[1], a[2]};
  assert_true(r->some.hash != r->part.hash && r->some.hash != r->many.hash);
}

static void same_here(void **unused) {
  (void)unused;
  reference r;
  refer(&r, at_length);
  for (size_t i = 0; i < SETS; i++) every_way(sets[i], &r);
  assert_int_equal(failures, 0);
}

/* A build for this machine, by another compiler or with other options. */
static void same_as_other_build(void **unused) {
  (void)unused;
  reference r;
  refer(&r, 0);
  const unsigned points = (at_length ? SOME : PART) / SHARE;
  const answer *wanted = at_length ? &r.some : &r.part;
  for (size_t i = 0; i < SETS; i++) {
    if (!is_asked(sets[i])) continue;
    ways w = {.cpu = sets[i], .foreign = 1};
    add(&w, SOME / SHARE, 4096, 1, "", &r.some);
    add(&w, points, 17, 1, "", wanted);
    add(&w, points, 1, 1, "", wanted);
    run(&w, NULL);
  }
  assert_int_equal(failures, 0);
}

static void same_as_other_processor(void **unused) {
  (void)unused;
  static const char *const other[] = {"scalar", "neon"};
  answer wanted[2];
  ways here = {.cpu = "scalar"};
  add(&here, FEW, 4096, 1, "", NULL);
  add(&here, FEWER, 4096, 1, "", NULL);
  assert_true(run(&here, wanted));
  for (int i = 0; i < 2; i++) {
    ways w = {.cpu = other[i], .foreign = 1};
    if (i == 1) add(&w, FEW, 4096, 1, "", &wanted[0]);
    /* one lane has nothing of the processor's; nor have batches, which are shown at home */
    add(&w, FEWER, i == 1 ? 7 : 4096, 1, i == 1 ? ",misaligned,masked" : "", &wanted[1]);
    run(&w, NULL);
  }
  assert_int_equal(failures, 0);
}

int main(int argc, char **argv) {
  int processor = 0, other = 0;
  for (int i = 1; i < argc; i++) at_length |= strcmp(argv[i], "--long") == 0;
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
