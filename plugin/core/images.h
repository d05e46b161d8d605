/* SPDX-License-Identifier: Apache-2.0
 *
 * The pictures of a texture: opened when it is created, by whichever image
 * service there is, and closed with it.
 */
#ifndef SOZAI_CORE_IMAGES_H
#define SOZAI_CORE_IMAGES_H

#include "../../api/sozai_colour.h"
#include "params.h"

typedef struct {
  const sozai_images_1 *service; /* NULL: no picture was given */
  sozai_image **list;            /* one for each parameter, NULL where there is none */
  uint32_t count;
} image_set;

/* Opens the pictures of every IMAGE setting. On failure nothing is held. */
int32_t images_open(image_set *set, const sozai_host *host, const sozai_texture_info *info,
                    const settings *s);
void images_close(image_set *set, const sozai_host *host);
/* A service's result that is not SOZAI_OK as one that this header's callers may be given. */
int32_t image_result(int32_t r);
/* From a kernel: what a look-up came to. */
void images_answered(int32_t result);
/* Before look-ups that are to be asked about; and what those of this thread came to since. */
void images_forget(void);
int32_t images_looked(void);
/* Of the host's memory; pictures are the service's. */
uint64_t images_bytes(const image_set *set);

#endif
