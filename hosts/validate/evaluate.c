/* SPDX-License-Identifier: Apache-2.0
 * evaluate: what is written, and where. */
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "batch.h"
#include "groups.h"
#include "memory.h"

static bool has_textures(subject *s) {
  if (!subject_start(s)) return false;
  if (!s->textures) skipped("it has no texture");
  return s->textures != NULL;
}

static void each_of(subject *s, uint32_t presets, texture_test *test) {
  if (has_textures(s)) each_texture(s, presets, test);
}

/* "Answer a batch."; "Every written number is finite." */
static void answer(subject *s, const sozai_texture_info *info, const char *preset,
                   sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 257);
  if (b && batch_run(s, t, b, "all inputs"))
    for (uint32_t c = 0; c < info->component_count; c++) batch_written(b, c, 0, 257, "all inputs");
  batch_free(b);
}

static void answers(subject *s) { each_of(s, 0, answer); }
static void presets(subject *s) { each_of(s, 8, answer); }

/* Outputs are `count` long: nothing before or after is written. */
static void banded(subject *s, const sozai_texture_info *info, const char *preset,
                   sozai_texture *t) {
  static const uint32_t counts[] = {1,   2,   3,   4,   5,   7,   8,    9,    15,
                                    16,  17,  31,  32,  33,  63,  64,   65,   100,
                                    127, 128, 129, 255, 256, 257, 1000, 1024, 4097};
  batch *b = batch_new(s, info, preset, 1);
  for (uint32_t i = 0; b && i < COUNT_OF(counts) && !enough(); i++) {
    batch_from(b, 0, counts[i]);
    batch_mark(b);
    if (!batch_run(s, t, b, "guard bands round the outputs")) break;
    for (uint32_t c = 0; c < info->component_count; c++)
      batch_untouched(b, c, 0, counts[i], "outside of the batch");
  }
  batch_free(b);
}

static void guard_bands(subject *s) { each_of(s, 2, banded); }

/* ---- the ends of the arrays ------------------------------------------------------ */

/* Memory of `bytes` that ends where nothing may be read. */
static void *before_wall(size_t bytes) {
  size_t page = (size_t)sysconf(_SC_PAGESIZE), room = (bytes + page - 1) / page * page;
  if (!room) room = page;
  char *memory =
      mmap(NULL, room + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return NULL;
  mprotect(memory + room, page, PROT_NONE);
  return memory + room - bytes;
}

static void drop_wall(void *memory, size_t bytes) {
  size_t page = (size_t)sysconf(_SC_PAGESIZE), room = (bytes + page - 1) / page * page;
  if (!room) room = page;
  munmap((char *)memory - (room - bytes), room + page);
}

static void walled_batch(subject *s, sozai_texture *t, batch *b, uint32_t count, uint8_t *active) {
  size_t bytes = count * sizeof(float);
  float *in[BATCH_INPUTS], **out = calloc(b->info->component_count + 1, sizeof *out);
  sozai_batch *abi = before_wall(sizeof *abi);
  uint8_t *flags = before_wall(count);
  float **pointers = before_wall(b->info->component_count * sizeof *pointers);
  if (!out || !abi || !flags || !pointers) return failed("out of memory");
  for (uint32_t k = 0; k < BATCH_INPUTS; k++) {
    in[k] = before_wall(bytes);
    if (!in[k]) return failed("out of memory");
    memcpy(in[k], b->in[k], bytes);
  }
  for (uint32_t c = 0; c < b->info->component_count; c++) {
    pointers[c] = out[c] = before_wall(bytes);
    if (!out[c]) return failed("out of memory");
  }
  memcpy(flags, active, count);
  *abi = (sozai_batch){.size = sizeof *abi,
                       .count = count,
                       .point = {in[0], in[1], in[2]},
                       .normal = {in[3], in[4], in[5]},
                       .light = {in[6], in[7], in[8]},
                       .light_colour = {in[9], in[10], in[11]},
                       .view = {in[12], in[13], in[14]},
                       .footprint = in[15],
                       .active = flags,
                       .out = pointers,
                       .out_count = b->info->component_count};
  doing("evaluate of %s, %u points, walls after every array", b->name, count);
  int32_t r = s->textures->evaluate(t, abi);
  EXPECT(r == SOZAI_OK, "%s: evaluate gave %s", b->name, result_name(r));
  for (uint32_t k = 0; k < BATCH_INPUTS; k++) drop_wall(in[k], bytes);
  for (uint32_t c = 0; c < b->info->component_count; c++) drop_wall(out[c], bytes);
  drop_wall(abi, sizeof *abi);
  drop_wall(flags, count);
  drop_wall(pointers, b->info->component_count * sizeof *pointers);
  free(out);
}

/* "each array `count` long": neither read nor written past it. Here the process would die. */
static void walled(subject *s, const sozai_texture_info *info, const char *preset,
                   sozai_texture *t) {
  static const uint32_t counts[] = {1, 2, 3, 5, 7, 8, 9, 13, 16, 17, 31, 33, 63, 64, 65, 100, 1023};
  static uint8_t active[BATCH_MOST];
  batch *b = batch_new(s, info, preset, 1);
  memset(active, 1, sizeof active);
  for (uint32_t i = 0; b && i < COUNT_OF(counts); i++) walled_batch(s, t, b, counts[i], active);
  batch_free(b);
}

static void guard_pages(subject *s) { each_of(s, 1, walled); }

/* ---- what is not wanted ------------------------------------------------------------ */

/* "NULL where not wanted": each channel alone, which gives what it gave with all. */
static void channel_alone(subject *s, const sozai_texture_info *info, const char *preset,
                          sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 200);
  float *all = b && batch_run(s, t, b, "all channels") ? batch_answers(b) : NULL;
  for (uint32_t h = 0; all && h < info->channel_count && !enough(); h++) {
    const sozai_channel *channel = info->channels[h];
    batch_want(b, channel);
    batch_mark(b);
    if (!batch_run(s, t, b, channel->id)) continue;
    for (uint32_t c = 0; c < info->component_count; c++) {
      if (channel_of(info, c) == channel)
        batch_same(b, all, c, 0, 200, "and alone");
      else
        batch_untouched(b, c, 0, 0, "and not wanted");
    }
  }
  free(all);
  batch_free(b);
}

