/* SPDX-License-Identifier: Apache-2.0 */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "ending.h"
#include "numbers.h"
#include "output_file.h"
#include "progress.h"
#include "ceilings.h"

static const char *name_of(const command_line *line, char **argv) {
  return line->name ? line->name : argv[0];
}

static void print_help(const command_line *line) {
  printf("usage: sozai %s\n\n%s\n", line->usage, line->about);
  for (size_t i = 0; i < line->option_count; i++) {
    const option *o = &line->options[i];
    char left[64];
    char letter[8] = "    ";
    if (o->letter) snprintf(letter, sizeof letter, "-%c, ", o->letter);
    bool apart = o->argument && o->kind != OPTION_MAYBE;
    snprintf(left, sizeof left, "%s--%s%s%s", letter, o->name, apart ? " " : "",
             o->argument ? o->argument : "");
    printf("  %-28s %s\n", left, o->help);
  }
  printf("  %-28s %s\n", "-h, --help", "this help");
}

static bool read_count(const option *o, const char *text, uint32_t *out, failure *why) {
  double number;
  if (!number_read(text, &number) || !(number >= o->low && number <= o->high) ||
      number != (double)(uint32_t)number)
    return fail(why, EXIT_BAD_INPUT, "--%s: '%s' is not a whole number from %.0f to %.0f", o->name,
                text, o->low, o->high);
  *out = (uint32_t)number;
  return true;
}

static bool read_size(const option *o, const char *text, uint32_t *out, failure *why) {
  double size[2];
  if (numbers_read(text, 'x', size, 2) == 2 && size[0] >= o->low && size[0] <= o->high &&
      size[1] >= o->low && size[1] <= o->high && size[0] == (double)(uint32_t)size[0] &&
      size[1] == (double)(uint32_t)size[1]) {
    out[0] = (uint32_t)size[0];
    out[1] = (uint32_t)size[1];
    return true;
  }
  return fail(why, EXIT_BAD_INPUT, "--%s: '%s' is not WxH, whole numbers from %.0f to %.0f",
              o->name, text, o->low, o->high);
}

static bool store(const option *o, const char *text, failure *why) {
  switch (o->kind) {
  case OPTION_TEXT:
  case OPTION_MAYBE:
    *(const char **)o->target = text;
    return true;
  case OPTION_COUNT:
    return read_count(o, text, o->target, why);
  case OPTION_LIMIT:
    return limits_set(text, why);
  case OPTION_SIZE:
    return read_size(o, text, o->target, why);
  case OPTION_NUMBER: {
    double number;
    if (!number_read(text, &number) || !(number >= o->low && number <= o->high))
      return fail(why, EXIT_BAD_INPUT, "--%s: '%s' is not a number from %g to %g", o->name, text,
                  o->low, o->high);
    *(double *)o->target = number;
    return true;
  }
  default: {
    option_texts *texts = o->target; /* items has room for every argument */
    texts->items[texts->count++] = text;
    return true;
  }
  }
}

static const option *find(const command_line *line, const char *name, size_t length) {
  for (size_t i = 0; i < line->option_count; i++) {
    const char *full = line->options[i].name;
    if (strlen(full) == length && strncmp(full, name, length) == 0) return &line->options[i];
  }
  return NULL;
}

static const option *find_letter(const command_line *line, char letter) {
  for (size_t i = 0; i < line->option_count; i++)
    if (line->options[i].letter == letter) return &line->options[i];
  return NULL;
}

/* One option at argv[*at]; its value is after an '=', joined to a letter, or
 * the next argument. */
static bool take_option(const command_line *line, int argc, char **argv, int *at, failure *why) {
  const char *text = argv[*at];
  const option *o;
  const char *value = NULL;
  if (text[1] == '-') {
    const char *equals = strchr(text, '=');
    o = find(line, text + 2, equals ? (size_t)(equals - text) - 2 : strlen(text) - 2);
    if (equals) value = equals + 1;
  } else {
    o = find_letter(line, text[1]);
    if (text[2]) value = text + 2;
  }
  if (!o)
    return fail(why, EXIT_BAD_INPUT, "unknown option %s; see sozai %s --help", text,
                name_of(line, argv));
  if (line->given) line->given[o - line->options] = true;
  if (o->kind == OPTION_FLAG) {
    if (value) return fail(why, EXIT_BAD_INPUT, "--%s takes no value", o->name);
    *(bool *)o->target = true;
    return true;
  }
  if (!value && o->kind == OPTION_MAYBE) value = "";
  if (!value) {
    if (*at + 1 >= argc)
      return fail(why, EXIT_BAD_INPUT, "--%s needs a value: %s", o->name, o->argument);
    value = argv[++*at];
  }
  return store(o, value, why);
}

int options_parse(const command_line *line, int argc, char **argv, const char **values,
                  failure *why) {
  for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++)
    if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
      print_help(line);
      return output_printed(why) ? OPTIONS_DONE : OPTIONS_BAD;
    }
  size_t found = 0;
  bool plain = false; /* after "--" */
  for (int i = 1; i < argc; i++) {
    if (!plain && strcmp(argv[i], "--") == 0)
      plain = true;
    else if (!plain && argv[i][0] == '-' && argv[i][1]) {
      if (!take_option(line, argc, argv, &i, why)) return OPTIONS_BAD;
    } else if (found == line->positional_count) {
      fail(why, EXIT_BAD_INPUT, "unexpected argument '%s'; see sozai %s --help", argv[i],
           name_of(line, argv));
      return OPTIONS_BAD;
    } else
      values[found++] = argv[i];
  }
  if (found + line->optional_count >= line->positional_count) return OPTIONS_RUN;
  fail(why, EXIT_BAD_INPUT, "%s: no %s is given; see sozai %s --help", argv[0],
       line->positional[found], name_of(line, argv));
  return OPTIONS_BAD;
}

/* endings: several, a space between. */
static bool ends_in_one(const char *path, const char *endings) {
  while (*endings) {
    char one[16] = "";
    size_t length = strcspn(endings, " ");
    memcpy(one, endings, length < sizeof one ? length : sizeof one - 1);
    if (ends_in(path, one)) return true;
    endings += length + (endings[length] == ' ');
  }
  return false;
}

bool options_fit(const command_line *line, const option_use *uses, size_t count, const char *output,
                 failure *why) {
  for (size_t i = 0; output && i < count; i++) {
    const option *o = find(line, uses[i].name, strlen(uses[i].name));
    if (!o || !line->given[o - line->options] || ends_in_one(output, uses[i].endings)) continue;
    return fail(why, EXIT_BAD_INPUT, "--%s: only for %s, which '%s' is not", o->name,
                uses[i].endings, output);
  }
  return true;
}

int report(const failure *why) {
  progress_clear();
  if (why->exit_code != EXIT_CLOSED_PIPE) fprintf(stderr, "sozai: %s\n", why->text);
  return why->exit_code;
}
