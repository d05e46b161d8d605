/* SPDX-License-Identifier: Apache-2.0
 *
 * From the catalogue's entries and arrangements to presets: figures of fibres are
 * written down once, in the catalogue.
 */
#include "presets.h"

#include "../catalogue.h"
#include "arrangements.h"

#define PRESETS_MAX 64
#define VALUES_MAX 40

typedef struct {
  sozai_value list[VALUES_MAX];
  uint32_t count;
} values;

static void number(values *v, const char *id, double x) {
  v->list[v->count++] = (sozai_value){.id = id, .kind = SOZAI_KIND_FLOAT, .number = {x}};
}

/* Where the arrangement says nothing, the parameter's default stands. */
static void perhaps(values *v, const char *id, double x) {
  if (x > 0.0) number(v, id, x);
}

static double either(double arrangements, double fibres) {
  return arrangements > 0.0 ? arrangements : fibres;
}

static void choice(values *v, const char *id, const char *text) {
  v->list[v->count++] = (sozai_value){.id = id, .kind = SOZAI_KIND_CHOICE, .text = text};
}

static void colour(values *v, const char *id, const uint8_t c[3]) {
  v->list[v->count++] = (sozai_value){.id = id,
                                      .kind = SOZAI_KIND_COLOUR,
                                      .number = {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0},
                                      .text = "sRGB"};
}

static void set_strand(values *v, const fiber_arrangement *a, const fiber_material *f) {
  number(v, "diameter", either(a->diameter, f->diameter));
  /* evenly spread to sqrt(3) standard deviations */
  double spread = f->diameter_spread < 0.4 ? 1.732 * f->diameter_spread : 0.7;
  number(v, "diameter_spread", either(a->diameter_spread, spread));
  double height = either(a->crimp_height, f->crimp_height);
  number(v, "crimp", height > 0.0 ? either(a->crimp, f->crimp) : 0.0);
  number(v, "crimp_height", height);
  perhaps(v, "waver", a->waver);
  number(v, "ior", f->index);
  number(v, "roughness", either(a->roughness, f->roughness));
  number(v, "tilt", f->tilt);
  /* a core of air scatters what a rough wall has let through */
  double clear = 0.55 * (1.0 - 0.8 * f->roughness_round) * (1.0 - 0.7 * f->medulla) + 0.08;
  number(v, "transmission", either(a->transmission, clear));
}

static void set_aggregate(values *v, const fiber_arrangement *a, const fiber_material *f) {
  number(v, "packing", either(a->packing, f->packing));
  perhaps(v, "thickness", a->thickness);
  perhaps(v, "bundle", a->bundle);
  number(v, "alignment", a->alignment);
  number(v, "elevation", a->elevation);
  number(v, "elevation_spread", a->elevation_spread);
  perhaps(v, "nap_drift", a->nap_drift);
  perhaps(v, "nap_reach", a->nap_reach);
  number(v, "flyaway", a->flyaway);
  number(v, "flyaway_height", a->flyaway_height);
  perhaps(v, "darkening", a->darkening);
}

static void set_cloth(values *v, const fiber_arrangement *a) {
  if (!a->weave) return;
  choice(v, "structure", "woven");
  choice(v, "weave", a->weave);
  number(v, "yarn_spacing", a->spacing);
  number(v, "weft_spacing", a->weft_spacing);
  number(v, "yarn_width", a->width);
  number(v, "yarn_flatness", a->flatness);
  perhaps(v, "yarn_swell", a->swell);
  number(v, "twist", a->twist);
  number(v, "slub", a->slub);
  perhaps(v, "hollow", a->hollow);
}

static void set_colours(values *v, const fiber_arrangement *a, const fiber_material *f) {
  colour(v, "colour", a->coloured ? a->colour : f->colour);
  const uint8_t *second = a->coloured ? a->second : f->share_2 > 0.0 ? f->colour_2 : f->colour;
  colour(v, "second_colour", second);
  colour(v, "weft_colour", a->weft_coloured ? a->weft : a->coloured ? a->colour : f->colour);
  number(v, "second_share", a->coloured ? a->second_share : f->share_2);
  double spread = 1.732 * f->colour_spread;
  number(v, "variation", either(a->variation, spread < 0.35 ? spread : 0.35));
  perhaps(v, "mottle", a->mottle);
  perhaps(v, "mottle_size", a->mottle_size);
}

const sozai_preset *const *fibertex_presets(uint32_t *count) {
  static values of[PRESETS_MAX];
  static sozai_preset made[PRESETS_MAX];
  static const sozai_preset *list[PRESETS_MAX];
  uint32_t n = 0;
  for (uint32_t i = 0; i < fiber_arrangement_count && n < PRESETS_MAX; i++) {
    const fiber_arrangement *a = &fiber_arrangements[i];
    const fiber_material *f = fiber_material_find(a->fiber);
    if (!f) continue;
    values *v = &of[n];
    v->count = 0;
    set_strand(v, a, f);
    set_aggregate(v, a, f);
    set_cloth(v, a);
    set_colours(v, a, f);
    made[n] = (sozai_preset){.size = sizeof(sozai_preset),
                             .value_count = v->count,
                             .id = a->id,
                             .label = a->label ? a->label : f->label,
                             .doc = a->doc ? a->doc : f->doc,
                             .source = a->source ? a->source : f->source,
                             .values = v->list};
    list[n] = &made[n];
    n++;
  }
  *count = n;
  return list;
}
