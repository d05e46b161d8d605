/* SPDX-License-Identifier: Apache-2.0 */
#include "texture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Which file a parameter's text names: to know when it has changed. Text that
 * names none, or is no path, has no stamp. */
static void write_stamp(FILE *to, const char *text) {
  const char *options = strstr(text, " @ ");
  for (const char *later = options; later; later = strstr(later + 1, " @ ")) options = later;
  char *path = options ? strndup(text, (size_t)(options - text)) : strdup(text);
  struct stat s;
  if (path && *path && stat(path, &s) == 0 && S_ISREG(s.st_mode))
    fprintf(to, "%llu %llu %lld %lld.%09ld\n", (unsigned long long)s.st_dev,
            (unsigned long long)s.st_ino, (long long)s.st_size, (long long)s.st_mtim.tv_sec,
            s.st_mtim.tv_nsec);
  free(path);
}

/* Everything that create() is handed. Lengths, since a text may hold anything. */
static void write_text(FILE *to, const char *text) {
  fprintf(to, "%zu:%s\n", text ? strlen(text) : 0, text ? text : "");
}

static char *make_key(const recipe *r) {
  char *key = NULL;
  size_t size;
  FILE *to = open_memstream(&key, &size);
  if (!to) return NULL;
  fputs("texture\n", to);
  write_text(to, r->material);
  fputs(r->preset ? "preset " : "none ", to);
  write_text(to, r->preset);
  for (size_t i = 0; i < r->param_count; i++) {
    write_text(to, r->params[i].id);
    write_text(to, r->params[i].text);
    write_stamp(to, r->params[i].text);
  }
  bool ok = !ferror(to);
  if (fclose(to) != 0 || !ok) {
    free(key);
    return NULL;
  }
  return key;
}

static void destroy(void *texture) {
  failure ignored;
  const library *l = library_get(&ignored); /* open, or there would be no texture */
  if (l) l->plugin.textures->destroy(texture);
}

shared *texture_use(recipe *r, const library *l, failure *why) {
  const sozai_textures_1 *t = l->plugin.textures;
  if (!recipe_settle(r, t, why)) return NULL;
  char *key = make_key(r);
  shared *use = key ? shared_find(key) : NULL;
  sozai_texture *texture = NULL;
  if (!key)
    fail(why, EXIT_FAILURE, "out of memory");
  else if (!use && recipe_create(r, t, &l->host.abi, &texture, why)) {
    use = shared_add(key, texture, t->bytes(texture), destroy);
    if (!use) fail(why, EXIT_FAILURE, "out of memory");
  }
  free(key);
  return use;
}
