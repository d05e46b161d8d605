/* SPDX-License-Identifier: Apache-2.0
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
 * Units: of points, footprints, lengths and meshes millimetres, of angles radians;
 * parameters, channels and columns name their own. Colour is scene-linear, in the
 * working space of the colour service.
 *
 * From the environment create() reads SOZAI_CPU, the instruction set to be used
 * (scalar, sse2, avx2, avx512, neon), the colour service $OCIO, when it is first
 * wanted (a config stays as it was read until the last deinit()), and the image
 * service beside the plugin $TMPDIR.
 *
 * Rules that hold everywhere
 *   - No exception, signal, exit, print or locale change crosses this boundary.
 *     Rounding and floating-point traps of the calling thread change no answer,
 *     trap nothing, and are afterwards as they were; flags of exceptions may be
 *     raised.
 *   - A function that can fail returns int32_t: SOZAI_OK or one of
 *     SOZAI_ERROR_*, and last_error() of the same table then says why on the same
 *     thread; of sozai_wood_1 that of sozai_textures_1, of init nothing.
 *   - A struct that may grow begins with `size`; set it to sizeof. Members past
 *     the size given are taken as zero.
 *   - Tables of functions never change. A new function is a new table under a
 *     new id. An unknown id gives NULL.
 *   - Strings are UTF-8 and zero-terminated. Strings handed in are copied
 *     where they are kept; strings handed out live as long as their owner.
 *   - Thread rules, in brackets on every function:
 *       [thread-safe]  any thread, at any time between init and deinit;
 *       [exclusive]    not while another call on the same object is under way.
 *   - After a fork in a process of several threads the child may not call it.
 */
#ifndef SOZAI_H
#define SOZAI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SOZAI_ABI_MAJOR 1u /* another major: not compatible */
#define SOZAI_ABI_MINOR 4u /* a higher minor only adds ids and struct members */

/* ---- results ---------------------------------------------------------- */

#define SOZAI_OK 0
#define SOZAI_ERROR_ARGUMENT (-1)    /* a NULL, a wrong size, a missing input */
#define SOZAI_ERROR_UNKNOWN (-2)     /* no texture, preset, parameter or channel of that name */
#define SOZAI_ERROR_KIND (-3)        /* a value of the wrong kind, or unreadable as text */
#define SOZAI_ERROR_RANGE (-4)       /* a value outside its hard range, or none of the choices */
#define SOZAI_ERROR_MEMORY (-5)      /* the allocator gave NULL */
#define SOZAI_ERROR_UNSUPPORTED (-6) /* this plugin, or this machine, has no such thing */
#define SOZAI_ERROR_CANCELLED (-7)   /* the host asked to stop */
#define SOZAI_ERROR_FILE (-8)        /* missing, unreadable or malformed */
#define SOZAI_ERROR_COLOUR (-9)      /* an unknown colour space, or a failing transform */
#define SOZAI_ERROR_STATE (-10)      /* called before init or after the last deinit */
#define SOZAI_ERROR_LIMIT (-11)      /* more than a ceiling allows: see sozai_limit_info */

/* ---- entry ------------------------------------------------------------ */

