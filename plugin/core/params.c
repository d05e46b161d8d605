/* SPDX-License-Identifier: Apache-2.0 */
#include "params.h"

#include <string.h>

#include "image_text.h"
#include "limits.h"
#include "meter.h"
#include "status.h"

#define BUFFER_MAX (1ull << 31) /* no ceiling is above it: bytes in a buffer's array */

static const char *kind_name(uint32_t kind) {
  static const char *const names[] = {"text to be read", "a float",  "an int",   "a bool",
                                      "a choice",        "a float3", "a colour", "text",
                                      "a path",          "a buffer", "an image"};
  return kind < sizeof names / sizeof names[0] ? names[kind] : "an unknown kind";
}

static int is_number(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT || kind == SOZAI_KIND_INT || kind == SOZAI_KIND_BOOL;
}

static int is_triple(uint32_t kind) {
  return kind == SOZAI_KIND_FLOAT3 || kind == SOZAI_KIND_COLOUR;
}

static int find_parameter(const sozai_texture_info *info, const char *id) {
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    if (strcmp(info->parameters[i]->id, id) == 0) return (int)i;
  }
  return -1;
}

/* A setting on its way in; everything it points to is still the host's. */
typedef struct {
  setting s;
  image_name image;
} draft;

/* ---- reading text ----------------------------------------------------- */

static const char *skip_blank(const char *s) {
  while (*s == ' ' || *s == '\t' || *s == ',') s++;
  return s;
}

static const char *word_end(const char *s) {
  while (*s && *s != ' ' && *s != '\t' && *s != ',' && *s != '@') s++;
  return s;
}

static int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/* "#rrggbb" */
static int read_hex(const char *s, double out[3]) {
  if (s[0] != '#' || strlen(s) < 7) return 0;
  for (int c = 0; c < 3; c++) {
    int hi = hex_digit(s[1 + 2 * c]), lo = hex_digit(s[2 + 2 * c]);
    if (hi < 0 || lo < 0) return 0;
    out[c] = (hi * 16 + lo) / 255.0;
  }
  return 1;
}

static int32_t unreadable(const sozai_parameter *p, const char *text, const char *wanted) {
  return fail(SOZAI_ERROR_KIND, "%s: cannot read \"%.80s\" as %s", p->id, text, wanted);
}

static int32_t read_text(const sozai_parameter *p, const char *text, sozai_value *v) {
  v->kind = p->kind;
  const char *s = skip_blank(text);
  switch (p->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT: {
    const char *e = word_end(s);
    if (!read_number(s, e, &v->number[0]) || *skip_blank(e)) {
      return unreadable(p, text, p->kind == SOZAI_KIND_INT ? "a whole number" : "a number");
    }
    return SOZAI_OK;
  }
  case SOZAI_KIND_BOOL:
    if (!strcmp(s, "true") || !strcmp(s, "1") || !strcmp(s, "on") || !strcmp(s, "yes")) {
      v->number[0] = 1.0;
    } else if (!strcmp(s, "false") || !strcmp(s, "0") || !strcmp(s, "off") || !strcmp(s, "no")) {
      v->number[0] = 0.0;
    } else {
      return unreadable(p, text, "true or false");
    }
    return SOZAI_OK;
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR: {
    v->text = NULL;
    const char *e = s;
    if (p->kind == SOZAI_KIND_COLOUR && *s == '#') {
      e = word_end(s);
      if (e - s != 7 || !read_hex(s, v->number)) return unreadable(p, text, "a colour #rrggbb");
    } else {
      for (int c = 0; c < 3; c++) {
        s = skip_blank(e);
        e = word_end(s);
        if (!read_number(s, e, &v->number[c])) return unreadable(p, text, "three numbers");
      }
    }
    s = skip_blank(e);
    if (p->kind == SOZAI_KIND_COLOUR && *s == '@') {
      s = skip_blank(s + 1);
      if (!*s) return unreadable(p, text, "a colour and its space");
      v->text = s;
    } else if (*s) {
      return unreadable(p, text, "three numbers");
    }
    return SOZAI_OK;
  }
  case SOZAI_KIND_BUFFER:
    return fail(SOZAI_ERROR_KIND, "%s: takes a buffer of the host's, not text", p->id);
  default:
    v->text = text;
    return SOZAI_OK;
  }
}

/* ---- checking --------------------------------------------------------- */

