/* SPDX-License-Identifier: Apache-2.0
 * Fits the amounts of light on cloth (plugin/fiber/texture/fitted.h) and prints fitted.c: woven
 * presets and cloths between and beside them are followed by rays as fiber.cloth follows them, with
 * other seeds, and the texture is brought to their means by Gauss and Newton's steps. What one
 * cloth cannot say is held near what the last fit said.
 *
 *   fit-fiber-light [FILE]   FILE: of what was traced, read if it is there, else written */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "clothed.h"
#include "fiber/texture/fitted.h"
#include "fit.h"
#include "samples.h"
#include "slabbed.h"

enum {
  VARIANTS = 6, /* of each preset, beside itself; */
  FITTED = 3,   /* the rest of them are not fitted, but looked at */
  CLOTHS_MAX = 80,
  RAYS = 9000,
  RAYS_OF_VARIANT = 1000,
  SCALES = 4,
  POINTS = 128, /* of each look */
  POINTS_OF_VARIANT = 40,
  LOOKS = VIEWS * SIDES * LIGHTS,
  BULK_VARIANTS = 6, /* likewise, of each aggregate with itself */
  BULKS_MAX = 40,
  ELEVATIONS = 4,
  ENERGIES = 40 * 2 * ELEVATIONS
};
static int steps_of_bulks = 10, steps_of_cloths = 10;
static const double footprints[SCALES] = {0, 0.03, 0.3, 30};
static const double weights[SCALES] = {0.25, 0.25, 0.25, 0.25};

/* What is asked of the fit: of means how near; of single looks, over the colour's mean; and of
 * light on white fibres, what may come back. */
static const double sure = 0.006, sure_of_look = 1.5, sure_of_look_in_bulk = 0.3, most_back = 0.98,
                    over_back = 0.002;
static const double grazing[ELEVATIONS] = {10, 20, 40, 85}; /* and not, degrees */
/* How far an amount's logarithm may go with each feature, over the feature's spread. */
static const double steep = 1.0;

/* Which amounts go by what, beside themselves. */
#define ALL_BUT_(x) ((1u << CLOTH_FEATURES) - 1 - (x))
static const uint32_t goes_by[FIT_AMOUNTS] = {
    [FIT_SLAB] = 1 << CLOTH_DEPTH | 1 << CLOTH_DULL | 1 << CLOTH_ROUGH | 1 << CLOTH_SLOPE |
                 1 << CLOTH_COARSE,
    [FIT_COLOUR] = 1 << CLOTH_DEPTH | 1 << CLOTH_DULL | 1 << CLOTH_ROUGH | 1 << CLOTH_COARSE,
    [FIT_ALBEDO] = ALL_BUT_(1 << CLOTH_TWIST),
    [FIT_OFTEN] = ALL_BUT_(0),
    [FIT_NARROW] = 1 << CLOTH_ROUGH,
    [FIT_THROUGH] = ALL_BUT_(0),
    [FIT_FLOWN] = 1 << CLOTH_DULL | 1 << CLOTH_ROUGH,
    [FIT_HAIR] = 1 << CLOTH_ROUGH | 1 << CLOTH_DEPTH | 1 << CLOTH_RISE | 1 << CLOTH_FLOWN |
                 1 << CLOTH_COARSE,
    [FIT_GLANCE] = ALL_BUT_(0)};

static const uint32_t bulk_goes_by[BULK_AMOUNTS] = {
    [BULK_GLANCE] = 1 << BULK_THIN | 1 << BULK_RISE | 1 << BULK_ROUGH,
    [BULK_THROUGH] = 1 << BULK_THIN | 1 << BULK_RISE | 1 << BULK_ROUGH,
    [BULK_SINGLE] = 1 << BULK_THIN | 1 << BULK_DULL,
    [BULK_CHAIN] = 1 << BULK_THIN | 1 << BULK_DULL | 1 << BULK_RISE | 1 << BULK_ROUGH,
    [BULK_MORE] = 1 << BULK_THIN | 1 << BULK_DULL,
    [BULK_OFTEN] = 1 << BULK_THIN | 1 << BULK_DULL | 1 << BULK_RISE,
    [BULK_SLAB] = 1 << BULK_THIN | 1 << BULK_DULL};

