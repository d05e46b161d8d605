/* SPDX-License-Identifier: Apache-2.0
 * "No exception, signal, exit, print, locale or floating-point-environment change
 * crosses this boundary." And what else is the host's own. */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <fenv.h>
#include <locale.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "batch.h"
#include "control.h"
#include "groups.h"
#include "make.h"
#include "round.h"

extern char **environ;

static void ignore(const char *call) { (void)call; }

/* ---- standard streams ------------------------------------------------------------ */

/* "print" */
static void streams(subject *s) {
  if (!subject_load(s)) return;
  every_call(s, true, ignore);
  fflush(NULL);
  struct stat now;
  asked();
  if (fstat(1, &now) != 0 || now.st_size == 0) return;
  char text[120] = "";
  ssize_t n = pread(1, text, sizeof text - 1, 0);
  text[n > 0 ? n : 0] = '\0';
  failed("it wrote %lld bytes to standard output or error: '%s'", (long long)now.st_size, text);
}

/* ---- floating point ----------------------------------------------------------------- */

static uint64_t control;
static int rounding;
static const char *under;

static void environment_same(const char *call) {
  EXPECT(fegetround() == rounding, "%s changed the rounding mode, which was %s", call, under);
  EXPECT(control_word() == control, "%s changed the control word from %#llx to %#llx", call,
         (unsigned long long)control, (unsigned long long)control_word());
  if (fegetround() != rounding) fesetround(rounding);
}

static const struct {
  int mode;
  const char *name;
} modes[] = {{FE_TONEAREST, "to nearest"},
             {FE_UPWARD, "upward"},
             {FE_DOWNWARD, "downward"},
             {FE_TOWARDZERO, "toward zero"}};

static void rounding_kept(subject *s) {
  for (uint32_t i = 0; i < COUNT_OF(modes) && !enough(); i++) {
    if (!subject_load(s)) return;
    rounding = modes[i].mode;
    under = modes[i].name;
    fesetround(rounding);
    control = control_word();
    every_call(s, false, environment_same);
    fesetround(FE_TONEAREST);
    subject_stop(s);
  }
}

static void flushing_kept(subject *s) {
  if (!control_flushes()) return skipped("no flushing of denormals is known on this machine");
  if (!subject_load(s)) return;
  uint64_t kept = control_flush();
  rounding = fegetround();
  under = "to nearest, denormals flushed";
  control = control_word();
  every_call(s, false, environment_same);
  control_restore(kept);
}

static void growing_kept(subject *s) {
  if (!subject_load(s)) return;
  rounding = fegetround();
  under = "to nearest";
  control = control_word();
  every_call(s, true, environment_same);
}

/* Under another rounding mode the numbers are other ones, but finite. */
static void rounded_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 300);
  for (uint32_t i = 1; b && i < COUNT_OF(modes); i++) {
    batch_mark(b);
    fesetround(modes[i].mode);
    doing("evaluate of %s, rounding %s", b->name, modes[i].name);
    int32_t r = s->textures->evaluate(t, &b->abi);
    fesetround(FE_TONEAREST);
    EXPECT(r == SOZAI_OK, "%s: evaluate, rounding %s, gave %s", b->name, modes[i].name,
           result_name(r));
    for (uint32_t c = 0; c < info->component_count; c++) batch_written(b, c, 0, 300, modes[i].name);
  }
  batch_free(b);
}

static void rounded(subject *s) { start_each_texture(s, 2, rounded_of); }

/* ---- locale ---------------------------------------------------------------------------- */

static char locale_name[200];
static locale_t locale_own;

static void locale_same(const char *call) {
  EXPECT(strcmp(setlocale(LC_ALL, NULL), locale_name) == 0, "%s changed the locale", call);
  EXPECT(uselocale((locale_t)0) == locale_own, "%s changed the thread's locale", call);
}

static void locale_kept(subject *s) {
  static const char *const names[] = {"C", "C.UTF-8"};
  for (uint32_t i = 0; i < COUNT_OF(names) && !enough(); i++) {
    if (!setlocale(LC_ALL, names[i])) continue;
    if (!subject_load(s)) return;
    snprintf(locale_name, sizeof locale_name, "%s", setlocale(LC_ALL, NULL));
    locale_own = uselocale((locale_t)0);
    every_call(s, true, locale_same);
    subject_stop(s);
  }
  /* A thread's own locale too. */
  locale_t own = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  if (!own || !subject_load(s)) return;
  locale_own = own;
  uselocale(own);
  every_call(s, false, locale_same);
  uselocale(LC_GLOBAL_LOCALE);
}

