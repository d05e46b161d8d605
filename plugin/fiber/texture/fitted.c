/* SPDX-License-Identifier: Apache-2.0
 * Printed by fit-fiber-light, cloth in three runs, each from what the one before printed. The rows
 * of bulk are of an earlier fit, without structure: it returned less of what it was given. */
#include "fitted.h"

const fibertex_fitted *fibertex_fit(const double *made_of) {
  (void)made_of;
  static const fibertex_fitted fitted = {
      .least = {1, 0.9912, -0.9163, -2.728, 0.03313, 0.000622, 0.1778, 0.07839, 0.01029, 0,
                0.02767},
      .most = {1, 3.625, -0.2058, -1.128, 0.3438, 0.09034, 0.5172, 0.4122, 0.6005, 0.95, 0.3541},
      .middle = {0, 2.308, -0.5611, -1.928, 0.1885, 0.04548, 0.3475, 0.2453, 0.3054, 0.475, 0.1909},
      .amount =
          {
              [FIT_SLAB] = {-1.234, 0.3068, 0.2884, -0.7645, 0, 0, 0, 1.497, 0, 0, 2.755},
              [FIT_COLOUR] = {-0.06957, -0.026, -0.006038, 0.07987, 0, 0, 0, 0, 0, 0, -0.5465},
              [FIT_ALBEDO] = {-0.3138, -0.06922, 0.2029, 0.1075, 0.06278, 0.09405, -0.326, -0.1684,
                              0, -0.04943, -1.783},
              [FIT_OFTEN] = {0.05425, 0.002779, 0.2067, 0.0149, 0.3451, 0.1599, 0.6998, 0.1335,
                             -0.001491, -0.07645, -0.9923},
              [FIT_BROAD] = {0.261, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
              [FIT_NARROW] = {-0.1581, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
              [FIT_GLANCE] = {0.9317, 0, 0, 0.4401, 0, 0, -1.871, 0, 0, 0, 0},
              [FIT_THROUGH] = {0.639, 0.1033, 0.3166, 0.03592, 0.2548, 11.81, 2.087, -3.241, 0.1714,
                               0.1718, 2.745},
              [FIT_FLOWN] = {0.4277, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
              [FIT_HAIR] = {0.5167, -1.027, 0, -2.592, 0, 0, 0, 0, 0, 0, 0},
              [FIT_SHADED] = {-0.7085, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
          },
      .bulk_least = {1, 0.158, -0.7107, -1.976, 0.3383},
      .bulk_most = {1, 0.8297, -0.4615, -1.203, 0.8708},
      .bulk_middle = {0, 0.4939, -0.5861, -1.59, 0.6046},
      .bulk = {
          [BULK_GLANCE] = {-0.1393, 0, 0, 0, 0},
          [BULK_THROUGH] = {-0.2231, 0, 0, 0, 0},
          [BULK_SINGLE] = {-2.12, 0, 0, 0, 0},
          [BULK_CHAIN] = {1.937, 0, 0, 0, 0},
          [BULK_MORE] = {1.435, 0, 0, 0, 0},
          [BULK_OFTEN] = {0.1681, 0, 0, 0, 0},
          [BULK_SLAB] = {-1.214, 0, 0, 0, 0},
          [BULK_LINEAR] = {1.71, 0, 0, 0, 0},
          [BULK_SQUARE] = {2.688, 0, 0, 0, 0},
          [BULK_GRAZE] = {-0.2033, 0, 0, 0, 0},
          [BULK_GRAZE_BOTH] = {0.1604, 0, 0, 0, 0},
      }};
  return &fitted;
}
