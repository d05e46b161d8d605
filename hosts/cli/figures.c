/* SPDX-License-Identifier: Apache-2.0
 *
 * Draws the papers' figures, each with a JSON of measured numbers beside it. */
#include "commands.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "figures_fiber.h"
#include "figures_sawn.h"
#include "figures_stone.h"
#include "figures_tree.h"
#include "figures_wood.h"
#include "folder.h"
#include "output_file.h"

static bool draw_figure(session *s, const figure *f, const char *folder, failure *why) {
  char path[4096];
  output_file o;
  int n = snprintf(path, sizeof path, "%s/%s.json", folder, f->name);
  if (n < 0 || (size_t)n >= sizeof path)
    return fail(why, EXIT_BAD_INPUT, "'%s' is too long a path", folder);
  if (!output_begin(&o, path, why)) return false;
  json j = {.to = fopen(o.writing, "w")};
  bool ok = j.to || fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(errno));
  if (ok) {
    json_open(&j, NULL, '{');
    json_text(&j, "figure", f->name);
    json_text(&j, "title", f->title);
    ok = f->draw(s, folder, f->name, &j, why);
    json_close(&j, '}');
    if (fclose(j.to) != 0 && ok)
      ok = fail(why, EXIT_FAILURE, "cannot write %s: %s", path, strerror(errno));
  }
  if (ok) return output_commit(&o, why);
  output_discard(&o);
  return false;
}

static bool draw_each(session *s, const figure *list, size_t count, const char *only,
                      const char *folder, failure *why) {
  for (size_t i = 0; i < count; i++) {
    if (only && strncmp(list[i].name, only, strlen(only)) != 0) continue;
    if (!draw_figure(s, &list[i], folder, why)) return false;
    printf("%s/%s.png  %s\n", folder, list[i].name, list[i].title);
  }
  return true;
}

static bool known(const char *only) {
  const figure *const lists[] = {wood_figures, stone_figures, tree_figures, fiber_figures,
                                 sawn_figures};
  const size_t counts[] = {wood_figure_count, stone_figure_count, tree_figure_count,
                           fiber_figure_count, sawn_figure_count};
  for (int k = 0; k < 5; k++)
    for (size_t i = 0; i < counts[k]; i++)
      if (strncmp(lists[k][i].name, only, strlen(only)) == 0) return true;
  return false;
}

static bool draw_all(const session_options *shared, const char *only, const char *folder,
                     failure *why) {
  if (!folder) return fail(why, EXIT_BAD_INPUT, "figures: no output is given: -o DIR");
  if (only && !known(only))
    return fail(why, EXIT_BAD_INPUT, "figures: none begins with '%s'", only);
  session s;
  if (!session_open(&s, shared, why)) return false;
  bool ok = folder_make(folder) ||
            fail(why, EXIT_FAILURE, "cannot make the folder %s: %s", folder, strerror(errno));
  ok = ok && draw_each(&s, wood_figures, wood_figure_count, only, folder, why) &&
       draw_each(&s, stone_figures, stone_figure_count, only, folder, why) &&
       draw_each(&s, tree_figures, tree_figure_count, only, folder, why) &&
       draw_each(&s, fiber_figures, fiber_figure_count, only, folder, why) &&
       draw_each(&s, sawn_figures, sawn_figure_count, only, folder, why);
  session_close(&s);
  return ok;
}

int run_figures(int argc, char **argv) {
  failure why = {0};
  session_options shared;
  if (!session_options_init(&shared, argc, &why)) return report(&why);
  const char *folder = NULL, *only = NULL;
  const option options[] = {
      {"output", 'o', OPTION_TEXT, &folder, "DIR", "folder for the figures; made if need be", 0, 0},
      SESSION_DISPLAY_OPTIONS(shared),
      SESSION_RUN_OPTIONS(shared)};
  static const char *const positional[] = {"which"};
  const command_line line = {
      .usage = "figures [which] -o DIR [options]",
      .about = "Draws the figures of the papers that the materials "
               "implement, each with a JSON of\nthe numbers measured in it "
               "beside it; or those\nalone whose names begin with <which>: fiber, tree-0.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0],
      .positional = positional,
      .positional_count = 1,
      .optional_count = 1};
  int parsed = options_parse(&line, argc, argv, &only, &why);
  int code = 0;
  if (parsed == OPTIONS_BAD || (parsed == OPTIONS_RUN && !draw_all(&shared, only, folder, &why)))
    code = report(&why);
  session_options_free(&shared);
  return code;
}
