/* SPDX-License-Identifier: Apache-2.0
 *
 * The words in which a stone is written: its values, in the units that `sozai
 * describe stone` gives, and then STONE with its id, its label, a sentence and the
 * literature that its figures come from.
 *
 * Grain sizes, modes (shares of area) and structures are typical of the ranges
 * that the literature named gives for the rock, and not the measurement of one
 * block; colours are the stone's as seen polished or sawn, in sRGB.
 */
#ifndef SOZAI_STONE_STONES_ENTRY_H
#define SOZAI_STONE_STONES_ENTRY_H

#include "../../core/preset.h"
#include "list.h"

#define DECLARED(key) extern const sozai_preset stone_##key;
STONES_ALL(DECLARED)
#undef DECLARED

#define STONE(key, name, about, literature)                                                        \
  PRESET(stone_##key, #key, values_##key, name, about, literature)

#define IUGS                                                                                       \
  "Le Maitre R. W. (ed.), Igneous Rocks: A Classification and Glossary of Terms, Cambridge "       \
  "University Press (2002)"
#define GSJ "Geological Survey of Japan, AIST, Geological Museum's rock specimens"
#define EN12440 "EN 12440, Natural stone: denomination criteria"
#define EN13748 "EN 13748-1, Terrazzo tiles for internal use"
#define MACKENZIE                                                                                  \
  "MacKenzie W. S., Donaldson C. H., Guilford C., Atlas of Igneous Rocks and their Textures, "     \
  "Longman (1982)"
#define FISHER "Fisher R. V., Schmincke H.-U., Pyroclastic Rocks, Springer (1984)"
#define PRIMAVORI                                                                                  \
  "Primavori P., Carrara Marble: a nomination for Global Heritage Stone Resource from Italy, "     \
  "Geological Society Special Publication 407 (2015)"
#define FLUGEL "Flügel E., Microfacies of Carbonate Rocks, Springer (2004)"
#define PENTECOST "Pentecost A., Travertine, Springer (2005)"
#define PEREIRA                                                                                    \
  "Pereira D. et al., Petit Granit: a Belgian limestone used in heritage, construction and "       \
  "sculpture, Episodes 38 (2015)"
#define PETTIJOHN "Pettijohn F. J., Sedimentary Rocks, Harper & Row (3rd ed., 1975)"
#define CALLWEY                                                                                    \
  "Germann A., Kownatzki R., Mehling G. (eds.), Natural Stone Lexicon, Callwey (5th ed., 2003)"
#define EN1342 "EN 1342, Setts of natural stone for external paving"
#define EN1344 "EN 1344, Clay pavers"
#define EN1338 "EN 1338, Concrete paving blocks"
#define CONCRETE "Neville A. M., Properties of Concrete, Pearson (5th ed., 2011)"

/* Slabs with sawn edges and setts with split ones, by their size and joint, mm. */
#define SAWN_PAVING(l, w, j)                                                                       \
  NUMBER("stone_length", l), NUMBER("stone_width", w), NUMBER("joint_width", j),                   \
      NUMBER("joint_depth", 2.0), NUMBER("bevel", 2.0), NUMBER("edge_round", 1.0),                 \
      NUMBER("edge_drop", 0.5), NUMBER("tilt", 0.5)
#define CUT_SETTS(size, j)                                                                         \
  NUMBER("stone_length", size), NUMBER("stone_width", size), NUMBER("joint_width", j),             \
      NUMBER("joint_depth", 5.0), NUMBER("joint_grain", 0.8), NUMBER("edge_round", 0.13 * (size)), \
      NUMBER("edge_drop", 0.045 * (size)), NUMBER("edge_chipping", 0.8),                           \
      NUMBER("corner_radius", 0.12 * (size)), NUMBER("joint_wander", 0.035),                       \
      NUMBER("joint_divisions", 5.0), NUMBER("crown", 2.5), NUMBER("tilt", 1.5),                   \
      NUMBER("settle", 3.0), NUMBER("length_variation", 0.2)

#endif
