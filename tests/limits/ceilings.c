/* SPDX-License-Identifier: Apache-2.0
 *
 * Every ceiling of the plugin's, set by the host: what is at it passes, what is
 * one above it is refused with LIMIT, naming the ceiling and its value.
 */
#include "tables.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What is made under a ceiling. */
typedef struct {
  const char *limit;
  const char *names;   /* what the message begins with: a parameter, or a kind */
  uint64_t passes;     /* the lowest ceiling that it passes under */
  const char *texture; /* or NULL: a generator */
  const char *generator;
  const sozai_value *values;
  uint32_t count;
  int mesh; /* refused by its mesh, not by growing */
} attempt;

static int32_t try_it(const attempt *a, uint64_t ceiling) {
  count c;
  sozai_host host = counting_host(&c);
  const sozai_limit limit = {a->limit, ceiling};
  host.limits = &limit;
  host.limit_count = 1;
  sozai_texture *t = NULL;
  sozai_geometry *g = NULL;
  const sozai_mesh *m = NULL;
  int32_t r = a->texture ? textures->create(&host, a->texture, NULL, a->values, a->count, &t)
                         : geometry->grow(&host, a->generator, NULL, a->values, a->count, &g);
  if (!r && a->mesh) r = geometry->mesh(g, NULL, &m);
  geometry->release_mesh(m);
  geometry->release(g);
  textures->destroy(t);
  assert_int_equal(c.live, 0);
  return r;
}

static uint32_t tried;

static void check(const attempt *a) {
  const sozai_limit_info *info = limits->find(a->limit);
  assert_non_null(info);
  int32_t at = try_it(a, a->passes);
  if (at)
    print_message("%s at %llu: %s\n", a->limit, (unsigned long long)a->passes,
                  textures->last_error());
  assert_int_equal(at, SOZAI_OK);
  assert_int_equal(try_it(a, a->passes - 1), SOZAI_ERROR_LIMIT);
  char wanted[64];
  const char *why = textures->last_error();
  snprintf(wanted, sizeof wanted, "above the ceiling %s, %llu", a->limit,
           (unsigned long long)a->passes - 1);
  print_message("%s\n", why);
  assert_int_equal(strncmp(why, a->names, strlen(a->names)), 0);
  assert_non_null(strstr(why, wanted));
  assert_null(strchr(why, '\n'));
  tried++;
}

