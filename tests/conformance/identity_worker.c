/* SPDX-License-Identifier: Apache-2.0
 *
 * identity_worker PLUGIN WAY...
 * WAY: POINTS,BATCH,THREADS[,misaligned][,masked][,subset][,flushed]
 *
 * Evaluates, in each of the ways in turn, POINTS points (whole blocks of them)
 * and prints a line of their number, a hash over every bit of every answer, and
 * the instruction set. The hash is a sum over points and components, so neither
 * the order nor the way in which the points are cut into batches is in it. One
 * process for all ways, because making the textures takes longer than most of
 * them. Exits 1 when something is wrong, 77 when the plugin says that this
 * machine lacks what SOZAI_CPU asks for.
 */
#include <inttypes.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "identity_points.h"

#define TEXTURES_MAX 256
#define THREADS_MOST 64u
#define PIECES 16u /* a block is cut into at most so many, for the threads */

static plugin host;
static sozai_texture *textures[TEXTURES_MAX];
static uint32_t texture_count, wood_count, stone_count;

static uint64_t blocks;
static uint32_t batch_size;
static int misaligned, masked, subset, flushed;
static atomic_ullong next_piece, total, evaluated;
static atomic_int failed;

/* Where an array of n floats may begin, for the misaligned. */
typedef struct {
  float in[IN_COUNT][BLOCK];
  float pool[(IN_COUNT + COMPONENTS) * (BLOCK + 16u)];
  uint8_t active[BLOCK];
} work;

static float *slice(work *w, uint32_t which, uint32_t shift) {
  float *base = w->pool + which * (size_t)(BLOCK + 16u);
  return misaligned ? base + (shift + which * 5u) % 16u : base;
}

static void give_up(const char *why) {
  fprintf(stderr, "%s\n", why);
  atomic_store(&failed, 1);
}

/* ---- the textures ------------------------------------------------------ */

/* Only those that a block asks: first all are counted, then these are made. */
static int counting;
static uint8_t asked[TEXTURES_MAX];

static int make(const char *id, const char *preset, const sozai_value *values, uint32_t count) {
  if (texture_count == TEXTURES_MAX) return 0;
  if (counting || !asked[texture_count]) {
    texture_count++;
    return 0;
  }
  int32_t r = host.textures->create(NULL, id, preset, values, count, &textures[texture_count]);
  if (r == SOZAI_ERROR_UNSUPPORTED) return 77;
  if (r != SOZAI_OK) {
    fprintf(stderr, "create: %s\n", host.textures->last_error());
    return 1;
  }
  texture_count++;
  return 0;
}

static const char *const surfaces[] = {"smooth",  "band_sawn",   "circular_sawn",
                                       "planed",  "hand_planed", "sanded",
                                       "brushed", "charred",     "weathered"};
static const char *const finishes[] = {"raw", "oiled", "lacquered"};

/* Whose branches are knots. */
static const char *const trees[] = {"", "sugi", "akamatsu", "keyaki"};

/* Every fourth preset, with every kind of slope, surface, finish and tree. */
static int make_woods(void) {
  static const char *const cuts[] = {"log", "flat", "quarter", "rift", "end"};
  const sozai_texture_info *info = host.textures->find("wood");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i <= info->preset_count; i += 4) {
    const sozai_value values[] = {
        {.id = "grain", .kind = SOZAI_KIND_CHOICE, .text = "compound"},
        {.id = "cut", .kind = SOZAI_KIND_CHOICE, .text = cuts[i / 4u % 5u]},
        {.id = "cut_rotation", .kind = SOZAI_KIND_FLOAT, .number = {i / 20u * 33.0}},
        {.id = "wave_irregularity", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 3u * 0.3}},
        /* within reach of the points */
        {.id = "heartwood_years",
         .kind = SOZAI_KIND_FLOAT,
         .number = {10.0 + 10.0 * (i / 4u % 4u)}},
        {.id = "coat", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 3u * 0.5}},
        {.id = "reflection",
         .kind = SOZAI_KIND_CHOICE,
         .text = i / 4u % 2u ? "fibre_cone" : "kawai"},
        {.id = "surface", .kind = SOZAI_KIND_CHOICE, .text = surfaces[i / 4u % 9u]},
        {.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = finishes[i / 4u % 3u]},
        {.id = "age_years", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 2u * 7.0}},
        {.id = "streak_share", .kind = SOZAI_KIND_FLOAT, .number = {i / 4u % 4u * 0.01}},
        {.id = "mark_angle", .kind = SOZAI_KIND_FLOAT, .number = {i % 3u * 30.0}},
        {.id = "tree", .kind = SOZAI_KIND_TEXT, .text = trees[i / 4u % 4u]},
        {.id = "log_height", .kind = SOZAI_KIND_FLOAT, .number = {2000.0 + 500.0 * (i % 7u)}}};
    r = make("wood", i ? info->presets[i - 1]->id : NULL, values, 14);
  }
  return r;
}

