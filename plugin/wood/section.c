/* SPDX-License-Identifier: Apache-2.0
 *
 * A section from a picture: its scale, its pith and rim, and what the kernel
 * wants to know of its brightness.
 */
#include "section.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "parameters.h"
#include "scan.h"

#define TWO_PI 6.28318530717958647692
#define GRID 768     /* cells along the longer side, at most */
#define MARGIN 0.985 /* of the rim: what is nearer to it is mixed with the background */
#define PROBES 4096

/* A picture's grid, and all the room that reading it takes. */
typedef struct {
  scan scan;
  float *rgb;
  void *memory;
  size_t bytes;
} sheet;

static int32_t sheet_open(sheet *h, const sozai_host *host, uint32_t width, uint32_t height) {
  uint32_t longer = width > height ? width : height;
  double k = longer > GRID ? (double)GRID / longer : 1.0;
  int nx = (int)(width * k + 0.5), nz = (int)(height * k + 0.5);
  nx = nx < 1 ? 1 : nx;
  nz = nz < 1 ? 1 : nz;
  size_t cells = (size_t)nx * (size_t)nz, votes = (size_t)scan_votes(nx, nz);
  /* the frame of a grid of one line is counted twice over */
  size_t room = cells + 2 * (size_t)(nx + nz);
  h->bytes =
      sizeof(float) * (3 * cells + room + 3 * cells + votes) + sizeof(int32_t) * room + cells;
  h->memory = host_alloc(host, h->bytes, 64);
  if (!h->memory) return SOZAI_ERROR_MEMORY;
  float *f = h->memory;
  h->rgb = f;
  h->scan = (scan){.nx = nx, .nz = nz, .rgb = f};
  h->scan.grey = f + 3 * cells;
  h->scan.tensor = h->scan.grey + room;
  h->scan.votes = h->scan.tensor + 3 * cells;
  h->scan.stack = (int32_t *)(h->scan.votes + votes);
  h->scan.wood = (uint8_t *)(h->scan.stack + room);
  return SOZAI_OK;
}

/* n look-ups of squares of the given sides in s and t; rgb interleaved. */
static int32_t look(const sozai_images_1 *images, const sozai_image *picture, uint32_t n,
                    const float *s, const float *t, float ds, float dt, float *rgb) {
  float out[3][GRID], zero[GRID] = {0}, ss[GRID] = {0}, tt[GRID] = {0};
  for (uint32_t i = 0; i < n; i++) {
    ss[i] = ds;
    tt[i] = dt;
  }
  float *const to[3] = {out[0], out[1], out[2]};
  int32_t r = images->sample(images->self, picture, n, s, t, ss, zero, zero, tt, to);
  if (r) return fail(image_result(r), "section: the picture cannot be looked up");
  for (uint32_t i = 0; i < n; i++) {
    for (int c = 0; c < 3; c++) {
      float v = out[c][i];
      rgb[3 * i + (uint32_t)c] = v >= 0.0f && v <= 1.0f ? v : v > 1.0f ? 1.0f : 0.0f;
    }
  }
  return SOZAI_OK;
}

static int32_t sheet_fill(sheet *h, const sozai_images_1 *images, const sozai_image *picture) {
  uint32_t nx = (uint32_t)h->scan.nx, nz = (uint32_t)h->scan.nz;
  float s[GRID], t[GRID], ds = 1.0f / (float)nx, dt = 1.0f / (float)nz;
  int32_t r = SOZAI_OK;
  for (uint32_t j = 0; j < nz && !r; j++) {
    for (uint32_t i = 0; i < nx; i++) {
      s[i] = ((float)i + 0.5f) * ds;
      t[i] = ((float)j + 0.5f) * dt;
    }
    r = look(images, picture, nx, s, t, ds, dt, h->rgb + 3 * (size_t)j * nx);
  }
  return r;
}

/* The largest circle about the pith that stays within the picture; 0: the pith
 * is outside, or near its edge. Cells. */
static double largest_circle(const scan *g, const double pith[2]) {
  double r = pith[0], other[3] = {g->nx - pith[0], pith[1], g->nz - pith[1]};
  for (int i = 0; i < 3; i++) r = other[i] < r ? other[i] : r;
  return r > 0.1 * g->nx && r > 0.1 * g->nz ? r : 0.0;
}

