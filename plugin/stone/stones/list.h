/* SPDX-License-Identifier: Apache-2.0
 *
 * The list of stones, in the order in which hosts show them: X(id) for each.
 */
#ifndef SOZAI_STONE_STONES_LIST_H
#define SOZAI_STONE_STONES_LIST_H

/* clang-format off */
#define STONES_ALL(X) \
  X(inada) \
  X(makabe) \
  X(aji) \
  X(shirakawa) \
  X(mannari) \
  X(baltic_brown) \
  X(gabbro) \
  X(basalt) \
  X(komatsu) \
  X(oya) \
  X(carrara) \
  X(statuario) \
  X(calacatta) \
  X(bardiglio) \
  X(nero_marquina) \
  X(emperador) \
  X(rosso_levanto) \
  X(verde_alpi) \
  X(travertino) \
  X(jura) \
  X(bluestone) \
  X(slate) \
  X(sandstone) \
  X(terrazzo) \
  X(nihonmatsu) \
  X(tako) \
  X(isahaya) \
  X(towada) \
  X(rosa_beta) \
  X(rosso_verona) \
  X(solnhofen) \
  X(portland) \
  X(bath) \
  X(york) \
  X(teppei) \
  X(porphyry) \
  X(belgian_block) \
  X(granite_fan) \
  X(basalt_setts) \
  X(ishidatami) \
  X(brick_paver) \
  X(concrete_paver) \
  X(cast_concrete) \
  X(exposed_aggregate) \
  X(araidashi) \
  X(puddingstone)
/* clang-format on */

#endif
