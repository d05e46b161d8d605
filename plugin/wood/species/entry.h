/* SPDX-License-Identifier: Apache-2.0
 *
 * The words an entry of the catalogue is written in. A line of several values
 * names them here, in the units that `sozai describe wood` prints.
 *
 * Anatomy (vessel diameters and densities, rows, rays, ring structure) is
 * typical of the ranges that the literature named gives for the species, and
 * not the measurement of one tree; colours are the planed wood's as seen, in
 * sRGB. Rays are those that the eye meets: the finest are left to the fibres.
 */
#ifndef SOZAI_WOOD_SPECIES_ENTRY_H
#define SOZAI_WOOD_SPECIES_ENTRY_H

#include "../../core/preset.h"
#include "list.h"

#define DECLARE(key) extern const sozai_preset species_##key;
SPECIES_ALL(DECLARE)
#undef DECLARE

#define RINGS(width, variation, waviness)                                                          \
  NUMBER("ring_width", width), NUMBER("ring_variation", variation), NUMBER("undulation", waviness)
#define LATEWOOD(fraction, abruptness)                                                             \
  NUMBER("latewood_fraction", fraction), NUMBER("latewood_abruptness", abruptness)

#define WAVY(slope, length, irregularity, reach)                                                   \
  CHOICE("grain", "wavy"), NUMBER("wave_slope", slope), NUMBER("wave_length", length),             \
      NUMBER("wave_irregularity", irregularity), NUMBER("wave_reach", reach)
#define INTERLOCKED_BY(slope, years, length, irregularity)                                         \
  CHOICE("grain", "interlocked"), NUMBER("interlocked_slope", slope),                              \
      NUMBER("interlocked_years", years), NUMBER("interlocked_length", length),                    \
      NUMBER("interlocked_irregularity", irregularity)
/* Of wood that is sought for its figure: it moves with the eye, too, as fibres' gloss does, in the
 * wood's own hue. reflectance: in its brightest channel; less of dark wood. */
#define LUSTRE(reflectance)                                                                        \
  CHOICE("reflection", "fibre_cone"), NUMBER("specular_tint", 1.0),                                \
      NUMBER("fibre_reflectance", reflectance)
/* And of wood whose flakes are: dull where the fibres shine, they flash where those do not. lustre:
 * the rays' over the fibres'. */
#define SILVER_GRAIN(reflectance, lustre) LUSTRE(reflectance), NUMBER("ray_lustre", lustre)
#define INTERLOCKED(slope, years, length) INTERLOCKED_BY(slope, years, length, 0.7)

#define CURL(slope, length, irregularity, reach)                                                   \
  NUMBER("curl_slope", slope), NUMBER("curl_length", length),                                      \
      NUMBER("curl_irregularity", irregularity), NUMBER("curl_reach", reach)
#define QUILT(slope, height, width)                                                                \
  NUMBER("quilt_slope", slope), NUMBER("quilt_height", height), NUMBER("quilt_width", width)
#define EYES(density, diameter, depth, length)                                                     \
  NUMBER("eye_density", density), NUMBER("eye_diameter", diameter), NUMBER("eye_depth", depth),    \
      NUMBER("eye_length", length)

#define SPALT(amount, size, line)                                                                  \
  NUMBER("spalt", amount), NUMBER("spalt_size", size), NUMBER("spalt_line", line)

/* Rings that heartwood takes to turn into sapwood, by how the literature calls their boundary;
 * where it calls it distinct, the parameter's own 0.8. */
#define FAIRLY_DISTINCT 3.0
#define INDISTINCT 8.0

/* Of any wood, along the stem: a board of 2 m is seldom of one shade from end to end. */
#define DRIFT NUMBER("drift", 0.03)

/* deepening: of latewood, as densities rise within it in the literature's profiles. */
#define CONIFER(deepening)                                                                         \
  CHOICE("porosity", "none"), DRIFT, NUMBER("latewood_stray", 0.12),                               \
      NUMBER("latewood_deepening", deepening)
#define DIFFUSE_POROUS(density, diameter, spread)                                                  \
  CHOICE("porosity", "diffuse"), DRIFT, NUMBER("latewood_stray", 0.15),                            \
      NUMBER("vessel_density", density), NUMBER("vessel_diameter", diameter),                      \
      NUMBER("vessel_diameter_spread", spread)
#define SEMI_RING_POROUS(density, diameter, late, spread)                                          \
  CHOICE("porosity", "semi_ring"), DRIFT, NUMBER("latewood_stray", 0.2),                           \
      NUMBER("vessel_density", density), NUMBER("vessel_diameter", diameter),                      \
      NUMBER("vessel_diameter_late", late), NUMBER("vessel_diameter_spread", spread)
/* The latewood's vessels; the earlywood's follow as EARLYWOOD_ROWS. */
#define RING_POROUS(density, diameter, spread)                                                     \
  CHOICE("porosity", "ring"), DRIFT, NUMBER("latewood_stray", 0.12),                               \
      NUMBER("vessel_density", density), NUMBER("vessel_diameter", diameter),                      \
      NUMBER("vessel_diameter_spread", spread)
#define EARLYWOOD_ROWS(rows, density, diameter, spread, jitter)                                    \
  WHOLE("earlywood_rows", rows), NUMBER("earlywood_density", density),                             \
      NUMBER("earlywood_diameter", diameter), NUMBER("earlywood_diameter_spread", spread),         \
      NUMBER("earlywood_jitter", jitter)
/* How those of the latewood, or all of diffuse-porous wood, stand together; by the IAWA list of
 * microscopic features for hardwood identification (1989), 6 to 8. */
