/* SPDX-License-Identifier: Apache-2.0
 * docs/fiber-texture.md says what a yarn is there: an ellipse whose middle goes up and down from
 * crossing to crossing. Here it is filled with fibres that turn about its middle, each with a
 * course of its own. */
#include "woven.h"

#include <math.h>
#include "samples.h"

/* Share of a yarn that is fibre: Morton and Hearle 2008 and Hearle, Grosberg and Backer 1969
 * have 0.4 to 0.6. */
#define YARN_PACKING 0.5
/* Slope of a fibre's own course across its yarn, the mean square's root; and how many
 * diameters its waves are long. */
#define STRAY 0.13
#define WAVES 33.0
/* How much wider or narrower a yarn is where it has slubs. */
#define SLUB 0.16
/* How far it strays from a straight way then, of the spacing. */
#define COURSE 0.1

/* ---- from the preset --------------------------------------------------- */

static const sozai_value *given(const sozai_preset *p, const char *id) {
  for (uint32_t i = 0; i < p->value_count; i++) {
    if (!strcmp(p->values[i].id, id)) return &p->values[i];
  }
  return NULL;
}

static double number_of(const sozai_texture_info *info, const sozai_preset *p, const char *id) {
  const sozai_value *v = given(p, id);
  if (v) return v->number[0];
  for (uint32_t i = 0; i < info->parameter_count; i++) {
    if (!strcmp(info->parameters[i]->id, id)) return info->parameters[i]->default_number[0];
  }
  fail_msg("no parameter %s", id);
  return 0;
}

bool cloth_of(const sozai_texture_info *info, const sozai_preset *p, cloth *c) {
  const sozai_value *weave = given(p, "weave");
  if (!weave) return false;
  *c = (cloth){.preset = p->id,
               .weave = weave->text,
               .spacing = {number_of(info, p, "yarn_spacing"), number_of(info, p, "weft_spacing")},
               .width = number_of(info, p, "yarn_width"),
               .flatness = number_of(info, p, "yarn_flatness"),
               .swell = number_of(info, p, "yarn_swell"),
               .twist = number_of(info, p, "twist"),
               .slub = number_of(info, p, "slub"),
               .diameter = number_of(info, p, "diameter"),
               .elevation_spread = number_of(info, p, "elevation_spread"),
               .flyaway = number_of(info, p, "flyaway"),
               .flyaway_height = number_of(info, p, "flyaway_height"),
               .roughness = number_of(info, p, "roughness"),
               .tilt = number_of(info, p, "tilt"),
               .index = number_of(info, p, "ior"),
               .transmission = number_of(info, p, "transmission")};
  return true;
}

/* ---- the weave --------------------------------------------------------- */

typedef struct {
  const char *id;
  int repeat, over, step, in_pairs;
} pattern;

static const pattern *pattern_of(const char *weave) {
  static const pattern list[] = {{"plain", 2, 1, 1, 0},     {"basket", 2, 1, 1, 1},
                                 {"twill_2_1", 3, 2, 1, 0}, {"twill_3_1", 4, 3, 1, 0},
                                 {"twill_2_2", 4, 2, 1, 0}, {"satin", 5, 4, 2, 0}};
  for (unsigned i = 0; i < sizeof list / sizeof *list; i++) {
    if (!strcmp(list[i].id, weave)) return &list[i];
  }
  fail_msg("no weave %s", weave);
  return NULL;
}

/* Whether warp i is on top of weft k. */
static bool over(const pattern *p, int i, int k) {
  int key = (i >> p->in_pairs) * p->step + (k >> p->in_pairs);
  return ((key % p->repeat) + p->repeat) % p->repeat < p->over;
}

typedef struct {
  const cloth *of;
  const pattern *p;
  double half[2], height, rise, over; /* of yarns: docs/fiber-texture.md */
  int count;                          /* yarns of either direction in a tile */
} plan;

