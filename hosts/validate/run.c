/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE
#include "run.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "memory.h"
#include "subject.h"

#define JOBS_MOST 64u
#define OUTPUT_LINES 4 /* of what a dying process wrote */

typedef struct job {
  result *result; /* NULL: free */
  pid_t pid;
  int output; /* what it writes to stdout and stderr */
  double begun;
} job;

static volatile sig_atomic_t stopped;

static void on_stop(int number) { stopped = number; }
static void on_child(int number) { (void)number; }

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A name has chances of its own, so that --only repeats what a whole run did. */
static uint64_t seed_of(uint32_t seed, const char *name) {
  uint64_t h = 0xcbf29ce484222325u ^ seed;
  for (; *name; name++) h = (h ^ (unsigned char)*name) * 0x100000001b3u;
  return h;
}

/* ---- the child --------------------------------------------------------- */

static void child(const run_options *options, const result *r, int output, const sigset_t *mask) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  /* What a program starts with: a plugin's host has not set these either. */
  for (int s = 1; s < 32; s++)
    if (s != SIGKILL && s != SIGSTOP) signal(s, SIG_DFL);
  sigprocmask(SIG_SETMASK, mask, NULL);
  const struct rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  int nothing = open("/dev/null", O_RDONLY);
  if (nothing > 0) dup2(nothing, 0);
  if (nothing > 2) close(nothing);
  dup2(output, 1);
  dup2(output, 2);
  verdict_to(r->verdict);
  memory_scribble();
  subject s = {.path = options->path,
               .texture = options->texture,
               .thorough = options->thorough,
               .chance = seed_of(options->seed, r->check->name)};
  r->check->run(&s);
  atomic_store(&r->verdict->finished, true);
  fflush(NULL);
  _exit(0);
}

static bool start(const run_options *options, job *j, result *r, const sigset_t *mask) {
  j->output = memfd_create("sozai-validate", MFD_CLOEXEC);
  if (j->output < 0) return false;
  j->begun = now();
  fflush(NULL);
  j->pid = fork();
  if (j->pid == 0) child(options, r, j->output, mask);
  if (j->pid < 0) {
    close(j->output);
    return false;
  }
  setpgid(j->pid, j->pid); /* as the child does: whichever comes first */
  j->result = r;
  return true;
}

/* ---- what became of it ------------------------------------------------- */

/* The first lines of what it wrote: an assertion's, or a sanitizer's. */
static void add_output(verdict *v, int output) {
  char text[2048];
  ssize_t n = pread(output, text, sizeof text - 1, 0);
  if (n <= 0) return;
  text[n] = '\0';
  char *at = text;
  for (int i = 0; i < OUTPUT_LINES && at && *at;) {
    char *line = strsep(&at, "\n");
    if (!*line || strspn(line, "=") == strlen(line)) continue;
    verdict_fail(v, "it wrote: %s", line);
    i++;
  }
}

static void judge(const run_options *options, job *j, int status, bool late) {
  result *r = j->result;
  verdict *v = r->verdict;
  /* The process had this memory: what it left there is text only up to here. */
  for (int i = 0; i < VERDICT_LINES; i++) {
    v->failure[i][VERDICT_LINE - 1] = '\0';
    v->warning[i][VERDICT_LINE - 1] = '\0';
  }
  v->skip[VERDICT_LINE - 1] = '\0';
  v->doing[VERDICT_LINE - 1] = '\0';
  r->seconds = now() - j->begun;
  bool died = true;
  if (late)
    verdict_fail(v, "it did not end within %g s; under way: %s", options->time_limit, v->doing);
  else if (WIFSIGNALED(status))
    verdict_fail(v, "killed by signal %d, %s; under way: %s", WTERMSIG(status),
                 strsignal(WTERMSIG(status)), v->doing);
  else if (!atomic_load(&v->finished))
    verdict_fail(v, "the process ended with exit code %d; under way: %s", WEXITSTATUS(status),
                 v->doing);
  else
    died = WEXITSTATUS(status) != 0;
  if (died && atomic_load(&v->finished))
    verdict_fail(v, "after its end the process gave exit code %d", WEXITSTATUS(status));
  if (died) add_output(v, j->output);
  if (atomic_load(&v->failures)) {
    r->outcome = OUTCOME_FAILED;
  } else if (v->skip[0]) {
    r->outcome = OUTCOME_SKIPPED;
  } else if (!atomic_load(&v->asked)) {
    snprintf(v->skip, sizeof v->skip, "it has nothing of the kind");
    r->outcome = OUTCOME_SKIPPED;
  } else {
    r->outcome = OUTCOME_PASSED;
  }
  close(j->output);
  j->result = NULL;
}

/* ---- the order of things ------------------------------------------------ */

static result *find(result *results, uint32_t count, const char *name) {
  for (uint32_t i = 0; name && i < count; i++)
    if (strcmp(results[i].check->name, name) == 0) return &results[i];
  return NULL;
}

