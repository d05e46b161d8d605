/* SPDX-License-Identifier: Apache-2.0
 *
 * The paper's tile: it repeats exactly, its four stones differ, its relief is
 * displaced with half the variance on every level and normalised as the paper
 * says, and its joints lie at one height and wander as far as they are told to.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum { S_NORMAL = 6, S_HEIGHT = 9, S_JOINT = 14 };
#define PAPER "colour_mode=paper_rgb; paper_texel=1; paper_relief=256; "

static double at(const points *p, int what, unsigned i) { return (double)p->out[what][i]; }
/* 256 codes are 256 mm; the face is code 256. */
static double code(const points *p, unsigned i) { return 256 + at(p, S_HEIGHT, i); }

static void repeats_exactly(void **state) {
  (void)state;
  static const struct {
    const char *pattern;
    int x, y;
  } tiles[] = {{"cut", 160, 96}, {"chidori", 160, 192}, {"igeta", 320, 192}};
  for (unsigned k = 0; k < 3; k++) {
    char text[256];
    snprintf(text, sizeof text, PAPER "paper_length=160; paper_width=96; paper_pattern=%s",
             tiles[k].pattern);
    sozai_texture *t = stone_make(NULL, text);
    points p = {0};
    uniform_seed(31);
    enum { N = 20000 };
    for (int i = 0; i < N; i++) {
      /* eighths of texels, which floats hold at any tile */
      double x = floor(8 * 400 * uniform()) / 8, y = floor(8 * 400 * uniform()) / 8;
      int a = (int)(64 * uniform()) - 32, b = (int)(64 * uniform()) - 32;
      points_add(&p, x, y, 0, 0);
      points_add(&p, x + a * tiles[k].x, y + b * tiles[k].y, 0, 0);
      /* and by less than a tile it does not */
      points_add(&p, x + (tiles[k].pattern[0] == 'i' ? 160 : 53), y + 37, 0, 0);
    }
    points_ask(&p, t);
    int differ = 0, other = 0;
    for (unsigned i = 0; i < p.count; i += 3) {
      for (int c = 0; c < S_JOINT + 1; c++) {
        if (c == 13) continue; /* crystals are the solid's */
        differ += p.out[c][i] != p.out[c][i + 1];
      }
      other += p.out[S_HEIGHT][i] != p.out[S_HEIGHT][i + 2];
    }
    CHECK(!differ && other > N * 8 / 10,
          "%s: %d numbers differ a whole tile of %d x %d on; %d of %d heights elsewhere\n",
          tiles[k].pattern, differ, tiles[k].x, tiles[k].y, other, N);
    points_free(&p);
    textures->destroy(t);
  }
}

/* The four places of igeta's tile: other outlines, other heights. */
static void four_stones_differ(void **state) {
  (void)state;
  sozai_texture *t = stone_make(NULL, PAPER "paper_length=160; paper_width=160; "
                                            "paper_pattern=igeta; paper_dh=0");
  points p = {0};
  for (int y = 0; y < 160; y++) {
    for (int x = 0; x < 160; x++) {
      for (int k = 0; k < 4; k++) {
        /* the first stone's place begins half a stone before the origin */
        points_add(&p, x + 80.5 + 160 * (k & 1), y + 80.5 + 160 * (k >> 1), 0, 0);
      }
    }
  }
  points_ask(&p, t);
  int outline[4][4] = {{0}}, alike[4][4] = {{0}};
  for (unsigned i = 0; i < p.count; i += 4) {
    for (unsigned a = 0; a < 4; a++) {
      for (unsigned b = 0; b < a; b++) {
        outline[a][b] += (p.out[S_JOINT][i + a] > 0.5f) != (p.out[S_JOINT][i + b] > 0.5f);
        alike[a][b] +=
            p.out[S_HEIGHT][i + a] == p.out[S_HEIGHT][i + b] && p.out[S_JOINT][i + a] < 0.5f;
      }
    }
  }
  int least = 1 << 30, most = 0;
  for (int a = 0; a < 4; a++) {
    for (int b = 0; b < a; b++) {
      if (outline[a][b] < least) least = outline[a][b];
      if (alike[a][b] > most) most = alike[a][b];
    }
  }
  CHECK(least > 100 && most < 25,
        "of 25,600 texels any two stones' outlines differ in %d or more, their heights agree in %d "
        "or fewer\n",
        least, most);
  points_free(&p);
  textures->destroy(t);
}

