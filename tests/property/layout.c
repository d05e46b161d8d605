/* SPDX-License-Identifier: Apache-2.0
 *
 * Layouts: every place has one unit, whose frame, edge and id agree; joints
 * are as wide as asked for; nothing repeats. Through wood's channels, at places
 * near the origin and 50 m off. What boards' edges look like: layout_profile.c.
 */
#include <math.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "wood.h"

/* Units of a layout: their inside areas less the joint, mm2, and a length that
 * none exceeds. `bent`: its frame is not a plane's. */
typedef struct {
  const char *id;
  double length, width, reach;
  double area[4]; /* 0: no more; all 0: not known */
  int bent, per_tile;
  double tile; /* mm2 */
} expected;

#define G 2.0 /* the joint */
#define R(l, w) (((l)-G) * ((w)-G))

static const expected layouts[] = {
    {.id = "strip", .length = 600, .width = 90, .reach = 760},
    {.id = "stack", .length = 300, .width = 200, .area = {R(300, 200)}, .per_tile = 1, .tile = 6e4},
    {.id = "running",
     .length = 300,
     .width = 90,
     .area = {R(300, 90)},
     .per_tile = 1,
     .tile = 27e3},
    {.id = "chidori",
     .length = 200,
     .width = 90,
     .area = {R(200, 90)},
     .per_tile = 1,
     .tile = 18e3},
    {.id = "english",
     .length = 210,
     .width = 65,
     .area = {R(210, 65), R(105, 65)},
     .per_tile = 3,
     .tile = 210 * 130},
    {.id = "flemish",
     .length = 210,
     .width = 65,
     .area = {R(210, 65), R(105, 65)},
     .per_tile = 2,
     .tile = 315 * 65},
    {.id = "herringbone",
     .length = 350,
     .width = 70,
     .area = {R(350, 70)},
     .per_tile = 1,
     .tile = 24500},
    {.id = "herringbone_90",
     .length = 333,
     .width = 70,
     .area = {R(333, 70)},
     .per_tile = 1,
     .tile = 333 * 70},
    {.id = "herringbone_double",
     .length = 400,
     .width = 50,
     .area = {R(400, 50)},
     .per_tile = 1,
     .tile = 2e4},
    {.id = "chevron", .length = 400, .width = 80, .reach = 560, .per_tile = 1, .tile = 400 * 80},
    {.id = "basket",
     .length = 300,
     .width = 75,
     .area = {R(300, 75)},
     .per_tile = 1,
     .tile = 22500},
    {.id = "windmill",
     .length = 300,
     .width = 100,
     .area = {R(300, 100), R(200, 200)},
     .per_tile = 5,
     .tile = 16e4},
    {.id = "igeta",
     .length = 300,
     .width = 150,
     .area = {R(300, 300), R(300, 150), R(150, 150)},
     .per_tile = 4,
     .tile = 450 * 450},
    {.id = "versailles", .length = 1000, .width = 90, .reach = 920},
    {.id = "hexagon",
     .length = 200,
     .width = 200,
     .reach = 235,
     .area = {0.86602540378 * (200 - G) * (200 - G)},
     .per_tile = 1,
     .tile = 0.86602540378 * 4e4},
    {.id = "octagon",
     .length = 200,
     .width = 200,
     .reach = 220,
     .area = {0.82842712475 * (200 - G) * (200 - G), R(82.842712, 82.842712)},
     .per_tile = 2,
     .tile = 4e4},
    {.id = "end_grain",
     .length = 80,
     .width = 80,
     .area = {R(80, 80)},
     .per_tile = 1,
     .tile = 6400},
    {.id = "butcher", .length = 450, .width = 42, .reach = 570},
    {.id = "ashlar", .length = 500, .width = 150, .reach = 660},
    {.id = "crazy", .length = 350, .width = 350, .reach = 900},
    {.id = "arcs", .length = 100, .width = 100, .reach = 240, .bent = 1},
    {.id = "circles", .length = 100, .width = 100, .reach = 210, .bent = 1},
    {.id = "fan", .length = 90, .width = 90, .reach = 230, .bent = 1},
};
#define COUNT (sizeof layouts / sizeof *layouts)

static sozai_texture *make(const expected *e) {
  char text[512];
  snprintf(text, sizeof text,
           "layout=%s; board_length=%g; board_width=%g; joint_width=%g; layout_rotation=20", e->id,
           e->length, e->width, G);
  return wood_make(NULL, text);
}

