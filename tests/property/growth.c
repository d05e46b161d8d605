/* SPDX-License-Identifier: Apache-2.0
 *
 * Figure of the growth front: fibres lie in the rings' surfaces and a walk stays
 * on its fibre, slopes are those asked for, rings never cross, and bird's eyes
 * are as many to an area as asked for.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
#define ROUND                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; slope_noise=0; taper=0; porosity=none; "         \
  "fibre_brightness=0; ring_variation=0; ring_width=2; "
#define WIDE "pith_wander=12; undulation=2; section_wobble=0.1; taper=10; "

static const char *const figures[] = {
    WIDE "curl_slope=0.25; curl_length=9; curl_irregularity=1",
    WIDE "quilt_slope=0.2; quilt_height=12; quilt_width=22",
    WIDE "quilt_slope=0.11; quilt_height=8; quilt_width=8",
    WIDE "eye_density=0.9; eye_diameter=3.5; eye_depth=0.6",
    WIDE "grain=compound; wave_length=15; curl_slope=0.1; quilt_slope=0.1; eye_density=0.5",
};
#define FIGURES (sizeof figures / sizeof *figures)

/* One metre by Runge and Kutta's fourth-order rule in double; only the field
 * is the plugin's. */
static void a_walk_stays_on_its_fibre(void **state) {
  (void)state;
  enum { WALKERS = 64 };
  static double at[WALKERS][3], k[4][WALKERS][3], first[WALKERS][2];
  for (unsigned f = 0; f < FIGURES; f++) {
    /* an eye's wall is bent within a few tenths of a millimetre */
    const double step = strstr(figures[f], "eye_density") ? 0.04 : 0.1;
    sozai_texture *t = wood_make(NULL, figures[f]);
    points p = {0};
    double worst = 0, dives = 0;
    uniform_seed(91);
    for (int w = 0; w < WALKERS; w++) {
      double r = 15 + 165 * uniform(), theta = 2 * PI * uniform();
      at[w][0] = r * cos(theta);
      at[w][1] = 800 * (uniform() - 0.5);
      at[w][2] = r * sin(theta);
    }
    for (int n = 0; n <= (int)(1000 / step); n++) {
      for (int stage = 0; stage < 4; stage++) {
        points_clear(&p);
        for (int w = 0; w < WALKERS; w++) {
          double h = stage == 0 ? 0 : stage == 3 ? step : 0.5 * step, q[3];
          for (int c = 0; c < 3; c++) q[c] = at[w][c] + (stage ? h * k[stage - 1][w][c] : 0);
          points_add(&p, q[0], q[1], q[2], 0);
        }
        points_ask(&p, t);
        for (int w = 0; w < WALKERS; w++) {
          for (int c = 0; c < 3; c++) k[stage][w][c] = (double)p.out[FIBER + c][w];
          if (stage) continue;
          double x = (double)p.out[REFERENCE][w], z = (double)p.out[REFERENCE + 1][w];
          if (n == 0) first[w][0] = x, first[w][1] = z;
          worst = fmax(worst, hypot(x - first[w][0], z - first[w][1]));
          double r = hypot(at[w][0], at[w][2]);
          dives = fmax(dives, fabs(k[0][w][0] * at[w][0] + k[0][w][2] * at[w][2]) / r);
        }
      }
      for (int w = 0; w < WALKERS; w++) {
        for (int c = 0; c < 3; c++)
          at[w][c] += step / 6 * (k[0][w][c] + 2 * k[1][w][c] + 2 * k[2][w][c] + k[3][w][c]);
      }
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(
        worst < 1e-3 && dives > 0.1,
        "%s\n  1 m on %d fibres, along the radius by up to %.2f: reference drifts %.2g mm (1e-3)\n",
        figures[f] + sizeof WIDE - 1, WALKERS, dives, worst);
  }
}

/* The direction against the gradient of time, by differences. */
static void fibres_lie_in_the_rings(void **state) {
  (void)state;
  enum { PLACES = 4000 };
  const double h = 0.01;
  for (unsigned f = 0; f < FIGURES; f++) {
    char text[512];
    snprintf(text, sizeof text, "%s; ring_width=4; ring_variation=0", figures[f]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(92);
    for (int i = 0; i < PLACES; i++) {
      double r = 20 + 150 * uniform(), theta = 2 * PI * uniform(), y = 600 * uniform();
      for (int c = 0; c < 7; c++) {
        double d[3] = {0, 0, 0};
        if (c) d[(c - 1) / 2] = c & 1 ? h : -h;
        points_add(&p, r * cos(theta) + d[0], y + d[1], r * sin(theta) + d[2], 0);
      }
    }
    points_ask(&p, t);
    double worst = 0, rms = 0;
    int n = 0;
    for (int i = 0; i < PLACES; i++) {
      double g[3], size = 0, along = 0;
      for (int c = 0; c < 3; c++) {
        g[c] = (double)p.out[TIME][7 * i + 1 + 2 * c] - (double)p.out[TIME][7 * i + 2 + 2 * c];
        size += g[c] * g[c];
        along += g[c] * (double)p.out[FIBER + c][7 * i];
      }
      double sine = fabs(along) / sqrt(size);
      worst = fmax(worst, sine);
      rms += sine * sine / PLACES;
      n++;
    }
    points_free(&p);
    textures->destroy(t);
    /* differences of years rounded to float: 4e-6 in 5e-3; the creases and an
     * eye's middle curve within the step */
    CHECK(worst < 0.02 && sqrt(rms) < 2e-3,
          "%s\n  sine of the angle between fibre and ring: %.2g rms, %.2g at most, %d places\n",
          figures[f] + sizeof WIDE - 1, sqrt(rms), worst, n);
  }
}

static void rings_never_cross(void **state) {
  (void)state;
  static const char *const steepest[] = {
      "curl_slope=1; curl_length=40; curl_irregularity=1; curl_reach=250",
      "curl_slope=0.8; curl_length=10; curl_irregularity=0.8; curl_reach=40",
      "quilt_slope=0.234; quilt_height=10; quilt_width=20; undulation=0.4; undulation_size=10",
      "quilt_slope=0.117; quilt_height=30; quilt_width=30; undulation=0.9; undulation_size=10",
      "eye_density=0.13; eye_diameter=9; eye_depth=0.19; eye_length=30",
      "eye_density=0.9; eye_diameter=3.5; eye_depth=1; eye_length=62",
  };
  for (unsigned f = 0; f < sizeof steepest / sizeof *steepest; f++) {
    sozai_texture *t = wood_make(NULL, steepest[f]);
    points p = {0};
    double least = 1e9, worst = 0;
    uniform_seed(93);
    for (int k = 0; k < 400; k++) {
      double theta = 2 * PI * uniform(), y = 3000 * (uniform() - 0.5);
      float height = (float)y, px, pz;
      woods->pith(t, 1, &height, &px, &pz);
      points_clear(&p);
      for (int i = 0; i < 2000; i++) {
        double r = 2 + 0.1 * i;
        points_add(&p, (double)px + r * cos(theta), y, (double)pz + r * sin(theta), 0);
      }
      points_ask(&p, t);
      for (unsigned i = 1; i < p.count; i++)
        least = fmin(least, (double)p.out[TIME][i] - (double)p.out[TIME][i - 1]);
      for (unsigned i = 0; i < p.count; i += 50) {
        float angle = (float)theta, r;
        woods->ring_radius(t, 1, &p.out[TIME][i], &angle, &height, &r);
        worst = fmax(worst, fabs((double)r / (2 + 0.1 * i) - 1));
      }
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(least > 0 && worst < 2e-5,
          "%s: outwards time rises, by %.2g years a step at least; R(T(r)) = r to %.2g\n",
          steepest[f], least, worst);
  }
}

/* The slope along the radius, on the +x side. */
static void slopes_are_those_asked_for(void **state) {
  (void)state;
  static const struct {
    const char *parameters;
    double greatest, rms;
  } cases[] = {
      {ROUND "curl_slope=0.2; curl_length=12; curl_irregularity=0", 0.2, 0.2 * 0.7071},
      {ROUND "quilt_slope=0.15; quilt_height=10; quilt_width=20", 0, 0.15},
      {ROUND "quilt_slope=0.05; quilt_height=30; quilt_width=20", 0, 0.05},
  };
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    sozai_texture *t = wood_make(NULL, cases[k].parameters);
    points p = {0};
    uniform_seed(94);
    for (int i = 0; i < 40000; i++) {
      double r = 80 + 100 * uniform(), theta = 2 * PI * uniform();
      points_add(&p, r * cos(theta), 100 + 4000 * uniform(), r * sin(theta), 0);
    }
    points_ask(&p, t);
    double most = 0, square = 0;
    for (unsigned i = 0; i < p.count; i++) {
      double x = (double)p.point[0][i], z = (double)p.point[2][i], r = hypot(x, z);
      double s = (x * (double)p.out[FIBER][i] + z * (double)p.out[FIBER + 2][i]) / r;
      s /= (double)p.out[FIBER + 1][i];
      most = fmax(most, fabs(s));
      square += s * s / p.count;
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(fabs(sqrt(square) - cases[k].rms) < 0.15 * cases[k].rms &&
              (cases[k].greatest == 0 || fabs(most - cases[k].greatest) < 2e-3),
          "%s: slope %.4f rms (%.4f), %.4f at most\n", cases[k].parameters + sizeof ROUND - 1,
          sqrt(square), cases[k].rms, most);
  }
}

/* Eyes on an unrolled tangential face, by what they do to the year. */
static void eyes_are_as_many_as_asked_for(void **state) {
  (void)state;
  static const struct { double density, diameter; } cases[] = {{0.3, 3}, {0.8, 3.5}, {1.5, 1.8}};
  static const double radii[] = {90, 131, 170};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text,
             ROUND "eye_density=%g; eye_diameter=%g; eye_depth=0.5; eye_length=50",
             cases[k].density, cases[k].diameter);
    sozai_texture *t = wood_make(NULL, text);
    double found = 0, pieces = 0, want = 0, width = 0, all = 0, outline = 0, places = 0;
    for (int r = 0; r < 3; r++) {
      double step = 0.12 * cases[k].diameter, tall = 400;
      int nx = (int)(2 * PI * radii[r] / step), ny = (int)(tall / step);
      unsigned char *in = calloc((size_t)(nx * ny), 1);
      float *year = malloc(sizeof(float) * (size_t)(nx * ny));
      float *shade = malloc(sizeof(float) * (size_t)(nx * ny));
      int *stack = malloc(sizeof(int) * (size_t)(nx * ny));
      points p = {0};
      for (int j = 0; j < ny; j++) {
        points_clear(&p);
        for (int i = 0; i < nx; i++) {
          double a = (i + 0.5) * step / radii[r];
          points_add(&p, radii[r] * cos(a), 50 + (j + 0.5) * step, radii[r] * sin(a), 0);
        }
        points_ask(&p, t);
        /* a tenth of the mean eye's depth; rings are 2 mm wide */
        double dent = 0.1 * 0.5 * 0.5 * cases[k].diameter / 2;
        for (int i = 0; i < nx; i++) {
          year[j * nx + i] = p.out[TIME][i];
          shade[j * nx + i] = p.out[ALBEDO][i];
          all += (double)p.out[ALBEDO][i];
          places++;
          in[j * nx + i] = (double)p.out[TIME][i] > radii[r] / 2 + dent;
        }
      }
      points_free(&p);
      /* as many as there are deepest places: two that touch are two */
      for (int at = nx; at < nx * (ny - 1); at++) {
        int left = at % nx ? at - 1 : at + nx - 1, right = (at + 1) % nx ? at + 1 : at + 1 - nx;
        const int beside[8] = {left,      right,     at - nx,    at + nx,
                               left - nx, left + nx, right - nx, right + nx};
        int deepest = in[at];
        for (int k = 0; k < 8; k++)
          deepest &= year[at] > year[beside[k]] || (year[at] == year[beside[k]] && at < beside[k]);
        found += deepest;
        /* an eighth of the mean eye's width up and down */
        if (deepest && at >= nx && at < nx * (ny - 1))
          outline += 0.5 * (double)(shade[at - nx] + shade[at + nx]);
        else
          outline += deepest * (double)shade[at];
      }
      for (int at = 0; at < nx * ny; at++) {
        if (!in[at]) continue;
        int depth = 0, left = nx, right = -nx, first = at % nx;
        stack[depth++] = at;
        in[at] = 0;
        while (depth) {
          int q = stack[--depth], i = q % nx, j = q / nx, dx = (i - first + nx + nx / 2) % nx;
          left = dx < left ? dx : left;
          right = dx > right ? dx : right;
          for (int d = 0; d < 4; d++) {
            int x = (i + (d == 0) - (d == 1) + nx) % nx, y = j + (d == 2) - (d == 3);
            if (y < 0 || y >= ny || !in[y * nx + x]) continue;
            in[y * nx + x] = 0;
            stack[depth++] = y * nx + x;
          }
        }
        pieces++;
        width += (right - left + 1) * step;
      }
      want += cases[k].density * 0.01 * nx * step * tall;
      free(in);
      free(year);
      free(shade);
      free(stack);
    }
    textures->destroy(t);
    /* a tenth of the depth lies where (1 - q)^3 is a tenth: at 0.73 of the radius */
    print_message("%g/cm2 of %g mm: %.0f eyes, %.0f wanted; %.2f mm across at a tenth\n",
                  cases[k].density, cases[k].diameter, found, want, width / pieces);
    double darker = 1 - outline / found * places / all;
    CHECK(darker > 0.05, "their outlines reflect %.3f less than the wood\n", darker);
    assert_true(fabs(found - want) < 3 * sqrt(want) + 0.03 * want);
    assert_true(fabs(width / pieces - 0.73 * cases[k].diameter) < 0.15 * cases[k].diameter);
  }
}

static void what_has_no_room_is_refused(void **state) {
  (void)state;
  static const char *const bad[][2] = {
      {"quilt_slope=0.3; quilt_height=20; quilt_width=20", "quilt_slope"},
      {"eye_density=3; eye_diameter=4", "eye_density"},
      {"curl_slope=nan", "curl_slope"},
      {"curl_slope=0.3; curl_length=40; curl_irregularity=1; curl_reach=20", "curl_slope"},
      {"curl_reach=0", "curl_reach"},
      {"wave_reach=1e30", "wave_reach"},
      {"interlocked_irregularity=1.5", "interlocked_irregularity"},
      {"curl_length=0", "curl_length"},
      {"eye_depth=1e30", "eye_depth"},
  };
  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
    const char *why = wood_refused(bad[i][0]);
    CHECK(why && strstr(why, bad[i][1]), "%s: %s\n", bad[i][0], why ? why : "made");
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_walk_stays_on_its_fibre),
      cmocka_unit_test(fibres_lie_in_the_rings),
      cmocka_unit_test(rings_never_cross),
      cmocka_unit_test(slopes_are_those_asked_for),
      cmocka_unit_test(eyes_are_as_many_as_asked_for),
      cmocka_unit_test(what_has_no_room_is_refused),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
