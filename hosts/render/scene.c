/* SPDX-License-Identifier: Apache-2.0 */
#include "scene.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "shapes.h"

static bool embree_failed(const scene *s, failure *why) {
  return fail(why, EXIT_FAILURE, "Embree: error %d",
              s->device ? (int)rtcGetDeviceError(s->device) : (int)rtcGetDeviceError(NULL));
}

static void grow(scene *s, vec p) {
  s->low = (vec){fminf(s->low.x, p.x), fminf(s->low.y, p.y), fminf(s->low.z, p.z)};
  s->high = (vec){fmaxf(s->high.x, p.x), fmaxf(s->high.y, p.y), fmaxf(s->high.z, p.z)};
}

static bool make_mesh(scene *s, const render_job *job, failure *why) {
  switch (job->shape) {
  case SHAPE_GIVEN:
    s->mesh = *job->given;
    return true;
  case SHAPE_PLANE:
    return shape_plane(&s->mesh, job->size, why);
  case SHAPE_MESH:
    return mesh_read(&s->mesh, job->mesh, job->mesh_scale, why);
  default:
    return shape_board(&s->mesh, job->size, job->bevel, why);
  }
}

static RTCGeometry triangles(scene *s) {
  RTCGeometry g = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, s->mesh.points, 0,
                             3 * sizeof(float), s->mesh.point_count);
  rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, s->mesh.indices, 0,
                             3 * sizeof(uint32_t), s->mesh.triangle_count);
  for (uint32_t i = 0; i < s->mesh.point_count; i++) {
    const float *p = s->mesh.points + 3 * (size_t)i;
    grow(s, (vec){p[0], p[1], p[2]});
  }
  return g;
}

static RTCGeometry sphere(scene *s, double diameter) {
  float radius = (float)(diameter / 2);
  s->sphere[3] = radius;
  RTCGeometry g = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, s->sphere, 0,
                             4 * sizeof(float), 1);
  s->low = (vec){-radius, -radius, -radius};
  s->high = (vec){radius, radius, radius};
  return g;
}

