/* SPDX-License-Identifier: Apache-2.0
 * What a shared object says of itself, read from its file before any of its
 * code runs. 64-bit ELF of this machine's byte order, which is what can be
 * loaded here. Read with elf.h of libc; every place is checked against the
 * file's size, as the file may be cut off or hostile. */
#ifndef SOZAI_VALIDATE_LIBRARY_FILE_H
#define SOZAI_VALIDATE_LIBRARY_FILE_H

#include <stdbool.h>
#include <stdint.h>

#define LIBRARY_NAMES 4096u

typedef struct library_symbol {
  const char *name;
  bool defined;
  bool datum;    /* an object, not a function */
  uint64_t size; /* bytes */
} library_symbol;

typedef struct library_file {
  const unsigned char *bytes;
  uint64_t size;
  library_symbol symbols[LIBRARY_NAMES]; /* that others can see, or that it asks for */
  uint32_t symbol_count;
  const char *needed[64];
  uint32_t needed_count;
  bool runs_stack;  /* asks for an executable stack */
  bool text_relocs; /* writes into its code when it is loaded */
} library_file;

/* False with a reason in why. The file stays mapped. */
bool library_read(library_file *f, const char *path, char *why, unsigned why_size);

#endif
