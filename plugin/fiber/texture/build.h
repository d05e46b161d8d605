/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_FIBERTEX_BUILD_H
#define SOZAI_FIBERTEX_BUILD_H

#include "../../core/params.h"
#include "texture.h"

/* From settings to what the kernel reads. colours: in the working space.
 * kernel: any, since all measure the same. */
int32_t fibertex_build(fibertex_constants *w, const sozai_host *host, const settings *s,
                       const float (*colours)[3], const fibertex_kernel *kernel);

#endif
