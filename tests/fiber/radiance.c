/* SPDX-License-Identifier: Apache-2.0
 * Row 10: light on curves and on the texture of one aggregate. Rays go to and fro between
 * the strands of a slab (slab.h), and the texture of the same diameter, packing, thickness,
 * rise and fibre answers under five footprints. Prints the table of docs/fiber-texture.md. */
#include <math.h>
#include "slab.h"
#include "textured.h"

enum { SCALES = 5, POINTS = 32768, VIEWS = 2 };
static const double views[VIEWS] = {90, 45};

/* ---- the texture ------------------------------------------------------- */

static sozai_texture *texture_of(const slab *b, const sozai_textures_1 *textures) {
  const aggregate *a = b->of;
#define NUMBER_(i, x)                                                                              \
  {                                                                                                \
    .id = i, .kind = SOZAI_KIND_FLOAT, .number = { x }                                             \
  }
  const sozai_value values[] = {
      NUMBER_("diameter", a->diameter),
      NUMBER_("diameter_spread", 0),
      NUMBER_("thickness", a->thick),
      NUMBER_("packing", b->packing),
      NUMBER_("flyaway", 0),
      NUMBER_("crimp", 0),
      NUMBER_("alignment", 0),
      NUMBER_("elevation", 0),
      NUMBER_("elevation_spread", atan(b->rise) * 180 / PI),
      NUMBER_("second_share", 0),
      NUMBER_("variation", 0),
      {.id = "colour",
       .kind = SOZAI_KIND_COLOUR,
       .number = {encoded((double)colours[0]), encoded((double)colours[1]),
                  encoded((double)colours[2])},
       .text = "sRGB"},
  };
  sozai_texture *t;
  if (textures->create(NULL, "fiber", a->preset, values, sizeof values / sizeof *values, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

/* Mean radiance of the three colours. */
static void look_at_texture(const sozai_texture *t, const sozai_textures_1 *textures, vec view,
                            vec light, double footprint, double got[3]) {
  ground g = ground_of(POINTS, 1);
  uint32_t r = 9;
  for (int i = 0; i < POINTS; i++) {
    /* the hull's frame turns with the ground, as the curves' view does */
    double turn = 2 * PI * random_of(&r), c = cos(turn), d = sin(turn);
    for (int k = 0; k < 2; k++) g.at[k][i] = (float)(400 * random_of(&r));
    const vec *of[2] = {&view, &light};
    float **to[2] = {g.view, g.light};
    for (int q = 0; q < 2; q++) {
      double x = (double)of[q]->x, y = (double)of[q]->y;
      to[q][0][i] = (float)(c * x - d * y);
      to[q][1][i] = (float)(d * x + c * y);
      to[q][2][i] = of[q]->z;
    }
  }
  ground_ask(&g, textures, t, footprint);
  for (int k = 0; k < 3; k++) got[k] = ground_mean(&g, RADIANCE + k);
  ground_free(&g);
}

/* ---- both -------------------------------------------------------------- */

static void compare(const aggregate *a) {
  static const double footprints[SCALES] = {0, 0.03, 0.3, 3, 30};
  static const char *const names[3] = {"white", "wool", "dark"};
  slab b;
  grow_slab(&b, a);
  const sozai_textures_1 *textures = textures_of();
  sozai_texture *t = texture_of(&b, textures);
  print_message(
      "%s: packing %.3f, %g mm; of each colour curves (+- chance), texture, parts apart\n", a->name,
      b.packing, a->thick);
  double all[3] = {0}, all_seen[SCALES][3] = {{0}}, worst[3] = {0}, chance2[3] = {0}, apart = 0;
  for (int v = 0; v < VIEWS; v++) {
    seen s = look_at_curves(&b.t, (eye){views[v], 0, 360}, a->rays);
    for (int l = 0; l < LIGHTS; l++) {
      double got[SCALES][3], mean[3] = {0};
      vec towards = aim(lights[l][0], lights[l][1]);
      for (int f = 0; f < SCALES; f++) {
        look_at_texture(t, textures, aim(views[v], 0), towards, footprints[f], got[f]);
        for (int k = 0; k < 3; k++) mean[k] += got[f][k] / SCALES;
      }
      print_message("  view %2.0f light %2.0f at %3.0f:", views[v], lights[l][0], lights[l][1]);
      for (int k = 0; k < 3; k++) {
        double square = s.square[l][k] - s.sum[l][k] * s.sum[l][k];
        double chance = sqrt(fmax(square, 0) / a->rays), off = mean[k] / s.sum[l][k] - 1;
        print_message(" %s %.3f (%.3f) %.3f %+3.0f %%", names[k], s.sum[l][k], chance, mean[k],
                      100 * off);
        double beyond = fabs(mean[k] - s.sum[l][k]) - 3 * chance;
        worst[k] = fmax(worst[k], beyond / s.sum[l][k]);
        for (int f = 0; f < SCALES; f++) apart = fmax(apart, fabs(got[f][k] / mean[k] - 1));
        all[k] += s.sum[l][k];
        for (int f = 0; f < SCALES; f++) all_seen[f][k] += got[f][k];
      }
      print_message("\n");
    }
    for (int k = 0; k < 3; k++) {
      double sum = 0;
      for (int l = 0; l < LIGHTS; l++) sum += s.sum[l][k];
      chance2[k] += (s.square_of_all[k] - sum * sum) / a->rays;
    }
  }
  double most[3] = {0};
  for (int k = 0; k < 3; k++) {
    print_message("  %s: the mean of all, under each footprint:", names[k]);
    for (int f = 0; f < SCALES; f++) {
      double off = all_seen[f][k] / all[k] - 1;
      print_message(" %+.1f", 100 * off);
      most[k] = fmax(most[k], fabs(off));
    }
    double chance = sqrt(chance2[k]) / all[k];
    most[k] -= chance;
    print_message(" %% (%.1f allowed beyond a chance of %.1f); one by one %.0f %% (%.0f) beyond\n",
                  100 * a->mean[k], 100 * chance, 100 * worst[k], 100 * a->each[k]);
  }
  print_message("  scales from their mean: %.1f %%\n", 100 * apart);
  for (int k = 0; k < 3; k++) {
    assert_true(most[k] <= a->mean[k]);
    assert_true(worst[k] <= a->each[k]);
  }
  assert_true(apart <= a->apart);
  textures->destroy(t);
  free_slab(&b);
}

static const aggregate list[] = {
    {.name = "felt",
     .preset = "felt",
     .diameter = 20,
     .length = 1.2,
     .side = 3,
     .thick = 4,
     .packing = 0.1,
     .squeeze = 0.3,
     .roughness = 10,
     .round = 0.4f,
     .tilt = 3,
     .index = 1.553f,
     .rays = 12000,
     .mean = {0.03, 0.03, 0.03},
     .each = {0.06, 0.07, 0.26},
     .apart = 0.055},
    {.name = "merino",
     .preset = "wool_merino",
     .diameter = 20,
     .length = 1.2,
     .side = 3,
     .thick = 10,
     .packing = 0.03,
     .squeeze = 0.3,
     .roughness = 9,
     .round = 0.35f,
     .tilt = 3,
     .index = 1.553f,
     .rays = 12000,
     .mean = {0.03, 0.03, 0.03},
     .each = {0.05, 0.07, 0.27},
     .apart = 0.065},
    {.name = "cotton",
     .preset = "cotton",
     .diameter = 14,
     .length = 1.2,
     .side = 3,
     .thick = 12,
     .packing = 0.02,
     .squeeze = 0.5,
     .roughness = 14,
     .round = 0.55f,
     .index = 1.55f,
     .rays = 12000,
     .mean = {0.03, 0.03, 0.03},
     .each = {0.2, 0.27, 0.39},
     .apart = 0.075},
    {.name = "thin",
     .preset = "felt",
     .diameter = 20,
     .length = 1.2,
     .side = 5,
     .thick = 0.7,
     .packing = 0.03,
     .squeeze = 0.5,
     .roughness = 10,
     .round = 0.4f,
     .tilt = 3,
     .index = 1.553f,
     .rays = 12000,
     .mean = {0.07, 0.05, 0.05},
     .each = {0.2, 0.18, 0.23},
     .apart = 0.08},
    {.name = "half-thick",
     .preset = "felt",
     .diameter = 20,
     .length = 1.2,
     .side = 5,
     .thick = 2.7,
     .packing = 0.03,
     .squeeze = 0.5,
     .roughness = 10,
     .round = 0.4f,
     .tilt = 3,
     .index = 1.553f,
     .rays = 8000,
     .mean = {0.03, 0.03, 0.06},
     .each = {0.04, 0.04, 0.09},
     .apart = 0.07},
};

static void all_of_them(void **unused) {
  (void)unused;
  for (unsigned i = 0; i < sizeof list / sizeof *list; i++) compare(&list[i]);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(all_of_them)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
