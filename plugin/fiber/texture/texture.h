/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre's texture: what a created one is, numbers that never change.
 *
 * The way from a point on the hull to its strand (docs/fiber-texture.md)
 *   layers      the shell below the hull, cut level by level; the ray towards
 *               the eye meets each where parallax puts it
 *   bundles     each layer is divided into cells of space, in which strands
 *               lie side by side in one direction
 *   lanes       the strands of a bundle, each with a centreline, ends, a
 *               radius and a tone of its own; two are looked at
 *   yarns       of a cloth: the bundles lie along yarns instead
 * Under a footprint of some lanes strands are counted and not placed, of many
 * they give way to their bundle's mean, and bundles to the layer's: a density
 * with directions.
 */
#ifndef SOZAI_FIBERTEX_TEXTURE_H
#define SOZAI_FIBERTEX_TEXTURE_H

#include <stdint.h>

#include "../../core/kernel.h"

/* A stage that is large, or called from several places: once in the code. */
#define STAGE static __attribute__((noinline, unused))

#define FIBERTEX_HULL 7  /* layers of an aggregate; the first stands off, where any does */
#define FIBERTEX_FLOWN 6 /* layers that may stand off, where one does not hold them */
#define FIBERTEX_LAYERS (FIBERTEX_HULL - 1 + FIBERTEX_FLOWN)
#define FIBERTEX_DIRECTIONS 16 /* that bundles lie in: quantiles */
#define FIBERTEX_LOOKS 6       /* directions that stand for all from afar */
#define FIBERTEX_FACES 4       /* of a cloth the first, two of either yarn; the rest stand off */

/* Over so many sigma max(0, 1 - q/8)^8, q = x^2 / 2 sigma^2, is a bell's density. */
#define FIBERTEX_BELL 2.39628

enum { STRUCTURE_AGGREGATE, STRUCTURE_WOVEN };
enum { COLOUR_FIRST, COLOUR_SECOND, COLOUR_WEFT, FIBERTEX_COLOURS };

/* A layer of the shell. Lengths in mm. */
typedef struct {
  float size, inverse_size; /* of the lattice of bundles, two to a cell */
  float offset[3];          /* of the lattice, cells */
  float reach2;             /* a bundle's radius, squared */
  float spacing, inverse_spacing;
  float radius, inverse_radius, radius_vary;
  float shift, sway; /* how far a centreline lies off its lane's middle, over 2^31; and swings */
  float tilt;        /* how far it drifts per mm, over 2^31 */
  float vague, vague_inverse; /* footprint from which strands are counted; 1 over how far on none is
                               seen by itself */
  float seen, seen_inverse;   /* footprint that its two lanes stand for, half; 1 over all of it */
  float widen_most;           /* how much broader a strand may look at a slant */
  float depth, depth_cells;   /* of the layer below the hull; in cells of the lattice */
  float chord_least;
  float ambient;               /* of the light that comes from around, what reaches it */
  float mean;                  /* share that its strands cover, seen squarely */
  float formula;               /* a bundle's mean, at its middle; */
  float pale;                  /* how bright, if strands did not dive */
  float counted, counted_lift; /* of strands that are counted: what slopes add to their width; 1
                                * over their mean brightness */
  float counted_near, counted_luck; /* mean nearness of what they leave bare; and how much less it
                                     * is of one lane */
  float counted_end; /* 2 over half of a footprint, in lanes, of which those that are counted are
                      * too few to tell anything */
  float beyond_near, beyond_widen; /* of what lies beyond the bundle: nearness; how much broader it
                                    * may look */
  float beyond[2]; /* what of a footprint lies beyond the bundle: share that is covered; that times
                    * brightness */
  float soft;      /* mean nearness of strands where they do not cover, */
  float soft_wide; /* and what is added to that for a footprint as wide as its lanes stand for */
  float lift;      /* 1 over the mean brightness of its strands, which is to be 1 */
  float slope2;    /* variance of the strands' slope within their bundle */
  float twist[2];  /* on a yarn: cosine and sine of the strands' angle */
  float presence;  /* chance of a lane to have a strand, of 2^32 */
  int32_t lattice; /* which of the turned ones */
  int32_t ends;    /* strands end within their bundle; else they follow a yarn */
  uint32_t seed;
} fibertex_layer;

