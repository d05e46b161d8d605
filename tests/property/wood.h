/* SPDX-License-Identifier: Apache-2.0
 *
 * A plugin and a way to ask it about wood, for the property tests.
 */
#ifndef SOZAI_TEST_WOOD_H
#define SOZAI_TEST_WOOD_H

#include "sozai.h"

extern const sozai_textures_1 *textures;
extern const sozai_wood_1 *woods;

/* cmocka group fixtures: load the plugin, unload it. */
int wood_setup(void **state);
int wood_teardown(void **state);

/* Another table of the plugin's. */
const void *wood_factory(const char *id);

/* A wood of a preset (NULL: none) with parameters as "a=1; b=2"; fails the
 * test when it cannot be made. */
sozai_texture *wood_make(const char *preset, const char *parameters);

sozai_texture *stone_make(const char *preset, const char *parameters);

/* Why it cannot be made: the plugin's message, or NULL when it can. */
const char *wood_refused(const char *parameters);
const char *stone_refused(const char *parameters);

/* How many presets there are, and the id of one. */
unsigned wood_presets(void);
const char *wood_preset(unsigned i);
/* Whether it is a sheet of plies. */
int wood_is_panel(const char *preset);

/* Points to ask about. Arrays grow as needed; outputs are by component. */
typedef struct {
  unsigned count, room;
  float *point[3], *normal[3], *light[3], *view[3], *footprint;
  float *out[42];
} points;

/* Components, as describe lists them. */
enum {
  ALBEDO = 0,
  RADIANCE = 3,
  FIBER = 6,
  DIVE = 9,
  TIME = 12,
  LATEWOOD,
  VESSEL,
  REFERENCE,
  CONE_COLOUR = 17,
  CONE_WIDTH = 20,
  COAT,
  RAY,
  BOARD_ID,
  BOARD_U,
  BOARD_V,
  BOARD_EDGE,
  NORMAL,
  HEIGHT = 30,
  CANAL,
  KNOT,
  COAT_ROUGHNESS,
  PARENCHYMA,
  FIBER_LOBE,
  RAY_LOBE = 38,
  RAY_LUSTRE = 41
};

void points_clear(points *p);
void points_free(points *p);
/* Normal, light and view +z; returns the point's index. */
unsigned points_add(points *p, double x, double y, double z, double footprint);
void points_ask(points *p, const sozai_texture *t);
/* Component `what` of an answered point. */
double points_value(const points *p, int what, unsigned point);
/* Add to `to` each answered point of p, a step further along its fibre, mm. */
void points_along_fibre(const points *p, float step, points *to);
/* The same, level and round the pith instead. */
void points_round_pith(const points *p, double step, points *to);
/* Add `count` points anywhere from radius r on, `deep` further at most, up to a height; by
 * uniform(). */
void points_add_anywhere(points *p, int count, double r, double deep, double height);
/* For some components alone, which is quicker: a set of ONLY and ONLY3. The rest stay as they
 * were. */
#define ONLY(component) (1ull << (component))
#define ONLY3(first) (7ull << (first))
void points_ask_only(points *p, const sozai_texture *t, unsigned long long components);

/* A stream of numbers in 0..1, the same in every run. */
double uniform(void);
void uniform_seed(unsigned seed);

#endif
