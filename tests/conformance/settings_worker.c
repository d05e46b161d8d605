/* SPDX-License-Identifier: Apache-2.0
 *
 * settings_worker PLUGIN COUNT [SEED]: COUNT textures of random settings, each asked at 96 places:
 * all in one batch, cut anywhere, one by one, and from the last to the first. An answer is a
 * point's own: whatever lies beside it in the batch, it must have the same bits. Prints a line
 * "kind seed hash" for each, so that instruction sets can be compared; what differs goes to stderr.
 *
 * Presets alone, which conformance.identity asks for, do not go all the ways that a kernel has: a
 * stage that is left out where no lane wants it must be nothing, to the bit, to the lanes that
 * did not. Exits 1 when something differs, 77 when the machine lacks what SOZAI_CPU asks for.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin.h"

#define POINTS 96u
#define INPUTS 16u
#define VALUES 256u
#define FEW 7u           /* values, of all that there are */
#define ONCE_PLACES 200u /* sets of them */

static plugin host;
static float in[INPUTS][POINTS], answers[2][COMPONENTS][POINTS];
static int given[INPUTS];

static double unit(uint64_t *s) { return (double)((*s = mix64(*s)) >> 11) * 0x1p-53; }
static uint32_t below(uint64_t *s, uint32_t n) { return (uint32_t)((*s = mix64(*s)) % n); }

/* ---- a texture ------------------------------------------------------------- */

/* 0: of no kind that is tried. Mostly within the usual range, seldom within the possible one. */
static int random_value(const sozai_parameter *p, uint64_t *s, sozai_value *v) {
  *v = (sozai_value){.id = p->id, .kind = p->kind};
  int possible = below(s, 12) == 0;
  double low = possible ? p->hard_min : p->soft_min, high = possible ? p->hard_max : p->soft_max;
  switch (p->kind) {
  case SOZAI_KIND_FLOAT:
    v->number[0] =
        low > 0.0 && below(s, 2) ? low * pow(high / low, unit(s)) : low + unit(s) * (high - low);
    return 1;
  case SOZAI_KIND_INT:
    v->number[0] = floor(low + unit(s) * (high - low));
    return 1;
  case SOZAI_KIND_BOOL:
    v->number[0] = below(s, 2);
    return 1;
  case SOZAI_KIND_CHOICE:
    v->text = p->choices[below(s, p->choice_count)];
    return 1;
  case SOZAI_KIND_COLOUR:
    for (int c = 0; c < 3; c++) v->number[c] = unit(s);
    return 1;
  default:
    return 0;
  }
}

/* Few values, of any. */
static uint32_t random_few(const sozai_texture_info *i, uint64_t *s, sozai_value v[VALUES]) {
  uint32_t count = 0, tries = below(s, FEW + 1);
  while (tries--)
    count += (uint32_t)random_value(i->parameters[below(s, i->parameter_count)], s, v + count);
  return count;
}

/* Most of what there is of some groups, each of them or not: a feature that takes several values to
 * be there at all is all but never drawn together with another one otherwise. */
static uint32_t random_groups(const sozai_texture_info *i, uint64_t *s, sozai_value v[VALUES]) {
  uint32_t count = 0, n = i->parameter_count;
  for (uint32_t k = 0, in = 0; k < n && count < VALUES; k++) {
    const sozai_parameter *p = i->parameters[k];
    if (k == 0 || strcmp(p->group, i->parameters[k - 1]->group) != 0) in = below(s, 3) == 0;
    if (in && below(s, 4)) count += (uint32_t)random_value(p, s, v + count);
  }
  return count;
}

/* NULL where the settings do not go together, which is no fault. */
static sozai_texture *random_texture(uint64_t *s) {
  sozai_value values[VALUES];
  sozai_texture *made = NULL;
  const sozai_texture_info *i = host.textures->info(below(s, host.textures->count()));
  const char *preset = below(s, 8) ? i->presets[below(s, i->preset_count)]->id : NULL;
  uint32_t count = below(s, 2) ? random_groups(i, s, values) : random_few(i, s, values);
  return host.textures->create(NULL, i->id, preset, values, count, &made) == SOZAI_OK ? made : NULL;
}

