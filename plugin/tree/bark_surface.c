/* SPDX-License-Identifier: Apache-2.0 */
#include "bark_surface.h"

#include "bark.h"

static const float shown_from[] = {30.0f, 60.0f}; /* mm of radius: stems, and limbs on them */
#define MARKED_FROM 80.0f                         /* mm of radius: where there are lenticels, */
#define MARKED_ALL 100.0f                         /* and where they are as dark as ever */
/* mm: furrows that are shallower are as deep as their mean; twice as deep, all is cut. */
#define LEAST_FURROW 0.8f
#define LEAST_MARK 0.03f /* lenticels that are paler are as dark as their mean */
#define CUT_BELOW 3u     /* levels of detail: from then on bark is as its mean */

/* Of bark half turned, how much more is rhytidome in furrows than all round, at most. */
#define TURNS_FIRST 0.5f

bark_surface bark_surface_of(const tree_plan *p) {
  return (bark_surface){furrows_of(p), lenticels_of(p)};
}

int bark_surface_on(const bark_surface *s, const tree *t, const tree_branch *b) {
  int shown = s->furrows.depth > 0.0f || (s->lenticels.shade > 0.0f && b->radius >= MARKED_FROM) ||
              scars_on(t, b);
  return shown && b->order < 2 && b < t->branches + t->limbs && b->radius >= shown_from[b->order];
}

bark_ring bark_ring_at(const bark_surface *s, const tree_plan *p, float age, float r, float y,
                       uint32_t level) {
  bark_ring at = {.old = bark_old(p, age)};
  at.depth = furrows_depth(&s->furrows, at.old, r);
  if (level < CUT_BELOW && at.depth > LEAST_FURROW) {
    at.turns = 4.0f * at.old * (1.0f - at.old);
    at.first = TURNS_FIRST * p->bark_turning * at.turns;
    at.varied = p->bark_variation;
    float grown = at.depth / LEAST_FURROW - 1.0f;
    at.cut = furrows_cut(&s->furrows, y) * (grown < 1.0f ? grown : 1.0f);
    at.dark = s->furrows.shade * at.old;
  }
  if (level == 0 && r >= MARKED_FROM) {
    at.marks = s->lenticels.shade * lenticels_seen(&s->lenticels, p, age, y);
    if (r < MARKED_ALL) at.marks *= (r - MARKED_FROM) / (MARKED_ALL - MARKED_FROM);
    if (at.marks < LEAST_MARK) at.marks = 0.0f;
  }
  return at;
}

void bark_ring_steps(const bark_surface *s, const bark_ring *at, uint32_t level, float out[2]) {
  float more[2];
  out[0] = out[1] = 0.0f;
  if (at->cut > 0.0f) {
    furrows_steps(&s->furrows, out);
    for (int i = 0; i < 2; i++) out[i] *= 1.0f + 0.5f * (float)level;
  }
  if (!(at->marks > 0.0f)) return;
  lenticels_steps(&s->lenticels, more);
  for (int i = 0; i < 2; i++)
    if (!(out[i] > 0.0f && out[i] < more[i])) out[i] = more[i];
}

bark_point bark_at(const bark_surface *s, const bark_ring *at, const float p[3]) {
  const furrows *f = &s->furrows;
  const lenticels *l = &s->lenticels;
  bark_point out = {at->depth * f->mean, at->old, 1.0f};
  if (at->cut > 0.0f) {
    furrow_place place = furrows_at(f, p);
    float off = at->cut * (place.height - f->mean), kind = at->cut * at->varied * place.kind;
    out.thick += at->depth * off;
    out.tone += at->dark * off + at->old * kind;
    out.old += at->turns * kind - at->first * off / f->mean;
    out.old = out.old < 0.0f ? 0.0f : out.old < 1.0f ? out.old : 1.0f;
  }
  if (at->marks > 0.0f) out.tone *= 1.0f - at->marks * (lenticels_mark(l, p) - l->mean);
  return out;
}
