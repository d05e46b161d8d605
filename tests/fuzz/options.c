/* SPDX-License-Identifier: Apache-2.0
 * A command's arguments, one to a line: options of every kind, then what render makes of its own,
 * and hulls by name. */
#include "fuzz.h"

#include <math.h>
#include <string.h>
#include "hulls.h"
#include "job_options.h"
#include "options.h"

#define MOST 64

/* The hulls themselves are the bench's and the tests': only their names are read here. */
bool mesh_allocate(mesh *m, uint32_t points, uint32_t triangles, failure *why) {
  (void)points, (void)triangles;
  memset(m, 0, sizeof *m);
  return fail(why, EXIT_FAILURE, "no hulls here");
}

void progress_clear(void) {}

static void check_job(const render_job *j) {
  for (int i = 0; i < 3; i++) {
    CHECK(isfinite(j->size[i]) && j->size[i] >= 0);
    CHECK(!j->has_target || fabs(j->target[i]) <= 1e6);
  }
  CHECK(fabs(j->camera_azimuth) <= 720 && fabs(j->camera_elevation) <= 90);
  CHECK(fabs(j->light_azimuth) <= 720 && fabs(j->light_elevation) <= 90);
}

static void parse(int argc, char **argv) {
  bool flag = false;
  double number = 1;
  uint32_t count = 1, size[2] = {1, 1};
  const char *hull = NULL, *items[MOST], *values[2] = {NULL, NULL};
  option_texts pairs = {items, 0};
  job_options job = {0};
  const option table[] = {
      {"flag", 'f', OPTION_FLAG, &flag, NULL, "", 0, 0},
      {"hull", 'u', OPTION_TEXT, &hull, "NAME", "", 0, 0},
      {"number", 'n', OPTION_NUMBER, &number, "N", "", -1.5, 40},
      {"count", 'c', OPTION_COUNT, &count, "N", "", 0, 4294967295.0},
      {"param", 'p', OPTION_PAIRS, &pairs, "NAME=VALUE", "", 0, 0},
      {"resolution", 'r', OPTION_SIZE, size, "WxH", "", 1, 65536},
      {"shape", 0, OPTION_TEXT, &job.shape, "S", "", 0, 0},
      {"size", 0, OPTION_TEXT, &job.size, "S", "", 0, 0},
      {"camera", 0, OPTION_TEXT, &job.camera, "S", "", 0, 0},
      {"target", 0, OPTION_TEXT, &job.target, "S", "", 0, 0},
      {"light", 0, OPTION_TEXT, &job.light, "S", "", 0, 0},
      {"up", 0, OPTION_TEXT, &job.up, "S", "", 0, 0},
  };
  static const char *const positional[] = {"material", "file"};
  const command_line line = {"fuzz",     NULL, "", table, sizeof table / sizeof *table,
                             positional, 2,    1,  NULL};
  failure why = {0, ""};
  int r = options_parse(&line, argc, argv, values, &why);
  CHECK(r == OPTIONS_RUN || r == OPTIONS_BAD);
  if (r == OPTIONS_BAD) {
    CHECK(why.exit_code == EXIT_BAD_INPUT && *why.text);
    return;
  }
  CHECK(number >= -1.5 && number <= 40 && size[0] >= 1 && size[1] <= 65536 && values[0]);
  render_job to = {.camera_angle = 30};
  const recipe_surface surface = {.shape = RECIPE_PLANE, .size = {10, 10, 0}};
  if (job_options_apply(&to, &job, &surface, &why)) check_job(&to);
  mesh m;
  if (hull) CHECK(!hull_make_named(&m, hull, &why));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = malloc(size + 1), *argv[MOST] = {"fuzz"};
  CHECK(text);
  if (size) memcpy(text, data, size);
  text[size] = '\0';
  int argc = 1;
  char *rest = text;
  for (char *word; argc < MOST - 1 && (word = strsep(&rest, "\n"));)
    if (strcmp(word, "-h") != 0 && strcmp(word, "--help") != 0) argv[argc++] = word;
  parse(argc, argv);
  free(text);
  return 0;
}
