/* SPDX-License-Identifier: Apache-2.0 */
#include "montage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIDE 3 /* samples along a pixel's side */
#define INPUTS 16
#define OUTPUTS 7 /* albedo, radiance, joint */

/* The projective map from picture to plane: eight numbers, the ninth is 1. By
 * Gaussian elimination with pivots. */
static bool solve(double a[8][9], double out[9]) {
  for (int c = 0; c < 8; c++) {
    int best = c;
    for (int r = c + 1; r < 8; r++)
      if (fabs(a[r][c]) > fabs(a[best][c])) best = r;
    if (fabs(a[best][c]) < 1e-12) return false;
    for (int k = 0; k < 9; k++) {
      double t = a[c][k];
      a[c][k] = a[best][k];
      a[best][k] = t;
    }
    for (int r = 0; r < 8; r++) {
      double f = r == c ? 0 : a[r][c] / a[c][c];
      for (int k = c; k < 9; k++) a[r][k] -= f * a[c][k];
    }
  }
  for (int c = 0; c < 8; c++) out[c] = a[c][8] / a[c][c];
  out[8] = 1;
  return true;
}

static bool map_of(const montage *m, double h[9]) {
  const double plane[4][2] = {{0, 0}, {m->length, 0}, {m->length, m->width}, {0, m->width}};
  double a[8][9] = {{0}};
  for (int i = 0; i < 4; i++) {
    double x = m->corner[i][0], y = m->corner[i][1];
    for (int k = 0; k < 2; k++) {
      double *row = a[2 * i + k];
      row[3 * k] = x;
      row[3 * k + 1] = y;
      row[3 * k + 2] = 1;
      row[6] = -x * plane[i][k];
      row[7] = -y * plane[i][k];
      row[8] = plane[i][k];
    }
  }
  return solve(a, h);
}

static void apply(const double h[9], double x, double y, double out[2]) {
  double w = h[6] * x + h[7] * y + h[8];
  out[0] = (h[0] * x + h[1] * y + h[2]) / w;
  out[1] = (h[3] * x + h[4] * y + h[5]) / w;
}

