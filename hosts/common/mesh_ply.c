/* SPDX-License-Identifier: Apache-2.0 */
#include "mesh_ply.h"
#include "ceilings.h"
#include "mesh_ply_parts.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static ply_type type_of(const char *name) {
  static const struct {
    const char *name;
    ply_type type;
  } all[] = {{"char", PLY_INT8},       {"int8", PLY_INT8},     {"uchar", PLY_UINT8},
             {"uint8", PLY_UINT8},     {"short", PLY_INT16},   {"int16", PLY_INT16},
             {"ushort", PLY_UINT16},   {"uint16", PLY_UINT16}, {"int", PLY_INT32},
             {"int32", PLY_INT32},     {"uint", PLY_UINT32},   {"uint32", PLY_UINT32},
             {"float", PLY_FLOAT},     {"float32", PLY_FLOAT}, {"double", PLY_DOUBLE},
             {"double64", PLY_DOUBLE}, {"float64", PLY_DOUBLE}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (strcmp(name, all[i].name) == 0) return all[i].type;
  return PLY_NONE;
}

static bool add_element(ply_header *h, const char *name, double count, failure *why) {
  bool points = strcmp(name, "vertex") == 0, strips = strcmp(name, "tristrips") == 0;
  bool faces = strips || strcmp(name, "face") == 0;
  if (!(count >= 0 && count <= h->bytes))
    return fail(why, EXIT_BAD_INPUT, "%s: a header of %.0f '%s' in a file of %.0f bytes", h->path,
                count, name, h->bytes);
  /* Assimp makes room for the first alone */
  if ((points && h->has_points) || (faces && h->has_faces))
    return fail(why, EXIT_BAD_INPUT, "%s: a header with '%s' after others of its kind", h->path,
                name);
  h->has_points = h->has_points || points;
  h->has_faces = h->has_faces || faces;
  if (points) h->points = count;
  ply_row *row = &h->rows[h->count++];
  *row = (ply_row){.element = true, .faces = faces, .strips = strips, .count = (uint64_t)count};
  memcpy(row->name, name, strlen(name) + 1);
  return true;
}

static bool add_property(ply_header *h, const char *line, failure *why) {
  char list[64] = "", type[64] = "";
  ply_row *row = &h->rows[h->count];
  *row = (ply_row){.element = false};
  bool is_list = sscanf(line, " property list %63s %63s %63s", list, type, row->name) == 3;
  if (!is_list && sscanf(line, " property %63s %63s", type, row->name) != 2) *type = '\0';
  row->list = is_list ? type_of(list) : PLY_NONE;
  row->type = type_of(type);
  if (h->count == 0 || !row->type || (is_list && !row->list))
    return fail(why, EXIT_BAD_INPUT, "%s: a header with a property of no known type: '%.60s'",
                h->path, line);
  h->count++;
  return true;
}

static bool add_format(ply_header *h, const char *name, failure *why) {
  static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  for (int i = 0; i < 3; i++)
    if (strcmp(name, names[i]) == 0) {
      h->format = (ply_format)i;
      return true;
    }
  return fail(why, EXIT_BAD_INPUT, "%s: '%s' is no format of a PLY file", h->path, name);
}

static bool add_line(ply_header *h, char *line, failure *why) {
  char name[64];
  double count;
  line[strcspn(line, "\r\n")] = '\0';
  if (sscanf(line, " element %63s %lf", name, &count) == 2) return add_element(h, name, count, why);
  if (sscanf(line, " format %63s", name) == 1) return add_format(h, name, why);
  return sscanf(line, " property %63s", name) != 1 || add_property(h, line, why);
}

/* false at the file's end. What is beyond the room is passed over: a comment's. */
static bool next_line(FILE *file, char *line, int room) {
  if (!fgets(line, room, file)) return false;
  int c = strchr(line, '\n') ? '\n' : 0;
  while (c != '\n' && c != EOF) c = getc(file);
  return true;
}

static bool read_header(ply_header *h, FILE *file, failure *why) {
  char line[512];
  for (int i = 0; i < PLY_MOST_LINES && next_line(file, line, sizeof line); i++) {
    if (strncmp(line, "end_header", 10) == 0) return true;
    if (!add_line(h, line, why)) return false;
  }
  return fail(why, EXIT_BAD_INPUT, "%s: a PLY file without an end of its header", h->path);
}

static bool check(FILE *file, const char *path, double bytes, failure *why) {
  ply_header h = {.path = path, .bytes = bytes};
  h.rows = calloc(PLY_MOST_LINES, sizeof *h.rows);
  if (!h.rows) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = read_header(&h, file, why) && mesh_ply_indices(&h, file, why);
  free(h.rows);
  return ok;
}

bool mesh_ply_plausible(const char *path, failure *why) {
  FILE *file = fopen(path, "rb");
  struct stat status;
  char magic[4] = "";
  bool ok = true;
  if (file && fstat(fileno(file), &status) == 0 && S_ISREG(status.st_mode) &&
      fread(magic, 1, 3, file) == 3 && strcasecmp(magic, "ply") == 0)
    ok = check(file, path, (double)status.st_size, why);
  if (file) fclose(file);
  return ok;
}
