/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays: as many to an area of the tangential face as asked for, as high and as
 * thick, at every radius; carried by the grain; averaged by a footprint.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "truth.h"

#define ROUND                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; slope_noise=0; taper=0; porosity=none; "         \
  "fibre_brightness=0; "

/* A tangential face unrolled: `wide` along the arc at radius r, `tall` along y. */
typedef struct {
  double r, wide, tall, step;
  int nx, ny;
  unsigned char *ray; /* 1: more than half covered */
} face;

static void unroll(face *f, sozai_texture *t) {
  points p = {0};
  f->nx = (int)(f->wide / f->step);
  f->ny = (int)(f->tall / f->step);
  f->ray = malloc((size_t)(f->nx * f->ny));
  for (int j = 0; j < f->ny; j++) {
    points_clear(&p);
    for (int i = 0; i < f->nx; i++) {
      double a = (i + 0.5) * f->step / f->r;
      unsigned n = points_add(&p, f->r * cos(a), (j + 0.5) * f->step, f->r * sin(a), 0);
      p.normal[0][n] = (float)cos(a);
      p.normal[2][n] = (float)sin(a);
    }
    points_ask(&p, t);
    for (int i = 0; i < f->nx; i++) f->ray[j * f->nx + i] = p.out[RAY][i] > 0.5f;
  }
  points_free(&p);
}

/* One piece, from a cell of it: its extent, and its moments about that cell. */
typedef struct {
  int cells, left, right, low, high;
  double x, y, xx, xy, yy;
} piece;

static piece take(face *f, int at) {
  static int stack[1 << 20];
  piece q = {.left = f->nx, .low = f->ny};
  int depth = 0;
  stack[depth++] = at;
  f->ray[at] = 0;
  while (depth) {
    int k = stack[--depth], i = k % f->nx, j = k / f->nx;
    double ox = i - at % f->nx, oy = j - at / f->nx;
    q.cells++;
    q.x += ox;
    q.y += oy;
    q.xx += ox * ox;
    q.xy += ox * oy;
    q.yy += oy * oy;
    q.left = i < q.left ? i : q.left;
    q.right = i > q.right ? i : q.right;
    q.low = j < q.low ? j : q.low;
    q.high = j > q.high ? j : q.high;
    for (int d = 0; d < 8; d++) {
      static const int dx[] = {-1, 0, 1, -1, 1, -1, 0, 1}, dy[] = {-1, -1, -1, 0, 0, 1, 1, 1};
      int x = i + dx[d], y = j + dy[d];
      if (x < 0 || y < 0 || x >= f->nx || y >= f->ny || !f->ray[y * f->nx + x]) continue;
      f->ray[y * f->nx + x] = 0;
      if (depth < (1 << 20)) stack[depth++] = y * f->nx + x;
    }
  }
  return q;
}

