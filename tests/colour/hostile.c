/* SPDX-License-Identifier: Apache-2.0
 *
 * Configs that are broken, endless, or no configs at all: a result, one line of
 * text, and the process goes on. OpenColorIO by itself crashes on some of them.
 */
#define _GNU_SOURCE /* mkdtemp */
#include "library.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"

static char folder[] = "/tmp/sozai-configs-XXXXXX";

static void refused(const char *config, int32_t want, const char *part) {
  char message[512] = "";
  sozai_services *services = (void *)message;
  int32_t result = library_open(config, &services, message, sizeof message);
  print_message("%.160s\n", message);
  assert_int_equal(result, want);
  assert_null(services);
  assert_contains(message, part);
  assert_null(strpbrk(message, "\n\r\t"));
}

static void circles(void **state) {
  (void)state;
  refused(CONFIG("circular_spaces"), SOZAI_ERROR_COLOUR, "\"b\" is defined by itself");
  refused(CONFIG("circular_looks"), SOZAI_ERROR_COLOUR, "look \"two\"");
  refused(CONFIG("circular_view"), SOZAI_ERROR_COLOUR, "view transform \"v\"");
  refused(CONFIG("circular_alias"), SOZAI_ERROR_FILE, "alias");
}

/* A file of the folder, to be opened. */
static const char *file(const char *name, const void *data, size_t size) {
  static char path[256];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE *f = fopen(path, "wb");
  assert_non_null(f);
  assert_int_equal(fwrite(data, 1, size, f), size);
  fclose(f);
  return path;
}

static const char head[] = "ocio_profile_version: 2\n"
                           "roles: {default: a, scene_linear: a}\n"
                           "file_rules:\n  - !<Rule> {name: Default, colorspace: a}\n"
                           "displays:\n  D:\n    - !<View> {name: V, colorspace: a}\n"
                           "colorspaces:\n  - !<ColorSpace> {name: a}\n"
                           "  - !<ColorSpace>\n    name: b\n";

/* An alias inside its own node ends OpenColorIO; anywhere else it is of use. */
static void aliases(void **state) {
  (void)state;
  static const char *const circular[] = {
      "    to_scene_reference: &t !<GroupTransform> {children: [*t]}\n",
      "    to_scene_reference: &t !<GroupTransform>\n      children: [\n*t]\n",
      "    to_scene_reference: &t !<GroupTransform>\n      children:\n      - *t\n",
      "    to_scene_reference: &t\n      !<GroupTransform>\n      children:\n        - *t\n",
      "    to_scene_reference: !<GroupTransform>\n      children: &t\n"
      "        - !<GroupTransform>\n          children: *t\n",
      "    to_scene_reference: !<GroupTransform>\n      children:\n"
      "        - &t !<GroupTransform>\n          children:\n            - *t\n",
      "    to_scene_reference: !<GroupTransform>\n      children:\n"
      "        - !<GroupTransform> &t\n          children:\n          - *t\n",
      "    to_scene_reference: !<GroupTransform> {\"children\": &t [!<GroupTransform> "
      "{\"children\":*t}]}\n",
  };
  static const char *const sound[] = {
      "    to_scene_reference: &t !<MatrixTransform> {offset: [1, 2, 3, 0]}\n"
      "  - !<ColorSpace>\n    name: c\n    to_scene_reference: *t\n",
      "    to_scene_reference: &t !<GroupTransform>\n      children:\n"
      "        - !<MatrixTransform> {offset: [1, 2, 3, 0]}\n    from_scene_reference: *t\n",
      "    to_scene_reference: !<GroupTransform>\n      children:\n"
      "        - &t !<MatrixTransform> {offset: [1, 2, 3, 0]}\n        - *t\n",
      "    to_scene_reference: !<GroupTransform>\n      children:\n"
      "      - &t !<MatrixTransform> {offset: &o [1, 2, 3, 0]}\n      - *t\n"
      "      - !<MatrixTransform> {offset: *o}\n",
      "    to_scene_reference: !<GroupTransform> {children: [&t !<MatrixTransform> {offset: [1, 2, "
      "3, 0]}, *t]}\n",
      "    description: R&D, 2*3 & more * \"*t\" # &t\n",
  };
  char text[2048];
  for (size_t i = 0; i < sizeof circular / sizeof *circular; i++) {
    snprintf(text, sizeof text, "%s%s", head, circular[i]);
    refused(file("alias.ocio", text, strlen(text)), SOZAI_ERROR_FILE, "alias *t is");
  }
  for (size_t i = 0; i < sizeof sound / sizeof *sound; i++) {
    snprintf(text, sizeof text, "%s%s", head, sound[i]);
    service s = service_open(file("alias.ocio", text, strlen(text)));
    float rgb[3] = {0.1f, 0.2f, 0.3f};
    assert_int_equal(s.colour->to_working(s.colour->self, "b", rgb, 1, NULL, 0), SOZAI_OK);
    service_close(s);
  }
}