#define VESSEL_BANDS(arrangement, share, spacing, waviness)                                        \
  CHOICE("vessel_arrangement", arrangement), NUMBER("vessel_bands", share),                        \
      NUMBER("vessel_band_spacing", spacing), NUMBER("vessel_band_waviness", waviness)
/* Axial parenchyma, by features 79 to 89 of that list: about vessels, um, and how much farther
 * round the stem; in bands of their own, um, every so many mm; between the vessels of bands; at a
 * ring's end, um. */
#define SHEATHS(thickness, wings)                                                                  \
  NUMBER("paratracheal_parenchyma", thickness), NUMBER("paratracheal_wings", wings)
#define SOFT_BANDS(width, spacing, waviness)                                                       \
  NUMBER("parenchyma_band_width", width), NUMBER("parenchyma_band_spacing", spacing),              \
      NUMBER("parenchyma_band_waviness", waviness)
#define BETWEEN(share) NUMBER("vessel_band_parenchyma", share)
#define MARGINAL(width) NUMBER("marginal_parenchyma", width)
#define RAYS(density, height, width, length)                                                       \
  NUMBER("ray_density", density), NUMBER("ray_height", height), NUMBER("ray_width", width),        \
      NUMBER("ray_length", length), NUMBER("ray_shade", 0.25)
/* Wide compound rays, which are darkest where they end. */
#define COMPOUND_RAYS(density, height, width, length)                                              \
  NUMBER("ray_density", density), NUMBER("ray_height", height), NUMBER("ray_width", width),        \
      NUMBER("ray_length", length), NUMBER("ray_shade", 0.5)

/* What the light makes of earlywood's colour, sRGB, and in how many years 63 % of
 * it: directions after Sandermann and Schlumbom (Holz als Roh- und Werkstoff 20,
 * 1962), Oltean, Teischinger and Hansmann (the same, 66, 2008), and the USDA
 * Wood Handbook's notes on colour. */
#define AGED(r, g, b, years) SRGB("aged_colour", r, g, b), NUMBER("ageing_years", years)
#define MINERAL_STREAKS(share, width, length)                                                      \
  NUMBER("streak_share", share), NUMBER("streak_width", width), NUMBER("streak_length", length)
#define PIGMENT(depth, spacing, width, stray, reach)                                               \
  NUMBER("pigment", depth), NUMBER("pigment_spacing", spacing), NUMBER("pigment_width", width),    \
      NUMBER("pigment_stray", stray), NUMBER("pigment_reach", reach)
#define CANALS(density, diameter)                                                                  \
  NUMBER("canal_density", density), NUMBER("canal_diameter", diameter)
/* Cells in um and basic density, from which the share of walls follows: of the rest, which is
 * lumina, two fifths keep what light they get. */
#define DENSITY(density)                                                                           \
  NUMBER("basic_density", density), NUMBER("end_shade", 0.4 * (1.0 - (density) / 1500.0))
#define TRACHEIDS(width, early, late, density)                                                     \
  NUMBER("cell_width", width), NUMBER("cell_depth", early), NUMBER("cell_depth_late", late),       \
      NUMBER("cell_length", 3.0), DENSITY(density), NUMBER("fine_ray_density", 40.0)
#define FIBRES(width, density)                                                                     \
  NUMBER("cell_width", width), NUMBER("cell_depth", width),                                        \
      NUMBER("cell_depth_late", 0.85 * (width)), NUMBER("cell_length", 1.2),                       \
      NUMBER("cell_irregularity", 1.0), NUMBER("fine_ray_density", 20.0), DENSITY(density)

/* Of the generator tree; years; mm up its stem. */
#define TREE(species, age, height)                                                                 \
  TEXT("tree", species), NUMBER("tree_age", age), NUMBER("log_height", height)

#define SPECIES(key, name, about, literature)                                                      \
  PRESET(species_##key, #key, values_##key, name, about, literature)

#define ITOH                                                                                       \
  "Itoh T., Anatomical description of Japanese hardwoods I-V, Wood Research and Technical Notes "  \
  "31-35 (1995-1999)"
#define INSIDEWOOD "InsideWood database, NC State University (IAWA feature codes)"
#define FFPRI "Forestry and Forest Products Research Institute, Japanese wood database"
#define WAGENFUEHR "Wagenfuehr R., Holzatlas, 6th edition (2007)"
#define SCHOCH                                                                                     \
  "Schoch W., Heller I., Schweingruber F. H., Kienast F., Wood anatomy of central European "       \
  "species (2004)"
#define HANDBOOK "USDA Forest Products Laboratory, Wood Handbook, FPL-GTR-190 (2010)"
#define PANSHIN "Panshin A. J., de Zeeuw C., Textbook of wood technology, 4th edition (1980)"
#define RICHTER                                                                                    \
  "Richter H. G., Dallwitz M. J., Commercial timbers: descriptions, illustrations, "               \
  "identification, and information retrieval (2000 onwards)"
#define METCALFE "Metcalfe C. R., Chalk L., Anatomy of the dicotyledons (1950)"
#define BEALS                                                                                      \
  "Beals H. O., Davis T. C., Figure in wood: an illustrated review, Alabama Agricultural "         \
  "Experiment Station bulletin 486 (1977)"
#define BRAGG                                                                                      \
  "Bragg D. C., The birdseye figured grain in sugar maple: literature review, nomenclature, and "  \
  "structural characteristics, Canadian Journal of Forest Research 29 (1999)"
#define ROBINSON                                                                                   \
  "Robinson S. C., Richter D. L., Laks P. E., Colonization of sugar maple by spalting fungi, "     \
  "Forest Products Journal 57 (2007)"
#define GYMNOSPERMS                                                                                \
  "IAWA Committee, IAWA list of microscopic features for softwood identification, IAWA Journal "   \
  "25 (2004)"

#endif
