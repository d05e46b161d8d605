/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"

#include <stdlib.h>
#include "options.h"

int run_figures(int argc, char **argv) {
  (void)argc, (void)argv;
  failure why;
  fail(&why, EXIT_FAILURE, "figures: not in this version");
  return report(&why);
}
