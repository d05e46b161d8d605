/* SPDX-License-Identifier: Apache-2.0
 *
 * Knots: they stand where the tree's branches do, with the branches' radii and
 * years; rings never cross and a walk along the fibre stays on it about them; a
 * footprint sees the mean of its points; and tables that will not do are refused.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
#define PLAIN                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; taper=0; slope_noise=0; fibre_brightness=0; "    \
  "ring_variation=0; porosity=none; "
/* as trees are: sugi's spiral, the whorls of a pine, a broadleaf's thick limbs */
static const char *const trees[][2] = {
    {"sugi", "tree=sugi; tree_age=40; log_height=4000"},
    {"akamatsu", "tree=akamatsu; tree_age=45; log_height=6000"},
    {"keyaki", "tree=keyaki; tree_age=60; log_height=5000; knot_size=0.6"},
};
#define TREES (sizeof trees / sizeof *trees)

/* ---- one knot, given as a table ----------------------------------------- */

/* Years 1 to 60 of a stem 4 m high that grows 2 mm a year, and on it one branch. */
static float rings[60 * 2][3], radii[60][3], knot[1][10];

static void one_branch(double death, double shed, double azimuth, double rise) {
  for (int year = 1; year <= 60; year++) {
    for (int end = 0; end < 2; end++) {
      float *row = rings[2 * (year - 1) + end];
      row[0] = (float)year;
      row[1] = end ? 4000.0f : 0.0f;
      row[2] = 2.0f * (float)year;
    }
    radii[year - 1][0] = 0;
    radii[year - 1][1] = (float)year;
    radii[year - 1][2] = 0.4f * (float)(death > 0 && year > death ? death : year);
  }
  const double row[10] = {-1, 0, death, shed, azimuth, rise, 2000, (double)radii[59][2], 0, 60};
  for (int c = 0; c < 10; c++) knot[0][c] = (float)row[c];
}

static sozai_texture *with_tables(int with_radii, int with_rings) {
  static const char *const plain[][2] = {
      {"pith_wander", "0"},    {"undulation", "0"},    {"section_wobble", "0"},
      {"taper", "0"},          {"slope_noise", "0"},   {"fibre_brightness", "0"},
      {"ring_variation", "0"}, {"log_height", "2000"}, {"ring_width", "2"},
      {"porosity", "none"},    {"knot_bark", "1.5"},   {"knot_checks", "0"}};
  const sozai_buffer buffers[3] = {
      {.size = sizeof(sozai_buffer), .kind = SOZAI_BUFFER_TABLE, .dims = {1, 10}, .data = knot[0]},
      {.size = sizeof(sozai_buffer), .kind = SOZAI_BUFFER_TABLE, .dims = {60, 3}, .data = radii[0]},
      {.size = sizeof(sozai_buffer),
       .kind = SOZAI_BUFFER_TABLE,
       .dims = {120, 3},
       .data = rings[0]}};
  static const char *const ids[3] = {"knots", "knot_radii", "stem_rings"};
  sozai_value values[16];
  unsigned n = 0;
  memset(values, 0, sizeof values);
  for (unsigned i = 0; i < sizeof plain / sizeof *plain; i++, n++) {
    values[n].id = plain[i][0];
    values[n].kind = SOZAI_KIND_STRING;
    values[n].text = plain[i][1];
  }
  for (int i = 0; i < 3; i++) {
    if ((i == 1 && !with_radii) || (i == 2 && !with_rings)) continue;
    values[n].id = ids[i];
    values[n].kind = SOZAI_KIND_BUFFER;
    values[n++].buffer = &buffers[i];
  }
  sozai_texture *t = NULL;
  textures->create(NULL, "wood", NULL, values, n, &t);
  return t;
}

/* The branch's radius where the stem's is rho, and the knot's in the plane z =
 * rho, seen along it: of growth in step the axis' cone of slope 0.2. */