/* ---- places ------------------------------------------------------------------ */

/* Scattered or on a plane, near together or far apart, under footprints of 0.001 to 100 mm; not
 * always with a normal or a view. */
static void random_places(uint64_t *s) {
  int plane = below(s, 2) == 0, normals = below(s, 4) > 0, views = below(s, 4) > 0;
  double apart = pow(10, 3 * unit(s)), size = pow(10, 5 * unit(s) - 3), base[3];
  for (int c = 0; c < 3; c++) base[c] = 400 * (unit(s) - 0.5);
  for (uint32_t k = 0; k < INPUTS; k++) {
    given[k] = (k < 3 || k > 5 || normals) && (k < 12 || k > 14 || views);
    for (uint32_t i = 0; i < POINTS; i++) {
      double x = unit(s) - 0.5;
      x = k < 3 ? base[k] + x * apart : k == 15 ? size * pow(10, x) : 2 * x;
      if (plane && k == 2) x = base[2];
      if (plane && k >= 3 && k <= 5) x = k == 5;
      if (plane && k == 15) x = size;
      in[k][i] = (float)x;
    }
  }
}

/* n points from the first on, wherever they stand in their own arrays. */
static int32_t ask(const sozai_texture *t, const float (*from)[POINTS], uint32_t first, uint32_t n,
                   float (*to)[POINTS]) {
  uint32_t components = host.textures->info_of(t)->component_count;
  float *out[COMPONENTS];
  for (uint32_t k = 0; k < components; k++) out[k] = to[k] + first;
  sozai_batch b = {.size = sizeof b, .count = n, .out = out, .out_count = components};
  for (uint32_t c = 0; c < 3; c++) {
    b.point[c] = from[c] + first;
    b.normal[c] = given[3 + c] ? from[3 + c] + first : NULL;
    b.light[c] = from[6 + c] + first;
    b.light_colour[c] = from[9 + c] + first;
    b.view[c] = given[12 + c] ? from[12 + c] + first : NULL;
  }
  b.footprint = from[15] + first;
  return host.textures->evaluate(t, &b);
}

/* Mostly within the first `pieces` points, then as many as are left. */
static void ask_cut(const sozai_texture *t, uint64_t s, uint32_t pieces, float (*to)[POINTS]) {
  for (uint32_t first = 0, n; first < POINTS; first += n) {
    n = 1 + below(&s, pieces);
    if (n > POINTS - first) n = POINTS - first;
    ask(t, in, first, n, to);
  }
}

static void ask_backwards(const sozai_texture *t, float (*to)[POINTS]) {
  static float turned[INPUTS][POINTS], got[COMPONENTS][POINTS];
  for (uint32_t k = 0; k < INPUTS; k++)
    for (uint32_t i = 0; i < POINTS; i++) turned[k][i] = in[k][POINTS - 1 - i];
  ask(t, turned, 0, POINTS, got);
  for (uint32_t k = 0; k < host.textures->info_of(t)->component_count; k++)
    for (uint32_t i = 0; i < POINTS; i++) to[k][i] = got[k][POINTS - 1 - i];
}

/* ---- comparing ----------------------------------------------------------------- */

static int same(const sozai_texture *t, uint64_t seed, const char *how) {
  const sozai_texture_info *info = host.textures->info_of(t);
  for (uint32_t k = 0; k < info->component_count; k++)
    for (uint32_t i = 0; i < POINTS; i++) {
      if (memcmp(&answers[0][k][i], &answers[1][k][i], sizeof(float)) == 0) continue;
      fprintf(stderr, "%s, seed %llu, component %u, point %u: %.9g in one batch, %.9g %s\n",
              info->id, (unsigned long long)seed, k, i, (double)answers[0][k][i],
              (double)answers[1][k][i], how);
      return 0;
    }
  return 1;
}

static uint64_t hash_of(uint32_t components) {
  uint64_t h = components;
  for (uint32_t k = 0; k < components; k++)
    for (uint32_t i = 0; i < POINTS; i++) {
      uint32_t bits;
      memcpy(&bits, &answers[0][k][i], sizeof bits);
      h = mix64(h ^ bits);
    }
  return h;
}

