/* SPDX-License-Identifier: Apache-2.0 */
#include "surface.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "atlas.h"
#include "shared.h"

#define USUAL_SIZE 1000.0  /* mm */
#define USUAL_PIXELS 4096u /* the longer side */

struct surface {
  surface_shape shape;
  double height;     /* z of a plane, mm */
  shared *atlas_use; /* of a mesh, else NULL */
  const atlas *atlas;
};

/* ---- opening ---------------------------------------------------------- */

/* What stands before a complaint: the file's name. */
static bool refuse(const recipe *r, failure *why, const char *text) {
  return fail(why, EXIT_BAD_INPUT, "%s%s%s", r->file ? r->file : "", r->file ? ": " : "", text);
}

static bool set_size(surface *s, const recipe *r, failure *why) {
  const recipe_surface *asked = &r->surface;
  const double *image = r->image.size;
  double *size = s->shape.size;
  bool board = asked->shape == RECIPE_BOARD;
  bool volume = s->shape.kind == SURFACE_VOLUME;
  for (int c = 0; c < 3; c++) {
    double usual = asked->size[c] > 0             ? asked->size[c]
                   : c == 1 && asked->size[0] > 0 ? asked->size[0]
                   : c == 2 && !volume            ? 0
                                                  : USUAL_SIZE;
    if (c == 2 && volume && asked->size[2] <= 0) usual = fmin(size[0], size[1]);
    size[c] = image[c] > 0 ? image[c] : usual;
    if (board && asked->size[c] > 0 && size[c] > asked->size[c])
      return refuse(r, why, "image: size is larger than the board's");
  }
  if (!volume) {
    s->height = board ? 0.5 * asked->size[2] : 0;
    size[2] = 0;
  }
  return true;
}

static uint32_t in_proportion(double pixels, double side, double of) {
  double n = floor(pixels * side / of + 0.5);
  return n < 1 ? 1 : n > RECIPE_MOST_PIXELS ? RECIPE_MOST_PIXELS : (uint32_t)n;
}

/* Texels are square where only one number is said. */
static void set_pixels(surface *s, const recipe *r) {
  const double *asked = r->image.resolution, *size = s->shape.size;
  uint32_t *pixels = s->shape.pixels;
  bool flat = s->shape.kind != SURFACE_VOLUME;
  if (asked[1] > 0)
    for (int c = 0; c < 3; c++) pixels[c] = asked[c] > 0 ? (uint32_t)asked[c] : 1;
  else {
    double longer = asked[0] > 0 ? asked[0] : USUAL_PIXELS;
    double side = fmax(fmax(size[0], size[1]), size[2]);
    for (int c = 0; c < 3; c++)
      pixels[c] = side > 0 ? in_proportion(longer, size[c], side) : (uint32_t)longer;
  }
  if (flat) pixels[2] = 1;
}

static void destroy_atlas(void *a) { atlas_close(a); }

/* The same for all pictures of one mesh, until its file changes. */
static bool use_atlas(surface *s, const char *path, double scale, failure *why) {
  char key[4200];
  struct stat file = {0};
  if (stat(path, &file) != 0)
    return fail(why, EXIT_BAD_INPUT, "cannot read mesh %s: %s", path, strerror(errno));
  int length =
      snprintf(key, sizeof key, "atlas %.17g %llu %llu %lld %lld.%09ld %s", scale,
               (unsigned long long)file.st_dev, (unsigned long long)file.st_ino,
               (long long)file.st_size, (long long)file.st_mtim.tv_sec, file.st_mtim.tv_nsec, path);
  bool fits = length > 0 && (size_t)length < sizeof key;
  if (!fits) return fail(why, EXIT_BAD_INPUT, "mesh: a path too long");
  s->atlas_use = shared_find(key);
  atlas *made = NULL;
  if (!s->atlas_use && atlas_open(&made, path, scale, why)) {
    s->atlas_use = shared_add(key, made, atlas_counts_of(made)->bytes, destroy_atlas);
    if (!s->atlas_use) fail(why, EXIT_FAILURE, "out of memory");
  }
  if (!s->atlas_use) return false;
  s->atlas = shared_object(s->atlas_use);
  return true;
}

static bool open_mesh(surface *s, const recipe *r, failure *why) {
  if (r->image.size[0] > 0)
    return refuse(r, why, "image: size is not for a mesh, whose UVs say what is shown");
  if (!use_atlas(s, r->surface.mesh, r->surface.scale > 0 ? r->surface.scale : 1, why)) {
    char text[sizeof why->text];
    memcpy(text, why->text, sizeof text);
    return fail(why, why->exit_code, "%s: %s", r->file ? r->file : "mesh", text);
  }
  s->shape.udim = r->image.udim ? r->image.udim : atlas_udim(s->atlas, 0);
  for (uint32_t k = 0; k < atlas_udim_count(s->atlas); k++)
    if (atlas_udim(s->atlas, k) == s->shape.udim) return true;
  return fail(why, EXIT_BAD_INPUT,
              "%s: image: udim %d is not among the mesh's tiles; the first is %d",
              r->file ? r->file : "mesh", s->shape.udim, atlas_udim(s->atlas, 0));
}