static void radius_bark_and_scar(void **state) {
  (void)state;
  one_branch(30, 40, PI / 2, 0);
  sozai_texture *t = with_tables(1, 1);
  assert_non_null(t);
  points p = {0};
  double worst = 0, bark = 0, least = 1, most = 0;
  int cap = 0;
  for (int n = 0; n < 40; n++) {
    double z = 10 + 2.5 * n, dead = 60, gone = 80;
    points_clear(&p);
    for (int i = -4000; i < 4000; i++) points_add(&p, 0, 0.005 * (i + 0.5), z, 0);
    points_ask(&p, t);
    double edge = 0, skin = 0, up = 0;
    for (int i = 0; i < 8000; i++) {
      edge += 0.0025 * (double)p.out[KNOT][i];
      up += 0.005 * (double)(i >= 4000 ? p.out[KNOT][i] : 0);
      skin += 0.0025 * (p.out[KNOT][i] < 0.01f && p.out[ALBEDO][i] < 0.06f);
    }
    /* the pith is nearer the upper side, of what is oblong by a seventh at most: half its
     * height is within 7 % of the circle's, and as much more as an oval's about its focus */
    double radius = 0.2 * (z < dead ? z : dead);
    /* its end is rounded and aslant, by 0.95 radii at most */
    if (z < gone - 0.95 * radius) {
      worst = fmax(worst, fabs(edge / radius - 1));
      if (radius > 3) {
        least = fmin(least, up / edge);
        most = fmax(most, up / edge);
      }
      if (z > dead + 5) bark = fmax(bark, fabs(skin - 1.5));
    } else if (z > gone + 3) {
      cap += edge > 0;
    }
  }
  points_free(&p);
  textures->destroy(t);
  CHECK(worst < 0.1 && bark < 0.15 && cap == 0 && least > 0.75 && most < 0.93,
        "radius within %.1f %% of the branch's (10: oblong), of which %.2f to %.2f lie above the "
        "pith (0.75 to 0.93), bark 1.5 mm within %.2f (0.15), %d places of 40 with a knot beyond "
        "its end (0)\n",
        100 * worst, least, most, bark, cap);
}

/* A branch that lives, or has never been shed, on a board wider than the stem: beyond the tree's
 * years it ends as others do, in wood, and not at a plane. */
static void ends_beyond_the_tree(void **state) {
  (void)state;
  enum { FROM = 110, TO = 700, ACROSS = 1200 };
  static const double deaths[] = {-1, 40};
  double fall = 0, first = TO, last = 0;
  points p = {0};
  for (int n = 0; n < 2; n++) {
    one_branch(deaths[n], -1, PI / 2, 0);
    sozai_texture *t = with_tables(1, 1);
    assert_non_null(t);
    double radius = deaths[n] < 0 ? 24 : 16, before = radius, end = 0;
    for (int z = FROM; z < TO; z++) {
      points_clear(&p);
      for (int i = 0; i < ACROSS; i++) points_add(&p, 0, 0.05 * (i - ACROSS / 2 + 0.5), z, 0);
      points_ask(&p, t);
      double edge = 0;
      for (int i = 0; i < ACROSS; i++) edge += 0.025 * (double)p.out[KNOT][i];
      fall = fmax(fall, (before - edge) / radius);
      before = edge;
      if (edge > 0) end = z;
    }
    first = fmin(first, (end - 120) / radius);
    last = fmax(last, (end - 120) / radius);
    textures->destroy(t);
  }
  points_free(&p);
  CHECK(fall < 0.5 && first >= 0 && last < 7,
        "knots of a stem of 120 mm end %.1f to %.1f of their radii beyond it (0 to 7), and lose at "
        "most %.2f of the radius in a millimetre (0.5)\n",
        first, last, fall);
}