static int compare(sozai_texture *t, uint64_t seed) {
  const sozai_texture_info *info = host.textures->info_of(t);
  uint64_t s = mix64(seed);
  random_places(&s);
  int ok = ask(t, in, 0, POINTS, answers[0]) == SOZAI_OK;
  if (!ok) { /* some outputs want normals */
    for (int c = 0; c < 3; c++) given[3 + c] = 1;
    ok = ask(t, in, 0, POINTS, answers[0]) == SOZAI_OK;
  }
  if (!ok) fprintf(stderr, "%s: %s\n", info->id, host.textures->last_error());
  if (ok) {
    ask_cut(t, seed, 40, answers[1]);
    ok = same(t, seed, "in one cut otherwise");
  }
  if (ok) {
    ask_cut(t, seed, 1, answers[1]);
    ok = same(t, seed, "alone");
  }
  if (ok) {
    ask_backwards(t, answers[1]);
    ok = same(t, seed, "in one turned round");
  }
  printf("%s %llu %016llx\n", info->id, (unsigned long long)seed,
         (unsigned long long)hash_of(info->component_count));
  return ok;
}

/* What did depend on the batch, before it was found. */
#define ONCE_VALUES 5u
static const struct {
  const char *kind, *preset;
  struct {
    const char *id, *text; /* NULL: no more */
  } values[ONCE_VALUES];
} once[] = {
    {"wood", "elm", {{"ray_height", "6.45"}, {"plies", "14"}}}, /* ragged and uneven rays */
    {"wood", "kihada", {{"ray_height", "9.48"}, {"cell_contrast", "0.456"}}}, /* rays' cells */
    {"stone",
     "concrete_paver",
     {{"inclusion_size", "37.6"}, {"white_share", "0.0726"}}}, /* specks */
    {"stone", /* inclusions in relief, below a hole as wide as all lanes */
     "nero_marquina",
     {{"inclusion_size", "2.32"},
      {"inclusion_third_share", "0.4"},
      {"inclusion_relief", "-5"},
      {"hole_size", "40"},
      {"hole_share", "0.2"}}},
};

static unsigned long compare_those(unsigned long times) {
  unsigned long differ = 0;
  for (size_t i = 0; i < sizeof once / sizeof once[0]; i++) {
    sozai_value v[ONCE_VALUES];
    sozai_texture *t = NULL;
    uint32_t count = 0;
    for (; count < ONCE_VALUES && once[i].values[count].id; count++) {
      v[count] = (sozai_value){.id = once[i].values[count].id, .kind = SOZAI_KIND_STRING};
      v[count].text = once[i].values[count].text;
    }
    if (host.textures->create(NULL, once[i].kind, once[i].preset, v, count, &t) != SOZAI_OK) {
      fprintf(stderr, "%s %s: %s\n", once[i].kind, once[i].preset, host.textures->last_error());
      return 1;
    }
    int ok = 1;
    for (unsigned long k = 0; k < times && ok; k++) ok = compare(t, k + 1);
    differ += !ok;
    host.textures->destroy(t);
  }
  return differ;
}

int main(int argc, char **argv) {
  if (argc < 3) {
    fprintf(stderr, "usage: settings_worker PLUGIN COUNT [SEED]\n");
    return 2;
  }
  if (plugin_start(&host, argv[1])) return 1;
  sozai_texture *any = NULL;
  if (host.textures->create(NULL, host.textures->info(0)->id, NULL, NULL, 0, &any) != SOZAI_OK) {
    fprintf(stderr, "%s\n", host.textures->last_error());
    return strstr(host.textures->last_error(), "SOZAI_CPU") ? 77 : 1;
  }
  host.textures->destroy(any);
  unsigned long wanted = strtoul(argv[2], NULL, 10), made = 0, differ = compare_those(ONCE_PLACES);
  uint64_t seed = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
  while (made < wanted) {
    uint64_t s = seed = mix64(seed);
    sozai_texture *t = random_texture(&s);
    if (!t) continue;
    made++;
    differ += !compare(t, seed);
    host.textures->destroy(t);
  }
  plugin_stop(&host);
  fprintf(stderr, "%lu textures of random settings: %lu whose answers depend on the batch\n", made,
          differ);
  return differ != 0;
}