/* Each way of finding a unit, with everything that a layout can have. */
static int make_layouts(void) {
  static const char *const layouts[] = {"strip",   "herringbone", "versailles", "hexagon",
                                        "ashlar",  "crazy",       "arcs",       "circles",
                                        "chevron", "end_grain"};
  static const char *const flips[] = {"random", "alternate", "none"};
  const sozai_texture_info *info = host.textures->find("wood");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i < sizeof layouts / sizeof *layouts; i++) {
    const sozai_value values[] = {
        {.id = "layout", .kind = SOZAI_KIND_CHOICE, .text = layouts[i]},
        {.id = "layout_rotation", .kind = SOZAI_KIND_FLOAT, .number = {17.0 * i}},
        {.id = "bevel", .kind = SOZAI_KIND_FLOAT, .number = {0.5 * i}},
        {.id = "cupping", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.7}},
        {.id = "board_flip", .kind = SOZAI_KIND_CHOICE, .text = flips[i % 3u]},
        {.id = "grain", .kind = SOZAI_KIND_CHOICE, .text = "compound"},
        {.id = "reflection", .kind = SOZAI_KIND_CHOICE, .text = i % 2u ? "fibre_cone" : "kawai"},
        {.id = "surface", .kind = SOZAI_KIND_CHOICE, .text = surfaces[(i + 1u) % 9u]},
        {.id = "tree", .kind = SOZAI_KIND_TEXT, .text = trees[i % 4u]}};
    r = make("wood", info->presets[i % info->preset_count]->id, values, 9);
  }
  return r;
}

/* Every third preset, which among them have all that a stone can have, every
 * finish, most layouts and weathers, and both of the paper's modes of colour,
 * with a tile and without. */
