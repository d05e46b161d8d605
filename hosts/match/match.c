/* SPDX-License-Identifier: Apache-2.0 */
#include "match.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "appearance.h"
#include "linear.h"
#include "weights.h"

/* A brightness is worth changing for a residual smaller by this, or a cost, the
 * third moments in it, by this factor. Palettes make up for a wrong brightness
 * in mean and covariance, but not in skewness. */
#define WORTH 0.01
#define PLAINLY 0.4

typedef struct matching {
  match_result *out;
  recipe *recipe;
  photo *photo;
  const board *board;
  const colour *colour;
  const sozai_texture_info *info;
  size_t roles;
  bool given[MOST_ROLES], unseen[MOST_ROLES], second_given[MOST_ROLES], brightness_given,
      boundary_given;
  uint8_t pixel;                 /* what the photograph's pixels of the first part hold */
  palette preset, preset_second; /* working space */
  double most_brightness;
  moments weights;
} matching;

static bool is_given(const recipe *r, const char *id) { return id && recipe_sets(r, id); }

/* ---- the preset --------------------------------------------------------------- */

static bool read_colour(const matching *m, const sozai_texture *texture, const char *id,
                        double *out, failure *why) {
  sozai_value v;
  if (m->board->textures->value(texture, id, &v) != SOZAI_OK)
    return fail(why, EXIT_FAILURE, "%s: %s", id, m->board->textures->last_error());
  float rgb[3] = {(float)v.number[0], (float)v.number[1], (float)v.number[2]};
  if (!appearance_to_working(m->colour, v.text ? v.text : "sRGB", rgb, 1, why)) return false;
  for (int k = 0; k < 3; k++) out[k] = (double)rgb[k];
  return true;
}

static bool read_brightness(matching *m, const sozai_texture *texture, failure *why) {
  const char *id = m->out->material.brightness;
  sozai_value v;
  if (!id) return true;
  if (m->board->textures->value(texture, id, &v) != SOZAI_OK)
    return fail(why, EXIT_FAILURE, "%s: %s", id, m->board->textures->last_error());
  m->out->brightness = m->out->preset_brightness = v.number[0];
  const sozai_parameter *p = parameter_of(m->info, id);
  if (p) m->most_brightness = p->hard_max;
  return true;
}

static bool read_preset(matching *m, failure *why) {
  const match_material *material = &m->out->material;
  sozai_texture *texture = NULL;
  if (!recipe_create(m->recipe, m->board->textures, &m->board->host->abi, &texture, why))
    return false;
  bool ok = read_brightness(m, texture, why);
  for (size_t i = 0; ok && i < m->roles; i++) {
    const match_role *role = &material->roles[i];
    m->given[i] = is_given(m->recipe, role->colour);
    m->second_given[i] = is_given(m->recipe, role->second);
    ok = read_colour(m, texture, role->colour, m->preset[i], why) &&
         (!role->second || read_colour(m, texture, role->second, m->preset_second[i], why));
  }
  m->brightness_given = is_given(m->recipe, material->brightness);
  m->boundary_given = is_given(m->recipe, material->boundary);
  m->board->textures->destroy(texture);
  return ok;
}

/* ---- weights ------------------------------------------------------------------- */

static weighing weighing_of(const matching *m) {
  return (weighing){.board = m->board,
                    .colour = m->colour,
                    .material = &m->out->material,
                    .roles = m->roles,
                    .most_brightness = m->most_brightness};
}

static bool weigh(matching *m, failure *why) {
  const weighing q = weighing_of(m);
  weights w;
  if (!weights_take(&w, &q, m->recipe, why)) return false;
  moments_take(&m->weights, w.of, w.stride, w.points, NULL, 0);
  for (size_t i = 0; i < m->roles; i++) m->unseen[i] = m->weights.mean[i] < LEAST_WEIGHT;
  weights_free(&w);
  return true;
}

/* ---- colours --------------------------------------------------------------------- */

static bool propose(matching *m, const char *parameter, const double working[3], bool derived,
                    bool given, bool unseen, failure *why) {
  match_colour *c = &m->out->colours[m->out->colour_count++];
  *c = (match_colour){
      .parameter = parameter, .derived = derived, .given = given, .unseen = unseen && !given};
  bool within = true;
  for (int k = 0; k < 3; k++) {
    c->working[k] = working[k];
    c->srgb[k] = (float)working[k];
  }
  if (!appearance_srgb(m->colour, c->srgb, 1, why)) return false;
  for (int k = 0; k < 3; k++) within = within && c->srgb[k] >= -5e-5f && c->srgb[k] <= 1.00005f;
  if (given || unseen) return true;
  /* sRGB means the same under every config; the working space where that is too small */
  if (within)
    snprintf(c->text, sizeof c->text, "%.4f %.4f %.4f @ sRGB", fabs((double)c->srgb[0]),
             fabs((double)c->srgb[1]), fabs((double)c->srgb[2]));
  else
    snprintf(c->text, sizeof c->text, "%.5f %.5f %.5f @ %s", working[0], working[1], working[2],
             m->colour->service->working_space(m->colour->service->self));
  return recipe_set(m->recipe, parameter, c->text, 0, why);
}