/* The axis and the years of its rings. */
static void axis_and_years(void **state) {
  (void)state;
  double off = 0, late = 0, young = 0;
  uniform_seed(5);
  points p = {0};
  for (int n = 0; n < 60; n++) {
    double azimuth = 2 * PI * uniform(), rise = 1.2 * (uniform() - 0.3);
    one_branch(-1, -1, azimuth, rise);
    sozai_texture *t = with_tables(1, 1);
    points_clear(&p);
    for (int i = 0; i < 100; i++) {
      double u = 15 + 0.9 * i, y = u * tan(rise);
      points_add(&p, u * cos(azimuth), y, u * sin(azimuth), 0);
      /* 3 mm to the side: of the year in which the branch had that radius */
      points_add(&p, u * cos(azimuth) - 3 * sin(azimuth), y, u * sin(azimuth) + 3 * cos(azimuth),
                 0);
    }
    points_ask(&p, t);
    for (int i = 0; i < 100; i++) {
      double x = (double)p.out[REFERENCE][2 * i], z = (double)p.out[REFERENCE + 1][2 * i];
      off = fmax(off, fabs(x + z));
      late = fmax(late, (double)p.out[TIME][2 * i]);
      if (15 + 0.9 * i > 20) {
        assert_true(p.out[KNOT][2 * i] > 0.99f);
        young = fmax(young, fabs((double)p.out[TIME][2 * i + 1] - 7.5) / 7.5);
      }
    }
    textures->destroy(t);
  }
  points_free(&p);
  CHECK(
      off < 0.5 && late < 1 && young < 0.35,
      "60 branches: the axis within %.3g mm (0.5) of its place, no older than %.2f years (1); the "
      "ring 3 mm out within %.0f %% of its year (35: collar, oblong)\n",
      off, late, 100 * young);
}

/* ---- the tree's branches ------------------------------------------------ */

static const sozai_geometry_1 *geometry;

/* The stem's, at the nearest height of the last year. */
static double radius_now(const sozai_table *t, double height) {
  double best = 1e30, radius = 0;
  for (uint64_t i = 0; i < t->rows; i++) {
    const float *row = t->data + 3 * i;
    if (row[0] != t->data[3 * (t->rows - 1)]) continue;
    double off = fabs((double)row[1] - height);
    if (off < best) best = off, radius = (double)row[2];
  }
  return radius;
}

static void branches_cross_the_board(void **state) {
  (void)state;
  double off = 0;
  int crossings = 0, missed = 0;
  for (unsigned k = 0; k < TREES; k++) {
    int age = k == 0 ? 40 : k == 1 ? 45 : 60;
    double low = k == 0 ? 4000 : k == 1 ? 6000 : 5000;
    char text[512];
    snprintf(text, sizeof text, PLAIN "%s", trees[k][1]);
    sozai_texture *t = wood_make(NULL, text);
    sozai_value values[2] = {{.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {age}},
                             {.id = "orders", .kind = SOZAI_KIND_INT, .number = {1}}};
    sozai_geometry *g;
    assert_int_equal(geometry->grow(NULL, "tree", trees[k][0], values, 2, &g), SOZAI_OK);
    sozai_table branches = {.size = sizeof branches};
    assert_int_equal(geometry->table(g, "branches", &branches), SOZAI_OK);
    uint32_t columns = branches.info->column_count;
    sozai_table grown = {.size = sizeof grown};
    assert_int_equal(geometry->table(g, "rings", &grown), SOZAI_OK);
    points p = {0};
    const double z = 40;
    static double at[65536][2];
    int n = 0;
    for (uint64_t i = 1; i < branches.rows; i++) {
      const float *b = branches.data + i * columns;
      double azimuth = (double)b[6] * PI / 180, rise = (double)b[7] * PI / 180;
      double y = (double)b[2] - low, south = -cos(azimuth), u = z / south;
      if (b[0] != 1.0f || b[1] != 0.0f || south < 0.35 ||
          u > 0.8 * radius_now(&grown, (double)b[2]))
        continue;
      at[n][0] = u * sin(azimuth);
      at[n][1] = y + u * tan(rise);
      points_add(&p, at[n][0], at[n][1], z, 0);
      n++;
    }
    points_ask(&p, t);
    for (int i = 0; i < n; i++) {
      /* within another branch of the whorl, or one too thin */
      if (p.out[KNOT][i] < 0.5f || p.out[TIME][i] > 3.0f) {
        missed++;
        continue;
      }
      crossings++;
      off = fmax(off, fabs((double)p.out[REFERENCE][i] + (double)p.out[REFERENCE + 1][i]));
    }
    points_free(&p);
    geometry->release(g);
    textures->destroy(t);
  }
  CHECK(crossings > 30 && missed * 10 < crossings && off < 0.5,
        "%d branches cross the boards within %.3g mm (0.5) of their place; %d not seen (a tenth)\n",
        crossings, off, missed);
}