static void each_ceiling(void **unused) {
  (void)unused;
  count c;
  sozai_host host = counting_host(&c);
  sozai_memory m = {.size = sizeof m};

  assert_int_equal(memory->texture(&host, "stone", NULL, NULL, 0, &m), SOZAI_OK);
  check(&(attempt){"texture_bytes", "stone", m.peak, "stone", NULL, NULL, 0, 0});

  const sozai_value young[] = {{.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {9}}};
  assert_int_equal(memory->geometry(&host, "tree", NULL, young, 1, &m), SOZAI_OK);
  check(&(attempt){"geometry_bytes", "tree", m.peak, NULL, "tree", young, 1, 0});
  sozai_geometry *g = NULL;
  assert_int_equal(geometry->grow(&host, "tree", NULL, young, 1, &g), SOZAI_OK);
  assert_int_equal(memory->mesh(g, NULL, &m), SOZAI_OK);
  check(&(attempt){"mesh_bytes", "tree", m.peak, NULL, "tree", young, 1, 1});
  const sozai_value bare[] = {young[0], {.id = "orders", .kind = SOZAI_KIND_INT, .number = {1}}};

  /* knots and their radii, as wood takes them */
  sozai_table knots = {.size = sizeof knots}, radii = {.size = sizeof radii};
  assert_int_equal(geometry->table(g, "knots", &knots), SOZAI_OK);
  assert_int_equal(geometry->table(g, "knot_radii", &radii), SOZAI_OK);
  const sozai_buffer tables[] = {{.size = sizeof(sozai_buffer),
                                  .kind = SOZAI_BUFFER_TABLE,
                                  .dims = {knots.rows, knots.info->column_count},
                                  .data = knots.data},
                                 {.size = sizeof(sozai_buffer),
                                  .kind = SOZAI_BUFFER_TABLE,
                                  .dims = {radii.rows, radii.info->column_count},
                                  .data = radii.data}};
  const sozai_value knotted[] = {
      {.id = "knots", .kind = SOZAI_KIND_BUFFER, .buffer = &tables[0]},
      {.id = "knot_radii", .kind = SOZAI_KIND_BUFFER, .buffer = &tables[1]}};
  check(&(attempt){"knots", "knots", knots.rows, "wood", NULL, knotted, 2, 0});
  check(&(attempt){"table_rows", "knot_radii", radii.rows, "wood", NULL, knotted, 2, 0});
  geometry->release(g);

  check(&(attempt){"values", "values", 2, NULL, "tree", bare, 2, 0});
  const sozai_value named[] = {{.id = "object", .kind = SOZAI_KIND_TEXT, .text = "table top"}};
  /* other texts, such as the names of spaces, are shorter */
  check(&(attempt){"text_bytes", "object", 9, "wood", NULL, named, 1, 0});
  static const float widths[7] = {1.0f, 2.0f, 1.5f, 0.5f, 2.5f, 3.0f, 1.0f};
  const sozai_buffer rings = {
      .size = sizeof rings, .kind = SOZAI_BUFFER_TABLE, .dims = {7, 1}, .data = widths};
  const sozai_value measured[] = {
      {.id = "ring_widths", .kind = SOZAI_KIND_BUFFER, .buffer = &rings}};
  check(&(attempt){"buffer_bytes", "ring_widths", 28, "wood", NULL, measured, 1, 0});
  const sozai_buffer picture = section_picture();
  const sozai_value section[] = {{.id = "section", .kind = SOZAI_KIND_IMAGE, .buffer = &picture}};
  check(&(attempt){"image_pixels", "section", picture.dims[0] * picture.dims[1], "wood", NULL,
                   section, 1, 0});

  const sozai_buffer box = box_hull();
  const sozai_value strands[] = {{.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &box},
                                 {.id = "count", .kind = SOZAI_KIND_INT, .number = {12}},
                                 {.id = "vertices", .kind = SOZAI_KIND_INT, .number = {5}}};
  check(&(attempt){"hull_triangles", "hull", 12, NULL, "fiber", strands, 3, 0});
  check(&(attempt){"strands", "count", 12, NULL, "fiber", strands, 3, 0});
  check(&(attempt){"strand_points", "count", 60, NULL, "fiber", strands, 3, 0});
  const sozai_value literal[] = {strands[0],
                                 strands[1],
                                 {.id = "mode", .kind = SOZAI_KIND_CHOICE, .text = "literal"},
                                 {.id = "spacing", .kind = SOZAI_KIND_FLOAT, .number = {10}}};
  /* each face is cut into 3 of its longest edge, of 20 to 25 mm; or 2, of 18 */
  check(&(attempt){"hull_vertices", "spacing", 8 * 10 + 4 * 6, NULL, "fiber", literal, 4, 0});

  /* how many there are the refusal says */
  const char *const grows[][2] = {{"shoots", "orders"}, {"leaves", "foliage"}};
  for (int k = 0; k < 2; k++) {
    attempt a = {grows[k][0], grows[k][1], 1, NULL, "tree", young, 1, 0};
    assert_int_equal(try_it(&a, 1), SOZAI_ERROR_LIMIT);
    const char *colon = strchr(textures->last_error(), ':');
    assert_non_null(colon);
    a.passes = strtoull(colon + 1, NULL, 10);
    assert_in_range(a.passes, 100, 10000000);
    check(&a);
  }
}

/* A picture in a file is refused by its head: the host hears that it begins, and no more. */
static uint32_t reports;

static int32_t note_report(void *user, float fraction, const char *what) {
  (void)user, (void)fraction, (void)what;
  reports++;
  return 0;
}

static int32_t with_file(const char *path, uint64_t ceiling) {
  count c;
  sozai_host host = counting_host(&c);
  const sozai_limit limit = {"image_pixels", ceiling};
  const sozai_value section = {.id = "section", .kind = SOZAI_KIND_IMAGE, .text = path};
  host.limits = &limit;
  host.limit_count = 1;
  host.progress = note_report;
  sozai_texture *t = NULL;
  reports = 0;
  int32_t r = textures->create(&host, "wood", NULL, &section, 1, &t);
  textures->destroy(t);
  assert_int_equal(c.live, 0);
  if (r) print_message("%s\n", textures->last_error());
  return r;
}