static fit_problem problem_of(const matching *m, const moments *target) {
  fit_problem q = {.roles = m->roles,
                   .weights = &m->weights,
                   .target = target,
                   .has_brightness = m->out->material.brightness != NULL,
                   .brightness = m->out->brightness,
                   .most_brightness = m->most_brightness};
  memcpy(q.reference, m->preset, sizeof q.reference);
  memcpy(q.fixed_colour, m->preset, sizeof q.fixed_colour);
  for (size_t i = 0; i < m->roles; i++) q.fixed[i] = m->given[i] || m->unseen[i];
  return q;
}

/* With the preset's brightness, and with the best. */
static void fit_first(matching *m, const moments *target, fit *best) {
  fit_problem q = problem_of(m, target);
  fit_palette(&q, best);
  m->out->residual = m->out->preset_residual = best->residual;
  m->out->brightness_free = q.has_brightness && !m->brightness_given;
  if (!m->out->brightness_free || m->out->shares.found) return;
  fit freed;
  q.free_brightness = true;
  fit_palette(&q, &freed);
  bool less = freed.residual < best->residual - WORTH && freed.cost < best->cost;
  if (!less && freed.cost > PLAINLY * best->cost) return;
  *best = freed;
  m->out->residual = freed.residual;
  m->out->brightness = freed.brightness;
  m->out->brightness_changed = true;
}

/* The second part has colours of its own, and shares the others and the brightness. */
static void fit_second(const matching *m, const moments *target, const fit *first, fit *out) {
  fit_problem q = problem_of(m, target);
  for (size_t i = 0; i < m->roles; i++) {
    bool shared = !m->out->material.roles[i].second;
    q.fixed[i] = shared || m->second_given[i] || m->unseen[i];
    memcpy(q.reference[i], shared ? m->preset[i] : m->preset_second[i], sizeof q.reference[i]);
    memcpy(q.fixed_colour[i], shared ? first->colour[i] : m->preset_second[i],
           sizeof q.fixed_colour[i]);
  }
  fit_palette(&q, out);
}

static bool keep_first(matching *m, const fit *f, failure *why) {
  bool ok = true;
  for (size_t i = 0; ok && i < m->roles; i++)
    ok = propose(m, m->out->material.roles[i].colour, f->colour[i], false, m->given[i],
                 m->unseen[i], why);
  if (!ok || !m->out->brightness_changed) return ok;
  char text[32];
  snprintf(text, sizeof text, "%.4f", m->out->brightness);
  return recipe_set(m->recipe, m->out->material.brightness, text, 0, why);
}

/* second: its fit; NULL: the photograph does not show it, and it stands to the
 * first as the preset's stands to the preset's. */
static bool keep_second(matching *m, const fit *first, const fit *second, failure *why) {
  bool ok = true;
  for (size_t i = 0; ok && i < m->roles; i++) {
    const char *id = m->out->material.roles[i].second;
    if (!id) continue;
    double rgb[3];
    for (int k = 0; k < 3; k++) {
      double ratio = m->preset_second[i][k] / fmax(m->preset[i][k], 1e-4);
      rgb[k] = second ? second->colour[i][k] : fmin(first->colour[i][k] * ratio, 1);
      if (m->second_given[i] || m->unseen[i]) rgb[k] = m->preset_second[i][k];
    }
    ok = propose(m, id, rgb, !second, m->second_given[i], m->unseen[i], why);
  }
  return ok;
}

/* Where the second part begins, so that the board shows as much of it as the
 * photograph. */
static int rising(const void *a, const void *b) {
  float x = *(const float *)a, y = *(const float *)b;
  return (x > y) - (x < y);
}

static bool place_boundary(matching *m, failure *why) {
  const match_material *material = &m->out->material;
  if (!material->boundary || m->boundary_given) return true;
  float *values = NULL;
  if (!board_channel(m->board, m->recipe, material->boundary_channel, &values, why)) return false;
  uint64_t points = board_points(m->board);
  qsort(values, points, sizeof *values, rising);
  const regions *r = &m->out->regions;
  double share = r->share / (r->share + r->second_share);
  m->out->boundary = fmax(0, (double)values[(uint64_t)(share * (double)(points - 1))]);
  free(values);
  m->out->has_boundary = true;
  char text[32];
  snprintf(text, sizeof text, "%.2f", m->out->boundary);
  return recipe_set(m->recipe, material->boundary, text, 0, why);
}

/* ---- shares --------------------------------------------------------------------------- */

/* And the brightness that goes with them; colours are then fitted to the face of both. */
static bool find_shares(matching *m, failure *why) {
  match_result *out = m->out;
  const weighing w = weighing_of(m);
  const fit_problem problem = problem_of(m, &out->parts[0].photo);
  const share_search q = {&w, m->photo, m->pixel, &problem, m->info};
  if (!shares_fit(&q, m->recipe, &out->shares, why)) return false;
  if (out->shares.found && out->shares.has_brightness) out->brightness = out->shares.brightness;
  return true;
}

