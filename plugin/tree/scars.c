/* SPDX-License-Identifier: Apache-2.0 */
#include "scars.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "bark.h"

#define LEAST_BRANCH 3.0f /* mm of radius: those of thinner ones are not seen */
#define OLD_ENOUGH 100.0f /* mm of a stem's radius at its foot: that has any */
#define SEEN_FROM 30.0f   /* mm of the stem's radius: where there are scars, */
#define SEEN_ALL 40.0f    /* and where they are as dark as ever */
#define LEAST_DARK 0.02f  /* paler ones are not told from the bark */
#define WIDEST 1.2f       /* of the stem's radius: the half of a brow, at most */
#define LONGEST 270.0f    /* mm: that ends hang down, at most; less than ABOUT */
#define STEEPEST 65.0     /* degrees: as if no branch left the stem by more */
#define ABOUT 300.0f      /* mm, up and down: over which the mean is taken */
#define MEAN_THICK 0.52f  /* of a brow, of that in its middle; see thickness */
#define RAGGED 0.45f      /* how uneven its height is */
#define WAVES 9.0f        /* uneven places to an arm */
#define WOUND_DARK 0.8f   /* of the brow's darkness */
#define BROW_RISE 0.14f   /* of the branch's radius */
#define WOUND_RISE -0.08f

/* From hash bits, about 1. */
static float varied(uint32_t hash, float by) {
  return 1.0f + by * ((float)(hash & 255u) * (2.0f / 255.0f) - 1.0f);
}

/* A branch's scar as it meets height y; its marks' area, mm^2. */
static float scar_of(const tree *t, const tree_branch *b, float y, scar *out) {
  const tree_plan *p = &t->plan;
  double z = (double)b->at, last = b->death >= 0.0f ? (double)b->death : p->age;
  double then = plan_radius(p, z, last), now = plan_radius(p, z, p->age);
  double up = scalar_least((double)b->elevation, STEEPEST) * RADIANS;
  float middle = b->at + (float)(then * scalar_sin(up) / scalar_cos(up));
  double way = (double)b->azimuth * RADIANS;
  uint32_t h = hash1(b->key ^ 0x3ad8025fu);
  float size = b->radius, apart = then > 0.0 ? (float)(now / then) : 1.0f;
  float half = p->scar_width * size * varied(h, 0.25f), most = WIDEST * (float)now;
  *out = (scar){.x = (float)scalar_sin(way),
                .z = (float)-scalar_cos(way),
                .up = y - middle,
                .top = 0.8f * size,
                .drop = p->scar_droop * half * varied(h >> 8, 0.25f),
                .thick = 0.55f * size,
                .wound = {0.9f * size * apart, 0.8f * size},
                .size = size,
                .hash = h};
  if (out->drop > LONGEST) out->drop = LONGEST;
  float sum = 0.0f;
  for (int i = 0; i < 2; i++) {
    float side = half * apart * varied(h >> (16 + 8 * i), 0.2f);
    out->half[i] = side < most ? side : most;
    sum += out->half[i];
  }
  /* of a mark that is 1 in its inner half and falls to 0 from there on */
  return 1.5f * MEAN_THICK * out->thick * sum + 2.36f * WOUND_DARK * out->wound[0] * out->wound[1];
}

/* Over the branch's middle: where it begins, and ends. */
static void scar_spans(const scar *s, float out[2]) {
  float thick = s->thick * (1.0f + RAGGED);
  out[0] = s->top - s->drop - thick;
  if (out[0] > -s->wound[1]) out[0] = -s->wound[1];
  out[1] = s->top + thick;
}

/* Branches whose scars may be so near to heights where the stem's radius is r at most. */
static int may_reach(const tree_branch *b, float r, float low, float high) {
  return b->order == 1 && b->radius >= LEAST_BRANCH && b->at < high + ABOUT &&
         b->at + 4.0f * r + ABOUT > low;
}

int scars_on(const tree *t, const tree_branch *b) {
  return t->by_years && b->order == 0 && b->radius >= OLD_ENOUGH && t->plan.scar_width > 0.0f &&
         t->plan.scar_shade > 0.0f;
}

float scars_dark(const tree *t, float age, float r, float y) {
  const tree_plan *p = &t->plan;
  float left = (p->bark_reach - y) / (0.2f * p->bark_reach);
  float dark = p->scar_shade * bark_periderm(p, age);
  if (!(left > 0.0f) || !(r > SEEN_FROM)) return 0.0f;
  if (left < 1.0f) dark *= left;
  if (r < SEEN_ALL) dark *= (r - SEEN_FROM) / (SEEN_ALL - SEEN_FROM);
  return dark < LEAST_DARK ? 0.0f : dark;
}

