/* SPDX-License-Identifier: Apache-2.0
 * What every fuzz target is made of: one function that takes any bytes, and helpers
 * that turn bytes into what a parser wants. libFuzzer calls it (the preset `fuzz`), or
 * replay.c does (every other build). */
#ifndef SOZAI_TESTS_FUZZ_H
#define SOZAI_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 0; -1 where the bytes are not worth keeping. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* What must hold whatever the input. */
#define CHECK(holds)                                                                               \
  ((holds) ? (void)0                                                                               \
           : (fprintf(stderr, "%s:%d: CHECK failed: %s\n", __FILE__, __LINE__, #holds), abort()))

/* ---- bytes, taken from the front; zeros when there are none left ---------- */

typedef struct bytes {
  const uint8_t *at;
  size_t left;
} bytes;

uint8_t take_u8(bytes *b);
uint32_t take_u32(bytes *b);
/* From 0 to below `count`, which is not 0. */
uint32_t take_below(bytes *b, uint32_t count);
/* Often a number that is worth trying: 0, an end of the range, NaN, 1e30 ... */
double take_number(bytes *b, double low, double high);
float take_float(bytes *b);
/* As many bytes as the next one says, `most` at most (a byte holds 255); zero-terminated,
 * without zeros within. To be freed. */
char *take_text(bytes *b, size_t most);

/* ---- text in pieces -------------------------------------------------------- */

/* The index-th of the pieces that lines "%%" part, zero-terminated; "" where there are
 * fewer. *length without the zero; NULL is allowed. To be freed. */
char *take_piece(const uint8_t *data, size_t size, uint32_t index, size_t *length);

/* ---- files ----------------------------------------------------------------- */

/* The path of a file of that name in a folder of this process's own, which goes when it
 * ends. Valid until the next call but three. */
const char *scratch_path(const char *name);
/* The same, with this in it. */
const char *scratch_file(const char *name, const void *data, size_t size);

#ifdef __cplusplus
}
#endif

#endif