/* A chain of spaces, each made of the next, `twice` over. */
static const char *chain(int length, int twice) {
  static char path[256];
  snprintf(path, sizeof path, "%s/chain.ocio", folder);
  FILE *f = fopen(path, "w");
  assert_non_null(f);
  fputs("ocio_profile_version: 2\nroles: {default: s0, scene_linear: s0}\n"
        "file_rules:\n  - !<Rule> {name: Default, colorspace: s0}\n"
        "displays:\n  D:\n    - !<View> {name: V, colorspace: s0}\n"
        "colorspaces:\n  - !<ColorSpace> {name: s0}\n",
        f);
  for (int i = 1; i < length; i++) {
    fprintf(f,
            "  - !<ColorSpace>\n    name: s%d\n    to_scene_reference: !<GroupTransform>\n"
            "      children:\n",
            i);
    for (int k = 0; k <= twice; k++)
      fprintf(f, "        - !<ColorSpaceTransform> {src: s%d, dst: s0}\n", i - 1);
  }
  fclose(f);
  return path;
}

static void endless(void **state) {
  (void)state;
  service s = service_open(chain(50, 0)); /* long, but it ends */
  float rgb[3] = {0.1f, 0.2f, 0.3f};
  assert_int_equal(s.colour->to_working(s.colour->self, "s49", rgb, 1, NULL, 0), SOZAI_OK);
  assert_true(rgb[0] == 0.1f);
  service_close(s);
  refused(chain(1000, 0), SOZAI_ERROR_COLOUR, "too many");
  refused(chain(60, 1), SOZAI_ERROR_COLOUR, "too many");
}

static void no_yaml(void **state) {
  (void)state;
  const size_t size = 1 << 20;
  unsigned char *noise = malloc(size);
  assert_non_null(noise);
  uint32_t x = 1;
  for (size_t i = 0; i < size; i++) {
    x = x * 1664525u + 1013904223u;
    noise[i] = (unsigned char)(x >> 24);
  }
  refused(file("noise.ocio", noise, size), SOZAI_ERROR_FILE, "noise.ocio");
  for (size_t i = 0; i < size; i++) noise[i] = (unsigned char)(' ' + noise[i] % 95);
  refused(file("text.ocio", noise, size), SOZAI_ERROR_FILE, "text.ocio");
  static const char each[] = "[{&*!-:\"'#%\0";
  for (size_t i = 0; i + 1 < sizeof each; i++) {
    memset(noise, each[i], size);
    refused(file("same.ocio", noise, size / 16), SOZAI_ERROR_FILE, "same.ocio");
  }
  refused(file("empty.ocio", noise, 0), SOZAI_ERROR_FILE, "empty.ocio");
  static const char archive[] = "PK\3\4 no archive";
  refused(file("not.ocioz", archive, sizeof archive), SOZAI_ERROR_FILE, "not.ocioz");
  static const char *const half[] = {"ocio_profile_version: 2\n",
                                     "ocio_profile_version: 99\n",
                                     "ocio_profile_version: [1, 2]\n",
                                     "ocio_profile_version: 2\nroles: 7\n",
                                     "ocio_profile_version: 2\ncolorspaces: {a: b}\n",
                                     "ocio_profile_version: 2\nroles: {scene_linear: a}\n"};
  for (size_t i = 0; i < sizeof half / sizeof *half; i++) {
    sozai_services *services = NULL;
    char message[512] = "";
    int32_t result = library_open(file("half.ocio", half[i], strlen(half[i])), &services, message,
                                  sizeof message);
    print_message("%.160s\n", message);
    assert_true(result == SOZAI_ERROR_FILE || result == SOZAI_ERROR_COLOUR);
    assert_null(services);
    assert_contains(message, "half.ocio");
  }
  free(noise);
}

/* Wherever a sound config is cut off: refused, or as good as whole. */
static void cut_off(void **state) {
  (void)state;
  FILE *f = fopen(CONFIG("acescg"), "rb");
  assert_non_null(f);
  static char whole[16384];
  const size_t size = fread(whole, 1, sizeof whole, f);
  fclose(f);
  unsigned opened = 0, tried = 0;
  for (size_t length = 0; length < size; length += 13) {
    sozai_services *services = NULL;
    char message[512] = "";
    int32_t result =
        library_open(file("cut.ocio", whole, length), &services, message, sizeof message);
    assert_true(result == SOZAI_OK || result == SOZAI_ERROR_FILE || result == SOZAI_ERROR_COLOUR);
    assert_true((result == SOZAI_OK) == (services != NULL));
    assert_true(result == SOZAI_OK || *message);
    opened += result == SOZAI_OK;
    tried++;
    library_factory()->close(services);
  }
  print_message("cut off at %u places: %u opened\n", tried, opened);
  assert_true(opened < tried / 2);
}

