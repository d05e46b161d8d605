/* SPDX-License-Identifier: Apache-2.0
 *
 * A branch as a tube: rings of points about its axis, their seam doubled for
 * u, closed at both ends. Its first ring lies about a point of the parent's
 * axis and is narrower than the parent: the joint is inside.
 */
#include "../core/hash1.h"
#include "bark.h"
#include "mesh.h"
#include "parameters.h"
#include "turn.h"

static uint32_t sides_of(float r, uint32_t level) {
  uint32_t n = r < 1.5f ? 3 : r < 6.0f ? 4 : r < 20.0f ? 6 : r < 60.0f ? 9 : r < 150.0f ? 14 : 22;
  n -= level * n / 5 < n ? level * n / 5 : n;
  if (level > 0 && n == 4) n = 3;
  return n < 3 ? 3 : n;
}

/* Stems of some size stand on roots: lobes, gone a diameter or two up, on more sides. */
#define LOBED_FROM 40.0f                        /* mm of radius */
static const uint32_t lobed_sides[] = {36, 26}; /* by level; from 2 on as any tube */

static int stands_on_roots(const tree_branch *b) { return !b->order && b->radius >= LOBED_FROM; }

typedef struct {
  float p[3], r, age; /* age: of its bark */
} ring;

/* ---- where bark is furrowed ------------------------------------------------ */

static const float furrowed_from[] = {30.0f, 100.0f}; /* mm of radius: stems, and limbs on them */
#define LIMBS_COARSER 1.75f                           /* whose points stand farther apart */
#define SIDES_MOST 320u
#define PARTS_MOST 256u   /* of what lies between two nodes */
#define LEAST_FURROW 0.8f /* mm: what is shallower is as deep as its mean */

static int furrowed(const tree *t, const furrows *f, const tree_branch *b) {
  return f && f->depth > 0.0f && b->order < 2 && b < t->branches + t->stems &&
         b->radius >= furrowed_from[b->order];
}

static float apart(const ring *a, const ring *b) {
  float sum = 0.0f;
  for (int c = 0; c < 3; c++) sum += (b->p[c] - a->p[c]) * (b->p[c] - a->p[c]);
  return __builtin_sqrtf(sum);
}

static int deep(const tree *t, const furrows *f, const ring *at) {
  float depth = furrows_depth(f, bark_old(&t->plan, at->age), at->r);
  return depth > LEAST_FURROW && furrows_cut(f, at->p[1]) > 0.0f;
}

/* Into how many what lies between two rings is cut. */
static uint32_t parts_between(const tree *t, const furrows *f, float step, const ring *a,
                              const ring *b) {
  if (!(step > 0.0f) || !(deep(t, f, a) || deep(t, f, b))) return 1;
  float parts = apart(a, b) / step;
  return parts < (float)PARTS_MOST ? (uint32_t)parts + 1 : PARTS_MOST;
}

static uint32_t lay_rings(const tree *t, const tree_branch *b, const tube_shape *s, ring *out);

/* More sides and rings, so many that they show it; fewer at the next level, then none. */
static void cut_finer(const tree *t, const furrows *f, const tree_branch *b, uint32_t level,
                      tube_shape *s) {
  float steps[2], wider = (float)(level + 1) * (b->order ? LIMBS_COARSER : 1.0f);
  ring rings[RINGS_MOST];
  uint32_t n = lay_rings(t, b, s, rings), more = 0, any = 0;
  furrows_steps(f, steps);
  for (uint32_t i = 0; i + 1 < n; i++) {
    more += parts_between(t, f, steps[1] * wider, &rings[i], &rings[i + 1]) - 1;
    any |= (uint32_t)deep(t, f, &rings[i]);
  }
  if (!any) return;
  s->step = steps[1] * wider;
  s->rings += more;
  float round = 6.2831853f * b->radius / (steps[0] * wider);
  uint32_t most = SIDES_MOST / (level + 1), sides = round < (float)most ? (uint32_t)round : most;
  if (sides > s->sides) s->sides = sides;
}

