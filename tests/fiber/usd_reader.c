/* SPDX-License-Identifier: Apache-2.0
 * The .usda of BasisCurves, and the v and l of OBJ: by their specifications. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "readers.h"

static char *text_of(const char *path) {
  FILE *f = fopen(path, "rb");
  if (!f) return NULL;
  fseek(f, 0, SEEK_END);
  long size = ftell(f);
  rewind(f);
  char *text = malloc((size_t)size + 1);
  size_t n = fread(text, 1, (size_t)size, f);
  text[n] = 0;
  fclose(f);
  return text;
}

/* The numbers between [ and ] of the attribute of that type and name. */
static double *numbers(const char *text, const char *attribute, uint32_t *count) {
  const char *at = strstr(text, attribute);
  *count = 0;
  if (!at || !(at = strchr(at, '['))) return NULL;
  if (at[1] == ']') at = strchr(at + 1, '['); /* the type's own */
  const char *end = at ? strchr(at, ']') : NULL;
  if (!end) return NULL;
  size_t room = 1024;
  double *out = malloc(room * sizeof *out);
  while (at < end) {
    while (at < end && strchr("[](), \n\t", *at)) at++;
    if (at >= end) break;
    char *next;
    if (*count == room) out = realloc(out, (room *= 2) * sizeof *out);
    out[(*count)++] = strtod(at, &next);
    if (next == at) break;
    at = next;
  }
  return out;
}

bool read_usd(strands_read *s, const char *path) {
  memset(s, 0, sizeof *s);
  char *text = text_of(path);
  if (!text) return false;
  bool ok = strncmp(text, "#usda 1.0", 9) == 0 && strstr(text, "def BasisCurves \"") &&
            strstr(text, "uniform token type = \"linear\"") &&
            strstr(text, "metersPerUnit = 0.001") && strstr(text, "upAxis = \"Y\"");
  uint32_t points, widths, ids, colours;
  double *n = numbers(text, "int[] curveVertexCounts", &s->curves);
  double *p = numbers(text, "point3f[] points", &points),
         *w = numbers(text, "float[] widths", &widths);
  double *i = numbers(text, "int[] primvars:id", &ids);
  double *c = numbers(text, "color3f[] primvars:displayColor", &colours);
  s->points = points / 3;
  ok = ok && n && p && w && i && c && points == 3 * widths && ids == s->curves &&
       colours == 3 * s->curves;
  uint64_t total = 0;
  if (ok) {
    s->counts = malloc((s->curves + 1) * sizeof *s->counts);
    s->ids = malloc((s->curves + 1) * sizeof *s->ids);
    s->at = malloc((points + 1) * sizeof *s->at);
    s->widths = malloc((widths + 1) * sizeof *s->widths);
    for (uint32_t k = 0; k < s->curves; k++) total += s->counts[k] = (uint32_t)n[k];
    for (uint32_t k = 0; k < s->curves; k++) s->ids[k] = (uint32_t)i[k];
    for (uint32_t k = 0; k < points; k++) s->at[k] = (float)p[k];
    for (uint32_t k = 0; k < widths; k++) s->widths[k] = (float)w[k];
    for (int k = 0; k < 3; k++) s->colour[k] = (float)c[k];
  }
  free(n), free(p), free(w), free(i), free(c), free(text);
  return ok && total == s->points;
}

bool read_obj(strands_read *s, const char *path) {
  memset(s, 0, sizeof *s);
  char *text = text_of(path);
  if (!text) return false;
  size_t lines = 1;
  for (char *c = text; *c; c++) lines += *c == '\n';
  s->at = malloc(3 * lines * sizeof *s->at);
  s->counts = malloc(lines * sizeof *s->counts);
  uint32_t next = 1;
  bool ok = true;
  for (char *rest = text, *line; (line = strtok_r(rest, "\n", &rest));) {
    if (line[0] == 'v' && line[1] == ' ') {
      float *to = s->at + 3 * (size_t)s->points++;
      ok = ok && sscanf(line, "v %f %f %f", to, to + 1, to + 2) == 3;
    } else if (line[0] == 'l' && line[1] == ' ') {
      uint32_t n = 0;
      for (char *at = line + 1, *end;; at = end, n++) {
        unsigned long index = strtoul(at, &end, 10);
        if (end == at) break;
        ok = ok && index == next++;
      }
      s->counts[s->curves++] = n;
    }
  }
  free(text);
  return ok && next == s->points + 1;
}
