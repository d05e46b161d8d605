/* SPDX-License-Identifier: Apache-2.0 */
#include "figures_stone.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "montage.h"
#include "plate.h"
#include "render.h"

#define PI 3.14159265358979323846
#define SIDE 400u /* pixels of a panel: one texel each */

/* ---- figure 5: the fine roughness -------------------------------------- */

/* Two cut stones across, so that each shows whole. */
#define CUT                                                                                        \
  "colour_mode=paper_rgb", "paper_pattern=cut", "paper_texel=1", "paper_length=200",               \
      "paper_width=200", "paper_base=120 115 108", "paper_variation=20 20 20", "paper_relief=12",  \
      "paper_levels=4", "finish=sawn"

static bool draw_5(session *s, const char *folder, const char *name, json *j, failure *why) {
  static const int sweep[] = {0, 15, 30, 60, 120};
  const uint32_t panels = sizeof sweep / sizeof *sweep;
  plate p;
  if (!plate_init(&p, panels, SIDE, SIDE, why)) return false;
  bool ok = true;
  json_open(j, "panels", '[');
  for (uint32_t i = 0; ok && i < panels; i++) {
    char dh[32];
    snprintf(dh, sizeof dh, "paper_dh=%d", sweep[i]);
    const char *const parameters[] = {CUT, dh, NULL};
    face_view view = {.centre = {200, 200, 0},
                      .right = {1, 0, 0},
                      .up = {0, 1, 0},
                      .light = {-0.6, 0.5, 0.62},
                      .width = SIDE,
                      .height = SIDE,
                      .pixel = 1};
    face f;
    ok = face_evaluate(&f, s, "stone", NULL, parameters, &view, why);
    if (!ok) break;
    const float *height = face_channel(&f, "height", why),
                *radiance = face_channel(&f, "radiance", why);
    ok = height && radiance;
    if (ok) {
      /* codes: 12 mm are 256 */
      double most = -1e9, mean = 0, rough = 0;
      size_t n = (size_t)SIDE * SIDE, pairs = 0;
      for (size_t k = 0; k < n; k++) {
        double h = 256 + (double)height[k] * 256 / 12;
        most = fmax(most, h);
        mean += h / (double)n;
        if (k % SIDE > 0) {
          double step = ((double)height[k] - (double)height[k - 1]) * 256 / 12;
          rough += step * step;
          pairs++;
        }
      }
      for (uint32_t k = 0; ok && k < f.info->component_count; k++)
        if (f.components[k] == radiance) ok = plate_colour(&p, i, f.components + k, s, why);
      json_open(j, NULL, '{');
      json_number(j, "dh", sweep[i]);
      json_number(j, "highest_code", most);
      json_number(j, "mean_code", mean);
      json_number(j, "step_between_texels_rms_code", sqrt(rough / (double)pairs));
      json_close(j, '}');
    }
    face_free(&f);
  }
  json_close(j, ']');
  ok = ok && plate_write(&p, folder, name, why);
  plate_free(&p);
  return ok;
}

/* ---- figure 6: montage -------------------------------------------------- */

#define WIDTH 1200u
#define HEIGHT 720u
#define AZIMUTH (-60.0)
#define ELEVATION 38.0

static bool make(session *s, const char *preset, const char *const *parameters, sozai_texture **out,
                 failure *why) {
  recipe r;
  if (!recipe_open(&r, "stone", why)) return false;
  bool ok = !preset || recipe_set_preset(&r, preset, why);
  for (; ok && *parameters; parameters++) ok = recipe_set_pair(&r, *parameters, why);
  ok = ok && recipe_create(&r, s->plugin.textures, &s->host.abi, out, why);
  recipe_free(&r);
  return ok;
}

/* The picture that is given: a house of stone on its ground, from the renderer,
 * so that nothing in it knows of the paving. */