/* Heights at the mesh's vertices: what a midpoint stands off its edge. */
static void variance_halves(void **state) {
  (void)state;
  enum { CELL = 16, GRID = 16 };
  double square[2] = {0, 0};
  int n[2] = {0, 0};
  for (int seed = 1; seed <= 60; seed++) {
    char text[256];
    snprintf(text, sizeof text,
             PAPER "paper_length=256; paper_width=256; paper_pattern=igeta; paper_dh=0; "
                   "paper_joint=0; paper_joint_wander=0; paper_repair=1; seed=%d",
             seed);
    sozai_texture *t = stone_make(NULL, text);
    points p = {0};
    for (int y = 1; y < GRID; y++) {
      for (int x = 1; x < GRID; x++) points_add(&p, 128 + x * CELL, 128 + y * CELL, 0, 0);
    }
    points_ask(&p, t);
#define H(x, y) code(&p, (unsigned)(((y)-1) * (GRID - 1) + (x)-1))
    for (int level = 0; level < 2; level++) {
      int half = level ? 1 : 2;
      for (int y = half; y < GRID; y += half) {
        for (int x = half; x < GRID; x += half) {
          int dx = x / half % 2 ? half : 0, dy = y / half % 2 ? half : 0;
          if ((!dx && !dy) || x - dx < 1 || y - dy < 1 || x + dx >= GRID || y + dy >= GRID)
            continue;
          double d = H(x, y) - 0.5 * (H(x - dx, y - dy) + H(x + dx, y + dy));
          square[level] += d * d;
          n[level]++;
        }
      }
    }
    points_free(&p);
    textures->destroy(t);
  }
  double ratio = square[0] / n[0] / (square[1] / n[1]);
  CHECK(fabs(ratio - 2) < 0.25,
        "variance of the third level's displacements over the fourth's: "
        "%.3f (2), of %d and %d\n",
        ratio, n[0], n[1]);
}

/* H' = alpha (H + e dh): the highest is 256 whatever dh is; with dh the texels
 * differ more, and the faces' own relief less. */
static void heights_are_normalised(void **state) {
  (void)state;
  static const int sweep[] = {0, 15, 30, 60, 120, 500};
  double step[6], broad[6], most[6];
  for (int k = 0; k < 6; k++) {
    char text[256];
    snprintf(text, sizeof text,
             PAPER "paper_length=192; paper_width=192; paper_pattern=cut; paper_dh=%d", sweep[k]);
    sozai_texture *t = stone_make(NULL, text);
    points p = {0};
    for (int y = 0; y < 192; y++) {
      for (int x = 0; x < 192; x++) points_add(&p, x + 0.5, y + 0.5, 0, 0);
    }
    points_ask(&p, t);
    most[k] = 0;
    double sum[12][12] = {{0}}, mean = 0, all = 0;
    step[k] = broad[k] = 0;
    for (int y = 24; y < 168; y++) {
      for (int x = 24; x < 168; x++) {
        double h = code(&p, (unsigned)(y * 192 + x)), g = code(&p, (unsigned)(y * 192 + x + 1));
        sum[(y - 24) / 12][(x - 24) / 12] += h / 144;
        step[k] += (g - h) * (g - h) / (144 * 144);
      }
    }
    for (unsigned i = 0; i < p.count; i++) most[k] = fmax(most[k], code(&p, i));
    for (int i = 0; i < 144; i++) mean += sum[i / 12][i % 12] / 144;
    for (int i = 0; i < 144; i++) all += pow(sum[i / 12][i % 12] - mean, 2) / 144;
    broad[k] = sqrt(all);
    points_free(&p);
    textures->destroy(t);
  }
  int ok = 1;
  for (int k = 0; k < 6; k++) ok &= fabs(most[k] - 256) < 0.05;
  for (int k = 1; k < 6; k++) ok &= step[k] > step[k - 1] && broad[k] < broad[k - 1];
  for (int k = 0; k < 6; k++) {
    print_message("dh %3d: highest code %.3f, between texels %.2f RMS, between patches %.2f\n",
                  sweep[k], most[k], sqrt(step[k]), broad[k]);
  }
  CHECK(ok, "the highest is 256; dh roughens and flattens\n");
}

