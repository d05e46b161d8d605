/* SPDX-License-Identifier: Apache-2.0
 *
 * Where palettes are converted: by the host's own colour service, by the one
 * beside the plugin, or, with neither, by sRGB's formula.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sozai_colour.h"

/* One tissue, nothing on it: albedo is the colour as converted. */
static const sozai_value plain[] = {
    {.id = "porosity", .kind = SOZAI_KIND_CHOICE, .text = "none"},
    {.id = "fibre_brightness", .kind = SOZAI_KIND_FLOAT},
    {.id = "latewood_colour", .kind = SOZAI_KIND_COLOUR, .number = {0.5, 0.25, 0.75}},
    {.id = "earlywood_colour", .kind = SOZAI_KIND_COLOUR, .number = {0.5, 0.25, 0.75}},
};
enum { PLAIN = sizeof plain / sizeof *plain };

typedef struct {
  void *library;
  const sozai_entry_v1 *entry;
  const sozai_textures_1 *textures;
} loaded;

static loaded load(const char *path) {
  loaded l;
  l.library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!l.library) fail_msg("%s", dlerror());
  l.entry = dlsym(l.library, SOZAI_ENTRY_SYMBOL);
  assert_non_null(l.entry);
  assert_int_equal(l.entry->init(path), SOZAI_OK);
  l.textures = l.entry->get_factory(SOZAI_TEXTURES_1);
  return l;
}

static void unload(loaded *l) {
  l->entry->deinit();
  dlclose(l->library);
}

static int32_t albedo(const loaded *l, const sozai_host *host, const char *space, float out[3]) {
  sozai_value values[PLAIN];
  memcpy(values, plain, sizeof values);
  values[2].text = values[3].text = space;
  sozai_texture *t;
  int32_t r = l->textures->create(host, "wood", NULL, values, PLAIN, &t);
  if (r) return r;
  const float p[3] = {40, 50, 3};
  float *const channels[3] = {&out[0], &out[1], &out[2]};
  sozai_batch b = {.size = sizeof b,
                   .count = 1,
                   .point = {&p[0], &p[1], &p[2]},
                   .out = channels,
                   .out_count = 3};
  r = l->textures->evaluate(t, &b);
  l->textures->destroy(t);
  return r;
}

static void assert_srgb(const float rgb[3]) {
  static const double in[3] = {0.5, 0.25, 0.75};
  for (int c = 0; c < 3; c++) {
    double want = pow((in[c] + 0.055) / 1.055, 2.4);
    if (fabs((double)rgb[c] - want) > 1e-5) {
      fail_msg("channel %d is %.7f, not %.7f", c, (double)rgb[c], want);
    }
  }
}

static int warnings;
static void count_warnings(void *user, int32_t severity, const char *text) {
  (void)user, (void)text;
  warnings += severity == SOZAI_LOG_WARNING;
}

/* The plugin in a folder of its own, without services beside it. */
typedef struct {
  char folder[32], path[64];
  loaded l;
} lone;

static void load_alone(lone *a) {
  char command[4200];
  snprintf(a->folder, sizeof a->folder, "/tmp/sozai-alone-XXXXXX");
  assert_non_null(mkdtemp(a->folder));
  snprintf(a->path, sizeof a->path, "%s/sozai.so", a->folder);
  snprintf(command, sizeof command, "cp '%s' '%s'", SOZAI_TEST_PLUGIN, a->path);
  assert_int_equal(system(command), 0);
  a->l = load(a->path);
}

static void unload_alone(lone *a) {
  unload(&a->l);
  unlink(a->path);
  rmdir(a->folder);
}

static void neither(void **state) {
  (void)state;
  lone a;
  load_alone(&a);
  sozai_host host = {.size = sizeof host, .log = count_warnings};
  float rgb[3];
  warnings = 0;
  assert_int_equal(albedo(&a.l, &host, NULL, rgb), SOZAI_OK);
  assert_srgb(rgb);
  assert_int_equal(albedo(&a.l, &host, "lin_rec709", rgb), SOZAI_OK);
  for (int c = 0; c < 3; c++) assert_true(fabs((double)rgb[c] - plain[2].number[c]) < 1e-6);
  assert_int_equal(warnings, 1);
  assert_int_equal(albedo(&a.l, &host, "ACEScg", rgb), SOZAI_ERROR_COLOUR);
  const char *why = a.l.textures->last_error();
  if (!strstr(why, "ACEScg") || !strstr(why, "colour")) fail_msg("says: %s", why);
  unload_alone(&a);
}