static void counts(void **state) {
  (void)state;
  static const struct {
    double density, height, width, radii[3], wide, tall, step;
  } cases[] = {{0.5, 2.0, 130, {60, 83, 140}, 300, 12, 0.025},
               {3.0, 0.5, 55, {45, 75, 130}, 250, 2.5, 0.0125},
               {0.02, 20, 330, {100, 120, 180}, 600, 150, 0.1}};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text, ROUND "ray_density=%g; ray_height=%g; ray_width=%g; ray_length=40",
             cases[k].density, cases[k].height, cases[k].width);
    sozai_texture *t = wood_make(NULL, text);
    for (int r = 0; r < 3; r++) {
      face f = {.r = cases[k].radii[r],
                .wide = cases[k].wide,
                .tall = cases[k].tall,
                .step = cases[k].step};
      unroll(&f, t);
      double n = 0, height = 0, area = 0;
      int whole = 0;
      for (int at = 0; at < f.nx * f.ny; at++) {
        if (!f.ray[at]) continue;
        piece q = take(&f, at);
        /* broad rays are uneven: crumbs off their thin ends are not rays */
        double size = q.cells * f.step * f.step;
        area += size;
        if (size < 0.08e-3 * cases[k].height * cases[k].width) continue;
        int cut = q.left == 0 || q.low == 0 || q.right == f.nx - 1 || q.high == f.ny - 1;
        n += cut ? 0.5 : 1;
        if (cut) continue;
        height += (q.high - q.low + 1) * f.step;
        whole++;
      }
      free(f.ray);
      double want = cases[k].density * f.wide * f.tall;
      /* broad rays are blunter than a lens */
      double broad = fmin(fmax((cases[k].height - 3) / 9, 0), 1), filled = (10 + 2 * broad) / 15;
      double cover = cases[k].density * cases[k].height * 1e-3 * cases[k].width * filled * 11 / 12;
      print_message(
          "%g/mm2 at %g mm: %.0f rays, %.0f wanted; mean height %.2f of %g mm; cover %.4f, "
          "%.4f wanted\n",
          cases[k].density, f.r, n, want, height / whole, cases[k].height, area / (f.wide * f.tall),
          cover);
      /* places within cells are less random than Poisson's; tapering ends are too
       * thin to be seen, and the lens's tips */
      assert_true(fabs(n - want) < 3 * sqrt(want) + 0.08 * want);
      assert_true(fabs(height / whole - cases[k].height) < 0.27 * cases[k].height);
      assert_true(fabs(area / (f.wide * f.tall) - cover) < 0.15 * cover);
    }
    textures->destroy(t);
  }
}

/* Rays that have no room in one layer of cells stand in two, which know nothing of each other: as
 * thick as asked for, and under a wide footprint as many as under points. */
static void crowded(void **state) {
  (void)state;
  static const struct {
    double density, height, width, tall, step;
  } cases[] = {{0.6, 2.6, 230, 40, 0.03}, {0.1, 8.5, 370, 90, 0.06}};
  for (int k = 0; k < 2; k++) {
    char text[512];
    snprintf(text, sizeof text, ROUND "ray_density=%g; ray_height=%g; ray_width=%g; ray_length=60",
             cases[k].density, cases[k].height, cases[k].width);
    sozai_texture *t = wood_make(NULL, text);
    face f = {.r = 90, .wide = 400, .tall = cases[k].tall, .step = cases[k].step};
    unroll(&f, t);
    double cover = 0;
    for (int at = 0; at < f.nx * f.ny; at++) cover += (double)f.ray[at] / f.nx / f.ny;
    free(f.ray);
    points p = {0};
    points_add(&p, f.r, 0, 0, 60);
    p.normal[0][0] = 1;
    points_ask(&p, t);
    double wide = p.out[RAY][0];
    points_free(&p);
    textures->destroy(t);
    double broad = fmin(fmax((cases[k].height - 3) / 9, 0), 1), filled = (10 + 2 * broad) / 15;
    double each =
        0.5 * cases[k].density * cases[k].height * 1e-3 * cases[k].width * filled * 11 / 12;
    double both = 2 * each - each * each;
    CHECK(fabs(cover - both) < 0.1 * both && wide > 0.75 * both && wide < both,
          "%g/mm2, %g by %g um: cover %.4f, %.4f from afar; %.4f wanted\n", cases[k].density,
          cases[k].height, cases[k].width, cover, wide, both);
  }
}

/* Half a millimetre along the fibre changes little of a ray 20 mm high, but for its
 * frayed edges. */
static void carried(void **state) {
  (void)state;
  sozai_texture *t =
      wood_make(NULL, "grain=compound; porosity=none; ray_density=0.02; ray_height=20; "
                      "ray_width=600");
  points a = {0}, b = {0};
  uniform_seed(81);
  points_add_anywhere(&a, 20000, 60, 60, 150);
  points_ask(&a, t);
  points_along_fibre(&a, 0.5f, &b);
  points_ask(&b, t);
  int in = 0, stayed = 0, across = 0;
  for (unsigned i = 0; i < a.count; i++) {
    if (a.out[RAY][i] < 0.5f) continue;
    in++;
    stayed += b.out[RAY][i] > 0.3f;
  }
  /* as far across the fibre instead */
  points_clear(&b);
  points_round_pith(&a, 0.5, &b);
  points_ask(&b, t);
  for (unsigned i = 0; i < a.count; i++) across += a.out[RAY][i] >= 0.5f && b.out[RAY][i] > 0.3f;
  CHECK(stayed > 0.9 * in && across < 0.3 * in,
        "of %d points in rays %d stay along the fibre, %d across it\n", in, stayed, across);
  points_free(&a);
  points_free(&b);
  textures->destroy(t);
}

