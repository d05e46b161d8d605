/* SPDX-License-Identifier: Apache-2.0
 *
 * Strands kept apart by their radii. In each round every strand looks where it
 * overlaps others, all standing as the round began, and moves by half of it:
 * whole, or bent where it touches. What is outside the hull pushes back in.
 */
#include <string.h>

#include "../core/meter.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "../core/crew.h"
#include "fit.h"
#include "parameters.h"
#include "segments.h"

#define STRANDS_JOB 32u
#define TOO_MANY 0.05 /* of the strands: if more still overlap in the end, the host is told */
#define SMOOTH 10     /* passes that spread a push along a strand that bends */
/* What a pushed vertex keeps of its push in each pass, in the first round and the last: spread far,
 * pushes bend strands slowly and their crimp stays, but what is hemmed in stays so. */
#define KEPT_FIRST 0.6
#define KEPT_LAST 0.97

typedef struct {
  fiber *f;
  segments *near;
  float *next;    /* points after the round */
  uint32_t *met;  /* of each strand: segments of others that overlap its own */
  float *deepest; /* of each */
  double kept;    /* of a push where it is, pass by pass */
} round_work;

/* What a strand's neighbours ask of it. */
typedef struct {
  double push[STRAND_VERTICES_MAX][3], weight[STRAND_VERTICES_MAX];
  uint32_t met;
  double deepest;
} pushes;

static void push_at(pushes *p, uint32_t segment, double at, const double way[3], double by) {
  for (uint32_t k = 0; k < 2; k++) {
    double w = k ? at : 1 - at;
    for (int a = 0; a < 3; a++) p->push[segment + k][a] += w * by * way[a];
    p->weight[segment + k] += w;
  }
}

static int apart_by_boxes(const float *a, const float *b, float keep) {
  for (int k = 0; k < 3; k++) {
    float a0 = a[k] < a[3 + k] ? a[k] : a[3 + k], a1 = a[k] < a[3 + k] ? a[3 + k] : a[k];
    float b0 = b[k] < b[3 + k] ? b[k] : b[3 + k], b1 = b[k] < b[3 + k] ? b[3 + k] : b[k];
    if (b0 - a1 > keep || a0 - b1 > keep) return 1;
  }
  return 0;
}

