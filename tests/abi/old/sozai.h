/* SPDX-License-Identifier: Apache-2.0
 *
 * The oldest header: ABI 1.0 as it was first recorded, kept as it was. It is never edited;
 * a host and a plugin of its time are compiled against it (tests/abi/host.c,
 * tests/mock/mock.c). Below this paragraph it is the file of that day.
 *
 * sozai: procedural materials for renderers, version 1 of the ABI.
 *
 * How to use it, in order:
 *   1. dlopen("sozai.so"), dlsym("sozai_entry"): a struct, not a function, so
 *      that its version can be read before any of its code runs.
 *   2. Refuse it unless abi_major == SOZAI_ABI_MAJOR, then call init(path).
 *   3. get_factory(SOZAI_TEXTURES_1) gives the table of functions below.
 *   4. create() a texture from values, evaluate() it on batches of points from
 *      any number of threads, destroy() it.
 *   5. deinit(), dlclose().
 *
 * Units: millimetres, radians (degrees only where a parameter says so), and
 * scene-linear colour in the working space of the colour service.
 *
 * Rules that hold everywhere
 *   - No exception, signal, exit, print, locale or floating-point-environment
 *     change crosses this boundary.
 *   - A function that can fail returns int32_t: SOZAI_OK or one of
 *     SOZAI_ERROR_*, and last_error() on the same thread then says why.
 *   - A struct that may grow begins with `size`; set it to sizeof. Members past
 *     the size given are taken as zero.
 *   - Tables of functions never change. A new function is a new table under a
 *     new id. An unknown id gives NULL.
 *   - Strings are UTF-8 and zero-terminated. Strings handed in are copied
 *     where they are kept; strings handed out live as long as their owner.
 *   - Thread rules, in brackets on every function:
 *       [thread-safe]  any thread, at any time between init and deinit;
 *       [exclusive]    not while another call on the same object is under way.
 */
#ifndef SOZAI_H
#define SOZAI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SOZAI_ABI_MAJOR 1u /* another major: not compatible */
#define SOZAI_ABI_MINOR 0u /* a higher minor only adds ids and struct members */

/* ---- results ---------------------------------------------------------- */

#define SOZAI_OK 0
#define SOZAI_ERROR_ARGUMENT (-1)    /* a NULL, a wrong size, a missing input */
#define SOZAI_ERROR_UNKNOWN (-2)     /* no texture, preset, parameter or channel of that name */
#define SOZAI_ERROR_KIND (-3)        /* a value of the wrong kind, or unreadable as text */
#define SOZAI_ERROR_RANGE (-4)       /* a value outside its hard range */
#define SOZAI_ERROR_MEMORY (-5)      /* the allocator gave NULL */
#define SOZAI_ERROR_UNSUPPORTED (-6) /* this plugin, or this machine, has no such thing */
#define SOZAI_ERROR_CANCELLED (-7)   /* the host asked to stop */
#define SOZAI_ERROR_FILE (-8)        /* missing, unreadable or malformed */
#define SOZAI_ERROR_COLOUR (-9)      /* an unknown colour space, or a failing transform */
#define SOZAI_ERROR_STATE (-10)      /* called before init or after the last deinit */

/* ---- entry ------------------------------------------------------------ */

typedef struct sozai_entry_v1 {
  uint32_t abi_major;
  uint32_t abi_minor;
  /* Make ready. plugin_path: the file this library was loaded from, or NULL;
   * used to find the colour service beside it. Counted: each init that gave
   * SOZAI_OK wants one deinit. [thread-safe] */
  int32_t (*init)(const char *plugin_path);
  /* Undo one init. Every texture must have been destroyed before the last.
   * [thread-safe] */
  void (*deinit)(void);
  /* The function table of that id, or NULL: unknown, or not initialised.
   * Valid until the last deinit. [thread-safe] */
  const void *(*get_factory)(const char *factory_id);
} sozai_entry_v1;

/* The only symbol sozai.so exports is an object of this type named: */
#define SOZAI_ENTRY_SYMBOL "sozai_entry"

/* ---- parameters ------------------------------------------------------- */

