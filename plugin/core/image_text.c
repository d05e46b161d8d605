/* SPDX-License-Identifier: Apache-2.0 */
#include "image_text.h"

#include <string.h>

#include "status.h"

static piece whole(const char *text) {
  piece p = {text, text ? strlen(text) : 0};
  return p;
}

static piece trimmed(const char *from, const char *end) {
  while (from < end && (*from == ' ' || *from == '\t')) from++;
  while (from < end && (end[-1] == ' ' || end[-1] == '\t')) end--;
  piece p = {from, (size_t)(end - from)};
  return p;
}

static int is(piece p, const char *word) {
  return p.length == strlen(word) && memcmp(p.at, word, p.length) == 0;
}

static int starts(piece p, const char *word) {
  return p.length >= strlen(word) && memcmp(p.at, word, strlen(word)) == 0;
}

static int32_t read_wrap(const sozai_parameter *p, piece value, uint32_t *out) {
  static const char *const names[] = {"default", "black", "clamp", "periodic", "mirror"};
  for (uint32_t i = 0; i < sizeof names / sizeof *names; i++) {
    if (is(value, names[i])) {
      *out = i;
      return SOZAI_OK;
    }
  }
  return fail(SOZAI_ERROR_RANGE,
              "%s: wrap \"%.*s\" is none of: default, black, clamp, periodic, mirror", p->id,
              value.length < 40 ? (int)value.length : 40, value.at);
}

static int32_t read_option(const sozai_parameter *p, piece o, image_name *out) {
  const char *end = o.at + o.length;
  if (starts(o, "wrap=")) return read_wrap(p, trimmed(o.at + 5, end), &out->wrap);
  if (starts(o, "channel=")) {
    double n;
    piece value = trimmed(o.at + 8, end);
    if (!read_number(value.at, value.at + value.length, &n) || !(n >= 0 && n <= 1023) ||
        n != (double)(uint32_t)n) {
      return fail(SOZAI_ERROR_RANGE, "%s: channel \"%.*s\" is no whole number from 0 to 1023",
                  p->id, value.length < 40 ? (int)value.length : 40, value.at);
    }
    out->first_channel = (uint32_t)n;
    return SOZAI_OK;
  }
  if (!o.length) return SOZAI_OK;
  if (out->space.at) {
    return fail(SOZAI_ERROR_KIND,
                "%s: \"%.*s\" after a colour space is neither wrap=... nor channel=...", p->id,
                o.length < 80 ? (int)o.length : 80, o.at);
  }
  out->space = o;
  return SOZAI_OK;
}

int32_t image_name_from_text(const sozai_parameter *p, const char *text, image_name *out) {
  memset(out, 0, sizeof *out);
  out->path = whole(text);
  const char *options = NULL;
  for (const char *s = strstr(text, " @ "); s; s = strstr(s + 1, " @ ")) options = s;
  if (!options) return SOZAI_OK;
  out->path = trimmed(text, options);
  for (const char *s = options + 3; s;) {
    const char *comma = strchr(s, ',');
    int32_t r = read_option(p, trimmed(s, comma ? comma : s + strlen(s)), out);
    if (r) return r;
    s = comma ? comma + 1 : NULL;
  }
  return SOZAI_OK;
}

image_name image_name_from_buffer(const sozai_buffer *b) {
  image_name n = {whole(b->path), whole(b->colour_space), b->wrap, b->first_channel,
                  b->path ? NULL : b};
  return n;
}

image_name image_name_from_path(const char *path) {
  image_name n = {whole(path), {NULL, 0}, SOZAI_WRAP_DEFAULT, 0, NULL};
  return n;
}

int image_name_given(const image_name *n) { return n->data || n->path.length; }
