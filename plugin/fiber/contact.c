/* SPDX-License-Identifier: Apache-2.0 */
#include "fiber.h"
int32_t fiber_keep_apart(fiber *f, const sozai_host *host) {
  (void)f;
  (void)host;
  return SOZAI_OK;
}