static const char *const bulk_amounts[BULK_AMOUNTS] = {"GLANCE", "THROUGH", "SINGLE",    "CHAIN",
                                                       "MORE",   "OFTEN",   "SLAB",      "LINEAR",
                                                       "SQUARE", "GRAZE",   "GRAZE_BOTH"};
static const char *const amounts[FIT_AMOUNTS] = {"SLAB",  "COLOUR", "ALBEDO", "OFTEN",
                                                 "BROAD", "NARROW", "GLANCE", "THROUGH",
                                                 "FLOWN", "HAIR",   "SHADED"};

typedef struct {
  cloth of;
  clothed real;
  bool preset, held_out; /* as it is; looked at, not fitted */
} sample;

typedef struct {
  aggregate is;
  slab of;
  slabbed real;
  bool variant, held_out;
} bulk_sample;

static bulk_sample bulks[BULKS_MAX];
static int bulk_count;
static sample samples[CLOTHS_MAX];
static int sample_count;
static bool looking; /* at all, also what is not fitted */
static fibertex_fitted *fitting;
static const double *made_of; /* the last cloth */
static const sozai_textures_1 *textures;

/* ---- cloths ------------------------------------------------------------ */

static double between(sample_stream *d, double least, double most) {
  return least + (most - least) * (double)sample_next(d);
}

/* Beside a preset: what an artist may turn it to. */
static cloth varied(cloth c, uint32_t which) {
  sample_stream d = {sample_hash(which)};
  if (which % 2) c.slub = 0;
  c.diameter *= exp(between(&d, -0.5, 0.5));
  c.flatness = fmin(fmax(c.flatness * exp(between(&d, -0.9, 0.35)), 0.15), 1);
  c.width = fmin(c.width * between(&d, 0.85, 1.15), 1.4);
  c.twist = between(&d, 0, 38);
  c.elevation_spread *= between(&d, 0.4, 1.5);
  c.flyaway = fmin(c.flyaway * between(&d, 0, 2), 0.39);
  c.transmission = between(&d, 0.18, 0.56);
  c.roughness *= exp(between(&d, -0.35, 0.35));
  c.swell *= between(&d, 0.5, 1.6);
  return c;
}

/* Deeper or thinner, steeper or flatter, clearer or duller. */
static aggregate varied_aggregate(aggregate a, uint32_t which, int variant) {
  sample_stream d = {sample_hash(7000u + which)};
  if (!variant) return a;
  a.thick *= exp(between(&d, -1.2, 0.4));
  a.squeeze = between(&d, 0.2, 0.6);
  a.round = (float)between(&d, 0.25, 0.65);
  a.roughness *= (float)exp(between(&d, -0.35, 0.35));
  return a;
}

static void gather(void) {
  const sozai_texture_info *info = textures->find("fiber");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    cloth c;
    if (!cloth_of(info, info->presets[i], &c)) continue;
    for (uint32_t k = 0; k <= VARIANTS; k++) {
      assert_true(sample_count < CLOTHS_MAX);
      samples[sample_count++] =
          (sample){.of = k ? varied(c, 100 * i + k) : c, .preset = k == 0, .held_out = k > FITTED};
    }
  }
}

/* What was traced: read as far as it goes, then written on. */
static FILE *kept;

static bool recalled(void *to, size_t size) { return kept && fread(to, size, 1, kept) == 1; }

static void keep(const void *what, size_t size) {
  if (!kept) return;
  fseek(kept, 0, SEEK_END);
  fwrite(what, size, 1, kept);
  fflush(kept);
}

