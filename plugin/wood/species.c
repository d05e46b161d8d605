/* SPDX-License-Identifier: Apache-2.0
 *
 * The species, as data. A new species is one more entry here: its values, its
 * label and the literature its figures come from.
 *
 * Anatomy (vessel diameters and densities, rows, ring structure) is typical
 * of the ranges that the literature named gives for the species, and not the
 * measurement of one tree; colours are the planed wood's as seen, in sRGB.
 */
#include "species.h"

#define COUNT(a) (sizeof(a) / sizeof((a)[0]))
#define NUMBER(name, x)                                                                            \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_FLOAT, .number = { x }                                          \
  }
#define WHOLE(name, x)                                                                             \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_INT, .number = { x }                                            \
  }
#define CHOICE(name, c)                                                                            \
  { .id = name, .kind = SOZAI_KIND_CHOICE, .text = c }
/* sRGB as 8-bit numbers */
#define SRGB(name, r, g, b)                                                                        \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_COLOUR, .number = {(r) / 255.0, (g) / 255.0, (b) / 255.0},      \
    .text = "sRGB"                                                                                 \
  }
#define SPECIES(key, name, about, literature)                                                      \
  static const sozai_preset species_##key = {.size = sizeof(sozai_preset),                         \
                                             .value_count = COUNT(values_##key),                   \
                                             .id = #key,                                           \
                                             .label = name,                                        \
                                             .doc = about,                                         \
                                             .source = literature,                                 \
                                             .values = values_##key}

#define ITOH                                                                                       \
  "Itoh T., Anatomical description of Japanese hardwoods I-V, Wood Research and Technical Notes "  \
  "31-35 (1995-1999)"
#define INSIDEWOOD "InsideWood database, NC State University (IAWA feature codes)"
#define FFPRI "Forestry and Forest Products Research Institute, Japanese wood database"

static const sozai_value values_onigurumi[] = {
    NUMBER("ring_width", 2.6),
    NUMBER("ring_variation", 0.28),
    NUMBER("latewood_fraction", 0.3),
    NUMBER("latewood_abruptness", 0.15),
    NUMBER("undulation", 1.1),
    CHOICE("porosity", "semi_ring"),
    NUMBER("vessel_density", 7.0),
    NUMBER("vessel_diameter", 190.0),
    NUMBER("vessel_diameter_late", 105.0),
    NUMBER("vessel_diameter_spread", 0.2),
    NUMBER("slope_noise", 0.04),
    NUMBER("slope_noise_length", 45.0),
    NUMBER("fibre_brightness", 0.15),
    SRGB("earlywood_colour", 168, 128, 88),
    SRGB("latewood_colour", 132, 95, 63),
    SRGB("vessel_colour", 124, 94, 65),
    SRGB("sapwood_earlywood_colour", 206, 186, 154),
    SRGB("sapwood_latewood_colour", 180, 156, 120),
    NUMBER("heartwood_years", 120.0),
    NUMBER("specular", 0.06),
};
SPECIES(onigurumi, "Onigurumi, Japanese walnut (Juglans mandshurica var. sachalinensis)",
        "Brown, with vessels that shrink across the ring and show as fine dark streaks.",
        ITOH "; " INSIDEWOOD);

static const sozai_value values_makaba[] = {
    NUMBER("ring_width", 1.8),
    NUMBER("ring_variation", 0.22),
    NUMBER("latewood_fraction", 0.1),
    NUMBER("latewood_abruptness", 0.5),
    NUMBER("undulation", 0.7),
    CHOICE("porosity", "diffuse"),
    NUMBER("vessel_density", 32.0),
    NUMBER("vessel_diameter", 92.0),
    NUMBER("vessel_diameter_spread", 0.2),
    NUMBER("slope_noise", 0.03),
    NUMBER("slope_noise_length", 45.0),
    NUMBER("fibre_brightness", 0.09),
    SRGB("earlywood_colour", 214, 170, 130),
    SRGB("latewood_colour", 186, 138, 99),
    SRGB("vessel_colour", 197, 154, 116),
    SRGB("sapwood_earlywood_colour", 232, 212, 180),
    SRGB("sapwood_latewood_colour", 212, 186, 150),
    NUMBER("heartwood_years", 110.0),
    NUMBER("specular", 0.09),
    NUMBER("ray_density", 4.0),
    NUMBER("ray_height", 0.4),
    NUMBER("ray_width", 45.0),
    NUMBER("ray_length", 25.0),
    SRGB("ray_colour", 202, 156, 114),
};
SPECIES(makaba, "Makaba, monarch birch (Betula maximowicziana)",
        "Pale reddish brown, even, with small vessels alike across the ring.",
        ITOH "; " INSIDEWOOD);

static const sozai_value values_yamazakura[] = {
    NUMBER("ring_width", 2.2),
    NUMBER("ring_variation", 0.25),
    NUMBER("latewood_fraction", 0.14),
    NUMBER("latewood_abruptness", 0.4),
    NUMBER("undulation", 0.9),
    CHOICE("porosity", "diffuse"),
    NUMBER("vessel_density", 120.0),
    NUMBER("vessel_diameter", 46.0),
    NUMBER("vessel_diameter_spread", 0.2),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    NUMBER("fibre_brightness", 0.1),
    SRGB("earlywood_colour", 200, 146, 102),
    SRGB("latewood_colour", 164, 108, 70),
    SRGB("vessel_colour", 180, 129, 90),
    SRGB("sapwood_earlywood_colour", 222, 192, 152),
    SRGB("sapwood_latewood_colour", 196, 160, 120),
    NUMBER("heartwood_years", 90.0),
    NUMBER("specular", 0.08),
    NUMBER("ray_density", 3.0),
    NUMBER("ray_height", 0.5),
    NUMBER("ray_width", 55.0),
    NUMBER("ray_length", 30.0),
    SRGB("ray_colour", 212, 164, 122),
};
SPECIES(yamazakura, "Yamazakura, Japanese cherry (Cerasus jamasakura)",
        "Warm brown, close-textured; vessels too small to see but for a silky streak.",
        ITOH "; " INSIDEWOOD);

static const sozai_value values_mizunara[] = {
    NUMBER("ring_width", 2.0),
    NUMBER("ring_variation", 0.28),
    NUMBER("latewood_fraction", 0.5),
    NUMBER("latewood_abruptness", 0.35),
    NUMBER("undulation", 0.9),
    CHOICE("porosity", "ring"),
    NUMBER("vessel_density", 14.0),
    NUMBER("vessel_diameter", 50.0),
    NUMBER("vessel_diameter_spread", 0.25),
    WHOLE("earlywood_rows", 2),
    NUMBER("earlywood_density", 2.4),
    NUMBER("earlywood_diameter", 270.0),
    NUMBER("earlywood_diameter_spread", 0.16),
    NUMBER("earlywood_jitter", 0.6),
    NUMBER("slope_noise", 0.045),
    NUMBER("slope_noise_length", 45.0),
    NUMBER("fibre_brightness", 0.12),
    SRGB("earlywood_colour", 203, 171, 128),
    SRGB("latewood_colour", 180, 144, 100),
    SRGB("vessel_colour", 169, 138, 99),
    SRGB("sapwood_earlywood_colour", 220, 199, 162),
    SRGB("sapwood_latewood_colour", 200, 176, 136),
    NUMBER("heartwood_years", 150.0),
    NUMBER("specular", 0.06),
    NUMBER("ray_density", 0.014),
    NUMBER("ray_height", 20.0),
    NUMBER("ray_width", 300.0),
    NUMBER("ray_length", 36.0),
    SRGB("ray_colour", 208, 177, 135),
};
SPECIES(mizunara, "Mizunara, Japanese oak (Quercus crispula)",
        "Light brown; one to three rows of very large earlywood vessels.", ITOH "; " INSIDEWOOD);

static const sozai_value values_harunire[] = {
    NUMBER("ring_width", 2.4),
    NUMBER("ring_variation", 0.3),
    NUMBER("latewood_fraction", 0.45),
    NUMBER("latewood_abruptness", 0.4),
    NUMBER("undulation", 1.2),
    CHOICE("porosity", "ring"),
    NUMBER("vessel_density", 45.0),
    NUMBER("vessel_diameter", 48.0),
    NUMBER("vessel_diameter_spread", 0.25),
    WHOLE("earlywood_rows", 2),
    NUMBER("earlywood_density", 2.9),
    NUMBER("earlywood_diameter", 220.0),
    NUMBER("earlywood_diameter_spread", 0.18),
    NUMBER("earlywood_jitter", 0.7),
    NUMBER("slope_noise", 0.05),
    NUMBER("slope_noise_length", 45.0),
    NUMBER("fibre_brightness", 0.14),
    SRGB("earlywood_colour", 196, 158, 116),
    SRGB("latewood_colour", 160, 118, 78),
    SRGB("vessel_colour", 158, 122, 86),
    SRGB("sapwood_earlywood_colour", 222, 200, 160),
    SRGB("sapwood_latewood_colour", 192, 164, 122),
    NUMBER("heartwood_years", 120.0),
    NUMBER("specular", 0.06),
    NUMBER("ray_density", 2.0),
    NUMBER("ray_height", 0.5),
    NUMBER("ray_width", 60.0),
    NUMBER("ray_length", 30.0),
    SRGB("ray_colour", 199, 162, 120),
};
SPECIES(harunire, "Harunire, Japanese elm (Ulmus davidiana var. japonica)",
        "Brown and lively; large earlywood vessels, many small ones in the latewood.",
        ITOH "; " INSIDEWOOD);

static const sozai_value values_keyaki[] = {
    NUMBER("ring_width", 2.8),
    NUMBER("ring_variation", 0.3),
    NUMBER("latewood_fraction", 0.4),
    NUMBER("latewood_abruptness", 0.5),
    NUMBER("undulation", 1.1),
    CHOICE("porosity", "ring"),
    NUMBER("vessel_density", 30.0),
    NUMBER("vessel_diameter", 42.0),
    NUMBER("vessel_diameter_spread", 0.25),
    WHOLE("earlywood_rows", 1),
    NUMBER("earlywood_density", 3.0),
    NUMBER("earlywood_diameter", 230.0),
    NUMBER("earlywood_diameter_spread", 0.15),
    NUMBER("earlywood_jitter", 0.5),
    NUMBER("slope_noise", 0.045),
    NUMBER("slope_noise_length", 45.0),
    NUMBER("fibre_brightness", 0.12),
    SRGB("earlywood_colour", 212, 160, 100),
    SRGB("latewood_colour", 172, 112, 60),
    SRGB("vessel_colour", 152, 107, 63),
    SRGB("sapwood_earlywood_colour", 228, 202, 152),
    SRGB("sapwood_latewood_colour", 196, 160, 108),
    NUMBER("heartwood_years", 140.0),
    NUMBER("specular", 0.08),
    NUMBER("ray_density", 1.6),
    NUMBER("ray_height", 0.6),
    NUMBER("ray_width", 75.0),
    NUMBER("ray_length", 30.0),
    SRGB("ray_colour", 188, 136, 80),
};
SPECIES(keyaki, "Keyaki, Japanese zelkova (Zelkova serrata)",
        "Golden brown, strongly figured; one row of large earlywood vessels.",
        ITOH "; " INSIDEWOOD);

static const sozai_value values_sugi[] = {
    NUMBER("ring_width", 3.4),
    NUMBER("ring_variation", 0.32),
    NUMBER("latewood_fraction", 0.2),
    NUMBER("latewood_abruptness", 0.72),
    NUMBER("latewood_variation", 0.35),
    NUMBER("undulation", 0.9),
    CHOICE("porosity", "none"),
    NUMBER("slope_noise", 0.012),
    NUMBER("fibre_brightness", 0.09),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 226, 176, 138),
    SRGB("latewood_colour", 152, 86, 56),
    SRGB("sapwood_earlywood_colour", 238, 220, 190),
    SRGB("sapwood_latewood_colour", 198, 158, 116),
    NUMBER("heartwood_years", 110.0),
    NUMBER("specular", 0.05),
};
SPECIES(sugi, "Sugi, Japanese cedar (Cryptomeria japonica)",
        "A conifer: pinkish earlywood and dark, abrupt latewood.", FFPRI "; " INSIDEWOOD);

