/* SPDX-License-Identifier: Apache-2.0
 *
 * The fibres' cone (Marschner, Westin, Arbree and Moon 2005): it is the paper's
 * formula, the same both ways, and gives back no more light than it gets.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "cone_formula.h"
#include "wood.h"

#define WHITE                                                                                      \
  "earlywood_colour=1 1 1; latewood_colour=1 1 1; sapwood_earlywood_colour=1 1 1; "                \
  "sapwood_latewood_colour=1 1 1; "

static void set(float *const to[3], unsigned i, const double d[3]) {
  for (int c = 0; c < 3; c++) to[c][i] = (float)d[c];
}

/* A point with a light and an eye. */
static void add_lit(points *p, double x, double y, const double l[3], const double v[3]) {
  unsigned i = points_add(p, x, y, 0, 0);
  set(p->light, i, l);
  set(p->view, i, v);
}

static void the_papers_lobe(void **state) {
  (void)state;
  static const char *const cuts[] = {"flat", "quarter", "end", "rift"};
  static const double widths[] = {4, 11, 30}, iors[] = {1.2, 1.55, 1.8};
  uniform_seed(61);
  double worst = 0;
  for (int c = 0; c < 4; c++) {
    for (int k = 0; k < 3; k++) {
      char text[512];
      snprintf(text, sizeof text,
               CONE BLACK "cut=%s; grain=spiral; spiral_slope=0.3; cone_width=%g; ior=%g; "
                          "specular_tint=0; fibre_reflectance=0.05",
               cuts[c], widths[k], iors[k]);
      sozai_texture *t = wood_make(NULL, text);
      points p = {0};
      double l[2000][3], v[2000][3];
      for (unsigned i = 0; i < 2000; i++) {
        double x = 60 * uniform(), y = 60 * uniform();
        direction(0.05 + 0.95 * uniform(), 2 * PI * uniform(), l[i]);
        direction(0.05 + 0.95 * uniform(), 2 * PI * uniform(), v[i]);
        add_lit(&p, x, y, l[i], v[i]);
      }
      points_ask(&p, t);
      for (unsigned i = 0; i < 2000; i++) {
        double f[3] = {(double)p.out[FIBER][i], (double)p.out[FIBER + 1][i],
                       (double)p.out[FIBER + 2][i]};
        double lobe[3], left;
        for (int n = 0; n < 3; n++) lobe[n] = (double)p.out[FIBER_LOBE + n][i];
        left = sqrt(dot(lobe, lobe)); /* where it would reflect more than it receives */
        double want = (double)p.out[CONE_COLOUR][i] * left *
                      lobe_of(l[i], v[i], f, iors[k], widths[k] * PI / 180, 0);
        worst = fmax(worst, fabs((double)p.out[RADIANCE][i] - want) / (1e-3 + want));
        assert_true(fabs((double)p.out[CONE_WIDTH][i] - widths[k] * PI / 180) < 1e-4);
      }
      points_free(&p);
      textures->destroy(t);
    }
  }
  CHECK(worst < 2e-4, "lobe against the formula in double: %.2g relative\n", worst);
}

/* Under one light, of all views the brightest are on the cone psi_r = -psi_i. */
static void on_the_cone(void **state) {
  (void)state;
  sozai_texture *t =
      wood_make(NULL, CONE BLACK "cut=flat; grain=spiral; spiral_slope=0.2; cone_width=5");
  double l[3], worst = 0;
  int met = 0;
  direction(0.7, 1.2, l);
  for (int k = 0; k < 24; k++) {
    points p = {0};
    double around = 2 * PI * k / 24;
    for (unsigned i = 0; i < 900; i++) {
      double v[3];
      direction(cos(i * PI / 1800), around, v);
      add_lit(&p, 10, 20, l, v);
    }
    points_ask(&p, t);
    /* without the cosines of T and of the light, both smooth: where g peaks */
    double best = -1, at = 0, low = 9, high = -9, f[3];
    for (int c = 0; c < 3; c++) f[c] = (double)p.out[FIBER + c][0];
    for (unsigned i = 0; i < 850; i++) {
      double v[3] = {(double)p.view[0][i], (double)p.view[1][i], (double)p.view[2][i]};
      double off = inclination(v, f, 1.55) + inclination(l, f, 1.55);
      low = fmin(low, off);
      high = fmax(high, off);
      if ((double)p.out[RADIANCE][i] <= best) continue;
      best = (double)p.out[RADIANCE][i];
      at = off;
    }
    /* not every plane of views meets the cone */
    if (low < 0 && high > 0) worst = fmax(worst, fabs(at)), met++;
    points_free(&p);
  }
  textures->destroy(t);
  CHECK(worst < 1.5 * PI / 180 && met >= 6,
        "in %d planes the brightest view is %.2f degrees off the cone at most\n", met,
        worst * 180 / PI);
}

