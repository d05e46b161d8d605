/* SPDX-License-Identifier: Apache-2.0
 * A PLY file's values, read for the sake of its faces' corners. As Assimp reads
 * them: in a text every element is a line. */
#include "mesh_ply_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "numbers.h"

typedef struct values {
  const ply_header *header;
  FILE *file;
  const ply_row *element;
  uint64_t at; /* which of the element's, from 0 */
  char *line, *rest;
  size_t room;
} values;

static bool amiss(const values *v, const char *what, failure *why) {
  return fail(why, EXIT_BAD_INPUT, "%s: '%s' %llu %s", v->header->path, v->element->name,
              (unsigned long long)v->at, what);
}

static bool is_whole(const char *text) {
  text += *text == '-' || *text == '+';
  return *text && text[strspn(text, "0123456789")] == '\0';
}

/* As numbers go: what of a vertex must be finite is checked with its name. */
static bool is_number(const char *text) {
  static const char *const odd[] = {"nan", "inf", "infinity"};
  double number;
  const char *word = text + (*text == '-' || *text == '+');
  for (size_t i = 0; i < sizeof odd / sizeof *odd; i++)
    if (strcasecmp(word, odd[i]) == 0) return true;
  return number_read(text, &number);
}

static bool text_value(values *v, ply_type type, double *out, failure *why) {
  char *word = strtok_r(NULL, " \t\r\n", &v->rest);
  if (!word) return amiss(v, "has fewer values than the header says", why);
  if (type < PLY_FLOAT ? !is_whole(word) : !is_number(word))
    return amiss(v, "has a value that is not of its type", why);
  *out = strtod(word, NULL); /* counts and indices are digits alone, if they are to be of use */
  return true;
}

static double number_of(ply_type type, uint64_t bits) {
  uint32_t word = (uint32_t)bits;
  float single;
  double number;
  switch (type) {
  case PLY_INT8:
    return (int8_t)bits;
  case PLY_INT16:
    return (int16_t)bits;
  case PLY_INT32:
    return (int32_t)bits;
  case PLY_FLOAT:
    memcpy(&single, &word, sizeof single);
    return (double)single;
  case PLY_DOUBLE:
    memcpy(&number, &bits, sizeof number);
    return number;
  default:
    return (double)bits;
  }
}

static bool binary_value(values *v, ply_type type, double *out, failure *why) {
  static const size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  unsigned char bytes[8];
  size_t size = sizes[type];
  if (fread(bytes, 1, size, v->file) != size) return amiss(v, "is beyond the file's end", why);
  uint64_t bits = 0;
  for (size_t i = 0; i < size; i++)
    bits = bits << 8 | bytes[v->header->format == PLY_BIG ? i : size - 1 - i];
  *out = number_of(type, bits);
  return true;
}

static bool value(values *v, ply_type type, double *out, failure *why) {
  return v->header->format == PLY_ASCII ? text_value(v, type, out, why)
                                        : binary_value(v, type, out, why);
}

static bool check_corner(const values *v, double corner, failure *why) {
  if ((corner >= 0 && corner < v->header->points) || (v->element->strips && corner == -1))
    return true;
  return fail(why, EXIT_BAD_INPUT, "%s: '%s' %llu has vertex index %.10g, of %.0f vertices from 0",
              v->header->path, v->element->name, (unsigned long long)v->at, corner,
              v->header->points);
}

static bool read_list(values *v, const ply_row *p, failure *why) {
  double count, number;
  if (!value(v, p->list, &count, why)) return false;
  if (!(count >= 0 && count <= v->header->bytes))
    return amiss(v, "has a list longer than the file", why);
  bool corners = v->element->faces && strncmp(p->name, "vertex_ind", 10) == 0;
  if (corners && count < 1 && !v->element->strips) return amiss(v, "has no corner", why);
  for (uint64_t i = 0; i < (uint64_t)count; i++)
    if (!value(v, p->type, &number, why) || (corners && !check_corner(v, number, why)))
      return false;
  return true;
}

static bool next_line(values *v, failure *why) {
  if (v->header->format != PLY_ASCII) return true;
  if (getline(&v->line, &v->room, v->file) < 0) return amiss(v, "is beyond the file's end", why);
  v->rest = v->line;
  return true;
}

/* Assimp reads what is no number of a text as 0. Normals and UVs may be none. */
static bool check_coordinate(const values *v, const ply_row *p, double at, failure *why) {
  bool coordinate = strcmp(v->element->name, "vertex") == 0 && strchr("xyz", p->name[0]) &&
                    p->name[0] && !p->name[1];
  if (!coordinate || isfinite(at)) return true;
  return fail(why, EXIT_BAD_INPUT, "%s: %s of vertex %llu is %g, which is no place",
              v->header->path, p->name, (unsigned long long)v->at, at);
}

static bool read_one(values *v, const ply_row *p, failure *why) {
  double number;
  return value(v, p->type, &number, why) && check_coordinate(v, p, number, why);
}

static bool read_element(values *v, const ply_row *end, failure *why) {
  if (!next_line(v, why)) return false;
  for (const ply_row *p = v->element + 1; p < end; p++)
    if (!(p->list ? read_list(v, p, why) : read_one(v, p, why))) return false;
  return true;
}

bool mesh_ply_indices(const ply_header *h, FILE *file, failure *why) {
  values v = {.header = h, .file = file};
  const ply_row *end = h->rows, *last = h->rows + h->count;
  bool ok = true;
  while (ok && end < last) {
    v.element = end++;
    while (end < last && !end->element) end++;
    /* of none that has values nothing is read, though of many */
    uint64_t count = end > v.element + 1 || h->format == PLY_ASCII ? v.element->count : 0;
    for (v.at = 0; ok && v.at < count; v.at++) ok = read_element(&v, end, why);
  }
  free(v.line);
  return ok;
}