/* Kinds. A value's kind must be its parameter's, with two exceptions: an INT
 * is taken for a FLOAT, and SOZAI_KIND_STRING, whose text is read as the
 * parameter's kind: "1.5", "12", "true", "ring", "1 2 3", "#c08040",
 * "0.2 0.1 0.05 @ ACEScg". Text is read and written in the C locale. */
#define SOZAI_KIND_STRING 0u /* never a parameter's kind */
#define SOZAI_KIND_FLOAT 1u  /* number[0] */
#define SOZAI_KIND_INT 2u    /* number[0], a whole number, |n| < 2^53 */
#define SOZAI_KIND_BOOL 3u   /* number[0], 0 or 1 */
#define SOZAI_KIND_CHOICE 4u /* text: the choice's id */
#define SOZAI_KIND_FLOAT3 5u /* number[0..2] */
#define SOZAI_KIND_COLOUR 6u /* number[0..2]; text: its colour space, NULL for the parameter's own */
#define SOZAI_KIND_TEXT 7u   /* text */
#define SOZAI_KIND_PATH 8u   /* text: a file's path */
#define SOZAI_KIND_BUFFER 9u /* buffer: memory of the host's */

/* What a buffer holds. */
#define SOZAI_BUFFER_TABLE 1u  /* rows x columns of float, row by row */
#define SOZAI_BUFFER_IMAGE 2u  /* height x width x channels of float, top row first */
#define SOZAI_BUFFER_MESH 3u   /* triangles: see points, normals and indices */
#define SOZAI_BUFFER_POINTS 4u /* a point cloud: points, and normals or NULL */

/* Memory handed in by the host. Read during create() only, and copied. */
typedef struct sozai_buffer {
  uint32_t size; /* sizeof(sozai_buffer) */
  uint32_t kind; /* SOZAI_BUFFER_* */
  uint64_t dims[3]; /* TABLE: rows, columns. IMAGE: height, width, channels.
                       MESH: points, triangles. POINTS: points. Others 0. */
  const float *data;        /* TABLE, IMAGE: the numbers */
  const float *points;      /* MESH, POINTS: x y z each, mm */
  const float *normals;     /* MESH, POINTS: x y z each, or NULL */
  const uint32_t *indices;  /* MESH: three to a triangle, counter-clockwise seen from outside */
  const char *colour_space; /* IMAGE: the name of its space, or NULL for data */
} sozai_buffer;

/* One value for one parameter. This struct never grows. */
typedef struct sozai_value {
  const char *id; /* the parameter's id */
  uint32_t kind;  /* SOZAI_KIND_* */
  uint32_t reserved; /* 0 */
  double number[3];
  const char *text;
  const sozai_buffer *buffer;
} sozai_value;

/* What a parameter is. */
typedef struct sozai_parameter {
  uint32_t size;
  uint32_t kind;
  const char *id;    /* lower_case, stable for ever */
  const char *label; /* for people, in English */
  const char *group; /* parameters of a group stand together in this order */
  const char *unit;  /* "mm", "deg", "1/mm2", "" for a plain number */
  const char *doc;   /* one or two sentences */
  double hard_min;   /* FLOAT, INT, FLOAT3, COLOUR: values outside are refused */
  double hard_max;
  double soft_min; /* where a slider should end */
  double soft_max;
  double default_number[3]; /* CHOICE: the index of the default in choices */
  const char *default_text; /* TEXT, PATH: the default. COLOUR: the space its numbers are in. */
  const char *const *choices;     /* CHOICE: ids; else NULL */
  const char *const *choice_docs; /* CHOICE: a phrase each; else NULL */
  uint32_t choice_count;
  uint32_t buffer_kind; /* BUFFER: the SOZAI_BUFFER_* it takes; else 0 */
} sozai_parameter;

/* A named set of values: a species of wood, a kind of stone. Values that a
 * preset does not name stay at the parameters' defaults; values given to
 * create() come on top. */
typedef struct sozai_preset {
  uint32_t size;
  uint32_t value_count;
  const char *id;
  const char *label;
  const char *doc;
  const char *source; /* the literature its figures come from */
  const sozai_value *values;
} sozai_preset;

/* ---- textures --------------------------------------------------------- */