/* A locale that writes 1,5: one of this machine's, or $SOZAI_VALIDATE_LOCALE. */
static bool comma_locale(void) {
  static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8",  "de_DE",       "fr_FR.UTF-8",
                                      "fr_FR.utf8",  "fr_FR",       "nl_NL.UTF-8", "it_IT.UTF-8",
                                      "es_ES.UTF-8", "pl_PL.UTF-8", "de_AT.UTF-8", "ru_RU.UTF-8"};
  const char *own = getenv("SOZAI_VALIDATE_LOCALE");
  if (own && setlocale(LC_ALL, own) && strcmp(localeconv()->decimal_point, ",") == 0) return true;
  for (uint32_t i = 0; i < COUNT_OF(names); i++)
    if (setlocale(LC_ALL, names[i]) && strcmp(localeconv()->decimal_point, ",") == 0) return true;
  setlocale(LC_ALL, "C");
  return false;
}

/* "Text is read and written in the C locale." */
static void comma(subject *s) {
  if (!comma_locale())
    return skipped(
        "this machine has no locale with a decimal comma (SOZAI_VALIDATE_LOCALE names one)");
  if (!subject_start(s)) return;
  static kind kinds[KINDS_MOST];
  uint32_t n = subject_kinds(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    for (uint32_t p = 0; k->texture && p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      if (q->kind != SOZAI_KIND_FLOAT || q->hard_min > 1.5 || q->hard_max < 1.5) continue;
      sozai_value v = {.id = q->id, .kind = SOZAI_KIND_STRING, .text = "1.5"}, is;
      made m;
      int32_t r = make(s, k, NULL, NULL, &v, 1, &m);
      EXPECT(r != SOZAI_ERROR_KIND, "%s: %s as \"1.5\" gave %s in a locale of decimal commas",
             k->id, q->id, result_name(r));
      if (r == SOZAI_OK) {
        made_value(s, &m, q->id, &is);
        EXPECT(is.number[0] == 1.5, "%s: %s as \"1.5\" is %.17g in a locale of decimal commas",
               k->id, q->id, is.number[0]);
        unmake(s, &m);
      }
      if (q->hard_max > 1e5) continue;
      v = (sozai_value){.id = q->id, .kind = SOZAI_KIND_FLOAT, .number = {1000000.5}};
      if (make(s, k, NULL, NULL, &v, 1, &m) != SOZAI_OK) {
        EXPECT(!strstr(last_error(s), "1000000,5"), "%s: an error has a decimal comma: '%s'", k->id,
               last_error(s));
      } else {
        unmake(s, &m);
      }
    }
  }
}

/* ---- signals ------------------------------------------------------------------------------- */

static struct sigaction handlers[32];
static sigset_t mask;

static void signals_same(const char *call) {
  sigset_t now;
  asked();
  sigprocmask(SIG_SETMASK, NULL, &now);
  for (int i = 1; i < 32; i++) {
    struct sigaction a;
    sigaction(i, NULL, &a);
    if (a.sa_handler != handlers[i].sa_handler)
      failed("%s changed the handler of signal %d", call, i);
    if (sigismember(&now, i) != sigismember(&mask, i))
      failed("%s changed the mask of signal %d", call, i);
  }
}

/* "signal" */
static void signals(subject *s) {
  if (!subject_load(s)) return;
  for (int i = 1; i < 32; i++) sigaction(i, NULL, &handlers[i]);
  sigprocmask(SIG_SETMASK, NULL, &mask);
  every_call(s, true, signals_same);
}

/* ---- the process ----------------------------------------------------------------------------- */

static char folder[4096];
static mode_t mode;
static struct rlimit limits[RLIM_NLIMITS];
static cpu_set_t processors;

static void process_same(const char *call) {
  char now[sizeof folder];
  mode_t is = umask(mode);
  cpu_set_t set;
  EXPECT(is == mode, "%s changed the umask", call);
  EXPECT(getcwd(now, sizeof now) && strcmp(now, folder) == 0, "%s changed the working directory",
         call);
  for (uint32_t i = 0; i < RLIM_NLIMITS; i++) {
    struct rlimit l;
    if (getrlimit((__rlimit_resource_t)i, &l) == 0)
      EXPECT(l.rlim_cur == limits[i].rlim_cur && l.rlim_max == limits[i].rlim_max,
             "%s changed the resource limit %u", call, i);
  }
  if (sched_getaffinity(0, sizeof set, &set) == 0)
    EXPECT(CPU_EQUAL(&set, &processors), "%s changed the processors that the thread may run on",
           call);
}

