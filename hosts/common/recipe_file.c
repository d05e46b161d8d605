/* SPDX-License-Identifier: Apache-2.0
 *
 * The .sozai file:
 *
 *   include: oak.sozai        # first if at all: that file's recipe, over which this one's goes
 *   material: wood
 *   preset: keyaki            # optional, as is all that follows
 *   params:
 *     ring_width: 1.5
 *     latewood_colour: [0.2, 0.1, 0.05]
 *     section: end.tif        # a picture, beside this file
 *     section:                # or, in full (all but file may be left out)
 *       file: end.tif
 *       space: sRGB           # its colour space; else by the config's file rules
 *       wrap: mirror          # black, clamp, periodic, mirror
 *       channel: 0            # the first channel that is used
 *   surface:
 *     shape: board            # plane, board or mesh
 *     size: [120, 240, 20]    # mm: width, height, thickness
 *     mesh: chair.obj         # for shape: mesh, beside this file
 *     scale: 10               # mm per unit of that file
 *   image:                    # the picture that an OpenImageIO reader makes of it
 *     resolution: [4096, 4096] # or one number, the longer side; three: a volume
 *     size: [1000, 1000]      # mm; three: a volume
 *     format: half            # auto, half or float
 *     wrap: clamp             # black, clamp, periodic (seamless), mirror
 *     outputs: [albedo, normal] # which channels, the first as plain R G B
 *     normals: tangent        # object, or tangent: encoded as normal maps are
 *     udim: 1002              # which tile of a mesh's
 *     subimages: separate     # separate, or single: all outputs are one's channels
 *     samples: 1              # 1, 2, 4 or 8: parts to a side of a texel
 *
 * Read event by event, since each event knows its line and nothing is kept
 * that was not asked for. */
#include "recipe.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yaml.h>
#include "numbers.h"
#include "ceilings.h"

typedef struct reader {
  const char *path;
  const struct reader *includer; /* the file that includes this one, or NULL */
  dev_t device;                  /* which file it is, whatever its names */
  ino_t number;
  yaml_parser_t parser;
  yaml_event_t event; /* the one being looked at */
  bool has_event;
  recipe *out;
  failure *why;
  bool started;     /* a key has been read */
  char *picture[4]; /* of the image being read: file, space, wrap, channel */
} reader;

typedef struct key {
  const char *name;
  bool (*read)(reader *in); /* from the value's first event to its last */
} key;

static int line_of(const reader *in) { return (int)in->event.start_mark.line + 1; }

__attribute__((format(printf, 2, 3))) static bool refuse(reader *in, const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return fail(in->why, EXIT_BAD_INPUT, "%s:%d: %s", in->path, line_of(in), text);
}

static bool next(reader *in) {
  if (in->has_event) yaml_event_delete(&in->event);
  in->has_event = false;
  if (!yaml_parser_parse(&in->parser, &in->event)) {
    int line = (int)in->parser.problem_mark.line + 1;
    const char *problem = in->parser.problem ? in->parser.problem : "unreadable";
    /* as of {tint: #c08040, ...} */
    bool missing = strstr(problem, "expected node content") != NULL;
    return fail(in->why, EXIT_BAD_INPUT, "%s:%d: %s%s", in->path, line, problem,
                missing ? "; # begins a comment: \"#rrggbb\" stands in quotes" : "");
  }
  in->has_event = true;
  if (in->event.type == YAML_ALIAS_EVENT) return refuse(in, "aliases are not taken here");
  return true;
}

/* The scalar being looked at, or NULL when it is something else. */
static const char *scalar(reader *in, const char *what) {
  if (in->event.type != YAML_SCALAR_EVENT) {
    refuse(in, "%s must be a single value", what);
    return NULL;
  }
  const char *text = (const char *)in->event.data.scalar.value;
  size_t length = in->event.data.scalar.length;
  if (length > RECIPE_MOST_TEXT || strlen(text) != length) {
    refuse(in, "%s is %s", what, length > RECIPE_MOST_TEXT ? "too long" : "not text");
    return NULL;
  }
  return text;
}

static bool keep(reader *in, char **slot, const char *what) {
  const char *text = scalar(in, what);
  if (!text) return false;
  if (!*text) return refuse(in, "%s is empty", what);
  free(*slot);
  *slot = strdup(text);
  return *slot ? true : fail(in->why, EXIT_FAILURE, "out of memory");
}