static int make_stones(void) {
  static const char *const worked[] = {"split", "flamed", "bush_hammered",
                                       "sawn",  "honed",  "polished"};
  static const char *const modes[] = {"paper_rgb", "paper_lightness"};
  static const char *const beds[] = {"x", "y", "z"};
  static const char *const layouts[] = {"none", "fan",    "crazy", "chidori", "hexagon",
                                        "arcs", "ashlar", "stack", "circles", "herringbone"};
  static const char *const patterns[] = {"igeta", "chidori"};
  const sozai_texture_info *info = host.textures->find("stone");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i < info->preset_count; i += 3) {
    const sozai_value values[] = {
        {.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = worked[i / 3 % 6u]},
        {.id = "bed", .kind = SOZAI_KIND_CHOICE, .text = beds[i / 3 % 3u]},
        {.id = "hole_share", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.05}},
        {.id = "vein_width", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u ? 0.0 : 4.0}},
        {.id = "layout", .kind = SOZAI_KIND_CHOICE, .text = layouts[i / 3 % 10u]},
        {.id = "stone_length", .kind = SOZAI_KIND_FLOAT},
        {.id = "stone_width", .kind = SOZAI_KIND_FLOAT},
        {.id = "joint_width", .kind = SOZAI_KIND_FLOAT, .number = {9}},
        {.id = "joint_wander", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.05}},
        {.id = "corner_radius", .kind = SOZAI_KIND_FLOAT, .number = {4.0 + i % 3u}},
        {.id = "edge_round", .kind = SOZAI_KIND_FLOAT, .number = {5}},
        {.id = "bevel", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 2.0}},
        {.id = "tilt", .kind = SOZAI_KIND_FLOAT, .number = {2}},
        {.id = "moss", .kind = SOZAI_KIND_FLOAT, .number = {i % 4u * 0.2}},
        {.id = "wet", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.7}},
        {.id = "water_level", .kind = SOZAI_KIND_FLOAT, .number = {i % 3u ? -1000.0 : -2.0}},
        {.id = "wear", .kind = SOZAI_KIND_FLOAT, .number = {i % 2u * 0.5}}};
    r = make("stone", info->presets[i]->id, values, sizeof values / sizeof *values);
  }
  for (int i = 0; !r && i < 2; i++) {
    const sozai_value values[] = {
        {.id = "colour_mode", .kind = SOZAI_KIND_CHOICE, .text = modes[i]},
        {.id = "paper_black", .kind = SOZAI_KIND_FLOAT, .number = {0.1}},
        {.id = "paper_white", .kind = SOZAI_KIND_FLOAT, .number = {0.1}},
        {.id = "paper_pattern", .kind = SOZAI_KIND_CHOICE, .text = patterns[i]}};
    r = make("stone", NULL, values, 3);
    if (!r) r = make("stone", NULL, values, 4);
  }
  return r;
}

/* Every preset of fibre, along each axis, matted, standing and woven. */
static int make_fibers(void) {
  static const char *const along[] = {"x", "y", "z"};
  static const char *const weaves[] = {"plain",     "basket",    "twill_2_1",
                                       "twill_3_1", "twill_2_2", "satin"};
  const sozai_texture_info *info = host.textures->find("fiber");
  int r = info ? 0 : 1;
  for (uint32_t i = 0; !r && i < info->preset_count; i++) {
    const sozai_value values[] = {
        {.id = "axis", .kind = SOZAI_KIND_CHOICE, .text = along[i % 3u]},
        {.id = "weave", .kind = SOZAI_KIND_CHOICE, .text = weaves[i % 6u]},
        {.id = "flyaway", .kind = SOZAI_KIND_FLOAT, .number = {i % 4u * 0.05}},
        {.id = "elevation", .kind = SOZAI_KIND_FLOAT, .number = {i % 5u * 15.0}}};
    r = make("fiber", info->presets[i]->id, values, sizeof values / sizeof *values);
  }
  return r;
}

/* A block's texture: of 64 blocks 60 are wood's, 3 fibre's and one stone's, since a
 * stone under a wide footprint takes many times as long. */
static uint32_t number_of(uint64_t block) {
  uint32_t others = wood_count + stone_count;
  if (block % 16 < 15) return (uint32_t)((block - block / 16) % wood_count);
  if (block % 64 == 63) return wood_count + (uint32_t)(block / 64 % stone_count);
  return others + (uint32_t)((block / 16 - block / 64) % (texture_count - others));
}

static sozai_texture *texture_of(uint64_t block) { return textures[number_of(block)]; }

static const sozai_texture_info *info_of(uint64_t block) {
  return host.textures->info_of(texture_of(block));
}

/* ---- hashing ----------------------------------------------------------- */

static uint64_t hash_of(uint64_t point, uint32_t component, float x) {
  uint32_t bits;
  memcpy(&bits, &x, sizeof bits);
  uint64_t key = (point * COMPONENTS + component) * 0x9e3779b97f4a7c15u;
  key ^= key >> 32;
  key = (key ^ bits) * 0xd6e8feb86659fd93u;
  key ^= key >> 32;
  return key * 0xd6e8feb86659fd93u;
}

#define UNTOUCHED 0x7fa5a5a5u /* a NaN that no arithmetic makes */

static float untouched(void) {
  uint32_t bits = UNTOUCHED;
  float f;
  memcpy(&f, &bits, sizeof f);
  return f;
}

static int is_untouched(float x) {
  uint32_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits == UNTOUCHED;
}