/* Where a vessel is cut open no fibre shines. */
static void not_in_vessels(void **state) {
  (void)state;
  sozai_texture *t =
      wood_make(NULL, "reflection=fibre_cone; fibre_brightness=0; porosity=diffuse; "
                      "vessel_density=20; vessel_diameter=200; vessel_colour=0 0 0; "
                      "sapwood_vessel_colour=0 0 0; " BLACK "cut=flat; specular_tint=0");
  points p = {0};
  uniform_seed(64);
  for (unsigned i = 0; i < 4000; i++) {
    double l[3], v[3], x = 50 * uniform(), y = 50 * uniform();
    direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), l);
    direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), v);
    add_lit(&p, x, y, l, v);
  }
  points_ask(&p, t);
  double worst = 0, most = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double l[3], v[3], f[3];
    for (int c = 0; c < 3; c++) {
      l[c] = (double)p.light[c][i], v[c] = (double)p.view[c][i], f[c] = (double)p.out[FIBER + c][i];
    }
    double open = (double)p.out[VESSEL][i];
    double lobe = (double)p.out[CONE_COLOUR][i] * lobe_of(l, v, f, 1.55, 11 * PI / 180, 0);
    worst = fmax(worst, fabs((double)p.out[RADIANCE][i] - (1 - open) * lobe));
    most = fmax(most, open);
  }
  points_free(&p);
  textures->destroy(t);
  CHECK(worst < 2e-5 && most > 0.99, "vessels of up to %.2f of a point: %.2g off\n", most, worst);
}

/* ---- rays: their cells lie along the radius ----------------------------- */

#define LEAN 0.09
#define THICKET                                                                                    \
  "pith_wander=0; undulation=0; specular_tint=0; ray_density=0.1; ray_height=10; ray_width=500; "
enum { WAYS = 24, PLACES = 5000 };

/* How far radiance at a place, of as many lights and eyes as there are, is off the lobe about an
 * axis that leans so from the radius, which is along x. Beside the ray's share there are fibres. */
static double off_the_lean(const points *p, unsigned at, double strength, double lean) {
  double whole = 1 / sqrt(1 + lean * lean), width = 11 * PI / 180, worst = 0;
  const double axis[3] = {whole, 0, lean * whole};
  for (unsigned i = at; i < at + WAYS; i++) {
    double l[3], v[3], f[3], ray = (double)p->out[RAY][i];
    for (int c = 0; c < 3; c++) {
      l[c] = (double)p->light[c][i], v[c] = (double)p->view[c][i];
      f[c] = (double)p->out[FIBER + c][i];
    }
    double lobe = 0.05 * (strength * ray * lobe_of(l, v, axis, 1.55, width, 0) +
                          (1 - ray) * lobe_of(l, v, f, 1.55, width, 0));
    worst = fmax(worst, fabs((double)p->out[RADIANCE][i] - lobe));
  }
  return worst;
}

/* The lean that it is least off: by thousandths, and then by fiftieths of those. */
static double lean_of(const points *p, unsigned at, double strength, double *error) {
  double best = 0;
  *error = 1e9;
  for (int pass = 0; pass < 2; pass++) {
    double middle = best;
    for (int k = -100; k <= 100; k++) {
      double lean = middle + k * (pass ? 2e-5 : 1e-3), off = off_the_lean(p, at, strength, lean);
      if (off < *error) *error = off, best = lean;
    }
  }
  return best;
}

/* A radial face, in a thicket of broad rays: what is theirs alone shines about an axis that is the
 * radius within five degrees, of one ray the same, as strongly as asked for. */