/* Two branches that were measured, one to the south and one to the east. */
static void a_measured_tree(void **state) {
  (void)state;
  static const char field[] =
      "trunk\n50 0 90 20\n50 0 90 19\n50 0 90 18\nB100\n0\n60 180 30 3\nB200\n0\n0\n60 90 0 2\n";
  const sozai_value values[] = {{.id = "tree_field", .kind = SOZAI_KIND_TEXT, .text = field},
                                {.id = "tree_age", .kind = SOZAI_KIND_FLOAT, .number = {25}},
                                {.id = "log_height", .kind = SOZAI_KIND_FLOAT, .number = {0}},
                                {.id = "pith_wander", .kind = SOZAI_KIND_FLOAT, .number = {0}},
                                {.id = "taper", .kind = SOZAI_KIND_FLOAT, .number = {0}}};
  sozai_texture *t = NULL;
  int32_t r = textures->create(NULL, "wood", "sugi", values, 5, &t);
  if (r) fail_msg("%s", textures->last_error());
  /* at their places, and as far on the other sides of the stem */
  const double at[][3] = {
      {0, 500 + 50 * tan(PI / 6), 50}, {50, 1000, 0}, {0, 500, -50}, {-50, 1000, 0}};
  points p = {0};
  for (int i = 0; i < 4; i++) points_add(&p, at[i][0], at[i][1], at[i][2], 0);
  points_ask(&p, t);
  for (int i = 0; i < 4; i++) {
    print_message("(%g, %g, %g): knot %g, year %.1f\n", at[i][0], at[i][1], at[i][2],
                  (double)p.out[KNOT][i], (double)p.out[TIME][i]);
    assert_int_equal(p.out[KNOT][i] > 0.99f, i < 2);
    if (i < 2)
      assert_true(fabs((double)p.out[REFERENCE][i] + (double)p.out[REFERENCE + 1][i]) < 0.5);
  }
  points_free(&p);
  textures->destroy(t);
}

/* ---- fibres and rings --------------------------------------------------- */

static void a_walk_stays_on_its_fibre(void **state) {
  (void)state;
  enum { WALKERS = 64 };
  static double at[WALKERS][3], k[4][WALKERS][3], first[WALKERS][2];
  static int stopped[WALKERS];
  const double step = 0.0125;
  for (unsigned f = 0; f < TREES; f++) {
    char text[512];
    snprintf(text, sizeof text,
             "pith_wander=12; undulation=2; section_wobble=0.1; taper=10; slope_noise=0.1; %s",
             trees[f][1]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    double worst = 0, off = 0;
    int ended = 0;
    uniform_seed(93 + f);
    for (int w = 0; w < WALKERS; w++) {
      double r = 15 + 80 * uniform(), theta = 2 * PI * uniform();
      at[w][0] = r * cos(theta);
      at[w][1] = 800 * (uniform() - 0.5);
      at[w][2] = r * sin(theta);
      stopped[w] = 0;
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
          /* at a knot, the fibre ends; and in what has died it has no more to say */
          if (p.out[KNOT][w] > 0 && !stopped[w]) stopped[w] = 1, ended++;
          if (stage || stopped[w]) continue;
          double x = (double)p.out[REFERENCE][w], z = (double)p.out[REFERENCE + 1][w];
          if (n == 0) first[w][0] = x, first[w][1] = z;
          double drift = hypot(x - first[w][0], z - first[w][1]);
          worst = fmax(worst, drift);
          off = fmax(off, sqrt(fmax(1 - k[0][w][1] * k[0][w][1], 0)));
        }
      }
      for (int w = 0; w < WALKERS; w++) {
        if (stopped[w]) continue;
        for (int c = 0; c < 3; c++)
          at[w][c] += step / 6 * (k[0][w][c] + 2 * k[1][w][c] + 2 * k[2][w][c] + k[3][w][c]);
      }
    }
    points_free(&p);
    textures->destroy(t);
    print_message("%s: 1 m on %d fibres, of which %d end at a knot, off the stem by up to %.2f: "
                  "reference drifts %.2g mm\n",
                  trees[f][0], WALKERS, ended, off, worst);
    CHECK(worst < 1e-3 && off > 0.3 && ended < WALKERS, "drift %.2g mm (1e-3)\n", worst);
  }
}