/* One of the directions that stand for all: in the frame of the hull's axes. */
typedef struct {
  float along[3], across[3], up[3]; /* the strand's; out of its yarn, or the hull. unit */
  float across2, up2;               /* variance of the angles to the directions it stands for */
  float share;
  float lit;    /* what of the light that comes from around reaches it, times share */
  float level;  /* of a yarn's face: the same times the cosine of its lean */
  float tip[2]; /* of a yarn's face: how it leans, a tangent to either axis */
  int32_t weft;
} fibertex_look;

/* The yarns of one direction. Lengths in mm. */
typedef struct {
  float spacing, inverse_spacing; /* from one to the next */
  float half, inverse_half;       /* width, half */
  float height;                   /* thickness, half */
  float edge;                     /* the same over the width, where there are holes */
  float rise, over;               /* how far its middle goes up and down, about what */
  float swell;                    /* how much broader on top than in the middle, of half */
  float wander, frequency;        /* unevenness, of half; 1/mm */
  float sway, course;             /* to the side of a straight way, mm; 1/mm */
  float tone;                     /* from yarn to yarn, over a field's 2^31 */
} fibertex_yarn;

/* Footprints, mm, between which parts of them are looked at in place of the middle, more parts, and
 * the mean of all cloth in place of parts; and 1 over what is seen of warp and weft in the mean, in
 * its shade, of what is yarn. */
typedef struct {
  float near[2], finer[2], far[2];
  float inverse_mean[2];
} fibertex_parts;

typedef struct {
  int32_t structure, layers, looks;
  float offset[3];
  float axis[3]; /* that strands align with, object space */
  int32_t axis_index;
  fibertex_layer layer[FIBERTEX_LAYERS];
  float turn[2][FIBERTEX_DIRECTIONS]; /* cosine and sine of the quantiles of direction */
  fibertex_look look[FIBERTEX_LOOKS];

  /* ..._vary: how far from it, over a field's 2^31 */
  float crimp, crimp_frequency, crimp_vary; /* shared in a bundle: mm; 1/mm */
  float own_frequency, own_vary;            /* of a strand's swing, 1/mm */
  float curl;                               /* curvature of a bundle, 1/mm, over a field's 2^31 */
  float slope2;                             /* variance of the slope of what bundles share */
  float scatter, scatter_up; /* of strands about their bundle's course, when not told apart */
  float lean, rise, rise2;   /* tangent of the elevation: mean, how far from it, variance */
  int32_t pile;              /* whether strands stand out of the hull: pile.h */
  float steep2;              /* mean square of the elevation's tangent */
  /* how far the axis turns in patches, how much steeper strands rise, log2: standard deviations;
   * and 1/mm: nap.h */
  float nap, nap_steeper, nap_frequency;
  uint32_t nap_seed;
  float cloud, cloud_frequency; /* of brightness: standard deviation; 1/mm: cloud.h */
  uint32_t cloud_seed;
  float radius_spread;
  float contact;         /* how much of the light strands take from what is close below */
  float step, step_more; /* optical depth of the first layer; and what each next has more */
  float far[2];          /* footprints between which bundles give way to the mean */
  float deep, deep_ambient, deep_above, deep_depth; /* what is below the last layer */

  /* cloth */
  fibertex_yarn yarn[2]; /* warp, weft */
  fibertex_parts parts;
  int32_t over, pair, shift;
  float repeat, inverse_repeat;
  float hollow, low, inverse_range; /* shade of furrows; their depth, and 1 over it */
  float solid, gaps;                /* share that is yarn; holes, over both widths' gaps */
  int32_t yarns_from;               /* the first layer that is on them */
  float lean_rms, slope_rms;   /* of all faces: sines to the side and along, mean square's root */
  float warp_share, flown;     /* of what is yarn; of what is seen, single strands over it */
  float part[FIBERTEX_LAYERS]; /* of what is seen squarely, each layer's, */
  float part_deep;             /* and what lies deeper, */
  float below[2];              /* in which direction; of an aggregate in none */

  /* working space: the palette; of light that went on through strands; of light that is
   * scattered often */
  float colour[FIBERTEX_COLOURS][3], glow[FIBERTEX_COLOURS][3], bulk[FIBERTEX_COLOURS][3];
  float second_share, variation;
  int32_t second_chance; /* of 256 */

  /* light on a strand: docs/fiber-texture.md */
  float gloss[3], tilt[3], sharp[3]; /* of R, TT and TRT; the last over R's */
  float beta2;                       /* R's variance */
  float from_afar[3];                /* of an aggregate's: what looks that stand for all lack */
  float single, multiple;            /* diffuse: of light met once, and often */
  float chain;                       /* of what goes on through strand after strand */
  /* cloth: reflectance of a strand squarely; what strands that stand off its yarns let through, how
   * much they shade themselves, and how many there are; variance of what is scattered often along
   * a yarn's strands, and 1 over its bell's mean */
  float mirror, flown_gloss, flown_deep, hair, even2, even;
  /* what is met often: the shell's optical depth for it, half; over how deep shells are; and
   * its loss where light or view is at a slant, and where both are */
  float slab, slab_linear, slab_square, graze, graze_both;
  /* how much less is shaded of what is seen along the light; how soon that ends as the
   * two part: over 1 - their cosine */
  float opposition, opposition_sharp;
  float strand_alpha2; /* roughness of a strand */
  uint32_t seed;
} fibertex_constants;

