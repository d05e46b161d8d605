/* SPDX-License-Identifier: Apache-2.0 */
#include "life.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "turning.h"
#include "way.h"

static double turned(double degrees) {
  double n = degrees / 360.0;
  int64_t whole = (int64_t)n;
  if ((double)whole > n) whole--;
  return degrees - 360.0 * (double)whole;
}

/* The year in which a rising function of it reaches a value, or `end`. */
static double year_of(double (*f)(const tree_plan *, double), const tree_plan *p, double value,
                      double begin, double end) {
  if (!(f(p, end) >= value)) return end;
  for (int i = 0; i < 48; i++) {
    double middle = 0.5 * (begin + end);
    if (f(p, middle) >= value) {
      end = middle;
    } else {
      begin = middle;
    }
  }
  return end;
}

/* Years that it stays when dead. */
static double years_dead(const tree_plan *p, const tree_bud *b) {
  return p->shedding * (0.5 + (double)tree_unit(hash1(b->key ^ 0x2c1b3c6du)));
}

static void live(const tree_plan *p, tree_bud *b) {
  double early = 0.85 + 0.3 * (double)tree_unit(hash1(b->key ^ 0x51ed270bu));
  b->birth = year_of(plan_height, p, b->z, 0.0, p->age);
  b->death = TREE_ALIVE;
  b->shed = TREE_ALIVE;
  if (p->crown_ratio >= 1.0 || !(plan_crown_base(p, p->age) >= b->z * early)) return;
  double death = year_of(plan_crown_base, p, b->z * early, b->birth, p->age);
  if (death < b->birth + 1.0) death = b->birth + 1.0;
  if (death >= p->age) return;
  b->death = death;
  double stays = years_dead(p, b);
  if (death + stays < p->age) b->shed = death + stays;
}

static double scatter_of(const tree_plan *p, uint32_t key) {
  double sum = 0.0;
  for (uint32_t i = 0; i < 3; i++) {
    sum += (double)tree_unit(hash1(key + 0x9e3779b9u * (i + 1)));
  }
  /* three even numbers: nearly normal, of standard deviation 1/2 */
  double s = 1.0 + p->crown_scatter * 2.0 * (sum - 1.5);
  return s > 0.15 ? s : 0.15;
}

static int is_down(const tree_plan *p, double azimuth) {
  double off = turned(azimuth - p->upslope);
  return off > 90.0 && off < 270.0;
}

static double elevation_of(const tree_plan *p, const tree_bud *b) {
  /* with the height above the crown's base at present, or at its death */
  double t = b->death >= 0.0 ? b->death : p->age;
  double top = plan_height(p, t), base = plan_crown_base(p, t);
  double up = top > base ? (b->z - base) / (top - base) : 1.0;
  if (up < p->angle_from) up = p->angle_from;
  if (up > p->angle_to) up = p->angle_to;
  double off = ((double)tree_unit(hash1(b->key ^ 0x1f83d9abu)) - 0.5) * p->angle_spread;
  double elevation = p->angle_low + (p->angle_top - p->angle_low) * up + off;
  return p->angle_chord ? way_base(p, b->key, life_length(p, b, p->age), elevation) : elevation;
}

int32_t life_make(const tree_plan *p, const sozai_host *host, tree_bud **out, uint32_t *count,
                  uint32_t *room) {
  tree_turning t;
  turning_make(&t, p);
  double a_year = t.turns * t.branches;
  *count = 0;
  *room = (uint32_t)(a_year * p->years) + (uint32_t)p->years + 2;
  tree_bud *list = *out = host_alloc(host, *room * sizeof *list, 64);
  if (!list) return SOZAI_ERROR_MEMORY;
  double top = plan_height(p, p->age), turning = 0.0, born = 0.0;
  double first = 360.0 * (double)tree_unit(hash1(p->seed ^ 0x3c6ef372u));
  double carry = (double)tree_unit(hash1(p->seed ^ 0xbb67ae85u));
  for (int year = 1; year <= p->years; year++) {
    double low = plan_height(p, year - 1), high = plan_height(p, year);
    double before = born;
    born += a_year;
    /* the branches of one year are whole ones, those of many a_year on average */
    int from = (int)(before + carry), to = (int)(born + carry), n = to - from;
    for (int i = 0; i < n && *count < *room; i++) {
      double u = p->whorls ? 1.0 - 0.06 * (double)(n - 1 - i) / n - 0.02 : (i + 0.5) / n;
      double z = low + (high - low) * (p->whorls ? u : turning_height(p, u));
      if (!(z < top - 1.0)) continue;
      tree_bud *b = &list[*count];
      b->key = hash1(p->seed * 0x9e3779b1u + hash1((uint32_t)(from + i) + 1u));
      double u_div = (double)tree_unit(hash1(b->key ^ 0xa54ff53au));
      if (p->random) {
        b->divergence = 360.0 * u_div; /* from any azimuth, so that the next is any, too */
      } else {
        b->divergence = turning_divergence(&t, u_div);
      }
      if (!*count) b->divergence = 0.0;
      turning += b->divergence;
      b->z = z;
      b->turning = turning;
      b->azimuth = turned(first + turning);
      b->year = year;
      b->down = is_down(p, b->azimuth);
      b->scatter = scatter_of(p, b->key);
      live(p, b);
      b->elevation = elevation_of(p, b);
      (*count)++;
    }
  }
  return SOZAI_OK;
}

double life_length(const tree_plan *p, const tree_bud *b, double t) {
  if (b->death >= 0.0 && t > b->death) t = b->death;
  return b->scatter * plan_reach(p, b->z, t, b->down);
}

double life_radius(const tree_plan *p, const tree_bud *b, double t) {
  if (b->death >= 0.0 && t > b->death) t = b->death;
  double r = 0.5 * p->slender * life_length(p, b, t), stem = plan_radius(p, b->z, t);
  return r < p->thickest * stem ? r : p->thickest * stem;
}

double life_left(const tree_plan *p, const tree_bud *b) {
  if (b->death < 0.0) return 1.0;
  double stays = years_dead(p, b), dead = p->age - b->death;
  double gone = dead < stays ? dead / stays : 1.0;
  return 1.0 - gone * (0.5 + 0.4 * (double)tree_unit(hash1(b->key ^ 0x7f4a7c15u)));
}
