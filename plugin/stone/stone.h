/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone: what a created one is, numbers and tables that never change.
 *
 * The way from a point to its stone
 *   object space -> bed space     an exchange of axes: +y is across the beds
 *   grains                        crystals that fill space, of three minerals
 *   bedding, mottle               what varies slowly, over the grains
 *   inclusions, specks            bodies within the ground mass, over it
 *   veins, holes                  what came last, over everything
 * All of it is a field in space: a block goes on through its chamfers and down
 * its sides. Or, with `colour_mode` of the paper's, a cube of one colour to a
 * texel in place of all that.
 */
#ifndef SOZAI_STONE_H
#define SOZAI_STONE_H

#include <stdint.h>

#include "../../api/sozai_colour.h"
#include "../core/kernel.h"
#include "../layout/layout.h"

/* A stage that is large and called from several places: once in the code. */
#define STAGE static __attribute__((noinline, unused))

#define STONE_RELIEF 5 /* octaves of a finish's relief */
#define HOLLOW 1.3f    /* what a relief's hollows keep from the sky, of its slopes' sd */
#define FACET_SIZES 3  /* of facets: facets.h */
#define FACET_SLOPE2 0.94f
#define FACET_HEIGHT2 0.133f
#define CLEFT_FAMILIES 2 /* of sheets: cleft.h */
#define STONE_CODES 256  /* of the paper's 8-bit RGB */

/* Colours of the palette, which albedo is a sum of. */
enum {
  COLOUR_BASE,
  COLOUR_SECOND,
  COLOUR_THIRD,
  COLOUR_BED,
  COLOUR_INCLUSION,
  COLOUR_INCLUSION_SECOND,
  COLOUR_INCLUSION_THIRD,
  COLOUR_BLACK,
  COLOUR_WHITE,
  COLOUR_VEIN,
  COLOUR_HOLE,
  STONE_COLOURS
};

enum { LAYER_GRAINS, LAYER_INCLUSIONS, LAYER_SPECKS, LAYER_HOLES, STONE_LAYERS };
/* What else lies over those. */
enum { OVER_MOSS = STONE_LAYERS, OVER_VEINS };

#define CELLS_JITTER 0.86f /* of the lattice cell; more, and a neighbour's neighbour counts */
#define SORTED_JITTER 0.5f /* the same of sorted bodies: more, and they cut each other */
#define JITTER_OF(share) (0.5f * (share) / 2147483648.0f) /* over hash_signed's reach */

/* Beds that a layer's bodies keep to: two families, of which a part has all that there
 * is in this way. */
typedef struct {
  float across[3][3];         /* mm: cells to bed space */
  float frequency[2];         /* 1/mm */
  float wave, wave_frequency; /* mm; 1/mm */
  float lag;                  /* of the wave, over the height: value.h */
  float few, more, part;      /* how many elsewhere; how many more there, of one family */
  uint32_t seed, seed_wave;
} stone_bedding;

#define SECTIONS_KEEP 2.5f /* of a layer's fade: where its cells are counted the mean comes in, */
#define SECTIONS_GONE 2.8f /* up to here */

/* A layer of cells: a power diagram of jittered points, one to a lattice cell.
 * Lengths are in lattice cells where no unit stands. */
typedef struct {
  float turn[3][3];            /* 1/mm: bed space to cells */
  float grading;               /* spread of the cells' weights */
  float jitter;                /* how far a centre strays, see JITTER_OF */
  float warp, warp_fine;       /* how far the cells' faces stray, at two sizes */
  float bend_turn[3][3];       /* as turn, of the layer whose noises bend these faces, too */
  float bend_scale;            /* such cells to a cell of this layer */
  int32_t bends_shared;        /* there are two such layers */
  float erode, erode_spread;   /* what a body is smaller than its cell; by chance, more */
  float radius, radius_spread; /* of the ball that a body is cut to; a share of it */
  float fines;                 /* how far small ones are more */
  float thick;                 /* of a flake, half, the mean; 1: bodies are none */
  float rim, core;             /* of a body of kind 1, as kind 2 is; what of all is not rim */
  uint32_t joins;              /* of 256: how often two cells along an axis are one crystal */
  float cluster;               /* how much chances change from place to place, 0..1 */
  float chance[2];             /* below the first: kind 1; below the second: kind 2 */
  float mean[2];               /* expected share of kinds 1 and 2 */
  float third, third_mean;     /* the same of a third: of kind 1, what is below the first */
  float variation;             /* of brightness from cell to cell; */
  float mixing;                /* how far one's colour goes towards the other kind's, or from it */
  float calm;                  /* of that and of lamellae kind 2 has this part, of bodies */
  float blur;                  /* mm over size: crystals let light through at their edges */
  float opacity;               /* share of what is below that bodies hide */
  float depth;                 /* share of light that comes through from behind them */
  float cleavage, turbidity;   /* what is seen within a crystal: crystals.h */
  float zoning;                /* and of a body's growth: look_stages.h */
  float swell;                 /* what the widest looks see of bodies in excess, a part of them */
  float size;                  /* mm */
  float fade;                  /* footprint, in cells, of which all but all is looked at */
  float fade_counted;          /* the same of footprints whose cells are counted */
  float counted_from;          /* footprint, in cells, from which they are */
  float looks, spread; /* parts to a cell that a footprint is looked at in; fewer, by cells */
  float least;         /* parts of a point, and what they are rounded by */
  float single;        /* footprint, in cells, up to which one look is all */
  float whole;         /* cells: wider looks are seen in quarters */
  float sheared;       /* cells: a wider look sees how the bends shear it */
  int32_t on, shaped;  /* shaped: eroded, or cut to a ball */
  int32_t sorted;      /* bodies that touch: large ones, and small ones between */
  float fours;         /* fours of looks to a cell, where looks come so (sites.h) */
  int32_t grouped;     /* they do */
  int32_t bedded;      /* bodies keep to certain beds */
  int32_t sparse;      /* bodies are few, and end */
  stone_bedding beds;
  uint32_t seed, seed_warp;
} stone_cells;

