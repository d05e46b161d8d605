/* SPDX-License-Identifier: Apache-2.0
 *
 * What an entry is written in. Values that it does not name stay at the
 * parameters' defaults, which are those of sugi.
 */
#ifndef SOZAI_TREE_SPECIES_ENTRY_H
#define SOZAI_TREE_SPECIES_ENTRY_H

#include "../../core/preset.h"

#define TRIPLE(name, a, b, c)                                                                      \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_FLOAT3, .number = { a, b, c }                                   \
  }
#define SPECIES(key, name, about, literature) PRESET(tree_##key, #key, key, name, about, literature)

/* Richards' curves: greatest, rate, shape. */
#define HEIGHT(max, rate, shape)                                                                   \
  NUMBER("height_max", max), NUMBER("height_rate", rate), NUMBER("height_shape", shape)
#define DIAMETER(max, rate, shape)                                                                 \
  NUMBER("diameter_max", max), NUMBER("diameter_rate", rate), NUMBER("diameter_shape", shape)
/* turns a year, branches a turn, spread of both; divergence: sd, least, greatest */
#define TURNING(turns, branches, spread, sd, low, high)                                            \
  NUMBER("turns_year", turns), NUMBER("branches_turn", branches),                                  \
      NUMBER("turning_spread", spread), NUMBER("divergence_sd", sd),                               \
      NUMBER("divergence_min", low), NUMBER("divergence_max", high)
/* a, at that height in m, narrowing; b young and old; scatter */
#define CROWN(a, height, narrowing, b, b_old, scatter)                                             \
  NUMBER("crown_a", a), NUMBER("crown_height", height), NUMBER("crown_narrowing", narrowing),      \
      NUMBER("crown_b", b), NUMBER("crown_b_old", b_old), NUMBER("crown_scatter", scatter)
/* ratio when mature, age of it, years that dead branches stay */
#define CROWN_LIFE(ratio, age, shedding)                                                           \
  NUMBER("crown_ratio", ratio), NUMBER("crown_age", age), NUMBER("shedding", shedding)
/* elevation at top and base; droop, at that length; upturn; wander; slenderness */
#define BRANCHES(top, base, droop, length, upturn, wander, slender)                                \
  NUMBER("elevation_top", top), NUMBER("elevation_base", base), NUMBER("droop", droop),            \
      NUMBER("droop_length", length), NUMBER("upturn", upturn), NUMBER("wander", wander),          \
      NUMBER("slenderness", slender)
/* how far apart, from that share on; arms' share of what is left, and angle */
#define FORKS(spacing, from, share, angle)                                                         \
  NUMBER("fork_spacing", spacing), NUMBER("fork_from", from), NUMBER("fork_share", share),         \
      NUMBER("fork_angle", angle)
/* k: "2" or "3" */
#define SHOOTS(k, spacing, length, share, taper, angle, round, bare, zone, bend, jitter)           \
  NUMBER("spacing_" k, spacing), NUMBER("length_" k, length), NUMBER("share_" k, share),           \
      NUMBER("taper_" k, taper), NUMBER("angle_" k, angle), CHOICE("arrangement_" k, round),       \
      NUMBER("bare_" k, bare), NUMBER("zone_" k, zone), NUMBER("bend_" k, bend),                   \
      NUMBER("jitter_" k, jitter)
#define LEAVES(shape, spacing, site, length, width, taper, angle, round, stalk, from, zone)        \
  CHOICE("leaf", shape), NUMBER("leaf_spacing", spacing), WHOLE("leaves_site", site),              \
      NUMBER("leaf_length", length), NUMBER("leaf_width", width), NUMBER("leaf_taper", taper),     \
      NUMBER("leaf_angle", angle), CHOICE("leaf_arrangement", round), NUMBER("leaf_stalk", stalk), \
      WHOLE("leaf_from", from), NUMBER("leaf_zone", zone)
/* The year's shoots; periderm, at that age; rhytidome, turned from one age to the other. */
#define SHOOT(r, g, b) TRIPLE("shoot_colour", r, g, b)
#define PERIDERM(age, r, g, b) NUMBER("periderm_age", age), TRIPLE("bark_colour", r, g, b)
#define RHYTIDOME(from, age, r, g, b)                                                              \
  NUMBER("rhytidome_from", from), NUMBER("rhytidome_age", age), TRIPLE("rhytidome_colour", r, g, b)
/* Of rhytidome: mm deep; of its plates or strips, mm wide and long; how flat, 0 to 1. */
#define FURROWS(deep, wide, tall, flat)                                                            \
  NUMBER("bark_depth", deep), NUMBER("bark_width", wide), NUMBER("bark_length", tall),             \
      NUMBER("bark_plates", flat)
/* how many are joined, how much they are ridges, how scaly, how varied: each a share */
#define PLATES(joined, ridges, scales, varied)                                                     \
  NUMBER("bark_joined", joined), NUMBER("bark_ridges", ridges), NUMBER("bark_scales", scales),     \
      NUMBER("bark_variation", varied)
/* Of periderm: to a dm2; mm across and along the stem; how dark, 0 to 1. */
#define LENTICELS(often, across, along, dark)                                                      \
  NUMBER("lenticel_density", often), NUMBER("lenticel_length", across),                            \
      NUMBER("lenticel_height", along), NUMBER("lenticel_shade", dark)
/* Brows of branches: diameters wide; how far they droop, in halves of that; how dark, 0 to 1. */
#define SCARS(wide, droop, dark)                                                                   \
  NUMBER("scar_width", wide), NUMBER("scar_droop", droop), NUMBER("scar_shade", dark)
#define STEM(form, butt, sway) NUMBER("stem_form", form), NUMBER("butt", butt), NUMBER("sway", sway)

#endif