static plan plan_of(const cloth *c) {
  plan q = {.of = c, .p = pattern_of(c->weave)};
  double thin = fmin(c->spacing[0], c->spacing[1]) * fmin(c->width, 1);
  q.rise = 0.3 * thin * c->flatness;
  q.height = 0.5 * thin * c->flatness;
  q.over = 0.9 * q.rise * (2.0 * q.p->over / q.p->repeat - 1);
  for (int i = 0; i < 2; i++) q.half[i] = 0.5 * c->spacing[i] * c->width;
  q.count = q.p->repeat << q.p->in_pairs;
  /* as long as a thick place and a thin one, where there are such */
  while (q.count < (c->slub > 0 ? 8 : 4)) q.count *= 2;
  return q;
}

/* How high a yarn's middle is at a place along it: 1 on top, -1 below. */
static double level(const plan *q, int weft, int mine, double at) {
  double t = at / q->of->spacing[1 - weft] - 0.5, low = floor(t), f = t - low;
  int next = (int)low;
  double side[2];
  for (int k = 0; k < 2; k++) {
    bool up = weft ? !over(q->p, next + k, mine) : over(q->p, mine, next + k);
    side[k] = up ? 1 : -1;
  }
  return side[0] + (side[1] - side[0]) * f * f * (3 - 2 * f);
}

/* ---- curves ------------------------------------------------------------ */

static void add_point(woven *b, double x, double y, double z, double radius) {
  if (!(b->points_count % 1024)) {
    b->points = realloc(b->points, 3 * (b->points_count + 1024) * sizeof *b->points);
    b->radii = realloc(b->radii, (b->points_count + 1024) * sizeof *b->radii);
    assert_true(b->points && b->radii);
  }
  float *to = b->points + 3 * b->points_count;
  to[0] = (float)x;
  to[1] = (float)y;
  to[2] = (float)z;
  b->radii[b->points_count++] = (float)radius;
}

static void begin_curve(woven *b) {
  b->first = realloc(b->first, (b->curves_count + 2) * sizeof *b->first);
  assert_non_null(b->first);
  b->first[b->curves_count++] = b->points_count;
}

/* One fibre of a yarn: `inside`, 0 its middle and 1 its face, at an angle about it. */
static void add_fibre(woven *b, const plan *q, int weft, int mine, int shown_at, double inside,
                      double angle, sample_stream *d) {
  const cloth *c = q->of;
  double r = c->diameter / 2000, length = q->count * c->spacing[1 - weft];
  double wave = WAVES * 2 * r, turn = 2 * PI / wave;
  double up = tan(c->elevation_spread * PI / 180) / sqrt(3);
  double aside = STRAY * sqrt(2) / turn, lift = up * sqrt(2) / turn;
  double wide = fmax(q->half[weft] - r, r), high = fmax(q->height - r, r);
  double rate = tan(c->twist * PI / 180) / q->half[weft];
  double phase = 2 * PI * (double)sample_next(d), other = 2 * PI * (double)sample_next(d);
  double waves = fmax(1, round(length / (9.1 * c->spacing[weft]))), at = 2.4 * mine + weft;
  double bends = fmax(1, round(length / (5.9 * c->spacing[weft]))), to = 3.7 * mine + 1.3 * weft;
  int steps = (int)ceil(length / fmin(c->spacing[1 - weft] / 8, wave / 8));
  double off = (shown_at + 0.5 - 0.5 * q->count) * c->spacing[weft];
  begin_curve(b);
  for (int k = 0; k <= steps; k++) {
    double s = length * k / steps, a = angle - rate * s;
    double high_up = level(q, weft, mine, s),
           middle = (weft ? -q->over : q->over) + q->rise * high_up;
    double thick =
        1 + SLUB * c->slub * sin(2 * PI * waves * s / length + at) + 0.5 * c->swell * high_up;
    /* to the side that is left of the yarn's way */
    double side = inside * wide * thick * cos(a) + aside * sin(turn * s + phase) +
                  COURSE * c->slub * c->spacing[weft] * sin(2 * PI * bends * s / length + to);
    double z = middle + inside * high * sin(a) + lift * sin(1.1 * turn * s + other);
    double along = s - 0.5 * length;
    if (weft)
      add_point(b, off - side, along, z, r);
    else
      add_point(b, along, off + side, z, r);
  }
}