/* Of the silver grain on a quarter-sawn face of straight wood, the area in ribbons: pieces
 * twice as long as wide or more; and of that the area in those that lie askew, 15 degrees or
 * more off the fibre, as oak's do where sheets sway through the face. */
static void ribbons(void **state) {
  (void)state;
  sozai_texture *t = wood_make("mizunara", ROUND "grain=straight; cut=quarter; cut_distance=85; "
                                                 "cut_tilt=0; cut_skew=0");
  face f = {.wide = 60, .tall = 400, .step = 0.25};
  f.nx = (int)(f.wide / f.step);
  f.ny = (int)(f.tall / f.step);
  f.ray = malloc((size_t)(f.nx * f.ny));
  points p = {0};
  for (int j = 0; j < f.ny; j++) {
    points_clear(&p);
    for (int i = 0; i < f.nx; i++) {
      unsigned n = points_add(&p, (i + 0.5) * f.step - 30, (j + 0.5) * f.step, 2, 0);
      p.normal[2][n] = 1;
    }
    points_ask(&p, t);
    for (int i = 0; i < f.nx; i++) f.ray[j * f.nx + i] = p.out[RAY][i] > 0.4f;
  }
  double all = 0, ribbon = 0, askew = 0;
  for (int at = 0; at < f.nx * f.ny; at++) {
    if (!f.ray[at]) continue;
    piece q = take(&f, at);
    double n = q.cells, xx = q.xx / n - q.x * q.x / n / n, yy = q.yy / n - q.y * q.y / n / n;
    double xy = q.xy / n - q.x * q.y / n / n, mid = (xx + yy) / 2;
    double off = hypot((xx - yy) / 2, xy);
    all += n;
    if (n < 16 || mid + off < 4 * (mid - off)) continue;
    ribbon += n;
    /* of the longer axis from +y */
    if (fabs(0.5 * atan2(2 * xy, yy - xx)) > 15 * 3.14159265 / 180) askew += n;
  }
  CHECK(all > 0.03 * f.nx * f.ny && ribbon > 0.3 * all && askew > 0.4 * ribbon,
        "silver grain covers %.3f of the face; %.2f of it are ribbons, %.2f of those askew\n",
        all / (f.nx * f.ny), ribbon / all, askew / ribbon);
  free(f.ray);
  points_free(&p);
  textures->destroy(t);
}

/* Rays do not stand above one another in columns: what they cover of lines along the fibre, side by
 * side round the stem, is much the same for all. Columns have no rays at all between them. */
static void columns(void **state) {
  (void)state;
  sozai_texture *t = wood_make(
      NULL, ROUND "grain=straight; ray_density=0.9; ray_height=1.4; ray_width=100; ray_length=40");
  face f = {.r = 70, .wide = 40, .tall = 300, .step = 0.06};
  unroll(&f, t);
  int bare = 0;
  double sum = 0;
  for (int i = 0; i < f.nx; i++) {
    int n = 0;
    for (int j = 0; j < f.ny; j++) n += f.ray[j * f.nx + i];
    sum += n;
    bare += n < 0.02 * f.ny;
  }
  double cover = sum / f.nx / f.ny;
  CHECK(cover > 0.04 && bare < 0.47 * f.nx,
        "rays cover %.3f; of lines along the fibre %.2f have "
        "less than 0.02\n",
        cover, (double)bare / f.nx);
  free(f.ray);
  textures->destroy(t);
}