/* A host's log may call the plugin, from where it is called or from another thread that it waits
 * for: nothing is held meanwhile. */
static loaded *within;
static int logged;
static void create_another(void *user, int32_t severity, const char *text) {
  (void)user, (void)severity, (void)text;
  float rgb[3];
  if (logged++ == 0) assert_int_equal(albedo(within, NULL, NULL, rgb), SOZAI_OK);
}

static void a_log_that_creates(void **state) {
  (void)state;
  lone a;
  load_alone(&a);
  sozai_host host = {.size = sizeof host, .log = create_another};
  float rgb[3];
  within = &a.l;
  logged = 0;
  alarm(60); /* a lock that is held would hang here */
  assert_int_equal(albedo(&a.l, &host, NULL, rgb), SOZAI_OK);
  alarm(0);
  assert_true(logged > 0);
  unload_alone(&a);
}

static void beside(void **state) {
  (void)state;
  char path[4096];
  snprintf(path, sizeof path, "%s", SOZAI_TEST_PLUGIN);
  char *slash = strrchr(path, '/');
  assert_non_null(slash);
  snprintf(slash + 1, sizeof path - (size_t)(slash + 1 - path), "sozai-colour.so");
  if (access(path, R_OK) != 0) skip();
  unsetenv("OCIO");
  loaded l = load(SOZAI_TEST_PLUGIN);
  sozai_host host = {.size = sizeof host, .log = count_warnings};
  float rgb[3], wide[3];
  warnings = 0;
  assert_int_equal(albedo(&l, &host, NULL, rgb), SOZAI_OK);
  assert_srgb(rgb);
  assert_int_equal(albedo(&l, &host, "ACEScg", wide), SOZAI_OK);
  assert_true(fabsf(wide[0] - rgb[0]) > 0.01f);
  assert_int_equal(warnings, 0);
  assert_int_equal(albedo(&l, &host, "no such space", rgb), SOZAI_ERROR_COLOUR);
  if (!strstr(l.textures->last_error(), "no such space")) fail_msg("%s", l.textures->last_error());
  host.colour_config = "/nowhere/none.ocio";
  assert_int_equal(albedo(&l, &host, NULL, rgb), SOZAI_ERROR_FILE);
  if (!strstr(l.textures->last_error(), "none.ocio")) fail_msg("%s", l.textures->last_error());
  unload(&l);
}

/* The program's folder when it is looked for is not that of init. */
static void beside_a_relative_path(void **state) {
  (void)state;
  char folder[4096], here[4096];
  snprintf(folder, sizeof folder, "%s", SOZAI_TEST_PLUGIN);
  char *slash = strrchr(folder, '/');
  assert_non_null(slash);
  *slash = '\0';
  assert_non_null(getcwd(here, sizeof here));
  assert_int_equal(chdir(folder), 0);
  if (access("sozai-colour.so", R_OK) != 0) skip();
  unsetenv("OCIO");
  loaded l = load("./sozai.so");
  assert_int_equal(chdir("/"), 0);
  float wide[3];
  assert_int_equal(albedo(&l, NULL, "ACEScg", wide), SOZAI_OK);
  unload(&l);
  assert_int_equal(chdir(here), 0);
}

/* Pictures of a host's that can be opened and, after a while, no more be looked up. */
static int32_t picture_state;
static uint32_t looked_up;
static int32_t open_picture(void *self, const sozai_image_request *q, sozai_image **out,
                            char *message, size_t size) {
  (void)q;
  snprintf(message, size, "no picture");
  *out = picture_state == 2 ? NULL : (sozai_image *)self;
  return picture_state == 1 ? 5 : SOZAI_OK;
}
static void close_picture(void *self, sozai_image *image) { assert_ptr_equal(self, image); }
static int32_t sides(void *self, const sozai_image *image, uint32_t *width, uint32_t *height) {
  assert_ptr_equal(self, image);
  *width = *height = 100;
  return picture_state == 4 ? 9 : SOZAI_OK;
}
static int32_t sample_picture(void *self, const sozai_image *image, uint32_t count, const float *s,
                              const float *t, const float *dsdx, const float *dtdx,
                              const float *dsdy, const float *dtdy, float *const *out) {
  (void)self, (void)image, (void)dsdx, (void)dtdx, (void)dsdy, (void)dtdy;
  looked_up += count;
  for (uint32_t i = 0; i < count; i++) { /* rings */
    float ring = 0.5f + 0.3f * sinf(60.0f * hypotf(s[i] - 0.5f, t[i] - 0.5f));
    for (int c = 0; c < 3; c++) out[c][i] = picture_state == 3 ? 0.0f : ring;
  }
  return picture_state == 3 ? SOZAI_ERROR_FILE : picture_state == 5 ? 7 : SOZAI_OK;
}
static int picture_self;
static const sozai_images_1 pictures = {sizeof pictures, 0,     &picture_self,  open_picture,
                                        close_picture,   sides, sample_picture, NULL};
