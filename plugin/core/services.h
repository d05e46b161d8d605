/* SPDX-License-Identifier: Apache-2.0
 *
 * Services for colour and pictures: the host's own, else those of
 * sozai-colour.so beside the plugin.
 */
#ifndef SOZAI_CORE_SERVICES_H
#define SOZAI_CORE_SERVICES_H

#include "../../api/sozai.h"

/* Where sozai.so was loaded from, for sozai-colour.so beside it. */
void services_plugin_path(const char *path);
/* Closes what was opened; at the last deinit. */
void services_close(void);

/* The table of that id for the host's config; *out NULL: there is none. Lives
 * until the last deinit. */
int32_t services_find(const sozai_host *host, const char *id, const void **out);

#endif
