/* SPDX-License-Identifier: Apache-2.0
 *
 * json_check FILE: is it one JSON value and nothing else (RFC 8259)?
 * json_check FILE PLUGIN TEXTURE: and does it hold every parameter, choice,
 * preset and channel that the plugin describes? */
#include <ctype.h>
#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "sozai.h"

#define DEEPEST 64

static const char *start, *at;

static bool wrong(const char *what) {
  printf("JSON: %s at byte %ld: %.30s\n", what, (long)(at - start), at);
  return false;
}

static void skip_space(void) {
  while (*at && strchr(" \t\r\n", *at)) at++;
}

static bool word(const char *text) {
  if (strncmp(at, text, strlen(text)) != 0) return wrong("unknown word");
  at += strlen(text);
  return true;
}

static bool string(void) {
  at++;
  while (*at != '"') {
    if ((unsigned char)*at < 0x20) return wrong("control character, or the end, in a string");
    if (*at == '\\') {
      at++;
      if (*at == 'u') {
        for (int i = 1; i <= 4; i++)
          if (!isxdigit((unsigned char)at[i])) return wrong("bad \\u");
        at += 4;
      } else if (!*at || !strchr("\"\\/bfnrt", *at))
        return wrong("bad escape");
    }
    at++;
  }
  at++;
  return true;
}

static bool digits(void) {
  if (!isdigit((unsigned char)*at)) return wrong("no digit");
  while (isdigit((unsigned char)*at)) at++;
  return true;
}

static bool number(void) {
  if (*at == '-') at++;
  if (*at == '0')
    at++;
  else if (!digits())
    return false;
  if (*at == '.') {
    at++;
    if (!digits()) return false;
  }
  if (*at == 'e' || *at == 'E') {
    at++;
    if (*at == '+' || *at == '-') at++;
    return digits();
  }
  return true;
}

static bool value(int depth);

static bool members(int depth, char end) {
  at++;
  skip_space();
  if (*at == end) return at++, true;
  for (;;) {
    skip_space();
    if (end == '}') {
      if (*at != '"') return wrong("no name");
      if (!string()) return false;
      skip_space();
      if (*at++ != ':') return wrong("no colon");
    }
    if (!value(depth)) return false;
    skip_space();
    if (*at == end) return at++, true;
    if (*at++ != ',') return wrong("no comma");
  }
}

static bool value(int depth) {
  skip_space();
  if (depth > DEEPEST) return wrong("too deep");
  switch (*at) {
  case '{':
    return members(depth + 1, '}');
  case '[':
    return members(depth + 1, ']');
  case '"':
    return string();
  case 't':
    return word("true");
  case 'f':
    return word("false");
  case 'n':
    return word("null");
  default:
    return number();
  }
}

/* How often `"key": "text"` stands in the file. */
static int occurrences(const char *key, const char *text) {
  char wanted[256];
  int length = snprintf(wanted, sizeof wanted, "\"%s\": \"%s\"", key, text), count = 0;
  for (const char *p = start; (p = strstr(p, wanted)); p += length) count++;
  return count;
}

static bool holds(const char *what, const char *id) {
  if (occurrences("id", id) > 0) return true;
  printf("%s '%s' is missing\n", what, id);
  return false;
}

static bool complete(const char *plugin, const char *texture) {
  void *library = dlopen(plugin, RTLD_NOW | RTLD_LOCAL);
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!entry || entry->init(plugin) != SOZAI_OK) return puts("no plugin"), false;
  const sozai_textures_1 *textures = entry->get_factory(SOZAI_TEXTURES_1);
  const sozai_texture_info *info = textures->find(texture);
  bool ok = info != NULL;
  int ranges = 0;
  for (uint32_t i = 0; ok && i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    ok = holds("parameter", p->id) && occurrences("unit", p->unit) > 0;
    ranges += p->kind == SOZAI_KIND_FLOAT || p->kind == SOZAI_KIND_INT ||
              p->kind == SOZAI_KIND_FLOAT3 || p->kind == SOZAI_KIND_COLOUR;
    for (uint32_t k = 0; ok && k < p->choice_count; k++) ok = holds("choice", p->choices[k]);
  }
  for (uint32_t i = 0; ok && i < info->preset_count; i++)
    ok = holds("preset", info->presets[i]->id);
  for (uint32_t i = 0; ok && i < info->channel_count; i++)
    ok = holds("channel", info->channels[i]->id);
  int found = 0;
  for (const char *p = start; (p = strstr(p, "\"hard_range\": [")); p++) found++;
  if (ok && found != ranges) ok = (printf("%d ranges, wanted %d\n", found, ranges), false);
  entry->deinit();
  dlclose(library);
  return ok;
}

int main(int argc, char **argv) {
  static char text[1 << 22];
  FILE *file = argc > 1 ? fopen(argv[1], "rb") : NULL;
  if (!file) return puts("usage: json_check FILE [PLUGIN TEXTURE]"), 1;
  size_t length = fread(text, 1, sizeof text - 1, file);
  fclose(file);
  start = at = text;
  if (strlen(text) != length) return puts("a zero byte, or too long"), 1;
  if (!value(0)) return 1;
  skip_space();
  if (*at) return wrong("something after the value"), 1;
  return argc == 4 && !complete(argv[2], argv[3]);
}