static const void *picture_service(void *user, const char *id) {
  (void)user;
  return strcmp(id, SOZAI_IMAGES_1) == 0 ? &pictures : NULL;
}

/* Of points that are not active a service is not asked. */
static void only_the_active(const loaded *l, const sozai_texture *t) {
  enum { N = 200 };
  static float p[3][N], rgb[3][N];
  static uint8_t active[N];
  float *const out[3] = {rgb[0], rgb[1], rgb[2]};
  sozai_batch b = {.size = sizeof b, .count = N, .point = {p[0], p[1], p[2]}, .out = out};
  b.out_count = 3;
  b.active = active;
  picture_state = 3;
  looked_up = 0;
  assert_int_equal(l->textures->evaluate(t, &b), SOZAI_OK);
  assert_int_equal(looked_up, 0);
  picture_state = 0;
  uint32_t asked = 0;
  for (uint32_t i = 0; i < N; i++) asked += active[i] = i % 7 == 0 || (i >= 90 && i < 150);
  assert_int_equal(l->textures->evaluate(t, &b), SOZAI_OK);
  assert_in_range(looked_up, asked, asked + 3 * 16); /* the ends of blocks repeat their last */
}

static void a_picture_that_has_gone(void **state) {
  (void)state;
  loaded l = load(SOZAI_TEST_PLUGIN);
  sozai_host host = {.size = sizeof host, .get_service = picture_service};
  const sozai_value value = {.id = "section", .kind = SOZAI_KIND_STRING, .text = "end.tif"};
  sozai_texture *t = NULL;
  for (picture_state = 1; picture_state <= 5; picture_state++) { /* 9 and 7 are no results */
    if (picture_state == 3) continue;
    assert_int_equal(l.textures->create(&host, "wood", NULL, &value, 1, &t), SOZAI_ERROR_FILE);
    if (!strstr(l.textures->last_error(), "section")) fail_msg("%s", l.textures->last_error());
  }
  picture_state = 0;
  if (l.textures->create(&host, "wood", NULL, &value, 1, &t))
    fail_msg("%s", l.textures->last_error());
  const float p[3] = {40, 50, 3};
  float rgb[3];
  float *const out[3] = {&rgb[0], &rgb[1], &rgb[2]};
  sozai_batch b = {.size = sizeof b, .count = 1, .point = {p, p + 1, p + 2}, .out = out};
  b.out_count = 3;
  assert_int_equal(l.textures->evaluate(t, &b), SOZAI_OK);
  picture_state = 3;
  assert_int_equal(l.textures->evaluate(t, &b), SOZAI_ERROR_FILE);
  if (!strstr(l.textures->last_error(), "picture")) fail_msg("%s", l.textures->last_error());
  picture_state = 0;
  assert_int_equal(l.textures->evaluate(t, &b), SOZAI_OK);
  only_the_active(&l, t);
  l.textures->destroy(t);
  unload(&l);
}

/* A service that knows of no ceiling and no progress is asked how large the picture is, and
 * a host that stopped meanwhile is listened to. */
static uint32_t reports, stop_at;
static int32_t count_reports(void *user, float fraction, const char *what) {
  assert_null(user);
  assert_true(fraction >= 0.0f && fraction <= 1.0f && *what);
  return ++reports == stop_at;
}

static void a_service_that_takes_no_ceiling(void **state) {
  (void)state;
  loaded l = load(SOZAI_TEST_PLUGIN);
  sozai_limit limit = {"image_pixels", 100 * 100};
  sozai_host host = {.size = sizeof host,
                     .get_service = picture_service,
                     .progress = count_reports,
                     .limits = &limit,
                     .limit_count = 1};
  const sozai_value value = {.id = "section", .kind = SOZAI_KIND_STRING, .text = "end.tif"};
  sozai_texture *t = NULL;
  picture_state = 0;
  assert_int_equal(l.textures->create(&host, "wood", NULL, &value, 1, &t), SOZAI_OK);
  assert_int_equal(reports, 1);
  l.textures->destroy(t);
  limit.value--;
  assert_int_equal(l.textures->create(&host, "wood", NULL, &value, 1, &t), SOZAI_ERROR_LIMIT);
  assert_string_equal(l.textures->last_error(),
                      "section: 10000 is above the ceiling image_pixels, 9999");
  limit.value++;
  stop_at = reports + 1;
  assert_int_equal(l.textures->create(&host, "wood", NULL, &value, 1, &t), SOZAI_ERROR_CANCELLED);
  assert_non_null(strstr(l.textures->last_error(), "cancelled"));
  assert_null(t);
  unload(&l);
}

