/* SPDX-License-Identifier: Apache-2.0 */
#include "figures_wood.h"

#include <math.h>
#include <stdlib.h>
#include "plate.h"

#define PI 3.14159265358979323846
#define DEGREES (180 / PI)
#define SIDE 480u /* pixels of a panel */

/* A tangential face 60 mm from the pith, leaning towards it by `lean` degrees
 * as boards do: a fibre that lay in the face for ever would be a line without
 * an end. */
static face_view tangential(double size, double lean) {
  double t = lean / DEGREES;
  return (face_view){.centre = {0, 200, 60},
                     .right = {1, 0, 0},
                     .up = {0, cos(t), -sin(t)},
                     .light = {0, 0, 1},
                     .width = SIDE,
                     .height = SIDE,
                     .pixel = size / SIDE};
}

/* A radial face, 60 to 140 mm from the pith. */
static face_view radial(double size) {
  return (face_view){.centre = {100, 200, 0},
                     .right = {1, 0, 0},
                     .up = {0, 1, 0},
                     .light = {0, 0, 1},
                     .width = SIDE,
                     .height = SIDE,
                     .pixel = size / SIDE};
}

static double mean_of(const float *a, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) sum += (double)a[i];
  return sum / (double)n;
}

/* Least and greatest slope of the fibres within the face, right over up. */
static void slopes_in(const face *f, const float *fibre, double *least, double *most,
                      double *mean) {
  size_t n = (size_t)f->view.width * f->view.height;
  const float *y = fibre, *z = fibre;
  /* the components of a channel stand one after the other */
  for (uint32_t k = 0; k < f->info->component_count; k++) {
    if (f->components[k] == fibre) {
      y = f->components[k + 1];
      z = f->components[k + 2];
    }
  }
  *least = 1e9;
  *most = -1e9;
  *mean = 0;
  for (size_t i = 0; i < n; i++) {
    double d[3] = {(double)fibre[i], (double)y[i], (double)z[i]}, a = 0, b = 0;
    for (int c = 0; c < 3; c++) {
      a += d[c] * f->view.right[c];
      b += d[c] * f->view.up[c];
    }
    *least = fmin(*least, a / b);
    *most = fmax(*most, a / b);
    *mean += a / b / (double)n;
  }
}

/* ---- figures 5 and 6: vessels ----------------------------------------- */

#define STEM "taper=0", "pith_wander=0", "undulation=0"

/* The grain of panels a, b and c, as in the paper's section 5.3. */
static const char *const grains[3][4] = {
    {"grain=straight", "slope_noise=0", "wave_slope=0.2", "wave_length=40"},
    {"grain=spiral", "spiral_slope=0.12", "slope_noise=0.02", "wave_length=40"},
    {"grain=wavy", "wave_slope=0.2", "wave_length=40", "slope_noise=0.02"},
};

static bool draw_vessels(session *s, const char *folder, const char *name, json *j,
                         const char *const layer[5], failure *why) {
  plate p;
  if (!plate_init(&p, 3, SIDE, SIDE, why)) return false;
  bool ok = true;
  json_open(j, "panels", '[');
  for (uint32_t i = 0; ok && i < 3; i++) {
    const char *parameters[16] = {STEM};
    int n = 3;
    for (int k = 0; k < 4; k++) parameters[n++] = grains[i][k];
    for (int k = 0; k < 5 && layer[k]; k++) parameters[n++] = layer[k];
    face_view view = tangential(64, 0.8);
    face f;
    ok = face_evaluate(&f, s, "wood", NULL, parameters, &view, why);
    if (!ok) break;
    const float *vessel = face_channel(&f, "vessel", why), *fibre = face_channel(&f, "fiber", why);
    ok = vessel && fibre;
    if (ok) {
      double least, most, mean;
      plate_ink(&p, i, vessel);
      slopes_in(&f, fibre, &least, &most, &mean);
      json_open(j, NULL, '{');
      json_text(j, "grain", grains[i][0] + 6);
      json_number(j, "coverage", mean_of(vessel, (size_t)SIDE * SIDE));
      json_number(j, "fibre_slope_least", least);
      json_number(j, "fibre_slope_mean", mean);
      json_number(j, "fibre_slope_most", most);
      json_number(j, "lines_degrees_from_upright", plate_direction(vessel, SIDE, SIDE));
      json_number(j, "fibres_degrees_from_upright", atan(mean) * DEGREES);
      json_close(j, '}');
    }
    face_free(&f);
  }
  json_close(j, ']');
  ok = ok && plate_write(&p, folder, name, why);
  plate_free(&p);
  return ok;
}

