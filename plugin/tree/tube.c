/* SPDX-License-Identifier: Apache-2.0
 *
 * A branch as a tube: rings of points about its axis, their seam doubled for
 * u, closed at both ends. Its first ring lies about a point of the parent's
 * axis and is narrower than the parent: the joint is inside.
 */
#include "../core/hash1.h"
#include "axis.h"
#include "bark.h"
#include "foot.h"
#include "mesh.h"
#include "parameters.h"
#include "turn.h"

static uint32_t sides_of(float r, uint32_t level) {
  uint32_t n = r < 1.5f ? 3 : r < 6.0f ? 4 : r < 20.0f ? 6 : r < 60.0f ? 9 : r < 150.0f ? 14 : 22;
  n -= level * n / 5 < n ? level * n / 5 : n;
  if (level > 0 && n == 4) n = 3;
  return n < 3 ? 3 : n;
}

typedef struct {
  float p[3], r, age; /* age: of its bark */
} ring;

static float apart(const ring *a, const ring *b) {
  float sum = 0.0f;
  for (int c = 0; c < 3; c++) sum += (b->p[c] - a->p[c]) * (b->p[c] - a->p[c]);
  return __builtin_sqrtf(sum);
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
  float parts = apart(from, to) / step;
  return parts < (float)PARTS_MOST ? (uint32_t)parts + 1 : PARTS_MOST;
}

static uint32_t lay_rings(const tree *t, const tree_branch *b, const tube_shape *s, ring *out);

/* More sides and rings, so many that they show it. */
static void cut_finer(const tree *t, const bark_surface *bark, const tree_branch *b,
                      tube_shape *s) {
  ring rings[RINGS_MOST];
  uint32_t n = lay_rings(t, b, s, rings);
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
  out->stride = level < 2 ? 1 : level < 4 ? 2 : 4;
  if (branch == 0 && level == 1) out->stride = 2;
  out->sides = sides_of(b->radius, level);
  uint32_t more = foot_sides(b, level);
  if (more) out->sides = more;
  out->collar = level < 2 && b->order == 1 && b->radius > 1.0f;
  out->rings = (b->nodes - 2) / out->stride + 2 + (out->collar ? 2u : 0u);
  out->level = level;
  out->fine = 0;
  if (bark && bark_surface_on(bark, t, b)) cut_finer(t, bark, b, out);
  return 1;
}

void tube_size(const tube_shape *s, uint64_t *points, uint64_t *triangles) {
  *points = (uint64_t)s->rings * (s->sides + 1) + 2;
  *triangles = (uint64_t)s->sides * (2ull * (s->rings - 1) + 2);
}

static void between(const ring *a, const ring *b, float share, float wider, ring *out) {
  for (int c = 0; c < 3; c++) out->p[c] = a->p[c] + share * (b->p[c] - a->p[c]);
  out->r = wider * (a->r + share * (b->r - a->r));
  out->age = a->age + share * (b->age - a->age);
}

/* Of the parent where the branch leaves it. */
static float parent_radius(const tree *t, const tree_branch *b) {
  const tree_branch *stem = &t->branches[b->parent];
  if (stem->order) {
    axis_walk w;
    float p[3];
    axis_begin(&w, &t->nodes[stem->first], stem->nodes);
    return axis_to(&w, b->at, p);
  }
  for (uint32_t k = 0; k + 1 < stem->nodes; k++) {
    const tree_node *lower = &t->nodes[stem->first + k];
    if (lower[1].p[1] >= b->at || k + 2 >= stem->nodes) return lower->r;
  }
  return b->radius / (float)t->plan.thickest; /* the base is that at most */
}

#define COLLAR 0.3f

/* Two rings more: where the branch leaves the parent it is wider, as branches are, the less the
 * thicker they are beside the parent, and a diameter on no longer. */
static uint32_t add_collar(ring *rings, uint32_t n, float parent, float radius) {
  float whole = 0.0f, at[2] = {parent, parent + 2.0f * radius};
  for (uint32_t i = 0; i + 1 < n; i++) whole += apart(&rings[i], &rings[i + 1]);
  if (at[1] > 0.8f * whole) {
    at[1] = 0.8f * whole;
    if (at[0] > 0.4f * whole) at[0] = 0.4f * whole;
  }
  float collar = radius < parent ? 1.0f + COLLAR * (1.0f - radius / parent) : 1.0f;
  for (uint32_t k = 2; k-- > 0;) {
    uint32_t i = 0;
    float begin = 0.0f, length = apart(&rings[0], &rings[1]);
    while (i + 2 < n && begin + length < at[k]) {
      begin += length;
      i++;
      length = apart(&rings[i], &rings[i + 1]);
    }
    float share = length > 0.0f ? (at[k] - begin) / length : 0.0f;
    ring more;
    between(&rings[i], &rings[i + 1], share < 1.0f ? share : 1.0f, k ? 1.0f : collar, &more);
    for (uint32_t m = n; m > i + 1; m--) rings[m] = rings[m - 1];
    rings[i + 1] = more;
    n++;
  }
  return n;
}

