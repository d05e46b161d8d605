/* SPDX-License-Identifier: Apache-2.0 */
#include "mesh_ply.h"
#include "ceilings.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static bool check_header(FILE *file, const char *path, double bytes, failure *why) {
  char line[512];
  for (int i = 0; i < PLY_MOST_LINES && fgets(line, sizeof line, file); i++) {
    char name[64];
    double count;
    if (strncmp(line, "end_header", 10) == 0) return true;
    if (sscanf(line, " element %63s %lf", name, &count) == 2 && !(count >= 0 && count <= bytes))
      return fail(why, EXIT_BAD_INPUT, "%s: a header of %.0f '%s' in a file of %.0f bytes", path,
                  count, name, bytes);
  }
  return fail(why, EXIT_BAD_INPUT, "%s: a PLY file without an end of its header", path);
}

bool mesh_ply_plausible(const char *path, failure *why) {
  FILE *file = fopen(path, "rb");
  struct stat status;
  char magic[4] = "";
  bool ok = true;
  if (file && fstat(fileno(file), &status) == 0 && S_ISREG(status.st_mode) &&
      fread(magic, 1, 3, file) == 3 && strcmp(magic, "ply") == 0)
    ok = check_header(file, path, (double)status.st_size, why);
  if (file) fclose(file);
  return ok;
}
