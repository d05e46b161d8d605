/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* mkdtemp, popen */
#include "other_path.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static unsigned level(int pixel, int channel) {
  uint32_t x = 2654435761u * (uint32_t)(pixel * 3 + channel + 1);
  x = (x ^ (x >> 15)) * 2246822519u;
  x ^= x >> 13;
  /* Every other pixel is dark: squared. */
  x &= 0xFFFF;
  return pixel % 2 ? x * x / 65535 : x;
}

void input_colours(float scale, float rgb[PIXELS * 3]) {
  for (int i = 0; i < PIXELS * 3; i++) rgb[i] = (float)level(i / 3, i % 3) / 65535.0f * scale;
}

bool has_program(const char *name) {
  char command[128];
  snprintf(command, sizeof command, "command -v %s >/dev/null", name);
  return system(command) == 0;
}

static void run(const char *folder, const char *format, ...) {
  char command[4096];
  int used = snprintf(command, sizeof command, "cd %s && ", folder);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(command + used, sizeof command - (size_t)used, format, arguments);
  va_end(arguments);
  if (system(command) != 0) fail_msg("failed: %s", command);
}

/* in.ppm, PIXELS colours without the scale. */
static void make_input(char *folder) {
  assert_non_null(mkdtemp(folder));
  char path[64];
  snprintf(path, sizeof path, "%s/in.ppm", folder);
  FILE *f = fopen(path, "w");
  assert_non_null(f);
  fprintf(f, "P3\n%d %d\n65535\n", SIDE, SIDE);
  for (int i = 0; i < PIXELS * 3; i++) fprintf(f, "%u\n", level(i / 3, i % 3));
  fclose(f);
}

/* The numbers of out.exr; then the folder goes. */
static void take_output(const char *folder, float rgb[PIXELS * 3]) {
  char command[128], line[256];
  snprintf(command, sizeof command, "oiiotool --dumpdata %s/out.exr", folder);
  FILE *f = popen(command, "r");
  assert_non_null(f);
  unsigned found = 0;
  while (fgets(line, sizeof line, f)) {
    int x, y;
    float c[3];
    if (sscanf(line, " Pixel (%d, %d): %f %f %f", &x, &y, &c[0], &c[1], &c[2]) != 5) continue;
    assert_true(x >= 0 && x < SIDE && y >= 0 && y < SIDE);
    memcpy(rgb + 3 * (y * SIDE + x), c, sizeof c);
    found++;
  }
  pclose(f);
  assert_int_equal(found, PIXELS);
  run("/tmp", "rm -r '%s'", folder);
}

void by_oiiotool(const char *config, float scale, const char *arguments, float rgb[PIXELS * 3]) {
  char folder[] = "/tmp/sozai-other-XXXXXX";
  make_input(folder);
  run(folder, "oiiotool --colorconfig '%s' in.ppm --mulc %g %s -d float -o out.exr", config,
      (double)scale, arguments);
  take_output(folder, rgb);
}

void by_ocioconvert(const char *config, const char *from, const char *to, float scale,
                    float rgb[PIXELS * 3]) {
  char folder[] = "/tmp/sozai-other-XXXXXX";
  make_input(folder);
  run(folder, "oiiotool in.ppm --mulc %g -d float -o in.exr", (double)scale);
  run(folder, "OCIO='%s' ocioconvert in.exr '%s' out.exr '%s' >/dev/null", config, from, to);
  take_output(folder, rgb);
}