/* The rim in mm: the mean radius and the outline's harmonics take what they
 * can, so that the years' surfaces follow it; the rest stays in the table. */
static void fit_outline(wood_constants *w, const float *rim) {
  double mean = 0.0, most = 0.0;
  for (int k = 0; k < WOOD_RIM; k++) mean += (double)rim[k] / WOOD_RIM;
  for (int h = 1; h <= WOOD_HARMONICS; h++) {
    double a = 0.0, b = 0.0;
    for (int k = 0; k < WOOD_RIM; k++) {
      double angle = TWO_PI * k / WOOD_RIM, x = (double)rim[k] / mean - 1.0;
      a += 2.0 / WOOD_RIM * x * scalar_cos(h * angle);
      b += 2.0 / WOOD_RIM * x * scalar_sin(h * angle);
    }
    w->outline_cos[h - 1] = (float)a;
    w->outline_sin[h - 1] = (float)b;
    most += __builtin_sqrt(a * a + b * b);
  }
  /* the bound of section_wobble, within which rings do not cross */
  double k = most > 0.3 ? 0.3 / most : 1.0;
  for (int h = 0; h < WOOD_HARMONICS; h++) {
    w->outline_cos[h] = (float)((double)w->outline_cos[h] * k);
    w->outline_sin[h] = (float)((double)w->outline_sin[h] * k);
  }
}

static void set_rim(wood_constants *w, const float *rim) {
  for (int k = 0; k <= WOOD_RIM; k++) {
    double angle = TWO_PI * k / WOOD_RIM, widen = 1.0;
    for (int h = 1; h <= WOOD_HARMONICS; h++) {
      widen += (double)w->outline_cos[h - 1] * scalar_cos(h * angle) +
               (double)w->outline_sin[h - 1] * scalar_sin(h * angle);
    }
    w->rim[k] = (float)((double)rim[k % WOOD_RIM] / widen);
  }
  w->folded = 1;
}

static void round_rim(float *rim, double mm) {
  for (int k = 0; k < WOOD_RIM; k++) rim[k] = (float)mm;
}

/* Grey of the brightest and the darkest wood: the 5th and 95th of 100. */
static void set_contrast(wood_constants *w, const scan *g) {
  int count[1024] = {0}, total = 0;
  for (int k = 0; k < g->nx * g->nz; k++) {
    if (!g->wood[k]) continue;
    float grey = (g->rgb[3 * k] + g->rgb[3 * k + 1] + g->rgb[3 * k + 2]) / 3.0f;
    count[grey >= 1.0f ? 1023 : (int)(grey * 1024.0f)]++;
    total++;
  }
  int sum = 0, low = 0, high = 0;
  for (int b = 0; b < 1024; b++) {
    sum += count[b];
    if (sum < 0.05 * total) low = b + 1;
    if (sum < 0.95 * total) high = b + 1;
  }
  w->picture_bright = (float)((high + 1) / 1024.0);
  w->picture_inverse_contrast = (float)(1024.0 / (high + 1 - low));
}

/* Below its pixels the picture says nothing of the fibres: their noise goes on
 * there, as strong as the picture's own detail is at its finest. */
static int32_t set_fibres(wood_constants *w, const scan *g, const sozai_images_1 *images,
                          const sozai_image *picture, double pixel, float ds, float dt) {
  double square = 0.0;
  int n = 0;
  for (uint32_t from = 0; from < PROBES; from += GRID / 2) {
    float s[GRID], t[GRID], fine[3 * GRID], coarse[3 * GRID];
    uint32_t m = 0;
    for (uint32_t i = from; i < from + GRID / 2; i++) {
      double u = (hash1(2 * i) + 0.5) / 4294967296.0, v = (hash1(2 * i + 1) + 0.5) / 4294967296.0;
      if (!g->wood[(int)(v * g->nz) * g->nx + (int)(u * g->nx)]) continue;
      s[m] = (float)u;
      t[m++] = (float)v;
    }
    int32_t r = look(images, picture, m, s, t, 0.0f, 0.0f, fine);
    if (!r) r = look(images, picture, m, s, t, 2.0f * ds, 2.0f * dt, coarse);
    if (r) return r;
    for (uint32_t i = 0; i < m; i++, n++) {
      double a = 0.01, b = 0.01;
      for (int c = 0; c < 3; c++) {
        a += (double)fine[3 * i + (uint32_t)c];
        b += (double)coarse[3 * i + (uint32_t)c];
      }
      square += (a / b - 1.0) * (a / b - 1.0);
    }
  }
  /* the noise's own deviation is 0.41 of its amplitude */
  double amplitude = n ? __builtin_sqrt(square / n) / 0.41 : 0.0, total = 0.0;
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    if (1.0 / (double)w->fibre_frequency[o] > 1.5 * pixel) w->fibre_scale[o] = 0.0f;
    total += (double)w->fibre_scale[o] * 2147483648.0;
  }
  double k = total > amplitude ? amplitude / total : 1.0;
  for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
    w->fibre_scale[o] = (float)((double)w->fibre_scale[o] * k);
  }
  return SOZAI_OK;
}

