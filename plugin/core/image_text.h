/* SPDX-License-Identifier: Apache-2.0
 *
 * A picture as it is named: by text, by a path, or by a buffer of the host's.
 */
#ifndef SOZAI_CORE_IMAGE_TEXT_H
#define SOZAI_CORE_IMAGE_TEXT_H

#include "../../api/sozai.h"

/* A piece of another's string. */
typedef struct {
  const char *at; /* NULL: not said */
  size_t length;
} piece;

typedef struct {
  piece path, space;
  uint32_t wrap, first_channel;
  const sozai_buffer *data; /* of the host's, or NULL */
} image_name;

/* "PATH @ SPACE, wrap=mirror, channel=0"; what follows the last " @ " may be
 * left out, in part or whole. p is for messages. */
int32_t image_name_from_text(const sozai_parameter *p, const char *text, image_name *out);
/* A checked buffer of kind IMAGE. */
image_name image_name_from_buffer(const sozai_buffer *b);
image_name image_name_from_path(const char *path);
/* Whether there is a picture at all. */
int image_name_given(const image_name *n);

#endif