int tube_shape_of(const tree *t, const furrows *bark, uint32_t branch, uint32_t level,
                  tube_shape *out) {
  const tree_branch *b = &t->branches[branch];
  if (b->nodes < 2) return 0;
  if (branch >= t->stems) {
    /* of shoots, the last order first, then by halves */
    uint32_t one_of = t->sprigs ? 0u : level > 2 ? 16u : level > 1 ? 8u : 2u;
    if (level >= 1 && b->order == 3 && (!one_of || branch % one_of)) return 0;
    if (level >= 3 && (hash1(b->key) >> 24) >= (256u >> (level - 2))) return 0;
  }
  out->stride = level < 2 ? 1 : level < 4 ? 2 : 4;
  if (branch == 0 && level == 1) out->stride = 2;
  out->sides = sides_of(b->radius, level);
  if (level < 2 && stands_on_roots(b)) out->sides = lobed_sides[level];
  out->collar = level < 2 && b->order == 1 && b->radius > 1.0f;
  out->rings = (b->nodes - 2) / out->stride + 2 + (out->collar ? 2u : 0u);
  out->step = 0.0f;
  if (level < 2 && furrowed(t, bark, b)) cut_finer(t, bark, b, level, out);
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
  for (uint32_t k = 0; k + 1 < stem->nodes; k++) {
    const tree_node *lower = &t->nodes[stem->first + k];
    if (lower[1].p[1] >= b->at || k + 2 >= stem->nodes) return lower->r;
  }
  return b->radius / (float)t->plan.thickest; /* the base is that at most */
}

/* Two rings more: where the branch leaves the parent it is wider, as branches
 * are, and a diameter on no longer. */
