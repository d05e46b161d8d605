/* SPDX-License-Identifier: Apache-2.0
 * The finished units of a bake, kept in a folder until the pictures are put
 * together.
 *
 * The folder holds bake.txt, which says what is being baked, a lock
 * (folder_lock.h), and for each worker I of N a journal I-of-N.pieces: one record after another,
 * each a header (see pieces.c) and the unit's pixels. A record that was cut short, or whose pixels
 * do not match its checksum, counts as not there. Journals are for the machines of one kind that
 * made them: numbers are in their order of bytes. */
#ifndef SOZAI_BAKE_PIECES_H
#define SOZAI_BAKE_PIECES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include "failure.h"
#include "folder_lock.h"

typedef struct piece {
  uint32_t journal; /* index in names, plus 1; 0: not there */
  uint64_t offset;  /* of its pixels */
  uint64_t bytes;
} piece;

typedef struct pieces {
  char *folder;
  piece *units; /* unit_count of them */
  uint64_t unit_count;
  char **names; /* paths of the journals */
  uint32_t name_count;
  FILE *reading; /* of the journals, the one read last */
  uint32_t reading_index;
  FILE *writing; /* one's own, or NULL */
  folder_lock lock;
  uint64_t written;
} pieces;

#define PIECES_FRESH 0  /* what is there of an earlier bake is thrown away; alone in the folder */
#define PIECES_RESUME 1 /* what is there of the same bake is taken up; beside others */
#define PIECES_MERGE 2  /* the same, but nothing is there to be added; alone */

/* job: the text of bake.txt: a line "name: value" for all that decides the
 * pixels. What is there of another job is refused, naming the line; and so is a
 * folder that another bake uses, where either wants to be alone. */
bool pieces_open(pieces *p, const char *folder, const char *job, uint64_t unit_count, int mode,
                 failure *why);
/* Begin one's own journal, or go on with it. Refused while another process
 * writes it. */
bool pieces_write_as(pieces *p, uint32_t worker, uint32_t of, failure *why);
/* Add a unit; it is safe from an end of this process as soon as this returns. */
bool pieces_add(pieces *p, uint64_t unit, const void *pixels, uint64_t bytes, failure *why);
/* From here to the end this process alone uses the folder. Refused while others
 * do. */
bool pieces_lock(pieces *p, failure *why);
bool pieces_has(const pieces *p, uint64_t unit);
/* Read one of exactly so many bytes. */
bool pieces_read(pieces *p, uint64_t unit, void *pixels, uint64_t bytes, failure *why);
/* Whether nobody else uses the folder, nor has anybody left a piece there. Last
 * before pieces_close. */
bool pieces_worthless(pieces *p);
/* Close; remove: the folder too, after pieces_lock or where it is worthless. */
void pieces_close(pieces *p, bool remove);

#endif
