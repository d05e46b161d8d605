/* SPDX-License-Identifier: Apache-2.0 */
#include "appearance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define DEGREE (3.14159265358979323846 / 180)

/* ---- the working space and sRGB ------------------------------------------ */

static float encode(float x) {
  float a = fabsf(x);
  return copysignf(a <= 0.0031308f ? 12.92f * a : 1.055f * powf(a, 1 / 2.4f) - 0.055f, x);
}

static float decode(float x) {
  float a = fabsf(x);
  return copysignf(a <= 0.04045f ? a / 12.92f : powf((a + 0.055f) / 1.055f, 2.4f), x);
}

bool appearance_srgb(const colour *c, float *rgb, size_t count, failure *why) {
  if (!c->service) {
    for (size_t i = 0; i < 3 * count; i++) rgb[i] = encode(rgb[i]);
    return true;
  }
  char message[512] = "";
  if (c->service->from_working(c->service->self, "sRGB", rgb, count, message, sizeof message) ==
      SOZAI_OK)
    return true;
  return fail(why, EXIT_BAD_INPUT, "the config cannot give sRGB: %s", message);
}

bool appearance_to_working(const colour *c, const char *space, float *rgb, size_t count,
                           failure *why) {
  if (!c->service) {
    if (strcasecmp(space, "Linear Rec.709") == 0) return true; /* the working space then */
    if (strcasecmp(space, "sRGB") != 0)
      return fail(why, EXIT_BAD_INPUT, "there is no colour service to look up '%s' in", space);
    for (size_t i = 0; i < 3 * count; i++) rgb[i] = decode(rgb[i]);
    return true;
  }
  char message[512] = "";
  if (c->service->to_working(c->service->self, space, rgb, count, message, sizeof message) ==
      SOZAI_OK)
    return true;
  return fail(why, EXIT_BAD_INPUT, "%s", message);
}

/* ---- Lab ------------------------------------------------------------------- */

static double lab_curve(double t) {
  return t > 216.0 / 24389 ? cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

bool appearance_lab(const colour *c, float *rgb, size_t count, failure *why) {
  static const double xyz[3][3] = {{0.4123907992659595, 0.35758433938387796, 0.1804807884018343},
                                   {0.21263900587151036, 0.7151686787677559, 0.07219231536073371},
                                   {0.01933081871559185, 0.11919477979462599, 0.9505321522496606}};
  if (!appearance_srgb(c, rgb, count, why)) return false;
  for (size_t i = 0; i < count; i++) {
    float *p = rgb + 3 * i;
    double f[3];
    for (int k = 0; k < 3; k++) {
      double sum = 0, white = 0;
      for (int j = 0; j < 3; j++) {
        sum += xyz[k][j] * (double)decode(p[j]);
        white += xyz[k][j];
      }
      f[k] = lab_curve(sum / white);
    }
    p[0] = (float)(116 * f[1] - 16);
    p[1] = (float)(500 * (f[0] - f[1]));
    p[2] = (float)(200 * (f[1] - f[2]));
  }
  return true;
}

/* ---- CIEDE2000, after Sharma, Wu and Dalal (2005) --------------------------- */

static double seventh(double x) { return x * x * x * x * x * x * x; }

static double hue(double a, double b) {
  if (a == 0 && b == 0) return 0;
  double h = atan2(b, a) / DEGREE;
  return h < 0 ? h + 360 : h;
}

static double hue_difference(double h1, double h2) {
  double d = h2 - h1;
  return d > 180 ? d - 360 : d < -180 ? d + 360 : d;
}

static double hue_mean(double h1, double h2) {
  if (fabs(h1 - h2) <= 180) return (h1 + h2) / 2;
  return h1 + h2 < 360 ? (h1 + h2 + 360) / 2 : (h1 + h2 - 360) / 2;
}

double ciede2000(const double a[3], const double b[3]) {
  double chroma = (hypot(a[1], a[2]) + hypot(b[1], b[2])) / 2;
  double g = 0.5 * (1 - sqrt(seventh(chroma) / (seventh(chroma) + seventh(25))));
  double a1 = (1 + g) * a[1], a2 = (1 + g) * b[1];
  double c1 = hypot(a1, a[2]), c2 = hypot(a2, b[2]);
  double h1 = hue(a1, a[2]), h2 = hue(a2, b[2]);
  bool grey = c1 * c2 == 0;
  double dh = grey ? 0 : hue_difference(h1, h2);
  double dl = b[0] - a[0], dc = c2 - c1, big_dh = 2 * sqrt(c1 * c2) * sin(dh / 2 * DEGREE);
  double l = (a[0] + b[0]) / 2, c = (c1 + c2) / 2, h = grey ? h1 + h2 : hue_mean(h1, h2);
  double t = 1 - 0.17 * cos((h - 30) * DEGREE) + 0.24 * cos(2 * h * DEGREE) +
             0.32 * cos((3 * h + 6) * DEGREE) - 0.20 * cos((4 * h - 63) * DEGREE);
  double turn = 30 * exp(-((h - 275) / 25) * ((h - 275) / 25));
  double rc = 2 * sqrt(seventh(c) / (seventh(c) + seventh(25)));
  double l50 = (l - 50) * (l - 50);
  double sl = 1 + 0.015 * l50 / sqrt(20 + l50), sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
  double x = dl / sl, y = dc / sc, z = big_dh / sh;
  return sqrt(x * x + y * y + z * z - sin(2 * turn * DEGREE) * rc * y * z);
}