/* Random places, half of them 50 m off. */
static void place(int i, double *x, double *y) {
  double far = i & 1 ? 5e4 : 0;
  *x = far + 4000 * (uniform() - 0.5);
  *y = far + 4000 * (uniform() - 0.5);
}

/* A place, one a small step off, and the four from which the edge's gradient
 * is taken. */
static void edges_and_frames(void **state) {
  (void)state;
  enum { N = 20000, STEP = 6 };
  for (unsigned k = 0; k < COUNT; k++) {
    const expected *e = &layouts[k];
    sozai_texture *t = make(e);
    points p = {0}, q = {0};
    uniform_seed(61 + k);
    for (int i = 0; i < N; i++) {
      double x, y, a = 6.28318530718 * uniform(), s = 30 * uniform() * uniform();
      place(i, &x, &y);
      points_add(&p, x, y, 0, 0);
      points_add(&p, x + s * cos(a), y + s * sin(a), 0, 0);
      for (int c = 0; c < 4; c++) {
        points_add(&p, x + (c == 0) - (c == 1), y + (c == 2) - (c == 3), 0, 0);
      }
    }
    points_ask(&p, t);
    double steep = 0, frame = 0, past = 0;
    int torn = 0, merged = 0, crossed = 0, inside = 0;
    for (unsigned i = 0; i < p.count; i += STEP) {
      double dx = (double)p.point[0][i + 1] - (double)p.point[0][i];
      double dy = (double)p.point[1][i + 1] - (double)p.point[1][i];
      double s = hypot(dx, dy), edge = points_value(&p, BOARD_EDGE, i);
      double change = fabs(points_value(&p, BOARD_EDGE, i + 1) - edge) - s;
      if (change > steep) steep = change;
      double gx = points_value(&p, BOARD_EDGE, i + 2) - points_value(&p, BOARD_EDGE, i + 3);
      double gy = points_value(&p, BOARD_EDGE, i + 4) - points_value(&p, BOARD_EDGE, i + 5),
             g = hypot(gx, gy);
      if (edge > s) {
        inside++;
        torn += p.out[BOARD_ID][i] != p.out[BOARD_ID][i + 1];
        double du = points_value(&p, BOARD_U, i + 1) - points_value(&p, BOARD_U, i);
        double dv = points_value(&p, BOARD_V, i + 1) - points_value(&p, BOARD_V, i);
        if (!e->bent && fabs(hypot(du, dv) - s) > frame) frame = fabs(hypot(du, dv) - s);
      }
      /* straight over the nearest joint; not where two edges are as near, and not
       * from so far that the gradient's rounding shows */
      if (edge > 1.5 && edge < 25 && g > 1.99) {
        double over = (edge + 0.5 * G) / g, beyond = (edge + G + 1) / g;
        double x = (double)p.point[0][i], y = (double)p.point[1][i];
        points_add(&q, x - gx * over, y - gy * over, points_value(&p, BOARD_ID, i), 0);
        points_add(&q, x - gx * beyond, y - gy * beyond, 0, 0);
      }
    }
    /* the id travels in z, which does not matter to the layout */
    points_ask(&q, t);
    for (unsigned i = 0; i < q.count; i += 2) {
      crossed++;
      past = fmax(past, fabs(points_value(&q, BOARD_EDGE, i) + 0.5 * G));
      merged += points_value(&q, BOARD_ID, i + 1) == (double)q.point[2][i] &&
                points_value(&q, BOARD_EDGE, i + 1) > 0;
    }
    /* an angle round the origin, 70 m off, is a float's to 0.03 mm; by a corner of rings
     * and borders the gradient may be that of two edges */
    CHECK(
        steep < (e->bent ? 0.08 : 0.03) && !torn && frame < 0.03 && crossed > N / 10 &&
            past < (e->bent ? 0.4 : 0.12) && !merged,
        "%s: %d places; edge changes by at most the step + %.3f mm; %d ids torn of %d steps within "
        "a unit, frames off by %.3f mm; %d joints crossed: their middles found to %.3f mm, %d ids "
        "merged\n",
        e->id, N, steep, torn, inside, frame, crossed, past, merged);
    points_free(&p);
    points_free(&q);
    textures->destroy(t);
  }
}

