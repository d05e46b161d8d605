/* SPDX-License-Identifier: Apache-2.0 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "commands.h"
#include "options.h"
#include "output_file.h"
#include "sozai.h"

typedef struct command {
  const char *name;
  const char *help;
  int (*run)(int argc, char **argv);
} command;

static const command commands[] = {
    {"list", "the materials there are, and their presets", run_list},
    {"describe", "a material's parameters, presets and channels", run_describe},
    {"eval", "a material's answers at points of a CSV file", run_eval},
    {"render", "a picture of a material on a board, a sphere or a mesh", run_render},
    {"bake", "a surface as picture files, in shares and resumed if need be", run_bake},
    {"colour", "the colour config in force, and what the materials ask of it", run_colour},
    {"figures", "the figures of the papers, with their measured numbers", run_figures},
    {"gallery", "a folder of pictures of every preset", run_gallery},
    {"grow", "a tree, or fibre in a hull, as a mesh, curves, tables or a picture", run_grow},
    {"limits", "the ceilings on what comes from outside", run_limits},
    {"match", "a material's palette from a photograph", run_match},
    {"saw", "a log of a grown tree into boards, and a picture of its cuts", run_saw},
    {"validate", "a plugin's file, judged by the contract of sozai.h", run_validate},
};
#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

static void print_help(FILE *to) {
  fputs("usage: sozai <command> [options]\n\n", to);
  for (size_t i = 0; i < COMMAND_COUNT; i++)
    fprintf(to, "  %-10s %s\n", commands[i].name, commands[i].help);
  fputs("\n  sozai <command> --help   a command's options; also sozai help <command>\n"
        "  sozai --version          this program's version\n"
        "\nSOZAI_PLUGIN names another sozai.so to load.\n",
        to);
}

static int printed(void) {
  failure why;
  return output_printed(&why) ? 0 : report(&why);
}

static const command *find(const char *name) {
  for (size_t i = 0; i < COMMAND_COUNT; i++)
    if (strcmp(name, commands[i].name) == 0) return &commands[i];
  return NULL;
}

/* A command's exit code, or none where it was asked to stop. */
static int run(const command *c, int argc, char **argv) {
  int code = c->run(argc, argv);
  cancel_end();
  return code;
}

static int unknown(const char *name) {
  fprintf(stderr, "sozai: unknown command '%s'; see sozai --help\n", name);
  return EXIT_BAD_INPUT;
}

/* "help bake" as "bake --help". */
static int help_on(int argc, char **argv) {
  static char flag[] = "--help";
  const command *c = find(argv[0]);
  if (!c) return unknown(argv[0]);
  char **with = calloc((size_t)argc + 2, sizeof *with);
  if (!with) {
    fputs("sozai: out of memory\n", stderr);
    return EXIT_FAILURE;
  }
  memcpy(with, argv, (size_t)argc * sizeof *with);
  with[argc] = flag;
  int code = run(c, argc + 1, with);
  free(with);
  return code;
}

int main(int argc, char **argv) {
  signal(SIGXFSZ, SIG_IGN); /* a file past the size that is allowed is too */
  signal(SIGPIPE, SIG_IGN); /* a closed pipe is a failed write: what is half made is taken away */
  cancel_install();
  const char *name = argc > 1 ? argv[1] : "";
  if (strcmp(name, "--version") == 0) {
    printf("sozai %s (ABI %u.%u)\n", SOZAI_VERSION, SOZAI_ABI_MAJOR, SOZAI_ABI_MINOR);
    return printed();
  }
  if (strcmp(name, "help") == 0 && argc > 2) return help_on(argc - 2, argv + 2);
  if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
    print_help(stdout);
    return printed();
  }
  const command *c = find(name);
  if (c) return run(c, argc - 1, argv + 1);
  if (*name) return unknown(name);
  print_help(stderr);
  return EXIT_BAD_INPUT;
}