static bool build(scene *s, const render_job *job, failure *why) {
  /* One thread builds the same tree every time, and trees this small as fast. */
  s->device = rtcNewDevice("threads=1");
  if (!s->device) return embree_failed(s, why);
  s->embree = rtcNewScene(s->device);
  /* No ray slips between two triangles, whichever is tested first. */
  rtcSetSceneFlags(s->embree, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry g = s->sphere ? sphere(s, job->size[0]) : triangles(s);
  rtcCommitGeometry(g);
  rtcAttachGeometry(s->embree, g);
  rtcReleaseGeometry(g);
  rtcCommitScene(s->embree);
  return rtcGetDeviceError(s->device) == RTC_ERROR_NONE || embree_failed(s, why);
}

static bool has_area(const mesh *m) {
  for (size_t i = 0; i < m->triangle_count; i++) {
    const float *p[3];
    for (size_t k = 0; k < 3; k++) p[k] = m->points + 3 * (size_t)m->indices[3 * i + k];
    double a[3], b[3];
    for (int k = 0; k < 3; k++) {
      a[k] = (double)p[1][k] - (double)p[0][k];
      b[k] = (double)p[2][k] - (double)p[0][k];
    }
    for (int k = 0; k < 3; k++)
      if (a[k] * b[(k + 1) % 3] != a[(k + 1) % 3] * b[k]) return true;
  }
  return false;
}

/* What a camera can be drawn back from: it stands among floats as the points do. */
static bool has_extent(const scene *s, const char *path, failure *why) {
  vec size = vec_sub(s->high, s->low), a = s->low, b = s->high;
  float longest = fmaxf(size.x, fmaxf(size.y, size.z));
  float farthest = fmaxf(fmaxf(fmaxf(-a.x, b.x), fmaxf(-a.y, b.y)), fmaxf(-a.z, b.z));
  double least = fmax(1e-3, 1e-5 * (double)farthest);
  if ((double)longest < least)
    return fail(why, EXIT_BAD_INPUT,
                "%s: the longest side of its box is %g mm: at least %g where it is", path,
                (double)longest, least);
  return has_area(&s->mesh) ||
         fail(why, EXIT_BAD_INPUT, "%s: none of its %u triangles has any area", path,
              s->mesh.triangle_count);
}

bool scene_open(scene *s, const render_job *job, failure *why) {
  memset(s, 0, sizeof *s);
  s->low = (vec){INFINITY, INFINITY, INFINITY};
  s->high = (vec){-INFINITY, -INFINITY, -INFINITY};
  s->up = job->y_up ? (vec){0, 1, 0} : (vec){0, 0, 1};
  bool ok;
  if (job->shape == SHAPE_SPHERE) {
    s->sphere = calloc(4, sizeof *s->sphere);
    ok = s->sphere ? true : fail(why, EXIT_FAILURE, "out of memory");
  } else
    ok = make_mesh(s, job, why);
  if (!ok || !build(s, job, why) || (job->shape == SHAPE_MESH && !has_extent(s, job->mesh, why))) {
    scene_close(s);
    return false;
  }
  s->step = 2e-5f * scene_radius(s);
  s->convex = job->shape != SHAPE_GIVEN && job->shape != SHAPE_MESH;
  s->has_floor = job->floor;
  /* A sheet lies a little above the floor, for the floor not to show through. */
  s->floor = vec_dot(s->low, s->up) - (job->shape == SHAPE_PLANE ? 4 * s->step : 0);
  return true;
}

void scene_close(scene *s) {
  if (s->embree) rtcReleaseScene(s->embree);
  if (s->device) rtcReleaseDevice(s->device);
  mesh_free(&s->mesh);
  free(s->sphere);
  memset(s, 0, sizeof *s);
}

vec scene_centre(const scene *s) { return vec_scale(0.5f, vec_add(s->low, s->high)); }
float scene_radius(const scene *s) { return 0.5f * vec_length(vec_sub(s->high, s->low)); }

static vec point_of(const float *array, uint32_t index) {
  const float *p = array + 3 * (size_t)index;
  return (vec){p[0], p[1], p[2]};
}

static vec blend(vec a, vec b, vec c, float u, float v) {
  return vec_add(vec_scale(1 - u - v, a), vec_add(vec_scale(u, b), vec_scale(v, c)));
}

/* The point from the triangle's corners, not along the ray: exact to the mesh
 * however far the camera stands. */
static void refine_triangle(const scene *s, uint32_t triangle, float u, float v, hit *h) {
  const uint32_t *t = s->mesh.indices + 3 * (size_t)triangle;
  h->point = blend(point_of(s->mesh.points, t[0]), point_of(s->mesh.points, t[1]),
                   point_of(s->mesh.points, t[2]), u, v);
  vec n = blend(point_of(s->mesh.normals, t[0]), point_of(s->mesh.normals, t[1]),
                point_of(s->mesh.normals, t[2]), u, v);
  h->normal = vec_length(n) > 1e-6f ? vec_unit(n) : h->geometric;
}

/* A triangle whose corners' normals lean apart stands for a surface that bulges: its points are
 * lifted on to the corners' tangent planes, so that the edge of its own shadow is no staircase of
 * triangles (Hanika 2021, Hacking the Shadow Terminator, Ray Tracing Gems II). */
static void lift(const scene *s, uint32_t triangle, float u, float v, hit *h) {
  const uint32_t *t = s->mesh.indices + 3 * (size_t)triangle;
  vec to[3];
  float most = 0;
  for (int i = 0; i < 3; i++) {
    vec n = point_of(s->mesh.normals, t[i]);
    if (vec_dot(n, h->geometric) < 0) n = vec_scale(-1, n);
    float below = fminf(vec_dot(vec_sub(h->point, point_of(s->mesh.points, t[i])), n), 0);
    to[i] = vec_along(h->point, -below, n);
    most = fmaxf(most, -below);
  }
  h->bulges = most > 0;
  if (h->bulges) h->lifted = blend(to[0], to[1], to[2], u, v);
}

static void refine_sphere(const scene *s, hit *h) {
  h->normal = h->geometric = vec_unit(h->point);
  h->point = vec_scale(s->sphere[3], h->normal);
}

static vec facing(vec n, vec direction) { return vec_dot(n, direction) > 0 ? vec_scale(-1, n) : n; }

static struct RTCRay ray_of(vec origin, vec direction) {
  struct RTCRay ray;
  memset(&ray, 0, sizeof ray);
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tfar = INFINITY;
  ray.mask = ~0u;
  return ray;
}

static bool trace_floor(const scene *s, vec origin, vec direction, hit *h) {
  float slope = vec_dot(direction, s->up);
  if (!s->has_floor || !(slope < -1e-6f)) return false;
  h->distance = (s->floor - vec_dot(origin, s->up)) / slope;
  h->point = vec_along(origin, h->distance, direction);
  h->normal = h->geometric = s->up;
  h->what = HIT_FLOOR;
  return h->distance > 0;
}

hit scene_trace(const scene *s, vec origin, vec direction) {
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  struct RTCRayHit r;
  memset(&r, 0, sizeof r);
  r.ray = ray_of(origin, direction);
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(s->embree, &context, &r);
  hit h = {.what = HIT_NOTHING};
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    if (!trace_floor(s, origin, direction, &h)) h = (hit){.what = HIT_NOTHING};
    return h;
  }
  h.what = HIT_SHAPE;
  h.distance = r.ray.tfar;
  h.point = vec_along(origin, h.distance, direction);
  h.geometric = vec_unit((vec){r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z});
  if (s->sphere)
    refine_sphere(s, &h);
  else {
    h.triangle = r.hit.primID;
    h.u = r.hit.u;
    h.v = r.hit.v;
    refine_triangle(s, r.hit.primID, r.hit.u, r.hit.v, &h);
  }
  h.geometric = facing(h.geometric, direction);
  if (!s->sphere) lift(s, h.triangle, h.u, h.v, &h);
  /* The smooth normal goes with its face; where it turns away from the eye
   * even so, at silhouettes, the face's own is better than none. */
  if (vec_dot(h.normal, h.geometric) < 0) h.normal = vec_scale(-1, h.normal);
  if (vec_dot(h.normal, direction) > 0) h.normal = h.geometric;
  return h;
}

bool scene_blocked(const scene *s, vec origin, vec direction) {
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  struct RTCRay ray = ray_of(origin, direction);
  rtcOccluded1(s->embree, &context, &ray);
  return ray.tfar < 0;
}

bool scene_sees_all(const scene *s, const hit *from) {
  return s->convex && from->what == HIT_SHAPE;
}

vec scene_lit_side(const hit *from) { return from->bulges ? from->normal : from->geometric; }

bool scene_blocked_from(const scene *s, const hit *from, vec direction) {
  if (scene_sees_all(s, from)) return false;
  vec start = from->bulges ? from->lifted : from->point;
  return scene_blocked(s, vec_along(start, s->step, from->geometric), direction);
}
