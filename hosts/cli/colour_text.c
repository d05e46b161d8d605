/* SPDX-License-Identifier: Apache-2.0 */
#include "colour_report.h"

#include <stdio.h>

static void print_list(const colour_report *r, uint32_t list, const char *title,
                       const char *between) {
  const sozai_display_1 *d = r->colour->display;
  uint32_t count = d->count(d->self, list, NULL);
  printf("\n%s%s\n", title, count ? "" : "\n  none");
  for (uint32_t i = 0; i < count; i++) {
    const char *name = "", *detail = "";
    d->item(d->self, list, NULL, i, &name, &detail);
    if (*detail)
      printf("  %-32s %s%s\n", name, between, detail);
    else
      printf("  %s\n", name);
  }
}

static void print_displays(const sozai_display_1 *d) {
  printf("\ndisplays and views\n");
  for (uint32_t i = 0; i < d->count(d->self, SOZAI_LIST_DISPLAYS, NULL); i++) {
    const char *display = "", *view = "", *look = "";
    d->item(d->self, SOZAI_LIST_DISPLAYS, NULL, i, &display, NULL);
    printf("  %s%s\n", display, i == 0 ? "  (default)" : "");
    for (uint32_t k = 0; k < d->count(d->self, SOZAI_LIST_VIEWS, display); k++) {
      d->item(d->self, SOZAI_LIST_VIEWS, display, k, &view, &look);
      printf("    %s%s%s%s\n", view, k == 0 ? "  (default)" : "", *look ? "  look: " : "", look);
    }
  }
}

static void print_use(const colour_use *u) {
  printf("\nin use: %s\n%s", u->what, u->spaces.count ? "" : "  none\n");
  for (size_t i = 0; i < u->spaces.count; i++) {
    const space_use *s = &u->spaces.items[i];
    printf("  %s -> %s\n    %s\n", s->name,
           s->resolved ? s->resolved : "MISSING: the config has no such space", s->where);
  }
}

void colour_print_text(const colour_report *r) {
  static const char *const corners[4] = {"red", "green", "blue", "white"};
  printf("config         %s\n  chosen       %s\nworking space  %s\n", r->config, r->chosen,
         r->working);
  for (int i = 0; r->has_chromaticities && i < 4; i++)
    printf("  %-12s x %.5f  y %.5f\n", corners[i], (double)r->xy[2 * i], (double)r->xy[2 * i + 1]);
  if (!r->has_chromaticities) puts("  chromaticities: the config cannot say");
  if (r->colour->display) {
    print_list(r, SOZAI_LIST_ROLES, "roles", "");
    print_list(r, SOZAI_LIST_SPACES, "colour spaces", "");
    print_displays(r->colour->display);
    print_list(r, SOZAI_LIST_LOOKS, "looks", "in ");
  }
  for (size_t i = 0; i < r->use_count; i++) print_use(&r->uses[i]);
}
