/* SPDX-License-Identifier: Apache-2.0
 * The file: what can be known before any of its code runs. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <string.h>

#include "groups.h"
#include "library_file.h"
#include "subject.h"

static library_file file;

static bool read_file(subject *s) {
  char why[200];
  if (library_read(&file, s->path, why, sizeof why)) return true;
  failed("%s", why);
  return false;
}

/* sozai.h, how to use it, 1: dlopen("sozai.so"), dlsym("sozai_entry"). */
static void opens(subject *s) {
  doing("dlopen");
  void *library = dlopen(s->path, RTLD_NOW | RTLD_LOCAL);
  EXPECT(library, "dlopen: %s", dlerror());
}

/* "a struct, not a function, so that its version can be read before any of its code runs" */
static void entry(subject *s) {
  if (!read_file(s)) return;
  const library_symbol *found = NULL;
  for (uint32_t i = 0; i < file.symbol_count; i++)
    if (file.symbols[i].defined && strcmp(file.symbols[i].name, SOZAI_ENTRY_SYMBOL) == 0)
      found = &file.symbols[i];
  if (!EXPECT(found, "it exports no " SOZAI_ENTRY_SYMBOL)) return;
  EXPECT(found->datum, SOZAI_ENTRY_SYMBOL " is not a datum");
  EXPECT(found->size >= sizeof(sozai_entry_v1), SOZAI_ENTRY_SYMBOL " is of %u bytes, not %u",
         (unsigned)found->size, (unsigned)sizeof(sozai_entry_v1));
}

/* What linkers add, and for sozai_entry GCC's AddressSanitizer. */
static bool by_tools(const char *name) {
  static const char *const names[] = {"_init",  "_fini",       "_end",
                                      "_edata", "__bss_start", ("__odr_asan." SOZAI_ENTRY_SYMBOL)};
  for (uint32_t i = 0; i < COUNT_OF(names); i++)
    if (strcmp(name, names[i]) == 0) return true;
  return false;
}

/* "The only symbol sozai.so exports is an object of this type" */
static void one(subject *s) {
  if (!read_file(s)) return;
  asked();
  for (uint32_t i = 0; i < file.symbol_count; i++) {
    const library_symbol *f = &file.symbols[i];
    if (f->defined && strcmp(f->name, SOZAI_ENTRY_SYMBOL) != 0 && !by_tools(f->name))
      failed("it also exports %s", f->name);
  }
}

static bool is_libc(const char *name) {
  static const char *const begins[] = {"libc.so",  "libm.so",  "libdl.so",      "libpthread.so",
                                       "librt.so", "ld-linux", "linux-vdso.so", "libgcc_s.so"};
  static const char *const sanitizers[] = {"libasan.", "libubsan.", "libtsan.", "libclang_rt."};
  for (uint32_t i = 0; i < COUNT_OF(begins); i++)
    if (strncmp(name, begins[i], strlen(begins[i])) == 0) return true;
  for (uint32_t i = 0; i < COUNT_OF(sanitizers); i++)
    if (strncmp(name, sanitizers[i], strlen(sanitizers[i])) == 0) return true;
  return false;
}

/* Not in the header: a library that a renderer has in another version is a fight for
 * symbols (docs/decisions.md), so a warning. */
static void needed(subject *s) {
  if (!read_file(s)) return;
  asked();
  for (uint32_t i = 0; i < file.needed_count; i++)
    if (!is_libc(file.needed[i]))
      warned("it needs %s, of which a host may have another version", file.needed[i]);
}

/* "No exception, signal, exit, print, locale or floating-point-environment change crosses
 * this boundary": that it could call one is a warning, that it does a failure elsewhere. */
static void calls(subject *s) {
  static const char *const ruled_out[] = {
      "exit",        "_exit",          "_Exit",     "quick_exit", "abort",        "raise",
      "kill",        "signal",         "sigaction", "setlocale",  "fesetround",   "fesetenv",
      "feupdateenv", "feenableexcept", "printf",    "vprintf",    "__printf_chk", "__vprintf_chk",
      "puts",        "putchar",        "perror",    "stdout",     "stderr",       "chdir",
      "umask",       "setenv",         "putenv",    "system",     "fork",         "__assert_fail"};
  if (!read_file(s)) return;
  asked();
  for (uint32_t i = 0; i < file.needed_count; i++)
    if (strstr(file.needed[i], "san.so")) {
      skipped("a sanitizer's build calls what it likes");
      return;
    }
  for (uint32_t i = 0; i < file.symbol_count; i++)
    for (uint32_t k = 0; k < COUNT_OF(ruled_out) && !file.symbols[i].defined; k++)
      if (strcmp(file.symbols[i].name, ruled_out[k]) == 0) warned("it refers to %s", ruled_out[k]);
}

/* Loading changes nothing of the host's: neither its stack nor shared pages of code. */
static void protection(subject *s) {
  if (!read_file(s)) return;
  EXPECT(!file.runs_stack, "it asks for an executable stack, which the whole process then has");
  EXPECT(!file.text_relocs, "it has relocations in its code (built without -fPIC)");
}

CHECKS(symbols, //
       {"symbols.opens", NULL, "dlopen takes it", opens},
       {"symbols.entry", "symbols.opens",
        "it exports sozai_entry, a datum of the size of sozai_entry_v1", entry},
       {"symbols.one", "symbols.opens", "it exports nothing else", one},
       {"symbols.needed", "symbols.opens", "it needs libc alone (else a warning)", needed},
       {"symbols.calls", "symbols.opens",
        "it refers to nothing that would exit, print or change the host's state (else a warning)",
        calls},
       {"symbols.protection", "symbols.opens", "no executable stack, no relocations in code",
        protection});