static bool draw_5(session *s, const char *folder, const char *name, json *j, failure *why) {
  static const char *const layer[5] = {"porosity=diffuse", "vessel_density=3",
                                       "vessel_diameter=160", "vessel_diameter_spread=0.2", NULL};
  json_number(j, "expected_coverage", 1 - exp(-3 * PI * 0.08 * 0.08 * 1.04));
  return draw_vessels(s, folder, name, j, layer, why);
}

static bool draw_6(session *s, const char *folder, const char *name, json *j, failure *why) {
  static const char *const layer[5] = {"porosity=ring", "ring_width=4", "earlywood_diameter=240",
                                       "vessel_density=4", "vessel_diameter=60"};
  return draw_vessels(s, folder, name, j, layer, why);
}

/* ---- figure 7: a cross-section, and the face it gives ----------------- */

static bool draw_7(session *s, const char *folder, const char *name, json *j, failure *why) {
  const char *const parameters[] = {STEM,
                                    "porosity=none",
                                    "fibre_brightness=0.4",
                                    "fibre_width=0.12",
                                    "latewood_fraction=0.35",
                                    "latewood_abruptness=0.6",
                                    "ring_width=3",
                                    "section_wobble=0.08",
                                    "grain=wavy",
                                    "wave_slope=0.15",
                                    "wave_length=15",
                                    "slope_noise=0.02",
                                    NULL};
  /* the same wood with one tissue only: what is left is the shift */
  const char *bare[24] = {"earlywood_colour=0.5 0.5 0.5 @ lin_rec709",
                          "latewood_colour=0.5 0.5 0.5 @ lin_rec709"};
  for (int i = 0; parameters[i]; i++) bare[i + 2] = parameters[i];
  face_view views[2] = {tangential(48, 1.2), tangential(48, 1.2)};
  views[0].centre[0] = 30;
  views[0].centre[1] = 0;
  views[0].centre[2] = 30;
  views[0].up[1] = 0;
  views[0].up[2] = -1;
  plate p;
  if (!plate_init(&p, 2, SIDE, SIDE, why)) return false;
  bool ok = true;
  for (uint32_t i = 0; ok && i < 2; i++) {
    face f;
    ok = face_evaluate(&f, s, "wood", NULL, parameters, &views[i], why);
    if (!ok) break;
    ok = plate_colour(&p, i, f.components, s, why);
    if (ok && i == 1) {
      double least, most, mean;
      const float *fibre = face_channel(&f, "fiber", why);
      ok = fibre != NULL;
      if (ok) {
        slopes_in(&f, fibre, &least, &most, &mean);
        json_number(j, "fibre_slope_least", least);
        json_number(j, "fibre_slope_most", most);
      }
    }
    face_free(&f);
  }
  if (ok) {
    face f;
    views[0].pixel = 0.01; /* near enough to see single fibres */
    ok = face_evaluate(&f, s, "wood", NULL, bare, &views[0], why);
    if (ok) {
      double low = 9, high = -9;
      for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        double shift = (double)f.components[0][i] / 0.5 - 1;
        low = fmin(low, shift);
        high = fmax(high, shift);
      }
      json_number(j, "brightness_shift_limit", 0.4);
      json_number(j, "brightness_shift_least", low);
      json_number(j, "brightness_shift_most", high);
      face_free(&f);
    }
  }
  ok = ok && plate_write(&p, folder, name, why);
  plate_free(&p);
  return ok;
}

/* ---- figure 9: the figure under three lights -------------------------- */

/* Heights at which the rows' mean is greatest, refined by a parabola, and
 * where the rows' mean dive equals delta; the mean distance between each peak
 * and the nearest such height. */