/* Whether a plane's picture may be made to fit itself. A ragged line through stones and joints
 * would tear them, and each is cut from a place of its own, so that no width fits. */
static bool check_seamless(const recipe *r, const sozai_textures_1 *textures,
                           const sozai_texture *texture, failure *why) {
  const char *begin = r->file ? r->file : "image", *mark = r->file ? ": image: " : ": ";
  if (!periodic_fits(r->material))
    return fail(why, EXIT_BAD_INPUT,
                "%s%swrap: periodic is not for %s, of which no piece fits itself; there is black, "
                "clamp, mirror",
                begin, mark, r->material);
  sozai_value layout = {.text = NULL};
  bool laid = textures->value(texture, "layout", &layout) == SOZAI_OK && layout.text &&
              strcmp(layout.text, "none") != 0;
  return !laid || fail(why, EXIT_BAD_INPUT,
                       "%s%swrap: periodic is not for stones in a layout ('%s'): the seam would "
                       "tear them; there is layout: none, or black, clamp, mirror",
                       begin, mark, layout.text);
}

static double number_of(const sozai_textures_1 *textures, const sozai_texture *texture,
                        const char *id) {
  sozai_value v = {.number = {0}};
  return textures->value(texture, id, &v) == SOZAI_OK ? v.number[0] : 0;
}

static bool is_text(const sozai_textures_1 *textures, const sozai_texture *texture, const char *id,
                    const char *text) {
  sozai_value v = {.text = NULL};
  return textures->value(texture, id, &v) == SOZAI_OK && v.text && strcmp(v.text, text) == 0;
}

/* mm, of the paper's tile of stones (plugin/stone/paper_tile.c), which repeats by itself. */
static bool paper_tile(const sozai_textures_1 *textures, const sozai_texture *texture,
                       double tile[2]) {
  sozai_value pattern = {.text = NULL};
  if (textures->value(texture, "paper_pattern", &pattern) != SOZAI_OK || !pattern.text ||
      strcmp(pattern.text, "none") == 0 || is_text(textures, texture, "colour_mode", "fabric"))
    return false;
  double texel = number_of(textures, texture, "paper_texel");
  tile[0] = texel * number_of(textures, texture, "paper_length");
  tile[1] = texel * number_of(textures, texture, "paper_width");
  if (strcmp(pattern.text, "igeta") == 0) tile[0] *= 2;
  if (strcmp(pattern.text, "cut") != 0) tile[1] *= 2;
  return tile[0] > 0 && tile[1] > 0;
}

#define TILE_ERROR 1e-4 /* of a tile: what numbers in a text leave */

/* Stones of a part of a tile would be torn as those of a layout are. */
static bool check_tiles(const surface *s, const recipe *r, const sozai_textures_1 *textures,
                        const sozai_texture *texture, failure *why) {
  double tile[2], fits[2];
  if (!paper_tile(textures, texture, tile)) return true;
  bool whole = true;
  for (int k = 0; k < 2; k++) {
    double count = s->shape.size[k] / tile[k];
    fits[k] = fmax(1, round(count)) * tile[k];
    whole = whole && fabs(s->shape.size[k] - fits[k]) <= TILE_ERROR * tile[k];
  }
  return whole ||
         fail(why, EXIT_BAD_INPUT,
              "%s%swrap: periodic: %.9g x %.9g mm is no whole number of the paper's tiles of %.9g "
              "x %.9g mm (paper_pattern); %.9g x %.9g mm would be",
              r->file ? r->file : "image", r->file ? ": image: " : ": ", s->shape.size[0],
              s->shape.size[1], tile[0], tile[1], fits[0], fits[1]);
}

static bool check(const surface *s, const recipe *r, failure *why) {
  const recipe_image *i = &r->image;
  int kind = s->shape.kind;
  if (kind == SURFACE_MESH && i->normals == RECIPE_NORMALS_TANGENT)
    return refuse(r, why, "image: normals: tangent is not for a mesh; there is object");
  if (kind == SURFACE_VOLUME && i->normals == RECIPE_NORMALS_TANGENT)
    return refuse(r, why, "image: normals: tangent is not for a volume, which has none");
  if (kind == SURFACE_VOLUME && r->surface.shape == RECIPE_MESH)
    return refuse(r, why, "image: three numbers make a volume, which a mesh is not");
  if (kind != SURFACE_MESH && i->udim) return refuse(r, why, "image: udim is for a mesh alone");
  if (kind == SURFACE_VOLUME && i->samples > 1)
    return refuse(r, why, "image: samples is not for a volume");
  if (i->wrap == RECIPE_WRAP_PERIODIC &&
      (kind != SURFACE_PLANE || r->surface.shape == RECIPE_BOARD))
    return refuse(r, why, "image: wrap: periodic is for a plane alone");
  return true;
}

