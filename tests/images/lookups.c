/* SPDX-License-Identifier: Apache-2.0
 *
 * Look-ups beside those of OpenImageIO in what `oiiotool --colorconvert` makes of the
 * same picture, at random places with footprints from a fiftieth of a pixel to the
 * whole picture.
 */
#include "library.h"
#include "places.h"
#include "plain.h"
#include "temp.h"

#include <math.h>

/* OpenColorIO's default, which oiiotool takes, approximates powers; ours does not. */
#define TOLERANCE 2e-5

typedef struct kind {
  const char *file;
  plain_picture picture;
  const char *space; /* asked for; NULL: by the file rules */
  const char *from;  /* what that is to oiiotool; NULL: nothing is converted */
  uint32_t first, channels;
  double tolerance;
} kind;

static void run_oiiotool(const char *in, const kind *k, const char *out) {
  char command[1024], convert[128] = "", choice[32] = "";
  for (uint32_t c = 0; c < k->channels; c++)
    snprintf(choice + strlen(choice), sizeof choice - strlen(choice), "%s%u", c ? "," : "",
             k->first + c);
  if (k->from)
    snprintf(convert, sizeof convert, "--colorconvert:unpremult=1 '%s' scene_linear", k->from);
  snprintf(command, sizeof command,
           "OCIO=$(dirname '%s')/sozai.ocio " OIIOTOOL " '%s' --ch %s %s -d float -o '%s'",
           library_path, in, choice, convert, out);
  assert_int_equal(system(command), 0);
}

static void compare(const services *s, const kind *k) {
  char in[256], out[256];
  snprintf(in, sizeof in, "%s", temp_path(k->file));
  snprintf(out, sizeof out, "%s", temp_path("converted.exr"));
  const plain_picture *p = &k->picture;
  float *data = random_pixels((size_t)(p->width * p->height * p->channels), 1);
  assert_true(plain_write(in, p, data));
  free(data);
  run_oiiotool(in, k, out);

  sozai_image_request request = file_request(in, k->channels);
  request.first_channel = k->first;
  request.colour_space = k->space;
  sozai_image *image = open_image(s, &request);
  plain *other = plain_open(out, SOZAI_WRAP_CLAMP);

  static places at;
  static float found[4][PLACES];
  places_make(&at, 7, p->width, 0, 1);
  assert_int_equal(places_look(s, image, &at, 0, PLACES, found, k->channels), SOZAI_OK);
  double worst = 0, sum = 0, low = 1e9, high = -1e9;
  for (int i = 0; i < PLACES; i++) {
    float want[4] = {0};
    assert_true(plain_look(other, at.s[i], at.t[i], at.dsdx[i], at.dtdx[i], at.dsdy[i], at.dtdy[i],
                           (int)k->channels, want));
    for (uint32_t c = 0; c < k->channels; c++) {
      double difference = fabs((double)found[c][i] - (double)want[c]);
      worst = fmax(worst, difference);
      low = fmin(low, (double)want[c]), high = fmax(high, (double)want[c]);
      sum += difference;
    }
  }
  print_message("%-12s %4dx%-4d %-6s channels %u+%u of %d: numbers %.3f to %.3f, worst %.2g, "
                "mean %.2g\n",
                k->file, p->width, p->height, p->format, k->first, k->channels, p->channels, low,
                high, worst, sum / PLACES / k->channels);
  assert_true(worst <= k->tolerance);
  assert_true(high > low + 0.5);
  close_image(s, image);
  plain_close(other);
}

static void as_oiiotool(void **state) {
  static const kind kinds[] = {
      {"png8.png", {512, 256, 3, "uint8", .tile = 0}, NULL, "sRGB", 0, 3, TOLERANCE},
      {"tiled16.tif", {512, 512, 3, "uint16", .tile = 64}, "sRGB", "sRGB", 0, 3, TOLERANCE},
      {"half.exr", {256, 512, 3, "half", .tile = 0}, NULL, NULL, 0, 3, 1e-6},
      {"tiled.exr", {256, 256, 3, "half", .tile = 32}, "ACEScg", "ACEScg", 0, 3, TOLERANCE},
      {"float.exr",
       {512, 256, 3, "float", .tile = 0},
       "Linear P3-D65",
       "Linear P3-D65",
       0,
       3,
       TOLERANCE},
      {"log.tif", {256, 256, 3, "float", .tile = 0}, "acescct_ap1", "ACEScct", 0, 3, 3e-2},
      {"rgba.exr", {256, 256, 4, "half", .tile = 0}, "ACEScg", "ACEScg", 0, 4, TOLERANCE},
      {"six.exr", {256, 256, 6, "half", .tile = 0}, "sRGB", "sRGB", 2, 3, TOLERANCE},
      {"six.tif", {256, 256, 6, "float", .tile = 0}, NULL, NULL, 4, 2, 1e-6},
      {"data.png", {256, 256, 3, "uint8", .tile = 0}, "data", NULL, 0, 3, 1e-6},
      {"raw16.png", {256, 256, 3, "uint16", .tile = 0}, "Raw", NULL, 0, 3, 1e-6},
      {"height.tif", {1024, 256, 1, "uint16", .tile = 0}, NULL, NULL, 0, 1, 1e-6},
  };
  for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) compare(*state, &kinds[i]);
}

/* Sizes that do not halve evenly: OpenImageIO's "automip" leaves pixels out there,
 * so only the numbers are shown. What ours should be is levels.c's question. */
static void odd_sizes(void **state) {
  static const kind kinds[] = {
      {"even.png", {300, 200, 3, "uint8", .tile = 0}, NULL, "sRGB", 0, 3, 1},
      {"odd.png", {301, 257, 3, "uint8", .tile = 0}, NULL, "sRGB", 0, 3, 1},
  };
  for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) compare(*state, &kinds[i]);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_oiiotool), cmocka_unit_test(odd_sizes)};
  return cmocka_run_group_tests(tests, services_setup, services_teardown);
}
