/* SPDX-License-Identifier: Apache-2.0
 * evaluate: which inputs are needed and used, and how odd ones are read. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "batch.h"
#include "groups.h"

#define ALL 0x3fu
#define POINTS 120u

/* ---- needs and uses ---------------------------------------------------------------- */

/* "ARGUMENT if a wanted channel needs an input that is NULL", "checked before any output is
 * written" */
static void without_need(subject *s, const sozai_texture_info *info, const char *preset,
                         sozai_texture *t) {
  batch *b = batch_new(s, info, preset, POINTS);
  for (uint32_t h = 0; b && h < info->channel_count && !enough(); h++)
    for (uint32_t i = 0; i < 6; i++) {
      const sozai_channel *channel = info->channels[h];
      if (!(channel->needs & batch_inputs[i].bit)) continue;
      for (uint32_t all = 0; all < 2; all++) {
        batch_from(b, 0, POINTS);
        batch_give(b, ALL & ~batch_inputs[i].bit);
        if (!all) batch_want(b, channel);
        batch_mark(b);
        doing("evaluate of %s, %s without %s", b->name, channel->id,
              input_name(batch_inputs[i].bit));
        int32_t r = s->textures->evaluate(t, &b->abi);
        EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: %s without the %s that it needs gave %s", b->name,
               channel->id, input_name(batch_inputs[i].bit), result_name(r));
        for (uint32_t c = 0; r != SOZAI_OK && c < info->component_count; c++)
          batch_untouched(b, c, 0, 0, "though the batch was refused");
      }
    }
  batch_free(b);
}

static void needs(subject *s) { start_each_texture(s, 1, without_need); }

/* One pointer of three missing is a missing input. */
static void without_part(subject *s, const sozai_texture_info *info, const char *preset,
                         sozai_texture *t) {
  batch *b = batch_new(s, info, preset, POINTS);
  for (uint32_t h = 0; b && h < info->channel_count && !enough(); h++)
    for (uint32_t part = 0; part < 15; part++) {
      const sozai_channel *channel = info->channels[h];
      if (!(channel->needs & batch_inputs[part / 3].bit)) continue;
      batch_from(b, 0, POINTS);
      batch_want(b, channel);
      const float **of[5] = {b->abi.point, b->abi.normal, b->abi.light, b->abi.light_colour,
                             b->abi.view};
      of[part / 3][part % 3] = NULL;
      doing("evaluate of %s, %s with part %u of %s missing", b->name, channel->id, part % 3,
            input_name(batch_inputs[part / 3].bit));
      int32_t r = s->textures->evaluate(t, &b->abi);
      EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: %s with part %u of %s missing gave %s", b->name,
             channel->id, part % 3, input_name(batch_inputs[part / 3].bit), result_name(r));
    }
  batch_free(b);
}

static void parts(subject *s) { start_each_texture(s, 0, without_part); }

/* "An input that a channel only `uses` may be NULL"; what unwanted channels need too. */
static void only_needs(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  batch *b = batch_new(s, info, preset, POINTS);
  for (uint32_t h = 0; b && h < info->channel_count && !enough(); h++) {
    const sozai_channel *channel = info->channels[h];
    batch_from(b, 0, POINTS);
    batch_give(b, channel->needs);
    batch_want(b, channel);
    batch_mark(b);
    if (!batch_run(s, t, b, "with the inputs alone that a channel needs")) continue;
    for (uint32_t k = 0; k < channel->components; k++)
      batch_written(b, channel->first + k, 0, POINTS, "with what it needs alone");
  }
  batch_free(b);
}

static void uses_absent(subject *s) { start_each_texture(s, 2, only_needs); }