static int32_t check_range(const sozai_parameter *p, double x) {
  /* written so that NaN fails */
  if (x >= p->hard_min && x <= p->hard_max) return SOZAI_OK;
  return fail(SOZAI_ERROR_RANGE, "%s: %.12g is outside %.12g to %.12g%s%s", p->id, x, p->hard_min,
              p->hard_max, p->unit[0] ? " " : "", p->unit);
}

static int32_t check_choice(const sozai_parameter *p, const char *text, double *index) {
  for (uint32_t i = 0; i < p->choice_count; i++) {
    if (strcmp(p->choices[i], text) == 0) {
      *index = i;
      return SOZAI_OK;
    }
  }
  char list[512] = "";
  for (uint32_t i = 0; i < p->choice_count; i++) {
    size_t n = strlen(list);
    if (n + strlen(p->choices[i]) + 3 > sizeof list) break;
    if (i) strcat(list, ", ");
    strcat(list, p->choices[i]);
  }
  return fail(SOZAI_ERROR_RANGE, "%s: \"%.80s\" is none of: %s", p->id, text, list);
}

static int32_t check_count(const sozai_host *host, const sozai_parameter *p, const char *what,
                           uint64_t n, const void *data) {
  uint64_t most = limit_of(host, LIMIT_BUFFER_BYTES);
  if (n > most / 4) {
    return fail(SOZAI_ERROR_LIMIT,
                "%s: a buffer of %llu %s of 4 B each is above the ceiling buffer_bytes, %llu",
                p->id, (unsigned long long)n, what, (unsigned long long)most);
  }
  if (n && !data) return fail(SOZAI_ERROR_ARGUMENT, "%s: the buffer's %s are NULL", p->id, what);
  return SOZAI_OK;
}

static int32_t check_text(const sozai_host *host, const sozai_parameter *p, const char *text) {
  if (!text) return fail(SOZAI_ERROR_ARGUMENT, "%s: its text is NULL", p->id);
  return limit_check(host, LIMIT_TEXT_BYTES, strlen(text), p->id);
}

/* A buffer of any size, its members past that size zero. */
static sozai_buffer whole_buffer(const sozai_buffer *given) {
  sozai_buffer b;
  memset(&b, 0, sizeof b);
  memcpy(&b, given, whole_members(given->size, sizeof b, PAIR_AT(sozai_buffer, wrap)));
  return b;
}

/* Elements of a buffer's four arrays; more than BUFFER_MAX stands for any
 * product that does not fit. */
static uint64_t product(uint64_t a, uint64_t b) {
  uint64_t r;
  return __builtin_mul_overflow(a, b, &r) || r > BUFFER_MAX ? BUFFER_MAX + 1 : r;
}

static void buffer_counts(const sozai_buffer *b, uint64_t n[4]) {
  memset(n, 0, 4 * sizeof *n);
  if (b->kind == SOZAI_BUFFER_TABLE) {
    n[0] = product(b->dims[0], b->dims[1]);
  } else if (b->kind == SOZAI_BUFFER_IMAGE) {
    n[0] = product(product(b->dims[0], b->dims[1]), b->dims[2]);
    /* nothing of too much is still too much */
    if (product(b->dims[0], b->dims[1]) > BUFFER_MAX) n[0] = BUFFER_MAX + 1;
  } else {
    n[1] = product(3, b->dims[0]);
    n[2] = b->normals ? n[1] : 0;
    n[3] = b->kind == SOZAI_BUFFER_MESH ? product(3, b->dims[1]) : 0;
  }
}

static int32_t check_buffer(const sozai_host *host, const sozai_parameter *p,
                            const sozai_buffer *given) {
  if (!given) return SOZAI_OK; /* none */
  if (given->size < 8) return fail(SOZAI_ERROR_ARGUMENT, "%s: the buffer's size is not set", p->id);
  sozai_buffer b = whole_buffer(given);
  if (b.kind == SOZAI_BUFFER_IMAGE && b.wrap > SOZAI_WRAP_MIRROR) {
    return fail(SOZAI_ERROR_RANGE, "%s: wrap %u is above %u", p->id, b.wrap, SOZAI_WRAP_MIRROR);
  }
  if (b.kind != p->buffer_kind) {
    return fail(SOZAI_ERROR_KIND, "%s: takes a buffer of kind %u, not %u", p->id, p->buffer_kind,
                b.kind);
  }
  for (int i = 0; i < 3; i++) {
    if (b.dims[i] > (1u << 30)) {
      return fail(SOZAI_ERROR_LIMIT,
                  "%s: a buffer of dimension %llu is above the ceiling of any dimension, %u", p->id,
                  (unsigned long long)b.dims[i], 1u << 30);
    }
  }
  uint64_t n[4];
  buffer_counts(&b, n);
  int32_t r = check_count(host, p, "numbers", n[0], b.data);
  if (!r) r = check_count(host, p, "points", n[1], b.points);
  if (!r) r = check_count(host, p, "normals", n[2], b.normals);
  if (!r) r = check_count(host, p, "indices", n[3], b.indices);
  if (!r && b.kind == SOZAI_BUFFER_IMAGE) {
    r = limit_check(host, LIMIT_IMAGE_PIXELS, b.dims[0] * b.dims[1], p->id);
  }
  if (!r && b.colour_space) r = check_text(host, p, b.colour_space);
  if (!r && b.path) r = check_text(host, p, b.path);
  for (uint64_t i = 0; !r && i < n[3]; i++) {
    if (b.indices[i] >= b.dims[0]) {
      return fail(SOZAI_ERROR_RANGE, "%s: index %u is not below the %llu points", p->id,
                  b.indices[i], (unsigned long long)b.dims[0]);
    }
  }
  return r;
}

