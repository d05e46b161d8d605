/* SPDX-License-Identifier: Apache-2.0
 * Broadleaved trees of the Americas. */
#include "entry.h"

static const sozai_value values_white_oak[] = {
    RINGS(2.2, 0.28, 0.9),
    LATEWOOD(0.5, 0.35),
    NUMBER("slope_noise", 0.04),
    NUMBER("slope_noise_length", 45.0),
    RING_POROUS(30.0, 42.0, 0.25),
    EARLYWOOD_ROWS(2, 2.6, 240.0, 0.17, 0.6),
    NUMBER("fibre_brightness", 0.11),
    SRGB("earlywood_colour", 204, 172, 130),
    SRGB("latewood_colour", 178, 144, 102),
    SRGB("vessel_colour", 168, 136, 98),
    SRGB("sapwood_earlywood_colour", 220, 200, 164),
    SRGB("sapwood_latewood_colour", 200, 174, 136),
    NUMBER("heartwood_years", 120.0),
    NUMBER("specular", 0.06),
    RAYS(0.011, 26.0, 320.0, 40.0),
    SRGB("ray_colour", 211, 180, 139),
};
SPECIES(white_oak, "White oak (Quercus alba)",
        "Light greyish brown; latewood's vessels small and many, rays tall and bright.",
        HANDBOOK "; " PANSHIN);

static const sozai_value values_red_oak[] = {
    RINGS(2.8, 0.28, 1.0),
    LATEWOOD(0.5, 0.35),
    NUMBER("slope_noise", 0.04),
    NUMBER("slope_noise_length", 45.0),
    RING_POROUS(8.0, 80.0, 0.22),
    EARLYWOOD_ROWS(3, 2.5, 270.0, 0.17, 0.6),
    NUMBER("fibre_brightness", 0.11),
    SRGB("earlywood_colour", 208, 168, 130),
    SRGB("latewood_colour", 180, 138, 102),
    SRGB("vessel_colour", 190, 151, 115),
    SRGB("sapwood_earlywood_colour", 222, 198, 164),
    SRGB("sapwood_latewood_colour", 200, 172, 136),
    NUMBER("heartwood_years", 140.0),
    NUMBER("specular", 0.06),
    RAYS(0.022, 12.0, 280.0, 36.0),
    SRGB("ray_colour", 214, 174, 136),
};
SPECIES(red_oak, "Northern red oak (Quercus rubra)",
        "Pinkish brown and coarse; open early vessels, shorter rays than white oak's.",
        HANDBOOK "; " PANSHIN);

static const sozai_value values_hickory[] = {
    RINGS(2.0, 0.3, 0.9),
    LATEWOOD(0.5, 0.35),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    RING_POROUS(4.0, 100.0, 0.25),
    EARLYWOOD_ROWS(1, 2.4, 240.0, 0.18, 0.7),
    NUMBER("fibre_brightness", 0.1),
    SRGB("earlywood_colour", 200, 160, 122),
    SRGB("latewood_colour", 172, 130, 94),
    SRGB("vessel_colour", 164, 126, 92),
    SRGB("sapwood_earlywood_colour", 230, 208, 174),
    SRGB("sapwood_latewood_colour", 208, 180, 144),
    NUMBER("heartwood_years", 90.0),
    NUMBER("specular", 0.07),
    RAYS(4.0, 0.35, 30.0, 28.0),
    SRGB("ray_colour", 204, 164, 126),
};
SPECIES(
    hickory, "Shagbark hickory (Carya ovata)",
    "Pale to reddish brown; a single broken row of large vessels, fine pale lines in the latewood.",
    HANDBOOK "; " PANSHIN);

static const sozai_value values_black_walnut[] = {
    RINGS(3.0, 0.28, 1.1),
    LATEWOOD(0.28, 0.2),
    NUMBER("slope_noise", 0.045),
    NUMBER("slope_noise_length", 45.0),
    SEMI_RING_POROUS(6.0, 170.0, 95.0, 0.2),
    NUMBER("fibre_brightness", 0.16),
    SRGB("earlywood_colour", 124, 92, 70),
    SRGB("latewood_colour", 88, 62, 46),
    SRGB("vessel_colour", 90, 66, 50),
    SRGB("sapwood_earlywood_colour", 200, 178, 146),
    SRGB("sapwood_latewood_colour", 176, 152, 120),
    NUMBER("heartwood_years", 120.0),
    NUMBER("specular", 0.07),
    RAYS(4.0, 0.4, 35.0, 28.0),
    SRGB("ray_colour", 128, 96, 73),
};
SPECIES(
    black_walnut, "Black walnut (Juglans nigra)",
    "Chocolate brown with a purple cast; dark fine lines from vessels that shrink across the ring.",
    HANDBOOK "; " PANSHIN);

