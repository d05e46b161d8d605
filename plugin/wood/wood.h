/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood, after Kawai's model of fibre orientation, vessels, shifted brightness
 * and figure. What a created wood is: numbers and tables that never change.
 *
 * The way from a point to its wood
 *   object space -> log space          cut (a turn and a shift)
 *   log space -> about the pith        pith(y)
 *   -> (rho, theta)                    rho = r s(y) / (1 + w(theta)) - u(x, y, z)
 *   rho about knots         the front of stem and branch together
 *   rho -> (year, phase of the ring)   a table of ring boundaries
 *   theta' = theta - phi(t, y)         the grain transform
 *   -> reference section               rho (1 + w(theta')) at theta', y = 0
 * Everything grown lives in the reference section and is looked up there.
 */
#ifndef SOZAI_WOOD_H
#define SOZAI_WOOD_H

#include <stdint.h>

#include "../../api/sozai_colour.h"
#include "../core/kernel.h"
#include "../layout/layout.h"
#include "knot_table.h"
#include "plies/plies.h"
#include "surface/surface.h"

#define WOOD_EYE_LONG 1.25f  /* a bird's eye along the stem, to a width of 1 */
#define WOOD_EYE_RIM 0.28f   /* the square of what is stained to its dimple's, across */
#define WOOD_EYE_PIN 0.6f    /* how dark its middle is, to its outline; */
#define WOOD_EYE_DARK 0.76f  /* of the darkest there might be, on both sides alike, in the mean, */
#define WOOD_EYE_DARKS 0.22f /* and how far from that */
#define WOOD_EYE_MEAN (4.0f / 15.0f + WOOD_EYE_PIN / 20.0f) /* and both in the mean over it */
#define WOOD_RINGS 256                                      /* rings before the table repeats */
#define WOOD_BINS_MAX 16384 /* bins of the look-up from rho to ring */
#define WOOD_HARMONICS 3    /* of the section's outline */
#define WOOD_RADII 8        /* steps of the table of vessel radii */
#define WOOD_FIBRE_OCTAVES 3
#define WOOD_BUNDLE 7.0       /* how many fibres wide the second octave is */
#define WOOD_CONE_PSI 65      /* steps of the sine of inclination, -1 to 1 */
#define WOOD_CONE_DIVE 17     /* steps of the sine of the dive angle, 0 to 1 */
#define WOOD_CONE_LEAST 0.05f /* of cos^2(psi_d / 2): where cones close, the lobe stays finite */
#define WOOD_STREAK 0.62f     /* how much of its colour a streak's depth gives */
#define PIGMENT_SAMPLES 1536  /* of the bands over the table of rings */
#define PIGMENT_LATE 0.75f    /* of its colour in latewood */
#define PIGMENT_FADE 0.6f     /* how much weaker bands may be in one place than in another */
#define CURL_STRAY_REACH 1.6f /* of the reach, that the phase strays over */
#define CANAL_CORE 0.4f       /* share of a resin canal that is its lumen */
/* Octaves of spalting's noise, of scales and weights; the variance of one of weight 1. */
enum { SPALT_OCTAVES = 4 };
static const float spalt_scale[SPALT_OCTAVES] = {1.0f, 2.3f, 5.3f, 12.2f};
static const float spalt_weight[SPALT_OCTAVES] = {1.0f, 0.4f, 0.13f, 0.045f};
#define SPALT_VARIANCE 0.0365f
#define SPALT_SLOPE 0.255f     /* that of its slope along an axis of its lattice, measured */
#define SPALT_DEVIATION 0.191f /* its root */
#define SPALT_SWELL 0.75f   /* of a line's width, for one deviation of the other fungus's noise */
#define SPALT_STAIN 0.13f   /* colonies: how far from a line the wood outside is stained */
#define SPALT_SECOND 1.3f   /* the second fungus's colonies are that much smaller */
#define SPALT_PALE 0.5f     /* and bleach so much, where the first bleaches by 1 */
#define CANAL_LOW 0.42f     /* phase of a ring from which on resin canals stand */
#define CANAL_MARGIN 1.6f   /* radii from a resin canal's middle to its ring's ends */
#define FINE_RAY_TALL 0.22f /* mm: the mean height of a fine ray, of some ten cells */
#define CELL_BEND_BY 1.6f   /* files by which files bend, at an irregularity of 1 */
#define WOOD_RIM 256        /* directions in which the rim of a picture is known */

/* The seeds of the noises, kept apart. */
enum {
  SEED_PITH_X,
  SEED_PITH_Z,
  SEED_UNDULATION,
  SEED_SLOPE = SEED_UNDULATION + 2,
  SEED_WAVE = SEED_SLOPE + 2,
  SEED_PORES,
  SEED_ROWS,
  SEED_RAYS,
  SEED_FIBRE,
  SEED_BOARDS = SEED_FIBRE + WOOD_FIBRE_OCTAVES,
  SEED_CURL,
  SEED_QUILT,
  SEED_EYES,
  SEED_MARKS = SEED_EYES + 2,
  SEED_WEAR,
  SEED_CHECKS = SEED_WEAR + SURFACE_OCTAVES,
  SEED_CRACKS,
  SEED_STREAKS,
  SEED_CANALS,
  SEED_CELLS,
  SEED_TYLOSES,
  SEED_RIMS,
  SEED_SPALT,
  SEED_KNOTS = SEED_SPALT + 2,
  SEED_PLIES,
  SEED_CURL_SWELL,
  SEED_WAVE_SWELL,
  SEED_RIBBON,
  SEED_PIGMENT,
  SEED_SPALT_MORE,
  SEED_CELL_BEND = SEED_SPALT_MORE + 4,
  SEED_SPLITS,
  SEED_BOLTS,
  SEED_DRIFT,
  SEED_BANDS,
  WOOD_SEEDS
};

#define WOOD_ROWS_ALONE 0.45f /* of a ring: past that a footprint meets the rows of others */

/* A layer of vessels of normally distributed radius. inverse_square[i] is
 * (mean radius / radius)^2 for the i-th of WOOD_RADII equally likely radii. */
typedef struct {
  float radius;   /* mm, the mean */
  float reach;    /* mm: the longest footprint that one look-up answers to its last tail */
  float part;     /* mm: the longest that is not cut into parts */
  float third;    /* mm: how long three parts may be */
  float farthest; /* q, in units of the mean radius, at which the largest vessel ends */
  float coverage; /* expected area fraction where the layer is at full size */
  float overlap;  /* share of the discs' areas that lies under another disc */
  float inverse_square[WOOD_RADII];
} wood_vessels;

/* How the field's pores are arranged in their rings; see vessels_bands.h. within[i] is how far from
 * the middle of a band the i-th of as many equally likely cells may be and still hold pores. */
typedef struct {
  int32_t on, along_arc; /* whether there are bands; whether they follow one another round the stem,
                            not along its radius */
  float often;           /* 1/mm: bands to a mm of radius; to a mm of the ring's radius, round it */
  float slant;           /* 1/mm: how far they go round with the radius */
  float fork, fork_most; /* of the spacing: how far they have parted at the ring's end; the half */
  float margin;          /* mm: from a ring's ends, where bands that go round leave no pores */
  float stray, stray_size; /* of the spacing, over the noise's bound; mm */
  float share;             /* of the cells, that hold pores */
  float swing;             /* of the density's first harmonic, over its mean */
  float within[WOOD_RADII];
} wood_bands;

/* Axial parenchyma: pale tissue of short, thin-walled cells. See parenchyma.h and
 * vessels_sheaths.h. */
typedef struct {
  int32_t on, sheaths; /* any; about vessels */
  float colour[3], sap[3];
  float margin; /* mm: of the line at a ring's end, of a wide ring; 0: none */
  float margin_before[WOOD_RINGS + 1]; /* mm: of all rings before, as far as they have room */
  float margin_period;
  float bands_often, bands_share;    /* 1/mm of radius; of the wood. 0: none */
  float bands_stray, bands_uneven;   /* turns, and of the share, over the bundles' noise */
  float bands_lost;                  /* twelve times the variance of that, turns^2 */
  float between_lost;                /* of what bands of vessels stray, likewise */
  float part;                        /* mm: a footprint that swallows little of either */
  float between_denser;              /* how many more vessels stand in a band than in the mean */
  float between, between_half;       /* share of a band of vessels; half of its width, in turns */
  float sheath_arc2, sheath_radial2; /* mm^2: semi-axes of a vessel with its sheath, squared */
  float sheath_cover;                /* expected, at full size */
  float sheath_area;                 /* sum of their areas over that of the section */
  float sheath_met;                  /* of n times the section n / (1 + met n) is covered */
  float sheath_late;                 /* of latewood, over what they are expected to cover */
  float sheath_grown; /* the mean over a ring of what that covers, over that of its mean */
} wood_parenchyma;

/* How far waves along the stem are from a sine: they are of the phase
 * y / length + stray n, n an axial noise, and of the complex amplitude steady +
 * swell (a + i b), a and b value noises. Where that is zero a wave forks or ends. */
typedef struct {
  float steady, swell;
  float power;                            /* expected square of the amplitude */
  float stray;                            /* turns */
  float stray_frequency, swell_frequency; /* 1/mm, along the stem */
} wood_irregular;

/* How the ends of boards are turned. */
enum { FLIP_RANDOM, FLIP_ALTERNATE, FLIP_NONE };

/* A layout of boards; see boards.h. */
typedef struct {
  layout layout; /* kind LAYOUT_NONE: the object is one piece */
  layout_profile profile;
  float flat, rift; /* shares of the cuts; the rest is quarter-sawn */
  float distance;   /* mm from the pith: half of it to two and a half times it */
  float lean, skew; /* of the length out of the stem's direction: 6^0.5 times the sd of its sine */
  float tone;       /* sd of a board's shade, relative */
  float joint_colour[3];
  int32_t flip, end;
} wood_boards;

/* What one point alone takes in four lanes; see alone.h. Of two octaves, or of the pith's two
 * coordinates, as the noises of two have them. */
typedef struct {
  float pith[4]; /* amplitude, of both; of their slopes */
  uint32_t pith_seed[4];
  float section[4], axis[4];             /* 1/mm: of the undulation, each octave twice */
  float height[4], slope_y[4], slope[4]; /* mm, both octaves twice; factors of slopes */
  uint32_t undulation_seed[4];
  float often[4];            /* 1/mm: of the slope's noise, each octave twice */
  float far[4], by_years[4]; /* mm, both octaves; of their slopes; mm per year */
  uint32_t slope_seed[4];
  /* the fibres' octaves, and an idle one */
  float blur[4], blur2[4], frequency[4], scale[4], front[4], variance[4];
  uint32_t fibre_seed[4];
} wood_fours;

typedef struct {
  /* object -> log: rows, then the shift. The rows are a rotation's. */
  float turn[3][3];
  float shift[3];
  int32_t turned;               /* 0: the rows are the axes, and there is nothing to turn */
  int32_t peeled;               /* veneer: each point has a turn of its own; see boards.h */
  float peel_radius, peel_lead; /* mm, where the sheet begins; thickness over pi */
  float peel_turn;              /* radians, of its beginning */

  /* the stem */
  float pith_amplitude, pith_frequency; /* mm, 1/mm */
  float taper;                          /* 1/mm: s(y) = 1 + taper y, |taper y| <= 0.9 */
  float outline_cos[WOOD_HARMONICS], outline_sin[WOOD_HARMONICS];
  float undulation[2];                                                 /* mm, per octave */
  float undulation_frequency_section[2], undulation_frequency_axis[2]; /* 1/mm */
  float undulation_size[2];                                            /* mm */
  float undulation_core; /* 1/mm: within its inverse of the pith the undulation dies out */

  /* figure of the growth front */
  int32_t has_curl, has_quilt, has_eyes;
  float curl_height, curl_slope, curl_frequency; /* mm; greatest slope; 1/mm */
  wood_irregular curl;
  float curl_inverse_reach;                                /* 1/mm */
  float quilt_height, quilt_slope;                         /* mm over the noise; rms slope */
  float quilt_frequency, quilt_frequency_axis, quilt_size; /* 1/mm; mm */
  float eye_radius, eye_depth, eye_mean; /* mm; of the radius; of the face, how dark in the mean */
  float eye_cell, inverse_eye_cell, eye_length, inverse_eye_length; /* mm, 1/mm */

  /* rings */
  float ring_period, inverse_ring_period; /* mm: the table's whole radius */
  float bin_scale;                        /* bins per mm */
  int32_t bin_last;
  float ring_width;                     /* mm, the mean */
  float late_start, late_middle;        /* phase: the rise begins; it is half way */
  float inverse_late_before;            /* 1 / (middle - start) */
  float late_after, inverse_late_after; /* from the middle to the whole, and its inverse */
  float late_sixth;                     /* (middle - start) / 6 */
  float late_deepening;                 /* what is missing where latewood begins, */
  float inverse_late_full;              /* and gone 1 / this further on, at the ring's end */
  float late_period;                    /* integral over the table */
  float blur;                           /* mm: no ring edge is sharper */
  float safe; /* mm: footprints this small never span a ring's rise and an edge */

  /* grain; slopes are r dtheta/dy */
  float spiral;
  float wave_slope, wave_displacement; /* A, A lambda / 2 pi */
  float wave_number, wave_frequency;   /* 2 pi / lambda, 1 / lambda */
  wood_irregular wave;
  float wave_inverse_reach;                       /* 1/years */
  float interlocked_slope, interlocked_frequency; /* 1/years */
  float interlocked_length;                       /* mm */
  float interlocked_irregularity;                 /* 0..1 */
  float slope_noise[2], slope_noise_frequency[2]; /* mm of displacement; 1/mm */
  float slope_noise_size[2];                      /* mm */
  float slope_noise_years;                        /* 1/years */
  int32_t has_wave, has_wave_irregularity, has_interlocked, has_slope_noise;
  float bolt, inverse_bolt; /* mm: of the stem, what vessels run through; 0: all of it. bolt.h */
  float bolt_uneven;        /* of a bolt: how far its end strays to either side */

  /* vessels */
  float pore_cell, inverse_pore_cell, pore_step; /* mm: side of a lattice cell; 1/mm; mm, / 2^32 */
  wood_vessels pores;                            /* of the field: cells of the reference section */
  float pore_early, pore_growth; /* size at phase f, over the mean: early + growth f */
  float pore_ring_mean;          /* mean over the ring of size^2 */
  wood_vessels row;              /* of the earlywood: rows at the ring's start */
  wood_bands bands;              /* that those stand in */
  uint32_t pores_each;           /* top bit: two to each cell of the section, not to every other */
  wood_parenchyma parenchyma;
  int32_t has_pores, rows, has_strays; /* the last: of bands */
  float rows_alone;  /* mm: a footprint along rho that meets the rows of one ring alone */
  float row_density; /* 1/mm of arc */
  float row_spacing; /* mm, radially */
  float row_start;   /* mm, of the first row's centres after the ring's start */
  float row_jitter_arc, row_jitter_radial; /* of the spacing; mm */
  float row_step_arc, row_step_radial;     /* the same, / 2^32 */
  float row_largest;                       /* mm: how far the largest vessel's share reaches */
  float row_inverse[WOOD_RADII];           /* mean radius / radius */
  float row_square[WOOD_RADII];            /* (radius / mean radius)^2 */
  float band;                              /* mm: of all rows, where a ring has room for them */
  float late_vessel;                       /* expected coverage of latewood by pores */
  float late_row; /* and by the rows, over that of all wood: 1 where rings are narrow */

  /* resin canals */
  int32_t has_canals;
  float canal_density; /* 1/mm^2 */
  int32_t canal_rows;  /* that those of a ring are looked up in */
  wood_vessels canal;
  float canal_late;                      /* share of latewood where they stand */
  float canal_colour[3], canal_lumen[3]; /* of the cells that line it, and within */

  /* cells */
  int32_t has_cells;
  float inverse_cell_width, inverse_cell_early, inverse_cell_late, inverse_cell_length; /* 1/mm */
  float wall_early, wall_late;           /* shares of the tissue */
  float cell_side, cell_end;             /* contrast: along the fibre, and on end grain */
  float cell_white, cell_open;           /* room above a colour: white / colour - open */
  float cell_gone;                       /* mm: the footprint from which on nothing is left */
  float cell_bend;                       /* files by which files bend */
  float inverse_fine_pitch, fine_tall;   /* 1/mm; fine rays' mean height, of their pitch */
  float fine_open;                       /* of a fine ray's cell, each way, that is lumen */
  float tyloses;                         /* contrast */
  float inverse_tylose, inverse_element; /* 1/mm */
  float rim_squares;                     /* 1/mm: to a vessel, about one */

  /* spalting */
  int32_t has_spalt;
  float spalt_frequency, spalt_width;                         /* 1/mm; mm */
  float spalt_level, spalt_other;                             /* of the noise, where lines are */
  float spalt_line_mean, spalt_bleach_mean, spalt_stain_mean; /* expected */
  float spalt_pale[3];                                        /* what bleached wood is nearer to */

  /* rays */
  int32_t has_rays;
  int32_t ray_layers;                      /* 2: as many as these say once more, between them */
  float ray_length, inverse_ray_length;    /* mm: of a shell */
  float ray_sectors, ray_sector_turn;      /* round the pith; radians of one */
  float ray_per_radius;                    /* cells to a sector, to a mm of its shell's radius */
  float inverse_ray_arc, inverse_ray_cell; /* 1/mm: of a cell, along the arc and along y */
  float ray_tall;                          /* half the mean height, in cells */
  float ray_half;                          /* mm: half the mean width */
  float ray_blunt;                         /* 0: a lens; 1: of even width but for the tips */
  int32_t ray_sides;                       /* cells to either side that are looked at */
  float ray_room;     /* of its cell's arc, that a ray's middle keeps from the edge */
  float ray_thickest; /* mm: half the width of the widest, */
  float ray_softer;   /* and times this with edges that a footprint averages, at most */
  float ray_cover;    /* expected */
  float ray_stray;    /* mm of a sheet's waves, over HASH_ONE */
  float ray_wave_radial, ray_wave_along; /* 1/mm */
  float ray_ripple;                      /* mm of broad rays' second waves, likewise, or 0 */
  float ray_ripple_radial, ray_ripple_along;
  float ray_sharp2; /* mm2: no edge is sharper */
  float ray_uneven; /* of the thickness, within which it varies */
  float ray_ragged; /* the same, from row to row of its cells */

  /* shifted brightness */
  float fibre_scale[WOOD_FIBRE_OCTAVES];     /* amplitude, over the noise's bound */
  float fibre_frequency[WOOD_FIBRE_OCTAVES]; /* 1/mm */
  float fibre_front[WOOD_FIBRE_OCTAVES];     /* mm: of latewood, over the noise's bound */
  float fibre_variance[WOOD_FIBRE_OCTAVES];  /* mm^2: of that */
  float drift, drift_length, drift_frequency, drift_frequency_radial; /* over HASH_ONE; mm; 1/mm */
  int has_front;
  float fibre_blur[WOOD_FIBRE_OCTAVES]; /* 1/mm^2: over squared extents, how it fades */

  /* knots */
  wood_knots *knots; /* NULL: none */
  float knot_early[3], knot_late[3], knot_bark[3];
  float knot_stain; /* how much of its colour a knot has */

  /* colour, working space */
  float early[3], late[3], vessel[3], vessel_sap[3], ray[3], ray_sap[3];

  float sap_early[3], sap_late[3];
  wood_tubes streaks; /* of minerals */
  float streak[3];    /* their colour */
  int32_t has_pigment;
  float pigment[3];                      /* colour of its bands in earlywood */
  float pigment_stray, pigment_period;   /* mm; integral over the table */
  float pigment_per_mm;                  /* samples */
  float pigment_frequency, pigment_near; /* 1/mm; mm^2: the footprint that bands are whole under */
  float heart_years, heart_edge;         /* years: where the heartwood ends, and how gradually */
  float shade, ray_shade;                /* light lost in open ends of cells, and of rays */
  int32_t has_ends;
  float heart_stray; /* years: most that the boundary departs from the ring */
  float heart_cos[3], heart_sin[3];

  /* a section from a picture */
  const sozai_images_1 *images;
  const sozai_image *picture;                     /* NULL: the section is grown */
  float picture_pith[2];                          /* s, t */
  float picture_per_mm[2];                        /* s and t to a mm */
  float picture_detail, picture_detail_size;      /* a factor; mm */
  float picture_bright, picture_inverse_contrast; /* grey of the brightest wood */
  int32_t folded;
  float rim[WOOD_RIM + 1]; /* mm, in units of rho */

  /* figure */
  float diffuse, specular, shininess;
  float roughness; /* of the lobe where nothing widens it */
  float tint_colour[3];

  /* the fibres' cone */
  int32_t cone;                       /* radiance by it, not by equation (4) */
  float ior, inverse_ior, cone_width; /* cone_width in radians */
  float coat, coat_alpha;
  float fibre_colour[3], fibre_brightest;
  float cone_table[WOOD_CONE_DIVE * WOOD_CONE_PSI]; /* reflectance; rows by the dive's sine */
  float cone_mean[WOOD_CONE_DIVE];                  /* of it over all directions */
  float cone_scale[WOOD_CONE_DIVE];                 /* of the lobe */
  float cone_ray[WOOD_CONE_DIVE];                   /* of the rays', over that */
  float ray_lustre, inverse_ray_lustre;             /* of which it is the most; 0 for none */

  wood_boards boards;
  wood_plies plies;
  wood_surface surface;

  uint32_t seed;
  uint32_t seeds[WOOD_SEEDS]; /* one for each noise */

  /* tables: ring j = 0 .. WOOD_RINGS - 1; the last entry closes the period */
  float start[WOOD_RINGS + 1]; /* mm: rho of the ring's start */
  float inverse_width[WOOD_RINGS];
  float late_weight[WOOD_RINGS + 1]; /* how dark the latewood of ring j - 1 grows */
  float row_before[WOOD_RINGS + 1];  /* mm: bands of the rows up to the ring; over the table */
  float row_period;
  float late_before[WOOD_RINGS + 1]; /* integral of the profile up to the ring */
  /* the same again as the kernel loads it: what belongs to a ring in one place */
  float ring_row[WOOD_RINGS]
                [4]; /* start, inverse width, weight of its latewood and of the last's */
  /* of a sample: the integral up to it, and the depth's terms of it; see pigment.h */
  float pigment_row[PIGMENT_SAMPLES][4];
  /* of the bin: the ring that its start lies in, and where the next one begins */
  float bin[WOOD_BINS_MAX][2];

  wood_fours fours;
} wood_constants;

/* Components of the output channels, in their order. */
enum {
  WOOD_ALBEDO = 0,
  WOOD_RADIANCE = 3,
  WOOD_FIBER = 6,
  WOOD_DIVE = 9,
  WOOD_SPECULAR = 10,
  WOOD_ROUGHNESS = 11,
  WOOD_TIME = 12,
  WOOD_LATEWOOD = 13,
  WOOD_VESSEL = 14,
  WOOD_REFERENCE = 15,
  WOOD_CONE_COLOUR = 17,
  WOOD_CONE_WIDTH = 20,
  WOOD_COAT = 21,
  WOOD_RAY = 22,
  WOOD_BOARD_ID = 23,
  WOOD_BOARD_U = 24,
  WOOD_BOARD_V = 25,
  WOOD_BOARD_EDGE = 26,
  WOOD_NORMAL = 27,
  WOOD_HEIGHT = 30,
  WOOD_CANAL = 31,
  WOOD_KNOT = 32,
  WOOD_COAT_ROUGHNESS = 33,
  WOOD_PARENCHYMA = 34,
  WOOD_FIBER_LOBE = 35,
  WOOD_RAY_LOBE = 38,
  WOOD_RAY_LUSTRE = 41,
  WOOD_COMPONENTS = 42
};

typedef void wood_radius(const wood_constants *w, uint32_t count, const float *t,
                         const float *theta, const float *y, float *out_r);
typedef void wood_pith(const wood_constants *w, uint32_t count, const float *y, float *out_x,
                       float *out_z);

/* One compilation of the kernel. */
typedef struct {
  kernel kernel;
  wood_radius *radius;
  wood_pith *pith;
} wood_kernel;

#endif
