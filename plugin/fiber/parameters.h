/* SPDX-License-Identifier: Apache-2.0
 *
 * The generator's parameters, one line each: the table of the ABI is made of it.
 */
#ifndef SOZAI_FIBER_PARAMETERS_H
#define SOZAI_FIBER_PARAMETERS_H

#include "../core/params.h"

/* N a number, I a whole number, C a choice, B a buffer, X a colour. Of the
 * lines: id, label, group, unit, hard range, soft range, default, sentence. */
/* clang-format off */
#define FIBER_PARAMETERS(N, I, C, B, X3) \
 B(HULL, "hull", "Hull", "hull", SOZAI_BUFFER_MESH, "The surface to fill: triangles, outward or inward alike. Open ones are closed by a vote of six rays.") \
 B(POINTS, "hull_points", "Hull as points", "hull", SOZAI_BUFFER_POINTS, "In place of a mesh, for mode=literal: dense points with outward normals.") \
 C(MODE, "mode", "Mode", "hull", mode, 0, "How distances are taken and strands moved.") \
 I(CELLS, "cells", "Cells", "hull", "", 8, 512, 32, 256, 64, "Of the distance field, along the hull's longest side; thinner parts want more.") \
 N(SPACING, "spacing", "Spacing", "hull", "mm", 0, 1e5, 0, 10, 0, "mode=literal: the hull's vertices are no further apart; 0: a hundredth of its longest side.") \
 I(SEED, "seed", "Seed", "strands", "", 0, 2147483647, 0, 100, 1, "Another number, another aggregate.") \
 I(COUNT, "count", "Count", "strands", "", 0, 50000000, 0, 100000, 2048, "How many strands; 0: as many as the packing wants.") \
 N(PACKING, "packing", "Packing", "strands", "", 1e-9, 1, 0.001, 0.3, 0.01, "count=0: the share of the hull's volume that is fibre.") \
 N(LENGTH, "length", "Length", "strands", "mm", 1e-4, 1e5, 1, 200, 10, "Along the strand: the mean.") \
 N(LENGTH_SPREAD, "length_spread", "Length spread", "strands", "", 0, 1, 0, 0.6, 0, "Standard deviation over mean.") \
 N(DIAMETER, "diameter", "Diameter", "strands", "um", 0.01, 1e6, 5, 300, 60, "Of the strand's middle: the mean.") \
 N(DIAMETER_SPREAD, "diameter_spread", "Diameter spread", "strands", "", 0, 1, 0, 0.5, 0, "Standard deviation over mean, from strand to strand.") \
 N(TAPER, "taper", "Taper", "strands", "", 0, 1, 0, 1, 1, "The ends' diameter over the middle's.") \
 I(VERTICES, "vertices", "Vertices", "crimp", "", 2, 1024, 8, 200, 32, "Of each strand. The angles are a joint's: more vertices, more crimp.") \
 N(PHI_MIN, "phi_min", "Twist from", "crimp", "deg", -360, 360, -90, 90, 0, "Least twist at a joint, about the segment before it.") \
 N(PHI_MAX, "phi_max", "Twist to", "crimp", "deg", -360, 360, -90, 90, 36, "Greatest twist at a joint.") \
 N(THETA_MIN, "theta_min", "Bend from", "crimp", "deg", -180, 180, -40, 40, 0, "Least bend at a joint.") \
 N(THETA_MAX, "theta_max", "Bend to", "crimp", "deg", -180, 180, -40, 40, 10.8, "Greatest bend at a joint.") \
 N(STEP, "step", "Step", "fitting", "mm", 0, 1e5, 0, 5, 0, "Of a strand's first moves; 0: a tenth of its length, with mode=literal a fortieth.") \
 N(TURN, "turn", "Turn", "fitting", "deg", 0, 90, 0, 20, 0, "Of a strand's first turns; 0: so that its ends move by a step.") \
 I(HALVINGS, "halvings", "Halvings", "fitting", "", 0, 12, 0, 5, 3, "How often steps are halved where none is a gain any more; mode=literal: never.") \
 I(ITERATIONS, "iterations", "Iterations", "fitting", "", 0, 4096, 0, 1000, 1000, "Moves of a strand, at most; 0: as first placed.") \
 I(ATTEMPTS, "attempts", "Attempts", "fitting", "", 1, 1000000, 100, 100000, 20000, "Places tried for a strand's middle before the hull is said to enclose nothing.") \
 C(CONTACT, "contact", "Contact", "contact", contact, 0, "Whether strands keep apart by their radii.") \
 I(ROUNDS, "rounds", "Rounds", "contact", "", 0, 1000, 0, 200, 60, "Of pushing apart, at most.") \
 N(CLEARANCE, "clearance", "Clearance", "contact", "", 0, 10, 0, 1, 0.02, "Gap kept between surfaces, in mean diameters.") \
 X3(COLOUR, "colour", "Colour", "look", 0.173, 0.125, 0.094, "Display-referred sRGB, 0 to 1.") \
 X3(COLOUR_2, "colour_2", "Second colour", "look", 0.3, 0.25, 0.2, "Of a share of the strands.") \
 N(SHARE_2, "share_2", "Second share", "look", "", 0, 1, 0, 1, 0, "How many of the strands have the second colour.") \
 N(COLOUR_SPREAD, "colour_spread", "Colour spread", "look", "", 0, 1, 0, 0.3, 0.1, "Of lightness, from strand to strand: standard deviation over mean. For renderers.") \
 N(ROUGHNESS, "roughness", "Roughness", "look", "deg", 1, 60, 3, 30, 8, "Standard deviation of the highlight along the strand. For renderers.") \
 N(ROUGHNESS_ROUND, "roughness_round", "Roughness round", "look", "", 0, 1, 0, 1, 0.3, "Around the strand. For renderers.") \
 N(TILT, "tilt", "Cuticle tilt", "look", "deg", -10, 10, 0, 5, 3, "Of the scales towards the tip. For renderers.")
/* clang-format on */

enum {
#define NAME_(name, ...) F_##name,
  FIBER_PARAMETERS(NAME_, NAME_, NAME_, NAME_, NAME_)
#undef NAME_
      FIBER_PARAMETER_COUNT
};

/* Choices, by index. */
#define MODE_FIELD 0
#define MODE_EXACT 1
#define MODE_LITERAL 2
#define CONTACT_OFF 0
#define CONTACT_RIGID 1
#define CONTACT_BEND 2

extern const sozai_parameter *const fiber_parameters[FIBER_PARAMETER_COUNT];

/* One preset to a material of the catalogue; filled when first asked, at init. */
const sozai_preset *const *fiber_presets(uint32_t *count);

#endif
