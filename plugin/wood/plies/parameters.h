/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_PLIES_PARAMETERS_H
#define SOZAI_WOOD_PLIES_PARAMETERS_H

#include "../../../api/sozai.h"

/* in the order of construction's choices */
enum { CONSTRUCTION_SOLID, CONSTRUCTION_PLYWOOD, CONSTRUCTION_LVL, CONSTRUCTION_BLOCKBOARD };

/* Wood's parameters of the group `plies`. */
extern const sozai_parameter plies_construction, plies_sheet_thickness, plies_sheets,
    plies_face_height, plies_count, plies_face_veneer, plies_core_veneer, plies_face_cut,
    plies_leaf_width, plies_leaf_match, plies_core_width, plies_core_gap, plies_lathe_checks,
    plies_glue_line, plies_glue_unevenness, plies_glue_colour, plies_glue_step;

#endif