/* A picture: by a buffer, by a path, or by text. */
static int32_t read_image(const sozai_host *host, const sozai_parameter *p, const sozai_value *v,
                          draft *d) {
  int32_t r = SOZAI_OK;
  memset(&d->image, 0, sizeof d->image);
  if (v->kind == SOZAI_KIND_IMAGE && v->buffer) {
    r = check_buffer(host, p, v->buffer);
    if (r) return r;
    sozai_buffer b = whole_buffer(v->buffer);
    if (b.data && b.path && !b.path[0]) b.path = NULL; /* no reason to lose the picture */
    d->image = image_name_from_buffer(&b);
    if (!b.path) {
      d->image.data = v->buffer;
      if (!b.dims[0] || !b.dims[1] || !b.dims[2]) {
        r = fail(SOZAI_ERROR_RANGE, "%s: an image of %llu x %llu x %llu has no pixels", p->id,
                 (unsigned long long)b.dims[0], (unsigned long long)b.dims[1],
                 (unsigned long long)b.dims[2]);
      } else if (b.first_channel >= b.dims[2]) {
        r = fail(SOZAI_ERROR_RANGE, "%s: first_channel %u is not below the %llu channels", p->id,
                 b.first_channel, (unsigned long long)b.dims[2]);
      }
    }
  } else if (v->kind == SOZAI_KIND_IMAGE || v->kind == SOZAI_KIND_STRING) {
    r = check_text(host, p, v->text);
    if (!r && v->kind == SOZAI_KIND_IMAGE) d->image = image_name_from_path(v->text);
    if (!r && v->kind == SOZAI_KIND_STRING) r = image_name_from_text(p, v->text, &d->image);
  } else {
    r = fail(SOZAI_ERROR_KIND, "%s: takes %s, not %s", p->id, kind_name(p->kind),
             kind_name(v->kind));
  }
  return r;
}

/* One value into one setting. */
static int32_t read_value(const sozai_host *host, const sozai_parameter *p,
                          const sozai_value *given, draft *d) {
  setting *s = &d->s;
  sozai_value v = *given;
  if (p->kind == SOZAI_KIND_IMAGE) return read_image(host, p, given, d);
  if (v.kind == SOZAI_KIND_STRING) {
    int32_t r = check_text(host, p, v.text);
    if (!r) r = read_text(p, given->text, &v);
    if (r) return r;
  }
  if (v.kind == SOZAI_KIND_INT && p->kind == SOZAI_KIND_FLOAT) v.kind = SOZAI_KIND_FLOAT;
  if (v.kind != p->kind) {
    return fail(SOZAI_ERROR_KIND, "%s: takes %s, not %s", p->id, kind_name(p->kind),
                kind_name(v.kind));
  }
  int32_t r = SOZAI_OK;
  if (is_number(p->kind)) {
    r = check_range(p, v.number[0]);
    if (!r && p->kind != SOZAI_KIND_FLOAT && v.number[0] != (double)(int64_t)v.number[0]) {
      r = fail(SOZAI_ERROR_KIND, "%s: %.9g is not a whole number", p->id, v.number[0]);
    }
    s->number[0] = v.number[0];
  } else if (is_triple(p->kind)) {
    for (int c = 0; c < 3 && !r; c++) r = check_range(p, v.number[c]);
    memcpy(s->number, v.number, sizeof s->number);
    if (p->kind == SOZAI_KIND_COLOUR) s->text = v.text && v.text[0] ? v.text : p->default_text;
    if (!r && s->text) r = check_text(host, p, s->text);
  } else if (p->kind == SOZAI_KIND_BUFFER) {
    r = check_buffer(host, p, v.buffer);
    s->buffer = v.buffer;
  } else {
    r = check_text(host, p, v.text);
    if (!r && p->kind == SOZAI_KIND_CHOICE) {
      r = check_choice(p, v.text, &s->number[0]);
      if (!r) s->text = p->choices[(uint32_t)s->number[0]];
    } else {
      s->text = v.text;
    }
  }
  return r;
}

