/* SPDX-License-Identifier: Apache-2.0
 *
 * The parts of wood_build, for the files of this folder alone. Each writes constants of its own,
 * and may read those of the parts before it; they stand in the order in which build.c calls them.
 */
#ifndef SOZAI_WOOD_BUILD_PARTS_H
#define SOZAI_WOOD_BUILD_PARTS_H

#include "../../core/hash1.h"
#include "../build.h"

#define TWO_PI 6.28318530717958647692
#define NOISE_BOUND 2147483648.0 /* of the kernels' noises, which are of whole numbers */

/* The fibres' noise's variance over its bound's square: a third from each corner, and
 * 26/35 of that is left between them along each axis. */
#define FIBRE_VARIANCE 0.1839

/* cut.c: from the object to the log. */
int32_t wood_build_cut(wood_constants *w, const settings *s);

/* season.c: the profile of a ring, from early- to latewood. */
void wood_build_season(wood_constants *w, const settings *s);

/* stem.c: pith, outline, growth front. */
int32_t wood_build_stem(wood_constants *w, const settings *s);

/* rings.c: the table of rings. tree: whose growth they may follow. */
int32_t wood_build_rings(wood_constants *w, const settings *s, const knot_source *tree);

/* grain.c: what the fibres do along the stem. */
void wood_build_grain(wood_constants *w, const settings *s);

/* figure.c: curl, quilt, bird's eyes. */
int32_t wood_build_figure(wood_constants *w, const settings *s);

/* vessels.c: pores of the field; it calls rows.c for the earlywood's. */
void wood_build_vessels(wood_constants *w, const settings *s);
void wood_build_rows(wood_constants *w, const settings *s);

/* parenchyma.c: whether vessels have sheaths; those, once vessels are known, square being the mean
 * of their radii's square over that of the mean; and the rest. */
int wood_has_sheaths(const wood_constants *w, const settings *s);
void wood_build_sheaths(wood_constants *w, const settings *s, double square);
void wood_build_parenchyma(wood_constants *w, const settings *s, const float (*colours)[3]);
/* Mean share of the section that ellipses of semi-axes a and b cover, two to each cell, as much
 * larger or smaller as vessels are; mm. */
double wood_paired_cover(const wood_vessels *v, double a, double b, double cell);

/* bands.c: how they are arranged. largest: mm, the largest pore's radius. */
void wood_build_bands(wood_constants *w, const settings *s, double largest);
/* Mean share of an area that is covered by pores in bands, whose areas over it sum to c. radius,
 * cell: mm, of a pore and of its cell. */
double wood_banded_cover(const wood_bands *m, double c, double radius, double cell);
/* How many times as dense as on average vessels are within `half` of the spacing from a band's
 * middle. */
double wood_bands_denser(const wood_bands *m, double half);

/* rays.c, fibres.c */
void wood_build_rays(wood_constants *w, const settings *s);
void wood_build_fibres(wood_constants *w, const settings *s);

/* colour.c: colours, heartwood, gloss. colours: in the working space. */
int32_t wood_build_colour(wood_constants *w, const sozai_host *host, const settings *s,
                          const float (*colours)[3]);

/* canals.c, cells.c, spalt.c */
void wood_build_canals(wood_constants *w, const settings *s, const float (*colours)[3]);
void wood_build_cells(wood_constants *w, const settings *s);
void wood_build_spalt(wood_constants *w, const settings *s);

/* cone.c: the fibres' own reflection, once their colour is known. */
void wood_build_cone(wood_constants *w, const settings *s);

/* ---- what several of them use ------------------------------------------ */

static inline double limited(double x, double low, double high) {
  return x < low ? low : x > high ? high : x;
}

/* The k-th number of a stream, uniform in 0..1; inline, since rows.c draws thousands. */
enum { STREAM_RINGS = 101, STREAM_LATE, STREAM_OUTLINE, STREAM_ROW_X, STREAM_ROW_Z, STREAM_HEART };
static inline double wood_uniform(uint32_t seed, uint32_t stream, uint32_t k) {
  return (hash1(seed ^ hash1(stream * 0x9e3779b9u + k)) + 0.5) / 4294967296.0;
}

/* random.c: the same, normal, of mean 0 and standard deviation 1. */
double wood_normal(uint32_t seed, uint32_t stream, uint32_t k);
/* The i-th of WOOD_RADII equally likely numbers of that distribution. */
double wood_radius_quantile(int i);

/* grain.c: irregularity 0..1 of waves of a length, mm. variance: of the swell's noises. */
wood_irregular wood_irregular_of(double amount, double length, double variance);

/* radii.c: a layer's radii and what follows from them. Returns the mean square of radius over
 * mean radius. */
double wood_build_radii(wood_vessels *v, double diameter_um, double spread);

/* radii.c: the longest footprint for which every vessel that could cover it lies within `clear`
 * of its centre. end: in units of the blurred disc's q, where that is 0. */
#define END_SHARP 1.25 /* of a disc that is full in its middle */
#define END_CONE 1.48
float wood_longest_footprint(double clear, double radius, double end);

#endif
