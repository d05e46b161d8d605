/* SPDX-License-Identifier: Apache-2.0
 * The gallery's page: index.html. */
#ifndef SOZAI_CLI_GALLERY_INDEX_H
#define SOZAI_CLI_GALLERY_INDEX_H

#include "gallery_picture.h"

/* The pictures that were made, under their sections; made: of each of the list, whether.
 * sheets: of each of gallery_sheets, whether there is one. */
bool gallery_index_write(const easel *e, const picture_list *list, const bool *made,
                         const bool *sheets, failure *why);

#endif