/* One number or a list of them; how many, or 0 when refused. */
static size_t read_numbers(reader *in, double *out, size_t most, double low, double high,
                           const char *what) {
  bool list = in->event.type == YAML_SEQUENCE_START_EVENT;
  size_t count = 0;
  if (list && !next(in)) return 0;
  do {
    if (list && in->event.type == YAML_SEQUENCE_END_EVENT) break;
    const char *text = scalar(in, what);
    if (!text) return 0;
    if (count == most) {
      refuse(in, "%s takes at most %zu numbers", what, most);
      return 0;
    }
    double number;
    if (!number_read(text, &number) || !(number >= low && number <= high)) {
      refuse(in, "%s: '%.40s' is not a number from %g to %g", what, text, low, high);
      return 0;
    }
    out[count++] = number;
    if (list && !next(in)) return 0;
  } while (list);
  if (count == 0) refuse(in, "%s is empty", what);
  return count;
}

static bool read_file_name(reader *in);

static bool unknown_key(reader *in, const char *name, const key *keys, const char *where) {
  char known[256] = "";
  for (const key *k = keys; k->name; k++) {
    size_t used = strlen(known);
    snprintf(known + used, sizeof known - used, "%s%s", k == keys ? "" : ", ", k->name);
  }
  /* the one place that a colour may have been meant for */
  const char *colour =
      keys->read == read_file_name ? "; a colour is \"#rrggbb\" or \"r g b @ SPACE\"" : "";
  return refuse(in, "unknown key '%.80s' in %s; there is %s%s", name, where, known, colour);
}

/* A mapping whose keys are known, from its start to its end. */
static bool read_mapping(reader *in, const key *keys, const char *where) {
  if (in->event.type != YAML_MAPPING_START_EVENT)
    return refuse(in, "%s must be a mapping of keys to values", where);
  uint32_t seen = 0;
  for (;;) {
    if (!next(in)) return false;
    if (in->event.type == YAML_MAPPING_END_EVENT) return true;
    const char *name = scalar(in, "a key");
    if (!name) return false;
    const key *k = keys;
    while (k->name && strcmp(k->name, name) != 0) k++;
    if (!k->name) return unknown_key(in, name, keys, where);
    uint32_t bit = 1u << (k - keys);
    if (seen & bit) return refuse(in, "'%s' stands twice", name);
    seen |= bit;
    if (!next(in) || !k->read(in)) return false;
    in->started = true;
  }
}

/* ---- params ----------------------------------------------------------- */

/* [0.2, 0.1, 0.05] becomes "0.2 0.1 0.05", which the plugin reads. */
static bool join_list(reader *in, char *text, size_t size) {
  size_t used = 0;
  for (;;) {
    if (!next(in)) return false;
    if (in->event.type == YAML_SEQUENCE_END_EVENT) return true;
    const char *item = scalar(in, "an item of a parameter's list");
    if (!item) return false;
    int more = snprintf(text + used, size - used, "%s%s", used ? " " : "", item);
    if (more < 0 || (size_t)more >= size - used) return refuse(in, "a list too long");
    used += (size_t)more;
  }
}

static bool read_file_name(reader *in) { return keep(in, &in->picture[0], "file"); }
static bool read_space(reader *in) { return keep(in, &in->picture[1], "space"); }
static bool read_wrap(reader *in) { return keep(in, &in->picture[2], "wrap"); }
static bool read_channel(reader *in) { return keep(in, &in->picture[3], "channel"); }

/* An image in full becomes "FILE @ SPACE, wrap=WRAP, channel=CHANNEL". */
static bool join_picture(reader *in, char *text, size_t size) {
  static const key keys[] = {{"file", read_file_name},
                             {"space", read_space},
                             {"wrap", read_wrap},
                             {"channel", read_channel},
                             {NULL, NULL}};
  bool ok = read_mapping(in, keys, "an image");
  char **p = in->picture;
  if (ok && !p[0])
    ok = refuse(in, "an image needs 'file'; a colour is \"#rrggbb\" or \"r g b @ SPACE\"");
  if (ok && p[1] && strchr(p[1], ',')) ok = refuse(in, "space '%.80s' has a comma", p[1]);
  if (ok && p[1] && strstr(p[1], " @ ")) ok = refuse(in, "space '%.80s' has ' @ ' in it", p[1]);
  if (ok) {
    int length =
        snprintf(text, size, "%s @ %s%s%s%s%s", p[0], p[1] ? p[1] : "", p[2] ? ", wrap=" : "",
                 p[2] ? p[2] : "", p[3] ? ", channel=" : "", p[3] ? p[3] : "");
    if (length < 0 || (size_t)length >= size) ok = refuse(in, "an image's description too long");
  }
  for (int i = 0; i < 4; i++) {
    free(p[i]);
    p[i] = NULL;
  }
  return ok;
}

