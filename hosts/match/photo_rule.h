/* SPDX-License-Identifier: Apache-2.0
 * Which colour space the config's file rules say a picture's numbers are in. */
#ifndef SOZAI_MATCH_PHOTO_RULE_H
#define SOZAI_MATCH_PHOTO_RULE_H

#include "colour.h"

/* A name that lives as long as the services. integers: whether the file holds
 * such, for want of a rule: sRGB, and of floats the working space. */
const char *photo_rule(const char *path, bool integers, const colour *c);

#endif