void scars_at(const tree *t, float age, float r, float y, scars_here *out) {
  out->count = 0;
  out->mean = 0.0f;
  out->dark = scars_dark(t, age, r, y);
  if (!(out->dark > 0.0f)) return;
  float area = 0.0f;
  for (uint32_t i = 1; i < t->stems; i++) {
    const tree_branch *b = &t->branches[i];
    float span[2];
    scar s;
    if (!may_reach(b, r, y, y)) continue;
    float own = scar_of(t, b, y, &s);
    /* nearer ones count for more: none comes or goes of a sudden */
    float off = s.up < 0.0f ? -s.up : s.up;
    if (off < ABOUT) area += own * (1.0f - off / ABOUT);
    scar_spans(&s, span);
    if (!(s.up > span[0] && s.up < span[1]) || out->count == SCARS_MOST) continue;
    out->at[out->count++] = s;
  }
  out->mean = area / (6.2831853f * r * ABOUT);
}

/* Value noise along an arm, within +-1. */
static float ragged(uint32_t hash, float u) {
  float at = WAVES * u;
  int32_t whole = scalar_floor((double)at);
  float f = at - (float)whole;
  float a = (float)(hash1(hash + (uint32_t)whole) >> 16) * (1.0f / 32767.5f) - 1.0f;
  float b = (float)(hash1(hash + (uint32_t)whole + 1u) >> 16) * (1.0f / 32767.5f) - 1.0f;
  return a + (b - a) * f * f * (3.0f - 2.0f * f);
}

/* Of a brow at u of an arm's length, of that in the middle: pointed at the ends. */
static float thickness(float u) {
  float left = 1.0f - u;
  return __builtin_sqrtf(left) * (0.45f + 0.55f * left);
}

static float inner_half(float in) { return in > 0.5f ? 1.0f : in > 0.0f ? 2.0f * in : 0.0f; }

/* The angle of a sine and a cosine that is not below 0: twice the arc tangent of its half's tangent
 * (Abramowitz and Stegun 4.4.49: within 1e-5). */
static float angle_of(float sine, float cosine) {
  float t = sine / (1.0f + cosine), q = t * t;
  float p = 0.0208351f * q - 0.0851330f;
  p = p * q + 0.1801410f;
  p = p * q - 0.3302995f;
  return 2.0f * t * (p * q + 0.9998660f);
}

scar_point scars_mark(const scars_here *s, float x, float z, float r) {
  scar_point out = {0.0f, 0.0f};
  for (uint32_t i = 0; i < s->count; i++) {
    const scar *q = &s->at[i];
    float before = x * q->x + z * q->z;
    if (!(before > 0.0f)) continue;
    float round = r * angle_of(z * q->x - x * q->z, before), far = round < 0.0f ? -round : round;
    int side = round < 0.0f;
    float u = far / q->half[side], brow = 0.0f;
    if (u < 1.0f) {
      float line = q->top - q->drop * u * (0.65f + 0.35f * u);
      float thick = q->thick * thickness(u);
      thick *= 1.0f + RAGGED * ragged(q->hash + (uint32_t)side * 0x9e3779b1u, u);
      float off = q->up - line;
      brow = inner_half(1.0f - (off < 0.0f ? -off : off) / thick);
    }
    float across = round / q->wound[0], along = q->up / q->wound[1];
    float wound = inner_half(1.0f - across * across - along * along);
    float mark = brow > WOUND_DARK * wound ? brow : WOUND_DARK * wound;
    if (mark > out.mark) out.mark = mark;
    out.rise += q->size * (brow * BROW_RISE + (1.0f - brow) * wound * WOUND_RISE);
  }
  return out;
}

void scars_steps(const tree *t, float r, float from, float to, float out[2]) {
  out[0] = out[1] = 0.0f;
  float least = 1e9f;
  for (uint32_t i = 1; i < t->stems; i++) {
    const tree_branch *b = &t->branches[i];
    float span[2];
    scar s;
    if (!may_reach(b, r, from, to)) continue;
    scar_of(t, b, from, &s);
    scar_spans(&s, span);
    if (s.up < span[1] && s.up + (to - from) > span[0] && s.size < least) least = s.size;
  }
  if (!(least < 1e9f)) return;
  out[1] = 0.18f * least > 2.4f ? 0.18f * least : 2.4f;
  out[0] = 1.8f * out[1];
}
