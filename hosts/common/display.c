/* SPDX-License-Identifier: Apache-2.0 */
#include "display.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- the sRGB curve, for want of a service ------------------------------- */

static float srgb_encode(float linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 1;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1 / 2.4f) - 0.055f;
}

static bool without_service(const display_choice *choice, float *rgb, size_t count, failure *why) {
  const char *name = choice->view ? choice->view : choice->display;
  if (!name && choice->look && *choice->look) name = choice->look;
  if (name) return fail(why, EXIT_FAILURE, "there is no colour service to look up '%s' in", name);
  for (size_t i = 0; i < 3 * count; i++) rgb[i] = srgb_encode(rgb[i]);
  return true;
}

/* ---- which name it is that the config lacks ------------------------------ */

static bool has(const sozai_display_1 *d, uint32_t list, const char *display, const char *name) {
  const char *item = NULL;
  for (uint32_t i = 0; i < d->count(d->self, list, display); i++)
    if (d->item(d->self, list, display, i, &item, NULL) == SOZAI_OK && strcasecmp(item, name) == 0)
      return true;
  return false;
}

static bool refuse(const sozai_display_1 *d, uint32_t list, const char *display, const char *option,
                   const char *name, failure *why) {
  char known[640] = "";
  const char *item = NULL;
  uint32_t count = d->count(d->self, list, display);
  for (uint32_t i = 0; i < count; i++) {
    size_t used = strlen(known);
    if (d->item(d->self, list, display, i, &item, NULL) == SOZAI_OK)
      snprintf(known + used, sizeof known - used, "%s%s", i ? ", " : "", item);
  }
  return fail(why, EXIT_BAD_INPUT, "--%s: the config has no %s '%.80s'%s%s; there is %s", option,
              option, name, display ? " for display " : "", display ? display : "",
              count ? known : "none");
}

/* "a, -b | c": looks in a row, and what to take where the first are missing. */
static bool check_looks(const sozai_display_1 *d, const char *looks, failure *why) {
  static const char between[] = " \t,:|+-";
  char name[128];
  for (const char *at = looks + strspn(looks, between); *at;) {
    size_t length = strcspn(at, ",:|");
    snprintf(name, sizeof name, "%.*s", (int)(length < 127 ? length : 127), at);
    size_t end = strlen(name);
    while (end > 0 && (name[end - 1] == ' ' || name[end - 1] == '\t')) name[--end] = '\0';
    if (!has(d, SOZAI_LIST_LOOKS, NULL, name))
      return refuse(d, SOZAI_LIST_LOOKS, NULL, "look", name, why);
    at += length;
    at += strspn(at, between);
  }
  return true;
}

static bool check_names(const sozai_display_1 *d, const display_choice *choice, failure *why) {
  if (choice->display && !has(d, SOZAI_LIST_DISPLAYS, NULL, choice->display))
    return refuse(d, SOZAI_LIST_DISPLAYS, NULL, "display", choice->display, why);
  const char *display = choice->display;
  if (!display) d->item(d->self, SOZAI_LIST_DISPLAYS, NULL, 0, &display, NULL);
  if (choice->view && !has(d, SOZAI_LIST_VIEWS, display, choice->view))
    return refuse(d, SOZAI_LIST_VIEWS, display, "view", choice->view, why);
  return !choice->look || check_looks(d, choice->look, why);
}

/* The service decides: a config may know views that it does not list, and looks
 * may name others to fall back on. */
bool display_check(const colour *c, const display_choice *choice, failure *why) {
  float grey[3] = {0.18f, 0.18f, 0.18f};
  if (display_apply(c, choice, grey, 1, why)) return true;
  failure first = *why;
  if (c->display && !check_names(c->display, choice, why)) return false;
  *why = first;
  return false;
}

/* ---- showing ------------------------------------------------------------- */

bool display_apply(const colour *c, const display_choice *choice, float *rgb, size_t count,
                   failure *why) {
  if (!c->display) return without_service(choice, rgb, count, why);
  char message[512] = "";
  if (c->display->to_display(c->display->self, choice->display, choice->view, choice->look, rgb,
                             count, message, sizeof message) == SOZAI_OK)
    return true;
  bool named = choice->display || choice->view || choice->look;
  return fail(why, named ? EXIT_BAD_INPUT : EXIT_FAILURE, "display transform: %s", message);
}

static bool contains_srgb(const char *name) {
  for (; *name; name++)
    if (strncasecmp(name, "sRGB", 4) == 0) return true;
  return false;
}

bool display_is_srgb(const colour *c, const display_choice *choice) {
  if (!c->display) return true;
  const char *display = choice->display;
  if (!display) c->display->item(c->display->self, SOZAI_LIST_DISPLAYS, NULL, 0, &display, NULL);
  if (!display || !contains_srgb(display)) return false;
  const float probe[3] = {0.05f, 0.2f, 0.5f};
  float shown[3] = {probe[0], probe[1], probe[2]};
  failure ignored;
  if (!display_apply(c, choice, shown, 1, &ignored)) return false;
  float most = 0;
  for (int k = 0; k < 3; k++) most = fmaxf(most, fabsf(shown[k] - probe[k]));
  return most > 1e-3f;
}

bool display_working(const colour *c, const char **name, float xy[8]) {
  static const float rec709[8] = {0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};
  if (!c->service) { /* what the plugin takes it for then */
    *name = "Linear Rec.709";
    memcpy(xy, rec709, sizeof rec709);
    return true;
  }
  *name = c->service->working_space(c->service->self);
  return c->display && c->display->chromaticities(c->display->self, NULL, xy, NULL, 0) == SOZAI_OK;
}
