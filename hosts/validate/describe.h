/* SPDX-License-Identifier: Apache-2.0
 * The checks of descriptions, "describe.stable" and so on, that describe.c lists
 * and other files hold. */
#ifndef SOZAI_VALIDATE_DESCRIBE_H
#define SOZAI_VALIDATE_DESCRIBE_H

#include "subject.h"

/* "Strings of this and the following descriptions are never NULL unless it says so." */
void described_text(const char *where, const char *id, const char *what, const char *text,
                    bool may_be_empty);

/* describe_stable.c */
void describe_stable(subject *s);
/* describe_parameters.c */
void describe_parameter_kinds(subject *s);
void describe_ranges(subject *s);
void describe_defaults(subject *s);
void describe_choices(subject *s);
void describe_buffers(subject *s);
void describe_groups(subject *s);
/* describe_results.c */
void describe_presets(subject *s);
void describe_channels(subject *s);
void describe_components(subject *s);
void describe_tables(subject *s);

#endif
