/* SPDX-License-Identifier: Apache-2.0
 *
 * What has been asked for, and so which stages there are.
 */
#ifndef SOZAI_WOOD_STAGES_WANTS_H
#define SOZAI_WOOD_STAGES_WANTS_H

#include "../plies/ply.h"

/* What has been asked for, and the stages that it takes. */
typedef struct {
  int radiance, colour, fibre, dive;
  int late, bundle, vessel, lobe, direction, section, picture, cone, lobes, board, relief;
  const ply_taps *taps; /* what the plies are told, if the wood is of plies */
} wood_wants;

static wood_wants wants_of(const wood_constants *w, const kernel_io *io) {
  wood_wants q;
  q.taps = NULL;
  q.radiance = kernel_wants(io, WOOD_RADIANCE, 3);
  q.colour = kernel_wants(io, WOOD_ALBEDO, 3) || q.radiance;
  q.fibre = kernel_wants(io, WOOD_FIBER, 3);
  q.dive = kernel_wants(io, WOOD_DIVE, 1);
  q.vessel = kernel_wants(io, WOOD_VESSEL, 1) || kernel_wants(io, WOOD_RAY, 1) ||
             kernel_wants(io, WOOD_CANAL, 1) || kernel_wants(io, WOOD_PARENCHYMA, 1) || q.colour;
  q.lobes = kernel_wants(io, WOOD_FIBER_LOBE, 6);
  q.vessel = q.vessel || (q.lobes && w->cone);
  q.late = kernel_wants(io, WOOD_LATEWOOD, 1) || q.vessel;
  q.picture = w->picture && q.late;
  if (w->picture) q.late = q.vessel = 0;
  q.bundle = q.late && (w->has_front || q.colour);
  q.lobe = kernel_wants(io, WOOD_SPECULAR, 2) || q.radiance;
  q.cone = kernel_wants(io, WOOD_CONE_COLOUR, 5) || kernel_wants(io, WOOD_COAT_ROUGHNESS, 1) ||
           kernel_wants(io, WOOD_RAY_LUSTRE, 1) || q.lobes; /* by the normal that relief leaves */
  q.board = kernel_wants(io, WOOD_BOARD_ID, WOOD_CANAL - WOOD_BOARD_ID);
  q.relief = w->surface.relief && (q.lobe || q.cone || (w->surface.stains && q.colour) ||
                                   kernel_wants(io, WOOD_NORMAL, 4));
  if (q.relief && w->bands.on && !w->picture) q.late = 1;
  q.bundle = q.bundle || (q.late && (w->bands.on || w->has_strays));
  q.direction = q.fibre || q.dive || q.radiance || q.cone || q.relief;
  q.section = q.direction || q.vessel || q.bundle || q.picture || q.lobe || q.cone ||
              kernel_wants(io, WOOD_REFERENCE, 2);
  return q;
}

#endif