static void alone(subject *s) { each_of(s, 2, channel_alone); }

/* The same of some components of a channel, and of channels by chance. */
static void some_components(subject *s, const sozai_texture_info *info, const char *preset,
                            sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 130);
  float *all = b && batch_run(s, t, b, "all channels") ? batch_answers(b) : NULL;
  for (uint32_t round = 0; all && round < 24 && !enough(); round++) {
    bool wanted[1024] = {false};
    uint32_t n = info->component_count < 1024 ? info->component_count : 1024;
    for (uint32_t c = 0; c < n; c++) {
      wanted[c] = round % 2 ? c == round / 2 % n : chance_below(s, 2) != 0;
      b->out[c] = wanted[c] ? b->memory + batch_place(c, 0) : NULL;
    }
    batch_mark(b);
    if (!batch_run(s, t, b, "some components")) break;
    for (uint32_t c = 0; c < n; c++) {
      if (wanted[c])
        batch_same(b, all, c, 0, 130, "and among some components");
      else
        batch_untouched(b, c, 0, 0, "and not wanted");
    }
  }
  free(all);
  batch_free(b);
}

static void components(subject *s) { each_of(s, 2, some_components); }

/* ---- lanes --------------------------------------------------------------------------- */

static void check_lanes(subject *s, sozai_texture *t, batch *b, const float *all,
                        const uint8_t *active, uint32_t count) {
  batch_from(b, 0, count);
  b->abi.active = active;
  batch_mark(b);
  float *marked = batch_answers(b);
  if (marked && batch_run(s, t, b, "some points inactive"))
    for (uint32_t c = 0; c < b->info->component_count && !enough(); c++) {
      batch_untouched(b, c, 0, count, "outside of the batch");
      for (uint32_t i = 0; i < count; i++) {
        const char *what =
            active[i] ? "and with others inactive" : "before, written though inactive";
        if (!batch_same(b, active[i] ? all : marked, c, i, 1, what)) break;
      }
    }
  free(marked);
}

/* "0: leave that point's outputs untouched" */
static void inactive_lanes(subject *s, const sozai_texture_info *info, const char *preset,
                           sozai_texture *t) {
  static uint8_t active[BATCH_MOST];
  batch *b = batch_new(s, info, preset, 300);
  float *all = b && batch_run(s, t, b, "all active") ? batch_answers(b) : NULL;
  for (uint32_t round = 0; all && round < 14 && !enough(); round++) {
    uint32_t count = round < 6 ? 1 + 13 * round : 1 + chance_below(s, 300);
    for (uint32_t i = 0; i < count; i++)
      active[i] = round == 6 ? 0 : round == 7 ? i == count - 1 : (uint8_t)chance_below(s, 2);
    check_lanes(s, t, b, all, active, count);
  }
  free(all);
  batch_free(b);
}

static void inactive(subject *s) { each_of(s, 2, inactive_lanes); }

/* Any number but 0 is active. */
static void active_numbers(subject *s, const sozai_texture_info *info, const char *preset,
                           sozai_texture *t) {
  static uint8_t active[BATCH_MOST];
  batch *b = batch_new(s, info, preset, 255);
  float *all = b && batch_run(s, t, b, "all active") ? batch_answers(b) : NULL;
  for (uint32_t i = 0; i < 255; i++) active[i] = (uint8_t)(i + 1);
  if (all) check_lanes(s, t, b, all, active, 255);
  free(all);
  batch_free(b);
}

