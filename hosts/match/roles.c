/* SPDX-License-Identifier: Apache-2.0 */
#include "roles.h"

#include <stdbool.h>
#include <string.h>

const match_material match_materials[] = {
    {.id = "wood",
     .roles = {{"earlywood_colour", "sapwood_earlywood_colour"},
               {"latewood_colour", "sapwood_latewood_colour"},
               {"vessel_colour", "sapwood_vessel_colour"}},
     .brightness = "fibre_brightness",
     .part = "heartwood",
     .second_part = "sapwood",
     .boundary = "heartwood_years",
     .boundary_channel = "time",
     /* what has a colour of its own is left out, and so is what fungi change,
      * unless given */
     .board = {{"cut", "flat"},
               {"ray_density", "0"},
               {"marginal_parenchyma", "0"},
               {"paratracheal_parenchyma", "0"},
               {"parenchyma_band_width", "0"},
               {"vessel_band_parenchyma", "0"},
               {"streak_share", "0"},
               {"pigment", "0"},
               {"canal_density", "0"},
               {"spalt", "0"}}},
    /* the base and its variation, the minerals that vary it, and the specks */
    {.id = "stone",
     .roles = {{"base_colour", NULL},
               {"second_colour", NULL},
               {"black_colour", NULL},
               {"white_colour", NULL},
               {"third_colour", NULL}},
     .brightness = "grain_variation",
     .shares = {"black_share", "white_share", "second_share", "third_share"},
     .spare_share = "third_share",
     .part = "",
     .second_part = "",
     /* what would take colours of its own is left out, unless given */
     .board = {{"colour_mode", "fabric"},
               {"layout", "none"},
               {"grime", "0"},
               {"bed_contrast", "0"},
               {"inclusion_share", "0"},
               {"inclusion_second_share", "0"},
               {"inclusion_third_share", "0"},
               {"vein_width", "0"},
               {"hole_share", "0"}}},
};
const uint32_t match_material_count = sizeof match_materials / sizeof match_materials[0];

static bool has(const sozai_texture_info *info, const char *id, uint32_t kind) {
  for (uint32_t i = 0; id && i < info->parameter_count; i++)
    if (info->parameters[i]->kind == kind && strcmp(info->parameters[i]->id, id) == 0) return true;
  return false;
}

match_material match_material_of(const match_material *m, const sozai_texture_info *info) {
  match_material out = *m;
  uint32_t count = 0;
  memset(out.roles, 0, sizeof out.roles);
  for (uint32_t i = 0; i < match_role_count(m); i++) {
    match_role role = m->roles[i];
    if (!has(info, role.colour, SOZAI_KIND_COLOUR)) continue;
    if (!has(info, role.second, SOZAI_KIND_COLOUR)) role.second = NULL;
    out.roles[count++] = role;
  }
  uint32_t shares = 0;
  memset(out.shares, 0, sizeof out.shares);
  for (uint32_t i = 0; i < MOST_SHARES; i++)
    if (has(info, m->shares[i], SOZAI_KIND_FLOAT)) out.shares[shares++] = m->shares[i];
  if (!has(info, out.brightness, SOZAI_KIND_FLOAT)) out.brightness = NULL;
  if (!has(info, out.boundary, SOZAI_KIND_FLOAT)) out.boundary = NULL;
  return out;
}

uint32_t match_role_count(const match_material *m) {
  uint32_t count = 0;
  while (count < MOST_ROLES && m->roles[count].colour) count++;
  return count;
}
