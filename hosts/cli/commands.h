/* SPDX-License-Identifier: Apache-2.0
 * The subcommands. Each gets argv[0] as its own name, and returns the
 * program's exit code: 0, EXIT_BAD_INPUT or EXIT_FAILURE. */
#ifndef SOZAI_CLI_COMMANDS_H
#define SOZAI_CLI_COMMANDS_H

int run_limits(int argc, char **argv);
int run_list(int argc, char **argv);
int run_describe(int argc, char **argv);
int run_eval(int argc, char **argv);
int run_render(int argc, char **argv);
int run_bake(int argc, char **argv);
int run_colour(int argc, char **argv);
int run_figures(int argc, char **argv);
int run_gallery(int argc, char **argv);
int run_grow(int argc, char **argv);
int run_match(int argc, char **argv);
int run_saw(int argc, char **argv);
int run_validate(int argc, char **argv);

#endif
