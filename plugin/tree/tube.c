/* SPDX-License-Identifier: Apache-2.0
 *
 * A branch as a tube: rings of points about its axis, their seam doubled for
 * u, closed at both ends. It begins within its parent: with a collar, whose first
 * ring lies under the parent's surface, or with a ring about a point of the parent's
 * axis that is narrower than the parent.
 */
#include "../core/hash1.h"
#include "bark.h"
#include "collar.h"
#include "foot.h"
#include "mesh.h"
#include "turn.h"

static uint32_t sides_of(float r, uint32_t level) {
  uint32_t n = r < 1.5f ? 3 : r < 6.0f ? 4 : r < 20.0f ? 6 : r < 60.0f ? 9 : r < 150.0f ? 14 : 22;
  n -= level * n / 5 < n ? level * n / 5 : n;
  if (level > 0 && n == 4) n = 3;
  return n < 3 ? 3 : n;
}

uint32_t tube_sides(const tree_branch *b, uint32_t level) {
  uint32_t n = sides_of(b->radius, level), foot = foot_sides(b, level);
  uint32_t collar = collar_may_be(b, level) ? collar_sides(b, level) : 0;
  return foot ? foot : n > collar ? n : collar;
}

/* ---- finer, where there is bark to be seen ---------------------------------- */

#define LIMBS_COARSER 2.0f /* than stems */
#define SIDES_MOST 320u
#define PARTS_MOST 512u /* of what lies between two nodes */

/* mm, from point to point round the axis and along it; 0: at will. */
static void steps_at(const tree *t, const bark_surface *bark, const tree_branch *b, uint32_t level,
                     const ring *at, float out[2]) {
  bark_ring all = bark_ring_at(bark, &t->plan, at->age, at->r, at->p[1], level);
  bark_ring_steps(bark, &all, level, out);
  for (int i = 0; b->order && i < 2; i++) out[i] *= LIMBS_COARSER;
}

/* The same of the scars between two rings. */
static void scar_steps(const tree *t, const tree_branch *b, uint32_t level, const ring *from,
                       const ring *to, float out[2]) {
  out[0] = out[1] = 0.0f;
  if (level >= SCARS_BELOW || !scars_on(t, b)) return;
  if (!(scars_dark(t, from->age, from->r, from->p[1]) > 0.0f) &&
      !(scars_dark(t, to->age, to->r, to->p[1]) > 0.0f))
    return;
  scars_steps(t, from->r, from->p[1], to->p[1], out);
  for (int i = 0; i < 2; i++) out[i] *= 1.0f + (float)level;
}

static float finer(float a, float b) { return a > 0.0f && (a < b || !(b > 0.0f)) ? a : b; }

/* Into how many what lies between two rings is cut. */
static uint32_t parts_between(const tree *t, const bark_surface *bark, const tree_branch *b,
                              const tube_shape *s, const ring *from, const ring *to) {
  float low[2], high[2], scars[2];
  if (!s->fine) return 1;
  steps_at(t, bark, b, s->level, from, low);
  steps_at(t, bark, b, s->level, to, high);
  scar_steps(t, b, s->level, from, to, scars);
  float step = finer(finer(low[1], high[1]), scars[1]);
  if (!(step > 0.0f)) return 1;
  float parts = (from->way < 0.0f ? rings_apart(from, to) : from->next) / step;
  return parts < (float)PARTS_MOST ? (uint32_t)parts + 1 : PARTS_MOST;
}

/* More sides and rings, so many that they show it. */
static void cut_finer(const tree *t, const bark_surface *bark, const tree_branch *b, tube_shape *s,
                      const ring *rings, uint32_t n) {
  float round = 0.0f, steps[2];
  for (uint32_t i = 0; i < n; i++) {
    steps_at(t, bark, b, s->level, &rings[i], steps);
    round = finer(round, steps[0]);
    scar_steps(t, b, s->level, &rings[i], &rings[i + 1 < n ? i + 1 : i], steps);
    round = finer(round, steps[0]);
  }
  if (!(round > 0.0f)) return;
  s->fine = 1;
  for (uint32_t i = 0; i + 1 < n; i++)
    s->rings += parts_between(t, bark, b, s, &rings[i], &rings[i + 1]) - 1;
  float sides = 6.2831853f * b->radius / round;
  uint32_t most = SIDES_MOST / (s->level + 1), whole = sides < (float)most ? (uint32_t)sides : most;
  if (whole > s->sides) s->sides = whole;
}