typedef struct sozai_entry_v1 {
  uint32_t abi_major;
  uint32_t abi_minor;
  /* Make ready. plugin_path: the file this library was loaded from, or NULL;
   * used to find the colour service beside it. A relative one is looked up now; a
   * link to the file is not followed. MEMORY. Counted: each init that gave
   * SOZAI_OK wants one deinit, and until the last of them the first path holds.
   * [thread-safe] */
  int32_t (*init)(const char *plugin_path);
  /* Undo one init. Every texture must have been destroyed, and every geometry, mesh
   * and curves released, before the last. [thread-safe] */
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
 * "0.2 0.1 0.05 @ ACEScg", "end grain.tif @ sRGB, wrap=mirror, channel=0".
 * Text is read and written in the C locale. */
#define SOZAI_KIND_STRING 0u /* never a parameter's kind */
#define SOZAI_KIND_FLOAT 1u  /* number[0] */
#define SOZAI_KIND_INT 2u    /* number[0], a whole number, |n| < 2^53; for a FLOAT any */
#define SOZAI_KIND_BOOL 3u   /* number[0], 0 or 1 */
#define SOZAI_KIND_CHOICE 4u /* text: the choice's id */
#define SOZAI_KIND_FLOAT3 5u /* number[0..2] */
#define SOZAI_KIND_COLOUR 6u /* number[0..2]; text: its space, NULL for the parameter's own */
#define SOZAI_KIND_TEXT 7u   /* text */
#define SOZAI_KIND_PATH 8u   /* text: a file's path */
#define SOZAI_KIND_BUFFER 9u /* buffer: memory of the host's */
#define SOZAI_KIND_IMAGE 10u /* buffer of kind IMAGE; or text: a file's path, "" for none */

/* What a buffer holds. */
#define SOZAI_BUFFER_TABLE 1u  /* rows x columns of float, row by row */
#define SOZAI_BUFFER_IMAGE 2u  /* height x width x channels of float, top row first */
#define SOZAI_BUFFER_MESH 3u   /* triangles: see points, normals and indices */
#define SOZAI_BUFFER_POINTS 4u /* a point cloud: points, and normals or NULL */

/* What a picture shows beyond its edges. */
#define SOZAI_WRAP_DEFAULT 0u /* the parameter's own */
#define SOZAI_WRAP_BLACK 1u
#define SOZAI_WRAP_CLAMP 2u
#define SOZAI_WRAP_PERIODIC 3u
#define SOZAI_WRAP_MIRROR 4u

/* Memory handed in by the host. Read during create() only, and copied. */
typedef struct sozai_buffer {
  uint32_t size;            /* sizeof(sozai_buffer) */
  uint32_t kind;            /* SOZAI_BUFFER_* */
  uint64_t dims[3];         /* TABLE: rows, columns. IMAGE: height, width, channels.
                               MESH: points, triangles. POINTS: points. Others are not read. */
  const float *data;        /* TABLE, IMAGE: the numbers */
  const float *points;      /* MESH, POINTS: x y z each, mm */
  const float *normals;     /* MESH, POINTS: x y z each, or NULL */
  const uint32_t *indices;  /* MESH: three to a triangle, counter-clockwise seen from outside */
  const char *colour_space; /* IMAGE: the name of its space, or NULL: a buffer is data, a
                               file's space follows the config's file rules */
  const char *path;         /* IMAGE: a file's path in place of data; "": none */
  uint32_t wrap;            /* IMAGE: SOZAI_WRAP_* */
  uint32_t first_channel;   /* IMAGE: where the picture has more than are wanted */
} sozai_buffer;

/* One value for one parameter. This struct never grows. */
typedef struct sozai_value {
  const char *id;    /* the parameter's id */
  uint32_t kind;     /* SOZAI_KIND_* */
  uint32_t reserved; /* 0, else ARGUMENT */
  double number[3];
  const char *text;
  const sozai_buffer *buffer;
} sozai_value;

/* What a parameter is. Strings of this and the following descriptions are never
 * NULL unless it says so. */
typedef struct sozai_parameter {
  uint32_t size;
  uint32_t kind;
  const char *id;    /* lower_case, stable for ever */
  const char *label; /* for people, in English */
  const char *group; /* parameters of a group stand together in this order */
  const char *unit;  /* "mm", "deg", "1/mm2", "" for a plain number */
  const char *doc;   /* one or two sentences */
  double hard_min;   /* FLOAT, INT, FLOAT3, COLOUR (in the space it is given in): values
                        outside are refused */
  double hard_max;
  double soft_min; /* where a slider should end */
  double soft_max;
  double default_number[3]; /* CHOICE: the index of the default in choices. IMAGE: how many
                               channels it takes, and its SOZAI_WRAP_*. */
  const char *default_text; /* TEXT, PATH, IMAGE: the default. COLOUR: the space its numbers are in.
                               Other kinds: NULL. */
  const char *const *choices;     /* CHOICE: ids; else NULL */
  const char *const *choice_docs; /* CHOICE: a phrase each; else NULL */
  uint32_t choice_count;
  uint32_t buffer_kind; /* BUFFER, IMAGE: the SOZAI_BUFFER_* it takes; else 0 */
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
  const char *unit; /* "mm", "rad"; of "xyz" "" for a direction, of length 1, and "share" for one
                       as long as the share of the footprint that has it: see fiber_lobe */
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
  uint32_t size;                /* sizeof(sozai_batch) */
  uint32_t count;               /* from 0 up */
  const float *point[3];        /* mm, object space. NaN is read as 0, and beyond
                                   +-1e6 (a kilometre) as the nearest of the two. */
  const float *normal[3];       /* outward, of any length from 1e-30 to 1e38; zero,
                                   shorter, longer or not finite is read as +z. Any of
                                   the three NULL: none, see evaluate. */
  const float *light[3];        /* towards the light, likewise */
  const float *light_colour[3]; /* irradiance on a face turned to the light
                                   over pi, working space; NULL: 1. Not finite: 0. */
  const float *view[3];         /* towards the eye, likewise; zero or not finite: the normal */
  const float *footprint;       /* mm: side of the square on the surface, square
                                   to the normal, over which each answer is the
                                   average; its turn about the normal is the
                                   texture's choice. Of a pixel that is longer than
                                   wide: the root of its area, or for less noise its
                                   length. With n samples spread over a pixel each
                                   stands for an n-th of it: the side by sqrt(n),
                                   which is sharper, and often cheaper. NULL,
                                   negative or NaN: 0, a point. Above 1e4: 1e4. */
  const uint8_t *active;        /* 0: leave that point's outputs untouched; none of its
                                   inputs is read, and it costs next to nothing. NULL:
                                   all active */
  float *const *out;            /* component_count pointers, NULL where not wanted:
                                   what is not wanted is not computed */
  uint32_t out_count;           /* length of out: components past it are not wanted,
                                   and pointers past component_count are not read */
  uint32_t reserved;            /* not read */
} sozai_batch;

typedef struct sozai_texture sozai_texture;
struct sozai_host;
struct sozai_limit;

#define SOZAI_TEXTURES_1 "sozai.textures/1"

typedef struct sozai_textures_1 {
  /* How many kinds of texture there are. [thread-safe] */
  uint32_t (*count)(void);
  /* The index-th kind, or NULL. [thread-safe] */
  const sozai_texture_info *(*info)(uint32_t index);
  /* The kind of that id, or NULL. [thread-safe] */
  const sozai_texture_info *(*find)(const char *texture_id);

  /* Make a texture, which never changes afterwards.
   *   host    services, or NULL for none. The struct and its ceilings are read
   *           here; `user`, free and what the callbacks need must outlive the texture.
   *   preset  a preset's id, or NULL for the parameters' own defaults.
   *   values  value_count of them; of two for one parameter the later counts.
   *   out     the texture; NULL when anything failed, and then nothing is kept.
   * Colours are converted into the working space here, once; pictures are
   * opened here, and read to their end. The image service beside the plugin keeps
   * them, about 16 bytes a pixel of three channels, in a file without a name in
   * $TMPDIR, where that is a folder to write in, else /tmp, else memory (where it is
   * full: MEMORY). It stays open until the last deinit, and a picture's room in it is
   * given back with the last texture that has it. OpenImageIO starts threads, which
   * stay until the process ends.
   * The host's callbacks are called on this thread, progress from its thread
   * pool's too. Takes no more of the stack than evaluate.
   * Errors: ARGUMENT, UNKNOWN, KIND, RANGE, LIMIT, MEMORY, FILE (of a section whose
   * pith cannot be found, too), COLOUR, CANCELLED, STATE, and UNSUPPORTED for an
   * instruction set that SOZAI_CPU asks for and this machine lacks, or for a picture
   * where there is no image service. [thread-safe] */
  int32_t (*create)(const struct sozai_host *host, const char *texture_id, const char *preset,
                    const sozai_value *values, uint32_t value_count, sozai_texture **out);
  /* NULL is allowed. [exclusive] */
  void (*destroy)(sozai_texture *texture);

  /* Answer a batch. Any size, any thread, any number at once; allocates
   * nothing, locks nothing, takes at most 384 KB of the calling thread's stack (whose
   * host has less calls from a thread that has more), and the answer to a point
   * depends on nothing but that point: same bits whatever the batch, thread or
   * machine. (Of a texture with a picture, as far as the image service keeps to
   * that: the one beside the plugin allocates, locks, and reads its file.)
   * Checked before any output is written: ARGUMENT if a wanted channel needs
   * an input that is NULL. An input that a channel only `uses` may be NULL:
   * without a normal the footprint is a ball, not a square. After the look-ups, all
   * outputs written: FILE, of a picture that cannot be read any more.
   * Every written number is finite. Where the calling thread flushes denormals
   * to zero, numbers below 1.2e-38 are zero. [thread-safe] */
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
  /* Why the last call on this thread failed, in one line: names the parameter,
   * the value and the range. "" before any failure; valid until the thread's next
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
   * first, >= 0; less, or NaN, is read as 0, above 1e5 as 1e5; theta beyond +-1e4
   * as 0; y as a point's). The inverse of the channel `time`, to 1e-5 of r, but in and
   * about a knot, where rings are the branch's or bend round it. count numbers each.
   * ARGUMENT: NULL, or not a wood. UNSUPPORTED: of plies, and of boards in a layout,
   * each of a log of its own. [thread-safe] */
  int32_t (*ring_radius)(const sozai_texture *texture, uint32_t count, const float *t,
                         const float *theta, const float *y, float *out_r);
  /* The pith at height y: x and z in mm, log space. The same errors. [thread-safe] */
  int32_t (*pith)(const sozai_texture *texture, uint32_t count, const float *y, float *out_x,
                  float *out_z);
} sozai_wood_1;

/* ---- geometry --------------------------------------------------------- */

/* Curves, meshes and tables that are grown: tree, fiber. What goes in, hulls
 * among it, comes as values, by pointer. Object space: mm, +y up the stem as in
 * wood's log; of fiber the hull's. */
#define SOZAI_GEOMETRY_1 "sozai.geometry/1"

/* A column of a table. */
typedef struct sozai_column {
  const char *id;
  const char *unit;
  const char *doc;
} sozai_column;

/* What a table of a kind of geometry holds, without its rows. */
typedef struct sozai_table_info {
  uint32_t size;
  uint32_t column_count;
  const char *id;
  const char *doc;
  const sozai_column *columns;
} sozai_table_info;

/* A kind of geometry. Lives until the last deinit. */
typedef struct sozai_generator_info {
  uint32_t size;
  uint32_t revision; /* grows when the same values grow something else */
  const char *id;    /* "tree" */
  const char *label;
  const char *doc;
  const sozai_parameter *const *parameters;
  const sozai_preset *const *presets;
  const sozai_table_info *const *tables;
  uint32_t parameter_count;
  uint32_t preset_count;
  uint32_t table_count;
  uint32_t reserved;
} sozai_generator_info;

/* What a part of a mesh or of curves is made of, for a host to give it a
 * material: items (triangles, or curves) from `first` on. */
typedef struct sozai_part {
  const char *id; /* "bark", "leaf", ... */
  uint64_t first;
  uint64_t count;
  float colour[3]; /* sRGB, display-referred: to paint it with, for want of a texture */
  uint32_t flags;  /* SOZAI_PART_* */
} sozai_part;

#define SOZAI_PART_CLOSED 0x1u /* closed surfaces; else sheets, seen from both sides */

/* How it is wanted. */
typedef struct sozai_detail {
  uint32_t size; /* sizeof(sozai_detail) */
  /* 0: all there is; at most 8. Of strands each level more is about half. Of a tree 1 has about
   * half of the triangles (47 to 60 %), 2 about a sixth (13 to 19 %), and each level more about
   * half of the one before, while leaves are most of it; they hide as much at each. */
  uint32_t level;
} sozai_detail;

/* One indexed mesh. Owned by the plugin until release_mesh. */
typedef struct sozai_mesh {
  uint32_t size;
  uint32_t part_count;
  uint64_t point_count; /* below 2^32 */
  uint64_t triangle_count;
  const float *points;     /* x y z each, mm */
  const float *normals;    /* x y z each, unit, outward; of sheets one of both sides */
  const float *uv;         /* u v each: of tubes u round, 0 to 1, and v along, mm / 100; of
                              leaves across and along, 0 to 1 */
  const uint32_t *owner;   /* of each point: what it belongs to, as in sozai_curves.ids */
  const uint32_t *indices; /* three to a triangle, counter-clockwise seen from outside */
  const sozai_part *parts; /* of triangles, in order, without gaps */
  const float *colours;    /* r g b each, as sozai_part.colour, of each point: bark by its age.
                              NULL: as the parts are. A plugin of ABI 1.3 gives a `size` without */
} sozai_mesh;

/* Polylines with a radius at each point. Owned by the plugin until
 * release_curves. */
typedef struct sozai_curves {
  uint32_t size;
  uint32_t part_count;
  uint64_t curve_count;
  uint64_t point_count;
  const float *points;     /* x y z each, mm */
  const float *radii;      /* mm, of each point */
  const uint64_t *first;   /* curve_count + 1: curve i has points first[i] up to first[i + 1] */
  const uint32_t *ids;     /* of each curve: the branch's (a leaf's: its shoot's); the strand's */
  const sozai_part *parts; /* of curves, in order, without gaps */
  const float *colours;    /* r g b each, of each point: as in sozai_mesh */
} sozai_curves;

/* Rows of numbers, row by row: fit to be handed on as a SOZAI_BUFFER_TABLE.
 * Lives as long as the geometry. */
typedef struct sozai_table {
  uint32_t size;
  uint32_t reserved;
  const sozai_table_info *info;
  const float *data;
  uint64_t rows;
} sozai_table;

typedef struct sozai_geometry sozai_geometry;

typedef struct sozai_geometry_1 {
  /* How many kinds of geometry there are. [thread-safe] */
  uint32_t (*count)(void);
  /* The index-th kind, or NULL. [thread-safe] */
  const sozai_generator_info *(*info)(uint32_t index);
  /* The kind of that id, or NULL. [thread-safe] */
  const sozai_generator_info *(*find)(const char *generator_id);

  /* Grow one, which never changes afterwards; arguments as of
   * sozai_textures_1.create, and of the host's the same must outlive meshes and curves
   * made of it, too. The same values give the same bits on every machine, with or
   * without the host's thread pool. Calls host.progress, from the pool's threads too.
   * Takes no more of any thread's stack than evaluate. On failure *out is NULL and
   * nothing is kept.
   * Errors: ARGUMENT, UNKNOWN, KIND, RANGE (a hull's or a table's numbers in a buffer,
   * too), LIMIT, MEMORY, FILE (a malformed table as text), CANCELLED, STATE.
   * [thread-safe] */
  int32_t (*grow)(const struct sozai_host *host, const char *generator_id, const char *preset,
                  const sozai_value *values, uint32_t value_count, sozai_geometry **out);
  /* Meshes and curves made of it stay. NULL is allowed. [exclusive] */
  void (*release)(sozai_geometry *geometry);

  /* As a mesh; detail NULL: level 0. Calls host.progress. Errors: ARGUMENT,
   * RANGE (the level), LIMIT, MEMORY, CANCELLED, UNSUPPORTED (beyond 2^32 points).
   * [thread-safe] */
  int32_t (*mesh)(const sozai_geometry *geometry, const sozai_detail *detail,
                  const sozai_mesh **out);
  /* NULL is allowed. [exclusive] */
  void (*release_mesh)(const sozai_mesh *mesh);
  /* As curves; the same errors. [thread-safe] */
  int32_t (*curves)(const sozai_geometry *geometry, const sozai_detail *detail,
                    const sozai_curves **out);
  /* NULL is allowed. [exclusive] */
  void (*release_curves)(const sozai_curves *curves);
  /* One of its tables; out->size is to be set. ARGUMENT, UNKNOWN.
   * [thread-safe] */
  int32_t (*table)(const sozai_geometry *geometry, const char *table_id, sozai_table *out);

  /* The value of one parameter as it was grown with. UNKNOWN. [thread-safe] */
  int32_t (*value)(const sozai_geometry *geometry, const char *parameter_id, sozai_value *out);
  /* Its kind. [thread-safe] */
  const sozai_generator_info *(*info_of)(const sozai_geometry *geometry);
  /* Bytes of memory it holds, without its meshes and curves. [thread-safe] */
  uint64_t (*bytes)(const sozai_geometry *geometry);
  /* As of sozai_textures_1. [thread-safe] */
  const char *(*last_error)(void);
} sozai_geometry_1;

/* ---- the host's services ---------------------------------------------- */

#define SOZAI_LOG_DEBUG 0
#define SOZAI_LOG_INFO 1
#define SOZAI_LOG_WARNING 2
#define SOZAI_LOG_ERROR 3

/* What a host offers. Every member may be NULL. Callbacks may come from any
 * thread that calls the plugin, progress from any of the pool's, several at once;
 * and they must not throw or unwind. They may call the plugin. On the thread that
 * called it rounding is to nearest meanwhile, and floating-point traps are off. */
typedef struct sozai_host {
  uint32_t size;     /* sizeof(sozai_host) */
  uint32_t reserved; /* not read */
  void *user;        /* handed back in every call */
  void (*log)(void *user, int32_t severity, const char *text);
  /* Both or neither. align is a power of two. free gets what alloc was asked. */
  void *(*alloc)(void *user, size_t size, size_t align);
  void (*free)(void *user, void *memory, size_t size, size_t align);
  /* Run task(context, i) for every i below count, in any order, and return
   * when all are done. Whatever it returns, the plugin then runs those itself that
   * have not run, which changes nothing; none may be run by others after that. */
  int32_t (*parallel)(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                      void *context);
  /* Long work, 0 to 1: growing, and reading pictures. Not 0: cancel. */
  int32_t (*progress)(void *user, float fraction, const char *what);
  /* A service of the host's own by id, e.g. SOZAI_COLOUR_1 of
   * sozai_colour.h, or NULL: the plugin then looks for one beside itself. */
  const void *(*get_service)(void *user, const char *service_id);
  /* An OpenColorIO config for the colour service: a path. NULL: $OCIO, else
   * the shipped one. */
  const char *colour_config;
  /* Bytes of pictures that the image service beside the plugin may hold at
   * most; 0: 1 GiB. What the first texture that opens it asks for counts. */
  uint64_t image_memory;
  /* Ceilings of the host's own, limit_count of them; of two for one id the later
   * counts. Those not named are as sozai_limits_1 says. They hold for what is
   * made with this host: read at every create() and grow(), and what was grown
   * keeps its own for its meshes and curves. UNKNOWN: no such id (ask find()
   * first: an older plugin has fewer). RANGE: above its `most`. */
  const struct sozai_limit *limits;
  uint32_t limit_count;
  uint32_t reserved_2;
} sozai_host;

/* ---- limits ------------------------------------------------------------ */

/* Ceilings on what comes from outside, beside the parameters' hard ranges. What
 * exceeds one is refused with LIMIT; last_error() names what, its value and the
 * ceiling. */
#define SOZAI_LIMITS_1 "sozai.limits/1"

/* A ceiling. Lives until the last deinit. */
typedef struct sozai_limit_info {
  uint32_t size;
  uint32_t reserved;
  const char *id;   /* "texture_bytes": lower_case, stable for ever */
  const char *unit; /* "B" of memory, "" of a number of things */
  const char *doc;
  uint64_t value; /* the ceiling where a host names none */
  uint64_t most;  /* the highest that a host may set it to */
} sozai_limit_info;

/* A host's own ceiling: sozai_host.limits. This struct never grows. */
typedef struct sozai_limit {
  const char *id;
  uint64_t value;
} sozai_limit;

typedef struct sozai_limits_1 {
  /* How many ceilings there are. [thread-safe] */
  uint32_t (*count)(void);
  /* The index-th, or NULL. [thread-safe] */
  const sozai_limit_info *(*info)(uint32_t index);
  /* The one of that id, or NULL. [thread-safe] */
  const sozai_limit_info *(*find)(const char *limit_id);
} sozai_limits_1;

/* What memory something would take, before it is taken. */
#define SOZAI_MEMORY_1 "sozai.memory/1"

/* Bytes as asked of sozai_host.alloc. Pictures that an image service holds are
 * not among them: see sozai_images_1.memory. */
typedef struct sozai_memory {
  uint32_t size; /* sizeof(sozai_memory), to be set */
  uint32_t reserved;
  uint64_t held; /* for as long as it lives: what bytes() will say */
  uint64_t peak; /* at most at any one time while it is made, `held` included */
} sozai_memory;

/* Each does what its namesake would, up to where the sizes are known, holds
 * meanwhile no more than that takes (of a tree its stem and branches without
 * shoots; of fibre the hull and its field; of knots their list) under the same
 * ceilings, frees it, and refuses what its namesake would have refused so far,
 * with the same errors; LIMIT too where the answer itself is above the ceiling.
 * On failure *out is all zero but its size. */
typedef struct sozai_memory_1 {
  /* Of a texture: arguments as of sozai_textures_1.create. [thread-safe] */
  int32_t (*texture)(const struct sozai_host *host, const char *texture_id, const char *preset,
                     const sozai_value *values, uint32_t value_count, sozai_memory *out);
  /* Of a geometry: arguments as of sozai_geometry_1.grow. [thread-safe] */
  int32_t (*geometry)(const struct sozai_host *host, const char *generator_id, const char *preset,
                      const sozai_value *values, uint32_t value_count, sozai_memory *out);
  /* Of a mesh made of it, and of curves. [thread-safe] */
  int32_t (*mesh)(const sozai_geometry *geometry, const sozai_detail *detail, sozai_memory *out);
  int32_t (*curves)(const sozai_geometry *geometry, const sozai_detail *detail, sozai_memory *out);
  /* As of sozai_textures_1. [thread-safe] */
  const char *(*last_error)(void);
} sozai_memory_1;

#ifdef __cplusplus
}
#endif

#endif