static int by_id(const void *a, const void *b) {
  const double *x = a, *y = b;
  return x[0] < y[0] ? -1 : x[0] > y[0];
}

/* Samples by id: id, x, y, inside. */
static double (*sorted(const points *p))[4] {
  double(*s)[4] = malloc(p->count * sizeof *s);
  for (unsigned i = 0; i < p->count; i++) {
    s[i][0] = points_value(p, BOARD_ID, i);
    s[i][1] = (double)p->point[0][i];
    s[i][2] = (double)p->point[1][i];
    s[i][3] = p->out[BOARD_EDGE][i] > 0;
  }
  qsort(s, p->count, sizeof *s, by_id);
  return s;
}

/* Every unit wholly in the window has the area of one of its kinds, and there
 * are as many as the tile has. */
static void areas(void **state) {
  (void)state;
  enum { SIDE = 900 };
  for (unsigned k = 0; k < COUNT; k++) {
    const expected *e = &layouts[k];
    if (e->area[0] <= 0) continue;
    sozai_texture *t = make(e);
    points p = {0};
    const double step = 2.1, low = -700, high = low + SIDE * step;
    for (int i = 0; i < SIDE * SIDE; i++) {
      points_add(&p, low + (i % SIDE) * step, low + (double)(i / SIDE) * step, 0, 0);
    }
    points_ask(&p, t);
    double(*s)[4] = sorted(&p), worst = 0;
    int units = 0, all = 0, seen[4] = {0};
    for (unsigned i = 0, j; i < p.count; i = j) {
      double n = 0, border = 0;
      for (j = i; j < p.count && s[j][0] == s[i][0]; j++) {
        n += s[j][3];
        border += s[j][1] < low + step || s[j][1] > high - 2 * step || s[j][2] < low + step ||
                  s[j][2] > high - 2 * step;
      }
      all++;
      if (border > 0) continue;
      double a = n * step * step, best = 1e9;
      int which = 0;
      for (int c = 0; c < 4 && e->area[c] > 0; c++) {
        if (fabs(a / e->area[c] - 1) < best) best = fabs(a / e->area[which = c] - 1);
      }
      seen[which]++;
      units++;
      worst = fmax(worst, best);
    }
    /* a unit counts as the tile's share of the plane; those cut by the window's
     * border count half */
    double want = SIDE * SIDE * step * step / e->tile * e->per_tile;
    double have = units + 0.5 * (all - units);
    CHECK(worst < 0.06 && fabs(have / want - 1) < 0.1 && seen[0],
          "%s: %d units in the window, each of one of the areas expected to %.1f%%; %.0f units "
          "with halves at the border, %.0f expected; of the kinds %d %d %d\n",
          e->id, units, 100 * worst, have, want, seen[0], seen[1], seen[2]);
    free(s);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Four different units to an igeta tile, each whole one once. */
static void igeta_has_four(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, "layout=igeta; board_length=300; board_width=150; "
                                     "joint_width=2");
  points p = {0};
  /* the middles of a tile's units: +u is +y, +v is -x */
  static const double middle[4][2] = {{150, 150}, {150, 375}, {375, 150}, {375, 375}};
  for (int tile = 0; tile < 400; tile++) {
    for (int k = 0; k < 4; k++) {
      double u = (tile % 20) * 450 + middle[k][0], v = (double)(tile / 20) * 450 + middle[k][1];
      points_add(&p, -v, u, 0, 0);
    }
  }
  points_ask(&p, t);
  double(*s)[4] = sorted(&p);
  int same = 0;
  for (unsigned i = 1; i < p.count; i++) same += s[i][0] == s[i - 1][0];
  /* depth at the middle tells the kinds apart */
  CHECK(same == 0 && fabs(points_value(&p, BOARD_EDGE, 0) - 149) < 0.01 &&
            fabs(points_value(&p, BOARD_EDGE, 1) - 74) < 0.01 &&
            fabs(points_value(&p, BOARD_EDGE, 2) - 74) < 0.01 &&
            fabs(points_value(&p, BOARD_EDGE, 3) - 74) < 0.01,
        "400 tiles of four units: %u different ids, %d of them twice\n", p.count, same);
  free(s);
  points_free(&p);
  textures->destroy(t);
}

/* No two places farther apart than a unit is long have the same id. */
static void no_repeat(void **state) {
  (void)state;
  enum { N = 300000 };
  for (unsigned k = 0; k < COUNT; k++) {
    const expected *e = &layouts[k];
    sozai_texture *t = make(e);
    points p = {0};
    uniform_seed(71 + k);
    for (int i = 0; i < N; i++) points_add(&p, 1e5 * uniform(), 1e5 * uniform(), 0, 0);
    points_ask(&p, t);
    double(*s)[4] = sorted(&p);
    double reach = e->reach > 0 ? e->reach : hypot(e->length, fmax(e->width, e->length));
    int repeats = 0, ids = 1, whole = 1;
    for (unsigned i = 1; i < p.count; i++) {
      whole &= s[i][0] == floor(s[i][0]) && s[i][0] >= 0 && s[i][0] < 16777216;
      if (s[i][0] != s[i - 1][0]) {
        ids++;
      } else {
        repeats += hypot(s[i][1] - s[i - 1][1], s[i][2] - s[i - 1][2]) > reach;
      }
    }
    CHECK(repeats == 0 && whole, "%s: %d places over 100 m square, %d ids, %d of them repeated\n",
          e->id, N, ids, repeats);
    free(s);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Black wood and white joints: the albedo is the joint's share of the
 * footprint. Against 1,024 samples, and of a footprint of 10 m against the share
 * of the plane. */
static void joint_shares(void **state) {
  (void)state;
  enum { SIDE = 32, SAMPLES = SIDE * SIDE, PLACES = 150 };
  static const double sizes[] = {1, 4, 20, 1e4};
  print_message("joint's share of a footprint, RMS error by its size in mm:\n%-20s", "");
  for (int f = 0; f < 4; f++) print_message("%9g", sizes[f]);
  print_message("%9s\n", "share");
  double worst[4] = {0};
  for (unsigned k = 0; k < COUNT; k++) {
    const expected *e = &layouts[k];
    char text[512];
    snprintf(text, sizeof text,
             "layout=%s; board_length=%g; board_width=%g; joint_width=4; joint_colour=#ffffff; "
             "earlywood_colour=#000000; latewood_colour=#000000; vessel_colour=#000000; "
             "sapwood_earlywood_colour=#000000; sapwood_latewood_colour=#000000; "
             "sapwood_vessel_colour=#000000",
             e->id, e->length, e->width);
    sozai_texture *t = wood_make(NULL, text);
    print_message("%-20s", e->id);
    uniform_seed(85);
    points p = {0};
    double share = 0;
    for (int i = 0; i < 200000; i++) points_add(&p, 8e3 * uniform(), 8e3 * uniform(), 0, 0);
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) share += (p.out[BOARD_EDGE][i] < 0) / (double)p.count;
    for (int f = 0; f < 4; f++) {
      double square = 0;
      for (int place = 0; place < PLACES; place++) {
        double x = 3000 * (uniform() - 0.5), y = 3000 * (uniform() - 0.5), truth = share;
        points_clear(&p);
        for (int i = 0; i < SAMPLES && f < 3; i++) {
          double u = ((i % SIDE + uniform()) / SIDE - 0.5) * sizes[f];
          points_add(&p, x + u, y + ((i / SIDE + uniform()) / SIDE - 0.5) * sizes[f], 0, 0);
        }
        unsigned own = points_add(&p, x, y, 0, sizes[f]);
        points_ask(&p, t);
        if (f < 3) truth = 0;
        for (unsigned i = 0; i < own; i++) truth += (p.out[BOARD_EDGE][i] < 0) / (double)SAMPLES;
        double error = points_value(&p, ALBEDO, own) - truth;
        square += error * error / PLACES;
      }
      worst[f] = fmax(worst[f], sqrt(square));
      print_message("%9.4f", sqrt(square));
    }
    print_message("%9.4f\n", share);
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(worst[0] < 0.03 && worst[1] < 0.03 && worst[2] < 0.04 && worst[3] < 0.012,
        "worst %.4f %.4f %.4f, of the plane %.4f\n", worst[0], worst[1], worst[2], worst[3]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(edges_and_frames), cmocka_unit_test(areas),
      cmocka_unit_test(igeta_has_four),   cmocka_unit_test(no_repeat),
      cmocka_unit_test(joint_shares),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