int tube_shape_of(const tree *t, const bark_surface *bark, uint32_t branch, uint32_t level,
                  tube_shape *out) {
  const tree_branch *b = &t->branches[branch];
  if (b->nodes < 2) return 0;
  if (branch >= t->limbs) {
    /* of shoots, the last order first, then by halves */
    uint32_t one_of = t->sprigs ? 0u : level > 2 ? 16u : level > 1 ? 8u : 2u;
    if (level >= 1 && b->order == 3 && (!one_of || branch % one_of)) return 0;
    if (level >= 3 && (hash1(b->key) >> 24) >= (256u >> (level - 2))) return 0;
  }
  out->stride = rings_stride(b, level);
  out->sides = tube_sides(b, level);
  out->rings = (b->nodes - 2) / out->stride + 2;
  out->level = level;
  out->fine = out->smooth = 0;
  if (bark && (collar_may_be(b, level) || bark_surface_on(bark, t, b))) {
    ring rings[RINGS_MOST], own[RINGS_MOST + COLLAR_RINGS];
    collar c;
    uint32_t n = rings_lay(t, b, level, rings);
    const ring *of = rings;
    out->rings = n;
    if (collar_of(&c, t, b, bark, level, rings, n)) {
      collar_rings(&c, own);
      of = own;
      out->rings = collar_count(&c);
      out->smooth = 1;
    }
    if (bark_surface_on(bark, t, b)) cut_finer(t, bark, b, out, of, out->rings);
  }
  return 1;
}

void tube_size(const tube_shape *s, uint64_t *points, uint64_t *triangles) {
  *points = (uint64_t)s->rings * (s->sides + 1) + 2;
  *triangles = (uint64_t)s->sides * (2ull * (s->rings - 1) + 2);
}

/* Where a tube ends: of a dead branch, whose tip has broken off, in a splinter. */
#define SPLINTER 1.2f /* radii long */

static void end_point(const tree_branch *b, const ring *last, const float along[3], float out[3]) {
  for (int c = 0; c < 3; c++) {
    out[c] = last->p[c];
    if (b->death >= 0.0f) out[c] += SPLINTER * last->r * along[c];
  }
}

/* A point with its bark, which is thick in the way out. */
static void write_point(mesh_pen *pen, const skin_point *q, const float bare[3], const float out[3],
                        const float normal[3], float u, float v, uint32_t branch) {
  float p[3];
  for (int c = 0; c < 3; c++) {
    p[c] = bare[c] + q->thick * out[c];
    pen->colour[c] = q->colour[c];
  }
  pen_point(pen, p, normal, u, v, branch);
}

static const float *round_of(const tree *t, const tube_shape *s, uint32_t k) {
  return t->plan.round[k % s->sides * 1024u / s->sides];
}

static void write_ring(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s,
                       const ring *at, const ring_skin *skin, float v) {
  const tree_branch *b = &t->branches[branch];
  for (uint32_t k = 0; k <= s->sides; k++) {
    const float *round = round_of(t, s, k);
    float p[3], out[3], normal[3], way[2];
    float r = at->r * foot_radius(t, b, at->p[1], k, s->sides, way);
    for (int c = 0; c < 3; c++) {
      out[c] = round[0] * skin->level[c] + round[1] * skin->side[c];
      normal[c] = way[0] * skin->level[c] + way[1] * skin->side[c];
      p[c] = at->p[c] + r * out[c];
    }
    skin_point q = skin_at(skin, &pen->bark, round, r, v);
    write_point(pen, &q, p, out, normal, (float)k / (float)s->sides, v, branch);
  }
}

/* From the parent's bark to the branch's, over a share of the way. */
static void mix_skins(const skin_point *parent, float share, skin_point *q) {
  float s = share * share * (3.0f - 2.0f * share);
  q->thick = parent->thick + s * (q->thick - parent->thick);
  for (int c = 0; c < 3; c++)
    q->colour[c] = parent->colour[c] + s * (q->colour[c] - parent->colour[c]);
}

