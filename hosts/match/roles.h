/* SPDX-License-Identifier: Apache-2.0
 * What of a material can be matched to a photograph, as data: the colours that
 * its albedo is linear in. To match another material, add an entry. */
#ifndef SOZAI_MATCH_ROLES_H
#define SOZAI_MATCH_ROLES_H

#include <stdint.h>
#include "sozai.h"

#define MOST_ROLES 5
#define MOST_BOARD 12
#define MOST_SHARES 4

typedef struct match_role {
  const char *colour; /* the parameter */
  const char *second; /* the parameter of the same tissue in the other part of a material of two
                         (sapwood), or NULL: both parts share it */
} match_role;

typedef struct match_material {
  const char *id;
  match_role roles[MOST_ROLES];
  /* A parameter that multiplies some of the colours by 1 + itself times a
   * pattern of mean 0, or NULL. */
  const char *brightness;
  /* Parameters that say how much of a face grains or specks of a role's colour cover. */
  const char *shares[MOST_SHARES];
  const char *spare_share; /* of those, one looked for only where the others leave ranks apart; or
                              NULL */
  const char *part, *second_part; /* what the parts of a material of two are called */
  /* The parameter that says where the second part begins, and the channel that
   * it is a value of; or NULL. */
  const char *boundary, *boundary_channel;
  const char *board[MOST_BOARD][2]; /* parameters of the face a photograph shows, unless given */
} match_material;

extern const match_material match_materials[];
extern const uint32_t match_material_count;

/* The entry as far as a plugin's material has such parameters. */
match_material match_material_of(const match_material *m, const sozai_texture_info *info);
uint32_t match_role_count(const match_material *m);

#endif
