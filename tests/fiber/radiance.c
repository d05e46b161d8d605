/* SPDX-License-Identifier: Apache-2.0
 * Row 10: light on curves and on the texture of one aggregate. Rays go to and fro between
 * the strands of a slab (slab.h), and the texture of the same diameter, packing, thickness,
 * rise and fibre answers under five footprints. Prints the table of docs/fiber-texture.md. */
#include <math.h>
#include "slabbed.h"

enum { SCALES = 5, POINTS = 24000, RAYS = 20000 };
static const double footprints[SCALES] = {0, 0.03, 0.3, 3, 30};
static const char *const names[3] = {"white", "wool", "dark"};
/* What is asked: of the mean of all looks, of each aggregate, colour and footprint, and beyond how
 * often the chance of the rays. And what is held, where 3 % is asked: of each look, of the root of
 * the mean square; and of one footprint from the mean of five, look by look. */
static const double asked = 0.03, chances = 2, each = 0.25, apart = 0.07;

typedef struct {
  double mean, each, apart;
} farthest;

static void print_looks(const slabbed *real, const slabbed seen_of[SCALES]) {
  for (int l = 0; l < SLAB_LOOKS; l++) {
    const double *light = lights[l % LIGHTS];
    print_message("  view %2.0f light %2.0f at %3.0f:", slab_views[l / LIGHTS], light[0], light[1]);
    for (int k = 0; k < 3; k++) {
      double mean = 0, is = real->radiance[l][k];
      for (int f = 0; f < SCALES; f++) mean += seen_of[f].radiance[l][k] / SCALES;
      print_message(" %s %.3f (%.3f) %.3f %+3.0f %%", names[k], is, real->chance[l][k], mean,
                    100 * (mean / is - 1));
    }
    print_message("\n");
  }
}

static void compare_colour(const slabbed *real, const slabbed seen_of[SCALES], int k,
                           farthest *most) {
  double square = 0;
  print_message("  %-5s %.4f: under each footprint", names[k], real->mean[k]);
  for (int f = 0; f < SCALES; f++) {
    double off = seen_of[f].mean[k] / real->mean[k] - 1, chance = real->mean_chance[k];
    print_message(" %+.1f", 100 * off);
    most->mean = fmax(most->mean, fabs(off) - chances * chance / real->mean[k]);
  }
  for (int l = 0; l < SLAB_LOOKS; l++) {
    double mean = 0, is = real->radiance[l][k];
    for (int f = 0; f < SCALES; f++) mean += seen_of[f].radiance[l][k] / SCALES;
    for (int f = 0; f < SCALES; f++)
      most->apart = fmax(most->apart, fabs(seen_of[f].radiance[l][k] / mean - 1));
    double off = mean - is, chance = real->chance[l][k];
    square += fmax(off * off - chance * chance, 0) / SLAB_LOOKS;
  }
  double of_each = sqrt(square) / real->mean[k];
  most->each = fmax(most->each, of_each);
  print_message(" %% (chance %.1f); one by one %.0f %%\n",
                100 * real->mean_chance[k] / real->mean[k], 100 * of_each);
}

static void compare(const aggregate *a, farthest *most) {
  slab b;
  grow_slab(&b, a);
  const sozai_textures_1 *textures = textures_of();
  sozai_texture *t = slab_as_texture(&b, textures);
  print_message(
      "%s: packing %.3f, %g mm; of each colour curves (+- chance), texture, parts apart\n", a->name,
      b.packing, a->thick);
  slabbed real = slab_as_curves(&b, 1, RAYS), seen_of[SCALES];
  for (int f = 0; f < SCALES; f++) seen_of[f] = slab_as_seen(t, textures, footprints[f], POINTS);
  print_looks(&real, seen_of);
  for (int k = 0; k < 3; k++) compare_colour(&real, seen_of, k, most);
  textures->destroy(t);
  free_slab(&b);
}

static void all_of_them(void **unused) {
  (void)unused;
  farthest most = {0};
  for (int i = 0; i < aggregate_count; i++) compare(&aggregates[i], &most);
  print_message("the farthest: means %.1f %% beyond chance, one by one %.0f, scales apart %.1f\n",
                100 * most.mean, 100 * most.each, 100 * most.apart);
  assert_true(most.mean <= asked);
  assert_true(most.each <= each);
  assert_true(most.apart <= apart);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(all_of_them)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