/* Whether a collar is fine enough for the bark of a stem to run on over it. */
static int stem_runs_on(const mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s) {
  return s->fine && pen->stem && !t->branches[branch].parent;
}

/* The same of a collar's, whose points lie each on its line. Where no stem's bark runs on over it,
 * what the branch has rises from the parent's mean, and its hem lies under all of that. */
static void write_collar_ring(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s,
                              const ring *at, const ring_skin *skin, const collar *c,
                              const collar_line *lines) {
  int runs_on = stem_runs_on(pen, t, branch, s) && at->way < COLLAR_TUBE;
  float under = at->way < COLLAR_SEEN ? c->bark * (COLLAR_SEEN - at->way) : 0.0f;
  float share = at->way - COLLAR_SEEN;
  share = share > 0.0f ? share < 1.0f ? share : 1.0f : 0.0f;
  for (uint32_t k = 0; k <= s->sides; k++) {
    const float *round = round_of(t, s, k);
    float p[3], out[3];
    float v = 0.01f * collar_at(c, &lines[k % s->sides], round, at->way, p, out);
    skin_point q = skin_at(skin, &pen->bark, round, at->r, v);
    if (runs_on) {
      skin_point parent = stem_skin_at(pen->stem, t, &pen->bark, s->level, p);
      mix_skins(&parent, share, &q);
    } else {
      q.thick = q.thick * share - under;
    }
    write_point(pen, &q, p, out, out, (float)k / (float)s->sides, v, branch);
  }
}

/* Normals of finer tubes, and of collars: of each point square to the lines between its neighbours.
 * kept: how many rings keep theirs. */
static void set_normals(mesh_block *m, uint64_t first, const tube_shape *s, uint64_t kept) {
  uint64_t across = s->sides + 1;
  for (uint64_t i = kept; i < s->rings; i++) {
    uint64_t below = i ? i - 1 : 0, above = i + 1 < s->rings ? i + 1 : i;
    for (uint64_t k = 0; k < across; k++) {
      uint64_t at = k % s->sides, left = at ? at - 1 : s->sides - 1, right = at + 1;
      const float *p = m->points + 3 * first;
      float round[3], along[3], n[3], sum = 0.0f;
      for (uint64_t c = 0; c < 3; c++) {
        round[c] = p[3 * (i * across + right) + c] - p[3 * (i * across + left) + c];
        along[c] = p[3 * (above * across + at) + c] - p[3 * (below * across + at) + c];
      }
      skin_side(round, along, n);
      for (int c = 0; c < 3; c++) sum += n[c] * n[c];
      if (!(sum > 1e-12f)) continue;
      sum = 1.0f / __builtin_sqrtf(sum);
      for (uint64_t c = 0; c < 3; c++) m->normals[3 * (first + i * across + k) + c] = sum * n[c];
    }
  }
}

/* How unlike two points are in colour. */
static float unlike(const mesh_block *m, uint32_t a, uint32_t b) {
  float sum = 0.0f;
  for (uint32_t c = 0; c < 3; c++) {
    float off = m->colours[3 * a + c] - m->colours[3 * b + c];
    sum += off * off;
  }
  return sum;
}

/* Between two rings, parted from the one to the other of its corners that are more alike: a line
 * that runs athwart would have teeth else (Dyn, Levin and Rippa 1990, IMA Journal of Numerical
 * Analysis 10, 137-154). */
static void write_quad(mesh_pen *pen, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  if (unlike(pen->mesh, b, d) < unlike(pen->mesh, a, c)) {
    pen_triangle(pen, a, b, d);
    pen_triangle(pen, b, c, d);
  } else {
    pen_triangle(pen, a, b, c);
    pen_triangle(pen, a, c, d);
  }
}

static void write_triangles(mesh_pen *pen, const tube_shape *s, uint32_t base, uint32_t tip) {
  uint32_t across = s->sides + 1, last = base + 1 + (s->rings - 1) * across;
  for (uint32_t k = 0; k < s->sides; k++) {
    pen_triangle(pen, base, base + 2 + k, base + 1 + k);
    for (uint32_t i = 0; i + 1 < s->rings; i++) {
      uint32_t a = base + 1 + i * across + k, c = a + across;
      write_quad(pen, a, a + 1, c + 1, c);
    }
    pen_triangle(pen, tip, last + k, last + k + 1);
  }
}