/* Outwards at a fixed place beside a branch time never falls. */
static void rings_never_cross(void **state) {
  (void)state;
  enum { LINES = 3000, STEPS = 400 };
  double falls = 0;
  uniform_seed(17);
  points p = {0};
  for (int n = 0; n < 4; n++) {
    one_branch(n & 1 ? 25 : -1, n & 1 ? 35 : -1, 0, 0);
    sozai_texture *t = with_tables(1, 1);
    for (int l = 0; l < LINES; l++) {
      double a = 40 * (uniform() - 0.5), y = 120 * (uniform() - 0.5);
      points_clear(&p);
      for (int i = 0; i < STEPS; i++) points_add(&p, 1 + 0.25 * i, y, a, 0);
      points_ask(&p, t);
      for (int i = 1; i < STEPS; i++) {
        /* where a dead branch ends, older wood lies beside younger */
        if ((p.out[KNOT][i] > 0) != (p.out[KNOT][i - 1] > 0)) continue;
        falls = fmax(falls, (double)p.out[TIME][i - 1] - (double)p.out[TIME][i]);
      }
    }
    textures->destroy(t);
  }
  points_free(&p);
  CHECK(falls < 1e-4, "time falls by %.2g years at most along the branch (1e-4)\n", falls);
}

/* ---- filtering ----------------------------------------------------------- */

static void against_1024_samples(void **state) {
  (void)state;
  enum { PLACES = 300, SIZES = 10 };
  static const double sizes[SIZES] = {0.01, 0.03, 0.1, 0.3, 1, 3, 10, 20, 30, 100};
  double worst = 0, mean = 0, bare_worst = 0, bare_mean = 0, share_worst = 0, share_mean = 0;
  points p = {0};
  print_message("RMS / mean error of albedo, by footprint in mm:\n%-12s", "");
  for (int f = 0; f < SIZES; f++) print_message("%16g", sizes[f]);
  print_message("\n");
  for (unsigned k = 0; k < TREES; k++) {
    for (int cut = 0; cut < 4; cut++) {
      /* the same boards once more, of branches too thin to leave knots */
      int bare = cut & 2;
      char text[512];
      snprintf(text, sizeof text, "%s; cut=%s%s", trees[k][1], cut & 1 ? "quarter" : "flat",
               bare ? "; knot_size=0.1" : "");
      sozai_texture *t = wood_make(trees[k][0], text);
      print_message("%-9s%-3s", trees[k][0], bare ? cut & 1 ? "q-" : "f-" : cut ? "q" : "f");
      for (int f = 0; f < SIZES; f++) {
        truth_errors e = {0};
        double square = 0, sum = 0;
        uniform_seed(7);
        for (int i = 0; i < PLACES; i++) {
          double x = 160 * (uniform() - 0.5), y = 3000 * (uniform() - 0.5), turn = PI * uniform();
          truth_ask(&p, t, ONLY3(ALBEDO) | ONLY(KNOT), x, y, turn, sizes[f]);
          truth_add(&e, &p);
          double share = truth_error(&p, KNOT);
          square += share * share / PLACES;
          sum += share / PLACES;
        }
        print_message("  %.4f/%+.4f", truth_rms(&e), truth_mean(&e));
        if (bare) {
          bare_worst = fmax(bare_worst, truth_rms(&e));
          bare_mean = fmax(bare_mean, fabs(truth_mean(&e)));
          continue;
        }
        share_worst = fmax(share_worst, sqrt(square));
        share_mean = fmax(share_mean, fabs(sum));
        worst = fmax(worst, truth_rms(&e));
        mean = fmax(mean, fabs(truth_mean(&e)));
      }
      print_message("\n");
      textures->destroy(t);
    }
  }
  points_free(&p);

  CHECK(worst <= 0.01 && mean <= 0.002,
        "worst RMS %.4f (goal 0.01), worst mean %.4f (goal 0.002); "
        "without knots (-) %.4f and %.4f\n",
        worst, mean, bare_worst, bare_mean);
  CHECK(share_worst <= 0.024 && share_mean <= 0.0042,
        "the knots' share: worst RMS %.4f (0.024), worst mean %.4f (0.0042)\n", share_worst,
        share_mean);
}

