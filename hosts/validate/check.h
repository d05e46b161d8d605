/* SPDX-License-Identifier: Apache-2.0
 * What a check is, and how it says what it found. A check runs alone in a
 * process of its own, which may crash, hang or end at any moment. */
#ifndef SOZAI_VALIDATE_CHECK_H
#define SOZAI_VALIDATE_CHECK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct subject;

typedef struct check {
  const char *name;  /* "group.what" */
  const char *needs; /* another check: when that one failed this one is skipped; or NULL */
  const char *shows; /* what holds when it passes, a phrase */
  void (*run)(struct subject *s);
} check;

typedef struct check_group {
  const char *id;
  const char *title;
  const check *checks;
  const uint32_t *count;
} check_group;

extern const check_group check_groups[];
extern const uint32_t check_group_count;

/* ---- within a check ---------------------------------------------------- */

/* It fails, for this reason; go on or return. [any thread] */
void failed(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Not against the contract, but worth knowing. [any thread] */
void warned(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* It does not apply, for this reason. Not if it failed too. */
void skipped(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* What is under way: shown when the process dies of it. */
void doing(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* So many reasons are known that more would not help. */
bool enough(void);
/* One more question was asked; a check that asked none counts as skipped. */
void asked(void);

/* Ask: the condition holds, or the check fails for that reason. Gives the
 * condition. */
#define EXPECT(condition, ...) (asked(), (condition) ? true : (failed(__VA_ARGS__), false))

#define COUNT_OF(array) ((uint32_t)(sizeof(array) / sizeof *(array)))

#endif
