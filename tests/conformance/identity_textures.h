/* SPDX-License-Identifier: Apache-2.0
 *
 * The textures on which the plugin must give the same bits everywhere: of every
 * material, with every way that its kernel takes.
 */
#ifndef SOZAI_TESTS_IDENTITY_TEXTURES_H
#define SOZAI_TESTS_IDENTITY_TEXTURES_H

#include "plugin.h"

/* Those that the first `blocks` blocks ask, none of them larger than COMPONENTS and
 * 32 channels. 0; 1, with the reason on stderr; 77 where the plugin says that this
 * machine lacks what SOZAI_CPU asks for. */
int textures_make(const plugin *p, uint64_t blocks);
/* Of a block below that number. */
sozai_texture *texture_of(uint64_t block);
/* Before the plugin stops. */
void textures_free(void);

#endif