/* ---- one batch --------------------------------------------------------- */

typedef struct {
  work *w;
  uint64_t block;
  uint32_t from, count, inputs, shift;
} span;

static const float *input(const span *s, int which, uint32_t bit) {
  if (!(s->inputs & bit)) return NULL;
  float *to = slice(s->w, (uint32_t)which, s->shift);
  memcpy(to, s->w->in[which] + s->from, s->count * sizeof *to);
  return to;
}

/* Evaluates the channels of `channels` for the active points; the hash. */
static uint64_t ask(const span *s, uint32_t channels, const uint8_t *active) {
  const sozai_texture_info *info = info_of(s->block);
  float *out[COMPONENTS] = {0};
  for (uint32_t c = 0; c < info->channel_count; c++) {
    const sozai_channel *k = info->channels[c];
    if (!(channels >> c & 1u) || k->needs & ~s->inputs) continue;
    for (uint32_t o = k->first; o < k->first + k->components; o++) {
      out[o] = slice(s->w, IN_COUNT + o, s->shift + 3u);
      for (uint32_t i = 0; i < s->count; i++) out[o][i] = untouched();
    }
  }
  sozai_batch b = {.size = sizeof b,
                   .count = s->count,
                   .active = active,
                   .out = out,
                   .out_count = info->component_count,
                   .footprint = input(s, IN_FOOTPRINT, SOZAI_INPUT_FOOTPRINT)};
  for (int c = 0; c < 3; c++) {
    b.point[c] = input(s, IN_POINT + c, SOZAI_INPUT_POINT);
    b.normal[c] = input(s, IN_NORMAL + c, SOZAI_INPUT_NORMAL);
    b.light[c] = input(s, IN_LIGHT + c, SOZAI_INPUT_LIGHT);
    b.light_colour[c] = input(s, IN_LIGHT_COLOUR + c, SOZAI_INPUT_LIGHT_COLOUR);
    b.view[c] = input(s, IN_VIEW + c, SOZAI_INPUT_VIEW);
  }
  if (host.textures->evaluate(texture_of(s->block), &b) != SOZAI_OK) {
    give_up(host.textures->last_error());
  }
  uint64_t sum = 0;
  uint64_t first = s->block * BLOCK + s->from;
  for (uint32_t o = 0; o < info->component_count; o++) {
    for (uint32_t i = 0; out[o] && i < s->count; i++) {
      if (active && !active[i]) {
        if (!is_untouched(out[o][i])) give_up("the output of an inactive point was written");
      } else {
        if (!isfinite(out[o][i])) give_up("an output is not finite, or was not written");
        sum += hash_of(first + i, o, out[o][i]);
      }
    }
  }
  return sum;
}

/* With a mask: some points, then the others. */
static uint64_t ask_masked(const span *s, uint32_t channels) {
  if (!masked) return ask(s, channels, NULL);
  uint64_t r = mix64(s->block * BLOCK + s->from);
  for (uint32_t i = 0; i < s->count; i++) {
    if (i % 64u == 0) r = mix64(r);
    s->w->active[i] = (uint8_t)(r >> (i % 64u) & 1u) ? (uint8_t)(1u + i % 255u) : 0;
  }
  uint64_t sum = ask(s, channels, s->w->active);
  for (uint32_t i = 0; i < s->count; i++) s->w->active[i] = !s->w->active[i];
  return sum + ask(s, channels, s->w->active);
}

/* With subsets: the channels dealt out at random to three calls. */
static uint64_t answer(const span *s) {
  if (!subset) return ask_masked(s, ~0u);
  uint32_t part[3] = {0, 0, 0};
  for (uint32_t c = 0; c < info_of(s->block)->channel_count; c++) {
    part[mix64(s->block * 77 + s->from + c * 1000003ull) % 3u] |= 1u << c;
  }
  uint64_t sum = 0;
  for (int k = 0; k < 3; k++) {
    if (part[k]) sum += ask_masked(s, part[k]);
  }
  return sum;
}

/* ---- the threads, each taking random pieces of the blocks -------------- */

