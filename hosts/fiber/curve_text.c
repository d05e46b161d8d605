/* SPDX-License-Identifier: Apache-2.0
 * Curves as text: USD, OBJ, pbrt. */
#include <math.h>
#include "curve_files.h"
#include "srgb.h"
#include "text_file.h"

static void put_triple(text_file *t, const float *v, const char *between) {
  for (int c = 0; c < 3; c++) {
    if (c) text_put(t, between);
    text_finest(t, (double)v[c]);
  }
}

/* ---- USD --------------------------------------------------------------- */

static void put_extent(text_file *t, const sozai_curves *c) {
  float low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  for (uint64_t i = 0; i < c->point_count; i++) {
    for (int a = 0; a < 3; a++) {
      float x = c->points[3 * i + (uint64_t)a], r = c->radii[i];
      if (i == 0 || x - r < low[a]) low[a] = x - r;
      if (i == 0 || x + r > high[a]) high[a] = x + r;
    }
  }
  text_put(t, "    float3[] extent = [(");
  put_triple(t, low, ", ");
  text_put(t, "), (");
  put_triple(t, high, ", ");
  text_put(t, ")]\n");
}

static void put_look(text_file *t, const sozai_curves *c) {
  text_put(t, "    color3f[] primvars:displayColor = [");
  for (uint32_t k = 0; k < c->part_count; k++) {
    for (uint64_t i = 0; i < c->parts[k].count; i++) {
      text_put(t, k || i ? ", (" : "(");
      for (int a = 0; a < 3; a++) {
        if (a) text_put(t, ", ");
        text_fine(t, srgb_to_linear((double)c->parts[k].colour[a]));
      }
      text_put(t, ")");
    }
  }
  text_put(t, "] (\n        interpolation = \"uniform\"\n    )\n    int[] primvars:id = [");
  for (uint64_t i = 0; i < c->curve_count; i++) {
    if (i) text_put(t, ", ");
    text_whole(t, c->ids[i]);
  }
  text_put(t, "] (\n        interpolation = \"uniform\"\n    )\n");
}

bool curves_write_usda(const sozai_curves *c, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "#usda 1.0\n(\n    defaultPrim = \"fiber\"\n    doc = \"sozai fiber\"\n"
               "    metersPerUnit = 0.001\n    upAxis = \"Y\"\n)\n\ndef BasisCurves \"fiber\"\n{\n"
               "    uniform token type = \"linear\"\n    uniform token wrap = \"nonperiodic\"\n");
  put_extent(&t, c);
  text_put(&t, "    int[] curveVertexCounts = [");
  for (uint64_t i = 0; i < c->curve_count; i++) {
    if (i) text_put(&t, ", ");
    text_whole(&t, c->first[i + 1] - c->first[i]);
  }
  text_put(&t, "]\n    point3f[] points = [");
  for (uint64_t i = 0; i < c->point_count; i++) {
    text_put(&t, i ? ", (" : "(");
    put_triple(&t, c->points + 3 * i, ", ");
    text_put(&t, ")");
  }
  text_put(&t, "]\n    float[] widths = [");
  for (uint64_t i = 0; i < c->point_count; i++) {
    if (i) text_put(&t, ", ");
    text_finest(&t, 2 * (double)c->radii[i]);
  }
  text_put(&t, "] (\n        interpolation = \"vertex\"\n    )\n");
  put_look(&t, c);
  text_put(&t, "}\n");
  return text_close(&t, why);
}

/* ---- OBJ --------------------------------------------------------------- */

bool curves_write_obj(const sozai_curves *c, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "# sozai fiber; millimetres, +y up\n");
  for (uint64_t i = 0; i < c->point_count; i++) {
    text_put(&t, "v ");
    put_triple(&t, c->points + 3 * i, " ");
    text_put(&t, "\n");
  }
  for (uint32_t k = 0; k < c->part_count; k++) {
    const sozai_part *part = &c->parts[k];
    text_put(&t, "g ");
    text_put(&t, part->id);
    text_put(&t, "\nusemtl ");
    text_put(&t, part->id);
    text_put(&t, "\n");
    for (uint64_t i = part->first; i < part->first + part->count; i++) {
      text_put(&t, "l");
      for (uint64_t p = c->first[i]; p < c->first[i + 1]; p++) {
        text_put(&t, " ");
        text_whole(&t, p + 1);
      }
      text_put(&t, "\n");
    }
  }
  return text_close(&t, why);
}

/* ---- pbrt -------------------------------------------------------------- */

/* Control points of segment i: a third of the way along the tangents that
 * Catmull and Rom give the points. */
static void controls(const sozai_curves *c, uint64_t begin, uint64_t end, uint64_t i,
                     float out[9]) {
  const float *p = c->points;
  for (uint64_t a = 0; a < 3; a++) {
    float before = p[3 * (i > begin ? i - 1 : i) + a], from = p[3 * i + a], to = p[3 * (i + 1) + a];
    float after = p[3 * (i + 2 < end ? i + 2 : i + 1) + a];
    out[a] = from + (to - before) / 6;
    out[3 + a] = to - (after - from) / 6;
    out[6 + a] = to;
  }
}

static void put_shape(text_file *t, const sozai_curves *c, uint64_t begin, uint64_t end,
                      uint64_t from, uint64_t to) {
  text_put(t, "Shape \"curve\" \"string type\" \"cylinder\" \"string basis\" \"bezier\" "
              "\"integer degree\" 3\n  \"point3 P\" [");
  put_triple(t, c->points + 3 * from, " ");
  for (uint64_t i = from; i < to; i++) {
    float p[9];
    controls(c, begin, end, i, p);
    for (int k = 0; k < 3; k++) {
      text_put(t, " ");
      put_triple(t, p + 3 * k, " ");
    }
  }
  text_put(t, "]\n  \"float width0\" ");
  text_finest(t, 2 * (double)c->radii[from]);
  text_put(t, " \"float width1\" ");
  text_finest(t, 2 * (double)c->radii[to]);
  text_put(t, "\n");
}

/* A curve's width runs evenly from one end to the other: as many shapes as the
 * radii have straight stretches. */
static void put_curve(text_file *t, const sozai_curves *c, uint64_t begin, uint64_t end) {
  uint64_t from = begin;
  for (uint64_t i = begin + 1; i < end; i++) {
    float step = c->radii[i] - c->radii[i - 1];
    bool last = i + 1 == end;
    bool even = !last && fabsf(c->radii[i + 1] - c->radii[i] - step) <= 1e-3f * c->radii[i];
    if (even) continue;
    put_shape(t, c, begin, end, from, i);
    from = i;
  }
}

bool curves_write_pbrt(const sozai_curves *c, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "# sozai fiber; millimetres, +y up\n");
  for (uint32_t k = 0; k < c->part_count; k++) {
    const sozai_part *part = &c->parts[k];
    text_put(&t, "AttributeBegin\nMaterial \"hair\" \"rgb color\" [");
    for (int a = 0; a < 3; a++) {
      if (a) text_put(&t, " ");
      text_fine(&t, srgb_to_linear((double)part->colour[a]));
    }
    text_put(&t, "]\n");
    for (uint64_t i = part->first; i < part->first + part->count; i++)
      put_curve(&t, c, c->first[i], c->first[i + 1]);
    text_put(&t, "AttributeEnd\n");
  }
  return text_close(&t, why);
}
