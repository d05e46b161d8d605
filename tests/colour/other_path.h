/* SPDX-License-Identifier: Apache-2.0
 *
 * The same conversions by other people's programs: oiiotool (Debian:
 * openimageio-tools) and ocioconvert (opencolorio-tools).
 */
#ifndef SOZAI_TEST_COLOUR_OTHER_PATH_H
#define SOZAI_TEST_COLOUR_OTHER_PATH_H

#include <stdbool.h>

enum { SIDE = 64, PIXELS = SIDE * SIDE };

/* The colours that go in: 0 to 1 in steps of 1/65535, times scale. */
void input_colours(float scale, float rgb[PIXELS * 3]);

/* Whether there is that program. */
bool has_program(const char *name);

/* oiiotool's answer to arguments such as "--colorconvert a b", or a failed test. */
void by_oiiotool(const char *config, float scale, const char *arguments, float rgb[PIXELS * 3]);

/* ocioconvert's, from a space into another. */
void by_ocioconvert(const char *config, const char *from, const char *to, float scale,
                    float rgb[PIXELS * 3]);

#endif
