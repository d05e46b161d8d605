/* SPDX-License-Identifier: Apache-2.0
 *
 * Plies: how many, how thick, which way their grain runs, how much glue; that
 * leaves mirror each other; that a footprint on an edge gives the mean of what
 * lies under it; and what is refused.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
#define STILL "slope_noise=0; undulation=0; taper=0; pith_wander=0; glue_unevenness=0; "

/* A point with a normal of its own. */
static void add(points *p, double x, double y, double z, const double n[3], double footprint) {
  unsigned i = points_add(p, x, y, z, footprint);
  for (int c = 0; c < 3; c++) p->normal[c][i] = (float)n[c];
}

static const double up[3] = {0, 0, 1}, under[3] = {0, 0, -1};
static const double sides[4][3] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};

/* Numbers of plies at thicknesses: those of Finnish birch plywood, and others'. */
static void as_many_as_the_trade_has(void **state) {
  (void)state;
  static const struct {
    const char *preset, *values;
    double thick;
    int plies;
  } sheets[] = {
      {"birch_plywood", "", 4, 3},
      {"birch_plywood", "", 6.5, 5},
      {"birch_plywood", "", 9, 7},
      {"birch_plywood", "", 12, 9},
      {"birch_plywood", "", 15, 11},
      {"birch_plywood", "", 18, 13},
      {"birch_plywood", "", 21, 15},
      {"birch_plywood", "", 24, 17},
      {"birch_plywood", "", 27, 19},
      {"birch_plywood", "", 30, 21},
      {"lauan_plywood", "", 12, 5},
      {"sugi_plywood", "", 12, 5},
      {"larch_lvl", "", 45, 15},
      {"pine_blockboard", "", 19, 5},
      {"birch_plywood", "plies=9; ", 18, 9},
      {"birch_plywood", "sheets=3; ", 18, 39},
  };
  points p = {0};
  for (unsigned i = 0; i < sizeof sheets / sizeof *sheets; i++) {
    char text[120];
    int stack = strstr(sheets[i].values, "sheets=3") ? 3 : 1;
    snprintf(text, sizeof text, "%ssheet_thickness=%g", sheets[i].values, sheets[i].thick);
    sozai_texture *t = wood_make(sheets[i].preset, text);
    points_clear(&p);
    add(&p, 3, 5, 0, up, 0.1);
    add(&p, 3, 5, -stack * sheets[i].thick, under, 0.1);
    points_ask(&p, t);
    int front = (int)p.out[BOARD_ID][0], back = (int)p.out[BOARD_ID][1];
    CHECK(front == 1 && back == sheets[i].plies,
          "%-16s %-11s %4.3g mm: plies %d to %d, expected %d\n", sheets[i].preset, sheets[i].values,
          sheets[i].thick, front, back, sheets[i].plies);
    textures->destroy(t);
  }
  points_free(&p);
}

/* Down an edge in steps: where plies change, which way their fibres run, and how
 * much is glue. */