static uint32_t count_levels(const surface_shape *shape) {
  if (shape->kind == SURFACE_VOLUME) return 1;
  uint32_t side = shape->pixels[0] > shape->pixels[1] ? shape->pixels[0] : shape->pixels[1];
  uint32_t levels = 1;
  while (side >> levels) levels++;
  return levels;
}

bool surface_open(surface **out, const recipe *r, const sozai_textures_1 *textures,
                  const sozai_texture *texture, failure *why) {
  *out = NULL;
  surface *s = calloc(1, sizeof *s);
  if (!s) return fail(why, EXIT_FAILURE, "out of memory");
  bool volume = r->image.resolution[2] > 0 || r->image.size[2] > 0;
  s->shape.kind = volume                            ? SURFACE_VOLUME
                  : r->surface.shape == RECIPE_MESH ? SURFACE_MESH
                                                    : SURFACE_PLANE;
  bool seamless = r->image.wrap == RECIPE_WRAP_PERIODIC;
  bool ok = check(s, r, why) && (!seamless || check_seamless(r, textures, texture, why)) &&
            (s->shape.kind == SURFACE_MESH ? open_mesh(s, r, why) : set_size(s, r, why)) &&
            (!seamless || check_tiles(s, r, textures, texture, why));
  if (!ok) {
    surface_close(s);
    return false;
  }
  set_pixels(s, r);
  s->shape.seamless = seamless;
  if (s->shape.seamless) s->shape.repeat = periodic_make(s->shape.size);
  s->shape.levels = count_levels(&s->shape);
  s->shape.samples = r->image.samples > 1 ? (uint32_t)r->image.samples : 1;
  *out = s;
  return true;
}

void surface_close(surface *s) {
  if (!s) return;
  shared_release(s->atlas_use);
  free(s);
}

/* ---- reading ---------------------------------------------------------- */

const surface_shape *surface_shape_of(const surface *s) { return &s->shape; }
const atlas *surface_atlas(const surface *s) { return s->atlas; }

void surface_level(const surface *s, uint32_t level, uint32_t pixels[3]) {
  for (int c = 0; c < 3; c++) {
    pixels[c] = level < 32 ? s->shape.pixels[c] >> level : 0;
    if (pixels[c] == 0) pixels[c] = 1;
  }
}

static void fill(float *to, size_t count, float value) {
  if (!to) return;
  for (size_t i = 0; i < count; i++) to[i] = value;
}

/* The middle of texel i of n over size mm about the origin. */
static float middle(uint32_t i, uint32_t n, double size) {
  return (float)((((double)i + 0.5) / n - 0.5) * size);
}

static void grid_texels(const surface *s, const uint32_t pixels[3], uint32_t x, uint32_t y,
                        uint32_t z, uint32_t w, uint32_t h, const surface_room *out) {
  const double *size = s->shape.size;
  bool volume = s->shape.kind == SURFACE_VOLUME;
  size_t count = (size_t)w * h;
  float *px = out->point[0], *py = out->point[1];
  for (uint32_t i = 0; px && i < w; i++) px[i] = middle(x + i, pixels[0], size[0]);
  for (uint32_t j = 0; j < h; j++) {
    float up = middle(y + j, pixels[1], size[1]);
    if (px && j > 0) memcpy(px + (size_t)j * w, px, w * sizeof *px);
    fill(py ? py + (size_t)j * w : NULL, w, volume ? up : -up);
  }
  fill(out->point[2], count, volume ? middle(z, pixels[2], size[2]) : (float)s->height);
  for (int c = 0; c < 3 && !volume; c++) fill(out->normal[c], count, c == 2 ? 1.0f : 0.0f);
  double wide = size[0] / pixels[0], high = size[1] / pixels[1];
  double footprint = volume ? cbrt(wide * high * size[2] / pixels[2]) : sqrt(wide * high);
  fill(out->footprint, count, (float)footprint);
  for (int c = 0; c < 3; c++) {
    fill(out->across[c], count, c == 0 ? (float)wide : 0.0f);
    fill(out->down[c], count, c == 1 ? (float)(volume ? high : -high) : 0.0f);
  }
  if (out->covered) memset(out->covered, 1, count);
}

bool surface_texels(const surface *s, uint32_t level, uint32_t x, uint32_t y, uint32_t z,
                    uint32_t w, uint32_t h, const surface_room *out) {
  uint32_t pixels[3];
  surface_level(s, level, pixels);
  if (level >= s->shape.levels || x > pixels[0] || w > pixels[0] - x || y > pixels[1] ||
      h > pixels[1] - y || z >= pixels[2])
    return false;
  if (s->shape.kind == SURFACE_MESH)
    return atlas_texels(s->atlas, s->shape.udim, pixels[0], pixels[1], x, y, w, h, out);
  grid_texels(s, pixels, x, y, z, w, h, out);
  return true;
}
