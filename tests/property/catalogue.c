/* SPDX-License-Identifier: Apache-2.0
 *
 * The catalogue of species: are the values of each plausible together, and is
 * what is said about them whole? Presets are read through the public header,
 * and what they leave out is the parameter's default.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979

static const sozai_texture_info *wood;
static const sozai_preset *species;
static unsigned wrong;

#define EXPECT(condition, ...)                                                                     \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      wrong++;                                                                                     \
      print_error("%s: ", species->id);                                                            \
      print_error(__VA_ARGS__);                                                                    \
      print_error("\n");                                                                           \
    }                                                                                              \
  } while (0)

static const sozai_parameter *parameter(const char *id) {
  for (uint32_t i = 0; i < wood->parameter_count; i++)
    if (strcmp(wood->parameters[i]->id, id) == 0) return wood->parameters[i];
  return NULL;
}

static const sozai_value *given(const char *id) {
  for (uint32_t i = 0; i < species->value_count; i++)
    if (strcmp(species->values[i].id, id) == 0) return &species->values[i];
  return NULL;
}

static double number(const char *id) {
  const sozai_value *v = given(id);
  const sozai_parameter *p = parameter(id);
  assert_non_null(p);
  return v ? v->number[0] : p->default_number[0];
}

static int is(const char *id, const char *choice) {
  const sozai_value *v = given(id);
  const sozai_parameter *p = parameter(id);
  assert_non_null(p);
  return strcmp(v ? v->text : p->choices[(int)p->default_number[0]], choice) == 0;
}

/* The Y of an sRGB colour; presets give theirs in sRGB. */
static double luminance(const char *id) {
  static const double weight[] = {0.2126, 0.7152, 0.0722};
  const sozai_value *v = given(id);
  double y = 0;
  EXPECT(v, "no %s", id);
  for (int k = 0; v && k < 3; k++) {
    double x = v->number[k];
    y += weight[k] * (x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4));
  }
  return y;
}

static void values_known_and_once(void) {
  for (uint32_t i = 0; i < species->value_count; i++) {
    const sozai_value *v = &species->values[i];
    const sozai_parameter *p = parameter(v->id);
    EXPECT(p, "%s is no parameter", v->id);
    EXPECT(given(v->id) == v, "%s is given twice", v->id);
    if (!p) continue;
    EXPECT(p->kind == v->kind, "%s: kind %u, not %u", v->id, v->kind, p->kind);
    if (v->kind == SOZAI_KIND_COLOUR) {
      EXPECT(v->text && strcmp(v->text, "sRGB") == 0, "%s is not in sRGB", v->id);
      for (int k = 0; k < 3; k++)
        EXPECT(v->number[k] >= 0 && v->number[k] <= 1, "%s: %g is no share of light", v->id,
               v->number[k]);
    } else if (v->kind != SOZAI_KIND_CHOICE) {
      EXPECT(v->number[0] >= p->soft_min / 3, "%s: %g is far below its usual %g", v->id,
             v->number[0], p->soft_min);
      EXPECT(v->number[0] <= 3 * p->soft_max, "%s: %g is far above its usual %g", v->id,
             v->number[0], p->soft_max);
    }
  }
}

/* "Common name (Genus species": the genus with a capital, the species without. */
static int has_botanical_name(const char *label) {
  const char *at = strchr(label, '(');
  if (!at || at == label || !isupper((unsigned char)*++at)) return 0;
  const char *genus = at++;
  while (islower((unsigned char)*at)) at++;
  if (at - genus < 3 || *at++ != ' ') return 0;
  if (strncmp(at, "x ", 2) == 0) at += 2; /* a hybrid */
  const char *name = at;
  while (islower((unsigned char)*at) || *at == '-') at++;
  return at - name >= 3 && (*at == ')' || *at == ' ') && label[strlen(label) - 1] == ')';
}

static void words(void) {
  EXPECT(has_botanical_name(species->label), "'%s' has no botanical name", species->label);
  EXPECT(strlen(species->doc) > 20, "'%s' says little", species->doc);
  EXPECT(species->doc[strlen(species->doc) - 1] == '.', "'%s' is no sentence", species->doc);
  EXPECT(strlen(species->source) > 20, "'%s' is no source", species->source);
  for (const char *c = species->id; *c; c++)
    EXPECT(islower((unsigned char)*c) || *c == '_', "'%c' in its id", *c);
  for (uint32_t i = 0; i < wood->preset_count; i++) {
    if (wood->presets[i] == species) continue;
    EXPECT(strcmp(wood->presets[i]->id, species->id) != 0, "another has its id");
    EXPECT(strcmp(wood->presets[i]->label, species->label) != 0, "another has its label");
  }
}

