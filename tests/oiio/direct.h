/* SPDX-License-Identifier: Apache-2.0
 * The material of a .sozai file through the plugin's own functions, for what is
 * read through OpenImageIO to be compared with. */
#ifndef TESTS_OIIO_DIRECT_H
#define TESTS_OIIO_DIRECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct direct direct;

/* Stops the program where it fails. */
direct *direct_open(const char *name);
void direct_close(direct *d);
/* A channel's components at a point under a footprint, mm. normal NULL: none.
 * Stops the program where there is no such channel. [thread-safe] */
void direct_at(const direct *d, const char *channel, const float point[3], const float *normal,
               float footprint, float *out);
/* The middle of texel i of n over size mm about the origin. */
float direct_middle(uint32_t i, uint32_t n, double size);

/* A folder for the test's own files, made, and removed at the program's end; a
 * place there; and a file with that text. Their names stay valid till then. One
 * thread. */
const char *direct_folder(void);
const char *direct_path(const char *name);
const char *direct_write(const char *name, const char *text);

/* Random numbers, the same on every machine. */
uint32_t direct_random(uint64_t *state);

#ifdef __cplusplus
}
#endif

#endif
