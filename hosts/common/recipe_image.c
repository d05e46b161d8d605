/* SPDX-License-Identifier: Apache-2.0 */
#include "recipe_image.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "numbers.h"

static size_t read_sizes(const char *text, double *out, size_t most, double low, double high) {
  size_t count = numbers_read(text, 'x', out, most);
  if (count == 0) count = numbers_read(text, ',', out, most);
  for (size_t i = 0; i < count; i++)
    if (!(out[i] >= low && out[i] <= high)) return 0;
  return count;
}

static bool set_resolution(recipe_image *image, const char *text, failure *why) {
  double read[3] = {0};
  size_t count = read_sizes(text, read, 3, 1, RECIPE_MOST_PIXELS);
  if (count == 0)
    return fail(why, EXIT_BAD_INPUT, "resolution: '%.80s' is not 1 to 3 whole numbers from 1 to %d",
                text, RECIPE_MOST_PIXELS);
  for (size_t i = 0; i < count; i++)
    if (read[i] != (double)(int)read[i])
      return fail(why, EXIT_BAD_INPUT, "resolution: '%.80s' must be whole numbers", text);
  memcpy(image->resolution, read, sizeof read);
  return true;
}

static bool set_size(recipe_image *image, const char *text, failure *why) {
  double read[3] = {0};
  size_t count = read_sizes(text, read, 3, 1e-3, 1e6);
  if (count == 0)
    return fail(why, EXIT_BAD_INPUT, "size: '%.80s' is not 1 to 3 numbers from 0.001 to 1e+06 (mm)",
                text);
  if (count == 1) read[1] = read[0];
  memcpy(image->size, read, sizeof read);
  return true;
}

static bool set_choice(int *out, const char *key, const char *text, const char *choices,
                       failure *why) {
  size_t length = strlen(text);
  int index = 0;
  for (const char *at = choices; length > 0 && *at; index++) {
    size_t end = strcspn(at, ",");
    if (end == length && strncmp(at, text, length) == 0) {
      *out = index;
      return true;
    }
    at += end;
    at += strspn(at, ", ");
  }
  return fail(why, EXIT_BAD_INPUT, "%s: unknown choice '%.40s'; there is %s", key, text, choices);
}

static bool set_wrap(recipe_image *image, const char *text, failure *why) {
  int chosen;
  if (!set_choice(&chosen, "wrap", text, "black, clamp, periodic, mirror", why)) return false;
  image->wrap = RECIPE_WRAP_BLACK + chosen;
  return true;
}

static bool set_outputs(recipe_image *image, const char *text, failure *why) {
  if (!*text) return fail(why, EXIT_BAD_INPUT, "outputs is empty");
  char *copy = strdup(text);
  if (!copy) return fail(why, EXIT_FAILURE, "out of memory");
  free(image->outputs);
  image->outputs = copy;
  return true;
}

static bool set_udim(recipe_image *image, const char *text, failure *why) {
  double number;
  if (!number_read(text, &number) || !(number >= 1001 && number <= 9999) ||
      number != (double)(int)number)
    return fail(why, EXIT_BAD_INPUT, "udim: '%.40s' is not a whole number from 1001 to 9999", text);
  image->udim = (int)number;
  return true;
}

static bool set_samples(recipe_image *image, const char *text, failure *why) {
  int chosen;
  if (!set_choice(&chosen, "samples", text, "1, 2, 4, 8", why)) return false;
  image->samples = 1 << chosen;
  return true;
}

static bool set_format(recipe_image *image, const char *text, failure *why) {
  return set_choice(&image->format, "format", text, "auto, half, float", why);
}

static bool set_normals(recipe_image *image, const char *text, failure *why) {
  return set_choice(&image->normals, "normals", text, "object, tangent", why);
}

static bool set_subimages(recipe_image *image, const char *text, failure *why) {
  return set_choice(&image->subimages, "subimages", text, "separate, single", why);
}

static const struct {
  const char *name;
  bool (*set)(recipe_image *image, const char *text, failure *why);
} keys[] = {{"resolution", set_resolution},
            {"size", set_size},
            {"format", set_format},
            {"wrap", set_wrap},
            {"outputs", set_outputs},
            {"normals", set_normals},
            {"udim", set_udim},
            {"samples", set_samples},
            {"subimages", set_subimages}};
#define KEYS (sizeof keys / sizeof keys[0])

int recipe_image_key(const char *name) {
  for (size_t key = 0; key < KEYS; key++)
    if (strcmp(keys[key].name, name) == 0) return (int)key;
  return -1;
}

void recipe_image_keys(char *text, size_t size) {
  size_t used = 0;
  *text = '\0';
  for (size_t key = 0; key < KEYS && used < size; key++)
    used += (size_t)snprintf(text + used, size - used, "%s%s", key ? ", " : "", keys[key].name);
}

bool recipe_image_set(recipe_image *image, int key, const char *text, failure *why) {
  return keys[key].set(image, text, why);
}

void recipe_image_free(recipe_image *image) {
  free(image->outputs);
  memset(image, 0, sizeof *image);
}