/* Inputs of a batch, as bits: what a channel needs. */
#define SOZAI_INPUT_POINT 0x01u
#define SOZAI_INPUT_NORMAL 0x02u
#define SOZAI_INPUT_LIGHT 0x04u
#define SOZAI_INPUT_LIGHT_COLOUR 0x08u
#define SOZAI_INPUT_VIEW 0x10u
#define SOZAI_INPUT_FOOTPRINT 0x20u

/* An output channel of one or more components. Component k of the channel is
 * written to sozai_batch.out[first + k]. */
typedef struct sozai_channel {
  uint32_t size;
  uint32_t first;      /* index of its first component */
  uint32_t components; /* 1 or 3, 2 for a place in a plane */
  uint32_t needs;      /* SOZAI_INPUT_*: evaluate refuses a batch without them */
  uint32_t uses;       /* SOZAI_INPUT_*: better with them; see evaluate */
  uint32_t reserved;
  const char *id;
  const char *unit;
  const char *suffixes; /* a letter for each component: "rgb", "xyz", "xz", "" for one */
  const char *doc;
} sozai_channel;

/* A kind of texture. Lives until the last deinit. */
typedef struct sozai_texture_info {
  uint32_t size;
  uint32_t revision; /* grows when a texture of the same values looks different */
  const char *id;    /* "wood" */
  const char *label;
  const char *doc;
  const sozai_parameter *const *parameters;
  const sozai_preset *const *presets;
  const sozai_channel *const *channels;
  uint32_t parameter_count;
  uint32_t preset_count;
  uint32_t channel_count;
  uint32_t component_count; /* of all channels together: the length of sozai_batch.out */
} sozai_texture_info;

/* Points to evaluate: structures of arrays, each array `count` long. Arrays
 * need the alignment of a float, no more. Outputs may not overlap inputs or
 * one another. */
typedef struct sozai_batch {
  uint32_t size;  /* sizeof(sozai_batch) */
  uint32_t count; /* from 0 up */
  const float *point[3];  /* mm, object space. NaN is read as 0, and beyond
                             +-1e6 (a kilometre) as the nearest of the two. */
  const float *normal[3]; /* outward, of any length; zero or not finite is
                             read as +z. All three NULL: see evaluate. */
  const float *light[3];  /* towards the light, of any length; likewise */
  const float *light_colour[3]; /* irradiance on a face turned to the light
                                   over pi, working space; NULL: 1. Not finite: 0. */
  const float *view[3];    /* towards the eye, of any length; zero or not finite: the normal */
  const float *footprint;  /* mm: side of the square on the surface, square
                              to the normal, over which each answer is the
                              average. NULL, negative or NaN: 0, a point.
                              Above 1e4: 1e4. */
  const uint8_t *active;   /* 0: leave that point's outputs untouched. NULL: all active */
  float *const *out;       /* component_count pointers, NULL where not wanted:
                              what is not wanted is not computed */
  uint32_t out_count;      /* length of out; components past it are not wanted */
  uint32_t reserved;
} sozai_batch;

typedef struct sozai_texture sozai_texture;
struct sozai_host;

#define SOZAI_TEXTURES_1 "sozai.textures/1"