static void trace_all(void) {
  for (int i = 0; i < sample_count; i++) {
    clothed *r = &samples[i].real;
    if (recalled(r, sizeof *r)) continue;
    *r = cloth_as_curves(&samples[i].of, 1000u + (uint32_t)i,
                         samples[i].preset ? RAYS : RAYS_OF_VARIANT);
    keep(r, sizeof *r);
    fprintf(stderr, "%d of %d: %s\n", i + 1, sample_count, samples[i].of.preset);
  }
}

/* ---- energy ------------------------------------------------------------ */

/* What a white fibre gives back of light that grazes is to stay below what comes in: of every
 * preset of a kind, and as clear as can be; what is over, if anything. */
static void add_over(const sozai_preset *p, bool clear, double *out) {
  enum { ROUND = 16, RINGS = 12 };
  const sozai_value white[] = {
      {.id = "colour", .kind = SOZAI_KIND_COLOUR, .number = {1, 1, 1}, .text = "sRGB"},
      {.id = "second_colour", .kind = SOZAI_KIND_COLOUR, .number = {1, 1, 1}, .text = "sRGB"},
      {.id = "weft_colour", .kind = SOZAI_KIND_COLOUR, .number = {1, 1, 1}, .text = "sRGB"},
      {.id = "transmission", .kind = SOZAI_KIND_FLOAT, .number = {1}}};
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "fiber", p->id, white, clear ? 4 : 3, &t), SOZAI_OK);
  for (int e = 0; e < ELEVATIONS; e++) {
    ground g = ground_of(ROUND * RINGS, 1);
    for (uint32_t i = 0; i < ROUND * RINGS; i++) {
      double rise = asin(sqrt((i % RINGS + 0.5) / RINGS)) * 180 / PI;
      double azimuth = 360.0 * (i / RINGS + 0.5) / ROUND;
      ground_look(&g, i, aim(rise, azimuth), aim(grazing[e], 40));
    }
    ground_ask(&g, textures, t, 100);
    double back = ground_mean(&g, RADIANCE) / sin(grazing[e] * PI / 180);
    out[e] = fmax(back - most_back, 0) / over_back;
    ground_free(&g);
  }
  textures->destroy(t);
}

static void add_energy(bool woven_, double *out) {
  const sozai_texture_info *info = textures->find("fiber");
  int at = 0;
  for (uint32_t i = 0; i < info->preset_count; i++) {
    cloth c;
    if (cloth_of(info, info->presets[i], &c) != woven_) continue;
    for (int clear = 0; clear < 2; clear++, at += ELEVATIONS) {
      assert_true(at + ELEVATIONS <= RESIDUALS_MAX);
      add_over(info->presets[i], clear, out + at);
    }
  }
}

/* ---- what is seen ------------------------------------------------------ */

/* How far off, over how sure: the chance of the rays, and what is asked. */
static double off_by(double got, double real, double chance, double asked) {
  return (got - real) / hypot(asked, chance);
}

/* From it: the means of each footprint, and of what is seen one by one the mean of all
 * footprints. */
static void cloth_off(int which, double *out) {
  memset(out, 0, RESIDUALS_MAX * sizeof *out);
  if (which == sample_count) {
    add_energy(true, out);
    return;
  }
  const sample *s = &samples[which];
  const clothed *r = &s->real;
  if (s->held_out && !looking) return;
  const double asked = s->preset ? sure : 12 * sure;
  double looks[LOOKS][3] = {{0}};
  sozai_texture *t = cloth_as_texture(&s->of, textures, colours);
  for (int f = 0; f < SCALES; f++) {
    uint32_t points = footprints[f] > 10 ? 6 : s->preset ? POINTS : POINTS_OF_VARIANT;
    clothed c = cloth_as_seen(t, textures, footprints[f], points);
    for (int k = 0; k < 3; k++) {
      *out++ = off_by(c.albedo[k], r->albedo[k], r->albedo_chance[k], asked * r->albedo[k]);
      *out++ = off_by(c.mean[k], r->mean[k], r->mean_chance[k], asked * r->mean[k]);
      for (int l = 0; l < LOOKS; l++) looks[l][k] += weights[f] * (&c.radiance[0][0][0])[l][k];
    }
  }
  textures->destroy(t);
  for (int k = 0; k < 3; k++) {
    for (int l = 0; l < LOOKS; l++) {
      *out++ = off_by(looks[l][k], (&r->radiance[0][0][0])[l][k], (&r->chance[0][0][0])[l][k],
                      sure_of_look * r->mean[k]);
    }
  }
}