static uint32_t cut(uint64_t block, uint32_t piece) {
  if (piece == 0) return 0;
  if (piece == PIECES) return BLOCK;
  /* sorted without sorting: a random place within each sixteenth */
  return piece * (BLOCK / PIECES) + (uint32_t)(mix64(block * PIECES + piece) % (BLOCK / PIECES));
}

static void *thread(void *one) {
  const int alone = *(const int *)one;
  const uint32_t pieces = alone ? 1 : PIECES;
#if defined(__x86_64__)
  /* denormals are zero, as renderers set it for their threads */
  if (flushed) __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040u);
#endif
  work *w = malloc(sizeof *w);
  uint64_t sum = 0, count = 0, made = ~0ull;
  for (;;) {
    uint64_t piece = atomic_fetch_add(&next_piece, 1), block = piece / pieces;
    if (block >= blocks || atomic_load(&failed)) break;
    if (block != made) points_make(made = block, w->in);
    uint32_t k = (uint32_t)(piece % pieces);
    uint32_t from = alone ? 0 : cut(block, k), to = alone ? BLOCK : cut(block, k + 1);
    for (uint32_t i = from; i < to; i += batch_size) {
      span s = {w, block, i, to - i < batch_size ? to - i : batch_size, points_inputs(block), i};
      sum += answer(&s);
      count += s.count;
    }
  }
  atomic_fetch_add(&total, sum);
  atomic_fetch_add(&evaluated, count);
  free(w);
  return NULL;
}

static uint64_t blocks_of(const char *way) { return (strtoull(way, NULL, 10) + BLOCK - 1) / BLOCK; }

/* One way, and its line. */
static int go(const char *way) {
  blocks = blocks_of(way);
  unsigned threads = 0;
  if (sscanf(way, "%*u,%" SCNu32 ",%u", &batch_size, &threads) != 2) return 2;
  if (!batch_size || !threads || threads > THREADS_MOST) return 2;
  misaligned = strstr(way, ",misaligned") != NULL;
  masked = strstr(way, ",masked") != NULL;
  subset = strstr(way, ",subset") != NULL;
  flushed = strstr(way, ",flushed") != NULL;
  atomic_store(&next_piece, 0);
  atomic_store(&total, 0);
  atomic_store(&evaluated, 0);
  int alone = threads == 1;
  pthread_t list[THREADS_MOST];
  for (uint32_t t = 0; t < threads; t++) pthread_create(&list[t], NULL, thread, &alone);
  for (uint32_t t = 0; t < threads; t++) pthread_join(list[t], NULL);
  printf("%llu %016llx %s\n", (unsigned long long)atomic_load(&evaluated),
         (unsigned long long)atomic_load(&total), host.textures->instruction_set(textures[0]));
  fflush(stdout);
  return atomic_load(&failed);
}

static int make_all(void) {
  texture_count = 0;
  int r = make_woods();
  if (!r) r = make_layouts();
  wood_count = texture_count;
  if (!r) r = make_stones();
  stone_count = texture_count - wood_count;
  return r ? r : make_fibers();
}

int main(int argc, char **argv) {
  if (argc < 3) return 2;
  if (plugin_start(&host, argv[1])) return 1;
  counting = 1;
  int r = make_all();
  for (int i = 2; !r && i < argc; i++) {
    uint64_t count = blocks_of(argv[i]);
    for (uint64_t block = 0; block < count; block++) asked[number_of(block)] = 1;
  }
  counting = 0;
  if (!r) r = make_all();
  if (r) return r;
  for (uint32_t i = 0; i < texture_count; i++) {
    if (!textures[i]) continue;
    const sozai_texture_info *info = host.textures->info_of(textures[i]);
    if (info->component_count > COMPONENTS || info->channel_count > 32) return 1;
  }
  for (int i = 2; !r && i < argc; i++) r = go(argv[i]);
  for (uint32_t i = 0; i < texture_count; i++)
    if (textures[i]) host.textures->destroy(textures[i]);
  plugin_stop(&host);
  return r;
}
