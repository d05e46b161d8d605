/* SPDX-License-Identifier: Apache-2.0
 *
 * From what was measured to a plan that grows its siblings.
 */
#include "../core/scalar.h"
#include "field.h"

static double within(double x, double least, double most) {
  return x < least ? least : x > most ? most : x;
}

/* ---- elevation --------------------------------------------------------- */

/* A line over height, where it is more than chance, and the mean where it is not: few branches
 * make a slope of anything, and at the crown's ends it would be far off. */
static void fit_elevation(tree_plan *p, const field_fit *fit, const fit_data *d) {
  double n = d->count, z = 0.0, zz = 0.0, ze = 0.0;
  for (uint32_t i = 0; i < d->count; i++) z += d->list[i].z / fit->height / n;
  for (uint32_t i = 0; i < d->count; i++) {
    double off = d->list[i].z / fit->height - z;
    zz += off * off;
    ze += off * (d->list[i].elevation - fit->lean);
  }
  double all = fit->lean_sd * fit->lean_sd * (n - 1.0), slope = 0.0, sd = fit->lean_sd;
  double rest = zz > 0.0 ? all - ze * ze / zz : all, free = n - 2.0;
  double least = 1.96 + 4.0 / free; /* about the t that one in 20 passes by chance */
  if (zz > 0.0 && ze * ze / zz > least * least * within(rest, 0.0, all) / free) {
    slope = ze / zz;
    sd = scalar_root(rest / free);
  }
  p->angle_low = fit->lean - slope * z;
  p->angle_top = fit->lean + slope * (1.0 - z);
  p->angle_from = within(d->list[0].z / fit->height, 0.0, 1.0);
  p->angle_to = within(d->list[d->count - 1].z / fit->height, p->angle_from, 1.0);
  p->angle_spread = 3.46410162 * sd; /* an even one of that standard deviation */
  p->angle_chord = 1;
}

/* ---- diameters --------------------------------------------------------- */

/* The form between the diameters of the trunk: the swell of the butt is the species'. */
static double form_of(const tree_plan *p, const fit_data *d, double height) {
  double xy = 0.0, xx = 0.0;
  const fit_stem *foot = &d->stem[0];
  for (uint32_t i = 1; i < d->stem_count; i++) {
    const fit_stem *s = &d->stem[i];
    if (!(s->z > foot->z && s->z < 0.95 * height)) continue;
    double swell = (1.0 + p->butt * scalar_exp(-s->z / p->girth_max)) /
                   (1.0 + p->butt * scalar_exp(-scalar_most(foot->z, 0.0) / p->girth_max));
    double x = scalar_log((1.0 - s->z / height) / (1.0 - foot->z / height));
    xy += x * scalar_log(s->diameter / foot->diameter / swell);
    xx += x * x;
  }
  return xx > 0.01 ? within(xy / xx, 0.3, 2.0) : p->stem_form;
}

#define STEM_STEPS 4 /* form and girth wait for each other; each step leaves some hundredth */

static void fit_stem_of(tree_plan *p, const field_fit *fit, const fit_data *d) {
  if (!(fit->stem > 0.0 && fit->stem_at < 0.9 * fit->height)) return;
  for (int i = 0; i < STEM_STEPS; i++) {
    p->stem_form = form_of(p, d, fit->height);
    p->girth_max *= 0.5 * fit->stem / plan_radius(p, fit->stem_at, p->age);
  }
}

/* Slenderness such that branches of the lengths measured are as thick in the mean, though none
 * passes its share of the stem. */
static double slender_of(const fit_data *d, double thickest) {
  double low = 0.001, high = 0.2, want = 0.0;
  for (uint32_t i = 0; i < d->count; i++) want += d->list[i].diameter;
  for (int step = 0; step < 50; step++) {
    double middle = 0.5 * (low + high), sum = 0.0;
    for (uint32_t i = 0; i < d->count; i++) {
      const fit_branch *b = &d->list[i];
      if (!(b->diameter > 0.0)) continue;
      double thick = middle * b->length, most = thickest * b->stem;
      sum += b->stem > 0.0 && thick > most ? most : thick;
    }
    if (sum < want) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return 0.5 * (low + high);
}

static void fit_thickness(tree_plan *p, const field_fit *fit, const fit_data *d) {
  if (!(fit->slender > 0.0)) return;
  double most = 0.0;
  for (uint32_t i = 0; i < d->count; i++) {
    const fit_branch *b = &d->list[i];
    if (b->diameter > 0.0 && b->stem > 0.0) most = scalar_most(most, b->diameter / b->stem);
  }
  if (most > 0.0) p->thickest = within(most, 0.05, 0.95);
  p->slender = slender_of(d, p->thickest);
}

/* ---- the whole --------------------------------------------------------- */

void sibling_plan(tree_plan *p, const field_fit *fit, const fit_data *d) {
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
  fit_elevation(p, fit, d);
  fit_stem_of(p, fit, d);
  fit_thickness(p, fit, d);
}