/* The side of the square of the same area that a sample stands for, mm. */
static double footprint_at(const double h[9], double x, double y) {
  double o[2], a[2], b[2];
  apply(h, x, y, o);
  apply(h, x + 0.5, y, a);
  apply(h, x, y + 0.5, b);
  double area = (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  return sqrt(fabs(area) * 4) / SIDE;
}

typedef struct row {
  uint32_t count, *pixel;
  float *in, *out;
} row;

static bool find(const sozai_texture_info *info, const char *id, uint32_t *first) {
  for (uint32_t i = 0; i < info->channel_count; i++) {
    if (strcmp(info->channels[i]->id, id) != 0) continue;
    *first = info->channels[i]->first;
    return true;
  }
  return false;
}

/* One row's samples on the plane. */
static void gather(const montage *m, const double h[9], uint32_t y, uint32_t width, row *r,
                   montage_report *report) {
  size_t room = (size_t)width * SIDE * SIDE;
  r->count = 0;
  for (uint32_t x = 0; x < width; x++) {
    for (int k = 0; k < SIDE * SIDE; k++) {
      double px = x + (k % SIDE + 0.5) / SIDE, py = y + (k / SIDE + 0.5) / SIDE, p[2];
      double w = h[6] * px + h[7] * py + h[8];
      double w0 = h[6] * m->corner[0][0] + h[7] * m->corner[0][1] + h[8];
      apply(h, px, py, p);
      if (w * w0 <= 0 || p[0] < 0 || p[1] < 0 || p[0] > m->length || p[1] > m->width) continue;
      uint32_t at = r->count++;
      double s = footprint_at(h, px, py);
      report->footprint[0] = fmin(report->footprint[0], s);
      report->footprint[1] = fmax(report->footprint[1], s);
      r->pixel[at] = x;
      const double v[INPUTS] = {p[0],
                                p[1],
                                0,
                                0,
                                0,
                                1,
                                m->light[0],
                                m->light[1],
                                m->light[2],
                                m->light_colour[0],
                                m->light_colour[1],
                                m->light_colour[2],
                                m->view[0],
                                m->view[1],
                                m->view[2],
                                s};
      for (size_t c = 0; c < INPUTS; c++) r->in[c * room + at] = (float)v[c];
    }
  }
}

static bool paint_row(const montage *m, const sozai_textures_1 *textures,
                      const sozai_texture *texture, const row *r, uint32_t width, float *rgb,
                      montage_report *report, failure *why) {
  const sozai_texture_info *info = textures->info_of(texture);
  size_t room = (size_t)width * SIDE * SIDE;
  uint32_t albedo, radiance, joint;
  if (!find(info, "albedo", &albedo) || !find(info, "radiance", &radiance) ||
      !find(info, "joint", &joint))
    return fail(why, EXIT_FAILURE, "the material has no albedo, radiance or joint");
  float **out = calloc(info->component_count, sizeof *out);
  if (!out) return fail(why, EXIT_FAILURE, "out of memory");
  for (uint32_t c = 0; c < 3; c++) {
    out[albedo + c] = r->out + c * room;
    out[radiance + c] = r->out + (3 + c) * room;
  }
  out[joint] = r->out + 6 * room;
  sozai_batch b = {.size = sizeof b,
                   .count = r->count,
                   .footprint = r->in + 15 * room,
                   .out = out,
                   .out_count = info->component_count};
  for (size_t c = 0; c < 3; c++) {
    b.point[c] = r->in + c * room;
    b.normal[c] = r->in + (3 + c) * room;
    b.light[c] = r->in + (6 + c) * room;
    b.light_colour[c] = r->in + (9 + c) * room;
    b.view[c] = r->in + (12 + c) * room;
  }
  int32_t result = r->count ? textures->evaluate(texture, &b) : SOZAI_OK;
  free(out);
  if (result != SOZAI_OK) return fail(why, EXIT_FAILURE, "evaluate: %s", textures->last_error());
  const float share = 1.0f / (SIDE * SIDE);
  for (uint32_t i = 0; i < r->count;) {
    float *to = rgb + 3 * r->pixel[i], sum[3] = {0, 0, 0};
    uint32_t from = i, pixel = r->pixel[i];
    for (; i < r->count && r->pixel[i] == pixel; i++) {
      for (size_t c = 0; c < 3; c++) {
        float a = r->out[c * room + i];
        sum[c] += r->out[(3 + c) * room + i] + a * (float)m->sky[c];
        report->albedo[c] += (double)a;
      }
      report->joint += (double)r->out[6 * room + i];
    }
    float part = (float)(i - from) * share;
    for (int c = 0; c < 3; c++) to[c] = to[c] * (1 - part) + sum[c] * share;
    report->pixels++;
  }
  return true;
}

bool montage_paint(const montage *m, const sozai_textures_1 *textures, const sozai_texture *texture,
                   float *rgb, uint32_t width, uint32_t height, montage_report *report,
                   failure *why) {
  double h[9];
  *report = (montage_report){.footprint = {1e30, 0}};
  if (!map_of(m, h)) return fail(why, EXIT_BAD_INPUT, "montage: the four points lie on a line");
  const double plane[4][2] = {{0, 0}, {m->length, 0}, {m->length, m->width}, {0, m->width}};
  for (int i = 0; i < 4; i++) {
    double p[2];
    apply(h, m->corner[i][0], m->corner[i][1], p);
    report->corner_error =
        fmax(report->corner_error, hypot(p[0] - plane[i][0], p[1] - plane[i][1]));
  }
  size_t room = (size_t)width * SIDE * SIDE;
  row r = {.pixel = malloc(room * sizeof *r.pixel),
           .in = malloc(room * INPUTS * sizeof *r.in),
           .out = malloc(room * OUTPUTS * sizeof *r.out)};
  bool ok = (r.pixel && r.in && r.out) || fail(why, EXIT_FAILURE, "out of memory");
  double samples = 0;
  for (uint32_t y = 0; ok && y < height; y++) {
    gather(m, h, y, width, &r, report);
    samples += r.count;
    ok = paint_row(m, textures, texture, &r, width, rgb + 3 * (size_t)y * width, report, why);
  }
  for (int c = 0; samples > 0 && c < 3; c++) report->albedo[c] /= samples;
  if (samples > 0) report->joint /= samples;
  free(r.pixel);
  free(r.in);
  free(r.out);
  return ok;
}