static bool read_param(reader *in, const char *id, int line) {
  if (in->event.type == YAML_MAPPING_START_EVENT) {
    char text[8192] = "";
    return join_picture(in, text, sizeof text) &&
           recipe_set_from(in->out, id, text, in->path, line, in->why);
  }
  if (in->event.type == YAML_SEQUENCE_START_EVENT) {
    char text[256] = "";
    return join_list(in, text, sizeof text) &&
           recipe_set_from(in->out, id, text, in->path, line, in->why);
  }
  const char *text = scalar(in, "a parameter");
  return text && recipe_set_from(in->out, id, text, in->path, line, in->why);
}

static bool read_params(reader *in) {
  if (in->event.type != YAML_MAPPING_START_EVENT)
    return refuse(in, "params must be a mapping of names to values");
  int first = line_of(in); /* those of an included file may be said again */
  for (;;) {
    if (!next(in)) return false;
    if (in->event.type == YAML_MAPPING_END_EVENT) return true;
    const char *name = scalar(in, "a parameter's name");
    if (!name) return false;
    for (size_t i = 0; i < in->out->param_count; i++)
      if (strcmp(in->out->params[i].id, name) == 0 && in->out->params[i].line >= first &&
          strcmp(in->out->params[i].file, in->path) == 0)
        return refuse(in, "parameter '%.80s' stands twice", name);
    int line = line_of(in);
    char *id = strdup(name); /* the next event takes its text away */
    if (!id) return fail(in->why, EXIT_FAILURE, "out of memory");
    bool ok = next(in) && read_param(in, id, line);
    free(id);
    if (!ok) return false;
  }
}

/* ---- surface ---------------------------------------------------------- */

static bool read_shape(reader *in) {
  static const struct {
    const char *name;
    int shape;
  } shapes[] = {{"plane", RECIPE_PLANE}, {"board", RECIPE_BOARD}, {"mesh", RECIPE_MESH}};
  const char *text = scalar(in, "shape");
  if (!text) return false;
  for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
    if (strcmp(shapes[i].name, text) == 0) {
      in->out->surface.shape = shapes[i].shape;
      if (shapes[i].shape != RECIPE_MESH) { /* an included file's */
        free(in->out->surface.mesh);
        in->out->surface.mesh = NULL;
      }
      return true;
    }
  return refuse(in, "unknown shape '%.40s'; there is plane, board, mesh", text);
}

static bool read_surface_size(reader *in) {
  return read_numbers(in, in->out->surface.size, 3, 1e-3, 1e6, "size (mm)") > 0;
}

/* The name being looked at; a relative one starts from the file's own folder. */
static bool read_path(reader *in, char **slot, const char *what) {
  char *name = NULL;
  if (!keep(in, &name, what)) return false;
  const char *slash = name[0] == '/' ? NULL : strrchr(in->path, '/');
  if (slash) {
    size_t folder = (size_t)(slash + 1 - in->path);
    char *path = malloc(folder + strlen(name) + 1);
    if (path) {
      memcpy(path, in->path, folder);
      memcpy(path + folder, name, strlen(name) + 1);
    }
    free(name);
    name = path;
  }
  free(*slot);
  *slot = name;
  return name ? true : fail(in->why, EXIT_FAILURE, "out of memory");
}

static bool read_mesh(reader *in) { return read_path(in, &in->out->surface.mesh, "mesh"); }

static bool read_scale(reader *in) {
  return read_numbers(in, &in->out->surface.scale, 1, 1e-6, 1e6, "scale (mm per unit)") > 0;
}

static bool read_surface(reader *in) {
  static const key keys[] = {{"shape", read_shape},
                             {"size", read_surface_size},
                             {"mesh", read_mesh},
                             {"scale", read_scale},
                             {NULL, NULL}};
  int line = line_of(in);
  if (!read_mapping(in, keys, "surface")) return false;
  const recipe_surface *s = &in->out->surface;
  if ((s->shape == RECIPE_MESH) == (s->mesh != NULL)) return true;
  return fail(in->why, EXIT_BAD_INPUT, "%s:%d: surface: 'shape: mesh' and 'mesh' go together",
              in->path, line);
}

/* ---- image ------------------------------------------------------------ */

/* One value, or a list of them with commas between. */
static bool read_values(reader *in, char *text, size_t size) {
  bool list = in->event.type == YAML_SEQUENCE_START_EVENT;
  size_t used = 0;
  text[0] = '\0';
  if (list && !next(in)) return false;
  do {
    if (list && in->event.type == YAML_SEQUENCE_END_EVENT) break;
    const char *item = scalar(in, "a value of image");
    if (!item) return false;
    int more = snprintf(text + used, size - used, "%s%s", used ? "," : "", item);
    if (more < 0 || (size_t)more >= size - used) return refuse(in, "a value of image is too long");
    used += (size_t)more;
    if (list && !next(in)) return false;
  } while (list);
  return true;
}

static bool refuse_image_key(reader *in, const char *name) {
  char keys[256];
  recipe_image_keys(keys, sizeof keys);
  return refuse(in, "unknown key '%.80s' in image; there is %s", name, keys);
}

