/* SPDX-License-Identifier: Apache-2.0
 *
 * Figure of the growth front: curl, quilt and bird's eyes, within what keeps rings apart.
 */
#include "parts.h"

#include "../../core/status.h"
#include "../parameters.h"

static int32_t build_curl(wood_constants *w, const settings *s) {
  double slope = number_at(s, P_CURL_SLOPE), length = number_at(s, P_CURL_LENGTH);
  w->has_curl = slope > 0.0;
  w->curl_slope = (float)slope;
  w->curl_height = (float)(slope * length / TWO_PI);
  w->curl_frequency = (float)(1.0 / length);
  double amount = number_at(s, P_CURL_IRREGULARITY), reach = number_at(s, P_CURL_REACH);
  w->curl = wood_irregular_of(amount, length, 0.137);
  w->curl_inverse_reach = (float)(1.0 / reach);
  /* rings keep apart: u changes across the stem by the swell's noises, 3.2 a reach at
   * most each, and by the phase's, 1.5 over CURL_STRAY_REACH */
  double strongest = (double)w->curl.steady + 1.4142 * (double)w->curl.swell;
  double bound = 3.0 * 3.2 * (double)w->curl.swell / TWO_PI +
                 strongest * (double)w->curl.stray * 1.5 / (double)CURL_STRAY_REACH;
  if (slope * length * bound > 0.8000001 * reach) {
    return fail(SOZAI_ERROR_RANGE,
                "curl_slope: %.9g over a curl_length of %.9g mm, a curl_irregularity of %.9g and a "
                "curl_reach of %.9g mm: rings would cross; 0 to %.9g",
                slope, length, amount, reach, 0.8 * reach / (length * bound));
  }
  return SOZAI_OK;
}

static int32_t build_quilt(wood_constants *w, const settings *s) {
  double quilt = number_at(s, P_QUILT_SLOPE), height = number_at(s, P_QUILT_HEIGHT);
  double width = number_at(s, P_QUILT_WIDTH), most = 0.117 * width / height;
  if (quilt > most * 1.0000001) {
    return fail(SOZAI_ERROR_RANGE,
                "quilt_slope: %.9g is above 0.117 of quilt_width (%.9g mm) over quilt_height "
                "(%.9g mm): rings would cross; 0 to %.9g",
                quilt, width, height, most);
  }
  w->has_quilt = quilt > 0.0;
  w->quilt_slope = (float)quilt;
  /* the noise's slope is 0.41, root mean square */
  w->quilt_height = (float)(quilt * height / 0.41);
  w->quilt_frequency = (float)(1.0 / width);
  w->quilt_frequency_axis = (float)(1.0 / height);
  w->quilt_size = (float)(width < height ? width : height);
  return SOZAI_OK;
}

static int32_t build_eyes(wood_constants *w, const settings *s) {
  double density = number_at(s, P_EYE_DENSITY), diameter = number_at(s, P_EYE_DIAMETER);
  double crowd = 32.0 / (diameter * diameter);
  if (density > crowd * 1.0000001) {
    return fail(
        SOZAI_ERROR_RANGE,
        "eye_density: %.9g/cm2 leaves no room for eyes of eye_diameter = %.9g mm; 0 to %.9g",
        density, diameter, crowd);
  }
  double depth = number_at(s, P_EYE_DEPTH),
         deepest = number_at(s, P_EYE_LENGTH) / (17.5 * diameter);
  if (density > 0.0 && depth > deepest * 1.0000001) {
    return fail(SOZAI_ERROR_RANGE,
                "eye_depth: %.9g of eyes of %.9g mm over an eye_length of %.9g mm: rings would "
                "cross; 0 to %.9g",
                depth, diameter, number_at(s, P_EYE_LENGTH), deepest);
  }
  w->has_eyes = density > 0.0 && depth > 0.0;
  w->eye_radius = (float)(0.5 * diameter);
  w->eye_depth = (float)depth;
  w->eye_length = (float)number_at(s, P_EYE_LENGTH);
  w->inverse_eye_length = (float)(1.0 / number_at(s, P_EYE_LENGTH));
  if (!w->has_eyes) return SOZAI_OK;
  /* in each of four layers a share of the cells have one, and a radius meets three quarters of
   * those, less what has only begun or all but ended */
  double cell = 10.0 * __builtin_sqrt(0.62 * 0.7 / (0.25 * density));
  /* in the mean over a face: the layers' radii squared are 1.07 of the mean's, eyes nine
   * tenths grown; to 0.68 the cells' edges cut, as the filter's test found */
  const double eyes = 0.68 * (double)WOOD_EYE_DARK;
  double area = 3.14159265 * WOOD_EYE_LONG * WOOD_EYE_RIM * eyes * w->eye_radius * w->eye_radius;
  w->eye_mean = (float)(0.01 * density * area * WOOD_EYE_MEAN);
  w->eye_cell = (float)cell;
  w->inverse_eye_cell = (float)(1.0 / cell);
  return SOZAI_OK;
}

int32_t wood_build_figure(wood_constants *w, const settings *s) {
  int32_t r = build_curl(w, s);
  if (!r) r = build_quilt(w, s);
  if (!r) r = build_eyes(w, s);
  return r;
}
