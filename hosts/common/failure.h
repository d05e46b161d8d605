/* SPDX-License-Identifier: Apache-2.0
 * Why something failed, and what the program should exit with. */
#ifndef SOZAI_HOSTS_FAILURE_H
#define SOZAI_HOSTS_FAILURE_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EXIT_BAD_INPUT 2 /* the user can mend it; EXIT_FAILURE is everything else */
/* Nobody reads standard output any more, of which there is nothing to say: what a shell gives for
 * a command that SIGPIPE ended. */
#define EXIT_CLOSED_PIPE 141

typedef struct failure {
  int exit_code;
  char text[1024]; /* one line, without a newline at its end */
} failure;

/* Fill in why; always false, so that callers can `return fail(...)`. The
 * arguments may point into why->text. */
bool fail(failure *why, int exit_code, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* In why's text: every `from` as `to`. */
void failure_rename(failure *why, const char *from, const char *to);

#ifdef __cplusplus
}
#endif

#endif
