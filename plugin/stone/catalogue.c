/* SPDX-License-Identifier: Apache-2.0
 *
 * The catalogue of stones, as data. A new stone is one more entry here: its
 * values, its label and the literature its figures come from.
 *
 * Grain sizes, modes (shares of area) and structures are typical of the ranges
 * that the literature named gives for the rock, and not the measurement of one
 * block; colours are the stone's as seen polished or sawn, in sRGB.
 */
#include "catalogue.h"

#include "../core/preset.h"

#define STONE(key, name, about, literature)                                                        \
  static const sozai_preset stone_##key = {.size = sizeof(sozai_preset),                           \
                                           .value_count = COUNT(values_##key),                     \
                                           .id = #key,                                             \
                                           .label = name,                                          \
                                           .doc = about,                                           \
                                           .source = literature,                                   \
                                           .values = values_##key}

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

static const sozai_value values_inada[] = {
    NUMBER("grain_size", 3.4),
    NUMBER("grain_grading", 0.8),
    NUMBER("grain_interlock", 0.75),
    NUMBER("grain_blur", 0.16),
    NUMBER("second_share", 0.33),
    NUMBER("third_share", 0.24),
    NUMBER("grain_variation", 0.1),
    NUMBER("mottle", 0.075),
    NUMBER("mottle_size", 2.2),
    SRGB("base_colour", 214, 210, 203),
    SRGB("second_colour", 160, 158, 155),
    SRGB("third_colour", 226, 219, 208),
    NUMBER("black_share", 0.055),
    NUMBER("white_share", 0.0),
    NUMBER("speck_size", 1.9),
    SRGB("black_colour", 38, 36, 36),
};
STONE(inada, "Inada granite (Inada-ishi, Ibaraki)",
      "White biotite granite of medium to coarse grain: white feldspar, grey glassy quartz, black "
      "mica.",
      IUGS "; " GSJ);

static const sozai_value values_makabe[] = {
    NUMBER("grain_size", 1.8),
    NUMBER("grain_grading", 0.7),
    NUMBER("grain_interlock", 0.7),
    NUMBER("grain_blur", 0.12),
    NUMBER("second_share", 0.32),
    NUMBER("third_share", 0.18),
    NUMBER("grain_variation", 0.1),
    NUMBER("mottle", 0.07),
    NUMBER("mottle_size", 1.4),
    SRGB("base_colour", 196, 197, 197),
    SRGB("second_colour", 148, 150, 152),
    SRGB("third_colour", 208, 204, 198),
    NUMBER("black_share", 0.075),
    NUMBER("white_share", 0.012),
    NUMBER("speck_size", 1.15),
    SRGB("black_colour", 42, 42, 44),
    SRGB("white_colour", 228, 228, 226),
};
STONE(makabe, "Makabe granite (Makabe-ishi, Ibaraki)",
      "Bluish grey two-mica granite, finer than Inada's and even.", IUGS "; " GSJ);

static const sozai_value values_aji[] = {
    NUMBER("grain_size", 0.75),           NUMBER("grain_grading", 0.6),
    NUMBER("grain_interlock", 0.6),       NUMBER("grain_blur", 0.07),
    NUMBER("second_share", 0.34),         NUMBER("third_share", 0.12),
    NUMBER("grain_variation", 0.1),       NUMBER("mottle", 0.09),
    NUMBER("mottle_size", 16.0),          SRGB("base_colour", 168, 171, 174),
    SRGB("second_colour", 122, 125, 129), SRGB("third_colour", 184, 182, 178),
    NUMBER("black_share", 0.11),          NUMBER("speck_size", 0.6),
    SRGB("black_colour", 40, 41, 44),
};
STONE(aji, "Aji granite (Aji-ishi, Kagawa), fine",
      "Fine-grained grey biotite granite, clouded by fu, a soft mottle of light and dark.",
      IUGS "; " GSJ);

static const sozai_value values_shirakawa[] = {
    NUMBER("grain_size", 2.4),
    NUMBER("grain_grading", 0.7),
    NUMBER("grain_interlock", 0.7),
    NUMBER("grain_blur", 0.15),
    NUMBER("second_share", 0.34),
    NUMBER("third_share", 0.26),
    NUMBER("grain_variation", 0.1),
    NUMBER("mottle", 0.07),
    NUMBER("mottle_size", 1.8),
    SRGB("base_colour", 216, 209, 197),
    SRGB("second_colour", 166, 160, 152),
    SRGB("third_colour", 211, 194, 176),
    NUMBER("black_share", 0.05),
    NUMBER("speck_size", 1.3),
    SRGB("black_colour", 45, 40, 37),
    CHOICE("finish", "bush_hammered"),
};
STONE(shirakawa, "Shirakawa granite (Shirakawa-ishi, Kyoto)",
      "Pale, slightly warm biotite granite of medium grain, peppered with mica; Kyoto's lanterns "
      "and gardens.",
      IUGS "; " GSJ);

static const sozai_value values_mannari[] = {
    NUMBER("grain_size", 4.2),
    NUMBER("grain_grading", 0.85),
    NUMBER("grain_interlock", 0.75),
    NUMBER("grain_blur", 0.2),
    NUMBER("second_share", 0.32),
    NUMBER("third_share", 0.24),
    NUMBER("grain_variation", 0.12),
    NUMBER("mottle", 0.075),
    NUMBER("mottle_size", 2.4),
    SRGB("base_colour", 198, 158, 140),
    SRGB("second_colour", 138, 133, 129),
    SRGB("third_colour", 205, 192, 180),
    NUMBER("black_share", 0.035),
    NUMBER("speck_size", 2.0),
    SRGB("black_colour", 40, 36, 34),
};
STONE(
    mannari, "Mannari granite (Mannari-ishi, Okayama)",
    "Pink granite: salmon alkali feldspar among grey quartz, white plagioclase and a little mica.",
    IUGS "; " GSJ);

static const sozai_value values_baltic_brown[] = {
    NUMBER("grain_size", 3.0),
    NUMBER("grain_grading", 0.8),
    NUMBER("grain_interlock", 0.8),
    NUMBER("grain_blur", 0.18),
    NUMBER("second_share", 0.34),
    NUMBER("third_share", 0.22),
    NUMBER("grain_variation", 0.15),
    SRGB("base_colour", 62, 50, 42),
    SRGB("second_colour", 104, 90, 78),
    SRGB("third_colour", 128, 110, 88),
    NUMBER("inclusion_size", 36.0),
    NUMBER("inclusion_share", 0.28),
    NUMBER("inclusion_second_share", 0.12),
    NUMBER("inclusion_gap", 1.5),
    NUMBER("inclusion_roundness", 0.8),
    NUMBER("inclusion_grading", 0.55),
    NUMBER("inclusion_interlock", 0.25),
    NUMBER("inclusion_variation", 0.16),
    SRGB("inclusion_colour", 122, 86, 68),
    SRGB("inclusion_second_colour", 116, 98, 76),
    NUMBER("black_share", 0.08),
    NUMBER("speck_size", 2.6),
    SRGB("black_colour", 26, 24, 24),
    NUMBER("mottle", 0.1),
    NUMBER("mottle_size", 3.0),
};
STONE(baltic_brown, "Baltic Brown (rapakivi granite, Finland)",
      "Round eyes of brown alkali feldspar in a dark ground of quartz and hornblende.",
      IUGS "; " EN12440);

static const sozai_value values_gabbro[] = {
    NUMBER("grain_size", 1.5),
    NUMBER("grain_grading", 0.7),
    NUMBER("grain_stretch", 1.3),
    NUMBER("grain_interlock", 0.55),
    NUMBER("grain_blur", 0.1),
    NUMBER("second_share", 0.4),
    NUMBER("third_share", 0.1),
    NUMBER("grain_variation", 0.2),
    SRGB("base_colour", 34, 35, 35),
    SRGB("second_colour", 70, 71, 71),
    SRGB("third_colour", 98, 99, 98),
    NUMBER("black_share", 0.06),
    NUMBER("white_share", 0.006),
    NUMBER("speck_size", 1.0),
    SRGB("black_colour", 16, 16, 16),
    SRGB("white_colour", 150, 150, 146),
    NUMBER("mottle", 0.1),
    NUMBER("mottle_size", 1.5),
};
STONE(gabbro, "Black gabbro (Ukigane-ishi, Fukushima)",
      "Nearly black: plagioclase laths, grey, between pyroxene and hornblende.", IUGS "; " GSJ);

static const sozai_value values_basalt[] = {
    NUMBER("grain_size", 0.3),
    NUMBER("grain_grading", 0.6),
    NUMBER("grain_interlock", 0.5),
    NUMBER("grain_blur", 0.05),
    NUMBER("second_share", 0.4),
    NUMBER("third_share", 0.12),
    NUMBER("grain_variation", 0.15),
    NUMBER("mottle", 0.05),
    NUMBER("mottle_size", 14.0),
    SRGB("base_colour", 58, 60, 62),
    SRGB("second_colour", 80, 82, 83),
    SRGB("third_colour", 44, 46, 48),
    NUMBER("inclusion_size", 3.0),
    NUMBER("inclusion_share", 0.012),
    NUMBER("inclusion_second_share", 0.02),
    NUMBER("inclusion_gap", 0.3),
    NUMBER("inclusion_roundness", 0.3),
    NUMBER("inclusion_grading", 0.6),
    NUMBER("inclusion_interlock", 0.2),
    SRGB("inclusion_colour", 92, 94, 66),
    SRGB("inclusion_second_colour", 112, 113, 112),
    NUMBER("hole_size", 1.4),
    NUMBER("hole_share", 0.012),
    NUMBER("hole_stretch", 1.3),
    SRGB("hole_colour", 26, 26, 27),
    CHOICE("finish", "honed"),
};
STONE(basalt, "Basalt (Genbu-gan)",
      "Dark grey, dense, of a grain too fine to see, with small olivines and a few vesicles.",
      IUGS "; " MACKENZIE);

static const sozai_value values_komatsu[] = {
    NUMBER("grain_size", 0.35),
    NUMBER("grain_grading", 0.6),
    NUMBER("grain_interlock", 0.5),
    NUMBER("grain_blur", 0.06),
    NUMBER("second_share", 0.4),
    NUMBER("third_share", 0.15),
    NUMBER("grain_variation", 0.1),
    NUMBER("mottle", 0.04),
    NUMBER("mottle_size", 20.0),
    SRGB("base_colour", 128, 131, 127),
    SRGB("second_colour", 112, 115, 112),
    SRGB("third_colour", 142, 144, 139),
    NUMBER("inclusion_size", 1.7),
    NUMBER("inclusion_share", 0.09),
    NUMBER("inclusion_second_share", 0.035),
    NUMBER("inclusion_gap", 0.15),
    NUMBER("inclusion_roundness", 0.15),
    NUMBER("inclusion_grading", 0.7),
    NUMBER("inclusion_interlock", 0.15),
    NUMBER("inclusion_variation", 0.12),
    SRGB("inclusion_colour", 176, 177, 171),
    SRGB("inclusion_second_colour", 62, 64, 62),
    CHOICE("finish", "honed"),
};
STONE(komatsu, "Hon-Komatsu andesite (Kanagawa)",
      "Fine greenish grey andesite with small white plagioclase and dark pyroxene.", IUGS "; " GSJ);

static const sozai_value values_oya[] = {
    NUMBER("grain_size", 0.8),
    NUMBER("grain_grading", 0.8),
    NUMBER("grain_interlock", 0.8),
    NUMBER("grain_blur", 0.15),
    NUMBER("second_share", 0.3),
    NUMBER("third_share", 0.22),
    NUMBER("grain_variation", 0.12),
    NUMBER("mottle", 0.05),
    NUMBER("mottle_size", 22.0),
    SRGB("base_colour", 183, 184, 164),
    SRGB("second_colour", 168, 171, 152),
    SRGB("third_colour", 200, 198, 181),
    NUMBER("inclusion_size", 15.0),
    NUMBER("inclusion_share", 0.07),
    NUMBER("inclusion_second_share", 0.1),
    NUMBER("inclusion_gap", 0.5),
    NUMBER("inclusion_roundness", 0.55),
    NUMBER("inclusion_grading", 0.85),
    NUMBER("inclusion_stretch", 1.8),
    NUMBER("inclusion_interlock", 0.8),
    NUMBER("inclusion_variation", 0.12),
    SRGB("inclusion_colour", 150, 134, 98),
    SRGB("inclusion_second_colour", 196, 198, 182),
    NUMBER("black_share", 0.012),
    NUMBER("white_share", 0.02),
    NUMBER("speck_size", 1.2),
    SRGB("black_colour", 74, 72, 62),
    SRGB("white_colour", 222, 220, 208),
    NUMBER("hole_size", 3.2),
    NUMBER("hole_share", 0.02),
    NUMBER("hole_stretch", 1.6),
    SRGB("hole_colour", 104, 88, 62),
    CHOICE("finish", "sawn"),
};
STONE(
    oya, "Oya tuff (Oya-ishi, Tochigi)",
    "Pale green, soft: pumice and glass, with brown clots of clay, miso, that weather into holes.",
    FISHER "; " GSJ);

static const sozai_value values_carrara[] = {
    NUMBER("grain_size", 0.45),
    NUMBER("grain_grading", 0.4),
    NUMBER("grain_interlock", 0.3),
    NUMBER("grain_blur", 0.25),
    NUMBER("second_share", 0.4),
    NUMBER("third_share", 0.0),
    NUMBER("grain_variation", 0.035),
    NUMBER("mottle", 0.06),
    NUMBER("mottle_size", 60.0),
    SRGB("base_colour", 229, 230, 230),
    SRGB("second_colour", 222, 224, 225),
    NUMBER("vein_spacing", 110.0),
    NUMBER("vein_width", 16.0),
    NUMBER("vein_softness", 5.0),
    NUMBER("vein_warp", 0.75),
    SRGB("vein_colour", 158, 163, 169),
    NUMBER("ior", 1.6),
};
STONE(carrara, "Carrara marble (Bianco Carrara)",
      "White, of fine sugary grain, with soft grey veins and clouds.", PRIMAVORI "; " EN12440);

static const sozai_value values_nero_marquina[] = {
    NUMBER("grain_size", 0.3),
    NUMBER("grain_grading", 0.5),
    NUMBER("grain_interlock", 0.4),
    NUMBER("grain_blur", 0.1),
    NUMBER("second_share", 0.4),
    NUMBER("grain_variation", 0.15),
    NUMBER("mottle", 0.12),
    NUMBER("mottle_size", 50.0),
    SRGB("base_colour", 27, 27, 29),
    SRGB("second_colour", 35, 35, 37),
    NUMBER("white_share", 0.003),
    NUMBER("speck_size", 2.0),
    SRGB("white_colour", 120, 120, 122),
    NUMBER("vein_spacing", 120.0),
    NUMBER("vein_width", 6.0),
    NUMBER("vein_softness", 0.35),
    NUMBER("vein_warp", 0.8),
    SRGB("vein_colour", 212, 210, 206),
    NUMBER("ior", 1.6),
};
STONE(nero_marquina, "Nero Marquina (limestone, Spain)",
      "Black, fine, cut by sharp white veins of calcite.", FLUGEL "; " EN12440);

static const sozai_value values_travertino[] = {
    NUMBER("grain_size", 0.6),
    NUMBER("grain_grading", 0.5),
    NUMBER("grain_stretch", 1.8),
    NUMBER("grain_interlock", 0.5),
    NUMBER("grain_blur", 0.2),
    NUMBER("second_share", 0.35),
    NUMBER("third_share", 0.0),
    NUMBER("grain_variation", 0.05),
    NUMBER("mottle", 0.045),
    NUMBER("mottle_size", 22.0),
    SRGB("base_colour", 222, 208, 184),
    SRGB("second_colour", 214, 199, 174),
    NUMBER("bed_thickness", 11.0),
    NUMBER("bed_contrast", 0.9),
    NUMBER("bed_wave", 7.0),
    NUMBER("bed_wavelength", 90.0),
    SRGB("bed_colour", 192, 167, 131),
    NUMBER("hole_size", 2.3),
    NUMBER("hole_share", 0.05),
    NUMBER("hole_stretch", 3.6),
    SRGB("hole_colour", 122, 96, 66),
    CHOICE("finish", "honed"),
    NUMBER("ior", 1.6),
    NUMBER("black_share", 0.018),
    NUMBER("speck_size", 1.6),
    NUMBER("speck_stretch", 2.4),
    SRGB("black_colour", 140, 114, 82),
};
STONE(travertino, "Travertino Romano (Tivoli)",
      "Cream calcite laid down in bands, with holes drawn out along them.", PENTECOST "; " EN12440);

static const sozai_value values_jura[] = {
    NUMBER("grain_size", 0.5),
    NUMBER("grain_grading", 0.6),
    NUMBER("grain_interlock", 0.6),
    NUMBER("grain_blur", 0.15),
    NUMBER("second_share", 0.35),
    NUMBER("grain_variation", 0.05),
    NUMBER("mottle", 0.05),
    NUMBER("mottle_size", 26.0),
    SRGB("base_colour", 208, 194, 168),
    SRGB("second_colour", 199, 184, 157),
    NUMBER("inclusion_size", 17.0),
    NUMBER("inclusion_share", 0.16),
    NUMBER("inclusion_second_share", 0.06),
    NUMBER("inclusion_gap", 0.6),
    NUMBER("inclusion_roundness", 0.7),
    NUMBER("inclusion_grading", 0.8),
    NUMBER("inclusion_stretch", 1.7),
    NUMBER("inclusion_interlock", 0.9),
    NUMBER("inclusion_variation", 0.06),
    SRGB("inclusion_colour", 222, 209, 184),
    SRGB("inclusion_second_colour", 178, 160, 132),
    NUMBER("black_share", 0.006),
    NUMBER("white_share", 0.03),
    NUMBER("speck_size", 2.2),
    NUMBER("speck_stretch", 1.6),
    SRGB("black_colour", 138, 116, 88),
    SRGB("white_colour", 230, 221, 200),
    NUMBER("bed_thickness", 60.0),
    NUMBER("bed_contrast", 0.35),
    NUMBER("bed_wave", 8.0),
    NUMBER("bed_wavelength", 200.0),
    SRGB("bed_colour", 188, 168, 136),
    CHOICE("finish", "honed"),
    NUMBER("ior", 1.6),
};
STONE(jura, "Jura limestone (Treuchtlingen)",
      "Beige limestone crowded with sponges and fossils, pale on grey-beige.", FLUGEL "; " EN12440);

static const sozai_value values_bluestone[] = {
    NUMBER("grain_size", 0.5),
    NUMBER("grain_grading", 0.6),
    NUMBER("grain_interlock", 0.5),
    NUMBER("grain_blur", 0.1),
    NUMBER("second_share", 0.4),
    NUMBER("grain_variation", 0.1),
    NUMBER("mottle", 0.05),
    NUMBER("mottle_size", 30.0),
    SRGB("base_colour", 84, 88, 92),
    SRGB("second_colour", 96, 100, 104),
    NUMBER("inclusion_size", 3.4),
    NUMBER("inclusion_share", 0.17),
    NUMBER("inclusion_second_share", 0.07),
    NUMBER("inclusion_gap", 0.3),
    NUMBER("inclusion_roundness", 0.45),
    NUMBER("inclusion_grading", 0.8),
    NUMBER("inclusion_stretch", 1.3),
    NUMBER("inclusion_interlock", 0.3),
    NUMBER("inclusion_variation", 0.14),
    SRGB("inclusion_colour", 112, 115, 118),
    SRGB("inclusion_second_colour", 68, 71, 75),
    NUMBER("white_share", 0.012),
    NUMBER("speck_size", 1.6),
    SRGB("white_colour", 158, 160, 161),
    CHOICE("finish", "honed"),
    NUMBER("ior", 1.6),
};
STONE(bluestone, "Petit Granit, Belgian bluestone",
      "Blue-grey limestone full of crinoids, whose broken stems show as grey and white crystals.",
      PEREIRA "; " FLUGEL);

static const sozai_value values_slate[] = {
    NUMBER("grain_size", 0.25),
    NUMBER("grain_grading", 0.5),
    NUMBER("grain_stretch", 4.0),
    NUMBER("grain_interlock", 0.4),
    NUMBER("grain_blur", 0.05),
    NUMBER("second_share", 0.4),
    NUMBER("grain_variation", 0.12),
    NUMBER("mottle", 0.06),
    NUMBER("mottle_size", 45.0),
    SRGB("base_colour", 50, 52, 55),
    SRGB("second_colour", 57, 59, 62),
    NUMBER("bed_thickness", 9.0),
    NUMBER("bed_contrast", 0.5),
    NUMBER("bed_wave", 1.5),
    NUMBER("bed_wavelength", 150.0),
    SRGB("bed_colour", 64, 66, 69),
    NUMBER("white_share", 0.003),
    NUMBER("speck_size", 0.5),
    SRGB("white_colour", 120, 122, 124),
    CHOICE("finish", "split"),
    NUMBER("relief", 0.12),
};
STONE(slate, "Ogatsu slate (Miyagi)",
      "Black slate, split along its cleavage: even, fine, with a faint banding.",
      PETTIJOHN "; " GSJ);

static const sozai_value values_sandstone[] = {
    NUMBER("grain_size", 0.35),
    NUMBER("grain_grading", 0.6),
    NUMBER("grain_interlock", 0.2),
    NUMBER("grain_blur", 0.03),
    NUMBER("second_share", 0.35),
    NUMBER("third_share", 0.1),
    NUMBER("grain_variation", 0.14),
    NUMBER("mottle", 0.05),
    NUMBER("mottle_size", 40.0),
    SRGB("base_colour", 160, 112, 92),
    SRGB("second_colour", 147, 99, 80),
    SRGB("third_colour", 184, 142, 120),
    NUMBER("bed_thickness", 14.0),
    NUMBER("bed_contrast", 0.9),
    NUMBER("bed_wave", 6.0),
    NUMBER("bed_wavelength", 260.0),
    SRGB("bed_colour", 190, 150, 128),
    NUMBER("black_share", 0.008),
    NUMBER("white_share", 0.01),
    NUMBER("speck_size", 0.5),
    SRGB("black_colour", 82, 56, 48),
    SRGB("white_colour", 220, 196, 178),
    CHOICE("finish", "sawn"),
};
STONE(sandstone, "Red sandstone (Indian, Agra)",
      "Red-brown sandstone, cross-lit by pale laminae; sand grains that one can just see.",
      PETTIJOHN "; " EN12440);

static const sozai_value values_terrazzo[] = {
    NUMBER("grain_size", 0.35),
    NUMBER("grain_grading", 0.4),
    NUMBER("grain_interlock", 0.3),
    NUMBER("grain_blur", 0.08),
    NUMBER("second_share", 0.3),
    NUMBER("grain_variation", 0.05),
    SRGB("base_colour", 206, 202, 194),
    SRGB("second_colour", 196, 192, 184),
    NUMBER("inclusion_size", 13.0),
    NUMBER("inclusion_share", 0.24),
    NUMBER("inclusion_second_share", 0.16),
    NUMBER("inclusion_gap", 1.2),
    NUMBER("inclusion_roundness", 0.1),
    NUMBER("inclusion_grading", 0.75),
    NUMBER("inclusion_interlock", 0.06),
    NUMBER("inclusion_variation", 0.12),
    SRGB("inclusion_colour", 172, 130, 98),
    SRGB("inclusion_second_colour", 104, 112, 106),
    NUMBER("black_share", 0.07),
    NUMBER("white_share", 0.16),
    NUMBER("speck_size", 4.2),
    SRGB("black_colour", 74, 70, 66),
    SRGB("white_colour", 234, 230, 222),
    NUMBER("third_share", 0.0),
};
STONE(terrazzo, "Terrazzo (Venetian, marble chips in white cement)",
      "Crushed marble chips, white, ochre and grey-green, of all sizes to 14 mm, ground flush in a "
      "pale binder.",
      EN13748);

const sozai_preset *const stone_catalogue[] = {
    &stone_inada,      &stone_makabe,       &stone_aji,       &stone_shirakawa,
    &stone_mannari,    &stone_baltic_brown, &stone_gabbro,    &stone_basalt,
    &stone_komatsu,    &stone_oya,          &stone_carrara,   &stone_nero_marquina,
    &stone_travertino, &stone_jura,         &stone_bluestone, &stone_slate,
    &stone_sandstone,  &stone_terrazzo,
};
const uint32_t stone_catalogue_count = COUNT(stone_catalogue);