static double peaks_against_dive(json *j, const double *gloss, const double *dive, uint32_t rows,
                                 double delta, double pixel) {
  double sum = 0;
  int peaks = 0;
  json_open(j, "highlights", '[');
  for (uint32_t y = 2; y + 2 < rows; y++) {
    if (!(gloss[y] > gloss[y - 1] && gloss[y] >= gloss[y + 1])) continue;
    double bend = gloss[y - 1] - 2 * gloss[y] + gloss[y + 1];
    double peak = y + (bend < 0 ? 0.5 * (gloss[y - 1] - gloss[y + 1]) / bend : 0);
    double best = 1e9, where = 0;
    for (uint32_t k = 0; k + 1 < rows; k++) {
      double a = dive[k] - delta, b = dive[k + 1] - delta;
      if (a * b > 0 || a == b) continue;
      double at = k + a / (a - b);
      if (fabs(at - peak) < best) {
        best = fabs(at - peak);
        where = at;
      }
    }
    if (best > 1e8) continue;
    json_open(j, NULL, '{');
    json_number(j, "peak_mm", (rows - peak) * pixel);
    json_number(j, "alpha_is_delta_mm", (rows - where) * pixel);
    json_close(j, '}');
    sum += best * pixel;
    peaks++;
  }
  json_close(j, ']');
  return peaks ? sum / peaks : -1;
}

static bool draw_9(session *s, const char *folder, const char *name, json *j, failure *why) {
  /* 30 % specular; the exponent is not printed in the paper */
  const char *parameters[] = {STEM,
                              "slope_noise=0",
                              "porosity=diffuse",
                              "vessel_density=30",
                              "vessel_diameter=50",
                              "grain=wavy",
                              "wave_slope=0.15",
                              "wave_length=20",
                              "diffuse=0.7",
                              "specular=0.3",
                              "specular_tint=0",
                              "shininess=100",
                              NULL};
  plate p;
  if (!plate_init(&p, 3, SIDE, SIDE, why)) return false;
  bool ok = true;
  json_open(j, "panels", '[');
  for (uint32_t i = 0; ok && i < 3; i++) {
    double delta = 7.2 * (1 - (double)i) / DEGREES;
    face_view view = radial(80);
    /* light tilted up the stem by delta from the normal, which is +z */
    view.light[1] = sin(delta);
    view.light[2] = cos(delta);
    face f;
    ok = face_evaluate(&f, s, "wood", NULL, parameters, &view, why);
    if (!ok) break;
    const float *radiance = face_channel(&f, "radiance", why),
                *dive = face_channel(&f, "dive", why);
    const float *albedo = face_channel(&f, "albedo", why);
    double *gloss = calloc(2 * SIDE, sizeof *gloss);
    ok = radiance && dive && albedo && (gloss || fail(why, EXIT_FAILURE, "out of memory"));
    if (ok) {
      double *slope = gloss + SIDE;
      for (size_t k = 0; k < (size_t)SIDE * SIDE; k++) {
        gloss[k / SIDE] += ((double)radiance[k] - 0.7 * (double)albedo[k] * cos(delta)) / SIDE;
        slope[k / SIDE] += (double)dive[k] / SIDE;
      }
      uint32_t first = 0;
      while (f.components[first] != radiance) first++;
      ok = plate_colour(&p, i, f.components + first, s, why);
      json_open(j, NULL, '{');
      json_number(j, "delta_degrees", delta * DEGREES);
      double off = peaks_against_dive(j, gloss, slope, SIDE, delta, view.pixel);
      json_number(j, "mean_distance_mm", off);
      json_close(j, '}');
    }
    free(gloss);
    face_free(&f);
  }
  json_close(j, ']');
  ok = ok && plate_write(&p, folder, name, why);
  plate_free(&p);
  return ok;
}

const figure wood_figures[] = {
    {"wood-05", "Vessels of diffuse-porous wood under straight, spiral and wavy grain", draw_5},
    {"wood-06", "Vessels of ring-porous wood under straight, spiral and wavy grain", draw_6},
    {"wood-07", "A cross-section of rings and shifted brightness, and the face it gives", draw_7},
    {"wood-09", "Figure of wavy grain under light at 7.2, 0 and -7.2 degrees", draw_9},
};
const size_t wood_figure_count = sizeof wood_figures / sizeof wood_figures[0];
