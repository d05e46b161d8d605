/* SPDX-License-Identifier: Apache-2.0
 *
 * The generator's parameters as the ABI describes them, and its presets.
 */
#include "parameters.h"

#include "../generator_parameters.h"

#include "catalogue.h"

static const char *const mode_choices[] = {"field", "exact", "literal"};
static const char *const mode_docs[] = {"distances from a field of exact ones",
                                        "exact distances, slow",
                                        "as the paper: the nearest vertex, one step size"};
static const char *const contact_choices[] = {"off", "rigid", "bend"};
static const char *const contact_docs[] = {"strands pass through one another, as in the paper",
                                           "pushed apart whole",
                                           "pushed apart, and bent where they touch"};

FIBER_PARAMETERS(N_, I_, C_, B_, X3_)

#define AT_(name, ...) [F_##name] = &p_##name,
const sozai_parameter *const fiber_parameters[FIBER_PARAMETER_COUNT] = {
    FIBER_PARAMETERS(AT_, AT_, AT_, AT_, AT_)};

/* ---- presets ----------------------------------------------------------- */

#define PRESETS_MOST 64
#define VALUES_MOST 24

static sozai_preset presets[PRESETS_MOST];
static const sozai_preset *preset_list[PRESETS_MOST];
static sozai_value preset_values[PRESETS_MOST][VALUES_MOST];

static void put(sozai_value **to, const char *id, double x) {
  *(*to)++ = (sozai_value){.id = id, .kind = SOZAI_KIND_FLOAT, .number = {x}};
}

static void put_colour(sozai_value **to, const char *id, const uint8_t c[3]) {
  *(*to)++ = (sozai_value){
      .id = id, .kind = SOZAI_KIND_FLOAT3, .number = {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0}};
}

static uint32_t put_material(sozai_value *list, const fiber_material *m) {
  sozai_value *to = list;
  put(&to, "length", m->length);
  put(&to, "length_spread", m->length_spread);
  put(&to, "diameter", m->diameter);
  put(&to, "diameter_spread", m->diameter_spread);
  put(&to, "taper", m->taper);
  *to++ = (sozai_value){.id = "vertices", .kind = SOZAI_KIND_INT, .number = {m->vertices}};
  put(&to, "phi_min", m->phi[0]);
  put(&to, "phi_max", m->phi[1]);
  put(&to, "theta_min", m->theta[0]);
  put(&to, "theta_max", m->theta[1]);
  put(&to, "packing", m->packing);
  put_colour(&to, "colour", m->colour);
  put_colour(&to, "colour_2", m->share_2 > 0 ? m->colour_2 : m->colour);
  put(&to, "share_2", m->share_2);
  put(&to, "colour_spread", m->colour_spread);
  put(&to, "roughness", m->roughness);
  put(&to, "roughness_round", m->roughness_round);
  put(&to, "tilt", m->tilt);
  return (uint32_t)(to - list);
}

const sozai_preset *const *fiber_presets(uint32_t *count) {
  *count = fiber_material_count < PRESETS_MOST ? fiber_material_count : PRESETS_MOST;
  for (uint32_t i = 0; !preset_list[*count - 1] && i < *count; i++) {
    const fiber_material *m = fiber_materials[i];
    presets[i] = (sozai_preset){.size = sizeof(sozai_preset),
                                .id = m->id,
                                .label = m->label,
                                .doc = m->doc,
                                .source = m->source,
                                .values = preset_values[i]};
    presets[i].value_count = put_material(preset_values[i], m);
    preset_list[i] = &presets[i];
  }
  return preset_list;
}