/* Whether it may be started; where what it needs failed it is skipped, and so is
 * what needs that. */
static bool ready(result *results, uint32_t count, result *r) {
  const result *need = find(results, count, r->check->needs);
  if (!need || need->outcome == OUTCOME_PASSED) return true;
  if (need->outcome == OUTCOME_NONE) return false;
  if (need->outcome == OUTCOME_SKIPPED && strncmp(need->verdict->skip, "needs ", 6) != 0)
    return true;
  snprintf(r->verdict->skip, sizeof r->verdict->skip, "needs %s, which %s", need->check->name,
           need->outcome == OUTCOME_FAILED ? "failed" : "could not be asked");
  r->outcome = OUTCOME_SKIPPED;
  return false;
}

/* Start what can be started; how many are under way. */
static uint32_t fill(const run_options *options, job *jobs, uint32_t job_count, result *results,
                     uint32_t count, const sigset_t *mask) {
  uint32_t busy = 0;
  for (uint32_t k = 0; k < job_count; k++) busy += jobs[k].result != NULL;
  for (uint32_t i = 0; i < count && busy < job_count && !stopped; i++) {
    bool running = false;
    for (uint32_t k = 0; k < job_count; k++) running |= jobs[k].result == &results[i];
    if (running || results[i].outcome != OUTCOME_NONE || !ready(results, count, &results[i]))
      continue;
    uint32_t slot = 0;
    while (jobs[slot].result) slot++;
    if (start(options, &jobs[slot], &results[i], mask)) {
      busy++;
    } else {
      verdict_fail(results[i].verdict, "no process could be started for it: %s", strerror(errno));
      results[i].outcome = OUTCOME_FAILED;
    }
  }
  return busy;
}

/* End a job with everything that it started. */
static int end(const job *j) {
  int status = 0;
  kill(-j->pid, SIGKILL);
  kill(j->pid, SIGKILL);
  while (waitpid(j->pid, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

static void collect(const run_options *options, job *jobs, uint32_t job_count) {
  for (uint32_t k = 0; k < job_count; k++) {
    job *j = &jobs[k];
    if (!j->result) continue;
    int status;
    pid_t ended = waitpid(j->pid, &status, WNOHANG);
    if (ended == j->pid) {
      kill(-j->pid, SIGKILL); /* what it may have left running */
      judge(options, j, status, false);
    } else if (now() - j->begun > options->time_limit) {
      judge(options, j, end(j), true);
    }
  }
}

static void wait_for_one(const run_options *options, const job *jobs, uint32_t job_count,
                         const sigset_t *waited) {
  double left = 1;
  for (uint32_t k = 0; k < job_count; k++) {
    if (!jobs[k].result) continue;
    double own = jobs[k].begun + options->time_limit - now();
    if (own < left) left = own;
  }
  if (left < 0.001) left = 0.001;
  const struct timespec t = {.tv_sec = (time_t)left,
                             .tv_nsec = (long)((left - (double)(time_t)left) * 1e9)};
  sigtimedwait(waited, NULL, &t);
}

bool run_checks(const run_options *options, result *results, uint32_t count,
                void (*done)(const result *r, void *user), void *user) {
  job jobs[JOBS_MOST] = {{0}};
  uint32_t job_count = options->jobs < JOBS_MOST ? options->jobs : JOBS_MOST;
  verdict *shared =
      mmap(NULL, count * sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return false;
  for (uint32_t i = 0; i < count; i++) results[i].verdict = &shared[i];

  /* A child's end wakes sigtimedwait; it must be blocked, and not ignored. */
  struct sigaction stop = {.sa_handler = on_stop}, told = {.sa_handler = on_child};
  struct sigaction kept_int, kept_term, kept_child;
  sigaction(SIGINT, &stop, &kept_int);
  sigaction(SIGTERM, &stop, &kept_term);
  sigaction(SIGCHLD, &told, &kept_child);
  sigset_t waited, mask;
  sigemptyset(&waited);
  sigaddset(&waited, SIGCHLD);
  sigprocmask(SIG_BLOCK, &waited, &mask);

  uint32_t reported = 0;
  while (reported < count && !stopped) {
    uint32_t busy = fill(options, jobs, job_count, results, count, &mask);
    for (; reported < count && results[reported].outcome != OUTCOME_NONE; reported++)
      done(&results[reported], user);
    if (!busy) continue;
    wait_for_one(options, jobs, job_count, &waited);
    collect(options, jobs, job_count);
  }
  for (uint32_t k = 0; k < job_count; k++)
    if (jobs[k].result) {
      end(&jobs[k]);
      close(jobs[k].output);
    }
  sigprocmask(SIG_SETMASK, &mask, NULL);
  sigaction(SIGINT, &kept_int, NULL);
  sigaction(SIGTERM, &kept_term, NULL);
  sigaction(SIGCHLD, &kept_child, NULL);
  return !stopped;
}
