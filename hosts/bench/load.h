/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_BENCH_LOAD_H
#define SOZAI_BENCH_LOAD_H

#include "failure.h"

/* What loading the plugin and a first create() take in a fresh process. */
bool load_once(const char *plugin_path, double *ns, failure *why);
/* The same, of the plugin without sozai-colour.so beside it. */
bool load_alone(const char *plugin_path, double *ns, failure *why);

#endif
