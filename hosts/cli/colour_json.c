/* SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include "colour_report.h"
#include "json.h"

static void print_list(json *j, const sozai_display_1 *d, uint32_t list, const char *key,
                       const char *detail_key) {
  json_open(j, key, '[');
  for (uint32_t i = 0; d && i < d->count(d->self, list, NULL); i++) {
    const char *name = "", *detail = "";
    d->item(d->self, list, NULL, i, &name, &detail);
    json_open(j, NULL, '{');
    json_text(j, "name", name);
    json_text(j, detail_key, detail);
    json_close(j, '}');
  }
  json_close(j, ']');
}

static void print_displays(json *j, const sozai_display_1 *d) {
  json_open(j, "displays", '[');
  for (uint32_t i = 0; d && i < d->count(d->self, SOZAI_LIST_DISPLAYS, NULL); i++) {
    const char *display = "", *view = "", *look = "";
    d->item(d->self, SOZAI_LIST_DISPLAYS, NULL, i, &display, NULL);
    json_open(j, NULL, '{');
    json_text(j, "name", display);
    json_bool(j, "default", i == 0);
    json_open(j, "views", '[');
    for (uint32_t k = 0; k < d->count(d->self, SOZAI_LIST_VIEWS, display); k++) {
      d->item(d->self, SOZAI_LIST_VIEWS, display, k, &view, &look);
      json_open(j, NULL, '{');
      json_text(j, "name", view);
      json_bool(j, "default", k == 0);
      json_text(j, "look", look);
      json_close(j, '}');
    }
    json_close(j, ']');
    json_close(j, '}');
  }
  json_close(j, ']');
}

static void print_uses(json *j, const colour_report *r) {
  json_open(j, "in_use", '[');
  for (size_t i = 0; i < r->use_count; i++) {
    json_open(j, NULL, '{');
    json_text(j, "of", r->uses[i].what);
    json_open(j, "spaces", '[');
    for (size_t k = 0; k < r->uses[i].spaces.count; k++) {
      const space_use *s = &r->uses[i].spaces.items[k];
      json_open(j, NULL, '{');
      json_text(j, "name", s->name);
      if (s->resolved)
        json_text(j, "resolved", s->resolved);
      else
        json_null(j, "resolved");
      json_text(j, "where", s->where);
      json_close(j, '}');
    }
    json_close(j, ']');
    json_close(j, '}');
  }
  json_close(j, ']');
}

void colour_print_json(const colour_report *r) {
  static const char *const corners[4] = {"red", "green", "blue", "white"};
  const sozai_display_1 *d = r->colour->display;
  json j = {.to = stdout};
  json_open(&j, NULL, '{');
  json_text(&j, "config", r->config);
  json_text(&j, "chosen", r->chosen);
  json_text(&j, "working_space", r->working);
  if (r->has_chromaticities) {
    json_open(&j, "chromaticities", '{');
    for (int i = 0; i < 4; i++) {
      json_open(&j, corners[i], '[');
      for (int k = 0; k < 2; k++) json_number(&j, NULL, (double)r->xy[2 * i + k]);
      json_close(&j, ']');
    }
    json_close(&j, '}');
  } else
    json_null(&j, "chromaticities");
  print_list(&j, d, SOZAI_LIST_ROLES, "roles", "space");
  print_list(&j, d, SOZAI_LIST_SPACES, "spaces", "encoding");
  print_displays(&j, d);
  print_list(&j, d, SOZAI_LIST_LOOKS, "looks", "process_space");
  print_uses(&j, r);
  json_close(&j, '}');
}