/* A space whose table is not one: the space fails, when it is first used. */
static void no_tables(void **state) {
  (void)state;
  static const char ctf[] =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ProcessList id=\"a\" version=\"2.0\">\n"
      "<Reference inBitDepth=\"32f\" outBitDepth=\"32f\" path=\"self.ctf\"/>\n</ProcessList>\n";
  static const char *const kinds[] = {"spi1d", "spi3d", "cube", "3dl",    "csp",
                                      "clf",   "ctf",   "icc",  "spimtx", "cc"};
  const size_t noisy = 1 << 16;
  char *noise = malloc(noisy), text[2048], name[32];
  assert_non_null(noise);
  uint32_t x = 7;
  for (size_t i = 0; i < noisy; i++) {
    x = x * 1664525u + 1013904223u;
    noise[i] = (char)(x >> 24);
  }
  const size_t sizes[] = {noisy, 0, 1};
  for (size_t i = 0; i <= 3 * sizeof kinds / sizeof *kinds; i++) {
    /* Another name each time: OpenColorIO remembers what it has read of a path. */
    if (i < 3 * sizeof kinds / sizeof *kinds) {
      snprintf(name, sizeof name, "t%zu.%s", i, kinds[i / 3]);
      file(name, noise, sizes[i % 3]);
    } else {
      file(strcpy(name, "self.ctf"), ctf, sizeof ctf - 1);
    }
    snprintf(text, sizeof text,
             "search_path: .\n%s    to_scene_reference: !<FileTransform> {src: %s}\n", head, name);
    service s = service_open(file("table.ocio", text, strlen(text)));
    float rgb[3] = {0.1f, 0.2f, 0.3f};
    const float before[3] = {0.1f, 0.2f, 0.3f};
    char message[512] = "";
    int32_t result = s.colour->to_working(s.colour->self, "b", rgb, 1, message, sizeof message);
    print_message("%s: ...%.100s\n", name, *message ? strstr(message, "ocio:") : "");
    assert_int_equal(result, SOZAI_ERROR_COLOUR);
    assert_contains(message, "table.ocio");
    assert_memory_equal(rgb, before, sizeof rgb);
    assert_int_equal(s.colour->to_working(s.colour->self, "a", rgb, 1, NULL, 0), SOZAI_OK);
    service_close(s);
  }
  free(noise);
}

static void odd_paths(void **state) {
  (void)state;
  refused(folder, SOZAI_ERROR_FILE, "directory");
  refused("/dev/zero", SOZAI_ERROR_FILE, "not a file");
  char pipe[256];
  snprintf(pipe, sizeof pipe, "%s/pipe", folder);
  assert_int_equal(mkfifo(pipe, 0600), 0);
  refused(pipe, SOZAI_ERROR_FILE, "not a file");

  /* Bytes that are no UTF-8 name a file all the same; the message is UTF-8. */
  refused("/nowhere/\xE9t\xE9.ocio", SOZAI_ERROR_FILE, "/nowhere/?t?.ocio");
  refused("/nowhere/\xC3\xA9t\xC3\xA9.ocio", SOZAI_ERROR_FILE, "/nowhere/\xC3\xA9t\xC3\xA9.ocio");
  static char long_path[100000];
  memset(long_path, 'a', sizeof long_path - 1);
  refused(long_path, SOZAI_ERROR_FILE, "aaa");

  char command[512], path[256];
  snprintf(path, sizeof path, "%s/\xE9t\xE9.ocio", folder);
  snprintf(command, sizeof command, "cp '%s' '%s'", CONFIG("acescg"), path);
  assert_int_equal(system(command), 0);
  service s = service_open(path);
  assert_string_equal(s.colour->config_name(s.colour->self), path);
  service_close(s);
}

/* Configs built into OpenColorIO: since 2.2, and not of every name. */
static void built_in(void **state) {
  (void)state;
  char message[512] = "";
  sozai_services *services = NULL;
  int32_t result = library_open("ocio://default", &services, message, sizeof message);
  print_message("ocio://default: %d %s\n", (int)result, message);
  if (result == SOZAI_OK) {
    const sozai_colour_1 *c = library_factory()->get(services, SOZAI_COLOUR_1);
    assert_string_equal(c->config_name(c->self), "ocio://default");
    library_factory()->close(services);
  } else {
    assert_int_equal(result, SOZAI_ERROR_FILE);
    assert_contains(message, "2.2");
  }
  refused("ocio://utopia", SOZAI_ERROR_FILE, "ocio://utopia");
}

static int setup(void **state) { return !mkdtemp(folder) || library_setup(state); }

static int teardown(void **state) {
  char command[128];
  snprintf(command, sizeof command, "rm -r '%s'", folder);
  return system(command) || library_teardown(state);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(circles),   cmocka_unit_test(aliases),  cmocka_unit_test(endless),
      cmocka_unit_test(no_yaml),   cmocka_unit_test(cut_off),  cmocka_unit_test(no_tables),
      cmocka_unit_test(odd_paths), cmocka_unit_test(built_in),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
