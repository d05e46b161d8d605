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
#include "identity_textures.h"

#define THREADS_MOST 64u
#define PIECES 16u /* a block is cut into at most so many, for the threads */

static plugin host;
static uint64_t blocks;
static uint32_t batch_size;
static int misaligned, masked, subset, flushed;
static atomic_ullong next_piece, total, evaluated;
static atomic_int failed;

/* A thread's own: its block's points, and room for what a batch takes and gives. */
typedef struct {
  float in[IN_COUNT][BLOCK];
  float pool[(IN_COUNT + COMPONENTS) * (BLOCK + 16u)];
  uint8_t active[BLOCK];
} work;

/* Room for one array of a batch; of a misaligned one, beginning at any float. */
static float *slice(work *w, uint32_t which, uint32_t shift) {
  float *base = w->pool + which * (size_t)(BLOCK + 16u);
  return misaligned ? base + (shift + which * 5u) % 16u : base;
}

static void give_up(const char *why) {
  fprintf(stderr, "%s\n", why);
  atomic_store(&failed, 1);
}

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

/* Every eighth point is seen almost squarely, as by a camera that faces it: from 2^-20 to 2^-8 off
 * the normal. */
static void look_squarely(uint64_t block, float (*in)[BLOCK]) {
  for (uint32_t i = 0; i < BLOCK; i += 8) {
    float aside = ldexpf(1.0f, -8 - (int)(mix64(block * BLOCK + i) % 13u));
    for (int c = 0; c < 3; c++)
      in[IN_VIEW + c][i] = in[IN_NORMAL + c][i] + aside * in[IN_NORMAL + (c + 1) % 3][i];
  }
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
  if (!w) {
    give_up("out of memory");
    return NULL;
  }
  uint64_t sum = 0, count = 0, made = ~0ull;
  for (;;) {
    uint64_t piece = atomic_fetch_add(&next_piece, 1), block = piece / pieces;
    if (block >= blocks || atomic_load(&failed)) break;
    if (block != made) {
      points_make(made = block, w->in);
      look_squarely(block, w->in);
    }
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

/* The whole blocks that a way's points are of. */
static uint64_t blocks_of(const char *way) { return (strtoull(way, NULL, 10) + BLOCK - 1) / BLOCK; }

/* One way, and its line. 2: it is none. */
static int go(const char *way) {
  blocks = blocks_of(way);
  unsigned threads = 0;
  if (sscanf(way, "%*u,%" SCNu32 ",%u", &batch_size, &threads) != 2) return 2;
  if (!blocks || !batch_size || !threads || threads > THREADS_MOST) return 2;
  misaligned = strstr(way, ",misaligned") != NULL;
  masked = strstr(way, ",masked") != NULL;
  subset = strstr(way, ",subset") != NULL;
  flushed = strstr(way, ",flushed") != NULL;
  atomic_store(&next_piece, 0);
  atomic_store(&total, 0);
  atomic_store(&evaluated, 0);
  int alone = threads == 1;
  pthread_t list[THREADS_MOST];
  uint32_t running = 0;
  while (running < threads && pthread_create(&list[running], NULL, thread, &alone) == 0) running++;
  if (running < threads) give_up("a thread could not be started");
  for (uint32_t t = 0; t < running; t++) pthread_join(list[t], NULL);
  printf("%llu %016llx %s\n", (unsigned long long)atomic_load(&evaluated),
         (unsigned long long)atomic_load(&total), host.textures->instruction_set(texture_of(0)));
  fflush(stdout);
  return atomic_load(&failed);
}

int main(int argc, char **argv) {
  if (argc < 3) return 2;
  if (plugin_start(&host, argv[1])) return 1;
  uint64_t most = 0;
  for (int i = 2; i < argc; i++)
    if (blocks_of(argv[i]) > most) most = blocks_of(argv[i]);
  int r = textures_make(&host, most);
  for (int i = 2; !r && i < argc; i++) r = go(argv[i]);
  textures_free();
  plugin_stop(&host);
  return r;
}