static const sozai_value values_cherry[] = {
    RINGS(2.4, 0.26, 0.9),
    LATEWOOD(0.12, 0.4),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(110.0, 48.0, 0.2),
    NUMBER("fibre_brightness", 0.1),
    SRGB("earlywood_colour", 196, 136, 94),
    SRGB("latewood_colour", 164, 104, 68),
    SRGB("vessel_colour", 180, 122, 83),
    SRGB("sapwood_earlywood_colour", 226, 196, 156),
    SRGB("sapwood_latewood_colour", 202, 166, 126),
    NUMBER("heartwood_years", 80.0),
    NUMBER("specular", 0.09),
    RAYS(3.0, 0.5, 50.0, 28.0),
    SRGB("ray_colour", 208, 152, 111),
};
SPECIES(cherry, "Black cherry (Prunus serotina)",
        "Reddish brown and satin-smooth, deepening with light; fine bright rays.",
        HANDBOOK "; " PANSHIN);

static const sozai_value values_hard_maple[] = {
    RINGS(1.9, 0.22, 0.7),
    LATEWOOD(0.06, 0.7),
    NUMBER("slope_noise", 0.025),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(38.0, 68.0, 0.2),
    NUMBER("fibre_brightness", 0.06),
    SRGB("earlywood_colour", 230, 202, 164),
    SRGB("latewood_colour", 198, 160, 120),
    SRGB("vessel_colour", 214, 184, 145),
    SRGB("sapwood_earlywood_colour", 236, 212, 178),
    SRGB("sapwood_latewood_colour", 210, 178, 138),
    NUMBER("heartwood_years", 110.0),
    NUMBER("specular", 0.16),
    RAYS(2.2, 0.6, 75.0, 28.0),
    SRGB("ray_colour", 219, 187, 148),
};
SPECIES(hard_maple, "Hard maple, sugar maple (Acer saccharum)",
        "Creamy white with a reddish cast, hard and even; thin brown line at each ring.",
        HANDBOOK "; " PANSHIN);

static const sozai_value values_yellow_birch[] = {
    RINGS(1.6, 0.24, 0.8),
    LATEWOOD(0.1, 0.5),
    NUMBER("slope_noise", 0.03),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(28.0, 100.0, 0.2),
    NUMBER("fibre_brightness", 0.08),
    SRGB("earlywood_colour", 206, 164, 124),
    SRGB("latewood_colour", 178, 132, 94),
    SRGB("vessel_colour", 188, 146, 108),
    SRGB("sapwood_earlywood_colour", 232, 208, 172),
    SRGB("sapwood_latewood_colour", 210, 180, 142),
    NUMBER("heartwood_years", 90.0),
    NUMBER("specular", 0.1),
    RAYS(4.0, 0.4, 40.0, 25.0),
    SRGB("ray_colour", 197, 154, 115),
};
SPECIES(yellow_birch, "Yellow birch (Betula alleghaniensis)",
        "Light reddish brown heart, pale sapwood; even, with short fine vessel lines.",
        HANDBOOK "; " PANSHIN);

static const sozai_value values_tulipwood[] = {
    RINGS(3.2, 0.26, 0.9),
    LATEWOOD(0.06, 0.5),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(80.0, 62.0, 0.2),
    NUMBER("fibre_brightness", 0.1),
    SRGB("earlywood_colour", 182, 166, 116),
    SRGB("latewood_colour", 158, 142, 96),
    SRGB("vessel_colour", 171, 154, 106),
    SRGB("sapwood_earlywood_colour", 232, 218, 184),
    SRGB("sapwood_latewood_colour", 212, 194, 156),
    NUMBER("heartwood_years", 70.0),
    NUMBER("specular", 0.06),
    RAYS(3.0, 0.55, 45.0, 28.0),
    SRGB("ray_colour", 189, 173, 124),
};
SPECIES(tulipwood, "Tulip tree, yellow poplar (Liriodendron tulipifera)",
        "Greenish to olive brown heart in creamy sapwood; even, a pale line at each ring.",
        HANDBOOK "; " PANSHIN);

static const sozai_value values_basswood[] = {
    RINGS(2.2, 0.25, 0.8),
    LATEWOOD(0.06, 0.35),
    NUMBER("slope_noise", 0.02),
    NUMBER("slope_noise_length", 60.0),
    DIFFUSE_POROUS(80.0, 56.0, 0.2),
    NUMBER("fibre_brightness", 0.05),
    SRGB("earlywood_colour", 228, 206, 170),
    SRGB("latewood_colour", 208, 180, 142),
    SRGB("vessel_colour", 219, 195, 158),
    SRGB("sapwood_earlywood_colour", 234, 216, 184),
    SRGB("sapwood_latewood_colour", 216, 192, 156),
    NUMBER("heartwood_years", 60.0),
    NUMBER("specular", 0.06),
    RAYS(2.4, 0.7, 42.0, 26.0),
    SRGB("ray_colour", 220, 195, 158),
};
SPECIES(basswood, "American basswood (Tilia americana)",
        "Creamy white to pale brown, plain and soft.", HANDBOOK "; " PANSHIN);