static void process(subject *s) {
  if (!subject_load(s)) return;
  mode = umask(022);
  umask(mode);
  if (!getcwd(folder, sizeof folder)) return skipped("there is no working directory");
  for (uint32_t i = 0; i < RLIM_NLIMITS; i++) getrlimit((__rlimit_resource_t)i, &limits[i]);
  sched_getaffinity(0, sizeof processors, &processors);
  every_call(s, true, process_same);
}

static uint64_t environment_digest(void) {
  uint64_t h = 0xcbf29ce484222325u;
  for (char **e = environ; *e; e++)
    for (const char *c = *e;; c++) {
      h = (h ^ (unsigned char)*c) * 0x100000001b3u;
      if (!*c) break;
    }
  return h;
}

static uint64_t digest;

static void environment_kept(const char *call) {
  EXPECT(environment_digest() == digest, "%s changed the environment", call);
}

static void environment(subject *s) {
  if (!subject_load(s)) return;
  digest = environment_digest();
  every_call(s, true, environment_kept);
}

/* How many entries a folder of /proc has; -1: none such. */
static int entries(const char *path) {
  DIR *d = opendir(path);
  int n = 0;
  if (!d) return -1;
  while (readdir(d)) n++;
  closedir(d);
  return n;
}

static void leftovers(subject *s, const char *path, const char *what) {
  if (!subject_load(s)) return;
  if (entries(path) < 0) return skipped("there is no %s", path);
  every_call(s, true, ignore);
  int before = entries(path);
  for (int i = 0; i < 3; i++) every_call(s, i == 2, ignore);
  EXPECT(entries(path) <= before, "%d %s more after three rounds of init to deinit",
         entries(path) - before, what);
}

static void files(subject *s) { leftovers(s, "/proc/self/fd", "open files"); }

static void threads(subject *s) {
  leftovers(s, "/proc/self/task", "threads");
  if (enough() || entries("/proc/self/task") < 0) return;
  EXPECT(entries("/proc/self/task") == 3, "%d threads are left after deinit",
         entries("/proc/self/task") - 3);
}

static void idle_of(subject *s, const sozai_texture_info *info, const char *preset,
                    sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 2000);
  if (!b) return;
  batch_run(s, t, b, "first");
  int tasks = entries("/proc/self/task"), opened = entries("/proc/self/fd");
  for (int i = 0; i < 20; i++) batch_run(s, t, b, "again");
  EXPECT(entries("/proc/self/task") == tasks, "%s: evaluate started threads", b->name);
  EXPECT(entries("/proc/self/fd") == opened, "%s: evaluate opened files", b->name);
  batch_free(b);
}

static void idle(subject *s) {
  if (entries("/proc/self/task") < 0) return skipped("there is no /proc/self/task");
  start_each_texture(s, 2, idle_of);
}

/* No process of the plugin's is left to the host to wait for. */
static void children(subject *s) {
  if (!subject_load(s)) return;
  every_call(s, true, ignore);
  EXPECT(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD, "it left a child process");
}

CHECKS(surroundings, //
       {"surroundings.streams", "evaluate.answers",
        "nothing is written to standard output or error", streams},
       {"surroundings.rounding", "evaluate.answers",
        "no call changes the rounding mode, whichever it is", rounding_kept},
       {"surroundings.flushing", "evaluate.answers", "nor what becomes of denormals",
        flushing_kept},
       {"surroundings.growing", "evaluate.answers", "nor does growing", growing_kept},
       {"surroundings.rounded", "evaluate.answers", "answers are finite in every rounding mode",
        rounded},
       {"surroundings.locale", "evaluate.answers",
        "no call changes the locale, the process's or the thread's", locale_kept},
       {"surroundings.comma", "evaluate.answers",
        "text is read and written with a point where the locale has a comma", comma},
       {"surroundings.signals", "evaluate.answers", "no call changes a signal's handler or mask",
        signals},
       {"surroundings.process", "evaluate.answers", "nor the folder, umask, limits or processors",
        process},
       {"surroundings.environment", "evaluate.answers", "nor the environment", environment},
       {"surroundings.files", "evaluate.answers", "no file is left open", files},
       {"surroundings.threads", "evaluate.answers", "no thread is left running", threads},
       {"surroundings.evaluate", "evaluate.answers", "evaluate starts no thread and opens no file",
        idle},
       {"surroundings.children", "evaluate.answers", "no process is left behind", children});
