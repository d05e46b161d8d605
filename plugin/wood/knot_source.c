/* SPDX-License-Identifier: Apache-2.0 */
#include "knot_source.h"

#include <string.h>

#include "../core/limits.h"
#include "../core/meter.h"
#include "../core/services.h"
#include "../core/status.h"
#include "../tree/generator.h"
#include "../tree/tables.h"
#include "parameters.h"

#define ROWS_MOST 16777216ull /* the table_rows ceiling at its highest */

/* One column of one row of a host's table, and what it may be. */
typedef struct {
  int column;
  double least, most;
} column_range;

static int32_t check_table(const char *id, const sozai_host *host, const sozai_buffer *b,
                           uint64_t columns, limit most, const sozai_table_info *names,
                           const column_range *ranges, int count, knot_rows *out) {
  int32_t r = limit_check(host, most, b->dims[0], id);
  if (r) return r;
  if (b->dims[0] == 0 || b->dims[1] != columns) {
    return fail(SOZAI_ERROR_RANGE, "%s: a table of %llu x %llu; 1 to %llu rows of %llu columns", id,
                (unsigned long long)b->dims[0], (unsigned long long)b->dims[1],
                (unsigned long long)limit_of(host, most), (unsigned long long)columns);
  }
  for (uint64_t i = 0; i < b->dims[0]; i++) {
    for (int c = 0; c < count; c++) {
      double x = (double)b->data[i * columns + (uint64_t)ranges[c].column];
      if (!(x >= ranges[c].least && x <= ranges[c].most)) {
        return fail(SOZAI_ERROR_RANGE, "%s: row %llu: %s is %.9g, outside %.9g to %.9g", id,
                    (unsigned long long)i, names->columns[ranges[c].column].id, x, ranges[c].least,
                    ranges[c].most);
      }
    }
  }
  *out = (knot_rows){b->data, b->dims[0]};
  return SOZAI_OK;
}

static int32_t check_knots(knot_source *k, const sozai_host *host, const sozai_buffer *b) {
  static const column_range ranges[] = {
      {KNOT_BIRTH, 0, 10000},    {KNOT_DEATH, -1, 10000},       {KNOT_SHED, -1, 10000},
      {KNOT_AZIMUTH, -100, 100}, {KNOT_INCLINATION, -1.3, 1.3}, {KNOT_HEIGHT, -2e5, 2e5},
      {KNOT_RADIUS, 0, 1000},    {KNOT_FIRST, 0, ROWS_MOST},    {KNOT_COUNT, 0, 10000}};
  return check_table("knots", host, b, KNOT_COLUMNS, LIMIT_KNOTS, tree_table_infos[TABLE_KNOTS],
                     ranges, sizeof ranges / sizeof *ranges, &k->knots);
}

static int32_t check_radii(knot_source *k, const sozai_host *host, const sozai_buffer *b) {
  static const column_range ranges[] = {{RADIUS_YEAR, 0, 10000}, {RADIUS_RADIUS, 0, 1000}};
  int32_t r = check_table("knot_radii", host, b, RADIUS_COLUMNS, LIMIT_TABLE_ROWS,
                          tree_table_infos[TABLE_KNOT_RADII], ranges, 2, &k->radii);
  for (uint64_t i = 0; !r && i < k->knots.count; i++) {
    const float *row = k->knots.rows + i * KNOT_COLUMNS;
    double end = (double)row[KNOT_FIRST] + (double)row[KNOT_COUNT];
    if (end > (double)k->radii.count) {
      r = fail(SOZAI_ERROR_RANGE, "knots: row %llu ends at row %.9g of knot_radii, which has %llu",
               (unsigned long long)i, end, (unsigned long long)k->radii.count);
    }
  }
  return r;
}