static void a_picture_in_a_file(void **unused) {
  (void)unused;
  const sozai_buffer picture = section_picture();
  unsigned side = (unsigned)picture.dims[0];
  char path[] = "/tmp/sozai-ceilings-XXXXXX", wanted[128];
  int number = mkstemp(path);
  assert_true(number >= 0);
  FILE *file = fdopen(number, "wb");
  assert_non_null(file);
  fprintf(file, "PF\n%u %u\n-1.0\n", side, side);
  size_t numbers = (size_t)side * side * 3;
  assert_int_equal(fwrite(picture.data, sizeof(float), numbers, file), numbers);
  fclose(file);

  assert_int_equal(with_file(path, side * side), SOZAI_OK);
  assert_true(reports > 1);
  assert_int_equal(with_file(path, side * side - 1), SOZAI_ERROR_LIMIT);
  assert_int_equal(reports, 1);
  snprintf(wanted, sizeof wanted, "section: picture %s: %u is above the ceiling image_pixels, %u",
           path, side * side, side * side - 1);
  assert_string_equal(textures->last_error(), wanted);
  assert_int_equal(with_file(path, 0), SOZAI_ERROR_LIMIT);
  assert_int_equal(reports, 0);
  unlink(path);
}

static void every_row_was_tried(void **unused) {
  (void)unused;
  assert_int_equal(tried, limits->count());
}

/* ---- the list itself ----------------------------------------------------- */

static void rows_make_sense(void **unused) {
  (void)unused;
  for (uint32_t i = 0; i < limits->count(); i++) {
    const sozai_limit_info *a = limits->info(i);
    assert_ptr_equal(limits->find(a->id), a);
    assert_true(a->size >= sizeof *a && a->value && a->value <= a->most);
    assert_true(a->doc[0] && a->doc[strlen(a->doc) - 1] == '.');
  }
  assert_null(limits->info(limits->count()));
  assert_null(limits->find("no such limit"));
  assert_null(limits->find(NULL));
}

static int32_t with(const sozai_limit *list, uint32_t n) {
  count c;
  sozai_host host = counting_host(&c);
  host.limits = list;
  host.limit_count = n;
  sozai_texture *t = NULL;
  int32_t r = textures->create(&host, "stone", NULL, NULL, 0, &t);
  textures->destroy(t);
  assert_int_equal(c.live, 0);
  return r;
}

static void a_host_that_asks_wrongly(void **unused) {
  (void)unused;
  const sozai_limit *row = &(sozai_limit){"texture_bites", 5};
  assert_int_equal(with(row, 1), SOZAI_ERROR_UNKNOWN);
  assert_non_null(strstr(textures->last_error(), "texture_bites"));
  row = &(sozai_limit){"texture_bytes", UINT64_MAX};
  assert_int_equal(with(row, 1), SOZAI_ERROR_RANGE);
  assert_non_null(strstr(textures->last_error(), "texture_bytes: 18446744073709551615"));
  row = &(sozai_limit){NULL, 5};
  assert_int_equal(with(row, 1), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(with(NULL, 1), SOZAI_ERROR_ARGUMENT);
  /* nothing at all is allowed; and the later of two counts */
  const sozai_limit twice[] = {{"texture_bytes", 0}, {"texture_bytes", 1u << 30}};
  assert_int_equal(with(twice, 1), SOZAI_ERROR_LIMIT);
  assert_int_equal(with(twice, 2), SOZAI_OK);
  sozai_memory small = {.size = 8};
  assert_int_equal(memory->texture(NULL, "stone", NULL, NULL, 0, &small), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(memory->texture(NULL, "stone", NULL, NULL, 0, NULL), SOZAI_ERROR_ARGUMENT);
  small.size = sizeof small;
  assert_int_equal(memory->mesh(NULL, NULL, &small), SOZAI_ERROR_ARGUMENT);
  assert_int_equal(memory->texture(NULL, "no such", NULL, NULL, 0, &small), SOZAI_ERROR_UNKNOWN);
}

/* The host of before knows of no ceilings: its struct ends earlier. */
static void an_older_host(void **unused) {
  (void)unused;
  count c;
  sozai_host host = counting_host(&c);
  const sozai_limit none = {"texture_bytes", 0};
  host.limits = &none;
  host.limit_count = 1;
  host.size = offsetof(sozai_host, limits);
  sozai_texture *t = NULL;
  assert_int_equal(textures->create(&host, "stone", NULL, NULL, 0, &t), SOZAI_OK);
  textures->destroy(t);
  assert_int_equal(c.live, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(rows_make_sense),          cmocka_unit_test(each_ceiling),
      cmocka_unit_test(a_picture_in_a_file),      cmocka_unit_test(every_row_was_tried),
      cmocka_unit_test(a_host_that_asks_wrongly), cmocka_unit_test(an_older_host)};
  return cmocka_run_group_tests(tests, tables_open, tables_close);
}