static bool draw_street(session *s, film *out, failure *why) {
  static const char *const wall[] = {"joint_width=10", "finish=sawn", NULL};
  sozai_texture *t = NULL;
  if (!make(s, "oya", wall, &t, why)) return false;
  render_job job;
  render_job_init(&job, s->plugin.textures, t);
  job.size[0] = 9000;
  job.size[1] = 3000;
  job.size[2] = 3600;
  job.bevel = 30;
  job.width = WIDTH;
  job.height = HEIGHT;
  job.spp = 8;
  job.threads = s->host.threads;
  job.camera_azimuth = -90;
  job.camera_elevation = 9;
  job.camera_angle = 34;
  job.light_azimuth = AZIMUTH;
  job.light_elevation = ELEVATION;
  job.zoom = 0.62;
  job.quiet = true;
  bool ok = render(&job, out, why);
  s->plugin.textures->destroy(t);
  return ok;
}

static bool draw_6(session *s, const char *folder, const char *name, json *j, failure *why) {
  /* the paper's numbers; a stone of 450 mm of 150 texels */
  static const char *const paving[] = {
      "colour_mode=paper_rgb",    "paper_pattern=chidori", "paper_texel=3",
      "paper_length=150",         "paper_width=150",       "paper_base=50 50 50",
      "paper_variation=30 30 30", "paper_dh=30",           "paper_joint_wander=0.06",
      "paper_relief=18",          "finish=sawn",           NULL};
  film f;
  if (!draw_street(s, &f, why)) return false;
  sozai_texture *t = NULL;
  double a = AZIMUTH * PI / 180, e = ELEVATION * PI / 180;
  /* before the house, by the horizon at row 167: twelve metres, and eight deep */
  montage m = {.corner = {{-65, 710}, {1265, 710}, {991, 486}, {209, 486}},
               .length = 12000,
               .width = 7830,
               .light = {cos(a) * cos(e), sin(a) * cos(e), sin(e)},
               .light_colour = {1, 1, 1},
               .view = {0, -0.97, 0.24},
               .sky = {0.42, 0.425, 0.43}};
  montage_report report;
  bool ok = make(s, NULL, paving, &t, why) &&
            montage_paint(&m, s->plugin.textures, t, f.beauty, WIDTH, HEIGHT, &report, why);
  s->plugin.textures->destroy(t);
  plate p = {0};
  if (ok) ok = plate_init(&p, 1, WIDTH, HEIGHT, why);
  if (ok) {
    size_t n = (size_t)WIDTH * HEIGHT;
    float *planes = malloc(3 * n * sizeof *planes);
    ok = planes || fail(why, EXIT_FAILURE, "out of memory");
    if (ok) {
      float *rgb[3] = {planes, planes + n, planes + 2 * n};
      for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) rgb[c][i] = f.beauty[3 * i + (size_t)c];
      ok = plate_colour(&p, 0, rgb, s, why) && plate_write(&p, folder, name, why);
    }
    free(planes);
  }
  if (ok) {
    json_open(j, "corners", '[');
    for (int i = 0; i < 4; i++) {
      json_open(j, NULL, '{');
      json_number(j, "x", m.corner[i][0]);
      json_number(j, "y", m.corner[i][1]);
      json_close(j, '}');
    }
    json_close(j, ']');
    json_number(j, "corner_error_mm", report.corner_error);
    json_number(j, "pixels", report.pixels);
    json_number(j, "footprint_least_mm", report.footprint[0]);
    json_number(j, "footprint_greatest_mm", report.footprint[1]);
    json_number(j, "albedo_red", report.albedo[0]);
    json_number(j, "albedo_green", report.albedo[1]);
    json_number(j, "albedo_blue", report.albedo[2]);
    json_number(j, "joint", report.joint);
  }
  plate_free(&p);
  film_free(&f);
  return ok;
}

const figure stone_figures[] = {
    {"stone-05", "Cut stones whose fine roughness dh is 0, 15, 30, 60 and 120", draw_5},
    {"stone-06", "Paving staggered by half, placed in a picture by four points", draw_6},
};
const size_t stone_figure_count = sizeof stone_figures / sizeof stone_figures[0];
