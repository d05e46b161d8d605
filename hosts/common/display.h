/* SPDX-License-Identifier: Apache-2.0
 * What a picture is shown through, by name, and what a picture's file says of
 * its colours. */
#ifndef SOZAI_HOSTS_DISPLAY_H
#define SOZAI_HOSTS_DISPLAY_H

#include <stddef.h>
#include "colour.h"
#include "failure.h"

/* NULL: the config's default display, that display's default view, that
 * view's own look. A look of "" is none at all. */
typedef struct display_choice {
  const char *display, *view, *look;
} display_choice;

/* Whether the config has them; the message lists what there is. */
bool display_check(const colour *c, const display_choice *choice, failure *why);

/* count pixels of r g b, from the working space to the display's 0 to 1, in
 * place. Without a service: the sRGB curve over linear Rec.709. */
bool display_apply(const colour *c, const display_choice *choice, float *rgb, size_t count,
                   failure *why);

/* Whether what display_apply gives is meant for an sRGB display. The contract
 * has no word for that, so by the display's name; a view that changes nothing
 * shows raw numbers and is none. */
bool display_is_srgb(const colour *c, const display_choice *choice);

/* The working space's name, and the chromaticities of its red, green, blue and
 * white; false: the config cannot say them. */
bool display_working(const colour *c, const char **name, float xy[8]);

#endif
