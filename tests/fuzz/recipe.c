/* SPDX-License-Identifier: Apache-2.0
 * A .sozai file and the query behind its name. The input's pieces: the query, the file, and
 * two that it may include, b.sozai and c.sozai. */
#include "fuzz.h"

#include <string.h>
#include "recipe.h"

static void put(const char *name, const uint8_t *data, size_t size, uint32_t piece) {
  size_t length;
  char *text = take_piece(data, size, piece, &length);
  scratch_file(name, text, length);
  free(text);
}

/* What a reader of pictures and the commands take for granted. */
static void check(const recipe *r) {
  CHECK(r->file && r->material && *r->material);
  CHECK((r->surface.shape == RECIPE_MESH) == (r->surface.mesh != NULL));
  for (size_t i = 0; i < r->param_count; i++) CHECK(r->params[i].id && r->params[i].text);
  const recipe_image *m = &r->image;
  CHECK(m->format >= RECIPE_FORMAT_AUTO && m->format <= RECIPE_FORMAT_FLOAT);
  CHECK(m->wrap >= RECIPE_WRAP_UNSAID && m->wrap <= RECIPE_WRAP_MIRROR);
  for (int i = 0; i < 3; i++) {
    CHECK(m->resolution[i] >= 0 && m->resolution[i] <= RECIPE_MOST_PIXELS);
    CHECK(m->size[i] >= 0 && m->size[i] <= 1e6);
    CHECK(r->surface.size[i] >= 0 && r->surface.size[i] <= 1e6);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  put("b.sozai", data, size, 2);
  put("c.sozai", data, size, 3);
  put("a.sozai", data, size, 1);
  const char *path = scratch_path("a.sozai");
  char *query = take_piece(data, size, 0, NULL);
  query[strcspn(query, "\n")] = '\0';
  size_t length = strlen(path) + strlen(query) + 2;
  char *name = malloc(length);
  CHECK(name);
  snprintf(name, length, "%s%s%s", path, *query ? "?" : "", query);
  recipe r;
  failure why = {0, ""};
  if (recipe_open(&r, name, &why)) {
    check(&r);
    recipe_set_pair(&r, query, &why);
    recipe_free(&r);
  } else
    CHECK(why.exit_code != 0 && *why.text && !strchr(why.text, '\n'));
  free(name);
  free(query);
  return 0;
}
