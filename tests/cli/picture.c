/* SPDX-License-Identifier: Apache-2.0
 *
 * Questions about a picture's file:
 *   picture layers FILE                        prints width, height, channels' names sorted
 *   picture finite FILE                        is every number finite?
 *   picture between FILE X Y CHANNEL LOW HIGH  is that pixel's number, inclusive?
 *   picture same FILE FILE                     the same channels and bits?
 *   picture varies FILE                        is it not of one brightness? */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "image.h"

static int by_name(const void *a, const void *b) {
  return strcmp(*(char *const *)a, *(char *const *)b);
}

static size_t floats(const image *p) { return (size_t)p->width * p->height * p->channels; }

static int layers(const image *p) {
  char **sorted = malloc(p->channels * sizeof *sorted);
  if (!sorted) return 1;
  memcpy(sorted, p->names, p->channels * sizeof *sorted);
  qsort(sorted, p->channels, sizeof *sorted, by_name);
  printf("%u %u", p->width, p->height);
  for (uint32_t c = 0; c < p->channels; c++) printf(" %s", sorted[c]);
  putchar('\n');
  free(sorted);
  return 0;
}

static int all_finite(const image *p) {
  for (size_t i = 0; i < floats(p); i++)
    if (!isfinite(p->data[i])) {
      printf("channel %s: %g\n", p->names[i % p->channels], (double)p->data[i]);
      return 1;
    }
  return 0;
}

static int between(const image *p, char **argv) {
  uint32_t x = (uint32_t)atoi(argv[0]), y = (uint32_t)atoi(argv[1]), c = 0;
  while (c < p->channels && strcmp(p->names[c], argv[2]) != 0) c++;
  if (x >= p->width || y >= p->height || c == p->channels) {
    printf("no pixel %s %s, or no channel %s\n", argv[0], argv[1], argv[2]);
    return 1;
  }
  double got = (double)p->data[((size_t)y * p->width + x) * p->channels + c];
  if (got >= atof(argv[3]) && got <= atof(argv[4])) return 0;
  printf("%s at %u %u is %g, wanted %s to %s\n", argv[2], x, y, got, argv[3], argv[4]);
  return 1;
}

static int same(const image *p, const char *other) {
  image q;
  failure why;
  if (!image_read(&q, other, &why)) {
    puts(why.text);
    return 1;
  }
  bool equal = p->width == q.width && p->height == q.height && p->channels == q.channels;
  for (uint32_t c = 0; equal && c < p->channels; c++) equal = strcmp(p->names[c], q.names[c]) == 0;
  equal = equal && memcmp(p->data, q.data, floats(p) * sizeof *p->data) == 0;
  image_free(&q);
  return equal ? 0 : 1;
}

/* By a fiftieth of its mean at least, sd over mean. */
static int varies(const image *p) {
  double sum = 0, square = 0, n = (double)floats(p);
  for (size_t i = 0; i < floats(p); i++) {
    sum += (double)p->data[i];
    square += (double)p->data[i] * (double)p->data[i];
  }
  double mean = sum / n, sd = sqrt(fmax(square / n - mean * mean, 0));
  if (sd > 0.02 * mean) return 0;
  printf("mean %g, sd %g\n", mean, sd);
  return 1;
}

int main(int argc, char **argv) {
  image p;
  failure why;
  if (argc < 3 || !image_read(&p, argv[2], &why)) {
    puts(argc < 3 ? "usage: see picture.c" : why.text);
    return 1;
  }
  int result = 1;
  if (strcmp(argv[1], "layers") == 0) result = layers(&p);
  if (strcmp(argv[1], "finite") == 0) result = all_finite(&p);
  if (strcmp(argv[1], "between") == 0 && argc == 8) result = between(&p, argv + 3);
  if (strcmp(argv[1], "same") == 0 && argc == 4) result = same(&p, argv[3]);
  if (strcmp(argv[1], "varies") == 0) result = varies(&p);
  image_free(&p);
  return result;
}