static void set_default(const sozai_parameter *p, draft *d) {
  memset(d, 0, sizeof *d);
  setting *s = &d->s;
  if (p->kind == SOZAI_KIND_IMAGE) {
    d->image = image_name_from_path(p->default_text);
    return;
  }
  memcpy(s->number, p->default_number, sizeof s->number);
  if (p->kind == SOZAI_KIND_CHOICE) {
    s->text = p->choices[(uint32_t)p->default_number[0]];
  } else {
    s->text = p->default_text;
  }
}

static int32_t read_values(const sozai_host *host, draft *list, const sozai_texture_info *info,
                           const sozai_value *values, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    if (!values[i].id) return fail(SOZAI_ERROR_ARGUMENT, "value %u has no parameter's id", i);
    int k = find_parameter(info, values[i].id);
    if (k < 0) {
      return fail(SOZAI_ERROR_UNKNOWN, "%s has no parameter \"%.80s\"", info->id, values[i].id);
    }
    if (values[i].reserved) {
      return fail(SOZAI_ERROR_ARGUMENT, "%s: the value's `reserved` is %u, not 0", values[i].id,
                  values[i].reserved);
    }
    int32_t r = read_value(host, info->parameters[k], &values[i], &list[k]);
    if (r) return r;
  }
  return SOZAI_OK;
}

/* ---- copying ---------------------------------------------------------- */

static size_t round_up(size_t n) { return (n + 15) & ~(size_t)15; }

/* Of a buffer's arrays alone. */
static size_t array_bytes(const sozai_buffer *given) {
  if (!given) return 0;
  sozai_buffer b = whole_buffer(given);
  uint64_t c[4];
  size_t n = 0;
  buffer_counts(&b, c);
  for (int i = 0; i < 4; i++) n += round_up((size_t)c[i] * 4);
  return n;
}

static size_t copied_bytes(const draft *d) {
  const setting *s = &d->s;
  size_t n = 0;
  if (s->text) n += round_up(strlen(s->text) + 1);
  if (s->buffer) {
    sozai_buffer b = whole_buffer(s->buffer);
    n += round_up(sizeof(sozai_buffer));
    if (b.colour_space) n += round_up(strlen(b.colour_space) + 1);
  }
  if (image_name_given(&d->image)) {
    n += round_up(sizeof(sozai_buffer));
    if (d->image.path.at) n += round_up(d->image.path.length + 1);
    if (d->image.space.at) n += round_up(d->image.space.length + 1);
  }
  return n;
}

static void *copy_into(char **at, const void *from, size_t bytes) {
  if (!from) return NULL;
  void *to = *at;
  if (bytes) memcpy(to, from, bytes);
  *at += round_up(bytes);
  return to;
}

/* lend: in a rehearsal arrays stay the host's. */
static const void *copy_array(char **at, const void *from, uint64_t count, int lend) {
  if (!count) return NULL;
  return lend ? from : copy_into(at, from, (size_t)count * 4);
}

static void copy_owned(setting *s, char **at, int lend) {
  if (s->text) s->text = copy_into(at, s->text, strlen(s->text) + 1);
  if (s->buffer) {
    sozai_buffer b = whole_buffer(s->buffer);
    b.size = sizeof b;
    sozai_buffer *own = copy_into(at, &b, sizeof b);
    uint64_t c[4];
    buffer_counts(&b, c);
    own->data = copy_array(at, b.data, c[0], lend);
    own->points = copy_array(at, b.points, c[1], lend);
    own->normals = copy_array(at, b.normals, c[2], lend);
    own->indices = copy_array(at, b.indices, c[3], lend);
    own->path = NULL; /* a buffer is memory; a file is an IMAGE */
    if (b.colour_space) {
      own->colour_space = copy_into(at, b.colour_space, strlen(b.colour_space) + 1);
    }
    s->buffer = own;
  }
}