/* The rings' middles and radii. */
static uint32_t lay_rings(const tree *t, const tree_branch *b, const tube_shape *s, ring *out) {
  const tree_node *nodes = &t->nodes[b->first];
  float ages[RINGS_MOST];
  uint32_t n = 0;
  bark_ages(t, b, ages);
  for (uint32_t i = 0; i < b->nodes;
       i = i + 1 < b->nodes && i + s->stride >= b->nodes ? b->nodes - 1 : i + s->stride) {
    for (int c = 0; c < 3; c++) out[n].p[c] = nodes[i].p[c];
    out[n].age = ages[i];
    out[n++].r = nodes[i].r;
  }
  return s->collar ? add_collar(out, n, parent_radius(t, b), b->radius) : n;
}

static void direction(const ring *rings, uint32_t count, uint32_t i, float out[3]) {
  uint32_t a = i ? i - 1 : 0, b = i + 1 < count ? i + 1 : i;
  float sum = 0.0f;
  for (int c = 0; c < 3; c++) out[c] = rings[b].p[c] - rings[a].p[c], sum += out[c] * out[c];
  float s = sum > 0.0f ? 1.0f / __builtin_sqrtf(sum) : 0.0f;
  for (int c = 0; c < 3; c++) out[c] *= s;
  if (!(sum > 0.0f)) out[1] = 1.0f;
}

/* The last ring's frame carried on to a new direction without twisting. */
static void carry(float level[3], const float along[3]) {
  float d = level[0] * along[0] + level[1] * along[1] + level[2] * along[2], sum = 0.0f;
  for (int c = 0; c < 3; c++) level[c] -= d * along[c], sum += level[c] * level[c];
  if (sum < 1e-8f) {
    turn_level(along, level);
    return;
  }
  sum = 1.0f / __builtin_sqrtf(sum);
  for (int c = 0; c < 3; c++) level[c] *= sum;
}

