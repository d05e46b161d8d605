/* SPDX-License-Identifier: Apache-2.0
 *
 * The dive angle, and Kawai's equation (4).
 */
#include <math.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
#define PLAIN                                                                                      \
  "section_wobble=0; undulation=0; taper=0; pith_wander=0; slope_noise=0; ring_variation=0; "

static void set3(float *a[3], unsigned i, double x, double y, double z) {
  a[0][i] = (float)x;
  a[1][i] = (float)y;
  a[2][i] = (float)z;
}

static void dive_on_the_faces(void **state) {
  (void)state;
  uniform_seed(41);
  static const double slopes[4] = {-0.2, 0.05, 0.12, 0.3};
  for (int k = 0; k < 4; k++) {
    char text[256];
    snprintf(text, sizeof text, PLAIN "grain=spiral; spiral_slope=%g", slopes[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    for (int i = 0; i < 2000; i++) {
      double r = 50 + 100 * uniform(), theta = 2 * PI * uniform(), y = 500 * (uniform() - 0.5);
      double c = cos(theta), s = sin(theta);
      unsigned a = points_add(&p, r * c, y, r * s, 0);
      set3(p.normal, a, c, 0, s); /* tangential face: square to the radius */
      a = points_add(&p, r * c, y, r * s, 0);
      set3(p.normal, a, s, 0, -c); /* radial face, looking against theta */
      a = points_add(&p, r * c, y, r * s, 0);
      set3(p.normal, a, -s, 0, c); /* the same from its other side */
    }
    points_ask(&p, t);
    double tangential = 0, radial = 0, back = 0, want = atan(slopes[k]);
    for (unsigned i = 0; i < p.count; i += 3) {
      tangential = fmax(tangential, fabs((double)p.out[DIVE][i]));
      radial = fmax(radial, fabs((double)p.out[DIVE][i + 1] - want));
      back = fmax(back, fabs((double)p.out[DIVE][i + 2] + want));
    }
    CHECK(tangential < 1e-4 && radial < 1e-3 && back < 1e-3,
          "slope %+.2f: tangential |alpha| <= %.2g; radial alpha = %+.4f to %.2g, and its negative "
          "from behind to %.2g\n",
          slopes[k], tangential, want, radial, back);
    points_free(&p);
    textures->destroy(t);
  }
}

/* kd LI cos(delta) + ks LI cos^n(delta - alpha) with the light in the plane of
 * the normal and the stem, for a range of n, ks and wavy grain. */
static void equation_4(void **state) {
  (void)state;
  uniform_seed(42);
  static const double exponents[4] = {1, 8, 30, 100};
  double worst = 0, worst_solid = 0;
  unsigned asked = 0;
  for (int k = 0; k < 4; k++) {
    char text[320];
    snprintf(text, sizeof text,
             "grain=wavy; wave_slope=0.2; wave_length=20; diffuse=0.7; specular=0.3; "
             "shininess=%g; specular_tint=0",
             exponents[k]);
    sozai_texture *t = wood_make("keyaki", text);
    points p = {0};
    enum { N = 20000 };
    static double delta[N];
    static float colour[3][N];
    for (int i = 0; i < N; i++) {
      double r = 30 + 150 * uniform(), theta = 2 * PI * uniform();
      unsigned a = points_add(&p, r * cos(theta), 400 * (uniform() - 0.5), r * sin(theta), 0);
      double turn = 2 * PI * uniform(), up = i % 2 ? 0 : uniform() - 0.5;
      /* faces along the stem, or leaning against it */
      double n[3] = {cos(turn) * cos(up), sin(up), sin(turn) * cos(up)};
      double u[3] = {-n[1] * n[0], 1 - n[1] * n[1], -n[1] * n[2]}, l = sqrt(u[1]);
      set3(p.normal, a, n[0], n[1], n[2]);
      delta[i] = PI * (uniform() - 0.5) * 1.2;
      double light[3], aside = i % 3 ? 0 : 0.8 * (uniform() - 0.5);
      const double w[3] = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2],
                           n[0] * u[1] - n[1] * u[0]};
      for (int c = 0; c < 3; c++) {
        light[c] =
            (n[c] * cos(delta[i]) + u[c] / l * sin(delta[i])) * cos(aside) + w[c] / l * sin(aside);
        colour[c][i] = (float)uniform();
      }
      if (i % 3 == 0) delta[i] = 1e9; /* out of the plane: judged as a solid angle below */
      set3(p.light, a, light[0], light[1], light[2]);
    }
    sozai_batch b = {.size = sizeof b, .count = p.count, .out = p.out, .out_count = 17};
    for (int c = 0; c < 3; c++) {
      b.point[c] = p.point[c];
      b.normal[c] = p.normal[c];
      b.light[c] = p.light[c];
      b.light_colour[c] = colour[c];
    }
    assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
    for (int i = 0; i < N; i++) {
      double alpha = (double)p.out[DIVE][i], cosine, lobe;
      if (delta[i] < 1e8) {
        cosine = fmax(cos(delta[i]), 0);
        lobe = fmax(cos(delta[i] - alpha), 0);
      } else {
        /* the lobe's normal: N tilted by alpha towards +y within the surface */
        double n[3], v[3], l[3], up = 0, tilted = 0;
        for (int c = 0; c < 3; c++) {
          n[c] = (double)p.normal[c][i];
          l[c] = (double)p.light[c][i];
        }
        cosine = fmax(n[0] * l[0] + n[1] * l[1] + n[2] * l[2], 0);
        for (int c = 0; c < 3; c++) {
          v[c] = (c == 1) - n[1] * n[c];
          up += v[c] * v[c];
        }
        for (int c = 0; c < 3; c++) {
          tilted += l[c] * (n[c] * cos(alpha) + v[c] / sqrt(up) * sin(alpha));
        }
        lobe = fmax(tilted, 0);
      }
      for (int c = 0; c < 3; c++) {
        double want = (double)colour[c][i] *
                      (0.7 * (double)p.out[ALBEDO + c][i] * cosine + 0.3 * pow(lobe, exponents[k]));
        double error = fabs((double)p.out[RADIANCE + c][i] - want);
        if (delta[i] < 1e8)
          worst = fmax(worst, error);
        else
          worst_solid = fmax(worst_solid, error);
        asked++;
      }
    }
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(worst < 1e-5 && worst_solid < 1e-5,
        "%u radiances: off equation (4) by %.2g in the plane, %.2g out of it (1e-5)\n", asked,
        worst, worst_solid);
}

/* The brightest band of a wavy face is where alpha = delta: it moves. */
static void bands_move_with_the_light(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, PLAIN "porosity=none; fibre_brightness=0; grain=wavy; "
                                           "wave_length=20; wave_slope=0.15; specular=0.3; "
                                           "specular_tint=0; shininess=200");
  for (int k = -1; k <= 1; k++) {
    double delta = 7.2 * k * PI / 180, best = -1, where = 0;
    points p = {0};
    for (int i = 0; i < 2000; i++) {
      /* a radial face that looks against theta: alpha rises with the slope */
      unsigned a = points_add(&p, 80, 0.01 * i, 0, 0);
      set3(p.normal, a, 0, 0, -1);
      set3(p.light, a, 0, sin(delta), -cos(delta));
    }
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) {
      double gloss = (double)(p.out[RADIANCE][i]) - 0.9 * (double)p.out[ALBEDO][i] * cos(delta);
      if (gloss > best) {
        best = gloss;
        where = (double)p.out[DIVE][i];
      }
    }
    CHECK(fabs(where - delta) < 2e-3 && fabs(best - 0.3) < 1e-3,
          "delta %+.1f deg: brightest where alpha is %+.2f deg\n", 7.2 * k, where * 180 / PI);
    points_free(&p);
  }
  textures->destroy(t);
}

