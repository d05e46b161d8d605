/* SPDX-License-Identifier: Apache-2.0 */
#include "colour.h"

#include <stdatomic.h>
#include <string.h>

#include "../../api/sozai_colour.h"
#include "scalar.h"
#include "services.h"
#include "status.h"

/* ---- names of sRGB ---------------------------------------------------- */

/* Configs agree on what sRGB is, not on what it is called. */
static const char *const srgb_names[] = {"sRGB",
                                         "sRGB - Texture",
                                         "srgb_texture",
                                         "Utility - sRGB - Texture",
                                         "sRGB Encoded Rec.709 (sRGB)",
                                         "srgb_rec709_scene"};
static const char *const linear_names[] = {"scene_linear", "lin_rec709", "lin_srgb",
                                           "Linear Rec.709 (sRGB)", "Linear Rec.709"};

static int is_one_of(const char *name, const char *const *list, size_t n) {
  for (size_t i = 0; i < n; i++) {
    if (strcmp(name, list[i]) == 0) return 1;
  }
  return 0;
}
#define IS_SRGB(name) is_one_of(name, srgb_names, sizeof srgb_names / sizeof *srgb_names)
#define IS_LINEAR(name) is_one_of(name, linear_names, sizeof linear_names / sizeof *linear_names)

static const char *known_name(const sozai_colour_1 *c, const char *space) {
  if (!IS_SRGB(space) || c->has_space(c->self, space)) return space;
  for (size_t i = 0; i < sizeof srgb_names / sizeof *srgb_names; i++) {
    if (c->has_space(c->self, srgb_names[i])) return srgb_names[i];
  }
  return space;
}

/* ---- without a service ------------------------------------------------ */

/* IEC 61966-2-1, mirrored for negative numbers. */
static double srgb_to_linear(double x) {
  double a = x < 0.0 ? -x : x;
  double y = a <= 0.04045 ? a / 12.92 : scalar_exp(2.4 * scalar_log((a + 0.055) / 1.055));
  return x < 0.0 ? -y : y;
}

static int32_t convert_by_formula(const char *id, const char *space, float rgb[3]) {
  if (IS_LINEAR(space)) return SOZAI_OK;
  if (!IS_SRGB(space)) {
    return fail(SOZAI_ERROR_COLOUR,
                "%s: colour space \"%.80s\" needs a colour service, and there is none; "
                "without one sRGB and lin_rec709 are known",
                id, space);
  }
  for (int c = 0; c < 3; c++) rgb[c] = (float)srgb_to_linear(rgb[c]);
  return SOZAI_OK;
}

static atomic_int warned;

void colour_close(void) { atomic_store(&warned, 0); }

static void warn_once(const sozai_host *host) {
  if (!atomic_exchange(&warned, 1)) {
    host_log(host, SOZAI_LOG_WARNING,
             "no colour service: sRGB is linearised by its formula, and the working space is "
             "taken to be linear Rec.709");
  }
}

int32_t colour_name(const sozai_host *host, const char *space, const char **out) {
  const void *found;
  int32_t r = services_find(host, SOZAI_COLOUR_1, &found);
  const sozai_colour_1 *service = found;
  *out = service && service->size >= sizeof *service ? known_name(service, space) : space;
  return r;
}

/* ---- conversion ------------------------------------------------------- */

static int32_t find_service(const sozai_host *host, const sozai_colour_1 **out) {
  const void *found;
  int32_t r = services_find(host, SOZAI_COLOUR_1, &found);
  if (r) return r;
  *out = found;
  if (*out && (*out)->size < sizeof **out) {
    return fail(SOZAI_ERROR_COLOUR, "the colour service is of %u bytes, not %zu", (*out)->size,
                sizeof **out);
  }
  if (!*out) warn_once(host);
  return SOZAI_OK;
}

static int32_t convert(const sozai_colour_1 *service, const char *id, const char *given,
                       float rgb[3]) {
  const char *space = given ? given : "sRGB";
  if (!service) return convert_by_formula(id, space, rgb);
  char message[512] = "";
  int32_t r = service->to_working(service->self, known_name(service, space), rgb, 1, message,
                                  sizeof message);
  if (r) return fail(SOZAI_ERROR_COLOUR, "%s: colour space \"%.80s\": %s", id, space, message);
  for (int c = 0; c < 3; c++) {
    if (!(rgb[c] > -1e6f && rgb[c] < 1e6f)) {
      return fail(SOZAI_ERROR_COLOUR, "%s: not finite in the working space", id);
    }
  }
  return SOZAI_OK;
}

int32_t colour_convert(const sozai_host *host, const sozai_texture_info *info, const settings *s,
                       float (*out)[3]) {
  const sozai_colour_1 *service;
  int32_t r = find_service(host, &service);
  for (uint32_t i = 0; i < info->parameter_count && !r; i++) {
    const sozai_parameter *p = info->parameters[i];
    if (p->kind != SOZAI_KIND_COLOUR) continue;
    for (int c = 0; c < 3; c++) out[i][c] = (float)s->list[i].number[c];
    r = convert(service, p->id, s->list[i].text, out[i]);
  }
  return r;
}

int32_t colour_hue(const sozai_host *host, const sozai_parameter *p, const setting *s,
                   float out[3]) {
  const sozai_colour_1 *service;
  int32_t r = find_service(host, &service);
  if (r) return r;
  double most = 0.0;
  for (int c = 0; c < 3; c++) most = s->number[c] > most ? s->number[c] : most;
  for (int c = 0; c < 3; c++) out[c] = most > 0.0 ? (float)(s->number[c] / most) : 1.0f;
  return convert(service, p->id, s->text, out);
}

int32_t colour_list(const sozai_host *host, const char *space, float (*rgb)[3], uint32_t count) {
  const sozai_colour_1 *service;
  int32_t r = find_service(host, &service);
  for (uint32_t i = 0; i < count && !r; i++) r = convert(service, space, space, rgb[i]);
  return r;
}