static void bulk_off(int which, double *out) {
  memset(out, 0, RESIDUALS_MAX * sizeof *out);
  if (which == bulk_count) {
    add_energy(false, out);
    return;
  }
  const bulk_sample *s = &bulks[which];
  const slabbed *r = &s->real;
  if (s->held_out && !looking) return;
  const double asked = s->variant ? 2 * sure : sure;
  double looks[SLAB_LOOKS][3] = {{0}};
  sozai_texture *t = slab_as_texture(&s->of, textures);
  for (int f = 0; f < SCALES; f++) {
    slabbed c = slab_as_seen(t, textures, footprints[f], footprints[f] > 10 ? 24 : 8 * POINTS);
    for (int k = 0; k < 3; k++) {
      *out++ = off_by(c.mean[k], r->mean[k], r->mean_chance[k], asked * r->mean[k]);
      for (int l = 0; l < SLAB_LOOKS; l++) looks[l][k] += weights[f] * c.radiance[l][k];
    }
  }
  textures->destroy(t);
  for (int k = 0; k < 3; k++) {
    for (int l = 0; l < SLAB_LOOKS; l++) {
      *out++ = off_by(looks[l][k], r->radiance[l][k], r->chance[l][k],
                      sure_of_look_in_bulk * r->mean[k]);
    }
  }
}

/* ---- unknowns ---------------------------------------------------------- */

static double features_of[CLOTHS_MAX][CLOTH_FEATURES];

/* How far the cloths' own amounts go. While they are fitted nothing bounds them. */
static void unbound(void) {
  for (int a = 0; a < FIT_AMOUNTS; a++) {
    fitting->low[a] = -1e3;
    fitting->high[a] = 1e3;
  }
}

static void bound(void) {
  for (int a = 0; a < FIT_AMOUNTS; a++) {
    fitting->low[a] = 1e3;
    fitting->high[a] = -1e3;
    for (int s = 0; s < sample_count; s++) {
      double log = fitted_sum(fitting->amount[a], features_of[s], fitting->least, fitting->most,
                              fitting->middle, CLOTH_FEATURES);
      fitting->low[a] = fmin(fitting->low[a], log);
      fitting->high[a] = fmax(fitting->high[a], log);
    }
  }
}

typedef struct {
  int features;
  double *least, *most, *middle;
  double spread[CLOTH_FEATURES];
} made;

static void add_made(made *m, int sample) {
  const double *x = made_of;
  for (int f = 0; f < m->features; f++) {
    if (!sample) m->least[f] = m->most[f] = x[f];
    m->least[f] = fmin(m->least[f], x[f]);
    m->most[f] = fmax(m->most[f], x[f]);
    m->middle[f] = 0.5 * (m->least[f] + m->most[f]);
    m->spread[f] = fmax(0.3 * (m->most[f] - m->least[f]), 1e-3);
  }
  m->middle[0] = 0; /* it is 1 */
}

/* A row's first is free; what it goes by is held near none. */
static void add_row(fit *f, const made *m, double *row, uint32_t goes_by_, double reach,
                    bool from_none) {
  for (int k = 0; k < m->features; k++) {
    if (k && !(goes_by_ >> k & 1)) continue;
    assert_true(f->unknowns < UNKNOWN_MAX);
    /* towards none and not the last fit: what no cloth asks for would add up over fits */
    f->list[f->unknowns++] =
        (unknown){&row[k], k && from_none ? 0 : row[k], k ? steep / m->spread[k] : reach};
  }
}

