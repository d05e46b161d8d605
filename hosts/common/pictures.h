/* SPDX-License-Identifier: Apache-2.0
 * Loading sozai-pictures.so, when a picture is first written or read:
 * OpenImageIO brings 260 libraries along, and most that a program is asked for
 * needs none of them. */
#ifndef SOZAI_HOSTS_PICTURES_H
#define SOZAI_HOSTS_PICTURES_H

#include "failure.h"

struct pictures; /* hosts/pictures/module.h */

/* The one of this process, which stays. NULL: why. [thread-safe] */
const struct pictures *pictures_load(failure *why);

#endif
