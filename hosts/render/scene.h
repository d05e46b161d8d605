/* SPDX-License-Identifier: Apache-2.0
 * What rays meet: the shape, through Embree, and the floor below it. */
#ifndef SOZAI_RENDER_SCENE_H
#define SOZAI_RENDER_SCENE_H

#include "mesh.h"
#include "render.h"
#include "vec.h"

#define HIT_NOTHING 0
#define HIT_SHAPE 1
#define HIT_FLOOR 2

typedef struct scene {
  struct RTCDeviceTy *device;
  struct RTCSceneTy *embree;
  mesh mesh;     /* empty for a sphere */
  float *sphere; /* x y z radius, or NULL */
  vec low, high; /* the shape's bounds */
  vec up;
  bool convex; /* no ray that leaves the shape meets it again */
  bool has_floor;
  float floor; /* height along up */
  float step;  /* how far a ray starts from the surface it leaves */
} scene;

typedef struct hit {
  int what; /* HIT_* */
  float distance;
  vec point;
  vec normal;    /* unit, towards the ray's origin */
  vec geometric; /* likewise, of the flat triangle */
  bool bulges;   /* the smooth normals bend the triangle up: light comes to the surface there, */
  vec lifted;    /* where the point is then */
  uint32_t triangle; /* of the mesh */
  float u, v;        /* where on it: shares of its second and third corner */
} hit;

bool scene_open(scene *s, const render_job *job, failure *why);
void scene_close(scene *s);

hit scene_trace(const scene *s, vec origin, vec direction);
/* Whether the shape stands in the way. */
bool scene_blocked(const scene *s, vec origin, vec direction);
/* Whether nothing can stand in the way of a ray that leaves a surface on the side of the hit's
 * geometric normal. */
bool scene_sees_all(const scene *s, const hit *from);
/* The side that light has to come from. */
vec scene_lit_side(const hit *from);
/* Whether the shape stands in the way of such a ray. */
bool scene_blocked_from(const scene *s, const hit *from, vec direction);

vec scene_centre(const scene *s);
float scene_radius(const scene *s);

#endif
