/* SPDX-License-Identifier: Apache-2.0
 *
 * After G. Sharma, W. Wu and E. N. Dalal, "The CIEDE2000 Color-Difference Formula:
 * Implementation Notes, Supplementary Test Data, and Mathematical Observations",
 * Color Research and Application 30 (2005).
 */
#include "ciede2000.h"

#include <math.h>

#define PI 3.14159265358979323846

static double lab_curve(double t) {
  const double d = 6.0 / 29;
  return t > d * d * d ? cbrt(t) : t / (3 * d * d) + 4.0 / 29;
}

void lab_of(const double xyz[3], double lab[3]) {
  const double x = 0.3127, y = 0.3290; /* D65 */
  const double fx = lab_curve(xyz[0] / (x / y)), fy = lab_curve(xyz[1]),
               fz = lab_curve(xyz[2] / ((1 - x - y) / y));
  lab[0] = 116 * fy - 16;
  lab[1] = 500 * (fx - fy);
  lab[2] = 200 * (fy - fz);
}

/* Degrees, 0 to 360; grey has none: 0. */
static double hue(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double h = atan2(b, a) * 180 / PI;
  return h < 0 ? h + 360 : h;
}

static double cos_deg(double x) { return cos(x * PI / 180); }
static double sin_deg(double x) { return sin(x * PI / 180); }
static double c7(double c) { return sqrt(pow(c, 7) / (pow(c, 7) + pow(25, 7))); }

double ciede2000(const double lab1[3], const double lab2[3]) {
  const double c = (hypot(lab1[1], lab1[2]) + hypot(lab2[1], lab2[2])) / 2;
  const double g = 0.5 * (1 - c7(c));
  const double a1 = (1 + g) * lab1[1], a2 = (1 + g) * lab2[1];
  const double c1 = hypot(a1, lab1[2]), c2 = hypot(a2, lab2[2]);
  const double h1 = hue(a1, lab1[2]), h2 = hue(a2, lab2[2]);

  double dh = h2 - h1, h = h1 + h2;
  if (c1 * c2 == 0) {
    dh = 0;
  } else {
    if (fabs(h1 - h2) <= 180)
      h /= 2;
    else
      h = h < 360 ? (h + 360) / 2 : (h - 360) / 2;
    if (dh > 180)
      dh -= 360;
    else if (dh < -180)
      dh += 360;
  }
  const double dl = lab2[0] - lab1[0], dc = c2 - c1, dhue = 2 * sqrt(c1 * c2) * sin_deg(dh / 2);
  const double l = (lab1[0] + lab2[0]) / 2, cc = (c1 + c2) / 2;

  const double t = 1 - 0.17 * cos_deg(h - 30) + 0.24 * cos_deg(2 * h) + 0.32 * cos_deg(3 * h + 6) -
                   0.20 * cos_deg(4 * h - 63);
  const double turn = 30 * exp(-pow((h - 275) / 25, 2));
  const double sl = 1 + 0.015 * pow(l - 50, 2) / sqrt(20 + pow(l - 50, 2));
  const double sc = 1 + 0.045 * cc, sh = 1 + 0.015 * cc * t;
  const double rt = -sin_deg(2 * turn) * 2 * c7(cc);
  const double x = dl / sl, y = dc / sc, z = dhue / sh;
  return sqrt(x * x + y * y + z * z + rt * y * z);
}