static void lay_up(const char *values, double thick, double face, double core, int plies,
                   int crossed) {
  char text[300];
  snprintf(text, sizeof text, STILL "sheet_thickness=%g; face_veneer=%g; core_veneer=%g; %s", thick,
           face, core, values);
  sozai_texture *t = wood_make("birch_plywood", text);
  points p = {0};
  enum { STEPS = 60000 };
  double step = thick / STEPS, edge_worst = 0, off = 0, aslant = 0;
  for (int i = 0; i < STEPS; i++) add(&p, 20, 7, -(i + 0.5) * step, sides[0], 0);
  points_ask(&p, t);
  int found = 1;
  unsigned glued = 0;
  double begins = 0, each = (thick - 2 * face) / (plies - 2);
  for (int i = 0; i < STEPS; i++) {
    int ply = (int)p.out[BOARD_ID][i];
    if (p.out[BOARD_EDGE][i] < 0) glued++;
    double along = fabs((double)p.out[FIBER + (crossed && ply % 2 == 0 ? 0 : 1)][i]);
    aslant = fmax(aslant, fabs(along - 1));
    if (ply == found) continue;
    off = fmax(off, fabs(i * step - begins - (found == 1 ? face : each)));
    edge_worst = fmax(edge_worst, fabs((double)p.out[BOARD_EDGE][i] + 0.045));
    begins = i * step;
    found = ply;
  }
  off = fmax(off, fabs(thick - begins - face)); /* of the last */
  double share = (double)glued / STEPS, asked = (plies - 1) * 0.09 / thick;
  CHECK(
      found == plies && off < 2 * step && aslant < 1e-6 && edge_worst < 2 * step &&
          fabs(share - asked) < 2.0 * plies / STEPS,
      "%-22s %2d plies (of %d), thicknesses off by %.4f mm, fibres by %.1e, glue %.4f of the edge "
      "(asked %.4f), its middle off by %.4f mm\n",
      values, found, plies, off, aslant, share, asked, edge_worst);
  points_free(&p);
  textures->destroy(t);
}

static void plies_are_as_asked(void **state) {
  (void)state;
  lay_up("construction=plywood", 18, 1.2, 1.4, 13, 1);
  lay_up("construction=plywood", 12, 0.6, 1.6, 9, 1);
  lay_up("construction=plywood; plies=3", 4, 0.5, 1, 3, 1);
  lay_up("construction=lvl", 24, 3, 3, 8, 0);
}

/* Uneven lines swell and thin out, and are as thick as asked on the mean. */
static void uneven_glue_keeps_its_share(void **state) {
  (void)state;
  sozai_texture *t = wood_make("birch_plywood", "glue_unevenness=1");
  points p = {0};
  enum { N = 400000 };
  uniform_seed(5);
  for (int i = 0; i < N; i++) {
    add(&p, 4000 * uniform(), 4000 * uniform(), -18 * uniform(), sides[i % 4], 0);
  }
  points_ask(&p, t);
  double glued = 0, asked = 12 * 0.09 / 18;
  for (int i = 0; i < N; i++) glued += (p.out[BOARD_EDGE][i] < 0) / (double)N;
  CHECK(fabs(glued - asked) < 4 * sqrt(asked / N) + 1e-4, "glue %.5f of the depth, asked %.5f\n",
        glued, asked);
  points_free(&p);
  textures->destroy(t);
}

/* The footprint's answer on an edge against 1,024 points of its square; the
 * square lies as it comes on faces, upright on edges. */