/* Room is zeroed: what is copied without its zero gets one. */
static const char *copy_piece(char **at, piece p) {
  if (!p.at) return NULL;
  char *to = *at;
  memcpy(to, p.at, p.length);
  *at += round_up(p.length + 1);
  return to;
}

/* A picture's name as a buffer of our own; the text of the setting is its path. */
static void copy_image(setting *s, const image_name *n, char **at, int lend) {
  sozai_buffer b;
  memset(&b, 0, sizeof b);
  if (n->data) b = whole_buffer(n->data);
  b.size = sizeof b;
  b.kind = SOZAI_BUFFER_IMAGE;
  b.wrap = n->wrap;
  b.first_channel = n->first_channel;
  sozai_buffer *own = copy_into(at, &b, sizeof b);
  own->path = copy_piece(at, n->path);
  own->colour_space = copy_piece(at, n->space);
  if (n->data) {
    uint64_t c[4];
    buffer_counts(&b, c);
    own->data = copy_array(at, b.data, c[0], lend);
  }
  s->buffer = own;
  s->text = own->path;
}

/* ---- settings --------------------------------------------------------- */

static int32_t read_all(const sozai_host *host, draft *list, const sozai_texture_info *info,
                        const char *preset, const sozai_value *values, uint32_t value_count) {
  for (uint32_t i = 0; i < info->parameter_count; i++) set_default(info->parameters[i], &list[i]);
  if (preset) {
    uint32_t k = 0;
    while (k < info->preset_count && strcmp(info->presets[k]->id, preset) != 0) k++;
    if (k == info->preset_count) {
      return fail(SOZAI_ERROR_UNKNOWN, "%s has no preset \"%.80s\"", info->id, preset);
    }
    int32_t r =
        read_values(host, list, info, info->presets[k]->values, info->presets[k]->value_count);
    if (r) return r;
  }
  return read_values(host, list, info, values, value_count);
}

int32_t settings_make(settings *out, const sozai_host *host, const sozai_texture_info *info,
                      const char *preset, const sozai_value *values, uint32_t value_count) {
  memset(out, 0, sizeof *out);
  if (value_count && !values) return fail(SOZAI_ERROR_ARGUMENT, "values is NULL");
  int32_t r = limit_check(host, LIMIT_VALUES, value_count, "values");
  if (r) return r;
  uint32_t n = info->parameter_count;
  size_t scratch_bytes = n * sizeof(draft), list_bytes = n * sizeof(setting);
  draft *scratch = host_alloc(host, scratch_bytes, 64);
  if (!scratch) return SOZAI_ERROR_MEMORY;
  r = read_all(host, scratch, info, preset, values, value_count);
  if (r == SOZAI_OK) {
    int lend = host_rehearses(host);
    size_t bytes = round_up(list_bytes), arrays = 0;
    for (uint32_t i = 0; i < n; i++) {
      bytes += copied_bytes(&scratch[i]);
      arrays += array_bytes(scratch[i].s.buffer) + array_bytes(scratch[i].image.data);
    }
    if (!lend) bytes += arrays;
    setting *list = lend && host_claim(host, arrays) ? NULL : host_alloc(host, bytes, 64);
    if (list) {
      char *at = (char *)list + round_up(list_bytes);
      for (uint32_t i = 0; i < n; i++) {
        list[i] = scratch[i].s;
        copy_owned(&list[i], &at, lend);
        if (image_name_given(&scratch[i].image)) {
          copy_image(&list[i], &scratch[i].image, &at, lend);
        } else if (info->parameters[i]->kind == SOZAI_KIND_IMAGE) {
          list[i].text = "";
        }
      }
      out->list = list;
      out->bytes = bytes;
      out->count = n;
    } else {
      r = SOZAI_ERROR_MEMORY;
    }
  }
  host_free(host, scratch, scratch_bytes, 64);
  return r;
}

void settings_free(settings *s, const sozai_host *host) {
  host_free(host, s->list, s->bytes, 64);
  memset(s, 0, sizeof *s);
}

int32_t settings_value(const settings *s, const sozai_texture_info *info, const char *id,
                       sozai_value *out) {
  int k = find_parameter(info, id);
  if (k < 0) return fail(SOZAI_ERROR_UNKNOWN, "%s has no parameter \"%.80s\"", info->id, id);
  memset(out, 0, sizeof *out);
  out->id = info->parameters[k]->id;
  out->kind = info->parameters[k]->kind;
  memcpy(out->number, s->list[k].number, sizeof out->number);
  out->text = s->list[k].text;
  out->buffer = s->list[k].buffer;
  return SOZAI_OK;
}
