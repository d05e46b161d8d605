/* SPDX-License-Identifier: Apache-2.0 */
#include "library_file.h"

#include <elf.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct tables {
  uint64_t names, names_size; /* the dynamic string table, as file offsets */
  uint64_t symbols, symbol_count;
} tables;

static const void *at(const library_file *f, uint64_t offset, uint64_t bytes) {
  return offset <= f->size && bytes <= f->size - offset ? f->bytes + offset : NULL;
}

/* A zero-terminated text within the string table. */
static const char *name_at(const library_file *f, const tables *t, uint64_t offset) {
  if (offset >= t->names_size) return NULL;
  const char *text = at(f, t->names + offset, 1);
  uint64_t room = t->names_size - offset;
  if (t->names + offset >= f->size) return NULL;
  if (room > f->size - t->names - offset) room = f->size - t->names - offset;
  return text && memchr(text, 0, (size_t)room) ? text : NULL;
}

/* Structs are copied out: a hostile file keeps no alignment. */
static bool section(const library_file *f, const Elf64_Ehdr *e, uint32_t type, Elf64_Shdr *out) {
  for (uint32_t i = 0; i < e->e_shnum; i++) {
    const void *from = at(f, e->e_shoff + (uint64_t)i * sizeof *out, sizeof *out);
    if (!from) return false;
    memcpy(out, from, sizeof *out);
    if (out->sh_type == type) return true;
  }
  return false;
}

static bool find_tables(const library_file *f, const Elf64_Ehdr *e, tables *t) {
  Elf64_Shdr symbols, names;
  if (!section(f, e, SHT_DYNSYM, &symbols)) return false;
  const void *from = at(f, e->e_shoff + (uint64_t)symbols.sh_link * sizeof names, sizeof names);
  if (!from || symbols.sh_link >= e->e_shnum) return false;
  memcpy(&names, from, sizeof names);
  t->names = names.sh_offset;
  t->names_size = names.sh_size;
  t->symbols = symbols.sh_offset;
  t->symbol_count = symbols.sh_size / sizeof(Elf64_Sym);
  return true;
}

static void read_symbols(library_file *f, const tables *t) {
  for (uint64_t i = 1; i < t->symbol_count && f->symbol_count < LIBRARY_NAMES; i++) {
    Elf64_Sym s;
    const void *from = at(f, t->symbols + i * sizeof s, sizeof s);
    if (!from) return;
    memcpy(&s, from, sizeof s);
    const char *name = name_at(f, t, s.st_name);
    int visibility = ELF64_ST_VISIBILITY(s.st_other), bind = ELF64_ST_BIND(s.st_info);
    if (!name || !*name || bind == STB_LOCAL) continue;
    if (visibility == STV_HIDDEN || visibility == STV_INTERNAL) continue;
    f->symbols[f->symbol_count++] =
        (library_symbol){.name = name,
                         .defined = s.st_shndx != SHN_UNDEF,
                         .datum = ELF64_ST_TYPE(s.st_info) == STT_OBJECT,
                         .size = s.st_size};
  }
}

static void read_dynamic(library_file *f, const tables *t, const Elf64_Phdr *segment) {
  for (uint64_t i = 0; i < segment->p_filesz / sizeof(Elf64_Dyn); i++) {
    Elf64_Dyn d;
    const void *from = at(f, segment->p_offset + i * sizeof d, sizeof d);
    if (!from) return;
    memcpy(&d, from, sizeof d);
    if (d.d_tag == DT_NULL) return;
    if (d.d_tag == DT_TEXTREL || (d.d_tag == DT_FLAGS && (d.d_un.d_val & DF_TEXTREL)))
      f->text_relocs = true;
    const char *name = d.d_tag == DT_NEEDED ? name_at(f, t, d.d_un.d_val) : NULL;
    if (name && f->needed_count < sizeof f->needed / sizeof *f->needed)
      f->needed[f->needed_count++] = name;
  }
}

static bool parse(library_file *f, char *why, unsigned why_size) {
  Elf64_Ehdr e;
  const void *from = at(f, 0, sizeof e);
  if (!from || memcmp(from, ELFMAG, SELFMAG) != 0) {
    snprintf(why, why_size, "not an ELF file");
    return false;
  }
  memcpy(&e, from, sizeof e);
  const uint16_t one = 1;
  unsigned char order = *(const unsigned char *)&one ? ELFDATA2LSB : ELFDATA2MSB;
  if (e.e_ident[EI_CLASS] != ELFCLASS64 || e.e_ident[EI_DATA] != order || e.e_type != ET_DYN) {
    snprintf(why, why_size, "not a 64-bit shared object of this machine's byte order");
    return false;
  }
  tables t;
  if (!find_tables(f, &e, &t)) {
    snprintf(why, why_size, "it has no readable table of dynamic symbols");
    return false;
  }
  read_symbols(f, &t);
  for (uint32_t i = 0; i < e.e_phnum; i++) {
    Elf64_Phdr p;
    from = at(f, e.e_phoff + (uint64_t)i * sizeof p, sizeof p);
    if (!from) break;
    memcpy(&p, from, sizeof p);
    if (p.p_type == PT_DYNAMIC) read_dynamic(f, &t, &p);
    if (p.p_type == PT_GNU_STACK && (p.p_flags & PF_X)) f->runs_stack = true;
  }
  return true;
}

bool library_read(library_file *f, const char *path, char *why, unsigned why_size) {
  memset(f, 0, sizeof *f);
  int file = open(path, O_RDONLY | O_CLOEXEC);
  struct stat status;
  if (file < 0 || fstat(file, &status) != 0 || status.st_size <= 0) {
    if (file >= 0) close(file);
    snprintf(why, why_size, "it cannot be read");
    return false;
  }
  f->size = (uint64_t)status.st_size;
  f->bytes = mmap(NULL, f->size, PROT_READ, MAP_PRIVATE, file, 0);
  close(file);
  if (f->bytes == MAP_FAILED) {
    snprintf(why, why_size, "it cannot be read");
    return false;
  }
  return parse(f, why, why_size);
}