static void rays_shine(void **state) {
  (void)state;
  static const double lustres[] = {0, 1, 2};
  double leans[3][PLACES], worst = 0, square = 0, most = 0;
  unsigned met[3] = {0};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text,
             CONE BLACK THICKET "fibre_reflectance=0.05; ray_colour=0 0 0; ray_lustre=%g",
             lustres[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(65);
    for (int i = 0; i < PLACES; i++) {
      double x = 40 + 60 * uniform(), y = 400 * uniform(), l[3], v[3];
      for (int j = 0; j < WAYS; j++) {
        direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), l);
        direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), v);
        add_lit(&p, x, y, l, v);
      }
    }
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i += WAYS) {
      if (p.out[RAY][i] < 0.6f) continue;
      double error, lean = lean_of(&p, i, lustres[k], &error);
      leans[k][met[k]++] = lean;
      worst = fmax(worst, error);
    }
    points_free(&p);
    textures->destroy(t);
  }
  assert_true(met[0] == met[1] && met[1] == met[2] && met[1] > 20);
  for (unsigned i = 0; i < met[1]; i++) {
    assert_true(fabs(leans[1][i] - leans[2][i]) < 1e-3);
    square += leans[1][i] * leans[1][i] / met[1];
    most = fmax(most, fabs(leans[1][i]));
  }
  CHECK(worst < 1e-3,
        "%u places in rays, at lustres of 0, 1 and 2: %.2g off the lobe about an axis\n", met[1],
        worst);
  CHECK(most <= LEAN + 0.001 && sqrt(square) > 0.3 * LEAN && sqrt(square) < 0.85 * LEAN,
        "which leans by %.3f at most, rms %.3f\n", most, sqrt(square));
}

/* Where a footprint has many of them, their lobe is the mean of all leans. */
static void rays_from_afar(void **state) {
  (void)state;
  sozai_texture *t =
      wood_make(NULL, CONE BLACK THICKET "slope_noise=0; grain=straight; ray_colour=0 0 0; "
                                         "fibre_reflectance=0.05; ray_lustre=2");
  const double x_axis[3] = {1, 0, 0}, width = 11 * PI / 180;
  points p = {0};
  uniform_seed(67);
  for (int i = 0; i < 4000; i++) {
    double l[3], v[3];
    direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), l);
    direction(0.3 + 0.7 * uniform(), 2 * PI * uniform(), v);
    add_lit(&p, 80, 100, l, v);
    p.footprint[i] = 100;
  }
  points_ask(&p, t);
  double ray = (double)p.out[RAY][0], worst = 0, sharp = 0, most = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double l[3], v[3], f[3], mean = 0;
    for (int c = 0; c < 3; c++) {
      l[c] = (double)p.light[c][i], v[c] = (double)p.view[c][i], f[c] = (double)p.out[FIBER + c][i];
    }
    for (int k = 0; k < 64; k++) {
      double lean = LEAN * ((k + 0.5) / 32 - 1), whole = 1 / sqrt(1 + lean * lean);
      mean += lobe_of(l, v, (double[3]){whole, 0, lean * whole}, 1.55, width, 0) / 64;
    }
    double fibres = (1 - ray) * lobe_of(l, v, f, 1.55, width, 0);
    double told = (double)p.out[RADIANCE][i], want = 0.05 * (2 * ray * mean + fibres);
    double level = 0.05 * (2 * ray * lobe_of(l, v, x_axis, 1.55, width, 0) + fibres);
    most = fmax(most, 0.05 * 2 * ray * mean);
    worst = fmax(worst, fabs(told - want));
    sharp = fmax(sharp, fabs(level - want));
  }
  points_free(&p);
  textures->destroy(t);
  CHECK(ray > 0.05 && worst < 0.02 * most && sharp > 0.1 * most,
        "over 100 mm, rays of %.2f: %.3f of the brightest off the mean of leans; without, %.3f\n",
        ray, worst / most, sharp / most);
}

/* The second's cut meets rays, too. */
static const char *const exchanged[][2] = {
    {"keyaki", "reflection=fibre_cone; coat=0.7; cut=rift; grain=compound"},
    {"silky_oak", "coat=0.7; cut=quarter; grain=compound; ray_density=0.2; ray_lustre=3"}};