static void meet(const round_work *w, pushes *p, uint32_t strand, uint32_t i, uint32_t other) {
  const fiber *f = w->f;
  uint32_t each = f->vertices - 1, theirs = other / each;
  if (theirs == strand) return;
  const float *a = f->points + 3 * ((size_t)strand * f->vertices + i);
  const float *b = f->points + 3 * ((size_t)theirs * f->vertices + other % each);
  double s, t, touch = (double)f->radii[strand] + (double)f->radii[theirs], way[3];
  double keep = touch + f->plan.clearance;
  if (apart_by_boxes(a, b, (float)(1.0001 * keep))) return;
  double square = segments_nearest(a, b, &s, &t);
  if (!(square < keep * keep)) return;
  double d = scalar_root(square);
  if (d > 1e-6 * touch) {
    for (int k = 0; k < 3; k++) {
      double x = (double)a[k] + s * ((double)a[3 + k] - (double)a[k]);
      double y = (double)b[k] + t * ((double)b[3 + k] - (double)b[k]);
      way[k] = (x - y) / d;
    }
  } else {
    /* through one another: square to both; the other sees it the other way */
    double l = 0, u[3], v[3];
    for (int k = 0; k < 3; k++)
      u[k] = (double)a[3 + k] - (double)a[k], v[k] = (double)b[3 + k] - (double)b[k];
    for (int k = 0; k < 3; k++) {
      way[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
      l += way[k] * way[k];
    }
    if (!(l > 0)) return;
    for (int k = 0; k < 3; k++) way[k] /= scalar_root(l);
  }
  push_at(p, i, s, way, 0.5 * (keep - d));
  if (d < touch) {
    p->met++;
    if (touch - d > p->deepest) p->deepest = touch - d;
  }
}

static void look_about(const round_work *w, pushes *p, uint32_t strand, uint32_t i) {
  const fiber *f = w->f;
  int32_t own[3], c[3];
  segment_cell(w->near, f->points + 3 * ((size_t)strand * f->vertices + i), own);
  for (int k = 0; k < 27; k++) {
    c[0] = own[0] + k % 3 - 1, c[1] = own[1] + k / 3 % 3 - 1, c[2] = own[2] + k / 9 - 1;
    uint32_t b = segment_bucket(w->near, c), key = segment_key(c);
    for (uint32_t n = w->near->first[b]; n < w->near->first[b + 1]; n++) {
      /* another cell may share the bucket */
      if (w->near->list[n].key == key) meet(w, p, strand, i, w->near->list[n].id);
    }
  }
}

/* Vertices outside, back by their distance. */
static void push_inside(const fiber *f, pushes *p, const float *points) {
  float e = 0.25f * f->grid.spacing / GRID_FINE;
  for (uint32_t i = 0; f->plan.mode != MODE_LITERAL && i < f->vertices; i++) {
    const float *q = points + 3 * i;
    float d = grid_at(&f->grid, q[0], q[1], q[2]);
    if (d >= 0) continue;
    double g[3], l = 0;
    for (int a = 0; a < 3; a++) {
      float s[3] = {q[0], q[1], q[2]}, t[3] = {q[0], q[1], q[2]};
      s[a] -= e, t[a] += e;
      g[a] =
          (double)grid_at(&f->grid, t[0], t[1], t[2]) - (double)grid_at(&f->grid, s[0], s[1], s[2]);
      l += g[a] * g[a];
    }
    if (!(l > 0)) continue;
    double by = -(double)d < f->plan.diameter ? -(double)d : f->plan.diameter;
    for (int a = 0; a < 3; a++) p->push[i][a] += by * g[a] / scalar_root(l);
    p->weight[i] += 1;
  }
}

/* Segments back to their length, from the middle out. */
static void restore_lengths(const fiber *f, uint32_t strand, double (*at)[3]) {
  double rest = strand_length(&f->plan.shape, strand) / (f->vertices - 1);
  uint32_t middle = f->vertices / 2;
  double moved[3] = {0, 0, 0}, old[3];
  for (int side = 0; side < 2; side++) {
    for (uint32_t k = 1; side ? middle + k < f->vertices : k <= middle; k++) {
      uint32_t i = side ? middle + k : middle - k, from = side ? i - 1 : i + 1;
      double way[3], l = 0;
      if (k == 1) memcpy(old, at[middle], sizeof old), memset(moved, 0, sizeof moved);
      for (int a = 0; a < 3; a++) way[a] = at[i][a] - old[a], l += way[a] * way[a];
      memcpy(old, at[i], sizeof old);
      l = scalar_root(l);
      for (int a = 0; a < 3; a++) at[i][a] = at[from][a] + (l > 0 ? way[a] / l : a == 0) * rest;
    }
  }
}

/* The least squares of a small rigid motion: the mean push, and the turn about
 * the pushed places' middle. */
static void move_whole(const fiber *f, const pushes *p, double (*at)[3]) {
  double weight = 0, shift[3] = {0, 0, 0}, mid[3] = {0, 0, 0}, spin[3] = {0, 0, 0};
  uint32_t n = f->vertices;
  for (uint32_t i = 0; i < n; i++) {
    weight += p->weight[i];
    for (int a = 0; a < 3; a++) shift[a] += p->push[i][a], mid[a] += at[i][a] / n;
  }
  double inertia = 0;
  for (int a = 0; a < 3; a++) shift[a] /= weight;
  for (uint32_t i = 0; i < n; i++) {
    double o[3];
    for (int a = 0; a < 3; a++) {
      o[a] = at[i][a] - mid[a];
      inertia += (p->weight[i] + weight / n) * o[a] * o[a];
    }
    for (int a = 0; a < 3; a++)
      spin[a] += o[(a + 1) % 3] * (p->push[i][(a + 2) % 3] - shift[(a + 2) % 3] * p->weight[i]) -
                 o[(a + 2) % 3] * (p->push[i][(a + 1) % 3] - shift[(a + 1) % 3] * p->weight[i]);
  }
  double angle = 0;
  for (int a = 0; a < 3; a++) {
    spin[a] = inertia > 0 ? spin[a] / inertia : 0;
    angle += spin[a] * spin[a];
  }
  angle = scalar_root(angle);
  double sine, cosine;
  strand_sine_cosine(angle, &sine, &cosine);
  for (uint32_t i = 0; i < n; i++) {
    double o[3], k[3], along = 0, turned[3];
    for (int a = 0; a < 3; a++) {
      o[a] = at[i][a] - mid[a];
      k[a] = angle > 1e-12 ? spin[a] / angle : 0;
      along += k[a] * o[a];
    }
    for (int a = 0; a < 3; a++) {
      double c = k[(a + 1) % 3] * o[(a + 2) % 3] - k[(a + 2) % 3] * o[(a + 1) % 3];
      turned[a] = angle > 1e-12 ? o[a] * cosine + c * sine + k[a] * along * (1 - cosine) : o[a];
    }
    for (int a = 0; a < 3; a++) at[i][a] = mid[a] + turned[a] + shift[a];
  }
}

/* Each vertex by its own push, spread over its neighbours. */
static void move_bent(const fiber *f, const pushes *p, double kept, double (*at)[3]) {
  uint32_t n = f->vertices;
  double by[STRAND_VERTICES_MAX][3];
  for (uint32_t i = 0; i < n; i++)
    for (int a = 0; a < 3; a++)
      by[i][a] = p->weight[i] > 0 ? p->push[i][a] / (p->weight[i] > 1 ? p->weight[i] : 1) : 0;
  for (int pass = 0; pass < SMOOTH; pass++) {
    double before[3];
    memcpy(before, by[0], sizeof before);
    for (uint32_t i = 0; i < n; i++) {
      const double *after = by[i + 1 < n ? i + 1 : i];
      double keep[3];
      memcpy(keep, by[i], sizeof keep);
      double own = p->weight[i] > 0 ? kept : 0.34, other = (1 - own) / 2;
      for (int a = 0; a < 3; a++) by[i][a] = own * keep[a] + other * (before[a] + after[a]);
      memcpy(before, keep, sizeof before);
    }
  }
  for (uint32_t i = 0; i < n; i++)
    for (int a = 0; a < 3; a++) at[i][a] += by[i][a];
}

static void push_strand(const round_work *w, uint32_t strand) {
  const fiber *f = w->f;
  uint32_t n = f->vertices;
  const float *from = f->points + 3 * (size_t)strand * n;
  float *to = w->next + 3 * (size_t)strand * n;
  pushes p;
  memset(p.push, 0, n * sizeof *p.push);
  memset(p.weight, 0, n * sizeof *p.weight);
  p.met = 0;
  p.deepest = 0;
  for (uint32_t i = 0; i + 1 < n; i++) look_about(w, &p, strand, i);
  w->met[strand] = p.met;
  w->deepest[strand] = (float)p.deepest;
  double sum = 0;
  for (uint32_t i = 0; i < n; i++) sum += p.weight[i];
  memcpy(to, from, 3 * (size_t)n * sizeof *to);
  if (!(sum > 0)) return;
  push_inside(f, &p, from);
  double at[STRAND_VERTICES_MAX][3];
  for (uint32_t i = 0; i < 3 * n; i++) at[i / 3][i % 3] = (double)from[i];
  if (f->plan.contact == CONTACT_BEND)
    move_bent(f, &p, w->kept, at);
  else
    move_whole(f, &p, at);
  restore_lengths(f, strand, at);
  for (uint32_t i = 0; i < 3 * n; i++) to[i] = (float)at[i / 3][i % 3];
}

static void push_job(void *context, uint32_t job) {
  const round_work *w = context;
  uint32_t end = (job + 1) * STRANDS_JOB;
  for (uint32_t i = job * STRANDS_JOB; i < end && i < w->f->strands; i++) push_strand(w, i);
}

static void recount_job(void *context, uint32_t job) {
  const round_work *w = context;
  fiber *f = w->f;
  uint32_t end = (job + 1) * STRANDS_JOB;
  for (uint32_t i = job * STRANDS_JOB; i < end && i < f->strands; i++) {
    double sum = 0;
    uint16_t inside = 0;
    for (uint32_t v = 0; v < f->vertices; v++) {
      const float *p = f->points + 3 * ((size_t)i * f->vertices + v);
      sum += (double)fit_distance(f, p);
      inside =
          (uint16_t)(inside + (f->plan.mode == MODE_LITERAL ? hull_literal(&f->hull, p) >= 0
                                                            : grid_inside(&f->grid, &f->hull, p)));
    }
    f->results[i].last = (float)sum;
    f->results[i].inside = inside;
  }
}

static int32_t run_rounds(round_work *w, const sozai_host *host) {
  fiber *f = w->f;
  uint32_t jobs = (f->strands + STRANDS_JOB - 1) / STRANDS_JOB, rounds = f->plan.rounds;
  int32_t r = SOZAI_OK;
  for (uint32_t k = 0; !r && k <= rounds; k++) {
    segments_sort(w->near, f);
    w->kept = KEPT_FIRST + (KEPT_LAST - KEPT_FIRST) * k / (rounds + 1.0);
    crew_progress bar = {"keeping strands apart", 0.6 + 0.38 * k / (rounds + 1.0),
                         0.6 + 0.38 * (k + 1) / (rounds + 1.0)};
    r = crew_run(host, jobs, push_job, w, bar);
    double met = 0, deepest = 0, strands = 0;
    for (uint32_t i = 0; i < f->strands; i++) {
      met += 0.5 * w->met[i];
      strands += w->met[i] > 0;
      if ((double)w->deepest[i] > deepest) deepest = (double)w->deepest[i];
    }
    if (k == 0) f->contacts.first = met, f->contacts.deepest_first = deepest;
    f->contacts.last = met, f->contacts.deepest = deepest;
    f->contacts.rounds = k;
    f->contacts.strands = strands;
    /* the last look only counts */
    if (r || met <= 0 || k == rounds) break;
    float *old = f->points;
    f->points = w->next;
    w->next = old;
  }
  if (!r) r = crew_run(host, jobs, recount_job, w, (crew_progress){"counting", 0.98, 1});
  return r;
}

int32_t fiber_keep_apart(fiber *f, const sozai_host *host) {
  size_t bytes = ((size_t)f->strands * f->vertices * 3 + 1) * sizeof(float);
  double thickest = 0, longest = 0;
  if (host_rehearses(host)) {
    uint64_t all =
        segments_bytes(f) + bytes + (f->strands + 1ull) * (sizeof(uint32_t) + sizeof(float));
    int32_t r = host_claim(host, all);
    host_unclaim(host, all);
    return r;
  }
  for (uint32_t i = 0; i < f->strands; i++) {
    double l = strand_length(&f->plan.shape, i) / (f->vertices - 1);
    if (l > longest) longest = l;
    if ((double)f->radii[i] > thickest) thickest = (double)f->radii[i];
  }
  if ((uint64_t)f->strands * (f->vertices - 1) >> 32)
    return fail(SOZAI_ERROR_RANGE,
                "contact: %u strands of %u vertices have more than 2^32 segments", f->strands,
                f->vertices);
  segments near;
  round_work w = {.f = f, .near = &near};
  int32_t r = segments_make(&near, host, f, 1.001 * (longest + 2 * thickest + f->plan.clearance));
  w.next = host_alloc(host, bytes, 64);
  w.met = host_alloc(host, (f->strands + 1ull) * sizeof *w.met, 64);
  w.deepest = host_alloc(host, (f->strands + 1ull) * sizeof *w.deepest, 64);
  if (!w.next || !w.met || !w.deepest) r = SOZAI_ERROR_MEMORY;
  if (!r) r = run_rounds(&w, host);
  const fiber_contacts *c = &f->contacts;
  if (!r && c->strands > TOO_MANY * f->strands)
    host_log(
        host, SOZAI_LOG_WARNING,
        "contact: %.0f of %u strands still overlap others after %.0f rounds, by %.3g mm at the "
        "deepest: take %sless packing or more rounds",
        c->strands, f->strands, c->rounds, c->deepest,
        f->plan.contact == CONTACT_RIGID ? "contact=bend, " : "");
  host_free(host, w.next, bytes, 64);
  host_free(host, w.met, (f->strands + 1ull) * sizeof *w.met, 64);
  host_free(host, w.deepest, (f->strands + 1ull) * sizeof *w.deepest, 64);
  segments_free(&near, host);
  return r;
}