static bool read_image(reader *in) {
  if (in->event.type != YAML_MAPPING_START_EVENT)
    return refuse(in, "image must be a mapping of keys to values");
  uint32_t seen = 0;
  for (;;) {
    if (!next(in)) return false;
    if (in->event.type == YAML_MAPPING_END_EVENT) return true;
    const char *name = scalar(in, "a key");
    if (!name) return false;
    int key = recipe_image_key(name);
    if (key < 0) return refuse_image_key(in, name);
    if (seen & 1u << key) return refuse(in, "'%s' stands twice", name);
    seen |= 1u << key;
    char text[512];
    failure problem;
    if (!next(in) || !read_values(in, text, sizeof text)) return false;
    if (!recipe_image_set(&in->out->image, key, text, &problem))
      return refuse(in, "%s", problem.text);
  }
}

/* ---- the file --------------------------------------------------------- */

static bool read_material(reader *in) { return keep(in, &in->out->material, "material"); }
static bool read_preset(reader *in) { return keep(in, &in->out->preset, "preset"); }

static bool read_one(recipe *r, const char *path, const reader *includer, failure *why);

/* The other file's recipe first, and this one's over it. */
static bool read_include(reader *in) {
  if (in->started) return refuse(in, "'include' must be the first key");
  char *path = NULL;
  bool ok = read_path(in, &path, "include") && read_one(in->out, path, in, in->why);
  free(path);
  return ok;
}

static bool read_document(reader *in) {
  static const key keys[] = {{"material", read_material},
                             {"preset", read_preset},
                             {"params", read_params},
                             {"surface", read_surface},
                             {"image", read_image},
                             {"include", read_include},
                             {NULL, NULL}};
  if (!next(in) || !next(in)) return false; /* the stream's start and the document's */
  if (in->event.type == YAML_STREAM_END_EVENT) return refuse(in, "an empty file");
  if (!next(in) || !read_mapping(in, keys, "the file")) return false;
  if (!next(in) || !next(in)) return false; /* the document's end, and what follows */
  if (in->event.type != YAML_STREAM_END_EVENT) return refuse(in, "more than one document");
  if (!in->out->material && !in->includer) return refuse(in, "no 'material' is named");
  return true;
}

static bool includes_itself(const reader *in) {
  for (const reader *up = in->includer; up; up = up->includer)
    if (up->device == in->device && up->number == in->number) return true;
  return false;
}

static int depth_of(const reader *in) {
  int depth = 0;
  for (; in; in = in->includer) depth++;
  return depth;
}

static bool read_stream(reader *in, FILE *file) {
  if (!yaml_parser_initialize(&in->parser)) return fail(in->why, EXIT_FAILURE, "out of memory");
  yaml_parser_set_input_file(&in->parser, file);
  bool ok = read_document(in);
  if (in->has_event) yaml_event_delete(&in->event);
  yaml_parser_delete(&in->parser);
  return ok;
}

static bool read_one(recipe *r, const char *path, const reader *includer, failure *why) {
  struct stat status;
  /* a pipe that nobody writes to would wait for ever */
  int handle = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  FILE *file = handle < 0 ? NULL : fdopen(handle, "rb");
  int error = file ? 0 : errno;
  if (!file && handle >= 0) close(handle);
  if (!file || fstat(fileno(file), &status) != 0 || !S_ISREG(status.st_mode)) {
    const char *reason = error ? strerror(error) : "not a regular file";
    if (file) fclose(file);
    return includer ? fail(why, EXIT_BAD_INPUT, "%s:%d: cannot read %s: %s", includer->path,
                           line_of(includer), path, reason)
                    : fail(why, EXIT_BAD_INPUT, "cannot read %s: %s", path, reason);
  }
  reader in = {.path = path,
               .includer = includer,
               .device = status.st_dev,
               .number = status.st_ino,
               .out = r,
               .why = why};
  bool ok;
  char what[sizeof why->text];
  if (includer)
    snprintf(what, sizeof what, "%s:%d: %s", includer->path, line_of(includer), path);
  else
    snprintf(what, sizeof what, "%s", path);
  if (includes_itself(&in))
    ok = fail(why, EXIT_BAD_INPUT, "%s includes itself", what);
  else
    ok = limits_check(HOST_LIMIT_RECIPE_INCLUDES, (uint64_t)depth_of(&in), what, why) &&
         limits_check(HOST_LIMIT_RECIPE_BYTES, (uint64_t)status.st_size, path, why) &&
         read_stream(&in, file);
  fclose(file);
  return ok;
}

bool recipe_read_file(recipe *r, const char *path, failure *why) {
  return read_one(r, path, NULL, why);
}