/* Share of a cross-section that vessels take. */
static double field(double diameter) {
  double d = 1e-3 * diameter, spread = number("vessel_diameter_spread");
  return number("vessel_density") * PI / 4 * d * d * (1 + spread * spread);
}

static void vessels(void) {
  if (is("porosity", "none")) {
    EXPECT(!given("vessel_density") && !given("earlywood_rows"), "vessels, but no porosity");
    return;
  }
  EXPECT(given("vessel_density") && given("vessel_diameter"), "porous, but no vessels");
  EXPECT(field(number("vessel_diameter")) < 0.6, "vessels take %.2f of it",
         field(number("vessel_diameter")));
  if (is("porosity", "semi_ring")) {
    EXPECT(number("vessel_diameter_late") < number("vessel_diameter"), "vessels grow in the ring");
  }
  if (!is("porosity", "ring")) return;
  EXPECT(given("earlywood_rows") && number("earlywood_rows") >= 1, "ring-porous without rows");
  double d = 1e-3 * number("earlywood_diameter"), spacing = 1 / number("earlywood_density");
  /* the rows stand a little more than a diameter apart */
  double band = 1.05 * d * number("earlywood_rows"), cover = PI / 4 * d / 1.05 / spacing;
  EXPECT(cover < 0.6, "vessels take %.2f of its rows", cover);
  EXPECT(d > 1.5e-3 * number("vessel_diameter"), "the latewood's vessels are as large");
  double narrow = number("ring_width") * (1 - 2 * number("ring_variation"));
  EXPECT(band < narrow, "rows of %.2f mm in rings of %.2f", band, narrow);
}

/* The share of a tangential face, and what cells of one ray have room for, in one layer or in two:
 * a wider one is narrowed, and the value would not be what it says. */
static void rays(void) {
  if (number("ray_density") <= 0) return;
  double area = number("ray_density") * number("ray_height") * 1e-3 * number("ray_width");
  EXPECT(given("ray_colour"), "rays without a colour");
  EXPECT(area * 2 / 3 < 0.25, "rays take %.2f of it", area * 2 / 3);
  /* of a cell 1.65 rays high: a fifth to either side, less for broad ones, which are uneven */
  double broad = fmin(fmax((number("ray_height") - 3) / 9, 0), 1);
  double room = 1.5 / 1.65 * fmin(0.2, 0.329 / 1.3 / (1 + 0.35 * broad));
  if (area > 1.25 * room) room *= 2;
  EXPECT(area <= room + 1e-9, "no room for its rays: %.3f, at most %.3f", area, room);
  EXPECT(1e-3 * number("ray_width") < 0.5 * number("ray_height"), "rays wide, not tall");
}

static void colours(void) {
  double early = luminance("earlywood_colour"), late = luminance("latewood_colour");
  double sap_early = luminance("sapwood_earlywood_colour");
  double sap_late = luminance("sapwood_latewood_colour");
  EXPECT(late <= early, "heartwood: latewood %.3f above earlywood %.3f", late, early);
  EXPECT(sap_late <= sap_early, "sapwood: latewood %.3f above earlywood %.3f", sap_late, sap_early);
  EXPECT(sap_early >= early - 1e-9, "earlywood: sapwood %.3f below %.3f", sap_early, early);
  EXPECT(sap_late >= late - 1e-9, "latewood: sapwood %.3f below %.3f", sap_late, late);
  EXPECT(late > 0.005 && early < 0.9, "no wood is that dark or pale: %.3f, %.3f", late, early);
  EXPECT(given("heartwood_years"), "no heartwood");
  if (!is("porosity", "none")) {
    EXPECT(luminance("vessel_colour") <= early + 1e-9, "vessels paler than the wood");
    EXPECT(given("sapwood_vessel_colour"), "no colour of vessels in sapwood");
    EXPECT(luminance("sapwood_vessel_colour") <= sap_early + 1e-9, "vessels paler than sapwood");
  }
}

static void plausible(void **state) {
  (void)state;
  wood = textures->find("wood");
  for (uint32_t i = 0; i < wood->preset_count; i++) {
    species = wood->presets[i];
    values_known_and_once();
    words();
    vessels();
    rays();
    colours();
  }
  CHECK(wrong == 0 && wood->preset_count >= 40, "%u species, %u faults\n", wood->preset_count,
        wrong);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(plausible)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