static double linear(double c) {
  c /= 255;
  return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

static void joints_are_joints(void **state) {
  (void)state;
  sozai_texture *t = stone_make(
      NULL, PAPER "paper_length=200; paper_width=200; paper_pattern=cut; paper_joint=6; "
                  "paper_joint_wander=0.06; paper_joint_height=40; paper_joint_parts=10; "
                  "paper_joint_colour=110 105 98; paper_base=50 50 50; paper_variation=30 30 30");
  points p = {0};
  for (int y = 0; y < 200; y++) {
    for (int x = 0; x < 200; x++) points_add(&p, x + 0.5, y + 0.5, 0, 0);
  }
  points_ask(&p, t);
  static const double wanted[3] = {110, 105, 98};
  int joint = 0, uneven = 0, coloured = 0, stained = 0;
  for (unsigned i = 0; i < p.count; i++) {
    if (p.out[S_JOINT][i] > 0.5f) {
      joint++;
      /* bilinear: the texel's own at its middle */
      uneven += fabs(code(&p, i) - 40) > 0.02;
      for (int c = 0; c < 3; c++) coloured += fabs(at(&p, c, i) - linear(wanted[c])) > 1e-4;
    } else {
      for (int c = 0; c < 3; c++) {
        stained += at(&p, c, i) < linear(20) - 1e-4 || at(&p, c, i) > linear(80) + 1e-4;
      }
    }
  }
  /* how far in the outline lies, at the division points */
  double low = 1e9, high = 0, mean = 0;
  for (int k = 1; k < 10; k++) {
    int from = 0;
    while (from < 100 && p.out[S_JOINT][(unsigned)(from * 200 + 20 * k)] > 0.5f) from++;
    low = fmin(low, from);
    high = fmax(high, from);
    mean += from / 9.0;
  }
  CHECK(joint > 2000 && !uneven && !coloured && !stained,
        "%d texels of joint, %d not at code 40, %d colours off; %d stone's colours beyond 50 +- "
        "30\n",
        joint, uneven, coloured, stained);
  CHECK(low >= 2 && high <= 3 + 0.06 * 200 + 1 && high - low > 5 && fabs(mean - 9) < 3.5,
        "the outline lies %.0f to %.0f texels in, %.1f on average (3 to 15, 9)\n", low, high, mean);
  points_clear(&p);
  points_add(&p, 100, 100, 0, 3000);
  double share = joint / 40000.0;
  points_ask(&p, t);
  CHECK(fabs(at(&p, S_JOINT, 0) - share) < 0.003, "wide footprints are %.4f joint (%.4f)\n",
        at(&p, S_JOINT, 0), share);
  points_free(&p);
  textures->destroy(t);
}

static void refused(void **state) {
  (void)state;
  static const char *const bad[][3] = {
      {PAPER "paper_pattern=cut; layout=stack", "paper_pattern", "layout"},
      {PAPER "paper_pattern=cut; paper_joint=180", "paper_joint", "0 to 116"},
      {PAPER "paper_pattern=brick", "paper_pattern", "igeta"},
      {PAPER "paper_levels=9", "paper_levels", "4"}};
  for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++) {
    const char *why = stone_refused(bad[i][0]);
    CHECK(why && strstr(why, bad[i][1]) && strstr(why, bad[i][2]), "%s\n", why ? why : "taken");
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(repeats_exactly),   cmocka_unit_test(four_stones_differ),
      cmocka_unit_test(variance_halves),   cmocka_unit_test(heights_are_normalised),
      cmocka_unit_test(joints_are_joints), cmocka_unit_test(refused),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
