/* SPDX-License-Identifier: Apache-2.0
 * make-mesh SHAPE [N] > FILE.obj: box, udim, leg, blob; N cells to a side. */
#include <stdlib.h>
#include <string.h>
#include "meshes.h"

int main(int argc, char **argv) {
  const char *shape = argc > 1 ? argv[1] : "";
  unsigned cells = argc > 2 ? (unsigned)strtoul(argv[2], NULL, 10) : 20;
  if (strcmp(shape, "box") == 0)
    write_box(stdout, cells, false);
  else if (strcmp(shape, "udim") == 0)
    write_box(stdout, cells, true);
  else if (strcmp(shape, "leg") == 0)
    write_leg(stdout, 2 * cells, 4 * cells);
  else if (strcmp(shape, "blob") == 0)
    write_blob(stdout, cells);
  else {
    fputs("usage: make-mesh box|udim|leg|blob [N] > FILE.obj\n", stderr);
    return 2;
  }
  return fflush(stdout) != 0;
}
