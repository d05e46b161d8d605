/* SPDX-License-Identifier: Apache-2.0
 * A picture of the gallery that is of a grown tree. */
#ifndef SOZAI_CLI_GALLERY_TREE_H
#define SOZAI_CLI_GALLERY_TREE_H

#include "film.h"
#include "gallery_table.h"
#include "session.h"

bool gallery_is_tree(const shot *s);

/* As `sozai grow tree` draws it, which takes GALLERY_TREE_LEVEL as --level: of what a finer one
 * has, pixels of the gallery see nothing. */
#define GALLERY_TREE_LEVEL 2u

typedef struct gallery_tree {
  const shot *shot;
  uint32_t spp, threads;
} gallery_tree;

bool gallery_tree_render(session *s, const gallery_tree *t, film *out, failure *why);

#endif