static void both_ways(void **state) {
  (void)state;
  for (unsigned k = 0; k < sizeof exchanged / sizeof *exchanged; k++) {
    sozai_texture *t = wood_make(exchanged[k][0], exchanged[k][1]);
    points p = {0};
    uniform_seed(62);
    for (unsigned i = 0; i < 4000; i += 2) {
      double x = 50 * uniform(), y = 50 * uniform(), a[3], b[3];
      direction(0.1 + 0.9 * uniform(), 2 * PI * uniform(), a);
      direction(0.1 + 0.9 * uniform(), 2 * PI * uniform(), b);
      add_lit(&p, x, y, a, b);
      add_lit(&p, x, y, b, a);
    }
    points_ask(&p, t);
    double worst = 0, most = 0;
    for (unsigned i = 0; i < p.count; i += 2) {
      double one = (double)(p.out[RADIANCE][i] / p.light[2][i]);
      double two = (double)(p.out[RADIANCE][i + 1] / p.light[2][i + 1]);
      worst = fmax(worst, fabs(one - two) / one);
      most = fmax(most, (double)p.out[RAY][i]);
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(worst < 1e-4, "%s, light and eye exchanged: %.2g relative\n", exchanged[k][0], worst);
    if (k) CHECK(most > 0.9, "rays of up to %.2f of a point\n", most);
  }
}

/* Over Kawai's equation (4): what the coat reflects, by GGX and Smith in double, and the rest as
 * far as it lets light in and out. */
static double coat_of(const double l[3], const double v[3], double eta, double alpha) {
  double h[3], a2 = alpha * alpha, size = 0;
  for (int c = 0; c < 3; c++) h[c] = l[c] + v[c], size += h[c] * h[c];
  for (int c = 0; c < 3; c++) h[c] /= sqrt(size);
  double d = h[2] * h[2] * (a2 - 1) + 1, a = l[2], b = v[2];
  double smith = a * sqrt(b * b * (1 - a2) + a2) + b * sqrt(a * a * (1 - a2) + a2);
  return fresnel_of(dot(v, h), eta) * a2 * l[2] / (2 * d * d * smith);
}

static void over_kawai(void **state) {
  (void)state;
  sozai_texture *bare = wood_make("keyaki", "cut=rift; grain=compound");
  sozai_texture *clad = wood_make("keyaki", "cut=rift; grain=compound; coat=0.7; ior=1.5; "
                                            "coat_roughness=0.4");
  points p = {0}, q = {0};
  uniform_seed(63);
  for (unsigned i = 0; i < 4000; i++) {
    double x = 50 * uniform(), y = 50 * uniform(), l[3], v[3];
    direction(0.05 + 0.95 * uniform(), 2 * PI * uniform(), l);
    direction(0.05 + 0.95 * uniform(), 2 * PI * uniform(), v);
    add_lit(&p, x, y, l, v);
    add_lit(&q, x, y, l, v);
  }
  points_ask(&p, bare);
  points_ask(&q, clad);
  double worst = 0, most = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double l[3], v[3];
    for (int c = 0; c < 3; c++) l[c] = (double)p.light[c][i], v[c] = (double)p.view[c][i];
    double through = (1 - 0.7 * fresnel_of(l[2], 1.5)) * (1 - 0.7 * fresnel_of(v[2], 1.5));
    double coat = 0.7 * coat_of(l, v, 1.5, 0.16);
    double want = (double)p.out[RADIANCE][i] * through + coat;
    worst = fmax(worst, fabs((double)q.out[RADIANCE][i] - want) / (1e-3 + want));
    most = fmax(most, coat);
  }
  points_free(&p);
  points_free(&q);
  textures->destroy(bare);
  textures->destroy(clad);
  CHECK(worst < 2e-4 && most > 0.2, "a coat over equation (4), up to %.2f: %.2g relative\n", most,
        worst);
}

/* The least coat of each finish, and of char; a parameter's own where that is more. And how rough
 * it is: satin where it is no film, wider by what a footprint has lost of the relief. */
