/* SPDX-License-Identifier: Apache-2.0
 * The version, and the tables under their ids. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "groups.h"
#include "subject.h"

static const char *const known_ids[] = {SOZAI_TEXTURES_1, SOZAI_GEOMETRY_1, SOZAI_WOOD_1};
static const size_t known_sizes[] = {sizeof(sozai_textures_1), sizeof(sozai_geometry_1),
                                     sizeof(sozai_wood_1)};

static const sozai_entry_v1 *raw_entry(subject *s) {
  doing("dlopen");
  s->library = dlopen(s->path, RTLD_NOW | RTLD_LOCAL);
  s->entry = s->library ? dlsym(s->library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!s->entry) failed("it has no entry");
  return s->entry;
}

/* "Refuse it unless abi_major == SOZAI_ABI_MAJOR" */
static void major(subject *s) {
  const sozai_entry_v1 *e = raw_entry(s);
  if (e)
    EXPECT(e->abi_major == SOZAI_ABI_MAJOR, "abi_major is %u, not %u", e->abi_major,
           SOZAI_ABI_MAJOR);
}

/* "a higher minor only adds ids and struct members": who claims no higher minor has no
 * larger structs. */
static void minor(subject *s) {
  if (!subject_start(s)) return;
  static kind kinds[KINDS_MOST];
  uint32_t n = subject_kinds(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    EXPECT(kinds[i].size >= kinds[i].size_known, "%s %s: size is %u, less than the %u of ABI 1",
           kinds[i].what, kinds[i].id, kinds[i].size, kinds[i].size_known);
    if (s->entry->abi_minor <= SOZAI_ABI_MINOR)
      EXPECT(kinds[i].size <= kinds[i].size_known,
             "%s %s: size is %u, more than the %u of the ABI 1.%u that it claims", kinds[i].what,
             kinds[i].id, kinds[i].size, kinds[i].size_known, s->entry->abi_minor);
  }
}

static void functions(subject *s) {
  const sozai_entry_v1 *e = raw_entry(s);
  if (!e) return;
  EXPECT(e->init, "init is NULL");
  EXPECT(e->deinit, "deinit is NULL");
  EXPECT(e->get_factory, "get_factory is NULL");
}

/* "An unknown id gives NULL." */
static void unknown_ids(subject *s) {
  if (!subject_start(s)) return;
  static const char *const ids[] = {"",
                                    " ",
                                    "sozai.textures/",
                                    "sozai.textures/1 ",
                                    " sozai.textures/1",
                                    "sozai.textures/10",
                                    "sozai.textures/99999",
                                    "sozai.texture",
                                    "SOZAI.TEXTURES/1",
                                    "sozai.geometry/0",
                                    "sozai.geometry/-1",
                                    "sozai.wood/1/",
                                    "validate.no-such-table/1",
                                    "%s%n%s",
                                    "\xff\xfe",
                                    "sozai.textures/1\n"};
  for (uint32_t i = 0; i < COUNT_OF(ids); i++) {
    doing("get_factory of the unknown id \"%s\"", ids[i]);
    EXPECT(!s->entry->get_factory(ids[i]), "get_factory(\"%s\") is not NULL", ids[i]);
  }
  size_t n = 1u << 20;
  char *huge = malloc(n + 1);
  if (!huge) return failed("out of memory");
  memset(huge, 'x', n);
  huge[n] = '\0';
  memcpy(huge, SOZAI_TEXTURES_1, strlen(SOZAI_TEXTURES_1));
  doing("get_factory of an id of 1 MiB");
  EXPECT(!s->entry->get_factory(huge), "get_factory of an id of 1 MiB is not NULL");
  free(huge);
}

static const void *found[COUNT_OF(known_ids)];

static void *look_up(void *context) {
  const subject *s = context;
  for (uint32_t i = 0; i < COUNT_OF(known_ids); i++) found[i] = s->entry->get_factory(known_ids[i]);
  return NULL;
}

/* "The function table of that id ... Valid until the last deinit. [thread-safe]" */
static void same_table(subject *s) {
  if (!subject_start(s)) return;
  pthread_t thread;
  if (pthread_create(&thread, NULL, look_up, s) != 0) return;
  pthread_join(thread, NULL);
  for (uint32_t i = 0; i < COUNT_OF(known_ids); i++)
    for (int again = 0; again < 3; again++)
      EXPECT(s->entry->get_factory(known_ids[i]) == found[i],
             "get_factory(\"%s\") gave another address", known_ids[i]);
}

/* Every function is there: a host calls them without asking. */
static void complete(subject *s) {
  if (!subject_start(s)) return;
  for (uint32_t i = 0; i < COUNT_OF(known_ids); i++) {
    const void *const *table = s->entry->get_factory(known_ids[i]);
    for (size_t k = 0; table && k < known_sizes[i] / sizeof *table; k++) {
      const void *f;
      memcpy(&f, &table[k], sizeof f);
      EXPECT(f, "function %u of %s is NULL", (unsigned)k, known_ids[i]);
    }
  }
}

/* "Tables of functions never change." */
static void constant(subject *s) {
  if (!subject_start(s)) return;
  static unsigned char before[COUNT_OF(known_ids)][256];
  for (uint32_t i = 0; i < COUNT_OF(known_ids); i++) {
    const void *table = s->entry->get_factory(known_ids[i]);
    if (table) memcpy(before[i], table, known_sizes[i]);
  }
  int32_t nested = s->entry->init(NULL);
  for (uint32_t i = 0; s->textures && i < s->textures->count(); i++) {
    sozai_texture *t = NULL;
    s->textures->create(NULL, s->textures->info(i)->id, NULL, NULL, 0, &t);
    s->textures->destroy(t);
    s->textures->create(NULL, "validate: none", NULL, NULL, 0, &t);
  }
  if (nested == SOZAI_OK) s->entry->deinit();
  for (uint32_t i = 0; i < COUNT_OF(known_ids); i++) {
    const void *table = s->entry->get_factory(known_ids[i]);
    if (table)
      EXPECT(memcmp(before[i], table, known_sizes[i]) == 0, "the table %s changed", known_ids[i]);
  }
}

CHECKS(version, //
       {"version.major", "symbols.entry",
        "abi_major is this header's, readable without running code", major},
       {"version.functions", "version.major", "init, deinit and get_factory are there", functions},
       {"version.minor", "init.tables", "structs are as large as the version says", minor},
       {"version.unknown-ids", "init.tables", "an unknown table's id gives NULL", unknown_ids},
       {"version.same-table", "init.tables", "the same id gives the same table, on every thread",
        same_table},
       {"version.complete", "init.tables", "no function of a table is NULL", complete},
       {"version.constant", "create.default", "tables do not change while textures come and go",
        constant});
