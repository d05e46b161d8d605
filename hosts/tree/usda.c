/* SPDX-License-Identifier: Apache-2.0
 * USD as text: a Mesh with a GeomSubset for each part, or BasisCurves, whose
 * widths are diameters. metersPerUnit says that it is in millimetres. */
#include "growth.h"
#include "text_file.h"

static void put_points(text_file *t, const float *v, uint64_t count, int each, bool fine) {
  text_put(t, "[");
  for (uint64_t i = 0; i < count; i++) {
    text_put(t, i ? ", (" : "(");
    for (int c = 0; c < each; c++) {
      if (c) text_put(t, ", ");
      double x = (double)v[(uint64_t)each * i + (uint64_t)c];
      if (fine)
        text_fine(t, x);
      else
        text_number(t, x);
    }
    text_put(t, ")");
  }
  text_put(t, "]");
}

static void put_extent(text_file *t, const float *v, uint64_t count, double margin) {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  for (uint64_t i = 0; i < count; i++)
    for (int c = 0; c < 3; c++) {
      double x = (double)v[3 * i + (uint64_t)c];
      if (i == 0 || x < low[c]) low[c] = x;
      if (i == 0 || x > high[c]) high[c] = x;
    }
  text_put(t, "        float3[] extent = [(");
  for (int c = 0; c < 3; c++) {
    if (c) text_put(t, ", ");
    text_number(t, low[c] - margin);
  }
  text_put(t, "), (");
  for (int c = 0; c < 3; c++) {
    if (c) text_put(t, ", ");
    text_number(t, high[c] + margin);
  }
  text_put(t, ")]\n");
}

/* displayColor is scene-linear. */
static double linear(float code) {
  double x = (double)code;
  if (x <= 0.04045) return x / 12.92;
  double y = (x + 0.055) / 1.055; /* y^2.4 = y^2 * (y^2)^(1/5), by Newton's steps */
  double root = y > 0.1 ? y : 0.1;
  for (int i = 0; i < 30; i++)
    root -= (root * root * root * root * root - y * y) / (5 * root * root * root * root);
  return y * y * root;
}

static void put_colour(text_file *t, const float *colour, bool first) {
  text_put(t, first ? "(" : ", (");
  for (int c = 0; c < 3; c++) {
    if (c) text_put(t, ", ");
    text_number(t, linear(colour[c]));
  }
  text_put(t, ")");
}

/* colours: of each point; NULL: each face, or curve, has its part's. */
static void put_colours(text_file *t, const sozai_part *parts, uint32_t count, const float *colours,
                        uint64_t points) {
  text_put(t, "        color3f[] primvars:displayColor = [");
  for (uint64_t i = 0; colours && i < points; i++) put_colour(t, &colours[3 * i], i == 0);
  for (uint32_t k = 0; !colours && k < count; k++)
    for (uint64_t i = 0; i < parts[k].count; i++) put_colour(t, parts[k].colour, !k && !i);
  text_put(t, "] (\n            interpolation = \"");
  text_put(t, colours ? "vertex" : "uniform");
  text_put(t, "\"\n        )\n");
}

static void put_mesh(text_file *t, const sozai_mesh *m) {
  text_put(t, "    def Mesh \"mesh\"\n    {\n");
  text_put(t, "        uniform token subdivisionScheme = \"none\"\n");
  text_put(t, "        uniform bool doubleSided = 1\n");
  put_extent(t, m->points, m->point_count, 0);
  text_put(t, "        int[] faceVertexCounts = [");
  for (uint64_t i = 0; i < m->triangle_count; i++) text_put(t, i ? ", 3" : "3");
  text_put(t, "]\n        int[] faceVertexIndices = [");
  for (uint64_t i = 0; i < 3 * m->triangle_count; i++) {
    if (i) text_put(t, ", ");
    text_whole(t, m->indices[i]);
  }
  text_put(t, "]\n        point3f[] points = ");
  put_points(t, m->points, m->point_count, 3, false);
  text_put(t, "\n        normal3f[] normals = ");
  put_points(t, m->normals, m->point_count, 3, true);
  text_put(t, " (\n            interpolation = \"vertex\"\n        )\n");
  text_put(t, "        texCoord2f[] primvars:st = ");
  put_points(t, m->uv, m->point_count, 2, true);
  text_put(t, " (\n            interpolation = \"vertex\"\n        )\n");
  put_colours(t, m->parts, m->part_count, growth_mesh_colours(m), m->point_count);
  for (uint32_t k = 0; k < m->part_count; k++) {
    const sozai_part *part = &m->parts[k];
    text_put(t, "\n        def GeomSubset \"");
    text_put(t, part->id);
    text_put(t, "\"\n        {\n            uniform token elementType = \"face\"\n"
                "            uniform token familyName = \"materialBind\"\n"
                "            int[] indices = [");
    for (uint64_t i = 0; i < part->count; i++) {
      if (i) text_put(t, ", ");
      text_whole(t, part->first + i);
    }
    text_put(t, "]\n        }\n");
  }
  text_put(t, "    }\n");
}

static void put_curves(text_file *t, const sozai_curves *c) {
  double widest = 0;
  for (uint64_t i = 0; i < c->point_count; i++)
    if ((double)c->radii[i] > widest) widest = (double)c->radii[i];
  text_put(t, "    def BasisCurves \"curves\"\n    {\n");
  text_put(
      t, "        uniform token type = \"linear\"\n        uniform token wrap = \"nonperiodic\"\n");
  put_extent(t, c->points, c->point_count, widest);
  text_put(t, "        int[] curveVertexCounts = [");
  for (uint64_t i = 0; i < c->curve_count; i++) {
    if (i) text_put(t, ", ");
    text_whole(t, c->first[i + 1] - c->first[i]);
  }
  text_put(t, "]\n        point3f[] points = ");
  put_points(t, c->points, c->point_count, 3, false);
  text_put(t, "\n        float[] widths = [");
  for (uint64_t i = 0; i < c->point_count; i++) {
    if (i) text_put(t, ", ");
    text_number(t, 2 * (double)c->radii[i]);
  }
  text_put(t, "] (\n            interpolation = \"vertex\"\n        )\n");
  put_colours(t, c->parts, c->part_count, growth_curves_colours(c), c->point_count);
  text_put(t, "    }\n");
}

bool write_usda(const sozai_mesh *m, const sozai_curves *c, const char *path, failure *why) {
  text_file t;
  if (!text_open(&t, path, why)) return false;
  text_put(&t, "#usda 1.0\n(\n    defaultPrim = \"tree\"\n    doc = \"sozai tree\"\n"
               "    metersPerUnit = 0.001\n    upAxis = \"Y\"\n)\n\ndef Xform \"tree\"\n{\n");
  if (m) put_mesh(&t, m);
  if (c) put_curves(&t, c);
  text_put(&t, "}\n");
  return text_close(&t, why);
}
