/* SPDX-License-Identifier: Apache-2.0 */
#include "strands.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Catmull and Rom's curve through b and c, at t of the way. */
static float through(float a, float b, float c, float d, float t) {
  return b + 0.5f * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

static void put_curve(strands *s, const sozai_curves *c, uint64_t curve, uint32_t smooth,
                      uint64_t *vertex, uint64_t *segment) {
  uint64_t begin = c->first[curve], end = c->first[curve + 1];
  for (uint64_t i = begin; i < end; i++) {
    uint64_t before = i > begin ? i - 1 : i, next = i + 1 < end ? i + 1 : i;
    uint64_t after = i + 2 < end ? i + 2 : next;
    for (uint32_t k = 0; k < (i + 1 < end ? smooth : 1); k++) {
      float t = (float)k / (float)smooth, *to = s->vertices + 4 * *vertex;
      for (uint64_t a = 0; a < 3; a++)
        to[a] = through(c->points[3 * before + a], c->points[3 * i + a], c->points[3 * next + a],
                        c->points[3 * after + a], t);
      to[3] = c->radii[i] + t * (c->radii[next] - c->radii[i]);
      if (i + 1 < end) {
        s->owner[*segment] = (uint32_t)curve;
        s->flags[*segment] =
            (unsigned char)((i > begin || k ? RTC_CURVE_FLAG_NEIGHBOR_LEFT : 0) |
                            (i + 2 < end || k + 1 < smooth ? RTC_CURVE_FLAG_NEIGHBOR_RIGHT : 0));
        s->indices[(*segment)++] = (uint32_t)*vertex;
      }
      (*vertex)++;
    }
  }
}

static bool allocate(strands *s, const sozai_curves *c, uint32_t smooth, failure *why) {
  uint64_t segments = (c->point_count - c->curve_count) * smooth;
  uint64_t vertices = segments + c->curve_count;
  if (vertices >> 32)
    return fail(why, EXIT_FAILURE, "%llu points are too many to be seen",
                (unsigned long long)vertices);
  s->vertices = calloc(4 * (size_t)vertices + 4, sizeof(float));
  s->indices = calloc((size_t)segments + 1, sizeof(uint32_t));
  s->owner = calloc((size_t)segments + 1, sizeof(uint32_t));
  s->flags = calloc((size_t)segments + 1, 1);
  if (!s->vertices || !s->indices || !s->owner || !s->flags)
    return fail(why, EXIT_FAILURE, "out of memory for %llu segments", (unsigned long long)segments);
  for (uint64_t i = 0; i < c->curve_count; i++)
    put_curve(s, c, i, smooth, &s->vertex_count, &s->segment_count);
  return true;
}

static bool build(strands *s, failure *why) {
  scene *sc = &s->scene;
  sc->device = rtcNewDevice("threads=1");
  if (!sc->device) return fail(why, EXIT_FAILURE, "Embree: error %d", (int)rtcGetDeviceError(NULL));
  sc->embree = rtcNewScene(sc->device);
  RTCGeometry g = rtcNewGeometry(sc->device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, s->vertices, 0,
                             4 * sizeof(float), s->vertex_count);
  rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, s->indices, 0,
                             sizeof(uint32_t), s->segment_count);
  rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, s->flags, 0, 1,
                             s->segment_count);
  rtcCommitGeometry(g);
  rtcAttachGeometry(sc->embree, g);
  rtcReleaseGeometry(g);
  rtcCommitScene(sc->embree);
  int error = (int)rtcGetDeviceError(sc->device);
  return error == RTC_ERROR_NONE || fail(why, EXIT_FAILURE, "Embree: error %d", error);
}

/* The height below which a few vertices in a thousand hang: what lies on a floor
 * bends where it touches, and does not stand on one hair. */
static float resting(const strands *s) {
  enum { BINS = 512 };
  uint64_t bins[BINS] = {0}, below = 0;
  const scene *sc = &s->scene;
  float span = sc->high.y - sc->low.y;
  if (!(span > 0)) return sc->low.y;
  for (uint64_t i = 0; i < s->vertex_count; i++) {
    float t = (s->vertices[4 * i + 1] - sc->low.y) / span * BINS;
    bins[t < 0 ? 0 : t >= BINS ? BINS - 1 : (int)t]++;
  }
  int k = 0;
  while (k < BINS && (below += bins[k]) * 250 < s->vertex_count) k++;
  return sc->low.y + span * (float)k / BINS;
}

bool strands_open(strands *s, const sozai_curves *c, uint32_t smooth, bool floor, failure *why) {
  memset(s, 0, sizeof *s);
  scene *sc = &s->scene;
  sc->low = (vec){INFINITY, INFINITY, INFINITY};
  sc->high = (vec){-INFINITY, -INFINITY, -INFINITY};
  sc->up = (vec){0, 1, 0};
  if (!allocate(s, c, smooth, why) || !build(s, why)) {
    strands_close(s);
    return false;
  }
  for (uint64_t i = 0; i < s->vertex_count; i++) {
    const float *p = s->vertices + 4 * i;
    sc->low = (vec){fminf(sc->low.x, p[0] - p[3]), fminf(sc->low.y, p[1] - p[3]),
                    fminf(sc->low.z, p[2] - p[3])};
    sc->high = (vec){fmaxf(sc->high.x, p[0] + p[3]), fmaxf(sc->high.y, p[1] + p[3]),
                     fmaxf(sc->high.z, p[2] + p[3])};
  }
  sc->step = 2e-5f * scene_radius(sc);
  sc->has_floor = floor;
  sc->floor = resting(s);
  return true;
}

void strands_close(strands *s) {
  scene_close(&s->scene);
  free(s->vertices);
  free(s->indices);
  free(s->owner);
  free(s->flags);
  memset(s, 0, sizeof *s);
}

bool strands_trace(const strands *s, vec origin, vec direction, strand_hit *h) {
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  struct RTCRayHit r;
  memset(&r, 0, sizeof r);
  r.ray.org_x = origin.x, r.ray.org_y = origin.y, r.ray.org_z = origin.z;
  r.ray.dir_x = direction.x, r.ray.dir_y = direction.y, r.ray.dir_z = direction.z;
  r.ray.tfar = INFINITY;
  r.ray.mask = ~0u;
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(s->scene.embree, &context, &r);
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  const float *a = s->vertices + 4 * (size_t)s->indices[r.hit.primID], *b = a + 4;
  h->curve = s->owner[r.hit.primID];
  h->distance = r.ray.tfar;
  h->point = vec_along(origin, h->distance, direction);
  h->tangent = vec_unit((vec){b[0] - a[0], b[1] - a[1], b[2] - a[2]});
  h->radius = a[3] + r.hit.u * (b[3] - a[3]);
  vec n = vec_unit((vec){r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z});
  n = vec_along(n, -vec_dot(n, h->tangent), h->tangent);
  if (vec_length(n) < 1e-4f) n = vec_along(direction, -vec_dot(direction, h->tangent), h->tangent);
  if (vec_length(n) < 1e-4f) vec_frame(h->tangent, &n, &(vec){0, 0, 0});
  h->normal = vec_unit(n);
  return true;
}

vec strand_leave(const strand_hit *h, vec direction) {
  vec middle = vec_along(h->point, -h->radius, h->normal);
  vec flat = vec_along(direction, -vec_dot(direction, h->tangent), h->tangent);
  float l = vec_length(flat);
  vec out = l > 1e-4f ? vec_scale(1 / l, flat) : h->normal;
  return vec_along(middle, 1.03f * h->radius, out);
}