/* A collar's rings. Gives the point from which the tube begins. kept: adds how many of them have
 * the parent's normals. */
static uint32_t write_collar(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s,
                             const collar *c, const ring *rings, ring_skin *skin, uint64_t *kept) {
  const tree_branch *b = &t->branches[branch];
  collar_line lines[SIDES_MOST];
  float back[3], kept_to = c->furrowed && stem_runs_on(pen, t, branch, s) ? 0.0f : COLLAR_SEEN;
  for (int k = 0; k < 3; k++) {
    skin->level[k] = c->level[k];
    skin->side[k] = c->side[k];
    back[k] = -c->along[k];
  }
  for (uint32_t k = 0; k < s->sides; k++) collar_line_of(c, round_of(t, s, k), &lines[k]);
  bark_colour(&t->plan, c->age, pen->colour);
  uint32_t base = pen_point(pen, c->rings[0].p, back, 0.5f, 0.0f, branch);
  for (uint32_t i = 0;; i++) {
    int last = rings[i].way >= COLLAR_END;
    uint32_t parts = last ? 1 : parts_between(t, &pen->bark, b, s, &rings[i], &rings[i + 1]);
    for (uint32_t part = 0; part < parts; part++) {
      ring at = rings[i];
      if (part) rings_between(&rings[i], &rings[i + 1], (float)part / (float)parts, &at);
      skin_of(skin, t, b, &pen->bark, s->level, &at);
      *kept += at.way <= kept_to;
      write_collar_ring(pen, t, branch, s, &at, skin, c, lines);
    }
    if (last) return base;
  }
}

void tube_write(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s) {
  const tree_branch *b = &t->branches[branch];
  ring all[RINGS_MOST], own[RINGS_MOST + COLLAR_RINGS], before = {.r = 0.0f};
  const ring *rings = all;
  uint32_t count = rings_lay(t, b, s->level, all), base = 0, first = 0;
  float along[3], v = 0.0f, end[3];
  uint64_t kept = 0;
  ring_skin skin;
  collar c;
  int collared = collar_of(&c, t, b, &pen->bark, s->level, all, count);
  if (collared) {
    collar_rings(&c, own);
    rings = own;
    count = collar_count(&c);
    base = write_collar(pen, t, branch, s, &c, rings, &skin, &kept);
    while (rings[first].way < COLLAR_END) first++;
    for (int k = 0; k < 3; k++) skin.level[k] = c.end_level[k];
    before = rings[first];
    v = 0.01f * c.end;
  }
  for (uint32_t i = first; i < count; i++) {
    uint32_t parts =
        i + 1 < count ? parts_between(t, &pen->bark, b, s, &rings[i], &rings[i + 1]) : 1;
    for (uint32_t part = collared && i == first ? 1 : 0; part < parts; part++) {
      float share = (float)part / (float)parts;
      int begins = !collared && i == 0 && part == 0;
      ring at = rings[i];
      if (part) rings_between(&rings[i], &rings[i + 1], share, &at);
      rings_direction(rings, count, i, share, along);
      foot_stand(b, at.p[1], along);
      if (begins) {
        turn_level(along, skin.level);
      } else {
        skin_carry(skin.level, along);
      }
      skin_side(along, skin.level, skin.side);
      skin_of(&skin, t, b, &pen->bark, s->level, &at);
      if (begins) {
        for (int k = 0; k < 3; k++) {
          end[k] = -along[k];
          pen->colour[k] = skin.even[k];
        }
        base = pen_point(pen, at.p, end, 0.5f, 0.0f, branch);
      } else {
        v += 0.01f * rings_apart(&before, &at);
      }
      write_ring(pen, t, branch, s, &at, &skin, v);
      before = at;
    }
  }
  if (s->fine || s->smooth) set_normals(pen->mesh, base + 1, s, kept);
  end_point(b, &rings[count - 1], along, end);
  for (int k = 0; k < 3; k++) pen->colour[k] = skin.even[k];
  write_triangles(pen, s, base, pen_point(pen, end, along, 0.5f, v, branch));
}
