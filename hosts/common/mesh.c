/* SPDX-License-Identifier: Apache-2.0 */
#include "mesh.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "mesh_ply.h"
#include "ceilings.h"

bool mesh_allocate(mesh *m, uint32_t points, uint32_t triangles, failure *why) {
  memset(m, 0, sizeof *m);
  /* Embree reads 16 bytes at the last point: one float more than there are. */
  m->points = calloc(3 * (size_t)points + 1, sizeof(float));
  m->normals = calloc(3 * (size_t)points + 1, sizeof(float));
  m->indices = calloc(3 * (size_t)triangles + 1, sizeof(uint32_t));
  m->point_count = points;
  m->triangle_count = triangles;
  if (m->points && m->normals && m->indices) return true;
  mesh_free(m);
  return fail(why, EXIT_FAILURE, "out of memory for a mesh of %u triangles", triangles);
}

void mesh_free(mesh *m) {
  free(m->points);
  free(m->normals);
  free(m->indices);
  free(m->uvs);
  memset(m, 0, sizeof *m);
}

/* A normal that is no number is as none: the face's own is used. */
static float finite_or_zero(float x) { return isfinite(x) ? x : 0; }

/* The first set of UVs: what other programs show. */
static void append_uvs(const mesh *m, const struct aiMesh *part) {
  float *uv = m->uvs + 2 * (size_t)m->point_count;
  const struct aiVector3D *from = part->mTextureCoords[0];
  for (uint32_t i = 0; i < part->mNumVertices; i++) {
    uv[2 * (size_t)i] = from ? from[i].x : NAN;
    uv[2 * (size_t)i + 1] = from ? from[i].y : NAN;
  }
}

/* As of a hull (plugin/fiber/hull.c), and of what textures tell apart. */
#define FARTHEST 1e6f

/* Points are counted from 0 as faces come upon them: so they are read. */
static bool check_points(const mesh *m, const char *path, failure *why) {
  for (size_t i = 0; i < 3 * (size_t)m->point_count; i++) {
    double at = (double)m->points[i];
    if (isnan(at))
      return fail(why, EXIT_BAD_INPUT, "%s: %c of point %zu is nan, which is no place", path,
                  "xyz"[i % 3], i / 3);
    if (!(fabs(at) <= (double)FARTHEST))
      return fail(why, EXIT_BAD_INPUT,
                  "%s: %c of point %zu is %g mm: outside -1000000 to 1000000 mm", path,
                  "xyz"[i % 3], i / 3, at);
  }
  return true;
}

static void append(mesh *m, const struct aiMesh *part, float scale) {
  uint32_t base = m->point_count;
  for (uint32_t i = 0; i < part->mNumVertices; i++) {
    float *p = m->points + 3 * (size_t)(base + i);
    float *n = m->normals + 3 * (size_t)(base + i);
    p[0] = scale * part->mVertices[i].x;
    p[1] = scale * part->mVertices[i].y;
    p[2] = scale * part->mVertices[i].z;
    if (!part->mNormals) continue; /* stays 0: the face's own is used */
    n[0] = finite_or_zero(part->mNormals[i].x);
    n[1] = finite_or_zero(part->mNormals[i].y);
    n[2] = finite_or_zero(part->mNormals[i].z);
  }
  if (m->uvs) append_uvs(m, part);
  m->point_count += part->mNumVertices;
  for (uint32_t f = 0; f < part->mNumFaces; f++) {
    const struct aiFace *face = &part->mFaces[f];
    if (face->mNumIndices != 3) continue; /* points and lines */
    uint32_t *t = m->indices + 3 * (size_t)m->triangle_count++;
    for (int k = 0; k < 3; k++) t[k] = base + face->mIndices[k];
  }
}

static bool convert(mesh *m, const struct aiScene *scene, const char *path, float scale,
                    failure *why) {
  uint64_t points = 0, triangles = 0;
  bool unwrapped = false;
  for (uint32_t i = 0; i < scene->mNumMeshes; i++) {
    points += scene->mMeshes[i]->mNumVertices;
    triangles += scene->mMeshes[i]->mNumFaces;
    unwrapped = unwrapped || scene->mMeshes[i]->mTextureCoords[0];
  }
  if (!limits_check(HOST_LIMIT_MESH_POINTS, points, path, why) ||
      !limits_check(HOST_LIMIT_MESH_TRIANGLES, triangles, path, why))
    return false;
  if (!mesh_allocate(m, (uint32_t)points, (uint32_t)triangles, why)) return false;
  if (unwrapped && !(m->uvs = malloc(2 * sizeof *m->uvs * ((size_t)points + 1)))) {
    mesh_free(m);
    return fail(why, EXIT_FAILURE, "out of memory for the UVs of %llu points",
                (unsigned long long)points);
  }
  m->point_count = m->triangle_count = 0; /* append counts what it uses */
  for (uint32_t i = 0; i < scene->mNumMeshes; i++) append(m, scene->mMeshes[i], scale);
  if (m->triangle_count > 0 ? check_points(m, path, why)
                            : fail(why, EXIT_BAD_INPUT, "%s has no triangles", path))
    return true;
  mesh_free(m);
  return false;
}

bool mesh_read(mesh *m, const char *path, double scale, failure *why) {
  memset(m, 0, sizeof *m);
  struct stat status;
  int unread = access(path, R_OK) != 0 || stat(path, &status) != 0;
  if (unread || !S_ISREG(status.st_mode))
    return fail(why, EXIT_BAD_INPUT, "cannot read mesh '%s': %s", path,
                unread ? strerror(errno) : "not a regular file");
  if (!limits_check(HOST_LIMIT_MESH_FILE_BYTES, (uint64_t)status.st_size, path, why)) return false;
  if (!mesh_ply_plausible(path, why)) return false;
  struct aiPropertyStore *settings = aiCreatePropertyStore();
  if (settings) aiSetImportPropertyFloat(settings, AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 45);
  const struct aiScene *scene = aiImportFileExWithProperties(
      path,
      aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_GenSmoothNormals |
          aiProcess_PreTransformVertices | aiProcess_SortByPType,
      NULL, settings);
  if (settings) aiReleasePropertyStore(settings);
  if (!scene) return fail(why, EXIT_BAD_INPUT, "%s: %s", path, aiGetErrorString());
  bool ok = convert(m, scene, path, (float)scale, why);
  aiReleaseImport(scene);
  return ok;
}
