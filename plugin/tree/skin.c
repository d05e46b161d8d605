/* SPDX-License-Identifier: Apache-2.0 */
#include "skin.h"

#include "bark.h"
#include "foot.h"
#include "turn.h"

void skin_of(ring_skin *o, const tree *t, const tree_branch *b, const bark_surface *s,
             uint32_t level, const ring *at) {
  o->r = at->r;
  o->own = b->order ? (float)(b->key & 0xffffu) : 0.0f;
  o->bark = (bark_ring){.depth = 0.0f};
  o->scars.count = 0, o->scars.dark = 0.0f;
  bark_colour(&t->plan, at->age, o->even);
  if (bark_surface_on(s, t, b))
    o->bark = bark_ring_at(s, &t->plan, at->age, at->r, at->p[1], level);
  if (level < SCARS_BELOW && scars_on(t, b)) scars_at(t, at->age, at->r, at->p[1], &o->scars);
  o->plain = !(o->bark.depth > 0.0f || o->bark.marks > 0.0f || o->scars.dark > 0.0f);
  if (!o->plain) bark_colours(&t->plan, at->age, o->bare, o->turned);
}

/* What scars make of a place on a ring. */
static void add_scars(const ring_skin *o, const float round[2], float r, bark_point *q) {
  float x = round[0] * o->level[0] + round[1] * o->side[0];
  float z = round[0] * o->level[2] + round[1] * o->side[2], square = x * x + z * z;
  if (!(square > 0.01f)) return; /* a stem that lies */
  float inverse = 1.0f / __builtin_sqrtf(square);
  scar_point s = scars_mark(&o->scars, x * inverse, z * inverse, r);
  q->tone *= 1.0f - o->scars.dark * (s.mark - o->scars.mean);
  q->thick += s.rise * o->scars.dark;
}

skin_point skin_at(const ring_skin *o, const bark_surface *s, const float round[2], float r,
                   float v) {
  skin_point out = {0.0f, {o->even[0], o->even[1], o->even[2]}};
  if (o->plain) return out;
  /* along the axis and not upright: limbs have it along them, too, each its own. As if there were
   * no roots: what they bulge stretches bark, and does not cut into more of it */
  const float place[3] = {o->own + o->r * round[0], 100.0f * v, o->r * round[1]};
  bark_point q = bark_at(s, &o->bark, place);
  if (o->scars.dark > 0.0f) add_scars(o, round, r, &q);
  out.thick = q.thick;
  for (int c = 0; c < 3; c++) {
    float now = q.tone * (o->bare[c] + q.old * o->turned[c]);
    out.colour[c] = now < 1.0f ? now : 1.0f;
  }
  return out;
}

/* ---- frames ----------------------------------------------------------------- */

void skin_carry(float level[3], const float along[3]) {
  float d = level[0] * along[0] + level[1] * along[1] + level[2] * along[2], sum = 0.0f;
  for (int c = 0; c < 3; c++) level[c] -= d * along[c], sum += level[c] * level[c];
  if (sum < 1e-8f) {
    turn_level(along, level);
    return;
  }
  sum = 1.0f / __builtin_sqrtf(sum);
  for (int c = 0; c < 3; c++) level[c] *= sum;
}

void skin_side(const float along[3], const float level[3], float side[3]) {
  side[0] = along[1] * level[2] - along[2] * level[1];
  side[1] = along[2] * level[0] - along[0] * level[2];
  side[2] = along[0] * level[1] - along[1] * level[0];
}

/* ---- the stem --------------------------------------------------------------- */

void stem_skin_of(stem_skin *o, const tree *t, uint32_t level_of_detail) {
  const tree_branch *b = &t->branches[0];
  float level[3];
  o->count = rings_lay(t, b, level_of_detail, o->at);
  for (uint32_t i = 0; i < o->count; i++) {
    float along[3];
    rings_direction(o->at, o->count, i, 0.0f, along);
    foot_stand(b, o->at[i].p[1], along);
    if (i == 0) {
      turn_level(along, level);
    } else {
      skin_carry(level, along);
    }
    for (int c = 0; c < 3; c++) o->level[i][c] = level[c];
    o->v[i] = i ? o->v[i - 1] + 0.01f * rings_apart(&o->at[i - 1], &o->at[i]) : 0.0f;
  }
}

skin_point stem_skin_at(const stem_skin *o, const tree *t, const bark_surface *s, uint32_t level,
                        const float p[3]) {
  float share = 0.0f, along[3], round[2] = {0.0f, 0.0f};
  uint32_t i = rings_nearest(o->at, o->count, p, &share);
  ring at;
  ring_skin skin;
  rings_between(&o->at[i], &o->at[i + 1], share, &at);
  skin_of(&skin, t, &t->branches[0], s, level, &at);
  rings_direction(o->at, o->count, i, share, along);
  for (int c = 0; c < 3; c++) skin.level[c] = o->level[i][c];
  skin_carry(skin.level, along);
  skin_side(along, skin.level, skin.side);
  for (int c = 0; c < 3; c++) {
    round[0] += (p[c] - at.p[c]) * skin.level[c];
    round[1] += (p[c] - at.p[c]) * skin.side[c];
  }
  float r = __builtin_sqrtf(round[0] * round[0] + round[1] * round[1]);
  float inverse = r > 0.0f ? 1.0f / r : 0.0f;
  round[0] *= inverse, round[1] *= inverse;
  skin_point out = skin_at(&skin, s, round, at.r, o->v[i] + share * (o->v[i + 1] - o->v[i]));
  out.thick -= skin.bark.depth * s->furrows.mean;
  return out;
}