static uint32_t add_collar(ring *rings, uint32_t n, float parent, float radius) {
  float whole = 0.0f, at[2] = {parent, parent + 2.0f * radius};
  for (uint32_t i = 0; i + 1 < n; i++) whole += apart(&rings[i], &rings[i + 1]);
  if (at[1] > 0.8f * whole) {
    at[1] = 0.8f * whole;
    if (at[0] > 0.4f * whole) at[0] = 0.4f * whole;
  }
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
    between(&rings[i], &rings[i + 1], share < 1.0f ? share : 1.0f, k ? 1.0f : 1.3f, &more);
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

/* The radius at the foot, as a share. */
static float lobed(const tree *t, const tree_branch *b, float height, const float round[2]) {
  if (!stands_on_roots(b)) return 1.0f;
  float near_ground = 1.0f - height / (3.0f * b->radius);
  if (near_ground <= 0.0f) return 1.0f;
  uint32_t h = hash1(t->plan.seed ^ 0x0badcafeu);
  const float *turn = t->plan.round[h >> 22];
  float c = round[0] * turn[0] - round[1] * turn[1], d = round[1] * turn[0] + round[0] * turn[1];
  /* cos 5x and cos 3x of one angle */
  float c2 = c * c, five = c * (16.0f * c2 * c2 - 20.0f * c2 + 5.0f),
        three = d * (3.0f - 4.0f * d * d);
  return 1.0f + near_ground * near_ground * (0.16f * five + 0.1f * three + 0.1f);
}

/* The k-th side's place on the ring, from the axis, and its normal. */
static float lobe(const tree *t, const tree_branch *b, float height, uint32_t k, uint32_t sides,
                  float out[2]) {
  const float *round[3]; /* of the side before, its own, and of the one behind */
  float r[3];
  for (uint32_t i = 0; i < 3; i++)
    round[i] = t->plan.round[(k + sides - 1 + i) % sides * 1024u / sides];
  out[0] = round[1][0], out[1] = round[1][1];
  if (!stands_on_roots(b)) return 1.0f;
  for (int i = 0; i < 3; i++) r[i] = lobed(t, b, height, round[i]);
  if (r[0] == r[2]) return r[1];
  /* square to the line from the side before to the one behind */
  float x = r[2] * round[2][0] - r[0] * round[0][0], y = r[2] * round[2][1] - r[0] * round[0][1];
  float s = 1.0f / __builtin_sqrtf(x * x + y * y);
  out[0] = s * y, out[1] = -s * x;
  return r[1];
}

#define UPRIGHT 0.7f /* a stem that leans further is no foot but a trunk along the ground */

/* A stem's foot lies flat on the ground, however it leans; its rings come round to it by and by. */
static void stand(const tree_branch *b, float height, float along[3]) {
  float share = height / (3.0f * b->radius), sum = 0.0f;
  if (b->order || share >= 1.0f || !(along[1] > UPRIGHT)) return;
  for (int c = 0; c < 3; c++) {
    along[c] = c == 1 ? 1.0f + share * (along[1] - 1.0f) : share * along[c];
    sum += along[c] * along[c];
  }
  sum = 1.0f / __builtin_sqrtf(sum);
  for (int c = 0; c < 3; c++) along[c] *= sum;
}

/* Where a tube ends: of a dead branch, whose tip has broken off, in a splinter. */
#define SPLINTER 1.2f /* radii long */

static void end_point(const tree_branch *b, const ring *last, const float along[3], float out[3]) {
  for (int c = 0; c < 3; c++) {
    out[c] = last->p[c];
    if (b->death >= 0.0f) out[c] += SPLINTER * last->r * along[c];
  }
}

/* How a ring lies. */
typedef struct {
  float level[3], side[3]; /* its plane */
  float depth, old, cut;   /* mm, of its furrows; shares: rhytidome; of furrows that are cut */
} ring_frame;

static void write_ring(mesh_pen *pen, const tree *t, uint32_t branch, const tube_shape *s,
                       const ring *at, const ring_frame *f, float v) {
  const tree_branch *b = &t->branches[branch];
  const furrows *bark = &pen->bark;
  int fine = s->step > 0.0f && f->depth > LEAST_FURROW && f->cut > 0.0f;
  float even[3];
  for (int c = 0; c < 3; c++) even[c] = pen->colour[c];
  for (uint32_t k = 0; k <= s->sides; k++) {
    const float *round = t->plan.round[k % s->sides * 1024u / s->sides];
    float n[3], p[3], out[2], r = at->r * lobe(t, b, at->p[1], k, s->sides, out);
    for (int c = 0; c < 3; c++) {
      n[c] = out[0] * f->level[c] + out[1] * f->side[c];
      p[c] = at->p[c] + r * (round[0] * f->level[c] + round[1] * f->side[c]);
    }
    if (f->depth > 0.0f) {
      float off = fine ? f->cut * (furrows_height(bark, p) - bark->mean) : 0.0f;
      float tone = 1.0f + bark->shade * f->old * off;
      r += f->depth * (bark->mean + off);
      for (int c = 0; c < 3; c++) {
        p[c] = at->p[c] + r * (round[0] * f->level[c] + round[1] * f->side[c]);
        pen->colour[c] = tone * even[c] < 1.0f ? tone * even[c] : 1.0f;
      }
    }
    pen_point(pen, p, n, (float)k / (float)s->sides, v, branch);
  }
  for (int c = 0; c < 3; c++) pen->colour[c] = even[c];
}

/* Normals of what is furrowed: of each point square to the lines between its neighbours. */
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
  int rough = furrowed(t, &pen->bark, b);
  float along[3], v = 0.0f, end[3];
  ring_frame f = {.depth = 0.0f};
  for (uint32_t i = 0; i < count; i++) {
    uint32_t parts =
        i + 1 < count ? parts_between(t, &pen->bark, s->step, &rings[i], &rings[i + 1]) : 1;
    for (uint32_t part = 0; part < parts; part++) {
      float share = (float)part / (float)parts;
      at = rings[i];
      if (part) between(&rings[i], &rings[i + 1], share, 1.0f, &at);
      turn_between(rings, count, i, share, along);
      stand(b, at.p[1], along);
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
      if (rough) {
        f.old = bark_old(&t->plan, at.age);
        f.depth = furrows_depth(&pen->bark, f.old, at.r);
        f.cut = furrows_cut(&pen->bark, at.p[1]);
      }
      write_ring(pen, t, branch, s, &at, &f, v);
      before = at;
    }
  }
  if (s->step > 0.0f) set_normals(pen->mesh, base + 1, s);
  end_point(b, &rings[count - 1], along, end);
  write_triangles(pen, s, base, pen_point(pen, end, along, 0.5f, v, branch));
}