/* A dead branch's bark closes over its end, and over nothing else: of squares across it,
 * and along it, about the end, and as far on the pith's other side. */
static void bark_at_the_end(void **state) {
  (void)state;
  enum { SIDE = 96 };
  static const double sizes[] = {2, 6, 11, 13, 16, 20, 24, 40};
  one_branch(30, 40, PI / 2, 0);
  sozai_texture *t = with_tables(1, 1);
  assert_non_null(t);
  points p = {0};
  double worst = 0, beyond = 0;
  uniform_seed(41);
  for (unsigned f = 0; f < sizeof sizes / sizeof *sizes; f++) {
    double square = 0, past = 0;
    int count = 0;
    for (int n = 0; n < 120; n++) {
      int other = n & 1, along = n & 2;
      double z = (other ? -1 : 1) * (70 + 26 * uniform()), y = 24 * (uniform() - 0.5);
      points_clear(&p);
      for (int i = 0; i < SIDE * SIDE; i++) {
        double u = ((i % SIDE + uniform()) / SIDE - 0.5) * sizes[f];
        double v = ((i / SIDE + uniform()) / SIDE - 0.5) * sizes[f];
        points_add(&p, along ? 0 : u, y + v, along ? z + u : z, 0);
      }
      points_add(&p, 0, y, z, sizes[f]);
      for (unsigned i = 0; i < p.count; i++) {
        p.normal[0][i] = along ? 1 : 0;
        p.normal[1][i] = 0;
        p.normal[2][i] = along ? 0 : 1;
      }
      points_ask(&p, t);
      double truth = 0;
      for (int i = 0; i < SIDE * SIDE; i++) truth += (double)p.out[ALBEDO][i] / (SIDE * SIDE);
      double error = (double)p.out[ALBEDO][SIDE * SIDE] - truth;
      if (other) {
        past = fmax(past, fabs(error));
      } else {
        square += error * error;
        count++;
      }
    }
    print_message("%g mm: RMS %.4f at the end, at most %.4f across the pith\n", sizes[f],
                  sqrt(square / count), past);
    worst = fmax(worst, sqrt(square / count));
    beyond = fmax(beyond, past);
  }
  points_free(&p);
  textures->destroy(t);
  CHECK(worst < 0.055 && beyond < 0.025,
        "RMS %.4f (0.055) at the end, %.4f (0.025) across the pith\n", worst, beyond);
}

/* ---- what is skipped ------------------------------------------------------ */

/* The same bits alone and among others: where the cells' parts say that no knot is
 * near, none has any effect. */