/* cell: mm. */
static int32_t place(wood_constants *w, sheet *h, const sozai_host *host, const settings *s,
                     double cell) {
  scan *g = &h->scan;
  double pith[2] = {number_at(s, P_SECTION_PITH_S) * g->nx, number_at(s, P_SECTION_PITH_T) * g->nz};
  int disc = scan_wood(g), found = choice_at(s, P_SECTION_PITH) == PITH_FOUND;
  if (found && !scan_pith(g, disc, pith)) {
    return fail(SOZAI_ERROR_FILE,
                "section: no pith can be found in the picture, whose stripes are too few; say "
                "where it is with section_pith = given, section_pith_s and section_pith_t");
  }
  float rim[WOOD_RIM];
  int how = choice_at(s, P_SECTION_RIM);
  const char *from = "none";
  double circle = largest_circle(g, pith);
  if (how == RIM_FOUND && disc && scan_rim(g, pith, WOOD_RIM, rim)) {
    from = "found";
    for (int k = 0; k < WOOD_RIM; k++) rim[k] = (float)((double)rim[k] * cell * MARGIN);
    fit_outline(w, rim);
  } else if (how == RIM_FOUND && circle > 0.0) {
    from = "the largest circle";
    round_rim(rim, circle * cell * MARGIN);
  } else if (how == RIM_GIVEN) {
    from = "given";
    round_rim(rim, number_at(s, P_SECTION_RADIUS));
  } else {
    how = RIM_NONE;
  }
  double mean = 0.0;
  if (how != RIM_NONE) {
    set_rim(w, rim);
    for (int k = 0; k < WOOD_RIM; k++) mean += (double)rim[k] / WOOD_RIM;
  }
  w->picture_pith[0] = (float)(pith[0] / g->nx);
  w->picture_pith[1] = (float)(pith[1] / g->nz);
  host_log(host, SOZAI_LOG_INFO, "section: pith %s at s = %.4f, t = %.4f; rim: %s, %.1f mm",
           found ? "found" : "given", (double)w->picture_pith[0], (double)w->picture_pith[1], from,
           mean);
  return SOZAI_OK;
}

int32_t section_build(wood_constants *w, const sozai_host *host, const settings *s,
                      const sozai_images_1 *images, const sozai_image *picture) {
  uint32_t width = 0, height = 0;
  int32_t r = images->resolution(images->self, picture, &width, &height);
  if (r || !width || !height) return fail(SOZAI_ERROR_FILE, "section: the picture has no size");
  double mm = number_at(s, P_SECTION_WIDTH), pixel = mm / width;
  w->picture_per_mm[0] = (float)(1.0 / mm);
  w->picture_per_mm[1] = (float)(1.0 / (pixel * height));
  w->picture_detail = (float)number_at(s, P_SECTION_DETAIL);
  w->picture_detail_size = (float)number_at(s, P_SECTION_DETAIL_SIZE);
  sheet h;
  r = sheet_open(&h, host, width, height);
  if (r) return r;
  r = sheet_fill(&h, images, picture);
  if (!r) r = place(w, &h, host, s, mm / h.scan.nx);
  if (!r) set_contrast(w, &h.scan);
  if (!r) {
    r = set_fibres(w, &h.scan, images, picture, pixel, 1.0f / (float)width, 1.0f / (float)height);
  }
  host_free(host, h.memory, h.bytes, 64);
  if (r) return r;
  w->images = images;
  w->picture = picture;
  return SOZAI_OK;
}