static void fit_cloths(void) {
  static fit f;
  made m = {CLOTH_FEATURES, fitting->least, fitting->most, fitting->middle, {0}};
  gather();
  for (int s = 0; s < sample_count; s++) {
    textures->destroy(cloth_as_texture(&samples[s].of, textures, colours));
    add_made(&m, s);
    memcpy(features_of[s], made_of, sizeof features_of[s]);
  }
  trace_all();
  unbound();
  for (int a = 0; a < FIT_AMOUNTS; a++)
    add_row(&f, &m, fitting->amount[a], goes_by[a], goes_by[a] ? 0.7 : 0.15, true);
  f.samples = sample_count + 1;
  f.residuals = 6 * SCALES + 3 * LOOKS;
  f.off = cloth_off;
  fit_run(&f, steps_of_cloths);
  bound();
}

static void fit_bulks(void) {
  static fit f;
  made m = {BULK_FEATURES, fitting->bulk_least, fitting->bulk_most, fitting->bulk_middle, {0}};
  for (int i = 0; i < aggregate_count * BULK_VARIANTS; i++) {
    bulk_sample *s = &bulks[bulk_count++];
    int variant = i % BULK_VARIANTS;
    s->is = varied_aggregate(aggregates[i / BULK_VARIANTS], (uint32_t)i, variant);
    s->variant = variant > 0;
    s->held_out = variant == BULK_VARIANTS - 1;
    if (recalled(&s->real, sizeof s->real) && recalled(&s->of, sizeof s->of)) {
      s->of.of = &s->is;
    } else {
      grow_slab(&s->of, &s->is);
      s->real = slab_as_curves(&s->of, 1000u + (uint32_t)i,
                               variant           ? 6000
                               : s->is.thick < 3 ? 60000
                                                 : 30000);
      keep(&s->real, sizeof s->real);
      keep(&s->of, sizeof s->of);
    }
    textures->destroy(slab_as_texture(&s->of, textures));
    add_made(&m, i);
    fprintf(stderr, "%s: %.3f %.3f %.3f\n", s->is.name, s->real.mean[0], s->real.mean[1],
            s->real.mean[2]);
  }
  for (int a = 0; a < BULK_AMOUNTS; a++)
    add_row(&f, &m, fitting->bulk[a], bulk_goes_by[a], 0.7, false);
  f.samples = bulk_count + 1;
  f.residuals = ENERGIES;
  f.off = bulk_off;
  fit_run(&f, steps_of_bulks);
}

/* ---- result ------------------------------------------------------------ */

static void print_row(const char *name, const double *row, int count) {
  printf("      %s = {", name);
  for (int f = 0; f < count; f++) printf(f ? ", %.4g" : "%.4g", row[f]);
  printf("},\n");
}

static void print_amount(const char *of, const char *amount, const double *row, int count) {
  char name[40];
  snprintf(name, sizeof name, "    [%s_%s]", of, amount);
  print_row(name, row, count);
}

static void print_fit(void) {
  printf("/* SPDX-License-Identifier: Apache-2.0\n"
         " * Printed by fit-fiber-light. */\n"
         "#include \"fitted.h\"\n\n"
         "const fibertex_fitted *fibertex_fit(const double *made_of) {\n"
         "  (void)made_of;\n"
         "  static const fibertex_fitted fitted = {\n");
  print_row(".least", fitting->least, CLOTH_FEATURES);
  print_row(".most", fitting->most, CLOTH_FEATURES);
  print_row(".middle", fitting->middle, CLOTH_FEATURES);
  printf("      .amount = {\n");
  for (int a = 0; a < FIT_AMOUNTS; a++)
    print_amount("FIT", amounts[a], fitting->amount[a], CLOTH_FEATURES);
  printf("      },\n");
  print_row(".low", fitting->low, FIT_AMOUNTS);
  print_row(".high", fitting->high, FIT_AMOUNTS);
  print_row(".bulk_least", fitting->bulk_least, BULK_FEATURES);
  print_row(".bulk_most", fitting->bulk_most, BULK_FEATURES);
  print_row(".bulk_middle", fitting->bulk_middle, BULK_FEATURES);
  printf("      .bulk = {\n");
  for (int a = 0; a < BULK_AMOUNTS; a++)
    print_amount("BULK", bulk_amounts[a], fitting->bulk[a], BULK_FEATURES);
  printf("      }};\n  return &fitted;\n}\n");
}

