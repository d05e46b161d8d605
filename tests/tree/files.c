/* SPDX-License-Identifier: Apache-2.0
 * sozai grow tree, its files read back: OBJ and glTF by Assimp, USD by a
 * reader of its grammar; and no half-made file when it fails or is stopped. */
#include <ctype.h>
#include <dirent.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mesh.h"

/* after failure.h, as cmocka has a macro `fail` */
#include <cmocka.h>

static char folder[64];

/* The command's exit code, its standard error in `said`. */
static int run(const char *arguments, char *said, size_t size) {
  char line[1024];
  snprintf(line, sizeof line, "cd %s && exec %s grow %s 2>&1 >/dev/null", folder,
           SOZAI_TEST_COMMAND, arguments);
  FILE *p = popen(line, "r");
  assert_non_null(p);
  size_t n = fread(said, 1, size - 1, p);
  said[n] = 0;
  return WEXITSTATUS(pclose(p));
}

static void works(const char *arguments) {
  char said[2048];
  int code = run(arguments, said, sizeof said);
  if (code) print_error("%s: %s\n", arguments, said);
  assert_int_equal(code, 0);
}

static int files_here(void) {
  int count = 0;
  DIR *d = opendir(folder);
  assert_non_null(d);
  for (struct dirent *e; (e = readdir(d));)
    if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0) count++;
  closedir(d);
  return count;
}

static int setup(void **unused) {
  (void)unused;
  strcpy(folder, "/tmp/sozai-tree-XXXXXX");
  return mkdtemp(folder) ? 0 : -1;
}

static int teardown(void **unused) {
  (void)unused;
  char line[128];
  snprintf(line, sizeof line, "rm -rf %s", folder);
  return system(line);
}

static void bounds(const mesh *m, double *low, double *high) {
  for (int c = 0; c < 3; c++) low[c] = 1e9, high[c] = -1e9;
  for (uint32_t i = 0; i < m->point_count; i++)
    for (int c = 0; c < 3; c++) {
      low[c] = fmin(low[c], (double)m->points[3 * i + (uint32_t)c]);
      high[c] = fmax(high[c], (double)m->points[3 * i + (uint32_t)c]);
    }
}

static char *text_of(const char *name) {
  char path[128];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE *f = fopen(path, "r");
  assert_non_null(f);
  fseek(f, 0, SEEK_END);
  long n = ftell(f);
  rewind(f);
  char *text = malloc((size_t)n + 1);
  assert_non_null(text);
  assert_int_equal(fread(text, 1, (size_t)n, f), n);
  text[n] = 0;
  fclose(f);
  return text;
}

static void through_assimp(void **unused) {
  (void)unused;
  works("tree --species cherry --age 6 -p orders=4 -o a.obj");
  works("tree --species cherry --age 6 -p orders=4 -o a.gltf");
  char path[128];
  failure why = {0};
  mesh obj, gltf;
  double low[2][3], high[2][3];
  snprintf(path, sizeof path, "%s/a.obj", folder);
  assert_true(mesh_read(&obj, path, 1, &why));
  snprintf(path, sizeof path, "%s/a.gltf", folder);
  assert_true(mesh_read(&gltf, path, 1000, &why));
  bounds(&obj, low[0], high[0]);
  bounds(&gltf, low[1], high[1]);
  char *text = text_of("a.gltf");
  assert_non_null(strstr(text, "\"COLOR_0\""));
  free(text);
  print_message("%u triangles in OBJ, %u in glTF, %.0f mm high\n", obj.triangle_count,
                gltf.triangle_count, high[0][1]);
  assert_true(obj.triangle_count > 5000);
  assert_int_equal(obj.triangle_count, gltf.triangle_count);
  assert_true(high[0][1] > 1500 && high[0][1] < 6000);
  for (int c = 0; c < 3; c++) {
    assert_true(fabs(low[0][c] - low[1][c]) < 0.01);
    assert_true(fabs(high[0][c] - high[1][c]) < 0.01);
  }
  mesh_free(&obj);
  mesh_free(&gltf);
}

/* ---- usda: brackets and quotes match, and arrays have the lengths they must */

static void grammar(const char *text) {
  char open[64];
  int depth = 0;
  assert_true(strncmp(text, "#usda 1.0\n", 10) == 0);
  for (const char *s = text + 10; *s; s++) {
    if (*s == '"') {
      for (s++; *s && *s != '"'; s++) assert_true(*s != '\n');
      assert_true(*s == '"');
    } else if (*s == '(' || *s == '[' || *s == '{') {
      assert_true(depth < 60);
      open[depth++] = *s;
    } else if (*s == ')' || *s == ']' || *s == '}') {
      assert_true(depth > 0);
      char was = open[--depth];
      assert_true(was == (*s == ')' ? '(' : *s == ']' ? '[' : '{'));
    } else {
      assert_true(isalnum((unsigned char)*s) || strchr(" \n\t,.=:_-+", *s) != NULL);
    }
  }
  assert_int_equal(depth, 0);
}

