/* SPDX-License-Identifier: Apache-2.0 */
#include "section.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const sozai_textures_1 *textures;
const sozai_wood_1 *woods;
char folder[256];

static void *library;
static const sozai_entry_v1 *entry;
static const sozai_images_1 *images;
static sozai_host host;
static char said[1024];
static int serving = 1;

static void keep_log(void *user, int32_t severity, const char *text) {
  (void)user, (void)severity;
  snprintf(said, sizeof said, "%s", text);
}

static const void *give(void *user, const char *id) {
  (void)user;
  return serving && strcmp(id, SOZAI_IMAGES_1) == 0 ? images : NULL;
}

int section_setup(void **state) {
  (void)state;
  library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    print_error("%s\n", dlerror());
    return -1;
  }
  entry = dlsym(library, SOZAI_ENTRY_SYMBOL);
  /* a place where no service lies: what is tested is the host's */
  if (!entry || entry->init("/nonexistent/sozai.so") != SOZAI_OK) return -1;
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  woods = entry->get_factory(SOZAI_WOOD_1);
  images = host_images_open();
  host = (sozai_host){.size = sizeof host, .log = keep_log, .get_service = give};
  snprintf(folder, sizeof folder, "/tmp/sozai-section-XXXXXX");
  return mkdtemp(folder) ? 0 : -1;
}

int section_teardown(void **state) {
  (void)state;
  entry->deinit();
  host_images_close();
  dlclose(library);
  char command[300];
  snprintf(command, sizeof command, "rm -rf '%s'", folder);
  return system(command);
}

const char *section_log(void) { return said; }
void section_serve(int yes) { serving = yes; }

const char *section_path(const char *name) {
  static char paths[2][512];
  static int turn;
  turn = !turn;
  snprintf(paths[turn], sizeof paths[turn], "%s/%s", folder, name);
  return paths[turn];
}

sozai_texture *section_wood(const char *preset, const char *parameters) {
  char text[2048];
  sozai_value values[48];
  uint32_t n = 0;
  snprintf(text, sizeof text, "%s", parameters);
  for (char *rest = text, *pair; (pair = strsep(&rest, ";"));) {
    while (*pair == ' ') pair++;
    char *equals = strchr(pair, '=');
    if (!equals) continue;
    *equals = '\0';
    assert_true(n < 48);
    values[n++] = (sozai_value){.id = pair, .kind = SOZAI_KIND_STRING, .text = equals + 1};
  }
  sozai_texture *t = NULL;
  said[0] = '\0';
  textures->create(&host, "wood", preset, values, n, &t);
  return t;
}

sozai_texture *section_make(const char *preset, const char *parameters) {
  sozai_texture *t = section_wood(preset, parameters);
  if (!t) fail_msg("%s", textures->last_error());
  return t;
}

void points_clear(points *p) { p->count = 0; }

void points_free(points *p) {
  for (int i = 0; i < 7; i++) free(p->in[i]);
  for (int i = 0; i < OUTS; i++) free(p->out[i]);
  memset(p, 0, sizeof *p);
}

void points_add(points *p, double x, double y, double z, char normal, double footprint) {
  if (p->count == p->room) {
    p->room = p->room ? 2 * p->room : 1024;
    for (int i = 0; i < 7; i++) p->in[i] = realloc(p->in[i], p->room * sizeof(float));
    for (int i = 0; i < OUTS; i++) p->out[i] = realloc(p->out[i], p->room * sizeof(float));
  }
  const double all[7] = {x, y, z, normal == 'x', normal == 'y', normal == 'z', footprint};
  for (int i = 0; i < 7; i++) p->in[i][p->count] = (float)all[i];
  p->count++;
}

void points_ask(points *p, const sozai_texture *t) {
  float *const *in = p->in;
  sozai_batch b = {.size = sizeof b,
                   .count = p->count,
                   .point = {in[0], in[1], in[2]},
                   .normal = {in[3], in[4], in[5]},
                   .light = {in[3], in[4], in[5]},
                   .footprint = in[6],
                   .out = p->out,
                   .out_count = OUTS};
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
}

double uniform(void) {
  static uint64_t state = 1;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)(state >> 11) / 9007199254740992.0;
}
