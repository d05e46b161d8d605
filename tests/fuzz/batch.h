/* SPDX-License-Identifier: Apache-2.0
 * The built plugin, and batches as a hostile host would hand them over. */
#ifndef SOZAI_TESTS_FUZZ_BATCH_H
#define SOZAI_TESTS_FUZZ_BATCH_H

#include "fuzz.h"
#include "sozai.h"

/* Loaded when first asked, and kept. */
const sozai_textures_1 *batch_plugin(void);
/* Any inputs, any of them missing, any outputs: what comes is finite, and what was not asked for is
 * untouched. */
void batch_try(const sozai_texture *t, bytes *b);

#endif