/* What a channel neither needs nor uses does not change it. */
static void undeclared_of(subject *s, const sozai_texture_info *info, const char *preset,
                          sozai_texture *t) {
  batch *b = batch_new(s, info, preset, POINTS);
  float *was = b && batch_run(s, t, b, "all inputs") ? batch_answers(b) : NULL;
  for (uint32_t i = 0; was && i < 6 && !enough(); i++)
    for (uint32_t absent = 0; absent < 2; absent++) {
      const struct batch_input *in = &batch_inputs[i];
      float *kept = malloc((size_t)in->count * BATCH_MOST * sizeof *kept);
      if (!kept) {
        failed("out of memory");
        break;
      }
      memcpy(kept, b->in[in->first], (size_t)in->count * BATCH_MOST * sizeof *kept);
      for (uint32_t k = 0; k < in->count; k++)
        for (uint32_t p = 0; p < POINTS; p++)
          b->in[in->first + k][p] = (float)chance_between(s, -2, 2);
      batch_from(b, 0, POINTS);
      if (absent) batch_give(b, ALL & ~in->bit);
      for (uint32_t c = 0; c < info->component_count; c++) {
        const sozai_channel *h = channel_of(info, c);
        if (!h || ((h->needs | h->uses) & in->bit)) b->out[c] = NULL;
      }
      batch_mark(b);
      if (batch_run(s, t, b, input_name(in->bit)))
        for (uint32_t c = 0; c < info->component_count; c++)
          if (b->out[c])
            batch_same(b, was, c, 0, POINTS,
                       absent ? "and without an input that it does not name"
                              : "and with another input that it does not name");
      memcpy(b->in[in->first], kept, (size_t)in->count * BATCH_MOST * sizeof *kept);
      free(kept);
    }
  free(was);
  batch_free(b);
}

static void undeclared(subject *s) { start_each_texture(s, 3, undeclared_of); }

/* ---- how odd inputs are read ---------------------------------------------------------- */

/* One way of giving an input, and another that must give the same bits. */
typedef void change(batch *b);

static void set_all(batch *b, uint32_t first, uint32_t count, float x) {
  for (uint32_t k = first; k < first + count; k++)
    for (uint32_t i = 0; i < POINTS; i++) b->in[k][i] = x;
}

static void equal_ways(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t, change *one, change *other, const char *what) {
  uint64_t kept = s->chance;
  batch *b = batch_new(s, info, preset, POINTS);
  s->chance = kept;
  if (!b) return;
  one(b);
  float *was = batch_run(s, t, b, what) ? batch_answers(b) : NULL;
  batch_free(b);
  b = batch_new(s, info, preset, POINTS);
  if (was && b) {
    other(b);
    if (batch_run(s, t, b, what)) batch_all_same(b, was, 0, POINTS, what);
  }
  free(was);
  batch_free(b);
}