static const sozai_value values_hinoki[] = {
    NUMBER("ring_width", 1.9),
    NUMBER("ring_variation", 0.25),
    NUMBER("latewood_fraction", 0.15),
    NUMBER("latewood_abruptness", 0.45),
    NUMBER("latewood_variation", 0.35),
    NUMBER("undulation", 0.6),
    CHOICE("porosity", "none"),
    NUMBER("slope_noise", 0.01),
    NUMBER("fibre_brightness", 0.06),
    NUMBER("fibre_width", 0.05),
    SRGB("earlywood_colour", 236, 203, 156),
    SRGB("latewood_colour", 206, 150, 98),
    SRGB("sapwood_earlywood_colour", 240, 224, 192),
    SRGB("sapwood_latewood_colour", 214, 184, 142),
    NUMBER("heartwood_years", 130.0),
    NUMBER("specular", 0.09),
};
SPECIES(hinoki, "Hinoki, Japanese cypress (Chamaecyparis obtusa)",
        "A conifer: pale, fine and lustrous, with narrow, gradual latewood.",
        FFPRI "; " INSIDEWOOD);

static const sozai_value values_itayakaede[] = {
    NUMBER("ring_width", 1.9),
    NUMBER("ring_variation", 0.22),
    NUMBER("latewood_fraction", 0.06),
    NUMBER("latewood_abruptness", 0.8),
    NUMBER("undulation", 0.8),
    CHOICE("grain", "wavy"),
    NUMBER("wave_slope", 0.17),
    NUMBER("wave_length", 11.0),
    NUMBER("wave_irregularity", 0.75),
    CHOICE("porosity", "diffuse"),
    NUMBER("vessel_density", 42.0),
    NUMBER("vessel_diameter", 66.0),
    NUMBER("vessel_diameter_spread", 0.2),
    NUMBER("fibre_brightness", 0.07),
    SRGB("earlywood_colour", 232, 202, 160),
    SRGB("latewood_colour", 198, 156, 110),
    SRGB("vessel_colour", 214, 182, 140),
    SRGB("sapwood_earlywood_colour", 236, 214, 178),
    SRGB("sapwood_latewood_colour", 208, 174, 132),
    NUMBER("heartwood_years", 100.0),
    NUMBER("diffuse", 0.8),
    NUMBER("specular", 0.35),
    NUMBER("shininess", 12.0),
    NUMBER("ray_density", 2.4),
    NUMBER("ray_height", 0.6),
    NUMBER("ray_width", 80.0),
    NUMBER("ray_length", 30.0),
    SRGB("ray_colour", 221, 186, 144),
};
SPECIES(itayakaede, "Itayakaede, painted maple with wavy grain (Acer pictum)",
        "Nearly white, close-textured; wavy grain gives a cross figure that moves with the light.",
        ITOH "; " INSIDEWOOD);

const sozai_preset *const wood_species[] = {
    &species_onigurumi, &species_makaba,   &species_yamazakura,
    &species_mizunara,  &species_harunire, &species_keyaki,
    &species_sugi,      &species_hinoki,   &species_itayakaede,
};
const uint32_t wood_species_count = COUNT(wood_species);