static void active_any(subject *s) { each_of(s, 0, active_numbers); }

/* ---- what is only read ------------------------------------------------------------------ */

static void only_read(subject *s, const sozai_texture_info *info, const char *preset,
                      sozai_texture *t) {
  static uint8_t active[BATCH_MOST], active_before[BATCH_MOST];
  batch *b = batch_new(s, info, preset, 500);
  if (!b) return;
  size_t n = BATCH_INPUTS * BATCH_MOST, outs = info->component_count * sizeof *b->out;
  float *before = malloc(n * sizeof *before);
  float **out_before = malloc(outs ? outs : 1);
  for (uint32_t i = 0; i < 500; i++) active_before[i] = active[i] = (uint8_t)chance_below(s, 2);
  /* What evaluate reads in another way than it is given. */
  b->in[0][3] = 1e30f;
  b->in[3][5] = b->in[4][5] = b->in[5][5] = 0;
  b->in[15][7] = -1;
  b->abi.active = active;
  if (before && out_before) {
    memcpy(before, b->in[0], n * sizeof *before);
    memcpy(out_before, b->out, outs);
    sozai_batch kept = b->abi;
    if (batch_run(s, t, b, "inputs kept")) {
      EXPECT(memcmp(before, b->in[0], n * sizeof *before) == 0, "%s: an input was changed",
             b->name);
      EXPECT(memcmp(active, active_before, sizeof active) == 0, "%s: active was changed", b->name);
      EXPECT(memcmp(out_before, b->out, outs) == 0, "%s: the pointers of out were changed",
             b->name);
      EXPECT(memcmp(&kept, &b->abi, sizeof kept) == 0, "%s: the batch was changed", b->name);
    }
  } else {
    failed("out of memory");
  }
  free(before);
  free(out_before);
  batch_free(b);
}

static void inputs_kept(subject *s) { each_of(s, 1, only_read); }

/* ---- what it may not do -------------------------------------------------------------------- */

static void unwatched(subject *s, const sozai_texture_info *info, const char *preset,
                      sozai_texture *t, bool locks) {
  batch *b = batch_new(s, info, preset, 1);
  for (uint32_t round = 0; b && round < 40; round++) {
    batch_from(b, 0, round < 4 ? round : 1 + chance_below(s, 3000));
    doing("evaluate of %s, watched", b->name);
    uint64_t calls = memory_calls(), taken = memory_locks();
    int32_t r = s->textures->evaluate(t, &b->abi);
    uint64_t more = locks ? memory_locks() - taken : memory_calls() - calls;
    if (!EXPECT(!more && r == SOZAI_OK, "%s: evaluate of %u points %s %llu times", b->name,
                b->abi.count, locks ? "locked" : "allocated", (unsigned long long)more))
      break;
  }
  batch_free(b);
}

static void no_memory(subject *s, const sozai_texture_info *info, const char *preset,
                      sozai_texture *t) {
  unwatched(s, info, preset, t, false);
}

static void no_lock(subject *s, const sozai_texture_info *info, const char *preset,
                    sozai_texture *t) {
  unwatched(s, info, preset, t, true);
}

/* "allocates nothing, locks nothing" */
static void allocates(subject *s) {
  if (!memory_watched()) {
    skipped("a sanitizer has the allocator");
    return;
  }
  each_of(s, 3, no_memory);
}

static void locks(subject *s) {
  if (!memory_watched()) {
    skipped("a sanitizer has the locks");
    return;
  }
  each_of(s, 3, no_lock);
}

CHECKS(evaluate, //
       {"evaluate.answers", "create.default", "evaluate writes every wanted number, all finite",
        answers},
       {"evaluate.presets", "evaluate.answers", "so it does of presets", presets},
       {"evaluate.guard-bands", "evaluate.answers", "nothing is written before or after an output",
        guard_bands},
       {"evaluate.guard-pages", "evaluate.answers", "nothing is read or written past any array",
        guard_pages},
       {"evaluate.alone", "evaluate.answers",
        "a channel alone has the bits that it has with all, and no other is written", alone},
       {"evaluate.components", "evaluate.answers", "so have components by chance", components},
       {"evaluate.inactive", "evaluate.answers",
        "inactive points are left untouched, others answered as ever", inactive},
       {"evaluate.active-any", "evaluate.answers", "any number but 0 is active", active_any},
       {"evaluate.inputs-kept", "evaluate.answers", "no input is changed", inputs_kept},
       {"evaluate.allocates-nothing", "evaluate.answers", "evaluate allocates nothing", allocates},
       {"evaluate.locks-nothing", "evaluate.answers", "evaluate locks nothing", locks});