#define WAYS(name, one, other, what)                                                               \
  static void name##_of(subject *s, const sozai_texture_info *info, const char *preset,            \
                        sozai_texture *t) {                                                        \
    equal_ways(s, info, preset, t, one, other, what);                                              \
  }                                                                                                \
  static void name(subject *s) { start_each_texture(s, 2, name##_of); }                            \
  _Static_assert(sizeof(what) > 1, "says what")

/* "NaN is read as 0, and beyond +-1e6 (a kilometre) as the nearest of the two" */
static void points_odd(batch *b) {
  static const float odd[] = {NAN, INFINITY, -INFINITY, 1e30f, -1e30f, 1.1e6f, -1.1e6f, FLT_MAX};
  for (uint32_t i = 0; i < POINTS; i++) b->in[i % 3][i] = odd[i % COUNT_OF(odd)];
}
static void points_read(batch *b) {
  static const float read[] = {0, 1e6f, -1e6f, 1e6f, -1e6f, 1e6f, -1e6f, 1e6f};
  for (uint32_t i = 0; i < POINTS; i++) b->in[i % 3][i] = read[i % COUNT_OF(read)];
}
WAYS(point_read, points_read, points_odd, "read as the header says, and with odd points");

/* "of any length; zero or not finite is read as +z" */
static void vector_odd(batch *b, uint32_t first) {
  for (uint32_t i = 0; i < POINTS; i++) {
    static const float odd[] = {0, NAN, INFINITY, -INFINITY};
    float x = odd[i % 4];
    for (uint32_t k = 0; k < 3; k++)
      if (x == 0 || i / 4 % 3 == k) b->in[first + k][i] = x;
  }
}
static void vector_up(batch *b, uint32_t first) {
  set_all(b, first, 2, 0);
  set_all(b, first + 2, 1, 1);
}
static void normals_odd(batch *b) { vector_odd(b, 3); }
static void normals_up(batch *b) { vector_up(b, 3); }
WAYS(normal_read, normals_up, normals_odd, "with normals of +z, and of 0 or not finite");

/* "towards the light, of any length; likewise" */
static void lights_odd(batch *b) { vector_odd(b, 6); }
static void lights_up(batch *b) { vector_up(b, 6); }
WAYS(light_read, lights_up, lights_odd, "with lights of +z, and of 0 or not finite");

/* "Not finite: 0." */
static void colours_odd(batch *b) {
  static const float odd[] = {NAN, INFINITY, -INFINITY};
  for (uint32_t i = 0; i < POINTS; i++) b->in[9 + i % 3][i] = odd[i / 3 % 3];
}
static void colours_zero(batch *b) {
  for (uint32_t i = 0; i < POINTS; i++) b->in[9 + i % 3][i] = 0;
}
WAYS(colour_read, colours_zero, colours_odd, "with light_colour 0, and not finite");

/* "NULL: 1." */
static void colours_one(batch *b) { set_all(b, 9, 3, 1); }
static void colours_none(batch *b) { batch_give(b, ALL & ~SOZAI_INPUT_LIGHT_COLOUR); }
WAYS(colour_absent, colours_one, colours_none, "with light_colour 1, and NULL");

/* "towards the eye, of any length; zero or not finite: the normal" */
static void views_odd(batch *b) { vector_odd(b, 12); }
static void views_normal(batch *b) {
  for (uint32_t k = 0; k < 3; k++) memcpy(b->in[12 + k], b->in[3 + k], POINTS * sizeof(float));
}
WAYS(view_read, views_normal, views_odd, "with views along the normal, and of 0 or not finite");

/* "NULL, negative or NaN: 0, a point." */
static void footprints_odd(batch *b) {
  static const float odd[] = {-1, NAN, -1e-30f, -INFINITY, -1e30f};
  for (uint32_t i = 0; i < POINTS; i++) b->in[15][i] = odd[i % COUNT_OF(odd)];
}
static void footprints_zero(batch *b) { set_all(b, 15, 1, 0); }
static void footprints_none(batch *b) { batch_give(b, ALL & ~SOZAI_INPUT_FOOTPRINT); }
WAYS(footprint_read, footprints_zero, footprints_odd, "with a footprint of 0, and negative or NaN");
WAYS(footprint_absent, footprints_zero, footprints_none, "with a footprint of 0, and NULL");

/* "Above 1e4: 1e4." */
static void footprints_huge(batch *b) {
  static const float odd[] = {1.0001e4f, 1e5f, 1e30f, FLT_MAX, INFINITY};
  for (uint32_t i = 0; i < POINTS; i++) b->in[15][i] = odd[i % COUNT_OF(odd)];
}
static void footprints_most(batch *b) { set_all(b, 15, 1, 1e4f); }
WAYS(footprint_huge, footprints_most, footprints_huge, "with a footprint of 1e4, and above");

/* "of any length": what is longer or shorter points the same way. Rounding apart. */
static void lengths_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  static const float scales[] = {0x1p3f, 0x1p-3f, 0x1p20f, 0x1p-20f, 0x1p60f, 0x1p-60f, 0x1p100f};
  static float kept[BATCH_INPUTS][POINTS];
  batch *b = batch_new(s, info, preset, POINTS);
  float *was = b && batch_run(s, t, b, "of length near 1") ? batch_answers(b) : NULL;
  for (uint32_t c = 0; was && c < BATCH_INPUTS; c++) memcpy(kept[c], b->in[c], sizeof kept[c]);
  for (uint32_t k = 0; was && k < COUNT_OF(scales) && !enough(); k++) {
    for (uint32_t c = 3; c < 15; c++)
      for (uint32_t i = 0; (c < 9 || c >= 12) && i < POINTS; i++)
        b->in[c][i] = kept[c][i] * scales[k];
    batch_mark(b);
    if (!batch_run(s, t, b, "vectors of another length")) break;
    for (uint32_t c = 0; c < info->component_count; c++) {
      uint32_t far = 0;
      for (uint32_t i = 0; i < POINTS; i++) {
        float x = was[batch_place(c, i)], y = b->memory[batch_place(c, i)];
        far += !(fabsf(x - y) <= 1e-2f * fabsf(x) + 1e-3f);
      }
      /* A texel's edge may fall to the other side by rounding: some points, not many. */
      EXPECT(far <= POINTS / 20,
             "%s: %s of %u points in %u is another where vectors are %g times "
             "as long",
             b->name, component_name(info, c), far, POINTS, (double)scales[k]);
    }
  }
  free(was);
  batch_free(b);
}

static void lengths(subject *s) { start_each_texture(s, 1, lengths_of); }

/* ---- hostile numbers --------------------------------------------------------------------- */

static float hostile_number(subject *s) {
  static const float numbers[] = {
      NAN,       -NAN,    INFINITY, -INFINITY, FLT_MAX,       -FLT_MAX,       FLT_MIN, -FLT_MIN,
      1e-45f,    -1e-45f, 0.0f,     -0.0f,     1e30f,         -1e30f,         1e6f,    -1e6f,
      999999.9f, 1e-20f,  16777216, 1e10f,     2147483648.0f, -2147483648.0f, 1.0f,    0.5f};
  return numbers[chance_below(s, COUNT_OF(numbers))];
}

/* "Every written number is finite." */
static void hostile_of(subject *s, const sozai_texture_info *info, const char *preset,
                       sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 1);
  for (uint32_t round = 0; b && round < 6 && !enough(); round++) {
    batch_from(b, 0, 2000);
    for (uint32_t k = 0; k < BATCH_INPUTS; k++)
      for (uint32_t i = 0; i < 2000; i++)
        if (round == 0 || chance_below(s, 4) == 0) b->in[k][i] = hostile_number(s);
    batch_mark(b);
    if (!batch_run(s, t, b, "hostile numbers")) break;
    for (uint32_t c = 0; c < info->component_count; c++)
      batch_written(b, c, 0, 2000, "of hostile numbers");
  }
  batch_free(b);
}