/* A host's own: it knows one space, which swaps red and blue. */
static int calls;
static const char *own_name(void *self) { return self ? "own" : "?"; }
static int32_t own_has(void *self, const char *space) {
  (void)self;
  return strcmp(space, "swapped") == 0;
}
static int32_t own_to_working(void *self, const char *space, float *rgb, uint64_t count,
                              char *message, size_t size) {
  calls++;
  if (!own_has(self, space)) {
    snprintf(message, size, "not one of ours");
    return SOZAI_ERROR_COLOUR;
  }
  for (uint64_t i = 0; i < count; i++) {
    float red = rgb[3 * i];
    rgb[3 * i] = rgb[3 * i + 2];
    rgb[3 * i + 2] = red;
  }
  return SOZAI_OK;
}
static int own_self;
static const sozai_colour_1 own = {.size = sizeof own,
                                   .self = &own_self,
                                   .config_name = own_name,
                                   .working_space = own_name,
                                   .has_space = own_has,
                                   .to_working = own_to_working,
                                   .from_working = own_to_working};
static const void *give_own(void *user, const char *id) {
  (void)user;
  return strcmp(id, SOZAI_COLOUR_1) == 0 ? &own : NULL;
}

static void the_hosts_own(void **state) {
  (void)state;
  loaded l = load(SOZAI_TEST_PLUGIN);
  sozai_host host = {.size = sizeof host, .get_service = give_own};
  static const char *const others[] = {"vessel_colour",
                                       "sapwood_earlywood_colour",
                                       "sapwood_latewood_colour",
                                       "sapwood_vessel_colour",
                                       "ray_colour",
                                       "joint_colour",
                                       "grey_colour",
                                       "streak_colour",
                                       "pigment_colour",
                                       "aged_colour",
                                       "canal_colour",
                                       "parenchyma_colour",
                                       "sapwood_parenchyma_colour",
                                       "knot_colour",
                                       "knot_bark_colour",
                                       "glue_colour"};
  enum { OTHERS = sizeof others / sizeof *others };
  sozai_value values[PLAIN + OTHERS];
  memcpy(values, plain, sizeof plain);
  values[2].text = values[3].text = "swapped";
  for (int i = 0; i < OTHERS; i++) {
    values[PLAIN + i] = (sozai_value){
        .id = others[i], .kind = SOZAI_KIND_COLOUR, .number = {0.1, 0.1, 0.1}, .text = "swapped"};
  }
  sozai_texture *t;
  calls = 0;
  assert_int_equal(l.textures->create(&host, "wood", NULL, values, PLAIN + OTHERS, &t), SOZAI_OK);
  assert_int_equal(calls, 19); /* eighteen colours, and the hue of one */
  const float p[3] = {40, 50, 3};
  float rgb[3], *const channels[3] = {&rgb[0], &rgb[1], &rgb[2]};
  sozai_batch b = {.size = sizeof b,
                   .count = 1,
                   .point = {&p[0], &p[1], &p[2]},
                   .out = channels,
                   .out_count = 3};
  assert_int_equal(l.textures->evaluate(t, &b), SOZAI_OK);
  assert_int_equal(calls, 19); /* none for a point */
  assert_true(fabs((double)rgb[0] - 0.75) < 1e-6 && fabs((double)rgb[2] - 0.5) < 1e-6);
  l.textures->destroy(t);
  float unused[3];
  assert_int_equal(albedo(&l, &host, "unheard-of", unused), SOZAI_ERROR_COLOUR);
  if (!strstr(l.textures->last_error(), "not one of ours"))
    fail_msg("%s", l.textures->last_error());
  unload(&l);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(neither),
      cmocka_unit_test(a_log_that_creates),
      cmocka_unit_test(beside),
      cmocka_unit_test(beside_a_relative_path),
      cmocka_unit_test(a_picture_that_has_gone),
      cmocka_unit_test(a_service_that_takes_no_ceiling),
      cmocka_unit_test(the_hosts_own),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
