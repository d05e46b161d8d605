/* SPDX-License-Identifier: Apache-2.0
 *
 * A folder that is empty before a program's tests and gone after.
 */
#ifndef SOZAI_TEST_IMAGES_TEMP_H
#define SOZAI_TEST_IMAGES_TEMP_H

#include <stddef.h>

void temp_make(void);
void temp_remove(void);
/* A path in it; one of a few buffers, so that some may be used side by side. */
const char *temp_path(const char *name);
void temp_write(const char *path, const void *data, size_t size);
/* What a file holds, to be freed. */
unsigned char *temp_read(const char *path, size_t *size);

#endif
