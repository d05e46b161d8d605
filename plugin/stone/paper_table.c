/* SPDX-License-Identifier: Apache-2.0
 *
 * What a code of the paper's 8-bit RGB is in the working space.
 *
 * sRGB is a curve to each channel and a matrix for all: the working colour of
 * (r, g, b) is T(r, 0, 0) + T(0, g, 0) + T(0, 0, b) - 2 T(0, 0, 0), whatever
 * the working space. All 768 codes go through the colour service once, and a
 * few hundred triples more to see that the sum holds in this config.
 */
#include "paper_table.h"

#include "../core/colour.h"
#include "../core/hash1.h"
#include "../core/status.h"
#include "parameters.h"

enum { TRIPLES = 256, ENTRIES = 3 * STONE_CODES + TRIPLES };

static void triple_of(uint32_t i, float rgb[3]) {
  for (uint32_t c = 0; c < 3; c++) {
    rgb[c] = (float)(hash1(i * 3u + c) % STONE_CODES) / (float)(STONE_CODES - 1);
  }
}

static double held(double x) { return x < 0.0 ? 0.0 : x > 255.0 ? 255.0 : x; }

/* Mean over a code that is uniform within base +- spread, rounded and held
 * within 0..255: every code's share of the interval. */
static void mean_of_channel(const stone_constants *w, int c, double mean[3]) {
  double low = (double)w->base[c] - (double)w->spread[c], width = 2.0 * (double)w->spread[c];
  for (int k = 0; k < STONE_CODES; k++) {
    double a = k ? k - 0.5 : -1e9, b = k < STONE_CODES - 1 ? k + 0.5 : 1e9, share;
    if (width > 1e-6) {
      double from = a > low ? a : low, to = b < low + width ? b : low + width;
      share = to > from ? (to - from) / width : 0.0;
    } else {
      share = low >= a && low < b;
    }
    for (int o = 0; o < 3; o++) mean[o] += share * (double)w->decode[c][k][o];
  }
}

/* The same for lightness and chroma, by the midpoint rule over both. */
static void mean_of_lightness(const stone_constants *w, double mean[3]) {
  enum { STEPS = 128 };
  for (int i = 0; i < STEPS * STEPS; i++) {
    double l = 2.0 * (i % STEPS + 0.5) / STEPS - 1.0, k = 2.0 * (i / STEPS + 0.5) / STEPS - 1.0;
    for (int c = 0; c < 3; c++) {
      double chroma = 1.0 + (double)w->chroma * k;
      double x =
          (double)w->luma + (double)w->lightness * l + (double)(w->base[c] - w->luma) * chroma;
      int code = (int)(held(x) + 0.5);
      for (int o = 0; o < 3; o++) {
        mean[o] += (double)w->decode[c][code][o] / (STEPS * STEPS);
      }
    }
  }
}

static int32_t fill(stone_constants *w, const sozai_host *host, float (*rgb)[3]) {
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < STONE_CODES; k++) {
      float *at = rgb[c * STONE_CODES + k];
      at[0] = at[1] = at[2] = 0.0f;
      at[c] = (float)k / (float)(STONE_CODES - 1);
    }
  }
  for (uint32_t i = 0; i < TRIPLES; i++) triple_of(i, rgb[3 * STONE_CODES + i]);
  int32_t r = colour_list(host, "sRGB", rgb, ENTRIES);
  if (r) return r;
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < STONE_CODES; k++) {
      for (int o = 0; o < 3; o++) {
        /* black is counted once, with red */
        double black = c ? (double)rgb[0][o] : 0.0;
        w->decode[c][k][o] = (float)((double)rgb[c * STONE_CODES + k][o] - black);
      }
    }
  }
  for (uint32_t i = 0; i < TRIPLES; i++) {
    float codes[3];
    triple_of(i, codes);
    for (int o = 0; o < 3; o++) {
      double sum = 0.0, wanted = (double)rgb[3 * STONE_CODES + i][o];
      for (int c = 0; c < 3; c++) {
        sum += (double)w->decode[c][(int)((double)codes[c] * 255.0 + 0.5)][o];
      }
      if (sum - wanted > 1e-4 || wanted - sum > 1e-4) {
        return fail(SOZAI_ERROR_COLOUR, "colour_mode: the paper's modes take a config in which "
                                        "sRGB is a curve and a matrix away from the working "
                                        "space, and in this one it is not");
      }
    }
  }
  return SOZAI_OK;
}

int32_t paper_build(stone_constants *w, const sozai_host *host) {
  size_t bytes = ENTRIES * sizeof(float[3]);
  float(*rgb)[3] = host_alloc(host, bytes, 64);
  if (!rgb) return SOZAI_ERROR_MEMORY;
  int32_t r = fill(w, host, rgb);
  host_free(host, rgb, bytes, 64);
  if (r) return r;
  double mean[3] = {0.0, 0.0, 0.0};
  if (w->mode == MODE_RGB) {
    for (int c = 0; c < 3; c++) mean_of_channel(w, c, mean);
  } else {
    mean_of_lightness(w, mean);
  }
  for (int o = 0; o < 3; o++) {
    double dark = 0.0, light = 0.0;
    for (int c = 0; c < 3; c++) {
      dark += (double)w->decode[c][0][o];
      light += (double)w->decode[c][STONE_CODES - 1][o];
    }
    double black = (double)w->black, white = (double)w->white - black;
    w->texel_mean[o] = (float)(mean[o] * (1.0 - black - white) + dark * black + light * white);
  }
  return SOZAI_OK;
}