/* On end grain rays are no denser about the pith, where they begin, and do not begin and end
 * together: of patches of 7 by 7 mm, as dense as each other but for chance, how unlike each other
 * they are. */
static void end_grain(void **state) {
  (void)state;
  enum { ACROSS = 7, STEPS = 28 };
  static const double radii[] = {3, 10, 50, 57, 64, 71, 78, 85, 92, 99};
  sozai_texture *t = wood_make(NULL, ROUND "grain=straight; ray_density=0.3; ray_height=2.6; "
                                           "ray_width=230; ray_length=80");
  points p = {0};
  double middle = 0, all = 0, square = 0;
  int patches = 0;
  for (int r = 0; r < 9; r++) {
    double deep = r ? ACROSS : radii[1] - radii[0], from = radii[r];
    int round = (int)(6.2831853 * (from + deep / 2) / ACROSS);
    for (int a = 0; a < round && r != 1; a++) {
      points_clear(&p);
      for (int i = 0; i < STEPS * STEPS; i++) {
        double rho = from + deep * (i / STEPS + uniform()) / STEPS;
        double angle = 6.2831853 * (a + (i % STEPS + uniform()) / STEPS) / round;
        unsigned n = points_add(&p, rho * cos(angle), 500, rho * sin(angle), 0);
        p.normal[1][n] = 1;
      }
      points_ask(&p, t);
      double cover = 0;
      for (unsigned i = 0; i < p.count; i++) cover += p.out[RAY][i] / (STEPS * STEPS);
      if (!r) {
        middle += cover / round;
        continue;
      }
      all += cover;
      square += cover * cover;
      patches++;
    }
  }
  points_free(&p);
  textures->destroy(t);
  all /= patches;
  double unlike = sqrt(square / patches - all * all) / all;
  CHECK(
      middle > 0.2 * all && middle < 1.3 * all && unlike < 0.5,
      "rays cover %.3f from 3 to 10 mm off the pith, %.3f from 50 to 99; patches differ by %.2f of "
      "that\n",
      middle, all, unlike);
}

static void filtered(void **state) {
  (void)state;
  static const double sizes[] = {0.03, 0.1, 0.3, 1, 3, 10, 30};
  static const char *const cuts[] = {"flat", "quarter", "end"};
  points p = {0};
  uniform_seed(83);
  double worst = 0;
  for (int f = 0; f < 7; f++) {
    for (int k = 0; k < 2; k++) {
      truth_errors errors = {0};
      for (int c = 0; c < 3; c++) {
        truth_errors part = {0};
        char text[64];
        snprintf(text, sizeof text, "cut=%s; cut_distance=70", cuts[c]);
        sozai_texture *t = wood_make(k ? "itayakaede" : "mizunara", text);
        for (int place = 0; place < 400; place++) {
          double x = 80 * (uniform() - 0.5), y = (c == 2 ? 80 : 800) * (uniform() - 0.5);
          truth_ask(&p, t, ONLY3(ALBEDO), x, y, 0, sizes[f]);
          truth_add(&part, &p);
        }
        textures->destroy(t);
        print_message("  %s %.4f", cuts[c], truth_rms(&part));
        errors.square += part.square;
        errors.mean += part.mean;
        errors.n += part.n;
      }
      double rms = truth_rms(&errors), mean = truth_mean(&errors);
      print_message("  %-10s footprint %-4g mm: albedo rms %.4f, mean %+.4f\n",
                    k ? "itayakaede" : "mizunara", sizes[f], rms, mean);
      worst = fmax(worst, fmax(rms, 5 * fabs(mean)));
    }
  }
  points_free(&p);
  CHECK(worst <= 0.01, "worst %.4f\n", worst);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(counts),  cmocka_unit_test(crowded),
                                     cmocka_unit_test(carried), cmocka_unit_test(ribbons),
                                     cmocka_unit_test(columns), cmocka_unit_test(end_grain),
                                     cmocka_unit_test(filtered)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
