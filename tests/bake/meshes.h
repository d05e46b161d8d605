/* SPDX-License-Identifier: Apache-2.0
 * Unwrapped meshes to test with, as OBJ files. */
#ifndef SOZAI_TEST_BAKE_MESHES_H
#define SOZAI_TEST_BAKE_MESHES_H

#include <stdbool.h>
#include <stdio.h>

/* A box with edges cut off at 45 degrees, 60 x 100 x 30 mm, 6 charts that meet in the
 * middle of the cut edges; `cells` to a chart's side. udim: each chart in a
 * tile of its own, 1001 to 1004, 1011, 1012; else all in 1001. */
void write_box(FILE *to, unsigned cells, bool udim);
/* A table's leg, turned: 300 mm high along y, about 20 mm in radius; its side
 * is cut open along a line and unrolled, its ends are two discs. */
void write_leg(FILE *to, unsigned around, unsigned along);
/* A sphere-like blob of 2 * cells * cells triangles, unrolled whole. */
void write_blob(FILE *to, unsigned cells);

#endif
