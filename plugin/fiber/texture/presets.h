/* SPDX-License-Identifier: Apache-2.0
 *
 * Presets: the catalogue's fibres as they lie in use.
 */
#ifndef SOZAI_FIBERTEX_PRESETS_H
#define SOZAI_FIBERTEX_PRESETS_H

#include "../../../api/sozai.h"

/* Made at the first call, which is alone. */
const sozai_preset *const *fibertex_presets(uint32_t *count);

#endif