/* ---- what comes of it --------------------------------------------------------------- */

static const char *text_of(const recipe *r, const char *id) {
  for (size_t i = 0; i < r->param_count; i++)
    if (strcmp(r->params[i].id, id) == 0) return r->params[i].text;
  return NULL;
}

/* The material as it is written, but all of one part. */
static bool measure(const matching *m, match_part *part, bool second, failure *why) {
  recipe r;
  if (!weights_copy_recipe(&r, m->recipe, why)) return false;
  bool ok = true;
  for (size_t i = 0; ok && i < m->roles; i++) {
    const match_role *role = &m->out->material.roles[i];
    if (!role->second) continue;
    const char *text = text_of(m->recipe, second ? role->second : role->colour);
    ok = !text || weights_set_role(&r, role, text, why);
  }
  float *rgb = NULL;
  ok = ok && board_channel(m->board, &r, "albedo", &rgb, why);
  if (ok) moments_take(&part->result, rgb, 3, board_points(m->board), NULL, 0);
  free(rgb);
  recipe_free(&r);
  return ok;
}

static bool compare(const matching *m, match_part *part, failure *why) {
  float means[6];
  double d[9], lab[2][3];
  for (int k = 0; k < 3; k++) {
    means[k] = (float)part->photo.mean[k];
    means[3 + k] = (float)part->result.mean[k];
  }
  if (!appearance_lab(m->colour, means, 2, why)) return false;
  for (int k = 0; k < 6; k++) lab[k / 3][k % 3] = (double)means[k];
  part->mean_difference = ciede2000(lab[0], lab[1]);
  for (int i = 0; i < 9; i++) d[i] = part->result.covariance[i] - part->photo.covariance[i];
  part->covariance_difference = frobenius(d) / fmax(frobenius(part->photo.covariance), 1e-18);
  return true;
}

/* ---- all of it -------------------------------------------------------------------------- */

static bool find_parts(matching *m, failure *why) {
  match_result *out = m->out;
  if (!regions_find(&out->regions, m->photo, m->colour, why)) return false;
  const photo *p = m->photo;
  uint64_t pixels = (uint64_t)p->width * p->height;
  bool has_second = false;
  for (size_t i = 0; i < m->roles; i++) has_second = has_second || out->material.roles[i].second;
  out->second_ignored = out->regions.two && !has_second;
  const size_t parts = out->regions.two && has_second ? 2 : 1;
  out->part_count = parts;
  bool lighter = out->second_ignored && out->regions.second_share > out->regions.share;
  for (size_t i = 0; i < parts; i++) {
    match_part *part = &out->parts[i];
    uint8_t value = i == 1 || lighter ? PIXEL_SECOND : PIXEL_PART;
    if (i == 0) m->pixel = value;
    part->name = i ? out->material.second_part : parts > 1 ? out->material.part : "";
    part->share = value == PIXEL_SECOND ? out->regions.second_share : out->regions.share;
    moments_take(&part->photo, p->rgb, 3, pixels, p->pixel, value);
    if (part->photo.count < PHOTO_LEAST_PIXELS)
      return fail(why, EXIT_BAD_INPUT, "only %llu pixels of %s are left; a palette takes %u",
                  (unsigned long long)part->photo.count,
                  *part->name ? part->name : "the photograph", PHOTO_LEAST_PIXELS);
  }
  return true;
}

static bool run(matching *m, failure *why) {
  match_result *out = m->out;
  fit first, second;
  if (!read_preset(m, why) || !find_parts(m, why) || !find_shares(m, why) || !weigh(m, why))
    return false;
  bool two = out->part_count > 1;
  fit_first(m, &out->parts[0].photo, &first);
  if (two) fit_second(m, &out->parts[1].photo, &first, &second);
  if (!keep_first(m, &first, why) || !keep_second(m, &first, two ? &second : NULL, why) ||
      (two && !place_boundary(m, why)))
    return false;
  for (size_t i = 0; i < out->part_count; i++)
    if (!measure(m, &out->parts[i], i > 0, why) || !compare(m, &out->parts[i], why)) return false;
  return true;
}

bool match_run(match_result *out, recipe *r, const match_material *m, photo *p, const board *b,
               const colour *c, failure *why) {
  memset(out, 0, sizeof *out);
  matching all = {.out = out, .recipe = r, .photo = p, .board = b, .colour = c};
  all.info = recipe_info(r, b->textures, NULL, why);
  if (!all.info) return false;
  out->material = match_material_of(m, all.info);
  all.roles = match_role_count(&out->material);
  if (all.roles < 2)
    return fail(why, EXIT_BAD_INPUT, "this plugin's %s has too few colours to match", m->id);
  for (size_t i = 0; i < MOST_BOARD && m->board[i][0]; i++)
    if (!is_given(r, m->board[i][0]) && !recipe_set(r, m->board[i][0], m->board[i][1], 0, why))
      return false;
  return run(&all, why);
}
