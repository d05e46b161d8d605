/* SPDX-License-Identifier: Apache-2.0 */
#include "lines.h"

#include <stdbool.h>

void lines_meet(const lines *l, const sozai_texture *t, double *covered, double *begin) {
  points p = {0};
  for (int k = 0; k < l->count; k++) {
    double x = 4000 * uniform(), y = 4000 * uniform(), z = 4000 * uniform();
    for (int i = 0; i < l->steps; i++) points_add(&p, x + l->step * i, y, z, 0);
  }
  points_ask_only(&p, t, ONLY3(ALBEDO));
  *covered = *begin = 0;
  for (unsigned i = 0; i < p.count; i++) {
    bool in = p.out[ALBEDO][i] > 0.25f;
    *covered += in;
    *begin += in && i % (unsigned)l->steps != 0 && p.out[ALBEDO][i - 1] <= 0.25f;
  }
  *covered /= p.count;
  *begin /= p.count * l->step;
  points_free(&p);
}