/* Components of the output channels, in their order. */
enum {
  FIBERTEX_ALBEDO = 0,
  FIBERTEX_RADIANCE = 3,
  FIBERTEX_COVERAGE = 6,
  FIBERTEX_TANGENT = 7,
  FIBERTEX_STRAND = 10,
  FIBERTEX_DEPTH = 11,
  FIBERTEX_HEIGHT = 12,
  FIBERTEX_NORMAL = 13,
  FIBERTEX_ROUGHNESS = 16,
  FIBERTEX_COMPONENTS = 17
};

/* Means of what is counted of a layer: coverage, over it brightness, nearness of what is bare, of
 * few lanes and of so many that there is no chance in it; and of coverage and of that times
 * brightness how much of the mean is beyond the bundle's edge. */
typedef struct {
  double cover, bright, near[2], luck, beyond[2], beyond_near;
} fibertex_counted;

/* Means over `count` footprints as wide as so many lanes, 0 for points: of each layer's coverage at
 * a point, of its bundles' formula, of what covers its brightness, and of its strands' nearness
 * where they do not cover; if strands are to be counted, also of those, and of how bright the
 * formula's strands are. */
typedef struct {
  double point[FIBERTEX_LAYERS], formula[FIBERTEX_LAYERS], soft[FIBERTEX_LAYERS],
      bright[FIBERTEX_LAYERS], pale[FIBERTEX_LAYERS];
  fibertex_counted counted[FIBERTEX_LAYERS];
} fibertex_means;
typedef void fibertex_measure(const fibertex_constants *w, uint32_t count, float lanes, int counted,
                              fibertex_means *out);

/* Means over `count` points of a cloth: what share its warp and its weft show, those in the shade
 * of furrows, the same by how level they lie, and the squares and fourth powers of the sines of its
 * face's lean to the side and of its slope. */
typedef struct {
  double yarn[2], shaded[2], level[2], lean2[2], lean4[2], slope2[2], slope4[2];
} fibertex_cloth_means;
typedef void fibertex_measure_cloth(const fibertex_constants *w, uint32_t count,
                                    fibertex_cloth_means *out);

/* Over `count` places, lights and views, as the places themselves have it and as looks that stand
 * for all have: of a cloth what comes back of what is scattered often, of warp and weft; of an
 * aggregate R, TT and TRT. Sums. */
typedef struct {
  double near[3], far[3];
} fibertex_both;
typedef void fibertex_measure_both(const fibertex_constants *w, uint32_t count, fibertex_both *out);

/* One compilation of the kernel. */
typedef struct {
  kernel kernel;
  fibertex_measure *measure;
  fibertex_measure_cloth *measure_cloth;
  fibertex_measure_both *measure_both;
} fibertex_kernel;

#endif