static void alone_as_among_others(void **state) {
  (void)state;
  enum { POINTS = 12000 };
  static const double sizes[] = {0, 1.99, 2.01, 11, 20, 23.9, 24.1, 90};
  static float among[POINTS][KNOT + 1];
  unsigned differ = 0, asked = 0, knotty = 0;
  points p = {0}, one = {0};
  for (unsigned k = 0; k < TREES; k++) {
    char text[512];
    snprintf(text, sizeof text, "%s; cut=log", trees[k][1]);
    sozai_texture *t = wood_make(trees[k][0], text);
    uniform_seed(3 + k);
    for (unsigned f = 0; f < sizeof sizes / sizeof *sizes; f++) {
      points_clear(&p);
      for (int i = 0; i < POINTS; i++) {
        double r = 160 * sqrt(uniform()), turn = 2 * PI * uniform();
        points_add(&p, r * cos(turn), 4000 * (uniform() - 0.5), r * sin(turn), sizes[f]);
      }
      points_ask(&p, t);
      for (int i = 0; i < POINTS; i++)
        for (int c = 0; c <= KNOT; c++) among[i][c] = p.out[c][i];
      for (int i = 0; i < POINTS; i++) {
        points_clear(&one);
        points_add(&one, (double)p.point[0][i], (double)p.point[1][i], (double)p.point[2][i],
                   sizes[f]);
        points_ask(&one, t);
        int same = 1;
        for (int c = 0; c <= KNOT; c++) same &= memcmp(&one.out[c][0], &among[i][c], 4) == 0;
        differ += !same;
        knotty += among[i][KNOT] > 0;
        asked++;
      }
    }
    textures->destroy(t);
  }
  points_free(&p);
  points_free(&one);
  CHECK(differ == 0 && knotty > 1000,
        "%u of %u points, %u of them with a knot, differ alone and among others (0)\n", differ,
        asked, knotty);
}

/* ---- bad input ----------------------------------------------------------- */

static void refusals(void **state) {
  (void)state;
  static const char *const bad[][2] = {{"tree=oaktree", "tree: "},
                                       {"tree=sugi; tree_age=0", "tree_age"},
                                       {"tree=sugi; tree_age=nan", "tree_age"},
                                       {"tree=sugi; knot_size=1e30", "knot_size"},
                                       {"tree_field=nonsense", "field"}};
  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
    const char *why = wood_refused(bad[i][0]);
    assert_non_null(why);
    print_message("%s\n", why ? why : "");
    assert_non_null(strstr(why, bad[i][1]));
    assert_null(strchr(why, '\n'));
  }
  const struct {
    float *at;
    float value;
    const char *says;
  } wrong[] = {{&knot[0][5], (float)NAN, "knots: row 0: inclination"},
               {&knot[0][6], 1e30f, "knots: row 0: height"},
               {&knot[0][9], 61, "knots: row 0 ends"},
               {&knot[0][8], -1, "knots: row 0: first"},
               {&radii[7][2], (float)INFINITY, "knot_radii: row 7: radius"},
               {&rings[9][0], 2, "stem_rings: row 9"},
               {&rings[5][1], -5, "stem_rings: row 5"},
               {&rings[5][2], -5, "stem_rings: row 5: radius"}};
  for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    one_branch(-1, -1, 0, 0);
    *wrong[i].at = wrong[i].value;
    sozai_texture *t = with_tables(1, 1);
    if (t) fail_msg("taken: %s", wrong[i].says);
    print_message("%s\n", textures->last_error());
    if (!strstr(textures->last_error(), wrong[i].says)) fail_msg("instead of: %s", wrong[i].says);
  }
  one_branch(-1, -1, 0, 0);
  for (int i = 0; i < 4; i++) {
    sozai_texture *t = with_tables(i & 1, i & 2);
    assert_non_null(t);
    textures->destroy(t);
  }
}

static int setup(void **state) {
  int r = wood_setup(state);
  geometry = wood_factory(SOZAI_GEOMETRY_1);
  return r || !geometry;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(radius_bark_and_scar),  cmocka_unit_test(ends_beyond_the_tree),
      cmocka_unit_test(axis_and_years),        cmocka_unit_test(branches_cross_the_board),
      cmocka_unit_test(a_measured_tree),

      cmocka_unit_test(rings_never_cross),     cmocka_unit_test(a_walk_stays_on_its_fibre),
      cmocka_unit_test(against_1024_samples),  cmocka_unit_test(bark_at_the_end),
      cmocka_unit_test(alone_as_among_others), cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, setup, wood_teardown);
}
