/* SPDX-License-Identifier: Apache-2.0
 * `sozai grow fiber`, which takes options of its own. */
#ifndef SOZAI_CLI_GROW_FIBER_H
#define SOZAI_CLI_GROW_FIBER_H

/* argv[1] is "fiber". */
int run_grow_fiber(int argc, char **argv);

#endif
