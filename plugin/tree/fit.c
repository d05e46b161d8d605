/* SPDX-License-Identifier: Apache-2.0
 *
 * Section 3 of the paper as arithmetic: crown a by least squares, divergence,
 * turns and branches a turn; and means of what section 4 adds, elevation and
 * diameter.
 */
#include "../core/scalar.h"
#include "../core/status.h"
#include "angle.h"
#include "field.h"

#define LEAST 3u /* branches */

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

static void fit_build(field_fit *out, const fit_branch *list, uint32_t count) {
  double lean = 0.0, squares = 0.0, thick = 0.0, length = 0.0, ratio = 0.0;
  uint32_t with_stem = 0;
  for (uint32_t i = 0; i < count; i++) {
    lean += list[i].elevation;
    squares += list[i].elevation * list[i].elevation;
    if (!(list[i].diameter > 0.0)) continue;
    thick += list[i].diameter;
    length += list[i].length;
    if (!(list[i].stem > 0.0)) continue;
    with_stem++;
    ratio += list[i].diameter / list[i].stem;
  }
  if (count > 0) out->lean = lean / count;
  if (count > 1) out->lean_sd = scalar_root((squares - lean * lean / count) / (count - 1.0));
  if (length > 0.0) out->slender = thick / length;
  if (with_stem) out->ratio = ratio / with_stem;
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
  fit_build(out, list, count);
  if (count > 0) out->rms = scalar_root(residual / count);
  if (count < 2) return;
  double n = count - 1;
  out->mean = sum / n;
  if (n > 1) out->sd = scalar_root((squares - sum * sum / n) / (n - 1.0));
  /* between N branches are N - 1 angles, but the years hold N */
  out->turns = years > 0.0 ? out->mean * count / 360.0 / years : 0.0;
  out->branches = out->mean > 0.0 ? 360.0 / out->mean : 0.0;
}

/* ---- from a table ------------------------------------------------------ */

static double rise_of(const field_row *r) {
  return 10.0 * r->length * scalar_sin(r->phi * RADIANS);
}

static void read_branch(fit_branch *o, const field_row *rows, uint32_t count) {
  double x = 0.0, y = 0.0, z = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    double level = 10.0 * rows[i].length * scalar_cos(rows[i].phi * RADIANS);
    x += level * scalar_sin(rows[i].theta * RADIANS);
    y += rise_of(&rows[i]);
    z += level * scalar_cos(rows[i].theta * RADIANS);
    o->length += 10.0 * rows[i].length;
  }
  o->azimuth = rows[0].theta;
  o->elevation = angle_of(y, scalar_root(x * x + z * z));
  o->diameter = 10.0 * rows[0].diameter;
}

static void read_stem(fit_data *d, const tree_field *f) {
  const field_block *trunk = &f->blocks[0];
  for (uint32_t i = 0; i < trunk->rows; i++) {
    const field_row *r = &f->lines[trunk->first + i];
    if (r->diameter > 0.0) d->stem[d->stem_count++] = (fit_stem){d->height, 10.0 * r->diameter};
    d->height += rise_of(r);
  }
}

/* With the trunk's diameter below each, from the node that it was measured at lowest. */
static int32_t read_branches(fit_data *d, const sozai_host *host, const tree_field *f) {
  const field_block *trunk = &f->blocks[0];
  const field_row *rows = &f->lines[trunk->first];
  size_t bytes = (trunk->rows + 1u) * sizeof(tree_node);
  tree_node *nodes = host_alloc(host, bytes, 64);
  if (!nodes) return SOZAI_ERROR_MEMORY;
  field_radii(rows, trunk->rows, 0.0, nodes);
  for (uint32_t k = 1; k < f->block_count; k++) {
    const field_block *b = &f->blocks[k];
    if (b->order != 1) continue;
    fit_branch o = {0};
    for (uint32_t i = 0; i < b->node; i++) o.z += rise_of(&rows[i]);
    read_branch(&o, &f->lines[b->first], b->rows);
    uint32_t known = 0;
    for (uint32_t i = 0; i <= b->node && i < trunk->rows; i++) known += rows[i].diameter > 0.0;
    if (known) o.stem = 2.0 * (double)nodes[b->node].r;
    uint32_t at = d->count++;
    for (; at > 0 && d->list[at - 1].z > o.z; at--) d->list[at] = d->list[at - 1];
    d->list[at] = o;
  }
  host_free(host, nodes, bytes, 64);
  return SOZAI_OK;
}

int32_t fit_data_make(fit_data *out, const sozai_host *host, const tree_field *f) {
  *out = (fit_data){.room = f->block_count, .stem_room = f->blocks[0].rows};
  out->list = host_alloc(host, out->room * sizeof *out->list, 64);
  out->stem = out->list ? host_alloc(host, out->stem_room * sizeof *out->stem, 64) : NULL;
  if (!out->stem) return SOZAI_ERROR_MEMORY;
  read_stem(out, f);
  return read_branches(out, host, f);
}

void fit_data_free(fit_data *d, const sozai_host *host) {
  host_free(host, d->list, d->room * sizeof *d->list, 64);
  host_free(host, d->stem, d->stem_room * sizeof *d->stem, 64);
}

int32_t fit_make(field_fit *out, const fit_data *d, const tree_plan *p) {
  if (d->count < LEAST) {
    return fail(SOZAI_ERROR_FILE, "field: %u first-order branches are too few to fit: %u at least",
                d->count, LEAST);
  }
  if (!(d->height > 10.0)) {
    return fail(SOZAI_ERROR_FILE, "field: a trunk that rises %.9g mm cannot be fitted: 10 at least",
                d->height);
  }
  fit_branches(out, d->list, d->count, d->height, p->age, p->upslope, p->crown_b);
  if (d->stem_count) {
    out->stem = d->stem[0].diameter;
    out->stem_at = d->stem[0].z;
  }
  return SOZAI_OK;
}