#define PAPER_STONES 4
#define PAPER_GRID 17  /* vertices along a stone's side, at most: 2^4 + 1 */
#define PAPER_PARTS 16 /* of a side, at most */

/* The paper's periodic tile: stones in texels, heights in codes of 0 to 256. */
typedef struct {
  int32_t on;
  int32_t across, down;           /* stones to a tile */
  int32_t grid, parts;            /* vertices along a side less one; parts of an edge line */
  float length, width;            /* of a stone's place, texels */
  float tile[2], inverse_tile[2]; /* texels */
  float shift, start;             /* of every other row; of the tile's origin */
  float dh, alpha, joint_height;  /* codes; the factor; code */
  float repair;                   /* texels */
  float mm;                       /* of a code */
  float share;                    /* of the tile that is joint */
  float mean, lost;               /* height, code; variance of slope of the fine roughness */
  float joint_colour[3];          /* working space */
  float height[PAPER_STONES * PAPER_GRID * PAPER_GRID]; /* codes, 0 to 128 */
  float inset[PAPER_STONES * 4 * (PAPER_PARTS + 1)];    /* texels, from the place's side */
} stone_tile;

/* Sheets that end in steps, of one size. */
typedef struct {
  float height, frequency; /* mm, of a family's steps together; 1/mm */
  float slope2;            /* variance of the slope, one axis */
  uint32_t seed;
} stone_cleft;

/* Facets of one size. */
typedef struct {
  float height, frequency; /* mm, either way at most; 1/mm */
  float slope2;            /* variance of the slope, one axis */
  uint32_t seed;
} stone_facets;

/* Sheets' edges, of one size. */
typedef struct {
  float height, across, along; /* mm; 1/mm */
  float slope2;                /* variance of the slope, one axis, of a face square to the sheets */
  uint32_t seed;
} stone_ledges;

#define VEIN_FAMILIES 3

/* Where edges are chipped, least and most of the rounded edge's width. */
#define STONE_ROUND_LEAST 0.2f
#define STONE_ROUND_MOST 2.5f

/* Paving, and what weather does to it: laid.h, moss.h and weather.h. Lengths in mm; m is
 * the distance from the joint's middle. */
typedef struct {
  layout layout; /* kind LAYOUT_NONE: the object is one block */
  layout_wander wander;
  float corner, corner_share;    /* radius; what all corners take of the stones */
  float half;                    /* of the joint */
  float wall;                    /* how far the joint's side leans into the joint */
  float depth;                   /* of the joint below the edge's foot */
  float chamfer, slope;          /* width; tangent of its angle */
  float round, drop;             /* width and fall of the rounded edge */
  float chipping, round_most;    /* how much that width varies; its most, a factor */
  float chip_frequency;          /* 1/mm */
  float tilt, settle, crown;     /* of a stone */
  float tone, tint;              /* sd, relative */
  float colour[3];               /* of the joint */
  float grain_frequency;         /* of what fills the joint, 1/mm */
  float reach;                   /* how far in from the joint wear fades in */
  float mean, slope2, occlusion; /* of the whole plane: height, variance of slope, sky */
} stone_paving;

typedef struct {
  int32_t on; /* anything below but what is usual */
  float wear, grime;
  float undulation, undulation_frequency;
  float moss, moss_spread, moss_height, moss_mean;
  float moss_told; /* mm: of wider footprints no part tells anything but the mean */
  float moss_colour[3];
  float wet, water; /* water: height, -1000 for none */
  uint32_t seed;
} stone_weather;

