/* SPDX-License-Identifier: Apache-2.0
 * Command-line options from a table, which also prints the help. */
#ifndef SOZAI_CLI_OPTIONS_H
#define SOZAI_CLI_OPTIONS_H

#include <stddef.h>
#include <stdint.h>
#include "failure.h"

#define OPTION_FLAG 0   /* bool */
#define OPTION_TEXT 1   /* const char * */
#define OPTION_NUMBER 2 /* double, within low and high */
#define OPTION_COUNT 3  /* uint32_t, within low and high */
#define OPTION_PAIRS 4  /* option_texts: given any number of times */
#define OPTION_SIZE 5   /* uint32_t[2]: WxH, each within low and high */
#define OPTION_LIMIT 6  /* "NAME=VALUE" for limits_set; no target */
#define OPTION_MAYBE 7  /* const char *: what follows an '=', or "" without one */

typedef struct option {
  const char *name;     /* without its dashes */
  char letter;          /* short form, or 0 */
  int kind;             /* OPTION_* */
  void *target;         /* holds the default beforehand */
  const char *argument; /* what the help calls its value */
  const char *help;
  double low, high;
} option;

typedef struct option_texts {
  const char **items;
  size_t count;
} option_texts;

/* What a command takes. */
typedef struct command_line {
  const char *usage; /* "render <material|file.sozai> -o FILE [options]" */
  const char *name;  /* whose --help messages point to; NULL: argv[0] */
  const char *about; /* some lines of help, each with its newline */
  const option *options;
  size_t option_count;
  const char *const *positional; /* what each plain argument is called, for messages */
  size_t positional_count;
  size_t optional_count; /* of them, the last ones, that may be left out */
  bool *given;           /* one to an option, or NULL: which were, for options_fit */
} command_line;

/* What an option is for: the endings of outputs it has an effect on, as ".png .exr". */
typedef struct option_use {
  const char *name;
  const char *endings;
} option_use;

#define OPTIONS_RUN 0  /* go on */
#define OPTIONS_DONE 1 /* help was printed: exit with 0 */
#define OPTIONS_BAD 2  /* exit with why->exit_code */

/* Fills the targets and positional_count values. */
int options_parse(const command_line *line, int argc, char **argv, const char **values,
                  failure *why);

/* What would have no effect was meant otherwise: refuses options that were given and are not for
 * such an output. */
bool options_fit(const command_line *line, const option_use *uses, size_t count, const char *output,
                 failure *why);

/* Print why, if there is one, and give the exit code. */
int report(const failure *why);

#endif