/* The same heights in every year, both rising. */
static int32_t check_rings(knot_source *k, const sozai_host *host, const sozai_buffer *b) {
  static const column_range ranges[] = {
      {RING_YEAR, 0, 10000}, {RING_HEIGHT, -2e5, 2e5}, {RING_RADIUS, 0, 20000}};
  int32_t r = check_table("stem_rings", host, b, RING_COLUMNS, LIMIT_TABLE_ROWS,
                          tree_table_infos[TABLE_RINGS], ranges, 3, &k->rings);
  if (r) return r;
  const float *rows = k->rings.rows;
  uint64_t n = 1;
  while (n < k->rings.count && rows[n * RING_COLUMNS] == rows[0]) n++;
  k->ring_heights = n;
  for (uint64_t i = 0; i < k->rings.count; i++) {
    const float *row = rows + i * RING_COLUMNS;
    int first = i % n == 0;
    int year = i < n || row[RING_YEAR] >= row[RING_YEAR - (int64_t)(n * RING_COLUMNS)];
    int ok = first ? year && (i == 0 || row[RING_YEAR] > row[RING_YEAR - RING_COLUMNS])
                   : row[RING_YEAR] == row[RING_YEAR - RING_COLUMNS] &&
                         row[RING_HEIGHT] > row[RING_HEIGHT - RING_COLUMNS];
    if (i >= n) ok = ok && row[RING_HEIGHT] == rows[i % n * RING_COLUMNS + RING_HEIGHT];
    if (!ok || k->rings.count % n || n < 2) {
      return fail(SOZAI_ERROR_RANGE,
                  "stem_rings: row %llu (year %.9g, height %.9g) is out of turn: years rising, and "
                  "within each the same two or more heights, rising",
                  (unsigned long long)i, (double)row[RING_YEAR], (double)row[RING_HEIGHT]);
    }
  }
  return SOZAI_OK;
}

static int32_t take_tables(knot_source *k, const sozai_host *host, const settings *s) {
  const sozai_buffer *knots = s->list[P_KNOTS].buffer, *radii = s->list[P_KNOT_RADII].buffer;
  const sozai_buffer *rings = s->list[P_STEM_RINGS].buffer;
  int32_t r = check_knots(k, host, knots);
  if (!r && radii) r = check_radii(k, host, radii);
  if (!r && rings) r = check_rings(k, host, rings);
  return r;
}

/* ---- a tree grown for its knots ---------------------------------------- */

static int32_t known_species(const sozai_generator_info *info, const char *id) {
  for (uint32_t i = 0; i < info->preset_count; i++) {
    if (strcmp(info->presets[i]->id, id) == 0) return SOZAI_OK;
  }
  return fail(SOZAI_ERROR_RANGE, "tree: there is no tree \"%.80s\"; the first is \"%s\"", id,
              info->preset_count ? info->presets[0]->id : "");
}

static int32_t grow_tree(knot_source *k, const sozai_host *host, const settings *s) {
  const sozai_generator_info *info = tree_generator.describe();
  const char *species = s->list[P_TREE].text, *field = s->list[P_TREE_FIELD].text;
  int32_t r = *species ? known_species(info, species) : SOZAI_OK;
  if (r) return r;
  sozai_texture_info parameters = generator_parameters(info);
  const sozai_value values[] = {
      {.id = "age", .kind = SOZAI_KIND_FLOAT, .number = {number_at(s, P_TREE_AGE)}},
      {.id = "seed", .kind = SOZAI_KIND_INT, .number = {number_at(s, P_SEED)}},
      {.id = "orders", .kind = SOZAI_KIND_INT, .number = {1}},
      {.id = "fork_spacing", .kind = SOZAI_KIND_FLOAT, .number = {0}}, /* arms leave no knot */
      {.id = "field", .kind = SOZAI_KIND_TEXT, .text = field}};
  r = settings_make(&k->given, host, &parameters, *species ? species : NULL, values,
                    sizeof values / sizeof values[0]);
  if (r) return r;
  k->tree = host_alloc(host, tree_generator.state_bytes, 64);
  if (!k->tree) return SOZAI_ERROR_MEMORY;
  /* knots come of its tables: a rehearsal too wants them */
  int rehearsing = host_rehearse(host, 0);
  r = tree_generator.grow(k->tree, host, &k->given);
  host_rehearse(host, rehearsing);
  if (r) return r;
  k->age = number_at(s, P_TREE_AGE);
  k->knots.rows = tree_generator.table(k->tree, TABLE_KNOTS, &k->knots.count);
  k->radii.rows = tree_generator.table(k->tree, TABLE_KNOT_RADII, &k->radii.count);
  k->rings.rows = tree_generator.table(k->tree, TABLE_RINGS, &k->rings.count);
  while (k->ring_heights < k->rings.count &&
         k->rings.rows[k->ring_heights * RING_COLUMNS] == k->rings.rows[0]) {
    k->ring_heights++;
  }
  return SOZAI_OK;
}