/* What is left of the means, of each footprint: in percent. */
static void print_off(const char *name, const char *kind, int from, int step, const double *off,
                      const double *real, const double *chance, double asked) {
  fprintf(stderr, "%-10s%s", name, kind);
  for (int k = 0; k < 3; k++) {
    double sure_ = hypot(asked, chance[k] / real[k]) * 100;
    fprintf(stderr, "  (%.1f)", 100 * chance[k] / real[k]);
    for (int f = 0; f < SCALES; f++)
      fprintf(stderr, " %+5.1f", off[(f * 3 + k) * step + from] * sure_);
  }
  fprintf(stderr, "\n");
}

static void print_rest(void) {
  double off[RESIDUALS_MAX];
  looking = true;
  for (int s = 0; s < sample_count; s++) {
    const sample *q = &samples[s];
    const clothed *r = &q->real;
    const char *kind = q->preset ? "*" : q->held_out ? "-" : " ";
    double asked = q->preset ? sure : 12 * sure;
    cloth_off(s, off);
    print_off(q->of.preset, kind, 0, 2, off, r->albedo, r->albedo_chance, asked);
    print_off("", " ", 1, 2, off, r->mean, r->mean_chance, asked);
  }
  for (int s = 0; s < bulk_count; s++) {
    const bulk_sample *q = &bulks[s];
    bulk_off(s, off);
    print_off(q->is.name,
              q->held_out  ? "-"
              : q->variant ? " "
                           : "*",
              0, 1, off, q->real.mean, q->real.mean_chance, q->variant ? 2 * sure : sure);
    double square[3] = {0};
    for (int k = 0; k < 3; k++)
      for (int l = 0; l < SLAB_LOOKS; l++) {
        double sure_ = hypot(sure_of_look_in_bulk, q->real.chance[l][k] / q->real.mean[k]) * 100;
        square[k] += pow(off[3 * SCALES + k * SLAB_LOOKS + l] * sure_, 2) / SLAB_LOOKS;
      }
    fprintf(stderr, "          one by one %.0f %.0f %.0f\n", sqrt(square[0]), sqrt(square[1]),
            sqrt(square[2]));
  }
  bulk_off(bulk_count, off);
  double over = 0;
  for (int i = 0; i < ENERGIES; i++) over = fmax(over, off[i]);
  fprintf(stderr, "energy: over by %.4f\n", over * over_back);
  cloth_off(sample_count, off);
  for (int i = 0; i < ENERGIES; i++) over = fmax(over, off[i]);
  fprintf(stderr, "energy: over by %.4f\n", over * over_back);
}

int main(int count, char **arguments) {
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  assert_true(entry && entry->init("/nonexistent/sozai.so") == SOZAI_OK);
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  fitting = dlsym(library, "fiber_fitting");
  made_of = dlsym(library, "fiber_made_of");
  assert_true(fitting && made_of);
  if (count > 1) {
    kept = fopen(arguments[1], "a+b");
    assert_non_null(kept);
    rewind(kept);
  }
  if (count > 2) steps_of_bulks = atoi(arguments[2]);
  if (count > 3) steps_of_cloths = atoi(arguments[3]);
  fit_bulks();
  fit_cloths();
  if (kept) fclose(kept);
  print_rest();
  print_fit();
  return 0;
}