typedef struct {
  int32_t swap;    /* the axis that changes places with y, or 1 */
  float offset[3]; /* mm, object space */
  stone_cells layer[STONE_LAYERS];

  float bed_frequency, bed_contrast, bed_wave, bed_wave_frequency; /* 1/mm; mm */
  float bed_lag;                               /* of the waves, over the height: value.h */
  float vein_frequency, vein_width, vein_warp; /* 1/mm; mm */
  float vein_mean[VEIN_FAMILIES];
  float vein_soft, vein_crossing, vein_variation; /* mm; 0..1 */
  float vein_frame[VEIN_FAMILIES][3][3]; /* rows: across a family's veins, and two along; unit */
  float mottle, mottle_frequency;
  int32_t has_beds, has_veins, has_mottle;
  uint32_t seed_bed, seed_vein, seed_mottle, seed_relief;

  float colour[STONE_COLOURS][3]; /* working space */

  /* the paper's colours */
  int32_t mode;               /* MODE_* */
  float texel, inverse_texel; /* mm */
  float base[3], spread[3];   /* 8-bit codes; spread for MODE_RGB */
  float luma, lightness, chroma;
  float black, white;              /* thresholds: below the first, below the second */
  float texel_mean[3];             /* working space, of all texels */
  float decode[3][STONE_CODES][3]; /* what each code of each channel adds, working space */

  stone_tile tile;

  /* finish */
  float relief[STONE_RELIEF], relief_frequency[STONE_RELIEF]; /* mm; 1/mm */
  float relief_slope2[STONE_RELIEF];                          /* variance of the slope, one axis */
  int32_t relief_octaves, pitted, is_cleft, faceted;
  stone_cleft cleft[CLEFT_FAMILIES];
  stone_ledges ledges[CLEFT_FAMILIES];
  stone_facets facets[FACET_SIZES];
  float alpha2;                /* roughness squared where nothing is lost */
  float specular;              /* reflectance at normal incidence, */
  float specular_wet;          /* and from water */
  float soaks;                 /* 0..1: how far the face takes up water, as it is open */
  float relief_steep;          /* variance of the slope along one axis, of all octaves */
  float leaning;               /* how much less slopes that lie together make all lean: surface.h */
  float glancing;              /* share of what leans from which light glances less: gloss.h */
  float hollow, hollow_deep;   /* kernel.c: of all of it; and how deep the mean place lies, 0..1 */
  float hole_depth;            /* mm to a cell */
  float raise;                 /* mm: of inclusions over the face, or below 0 under it; */
  float raise_mean, raise_sd;  /* over all of the plane */
  float dome_mean, dome_steep; /* over inclusions, of a dome of 1: of slope the sd, 1/mm */
  uint32_t seed;

  stone_paving paving;
  stone_weather weather;
} stone_constants;

/* Components of the output channels, in their order. */
enum {
  STONE_ALBEDO = 0,
  STONE_RADIANCE = 3,
  STONE_NORMAL = 6,
  STONE_HEIGHT = 9,
  STONE_ROUGHNESS = 10,
  STONE_SPECULAR = 11,
  STONE_SPECK = 12,
  STONE_GRAIN = 13,
  STONE_JOINT = 14,
  STONE_ID = 15,
  STONE_U = 16,
  STONE_V = 17,
  STONE_EDGE = 18,
  STONE_MOSS = 19,
  STONE_WET = 20,
  STONE_OCCLUSION = 21,
  STONE_COMPONENTS = 22
};

/* Means of what has no formula, over `count` points: how much of space the bodies
 * of each layer fill, how much of a face the widest looks take them to, and the
 * share of each family of veins; and where inclusions are domes, over their bodies, a dome's
 * height, its square and the square of its slope along one axis, 1/mm, and how many are how high,
 * of 1. */
#define DOME_BINS 16
typedef struct {
  double fill[STONE_LAYERS], seen[STONE_LAYERS], core[STONE_LAYERS], veins[VEIN_FAMILIES], dome,
      dome_square, dome_steep2, dome_high[DOME_BINS];
} stone_means;

/* The paving's means, likewise. */
typedef struct {
  double height, slope2, occlusion, moss;
} stone_laid_means;
typedef void stone_measure(const stone_constants *w, uint32_t count, stone_means *out);
typedef void stone_measure_laid(const stone_constants *w, uint32_t count, stone_laid_means *out);

/* Over every texel of the paper's tile: the highest and the mean of its stones,
 * and the joints' share. */
typedef struct {
  double highest, mean, joint;
} paper_scanned;
typedef void paper_scan(const stone_constants *w, paper_scanned *out);

/* One compilation of the kernel. */
typedef struct {
  kernel kernel;
  stone_measure *measure;
  stone_measure_laid *measure_laid;
  paper_scan *scan;
} stone_kernel;

#endif
