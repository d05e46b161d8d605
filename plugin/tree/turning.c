/* SPDX-License-Identifier: Apache-2.0 */
#include "turning.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "tree.h"

/* Table 1: turns a year and branches a turn of sugi nos. 2 to 18. Their means
 * are printed as 3.19 and 2.10. */
static const double table_1[17][2] = {{5.0, 1.9}, {2.7, 2.0}, {2.3, 2.2}, {2.2, 1.9}, {2.3, 2.5},
                                      {3.1, 2.3}, {2.5, 2.4}, {3.4, 2.0}, {2.4, 2.4}, {4.4, 2.2},
                                      {3.2, 2.1}, {3.8, 2.0}, {3.3, 2.0}, {4.4, 1.9}, {3.3, 1.9},
                                      {3.8, 1.9}, {2.1, 2.1}};
#define MEAN_TURNS (54.2 / 17.0)
#define MEAN_BRANCHES (35.7 / 17.0)

/* The table's own scatter, which keeps how the two go together: a tree is one
 * of its rows, over the means. */
static void draw_tree(tree_turning *t, const tree_plan *p) {
  uint32_t h = hash1(p->seed ^ 0x7e3a91c5u);
  uint32_t row = (uint32_t)(((uint64_t)h * 17u) >> 32);
  t->turns = p->turns * (1.0 + p->turn_spread * (table_1[row][0] / MEAN_TURNS - 1.0));
  t->branches = p->branches * (1.0 + p->turn_spread * (table_1[row][1] / MEAN_BRANCHES - 1.0));
  if (t->branches < 1.0) t->branches = 1.0;
}

/* Divergence is a beta distribution between its least and its greatest: the
 * one with that mean and standard deviation. Near 180 +- 130 degrees with sd 73
 * it is nearly even, as in the paper's figures. */
static void tabulate(tree_turning *t, const tree_plan *p) {
  double mean = 360.0 / t->branches, low = p->divergence_min, high = p->divergence_max;
  if (mean < low + 1.0) low = mean * 0.5;
  if (mean > high - 1.0) high = mean * 1.5;
  double width = high - low, m = (mean - low) / width, sd = p->divergence_sd / width;
  double most = 0.95 * scalar_root(m * (1.0 - m)); /* of any distribution of that mean */
  if (sd > most) sd = most;
  if (sd < 1e-3) {
    for (int i = 0; i <= TURNING_STEPS; i++) t->quantile[i] = mean;
    return;
  }
  double nu = m * (1.0 - m) / (sd * sd) - 1.0, a = m * nu - 1.0, b = (1.0 - m) * nu - 1.0;
  enum { CELLS = 1024 };
  static const double cell = 1.0 / CELLS;
  double total = 0.0, weight[CELLS];
  for (int i = 0; i < CELLS; i++) {
    double x = (i + 0.5) * cell;
    weight[i] = scalar_exp(a * scalar_log(x / m) + b * scalar_log((1.0 - x) / (1.0 - m)));
    total += weight[i];
  }
  double sum = 0.0, before = 0.0;
  int k = 0;
  for (int i = 0; i < CELLS; i++) {
    before = sum;
    sum += weight[i] / total;
    while (k <= TURNING_STEPS && (double)k / TURNING_STEPS <= sum) {
      double within = sum > before ? ((double)k / TURNING_STEPS - before) / (sum - before) : 0.0;
      t->quantile[k++] = low + width * (i + within) * cell;
    }
  }
  while (k <= TURNING_STEPS) t->quantile[k++] = high;
}

void turning_make(tree_turning *t, const tree_plan *p) {
  draw_tree(t, p);
  tabulate(t, p);
}

double turning_divergence(const tree_turning *t, double u) {
  double at = u * TURNING_STEPS;
  int i = (int)at;
  if (i >= TURNING_STEPS) return t->quantile[TURNING_STEPS];
  return t->quantile[i] + (at - i) * (t->quantile[i + 1] - t->quantile[i]);
}

double turning_height(const tree_plan *p, double u) { return 1.0 - tree_power(1.0 - u, p->flush); }