typedef struct sozai_textures_1 {
  /* How many kinds of texture there are. [thread-safe] */
  uint32_t (*count)(void);
  /* The index-th kind, or NULL. [thread-safe] */
  const sozai_texture_info *(*info)(uint32_t index);
  /* The kind of that id, or NULL. [thread-safe] */
  const sozai_texture_info *(*find)(const char *texture_id);

  /* Make a texture, which never changes afterwards.
   *   host    services, or NULL for none; must outlive the texture.
   *   preset  a preset's id, or NULL for the parameters' own defaults.
   *   values  value_count of them; of two for one parameter the later counts.
   *   out     the texture; NULL when anything failed, and then nothing is kept.
   * Colours are converted into the working space here, once. The host's
   * callbacks are called on this thread, or through its thread pool.
   * Errors: ARGUMENT, UNKNOWN, KIND, RANGE, MEMORY, FILE, COLOUR, CANCELLED,
   * STATE, and UNSUPPORTED for an instruction set that SOZAI_CPU asks for and
   * this machine lacks. [thread-safe] */
  int32_t (*create)(const struct sozai_host *host, const char *texture_id, const char *preset,
                    const sozai_value *values, uint32_t value_count, sozai_texture **out);
  /* NULL is allowed. [exclusive] */
  void (*destroy)(sozai_texture *texture);

  /* Answer a batch. Any size, any thread, any number at once; allocates
   * nothing, locks nothing, and the answer to a point depends on nothing but
   * that point: same bits whatever the batch, thread or machine.
   * Checked before any output is written: ARGUMENT if a wanted channel needs
   * an input that is NULL. An input that a channel only `uses` may be NULL:
   * without a normal the footprint is a ball, not a square.
   * Every written number is finite. [thread-safe] */
  int32_t (*evaluate)(const sozai_texture *texture, const sozai_batch *batch);

  /* The value of one parameter as the texture was made with, after preset
   * and defaults. Text and buffers live as long as the texture. UNKNOWN.
   * [thread-safe] */
  int32_t (*value)(const sozai_texture *texture, const char *parameter_id, sozai_value *out);
  /* Its kind. [thread-safe] */
  const sozai_texture_info *(*info_of)(const sozai_texture *texture);
  /* Bytes of memory it holds. [thread-safe] */
  uint64_t (*bytes)(const sozai_texture *texture);
  /* The instruction set its evaluate runs on: "avx512", "avx2", "sse2",
   * "neon" or "scalar". [thread-safe] */
  const char *(*instruction_set)(const sozai_texture *texture);
  /* Why the last call on this thread failed: names the parameter, the value
   * and the range. "" before any failure; valid until the thread's next
   * failing call. [thread-safe] */
  const char *(*last_error)(void);
} sozai_textures_1;

/* ---- wood ------------------------------------------------------------- */

#define SOZAI_WOOD_1 "sozai.wood/1"

/* Questions that only wood answers. */
typedef struct sozai_wood_1 {
  /* The ring surface r = R(t, theta, y): distance in mm from the pith, at
   * azimuth theta (radians; x = r cos theta, z = r sin theta about the pith)
   * and height y (mm), of the wood formed at time t (years from the pith's
   * first, >= 0). The inverse of the channel `time`, to 1e-5 of r. count
   * numbers each. ARGUMENT: NULL, or not a wood. [thread-safe] */
  int32_t (*ring_radius)(const sozai_texture *texture, uint32_t count, const float *t,
                         const float *theta, const float *y, float *out_r);
  /* The pith at height y: x and z in mm, log space. [thread-safe] */
  int32_t (*pith)(const sozai_texture *texture, uint32_t count, const float *y, float *out_x,
                  float *out_z);
} sozai_wood_1;

/* ---- geometry (reserved) ---------------------------------------------- */

/* Curves and meshes grown by fibre and tree. The id is reserved; no plugin of
 * ABI 1.0 answers it. */
#define SOZAI_GEOMETRY_1 "sozai.geometry/1"

/* ---- the host's services ---------------------------------------------- */

#define SOZAI_LOG_DEBUG 0
#define SOZAI_LOG_INFO 1
#define SOZAI_LOG_WARNING 2
#define SOZAI_LOG_ERROR 3

/* What a host offers. Every member may be NULL. Callbacks may come from any
 * thread that calls the plugin, and must not throw or unwind. */
typedef struct sozai_host {
  uint32_t size; /* sizeof(sozai_host) */
  uint32_t reserved;
  void *user; /* handed back in every call */
  void (*log)(void *user, int32_t severity, const char *text);
  /* Both or neither. align is a power of two. free gets what alloc was asked. */
  void *(*alloc)(void *user, size_t size, size_t align);
  void (*free)(void *user, void *memory, size_t size, size_t align);
  /* Run task(context, i) for every i below count, in any order, and return
   * when all are done. Not 0: refused, and the plugin runs them itself. */
  int32_t (*parallel)(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                      void *context);
  /* Long work, 0 to 1. Not 0: cancel. */
  int32_t (*progress)(void *user, float fraction, const char *what);
  /* A service of the host's own by id, e.g. SOZAI_COLOUR_1 of
   * sozai_colour.h, or NULL: the plugin then looks for one beside itself. */
  const void *(*get_service)(void *user, const char *service_id);
  /* An OpenColorIO config for the colour service: a path. NULL: $OCIO, else
   * the shipped one. */
  const char *colour_config;
} sozai_host;

#ifdef __cplusplus
}
#endif

#endif