static void cross(const float a[3], const float b[3], float out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Where a tube ends: of a dead branch, whose tip has broken off, in a splinter. */
#define SPLINTER 1.2f /* radii long */

static void end_point(const tree_branch *b, const ring *last, const float along[3], float out[3]) {
  for (int c = 0; c < 3; c++) {
    out[c] = last->p[c];
    if (b->death >= 0.0f) out[c] += SPLINTER * last->r * along[c];
  }
}

/* How a ring lies, and what its bark is like. */
typedef struct {
  float level[3], side[3]; /* its plane */
  bark_ring bark;
  scars_here scars;
} ring_frame;

/* What scars make of a place on a ring. */
static void add_scars(const ring_frame *f, const float round[2], float r, bark_point *q) {
  float x = round[0] * f->level[0] + round[1] * f->side[0];
  float z = round[0] * f->level[2] + round[1] * f->side[2], square = x * x + z * z;
  if (!(square > 0.01f)) return; /* a stem that lies */
  float inverse = 1.0f / __builtin_sqrtf(square);
  scar_point s = scars_mark(&f->scars, x * inverse, z * inverse, r);
  q->tone *= 1.0f - f->scars.dark * (s.mark - f->scars.mean);
  q->thick += s.rise * f->scars.dark;
}

static void write_ring(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s,
                       const ring *at, const ring_frame *f, float v) {
  const tree_branch *b = &t->branches[branch];
  const bark_ring *bark = &f->bark;
  int plain = !(bark->depth > 0.0f || bark->marks > 0.0f || f->scars.dark > 0.0f);
  float even[3], bare[3], turned[3];
  for (int c = 0; c < 3; c++) even[c] = pen->colour[c];
  if (!plain) bark_colours(&t->plan, at->age, bare, turned);
  for (uint32_t k = 0; k <= s->sides; k++) {
    const float *round = t->plan.round[k % s->sides * 1024u / s->sides];
    float n[3], p[3], out[2], r = at->r * foot_radius(t, b, at->p[1], k, s->sides, out);
    for (int c = 0; c < 3; c++) {
      n[c] = out[0] * f->level[c] + out[1] * f->side[c];
      p[c] = at->p[c] + r * (round[0] * f->level[c] + round[1] * f->side[c]);
    }
    if (!plain) {
      /* along the axis and not upright: limbs have it along them, too, each its own */
      float own = b->order ? (float)(b->key & 0xffffu) : 0.0f;
      /* as if there were no roots: what they bulge stretches bark, and does not cut into more of it
       */
      const float place[3] = {own + at->r * round[0], 100.0f * v, at->r * round[1]};
      bark_point q = bark_at(&pen->bark, bark, place);
      if (f->scars.dark > 0.0f) add_scars(f, round, r, &q);
      r += q.thick;
      for (int c = 0; c < 3; c++) {
        p[c] = at->p[c] + r * (round[0] * f->level[c] + round[1] * f->side[c]);
        float now = q.tone * (bare[c] + q.old * turned[c]);
        pen->colour[c] = now < 1.0f ? now : 1.0f;
      }
    }
    pen_point(pen, p, n, (float)k / (float)s->sides, v, branch);
  }
  for (int c = 0; c < 3; c++) pen->colour[c] = even[c];
}

/* Normals of finer tubes: of each point square to the lines between its neighbours. */
static void set_normals(mesh_block *m, uint64_t first, const tube_shape *s) {
  uint64_t across = s->sides + 1;
  for (uint64_t i = 0; i < s->rings; i++) {
    uint64_t below = i ? i - 1 : 0, above = i + 1 < s->rings ? i + 1 : i;
    for (uint64_t k = 0; k < across; k++) {
      uint64_t at = k % s->sides, left = at ? at - 1 : s->sides - 1, right = at + 1;
      const float *p = m->points + 3 * first;
      float round[3], along[3], n[3], sum = 0.0f;
      for (uint64_t c = 0; c < 3; c++) {
        round[c] = p[3 * (i * across + right) + c] - p[3 * (i * across + left) + c];
        along[c] = p[3 * (above * across + at) + c] - p[3 * (below * across + at) + c];
      }
      cross(round, along, n);
      for (int c = 0; c < 3; c++) sum += n[c] * n[c];
      if (!(sum > 1e-12f)) continue;
      sum = 1.0f / __builtin_sqrtf(sum);
      for (uint64_t c = 0; c < 3; c++) m->normals[3 * (first + i * across + k) + c] = sum * n[c];
    }
  }
}

static void write_triangles(mesh_pen *pen, const tube_shape *s, uint32_t base, uint32_t tip) {
  uint32_t across = s->sides + 1, last = base + 1 + (s->rings - 1) * across;
  for (uint32_t k = 0; k < s->sides; k++) {
    pen_triangle(pen, base, base + 2 + k, base + 1 + k);
    for (uint32_t i = 0; i + 1 < s->rings; i++) {
      uint32_t a = base + 1 + i * across + k, c = a + across;
      pen_triangle(pen, a, a + 1, c + 1);
      pen_triangle(pen, a, c + 1, c);
    }
    pen_triangle(pen, tip, last + k, last + k + 1);
  }
}

/* From one ring's direction to the next one's. */
static void turn_between(const ring *rings, uint32_t count, uint32_t i, float share, float out[3]) {
  float next[3], sum = 0.0f;
  direction(rings, count, i, out);
  if (!(share > 0.0f)) return;
  direction(rings, count, i + 1, next);
  for (int c = 0; c < 3; c++) {
    out[c] += share * (next[c] - out[c]);
    sum += out[c] * out[c];
  }
  if (!(sum > 1e-6f)) return;
  sum = 1.0f / __builtin_sqrtf(sum);
  for (int c = 0; c < 3; c++) out[c] *= sum;
}

void tube_write(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s) {
  const tree_branch *b = &t->branches[branch];
  ring rings[RINGS_MOST], at, before = {.r = 0.0f};
  uint32_t count = lay_rings(t, b, s, rings), base = 0;
  int barked = bark_surface_on(&pen->bark, t, b);
  int scarred = s->level < SCARS_BELOW && scars_on(t, b);
  float along[3], v = 0.0f, end[3];
  ring_frame f = {.bark = {.depth = 0.0f}, .scars = {.count = 0}};
  for (uint32_t i = 0; i < count; i++) {
    uint32_t parts =
        i + 1 < count ? parts_between(t, &pen->bark, b, s, &rings[i], &rings[i + 1]) : 1;
    for (uint32_t part = 0; part < parts; part++) {
      float share = (float)part / (float)parts;
      at = rings[i];
      if (part) between(&rings[i], &rings[i + 1], share, 1.0f, &at);
      turn_between(rings, count, i, share, along);
      foot_stand(b, at.p[1], along);
      if (i == 0 && part == 0) {
        turn_level(along, f.level);
      } else {
        carry(f.level, along);
      }
      cross(along, f.level, f.side);
      bark_colour(&t->plan, at.age, pen->colour);
      if (i == 0 && part == 0) {
        for (int c = 0; c < 3; c++) end[c] = -along[c];
        base = pen_point(pen, at.p, end, 0.5f, 0.0f, branch);
      } else {
        v += 0.01f * apart(&before, &at);
      }
      if (barked) f.bark = bark_ring_at(&pen->bark, &t->plan, at.age, at.r, at.p[1], s->level);
      if (scarred) scars_at(t, at.age, at.r, at.p[1], &f.scars);
      write_ring(pen, t, branch, s, &at, &f, v);
      before = at;
    }
  }
  if (s->fine) set_normals(pen->mesh, base + 1, s);
  end_point(b, &rings[count - 1], along, end);
  write_triangles(pen, s, base, pen_point(pen, end, along, 0.5f, v, branch));
}
