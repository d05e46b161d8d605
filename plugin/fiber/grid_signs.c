/* SPDX-License-Identifier: Apache-2.0 */
#include "grid_signs.h"

#include <string.h>

#include "../core/status.h"

static int32_t put(signs *s, const sozai_host *host, int axis, line_crossing c) {
  if (s->count[axis] == s->room[axis]) {
    uint32_t room = s->room[axis] ? 2 * s->room[axis] : 16384;
    line_crossing *more = host_alloc(host, room * sizeof *more, 64);
    if (!more) return SOZAI_ERROR_MEMORY;
    if (s->count[axis]) memcpy(more, s->list[axis], s->count[axis] * sizeof *more);
    host_free(host, s->list[axis], s->room[axis] * sizeof *more, 64);
    s->list[axis] = more;
    s->room[axis] = room;
  }
  s->list[axis][s->count[axis]++] = c;
  return SOZAI_OK;
}

/* The nodes along an axis between two places. */
static void range_of(const signs *s, int axis, float low, float high, uint32_t *from,
                     uint32_t *to) {
  double a = ((double)low - s->origin[axis]) / s->gap,
         b = ((double)high - s->origin[axis]) / s->gap;
  double last = (double)(s->nodes[axis] - 1);
  a = a - 1 > 0 ? a - 1 : 0;
  b = b + 2 < last ? b + 2 : last;
  uint32_t i = (uint32_t)a, n = (uint32_t)(b > 0 ? b : 0);
  while (i <= n && signs_place(s, axis, i) < low) i++;
  *from = i;
  while (i <= n && signs_place(s, axis, i) <= high) i++;
  *to = i;
}

static int32_t cross_triangle(signs *s, const sozai_host *host, const float corner[3][3],
                              int axis) {
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  uint32_t from[2], to[2];
  for (int k = 0; k < 2; k++) {
    int a = k ? v : u;
    float low = corner[0][a], high = low;
    for (int i = 1; i < 3; i++) {
      low = corner[i][a] < low ? corner[i][a] : low;
      high = corner[i][a] > high ? corner[i][a] : high;
    }
    range_of(s, a, low, high, &from[k], &to[k]);
    if (from[k] == to[k]) return SOZAI_OK;
  }
  for (uint32_t j = from[1]; j < to[1]; j++) {
    for (uint32_t i = from[0]; i < to[0]; i++) {
      float q[2] = {signs_place(s, u, i), signs_place(s, v, j)};
      line_crossing c = {.line = i + s->nodes[u] * j};
      c.turn = hull_crossing(corner, axis, q, &c.at);
      int32_t r = c.turn ? put(s, host, axis, c) : SOZAI_OK;
      if (r) return r;
    }
  }
  return SOZAI_OK;
}

/* Crossings in the order of their lines. */
static int32_t sort_lines(signs *s, const sozai_host *host, int axis) {
  uint32_t lines = s->nodes[(axis + 1) % 3] * s->nodes[(axis + 2) % 3], n = s->count[axis];
  uint32_t *first = host_alloc(host, (lines + 2) * sizeof *first, 64);
  line_crossing *sorted = host_alloc(host, (n + 1) * sizeof *sorted, 64);
  if (!first || !sorted) {
    host_free(host, first, (lines + 2) * sizeof *first, 64);
    host_free(host, sorted, (n + 1) * sizeof *sorted, 64);
    return SOZAI_ERROR_MEMORY;
  }
  for (uint32_t i = 0; i < n; i++) first[s->list[axis][i].line + 2]++;
  for (uint32_t i = 2; i < lines + 2; i++) first[i] += first[i - 1];
  for (uint32_t i = 0; i < n; i++) sorted[first[s->list[axis][i].line + 1]++] = s->list[axis][i];
  host_free(host, s->list[axis], s->room[axis] * sizeof *sorted, 64);
  s->list[axis] = sorted;
  s->room[axis] = n + 1;
  s->first[axis] = first;
  s->lines[axis] = lines;
  return SOZAI_OK;
}

int32_t signs_make(signs *s, const sozai_host *host, const hull *h, const double origin[3],
                   double gap, const uint32_t nodes[3]) {
  memset(s, 0, sizeof *s);
  s->rule = h->rule;
  s->axes = h->rule == HULL_VOTE ? 3 : 1;
  s->gap = gap;
  for (int a = 0; a < 3; a++) s->origin[a] = origin[a], s->nodes[a] = nodes[a];
  int32_t r = SOZAI_OK;
  for (uint32_t i = 0; !r && i < h->items; i++) {
    float corner[3][3];
    const hull_leaf *l = &h->leaves[i / HULL_LEAF];
    for (int k = 0; k < 9; k++) corner[k / 3][k % 3] = l->corner[k / 3][k % 3][i % HULL_LEAF];
    for (int a = 0; !r && a < s->axes; a++)
      r = cross_triangle(s, host, (const float(*)[3])corner, a);
  }
  for (int a = 0; !r && a < s->axes; a++) r = sort_lines(s, host, a);
  return r;
}

void signs_free(signs *s, const sozai_host *host) {
  for (int a = 0; a < 3; a++) {
    host_free(host, s->list[a], s->room[a] * sizeof *s->list[a], 64);
    host_free(host, s->first[a], s->first[a] ? (s->lines[a] + 2) * sizeof *s->first[a] : 0, 64);
  }
}

int signs_inside(const signs *s, const uint32_t node[3]) {
  int votes = 0;
  for (int a = 0; a < s->axes; a++) {
    int u = (a + 1) % 3, v = (a + 2) % 3, above = 0, odd[2] = {0, 0};
    uint32_t line = node[u] + s->nodes[u] * node[v];
    double x = (double)signs_place(s, a, node[a]);
    for (uint32_t i = s->first[a][line]; i < s->first[a][line + 1]; i++) {
      int beyond = s->list[a][i].at > x;
      if (beyond) above += s->list[a][i].turn;
      odd[beyond] ^= 1;
    }
    if (s->rule == HULL_WINDING) return above != 0;
    if (s->rule == HULL_PARITY) return odd[1];
    votes += odd[0] + odd[1];
  }
  return votes >= 4;
}