static void add_yarn(woven *b, const plan *q, int weft, int shown_at) {
  int mine = ((shown_at % q->count) + q->count) % q->count;
  double r = q->of->diameter / 2000;
  int fibres = (int)ceil(YARN_PACKING * q->half[weft] * q->height / (r * r));
  sample_stream d = {sample_hash(4711u + 2u * (uint32_t)mine + (uint32_t)weft)};
  for (int k = 0; k < fibres; k++) {
    /* evenly over the section, as a sunflower's seeds */
    double inside = sqrt((k + 0.5) / fibres), angle = 2.39996323 * k + 2 * PI * mine / 7.0;
    add_fibre(b, q, weft, mine, shown_at, inside, angle, &d);
  }
}

/* Single strands above all, lying every way; cut to the tile, through which they go straight. */
static void add_flown(woven *b, const plan *q, double level) {
  const cloth *c = q->of;
  double r = c->diameter / 2000;
  double x = 0.5 * q->count * c->spacing[1], y = 0.5 * q->count * c->spacing[0];
  double wanted = -log(1 - c->flyaway) * 4 * x * y / (2 * r), had = 0;
  sample_stream d = {sample_hash(99u)};
  while (had < wanted) {
    double a = 2 * PI * (double)sample_next(&d), co = cos(a), si = sin(a);
    double px = x * (2 * (double)sample_next(&d) - 1), py = y * (2 * (double)sample_next(&d) - 1);
    double z = level + 4 * r * (double)sample_next(&d);
    double to[2];
    for (int k = 0; k < 2; k++) {
      double way = k ? 1 : -1;
      double tx = fabs(co) > 1e-6 ? ((co * way > 0 ? x : -x) - px) / (co * way) : 1e9;
      double ty = fabs(si) > 1e-6 ? ((si * way > 0 ? y : -y) - py) / (si * way) : 1e9;
      to[k] = way * fmin(fmin(tx, ty), 30 * 2 * r);
    }
    begin_curve(b);
    for (int k = 0; k < 2; k++) add_point(b, px + to[k] * co, py + to[k] * si, z, r);
    had += to[1] - to[0];
  }
}

void weave_cloth(woven *b, const cloth *c) {
  memset(b, 0, sizeof *b);
  plan q = plan_of(c);
  for (int weft = 0; weft < 2; weft++) {
    /* and what of the next tile's yarns reaches into this one */
    for (int i = -1; i <= q.count; i++) add_yarn(b, &q, weft, i);
  }
  double top = q.rise + q.over + q.height;
  if (c->flyaway > 0) add_flown(b, &q, top + c->flyaway_height);
  begin_curve(b);
  const sozai_curves made = {.size = sizeof made,
                             .curve_count = --b->curves_count,
                             .point_count = b->points_count,
                             .points = b->points,
                             .radii = b->radii,
                             .first = b->first};
  failure why;
  assert_true(strands_open(&b->t.s, &made, 1, false, &why));
  b->t.half[0] = (float)(0.5 * q.count * c->spacing[1]);
  b->t.half[1] = (float)(0.5 * q.count * c->spacing[0]);
  b->t.high = (float)(top + (c->flyaway > 0 ? c->flyaway_height : 0) + 0.1);
  memcpy(b->t.colour, colours, sizeof colours);
  /* as presets make their transmission of it */
  b->t.round = (float)fmin(fmax((1 - (c->transmission - 0.08) / 0.55) / 0.8, 0), 1);
  b->t.lobe = fiber_lobe_make((float)c->roughness, b->t.round, (float)c->tilt, (float)c->index);
}

void free_cloth(woven *b) {
  strands_close(&b->t.s);
  free(b->points);
  free(b->radii);
  free(b->first);
}
