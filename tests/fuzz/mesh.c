/* SPDX-License-Identifier: Apache-2.0
 * What becomes of Assimp's answer: scenes as no file should give them. The source itself, for its
 * parts that have no name outside. */
#include "../../hosts/common/mesh.c"

#include "mesh_check.h"

#define PARTS 4
#define MOST 30

typedef struct part {
  struct aiMesh mesh;
  struct aiVector3D points[MOST], normals[MOST], uvs[MOST];
  struct aiFace faces[MOST];
  unsigned indices[MOST][4];
} part;

static struct aiVector3D vector(bytes *b) {
  struct aiVector3D v = {take_float(b), (float)take_u8(b), (float)take_u8(b)};
  return v;
}

/* Faces of 0 to 4 corners, all within the part's points: Assimp promises as much. */
static void take_part(part *p, bytes *b) {
  uint8_t what = take_u8(b);
  memset(p, 0, sizeof *p);
  p->mesh.mNumVertices = 1 + take_u8(b) % (unsigned)MOST;
  p->mesh.mNumFaces = take_u8(b) % (MOST + 1u);
  p->mesh.mVertices = p->points;
  if (what & 1) p->mesh.mNormals = p->normals;
  if (what & 2) p->mesh.mTextureCoords[0] = p->uvs;
  p->mesh.mFaces = p->faces;
  for (unsigned i = 0; i < p->mesh.mNumVertices; i++) {
    p->points[i] = vector(b);
    if (what & 1) p->normals[i] = vector(b);
    if (what & 2) p->uvs[i] = vector(b);
  }
  for (unsigned i = 0; i < p->mesh.mNumFaces; i++) {
    p->faces[i].mNumIndices = what & 4 ? take_u8(b) % 5u : 3;
    p->faces[i].mIndices = p->indices[i];
    for (int k = 0; k < 4; k++) p->indices[i][k] = take_u8(b) % p->mesh.mNumVertices;
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static part parts[PARTS];
  struct aiMesh *list[PARTS];
  bytes b = {data, size};
  struct aiScene scene;
  memset(&scene, 0, sizeof scene);
  scene.mNumMeshes = take_below(&b, PARTS + 1);
  scene.mMeshes = list;
  for (unsigned i = 0; i < scene.mNumMeshes; i++) {
    take_part(&parts[i], &b);
    list[i] = &parts[i].mesh;
  }
  const float scales[] = {1, 1e-6f, 1e6f};
  mesh m;
  failure why = {0, ""};
  if (!convert(&m, &scene, "m.obj", scales[take_below(&b, 3)], &why)) {
    CHECK(*why.text);
    return 0;
  }
  mesh_check(&m);
  mesh_free(&m);
  return 0;
}