/* A square's light is the mean of its points': slopes that a footprint averages widen what is
 * reflected. Wide squares hold many waves, of which little but the mean is left. */
static void figure_keeps_its_light(void **state) {
  (void)state;
  static const struct {
    const char *preset, *cut;
    double most; /* of the mean */
  } figured[] = {{"curly_maple", "cut=flat", 0.03},
                 {"quilted_maple", "cut=flat", 0.04},
                 {"sycamore", "cut=quarter", 0.03},
                 {"itayakaede", "cut=quarter", 0.02}};
  static const double towards[][3] = {{0, 0, 1}, {0.35, 0.3, 0.887}, {0, 0.5, 0.866}};
  enum { SQUARES = 60, SIDE = 32 };
  for (int k = 0; k < 4; k++) {
    sozai_texture *t = wood_make(figured[k].preset, figured[k].cut);
    for (int v = 0; v < 3; v++) {
      for (double size = 30; size < 101; size += 70) {
        points p = {0};
        uniform_seed(47);
        for (int i = 0; i < SQUARES; i++) {
          double x = 200 * (uniform() - 0.5), y = 400 * (uniform() - 0.5);
          for (int j = 0; j <= SIDE * SIDE; j++) {
            double a = (j % SIDE + uniform()) / SIDE - 0.5, b = (j / SIDE + uniform()) / SIDE - 0.5;
            int all = j == SIDE * SIDE;
            unsigned at = points_add(&p, x + (all ? 0 : size * a), y + (all ? 0 : size * b), 0,
                                     all ? size : 0);
            set3(p.light, at, towards[v][0], towards[v][1], towards[v][2]);
            set3(p.view, at, -towards[v][0], -towards[v][1], towards[v][2]);
          }
        }
        points_ask(&p, t);
        double near = 0, far = 0;
        for (int i = 0, at = 0; i < SQUARES; i++, at++) {
          for (int j = 0; j < SIDE * SIDE; j++, at++)
            near += (double)p.out[RADIANCE][at] / (SIDE * SIDE * SQUARES);
          far += (double)p.out[RADIANCE][at] / SQUARES;
        }
        CHECK(fabs(far / near - 1) < figured[k].most,
              "%-14s light from (%.2f, %.2f): squares of %3.0f mm %.4f, their points %.4f: %+.1f "
              "%%\n",
              figured[k].preset, towards[v][0], towards[v][1], size, far, near,
              100 * (far / near - 1));
        points_free(&p);
      }
    }
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(dive_on_the_faces),
      cmocka_unit_test(equation_4),
      cmocka_unit_test(figure_keeps_its_light),
      cmocka_unit_test(bands_move_with_the_light),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