static void hostile(subject *s) { start_each_texture(s, 4, hostile_of); }

/* "the answer to a point depends on nothing but that point" */
static void hostile_beside(subject *s, const sozai_texture_info *info, const char *preset,
                           sozai_texture *t) {
  batch *b = batch_new(s, info, preset, 700);
  float *was = b && batch_run(s, t, b, "ordinary points") ? batch_answers(b) : NULL;
  static bool changed[BATCH_MOST];
  for (uint32_t i = 0; was && i < 700; i++) {
    changed[i] = chance_below(s, 3) == 0;
    for (uint32_t k = 0; changed[i] && k < BATCH_INPUTS; k++) b->in[k][i] = hostile_number(s);
  }
  if (was) batch_mark(b);
  if (was && batch_run(s, t, b, "hostile numbers beside"))
    for (uint32_t c = 0; c < info->component_count && !enough(); c++)
      for (uint32_t i = 0; i < 700; i++)
        if (!changed[i] && !batch_same(b, was, c, i, 1, "beside hostile numbers")) break;
  free(was);
  batch_free(b);
}

static void lanes(subject *s) { start_each_texture(s, 3, hostile_beside); }

CHECKS(inputs, //
       {"inputs.needed", "evaluate.answers",
        "a channel without an input that it needs is refused, nothing written", needs},
       {"inputs.parts", "evaluate.answers", "an input with one of three arrays missing is missing",
        parts},
       {"inputs.used", "evaluate.answers",
        "what a channel only uses may be missing, and what others need", uses_absent},
       {"inputs.undeclared", "evaluate.answers",
        "an input that a channel does not name does not change it", undeclared},
       {"inputs.point", "evaluate.answers", "points: NaN is 0, beyond a kilometre a kilometre",
        point_read},
       {"inputs.normal", "evaluate.answers", "normals: zero or not finite is +z", normal_read},
       {"inputs.light", "evaluate.answers", "lights: zero or not finite is +z", light_read},
       {"inputs.light-colour", "evaluate.answers", "light_colour: not finite is 0", colour_read},
       {"inputs.light-colour-absent", "evaluate.answers", "light_colour: NULL is 1", colour_absent},
       {"inputs.view", "evaluate.answers", "views: zero or not finite is the normal", view_read},
       {"inputs.footprint", "evaluate.answers", "footprints: negative or NaN is 0", footprint_read},
       {"inputs.footprint-absent", "evaluate.answers", "footprints: NULL is 0", footprint_absent},
       {"inputs.footprint-huge", "evaluate.answers", "footprints: above 1e4 is 1e4",
        footprint_huge},
       {"inputs.lengths", "evaluate.answers", "vectors may be of any length", lengths},
       {"inputs.hostile", "evaluate.answers",
        "NaN, infinity, denormal and huge numbers give finite ones", hostile},
       {"inputs.lanes", "evaluate.answers", "and do nothing to the points beside them", lanes});