static void of_finishes(void **state) {
  (void)state;
  static const struct {
    const char *text;
    double coat, roughness, wider; /* the last: at most, with relief */
  } cases[] = {{"finish=raw", 0, 0.25, 0},
               {"finish=oiled", 0.3, 0.45, 0},
               {"finish=lacquered", 1, 0.25, 0},
               {"finish=oiled; coat=0.6", 0.6, 0.25, 0},
               {"finish=lacquered; coat_roughness=0.1", 1, 0.1, 0},
               {"finish=lacquered; reflection=fibre_cone", 1, 0.25, 0},
               {"finish=lacquered; surface=brushed", 1, 0.25, 0.8},
               {"surface=charred; charring=1", 0.5, 0.45, 1.01}};
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    sozai_texture *t = wood_make("keyaki", cases[k].text);
    points p = {0};
    points_add(&p, 10, 20, 0, 0);
    points_add(&p, 10, 20, 0, 20);
    points_ask(&p, t);
    double coat = (double)p.out[COAT][0], near = (double)p.out[COAT_ROUGHNESS][0],
           far = (double)p.out[COAT_ROUGHNESS][1];
    CHECK(fabs(coat - cases[k].coat) < 1e-6, "%s: coat %.2f\n", cases[k].text, coat);
    double most = cases[k].wider > 0 ? cases[k].wider : cases[k].roughness + 1e-6;
    double least = cases[k].wider > 0 ? cases[k].roughness + 0.02 : cases[k].roughness - 1e-6;
    CHECK(fabs(near - cases[k].roughness) < 1e-6 && far > least && far < most,
          "%s: as rough as %.3f, over 20 mm %.3f\n", cases[k].text, near, far);
    points_free(&p);
    textures->destroy(t);
  }
}

/* ---- the furnace ------------------------------------------------------- */

/* Reflected radiance of a place under a white sky of radiance 1, by a grid of lights. */
static double furnace_at(sozai_texture *t, double x, double y, const double v[3], int channel) {
  enum { UP = 100, ROUND = 200 };
  points p = {0};
  for (int i = 0; i < UP; i++) {
    for (int j = 0; j < ROUND; j++) {
      double l[3];
      direction((i + 0.5) / UP, 2 * PI * (j + 0.5) / ROUND, l);
      add_lit(&p, x, y, l, v);
    }
  }
  points_ask(&p, t);
  double sum = 0;
  for (unsigned i = 0; i < p.count; i++) sum += (double)p.out[RADIANCE + channel][i];
  points_free(&p);
  return sum * 2 / (UP * ROUND);
}

static double furnace(sozai_texture *t, const double v[3], int channel) {
  return furnace_at(t, 10, 20, v, channel);
}

static void white_furnace(void **state) {
  (void)state;
  static const char *const cuts[] = {"flat", "rift; spiral_slope=0.5; grain=spiral", "end",
                                     "quarter; spiral_slope=1; grain=spiral"};
  static const char *const surfaces[] = {
      "cone_width=3; coat=0",
      "cone_width=11; coat=0",
      "cone_width=45; coat=0; ior=1.01",
      "cone_width=11; coat=1; coat_roughness=0.3",
      "cone_width=6; coat=1; coat_roughness=1; ior=3",
      "cone_width=20; coat=0.5; coat_roughness=0.5; fibre_reflectance=0.1"};
  double worst = 0, least = 9;
  for (int c = 0; c < 4; c++) {
    for (int k = 0; k < 6; k++) {
      char text[700];
      snprintf(text, sizeof text, CONE WHITE "fibre_reflectance=1; specular_tint=0; cut=%s; %s",
               cuts[c], surfaces[k]);
      sozai_texture *t = wood_make(NULL, text);
      double most = 0, lowest = 9;
      for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 4; j++) {
          double v[3];
          direction(cos((i + 0.3) * PI / 16), j * PI / 4 + 0.2, v);
          double e = furnace(t, v, 1);
          most = fmax(most, e);
          lowest = fmin(lowest, e);
        }
      }
      print_message("%-38s %-68s gives back %.3f to %.3f\n", cuts[c], surfaces[k], lowest, most);
      worst = fmax(worst, most);
      least = fmin(least, lowest);
      textures->destroy(t);
    }
  }
  /* the grid of lights and the table are good to half a per cent where the lobe is narrow */
  CHECK(worst < 1.005 && least > 0.1, "at most %.4f of the light comes back, at least %.4f\n",
        worst, least);
}