static const sozai_value values_mahogany[] = {
    RINGS(3.6, 0.3, 1.1),
    LATEWOOD(0.22, 0.2),
    INTERLOCKED(0.07, 14.0, 900.0),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(9.0, 150.0, 0.2),
    NUMBER("fibre_brightness", 0.13),
    SRGB("earlywood_colour", 166, 104, 70),
    SRGB("latewood_colour", 138, 80, 52),
    SRGB("vessel_colour", 130, 80, 54),
    SRGB("sapwood_earlywood_colour", 214, 184, 150),
    SRGB("sapwood_latewood_colour", 194, 160, 126),
    NUMBER("heartwood_years", 140.0),
    NUMBER("specular", 0.14),
    RAYS(3.4, 0.45, 60.0, 30.0),
    SRGB("ray_colour", 158, 97, 65),
};
SPECIES(mahogany, "Big-leaf mahogany (Swietenia macrophylla)",
        "Reddish brown, golden in the light; a pale line at each ring, grain slightly interlocked.",
        RICHTER "; " HANDBOOK);

static const sozai_value values_balsa[] = {
    RINGS(12.0, 0.25, 1.5),
    LATEWOOD(0.2, 0.2),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(1.8, 230.0, 0.2),
    NUMBER("fibre_brightness", 0.07),
    SRGB("earlywood_colour", 232, 216, 190),
    SRGB("latewood_colour", 216, 196, 168),
    SRGB("vessel_colour", 210, 189, 159),
    SRGB("sapwood_earlywood_colour", 238, 224, 200),
    SRGB("sapwood_latewood_colour", 222, 204, 178),
    NUMBER("heartwood_years", 10.0),
    NUMBER("specular", 0.1),
    RAYS(0.9, 1.3, 90.0, 30.0),
    SRGB("ray_colour", 221, 200, 171),
};
SPECIES(balsa, "Balsa (Ochroma pyramidale)",
        "White to pale oatmeal, feather-light; few large vessels in soft silky tissue.",
        RICHTER "; " INSIDEWOOD);

static const sozai_value values_rosewood[] = {
    RINGS(3.4, 0.38, 2.0),
    NUMBER("undulation_size", 45.0),
    LATEWOOD(0.25, 0.45),
    NUMBER("latewood_variation", 0.6),
    NUMBER("slope_noise", 0.05),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(3.5, 190.0, 0.25),
    NUMBER("fibre_brightness", 0.2),
    SRGB("earlywood_colour", 118, 74, 52),
    SRGB("latewood_colour", 48, 30, 26),
    SRGB("vessel_colour", 62, 40, 32),
    SRGB("sapwood_earlywood_colour", 220, 200, 160),
    SRGB("sapwood_latewood_colour", 202, 178, 136),
    NUMBER("heartwood_years", 160.0),
    NUMBER("specular", 0.1),
    RAYS(8.0, 0.15, 18.0, 20.0),
    SRGB("ray_colour", 122, 78, 55),
};
SPECIES(rosewood, "Brazilian rosewood (Dalbergia nigra)",
        "Chocolate to purplish brown, drawn with black streaks that wander like landscapes.",
        RICHTER "; " WAGENFUEHR);

static const sozai_value values_cocobolo[] = {
    RINGS(3.0, 0.36, 1.8),
    NUMBER("undulation_size", 45.0),
    LATEWOOD(0.22, 0.45),
    NUMBER("latewood_variation", 0.6),
    NUMBER("slope_noise", 0.05),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(4.0, 150.0, 0.25),
    NUMBER("fibre_brightness", 0.16),
    SRGB("earlywood_colour", 158, 88, 54),
    SRGB("latewood_colour", 62, 34, 26),
    SRGB("vessel_colour", 86, 56, 44),
    SRGB("sapwood_earlywood_colour", 226, 206, 160),
    SRGB("sapwood_latewood_colour", 206, 180, 132),
    NUMBER("heartwood_years", 140.0),
    NUMBER("specular", 0.12),
    RAYS(8.0, 0.15, 18.0, 20.0),
    SRGB("ray_colour", 164, 94, 59),
};
SPECIES(cocobolo, "Cocobolo (Dalbergia retusa)",
        "Orange-red with black lines; dense, oily and bright.", RICHTER "; " WAGENFUEHR);

static const sozai_value values_purpleheart[] = {
    RINGS(3.0, 0.28, 0.9),
    LATEWOOD(0.25, 0.25),
    INTERLOCKED(0.04, 14.0, 1000.0),
    NUMBER("slope_noise", 0.035),
    NUMBER("slope_noise_length", 45.0),
    DIFFUSE_POROUS(5.0, 120.0, 0.2),
    NUMBER("fibre_brightness", 0.1),
    SRGB("earlywood_colour", 116, 74, 86),
    SRGB("latewood_colour", 92, 56, 66),
    SRGB("vessel_colour", 86, 58, 62),
    SRGB("sapwood_earlywood_colour", 216, 196, 176),
    SRGB("sapwood_latewood_colour", 196, 172, 152),
    NUMBER("heartwood_years", 150.0),
    NUMBER("specular", 0.1),
    RAYS(4.0, 0.4, 40.0, 28.0),
    SRGB("ray_colour", 122, 79, 90),
};
SPECIES(purpleheart, "Purpleheart (Peltogyne paniculata)",
        "Vivid purple-brown, straight and even, its vessels filled.", RICHTER "; " WAGENFUEHR);
