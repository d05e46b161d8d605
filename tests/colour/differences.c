/* SPDX-License-Identifier: Apache-2.0
 *
 * The service beside other programs' answers for the same config, in Delta E 2000:
 * at most 0.5 anywhere. Skipped without oiiotool.
 */
#include "ciede2000.h"
#include "colorimetry.h"
#include "library.h"
#include "other_path.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"
#define BLENDER blender_config()
#define LIMIT 0.5

static float here[PIXELS * 3], there[PIXELS * 3];

/* What makes numbers XYZ under D65: a space's matrix, after sRGB's curve or none. */
typedef struct meaning {
  matrix to_xyz;
  int encoded;
} meaning;

static meaning linear(primaries p) {
  const primaries d65 = rec709;
  return (meaning){product(rgb_to_xyz(d65), rgb_to_rgb(p, d65)), 0};
}
static meaning srgb(void) { return (meaning){rgb_to_xyz(rec709), 1}; }

static void lab_meant(meaning m, const float rgb[3], double lab[3]) {
  double v[3], xyz[3];
  for (int c = 0; c < 3; c++) {
    v[c] = rgb[c];
    if (m.encoded) {
      v[c] = fmin(1, fmax(0, v[c])); /* what a display can show */
      v[c] = v[c] <= 0.04045 ? v[c] / 12.92 : pow((v[c] + 0.055) / 1.055, 2.4);
    }
  }
  transform(m.to_xyz, v, xyz);
  lab_of(xyz, lab);
}

static void compare(meaning m, const char *what) {
  double worst = 0, sum = 0;
  for (int i = 0; i < PIXELS; i++) {
    double a[3], b[3];
    lab_meant(m, here + 3 * i, a);
    lab_meant(m, there + 3 * i, b);
    double e = ciede2000(a, b);
    worst = isfinite(e) ? fmax(worst, e) : INFINITY;
    sum += e;
  }
  print_message("%s: Delta E 2000 %.4f at most, %.5f on average\n", what, worst, sum / PIXELS);
  assert_true(worst <= LIMIT);
}

static void shipped_path(char path[1024]) {
  snprintf(path, 1024, "%s", library_path);
  char *slash = strrchr(path, '/');
  assert_non_null(slash);
  strcpy(slash + 1, "sozai.ocio");
}

/* A space into the working space, and what the working space is. */
static void palette(const char *config, const char *space, const primaries *working) {
  char what[1200], arguments[256], path[1024], message[512] = "";
  shipped_path(path);
  if (!config) config = path;
  if (access(config, R_OK) != 0) {
    print_message("%s is not here\n", config);
    return;
  }
  service s = service_open(config);
  const sozai_colour_1 *c = s.colour;
  const char *name = c->working_space(c->self);
  input_colours(1, here);
  if (c->to_working(c->self, space, here, PIXELS, message, sizeof message) != SOZAI_OK)
    fail_msg("%s", message);
  snprintf(arguments, sizeof arguments, "--colorconvert '%s' '%s'", space, name);
  by_oiiotool(config, 1, arguments, there);
  snprintf(what, sizeof what, "%s: %s to %s, oiiotool", strrchr(config, '/') + 1, space, name);
  compare(linear(*working), what);
  if (has_program("ocioconvert")) {
    by_ocioconvert(config, space, name, 1, there);
    snprintf(what, sizeof what, "%s: %s to %s, ocioconvert", strrchr(config, '/') + 1, space, name);
    compare(linear(*working), what);
  }
  service_close(s);
}

static void palettes(void **state) {
  (void)state;
  if (!has_program("oiiotool")) skip();
  palette(NULL, "sRGB", &rec709);
  palette(NULL, "ACEScg", &rec709);
  palette(NULL, "Linear P3-D65", &rec709);
  palette(BLENDER, "sRGB", &rec709);
  palette(BLENDER, "Linear ACEScg", &rec709);
  palette(CONFIG("acescg"), "sRGB - Texture", &aces_ap1);
  palette(CONFIG("acescg"), "lin_rec709", &aces_ap1);
  palette(CONFIG("p3d65"), "srgb_texture", &p3_d65);
  palette(CONFIG("p3d65"), "ACES2065-1", &p3_d65);
}

/* look: in place of the view's own, done in the space `process`; NULL: the view's. */
static void view(const char *config, const char *display, const char *name, const char *look,
                 const char *process) {
  char what[1200], arguments[512] = "", path[1024], message[512] = "";
  shipped_path(path);
  if (!config) config = path;
  if (access(config, R_OK) != 0) {
    print_message("%s is not here\n", config);
    return;
  }
  service s = service_open(config);
  const sozai_display_1 *d = s.display;
  const char *from = s.colour->working_space(s.colour->self);
  const float scale = 4;
  input_colours(scale, here);
  if (d->to_display(d->self, display, name, look, here, PIXELS, message, sizeof message) !=
      SOZAI_OK)
    fail_msg("%s", message);
  /* The oiiotool of Debian 12 overlooks looks= of --ociodisplay: a step of its own. */
  if (look) {
    snprintf(arguments, sizeof arguments, "'--ociolook:from=%s:to=%s' '%s' ", from, process, look);
    from = process;
  }
  size_t used = strlen(arguments);
  snprintf(arguments + used, sizeof arguments - used, "'--ociodisplay:from=%s' '%s' '%s'", from,
           display, name);
  by_oiiotool(config, scale, arguments, there);
  snprintf(what, sizeof what, "%s: %s, %s%s%s", strrchr(config, '/') + 1, display, name,
           look ? " with " : "", look ? look : "");
  compare(srgb(), what);
  service_close(s);
}

static void views(void **state) {
  (void)state;
  if (!has_program("oiiotool")) skip();
  view(NULL, "sRGB", "sozai", NULL, NULL);
  view(NULL, "sRGB", "Standard", NULL, NULL);
  view(BLENDER, "sRGB", "Standard", NULL, NULL);
  view(BLENDER, "sRGB", "Filmic", NULL, NULL);
  view(BLENDER, "sRGB", "Filmic", "High Contrast", "Filmic Log");
  view(CONFIG("acescg"), "sRGB - Display", "ACES 1.0 - SDR Video", NULL, NULL);
  view(CONFIG("acescg"), "sRGB - Display", "Un-tone-mapped", NULL, NULL);
  view(CONFIG("acescg"), "sRGB - Display", "Warm", NULL, NULL);
  view(CONFIG("acescg"), "sRGB - Display", "ACES 1.0 - SDR Video", "warm", "ACEScct");
  view(CONFIG("acescg"), "sRGB - Display", "Un-tone-mapped", "warm,-dim", "ACEScg");
  view(CONFIG("p3d65"), "Screen", "Plain", NULL, NULL);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(palettes), cmocka_unit_test(views)};
  return cmocka_run_group_tests(tests, library_setup, library_teardown);
}