static void averages_what_lies_under_it(void **state) {
  (void)state;
  static const double sizes[] = {0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30};
  enum { SIZES = sizeof sizes / sizeof *sizes, PLACES = 60 };
  static const struct {
    const char *preset, *values;
  } sheets[] = {{"birch_plywood", ""},
                {"birch_plywood", "glue_unevenness=0; core_gap=1"},
                {"birch_plywood", "reflection=fibre_cone; finish=oiled"},
                {"lauan_plywood", ""},
                {"sugi_plywood", ""},
                {"walnut_plywood", ""},
                {"larch_lvl", ""},
                {"pine_blockboard", "core_gap=0.6"}};
  points p = {0};
  int failed = 0;
  for (unsigned k = 0; k < sizeof sheets / sizeof *sheets; k++) {
    sozai_texture *t = wood_make(sheets[k].preset, sheets[k].values);
    double worst = 0, worst_size = 0, worst_mean = 0;
    uniform_seed(31);
    for (int f = 0; f < SIZES; f++) {
      truth_errors errors = {0};
      for (int place = 0; place < PLACES; place++) {
        const double *n = sides[place % 4];
        double x = 900 * (uniform() - 0.5), y = 900 * (uniform() - 0.5), size = sizes[f];
        double z = -12 * uniform(); /* the thinnest sheet's; squares reach past its faces */
        points_clear(&p);
        for (int i = 0; i < TRUTH_SAMPLES; i++) {
          double a = ((i % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
          double b = ((i / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
          add(&p, x - n[1] * a, y + n[0] * a, z + b, n, 0);
        }
        add(&p, x, y, z, n, size);
        points_ask(&p, t);
        truth_add(&errors, &p);
      }
      double rms = truth_rms(&errors), mean = fabs(truth_mean(&errors));
      print_message("%g: %.4f/%+.4f  ", sizes[f], rms, truth_mean(&errors));
      if (rms > worst) worst_size = sizes[f];
      worst = fmax(worst, rms);
      worst_mean = fmax(worst_mean, mean);
    }
    print_message("\n");
    failed += worst > 0.01 || worst_mean > 0.002;
    print_message("%-16s %-36s worst RMS %.4f at %g mm (goal 0.01), worst mean %.4f (goal 0.002)\n",
                  sheets[k].preset, sheets[k].values, worst, worst_size, worst_mean);
    textures->destroy(t);
  }
  points_free(&p);
  assert_int_equal(failed, 0);
}

/* The faces likewise: on a peeled one rings stray from the sheet by more than a
 * straight line says where a square is wide. */
static void faces_average_too(void **state) {
  (void)state;
  static const double sizes[] = {0.01, 0.1, 0.3, 1, 3, 10, 30, 100};
  enum { SIZES = sizeof sizes / sizeof *sizes, PLACES = 120 };
  points p = {0};
  double worst = 0, worst_mean = 0;
  for (unsigned k = 0; k < wood_presets(); k++) {
    if (!wood_is_panel(wood_preset(k))) continue;
    sozai_texture *t = wood_make(wood_preset(k), "");
    print_message("%-16s", wood_preset(k));
    uniform_seed(51);
    for (int f = 0; f < SIZES; f++) {
      truth_errors errors = {0};
      for (int place = 0; place < PLACES; place++) {
        double x = 900 * (uniform() - 0.5), y = 1200 * (uniform() - 0.5);
        truth_ask(&p, t, ONLY3(ALBEDO), x, y, 2 * PI * uniform(), sizes[f]);
        truth_add(&errors, &p);
      }
      double rms = truth_rms(&errors), mean = truth_mean(&errors);
      print_message("  %g: %.4f/%+.4f", sizes[f], rms, mean);
      worst = fmax(worst, rms);
      worst_mean = fmax(worst_mean, fabs(mean));
    }
    print_message("\n");
    textures->destroy(t);
  }
  points_free(&p);
  CHECK(worst <= 0.01 && worst_mean <= 0.002,
        "faces: worst RMS %.4f (goal 0.01), worst mean %.4f (goal 0.002)\n", worst, worst_mean);
}

/* A fibre of a ply is one fibre of its log, but for the bending of the veneer. It
 * is followed until it leaves the ply. */
static void a_walk_stays_on_its_fibre(void **state) {
  (void)state;
  enum { WALKERS = 200, STEPS = 200 };
  static const char *const presets[] = {"birch_plywood", "walnut_plywood", "larch_lvl"};
  points p = {0};
  for (unsigned k = 0; k < sizeof presets / sizeof *presets; k++) {
    sozai_texture *t = wood_make(presets[k], "leaf_width=400");
    double at[WALKERS][3], half[WALKERS][3], begin[WALKERS][2], worst = 0, longest = 0;
    int out[WALKERS] = {0};
    uniform_seed(6);
    for (int i = 0; i < WALKERS; i++) {
      at[i][0] = 400 * (uniform() - 0.5);
      at[i][1] = 300 * (uniform() - 0.5);
      at[i][2] = -0.1 - 0.4 * uniform();
    }
    for (int step = 0; step < 2 * STEPS; step++) {
      int to_half = step % 2 == 0;
      points_clear(&p);
      for (int i = 0; i < WALKERS; i++) {
        const double *q = to_half ? at[i] : half[i];
        points_add(&p, q[0], q[1], q[2], 0);
      }
      points_ask(&p, t);
      for (int i = 0; i < WALKERS; i++) {
        double x = (double)p.out[REFERENCE][i], z = (double)p.out[REFERENCE + 1][i];
        if (step == 0) {
          begin[i][0] = x;
          begin[i][1] = z;
        }
        float v = p.out[BOARD_V][i]; /* not across a joint either */
        out[i] |= p.out[BOARD_ID][i] > 1.5f || at[i][2] > 0 || v < 20 || v > 380 ||
                  p.out[BOARD_EDGE][i] < 0.01f;
        double way = 0.25 * step;
        if (to_half && !out[i] && way >= 5) {
          worst = fmax(worst, hypot(x - begin[i][0], z - begin[i][1]) / way);
          longest = fmax(longest, way);
        }
        double *to = to_half ? half[i] : at[i];
        for (int c = 0; c < 3; c++) {
          to[c] = at[i][c] + (to_half ? 0.25 : 0.5) * (double)p.out[FIBER + c][i];
        }
      }
    }
    CHECK(worst < (k == 1 ? 5e-5 : 5e-4) && longest > 30,
          "%-16s drift %.5f of the way, up to %.0f mm\n", presets[k], worst, longest);
    textures->destroy(t);
  }
  points_free(&p);
}

/* Across the joints of three leaves. Two that were opened like a book show the two
 * sides of one cut; the next is of the cuts beyond. */
static void leaves_mirror_each_other(void **state) {
  (void)state;
  static const char *const matches[] = {"book", "slip", "random"};
  double apart[3];
  for (int m = 0; m < 3; m++) {
    char text[120];
    snprintf(text, sizeof text, "leaf_width=100; leaf_match=%s", matches[m]);
    sozai_texture *t = wood_make("walnut_plywood", text);
    points p = {0};
    add(&p, 0, 40, 0, up, 0.5);
    points_ask(&p, t);
    double first = 100 - (double)p.out[BOARD_V][0];
    apart[m] = 1;
    for (int j = 0; j < 2; j++) {
      enum { N = 400 };
      points_clear(&p);
      for (int i = 0; i < N; i++) {
        double d = 0.2 + 45.0 * i / N, y = 0.7 * i, joint = first + 100 * j;
        add(&p, joint - d, y, 0, up, 0.3);
        add(&p, joint + d, y, 0, up, 0.3);
      }
      points_ask(&p, t);
      double sum = 0;
      for (int i = 0; i < 3 * N; i++) {
        const float *c = &p.out[ALBEDO + i / N][2 * (i % N)];
        sum += (double)(c[0] - c[1]) * (double)(c[0] - c[1]) / (3 * N);
      }
      apart[m] = fmin(apart[m], sqrt(sum));
    }
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(apart[0] < 0.002 && apart[1] > 0.01 && apart[2] > 0.01,
        "mirrored places differ by %.4f where book-matched, %.4f slip-matched, %.4f at random\n",
        apart[0], apart[1], apart[2]);
}

/* At the ends of plies and of glue, under squares of all sizes, on faces of any
 * slope: numbers, and colours of something. */
static void no_place_has_no_answer(void **state) {
  (void)state;
  enum { N = 20000, TIMES = 12 };
  points p = {0};
  sozai_texture *t = wood_make("birch_plywood", "face_height=36; sheets=4; core_gap=2");
  unsigned none = 0;
  uniform_seed(3);
  for (int k = 0; k < TIMES; k++) {
    points_clear(&p);
    for (int i = 0; i < N; i++) {
      double a = 2 * PI * uniform(), nz = uniform() < 0.7 ? 0 : 2 * uniform() - 1;
      double n[3] = {cos(a) * sqrt(1 - nz * nz), sin(a) * sqrt(1 - nz * nz), nz};
      /* every other one where a ply begins, as nearly as floats have it */
      double z = 36 - (i & 1 ? 72 * uniform() : 18 * (i % 5) + 1.2 + 1.41818185 * (i % 12));
      add(&p, 100 * (uniform() - 0.5), 100 * (uniform() - 0.5), z, n,
          pow(10, -2.5 + 3 * uniform()));
    }
    points_ask(&p, t);
    for (int i = 0; i < N; i++) {
      int lacks = 0;
      for (unsigned c = 0; c < sizeof p.out / sizeof *p.out; c++)
        lacks |= !(fabsf(p.out[c][i]) < 1e6f);
      for (int c = 0; c < 3; c++) lacks |= !(p.out[ALBEDO + c][i] > 0.005f);
      none += (unsigned)lacks;
    }
  }
  CHECK(none == 0, "%u of %d places have no answer\n", none, N * TIMES);
  points_free(&p);
  textures->destroy(t);
}

/* Height and normal on an edge agree, and a smooth face has neither. */
static void glue_stands_above(void **state) {
  (void)state;
  sozai_texture *t = wood_make("birch_plywood", "glue_step=0.02");
  points p = {0};
  enum { N = 4000 };
  const double h = 1e-3;
  for (int i = 0; i < N; i++) {
    double z = -0.3 - 17.4 * i / N, y = 0.1 * i;
    for (int k = -1; k <= 1; k++) add(&p, 30, y, z + k * h, sides[0], 0.05);
  }
  for (int i = 0; i < 50; i++) add(&p, 7 * i, 3 * i, 0, up, 0.05);
  points_ask(&p, t);
  double off = 0, slopes = 0, high = 0, flat = 0;
  for (int i = 0; i < N; i++) {
    const float *z = &p.out[HEIGHT][3 * i];
    double slope = (double)(z[2] - z[0]) / (2 * h);
    double nz = (double)p.out[NORMAL + 2][3 * i + 1], nx = (double)p.out[NORMAL][3 * i + 1];
    double error = -nz / nx - slope;
    off += error * error / N;
    slopes += slope * slope / N;
    high = fmax(high, (double)z[1]);
  }
  for (int i = 0; i < 50; i++) {
    flat = fmax(flat, fabs((double)p.out[HEIGHT][3 * N + i]));
    flat = fmax(flat, 1 - (double)p.out[NORMAL + 2][3 * N + i]);
  }
  CHECK(sqrt(off) < 0.12 * sqrt(slopes) && slopes > 1e-4 && high > 0.0199 && high < 0.0201 &&
            flat < 1e-6,
        "slopes off by %.4f RMS of %.4f, highest %.4f mm (asked 0.02), the face's %.1e\n",
        sqrt(off), sqrt(slopes), high, flat);
  points_free(&p);
  textures->destroy(t);
}

/* A floor of plywood: boards as they are, and the plies in their joints' sides. */
static void floors_may_be_of_plies(void **state) {
  (void)state;
  sozai_texture *t = wood_make("birch_plywood", STILL "layout=running; joint_width=2");
  points p = {0};
  unsigned joints = 0, odd = 0;
  uniform_seed(8);
  for (int i = 0; i < 20000; i++) points_add(&p, 3000 * uniform(), 3000 * uniform(), 0, 0);
  for (int i = 0; i < 13; i++) add(&p, 30, 200, -0.6 - 1.4 * i, sides[0], 0);
  points_ask(&p, t);
  for (unsigned i = 0; i < 20000; i++) joints += p.out[BOARD_EDGE][i] < 0;
  for (unsigned i = 0; i < 13; i++) {
    double along = fabs((double)p.out[FIBER + (i & 1 ? 0 : 1)][20000 + i]);
    odd += fabs(along - 1) > 1e-6;
  }
  CHECK(joints > 100 && !odd, "%u of 20000 places in joints, %u of 13 plies astray\n", joints, odd);
  points_free(&p);
  textures->destroy(t);
}

/* A normal's component is the same whether the others are asked for or not. */
static void components_by_themselves(void **state) {
  (void)state;
  static const double slant[3] = {0.6, 0, 0.8};
  sozai_texture *t = wood_make("birch_plywood", "sheets=100");
  points p = {0};
  uniform_seed(10);
  for (int i = 0; i < 3000; i++)
    add(&p, 900 * uniform(), 900 * uniform(), -1500 * uniform(), slant, 4 * uniform());
  points_ask(&p, t);
  float *whole = malloc(3 * p.count * sizeof *whole);
  assert_non_null(whole);
  for (unsigned c = 0; c < 3; c++)
    memcpy(whole + c * p.count, p.out[NORMAL + c], p.count * sizeof *whole);
  unsigned other = 0;
  for (unsigned c = 0; c < 3; c++) {
    points_ask_only(&p, t, ONLY(NORMAL + c));
    for (unsigned i = 0; i < p.count; i++) other += p.out[NORMAL + c][i] != whole[c * p.count + i];
  }
  CHECK(!other, "%u of 9000 components of a normal are others by themselves\n", other);
  free(whole);
  points_free(&p);
  textures->destroy(t);
}

static void what_cannot_be_is_refused(void **state) {
  (void)state;
  static const struct {
    const char *values, *names;
  } cases[] = {
      {"construction=plywood; plies=4", "plies: 4"},
      {"construction=plywood; plies=1", "plies: 1"},
      {"construction=lvl; plies=1", "plies: 1"},
      {"construction=blockboard; plies=7", "plies: 7"},
      {"construction=plywood; sheet_thickness=2; face_veneer=1", "sheet_thickness: 2"},
      {"construction=plywood; sheet_thickness=500; core_veneer=0.3", "core_veneer: 0.3"},
      {"construction=plywood; glue_line=0.9", "glue_line: 0.9"},
      {"construction=plywood; core_gap=3; core_width=8", "core_gap: 3"},
      {"construction=plywood; core_width=1", "core_width: 1"},
      {"construction=plywood; leaf_width=0.5", "leaf_width: 0.5"},
      {"construction=cardboard", "construction"},
      {"sheet_thickness=nan", "sheet_thickness"},
      {"sheets=0", "sheets"},
      {"lathe_checks=1e30", "lathe_checks"},
  };
  for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
    const char *why = wood_refused(cases[i].values);
    CHECK(why && strstr(why, cases[i].names), "%s: %s\n", cases[i].values, why ? why : "taken");
  }
  assert_null(wood_refused("plies=4; core_gap=3; core_width=8")); /* nothing to solid wood */
}

/* Nor is the pith: neither of plies nor of boards in a layout, each of a log of its own. */
static void rings_are_not_asked_for(void **state) {
  (void)state;
  static const char *const many[][2] = {{"birch_plywood", ""}, {"keyaki", "layout=herringbone"}};
  for (size_t i = 0; i < sizeof many / sizeof *many; i++) {
    sozai_texture *t = wood_make(many[i][0], many[i][1]);
    float zero = 0, r = -1;
    assert_int_equal(woods->ring_radius(t, 1, &zero, &zero, &zero, &r), SOZAI_ERROR_UNSUPPORTED);
    assert_int_equal(woods->pith(t, 1, &zero, &r, &r), SOZAI_ERROR_UNSUPPORTED);
    assert_true(r < 0);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(as_many_as_the_trade_has),    cmocka_unit_test(plies_are_as_asked),
      cmocka_unit_test(uneven_glue_keeps_its_share), cmocka_unit_test(leaves_mirror_each_other),
      cmocka_unit_test(glue_stands_above),           cmocka_unit_test(floors_may_be_of_plies),
      cmocka_unit_test(no_place_has_no_answer),      cmocka_unit_test(what_cannot_be_is_refused),
      cmocka_unit_test(averages_what_lies_under_it), cmocka_unit_test(faces_average_too),
      cmocka_unit_test(a_walk_stays_on_its_fibre),   cmocka_unit_test(rings_are_not_asked_for),
      cmocka_unit_test(components_by_themselves)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