/* Rays give back no more, however bright they are to be. */
/* Ten times as bright as fibres that leave room for that, and as those that do not. */
static void rays_in_the_furnace(void **state) {
  (void)state;
  static const double reflectances[] = {0.03, 0.3};
  for (int k = 0; k < 2; k++) {
    char text[512];
    snprintf(text, sizeof text,
             CONE WHITE THICKET
             "fibre_reflectance=%g; ray_lustre=10; ray_colour=1 1 1; cut=quarter",
             reflectances[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(66);
    for (int i = 0; i < 5000; i++) points_add(&p, 40 + 60 * uniform(), 400 * uniform(), 0, 0);
    points_ask(&p, t);
    unsigned at = 0;
    for (unsigned i = 0; i < p.count; i++) {
      if (p.out[RAY][i] > p.out[RAY][at]) at = i;
    }
    double ray = (double)p.out[RAY][at], most = 0, least = 9;
    for (int i = 0; i < 8; i++) {
      for (int j = 0; j < 4; j++) {
        double v[3];
        direction(cos((i + 0.3) * PI / 16), j * PI / 4 + 0.2, v);
        double e = furnace_at(t, (double)p.point[0][at], (double)p.point[1][at], v, 1);
        most = fmax(most, e);
        least = fmin(least, e);
      }
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(ray > 0.9 && most < 1.005 && least > 0.9,
          "of a ray's %.2f, ten times as bright as %.2f, %.3f to %.3f of the light comes back\n",
          ray, reflectances[k], least, most);
  }
}

/* With vessels as white, too, wherever the place is: there all is diffuse. */
static void nothing_lost(void **state) {
  (void)state;
  static const char *const porosity[] = {"none", "diffuse; vessel_density=20; vessel_diameter=200"};
  for (int k = 0; k < 2; k++) {
    char text[700];
    snprintf(text, sizeof text,
             CONE WHITE "cut=flat; specular_tint=0; fibre_reflectance=0.2; vessel_colour=1 1 1; "
                        "sapwood_vessel_colour=1 1 1; porosity=%s",
             porosity[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(68);
    for (int i = 0; i < 2000; i++) points_add(&p, 50 * uniform(), 50 * uniform(), 0, 0);
    points_ask(&p, t);
    unsigned at = 0;
    for (unsigned i = 0; i < p.count; i++) {
      if (p.out[VESSEL][i] > p.out[VESSEL][at]) at = i;
    }
    double worst = 0, vessel = (double)p.out[VESSEL][at];
    for (int i = 0; i < 8; i++) {
      double v[3];
      direction(cos((i + 0.3) * PI / 16), 0.7 * i, v);
      double e = furnace_at(t, (double)p.point[0][at], (double)p.point[1][at], v, 1);
      worst = fmax(worst, fabs(e - 1));
    }
    points_free(&p);
    textures->destroy(t);
    CHECK(worst < 0.02 && (vessel > 0.99) == k,
          "white raw wood, of it vessel %.2f, gives back all but %.4f\n", vessel, worst);
  }
}

/* Kawai's literal mode asks for no view. */
static void kawai_as_before(void **state) {
  (void)state;
  sozai_texture *t = wood_make("keyaki", "cut=flat");
  points p = {0};
  for (unsigned i = 0; i < 2; i++) {
    points_add(&p, 3, 4, 0, 0);
    set(p.light, i, (double[3]){0.3, 0.4, 0.87});
    set(p.view, i, i ? (double[3]){0.5, 0.2, 0.84} : (double[3]){0, 0, 1});
  }
  points_ask(&p, t);
  assert_true(p.out[RADIANCE][0] == p.out[RADIANCE][1]);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_papers_lobe), cmocka_unit_test(on_the_cone),
      cmocka_unit_test(not_in_vessels),  cmocka_unit_test(rays_shine),
      cmocka_unit_test(rays_from_afar),  cmocka_unit_test(both_ways),
      cmocka_unit_test(over_kawai),      cmocka_unit_test(of_finishes),
      cmocka_unit_test(white_furnace),   cmocka_unit_test(rays_in_the_furnace),
      cmocka_unit_test(nothing_lost),    cmocka_unit_test(kawai_as_before)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