/* ---- either ------------------------------------------------------------ */

static double later(double a, float b) { return (double)b > a ? (double)b : a; }

static void find_age(knot_source *k) {
  for (uint64_t i = 0; i < k->knots.count; i++) {
    const float *row = k->knots.rows + i * KNOT_COLUMNS;
    k->age = later(later(later(k->age, row[KNOT_BIRTH]), row[KNOT_DEATH]), row[KNOT_SHED]);
    if (!k->rings.count) k->height = later(k->height, row[KNOT_HEIGHT]);
  }
  for (uint64_t i = 0; i < k->radii.count; i++) {
    k->age = later(k->age, k->radii.rows[i * RADIUS_COLUMNS + RADIUS_YEAR]);
  }
  if (k->rings.count) {
    const float *last = k->rings.rows + (k->rings.count - 1) * RING_COLUMNS;
    k->age = later(k->age, last[RING_YEAR]);
    k->height = (double)last[RING_HEIGHT];
  }
}

int32_t knot_source_open(knot_source *k, const sozai_host *host, const settings *s) {
  memset(k, 0, sizeof *k);
  int tree = *s->list[P_TREE].text || *s->list[P_TREE_FIELD].text;
  int32_t r = SOZAI_OK;
  if (s->list[P_KNOTS].buffer) {
    r = tree ? fail(SOZAI_ERROR_RANGE,
                    "tree: \"%.80s\" and the table knots are both given; one of "
                    "them",
                    s->list[P_TREE].text)
             : take_tables(k, host, s);
  } else if (s->list[P_KNOT_RADII].buffer || s->list[P_STEM_RINGS].buffer) {
    r = fail(SOZAI_ERROR_RANGE, "%s: given without the table knots",
             s->list[P_KNOT_RADII].buffer ? "knot_radii" : "stem_rings");
  } else if (tree) {
    r = grow_tree(k, host, s);
  }
  if (r) {
    knot_source_close(k, host);
    return r;
  }
  find_age(k);
  return SOZAI_OK;
}

void knot_source_close(knot_source *k, const sozai_host *host) {
  if (k->tree) {
    tree_generator.release(k->tree, host);
    host_free(host, k->tree, tree_generator.state_bytes, 64);
  }
  settings_free(&k->given, host);
  memset(k, 0, sizeof *k);
}

/* Of one year's rows. */
static double radius_at(const knot_source *k, const float *rows, double height) {
  uint64_t n = k->ring_heights, low = 0, high = n - 1;
  if (height <= (double)rows[RING_HEIGHT]) return (double)rows[RING_RADIUS];
  if (height >= (double)rows[high * RING_COLUMNS + RING_HEIGHT]) {
    return (double)rows[high * RING_COLUMNS + RING_RADIUS];
  }
  while (high - low > 1) {
    uint64_t middle = (low + high) / 2;
    *((double)rows[middle * RING_COLUMNS + RING_HEIGHT] <= height ? &low : &high) = middle;
  }
  const float *a = rows + low * RING_COLUMNS, *b = rows + high * RING_COLUMNS;
  double t = (height - (double)a[RING_HEIGHT]) / ((double)b[RING_HEIGHT] - (double)a[RING_HEIGHT]);
  return (double)a[RING_RADIUS] + t * ((double)b[RING_RADIUS] - (double)a[RING_RADIUS]);
}

double knot_source_radius(const knot_source *k, double height, double year) {
  uint64_t years = k->rings.count / k->ring_heights, stride = k->ring_heights * RING_COLUMNS;
  uint64_t low = 0, high = years;
  /* low: the first year that is not before */
  while (low < high) {
    uint64_t middle = (low + high) / 2;
    if ((double)k->rings.rows[middle * stride] < year) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == years) return radius_at(k, k->rings.rows + (years - 1) * stride, height);
  const float *b = k->rings.rows + low * stride;
  double year_b = (double)b[RING_YEAR], radius_b = radius_at(k, b, height);
  double year_a = low ? (double)b[RING_YEAR - (int64_t)stride] : 0.0;
  double radius_a = low ? radius_at(k, b - stride, height) : 0.0;
  double t = year_b > year_a ? (year - year_a) / (year_b - year_a) : 1.0;
  return radius_a + (t < 0.0 ? 0.0 : t) * (radius_b - radius_a);
}