/* How many elements the array of that name has, and their sum. */
static uint64_t elements(const char *text, const char *name, double *sum) {
  const char *at = strstr(text, name);
  assert_non_null(at);
  at = strstr(at, "= [");
  assert_non_null(at);
  uint64_t count = 0;
  *sum = 0;
  for (at += 3; *at != ']';) {
    char *end;
    int triple = *at == '(';
    if (triple) at++;
    for (;;) {
      double x = strtod(at, &end);
      assert_true(end > at && isfinite(x));
      *sum += x;
      at = end;
      if (!triple || *at == ')') break;
      assert_true(at[0] == ',');
      at += 2;
    }
    if (triple) at++;
    count++;
    if (*at == ',') at += 2;
  }
  return count;
}

static void usd(void **unused) {
  (void)unused;
  double sum, corners;
  works("tree --species sugi --age 3 -o m.usda");
  char *text = text_of("m.usda");
  grammar(text);
  assert_non_null(strstr(text, "upAxis = \"Y\""));
  assert_non_null(strstr(text, "metersPerUnit = 0.001"));
  uint64_t faces = elements(text, "int[] faceVertexCounts", &corners);
  uint64_t points = elements(text, "point3f[] points", &sum);
  assert_true(faces > 1000);
  assert_int_equal((uint64_t)corners, 3 * faces);
  assert_int_equal(elements(text, "int[] faceVertexIndices", &sum), 3 * faces);
  assert_int_equal(elements(text, "normal3f[] normals", &sum), points);
  assert_int_equal(elements(text, "texCoord2f[] primvars:st", &sum), points);
  assert_int_equal(elements(text, "color3f[] primvars:displayColor", &sum), points);
  free(text);
  works("tree --species sugi --age 3 --curves -o c.usda");
  text = text_of("c.usda");
  grammar(text);
  uint64_t curves = elements(text, "int[] curveVertexCounts", &sum);
  assert_true(curves > 1000);
  points = elements(text, "point3f[] points", &corners);
  assert_int_equal((uint64_t)sum, points);
  assert_int_equal(elements(text, "float[] widths", &sum), points);
  assert_int_equal(elements(text, "color3f[] primvars:displayColor", &sum), points);
  free(text);
}

static void tables(void **unused) {
  (void)unused;
  works("tree --age 8 -p orders=1 -o a.field");
  works("tree --age 8 -p orders=1 --field a.field -o b.field");
  char *a = text_of("a.field"), *b = text_of("b.field");
  assert_string_equal(a, b);
  free(a);
  free(b);
  works("tree --species akamatsu --age 20 -p orders=1 --table knots -o k.csv");
  a = text_of("k.csv");
  assert_true(strncmp(a, "branch,birth,death,shed,", 24) == 0);
  free(a);
}

static void refused(const char *arguments, int code, const char *words) {
  char said[2048];
  int before = files_here();
  int got = run(arguments, said, sizeof said);
  if (got != code || !strstr(said, words)) fail_msg("%s: %d, %s", arguments, got, said);
  assert_true(strchr(said, '\n') == said + strlen(said) - 1);
  assert_int_equal(files_here(), before);
}

static void refusals(void **unused) {
  (void)unused;
  refused("tree", 2, "-o FILE");
  refused("bush -o a.obj", 2, "no 'bush'");
  refused("tree -o a.stl", 2, "--output: 'a.stl' ends in none of .obj");
  refused("tree -o x/a.obj", 2, "x/a.obj");
  refused("tree --age -3 -o o.obj", 2, "age: -3 is outside 1 to 300 years");
  refused("tree --level 12 -o o.obj", 2, "--level");
  refused("tree --curves -o o.obj", 2, "--curves");
  refused("tree --table roots -o o.csv", 2, "roots");
  refused("tree --field none.field -o o.obj", 2, "none.field");
  refused("tree --field /dev/zero -o o.obj", 2, "/dev/zero");
  FILE *f;
  char path[128];
  snprintf(path, sizeof path, "%s/bad.field", folder);
  f = fopen(path, "w");
  fputs("trunk\n50 0 90\n60 400 90\n", f);
  fclose(f);
  refused("tree --field bad.field -o o.obj", 2, "field: line 3, column 4: azimuth 400 is outside");
}

/* Ctrl-C at some moment leaves nothing. */
static void stopped(void **unused) {
  (void)unused;
  int before = files_here(), caught = 0;
  for (int i = 0; i < 4; i++) {
    pid_t child = fork();
    if (child == 0) {
      signal(SIGINT, SIG_DFL); /* whatever runs the tests may ignore it */
      if (chdir(folder)) _exit(9);
      if (!freopen("/dev/null", "w", stderr)) _exit(9);
      execl(SOZAI_TEST_COMMAND, "sozai", "grow", "tree", "--age", "30", "-o", "big.obj",
            (char *)NULL);
      _exit(9);
    }
    /* from when its file is there, which is before it grows anything */
    for (int k = 0; k < 3000 && files_here() == before; k++) usleep(5000);
    usleep(90000u * (unsigned)i);
    kill(child, SIGINT);
    int status;
    waitpid(child, &status, 0);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
    caught += WIFSIGNALED(status);
    assert_int_equal(files_here(), before);
  }
  print_message("stopped in time %d times of 4\n", caught);
  assert_true(caught >= 3);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(through_assimp), cmocka_unit_test(usd),
                                     cmocka_unit_test(tables), cmocka_unit_test(refusals),
                                     cmocka_unit_test(stopped)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
