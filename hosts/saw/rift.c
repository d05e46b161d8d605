/* SPDX-License-Identifier: Apache-2.0
 *
 * Rift-sawn: wedges round the log, and of each a board whose rings stand at 30
 * to 60 degrees to its face, 45 about its middle. Between the first and widest
 * boards go narrower ones, as long as any fits. */
#include "plan.h"

#include <math.h>

#define ROOT3 1.7320508075688772
#define OFFSETS 32 /* places that are tried for the next boards: from the pith, */
#define TURNS 10   /* round it, */
#define SPANS 8    /* and along the face */

/* A board in a frame turned by `turn` degrees: s0 to s1 along its face, its
 * middle p from the pith. */
typedef struct {
  double p, s0, s1, turn;
} place;

/* As far along the face as the rings' angle and the bark allow. */
static place widest(const saw_job *job, double p) {
  double half = 0.5 * job->thickness;
  place w = {.p = p, .s0 = (p + half) / ROOT3};
  w.s1 = fmin(ROOT3 * (p - half), saw_half_chord(job, p + half));
  if (job->width > 0 && w.s1 - w.s0 > job->width) w.s0 = w.s1 - job->width;
  return w;
}

static saw_board board_at(const saw_job *job, const place *w, double azimuth) {
  saw_board b = {.plan = job->plan,
                 .rotation = azimuth + w->turn,
                 .width = w->s1 - w->s0,
                 .thickness = job->thickness};
  double along[2], out[2], s = 0.5 * (w->s0 + w->s1);
  saw_board_axes(&b, along, out);
  for (int i = 0; i < 2; i++) b.centre[i] = s * along[i] + w->p * out[i];
  return b;
}

/* Whether n of them round the log leave one another the kerf. */
static bool round_fits(const saw_job *job, const place *w, int n) {
  saw_board first = board_at(job, w, 0);
  for (int i = 1; i <= n / 2; i++) {
    saw_board other = board_at(job, w, 360.0 * i / n);
    if (saw_gap(&first, &other) < job->kerf) return false;
  }
  return true;
}

static bool free_of(const saw_plan *p, const saw_job *job, const place *w) {
  saw_board b = board_at(job, w, job->azimuth);
  for (size_t i = 0; i < p->count; i++) {
    const saw_board *o = &p->boards[i];
    double far = hypot(b.centre[0] - o->centre[0], b.centre[1] - o->centre[1]);
    double reach = 0.5 * (b.width + b.thickness + o->width + o->thickness) + job->kerf;
    if (far < reach && saw_gap(&b, o) < job->kerf) return false;
  }
  return true;
}

static bool add_round(saw_plan *p, const saw_job *job, const place *w, int n, failure *why) {
  for (int i = 0; i < n; i++) {
    double azimuth = job->azimuth + 360.0 * i / n + w->turn;
    if (!saw_add(p, job, azimuth, w->s0, w->s1, w->p - 0.5 * job->thickness, why)) return false;
  }
  return true;
}

/* The widest boards at one offset, as many as there is room for round the log. */
static int first_round(const saw_job *job, double p, place *out) {
  *out = widest(job, p);
  if (out->s1 - out->s0 < saw_least_width(job)) return 0;
  double room = 2 * SAW_PI * out->s0 / (job->thickness + job->kerf);
  int n = room < SAW_MOST_BOARDS ? (int)room + 1 : SAW_MOST_BOARDS;
  while (n > 0 && !round_fits(job, out, n)) n--;
  return n;
}

/* The widest that fits at one offset and turn, with its inner or its outer end
 * drawn in. */
static bool try_spans(const saw_plan *p, const saw_job *job, place whole, int n, place *best) {
  double span = whole.s1 - whole.s0, least = saw_least_width(job);
  for (int i = 0; i < 2 * SPANS; i++) {
    place w = whole;
    double less = span * (i / 2) / SPANS;
    if (i % 2)
      w.s1 -= less;
    else
      w.s0 += less;
    double width = w.s1 - w.s0;
    if (width < least || width <= best->s1 - best->s0) return false;
    if (!free_of(p, job, &w) || !round_fits(job, &w, n)) continue;
    *best = w;
    return true;
  }
  return false;
}

static bool next_round(const saw_plan *p, const saw_job *job, int n, place *best) {
  *best = (place){0};
  for (int i = 1; i < OFFSETS; i++) {
    for (int k = 0; k < TURNS; k++) {
      place w = widest(job, job->radius * i / OFFSETS);
      w.turn = 360.0 * k / (TURNS * n);
      try_spans(p, job, w, n, best);
    }
  }
  return best->s1 > best->s0;
}

/* share: of the boards that the first round has room for. */
static bool fill(saw_plan *p, const saw_job *job, double offset, double share, failure *why) {
  place w;
  p->count = 0;
  int room = first_round(job, offset, &w), n = (int)(room * share + 0.5);
  if (room > 0 && n < 1) n = 1;
  while (n > 0) {
    if (!add_round(p, job, &w, n, why)) return false;
    if (!next_round(p, job, n, &w)) break;
  }
  return true;
}

/* What a plan is worth: of two with as much wood the one of wider boards is better. */
static double worth(const saw_plan *p) {
  double sum = 0;
  for (size_t i = 0; i < p->count; i++) sum += p->boards[i].width * p->boards[i].width;
  return sum;
}

/* Which first round leaves the best room for the others is tried: how far out it
 * lies, and whether there is more to be had of fewer boards in it. */
bool saw_rift(saw_plan *p, const saw_job *job, failure *why) {
  static const double shares[] = {1, 0.75, 0.5};
  double best = 0, offset = job->radius / 2, share = 1;
  for (int i = 1; i < OFFSETS; i++) {
    for (size_t k = 0; k < sizeof shares / sizeof *shares; k++) {
      failure ignored;
      double at = job->radius * i / OFFSETS;
      if (!fill(p, job, at, shares[k], &ignored)) continue;
      double value = worth(p);
      if (value <= best) continue;
      best = value;
      offset = at;
      share = shares[k];
    }
  }
  /* too many at every offset is a failure, with its reason */
  return fill(p, job, offset, share, why);
}
