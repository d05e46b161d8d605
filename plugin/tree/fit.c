/* SPDX-License-Identifier: Apache-2.0
 *
 * Section 3 of the paper as arithmetic: crown a by least squares, divergence,
 * turns and branches a turn; and a plan that grows siblings of a measured tree.
 */
#include "../core/scalar.h"
#include "../core/status.h"
#include "field.h"

#define LEAST 3u /* branches */
#define BRANCHES_MOST 4096u

static double turned(double degrees) {
  while (degrees < 0.0) degrees += 360.0;
  while (degrees >= 360.0) degrees -= 360.0;
  return degrees;
}

/* Of y = a x, x = (1 - z)^b: sum xy / sum xx, on one side of the slope or both. */
static double slope_of(const fit_branch *list, uint32_t count, double height, double upslope,
                       double b, int side) {
  double xy = 0.0, xx = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    double off = turned(list[i].azimuth - upslope);
    int down = off > 90.0 && off < 270.0;
    if (side >= 0 && side != down) continue;
    double x = tree_power(1.0 - list[i].z / height, b), y = list[i].length / height;
    xy += x * y;
    xx += x * x;
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

void fit_branches(field_fit *out, const fit_branch *list, uint32_t count, double height,
                  double years, double upslope, double b) {
  *out = (field_fit){.height = height, .count = count, .least = 360.0};
  out->a = slope_of(list, count, height, upslope, b, -1);
  out->a_up = slope_of(list, count, height, upslope, b, 0);
  out->a_down = slope_of(list, count, height, upslope, b, 1);
  double sum = 0.0, squares = 0.0, residual = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    double x = tree_power(1.0 - list[i].z / height, b);
    double off = x > 0.0 && out->a > 0.0 ? list[i].length / height / (out->a * x) - 1.0 : 0.0;
    residual += off * off;
    if (i == 0) continue;
    double d = turned(list[i].azimuth - list[i - 1].azimuth);
    sum += d;
    squares += d * d;
    if (d < out->least) out->least = d;
    if (d > out->most) out->most = d;
  }
  if (count > 0) out->rms = scalar_root(residual / count);
  if (count < 2) return;
  double n = count - 1;
  out->mean = sum / n;
  if (n > 1) out->sd = scalar_root((squares - sum * sum / n) / (n - 1.0));
  /* between N branches are N - 1 angles, but the years hold N */
  out->turns = years > 0.0 ? out->mean * count / 360.0 / years : 0.0;
  out->branches = out->mean > 0.0 ? 360.0 / out->mean : 0.0;
}

uint32_t field_first_order(const tree_field *f, fit_branch *out, uint32_t most, double *height) {
  const field_block *trunk = &f->blocks[0];
  uint32_t count = 0;
  *height = 0.0;
  for (uint32_t i = 0; i < trunk->rows; i++) {
    const field_row *r = &f->lines[trunk->first + i];
    *height += 10.0 * r->length * scalar_sin(r->phi * (3.14159265358979323846 / 180.0));
  }
  for (uint32_t k = 1; k < f->block_count && count < most; k++) {
    const field_block *b = &f->blocks[k];
    if (b->order != 1) continue;
    fit_branch o = {.azimuth = f->lines[b->first].theta};
    for (uint32_t i = 0; i < b->node; i++) {
      const field_row *r = &f->lines[trunk->first + i];
      o.z += 10.0 * r->length * scalar_sin(r->phi * (3.14159265358979323846 / 180.0));
    }
    for (uint32_t i = 0; i < b->rows; i++) o.length += 10.0 * f->lines[b->first + i].length;
    uint32_t at = count++;
    for (; at > 0 && out[at - 1].z > o.z; at--) out[at] = out[at - 1];
    out[at] = o;
  }
  return count;
}

int32_t field_fit_make(field_fit *out, const tree_field *f, const tree_plan *p) {
  fit_branch list[BRANCHES_MOST];
  double height;
  uint32_t count = field_first_order(f, list, BRANCHES_MOST, &height);
  if (count < LEAST) {
    return fail(SOZAI_ERROR_FILE, "field: %u first-order branches are too few to fit: %u at least",
                count, LEAST);
  }
  if (!(height > 10.0)) {
    return fail(SOZAI_ERROR_FILE, "field: a trunk that rises %.9g mm cannot be fitted: 10 at least",
                height);
  }
  fit_branches(out, list, count, height, p->age, p->upslope, p->crown_b);
  return SOZAI_OK;
}

void field_fit_apply(const field_fit *fit, tree_plan *p) {
  p->height_max *= fit->height / plan_height(p, p->age);
  p->crown_a = fit->a_up > 0.0 ? fit->a_up : fit->a;
  p->crown_a_down = fit->a_down > 0.0 ? fit->a_down : fit->a;
  p->crown_height = fit->height;
  p->crown_scatter = fit->rms < 0.9 ? fit->rms : 0.9;
  p->crown_b_old = p->crown_b;
  p->crown_ratio = 1.0; /* what was measured is there */
  p->turns = fit->turns;
  p->branches = fit->branches > 1.0 ? fit->branches : 1.0;
  p->turn_spread = 0.0;
  p->random = 0; /* the paper's sugi: with measurements, from them */
  p->divergence_sd = fit->sd;
  p->divergence_min = fit->least;
  p->divergence_max = fit->most > fit->least + 1.0 ? fit->most : fit->least + 1.0;
}
