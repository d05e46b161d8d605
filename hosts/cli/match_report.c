/* SPDX-License-Identifier: Apache-2.0 */
#include "match_report.h"

#include <math.h>
#include <string.h>
#include "quoted.h"
#include "utf8.h"

static bool fits_a_line(const unsigned char *s, int length) {
  if (length == 1) return *s >= 0x20 && *s != 0x7f;
  return length > 1 && utf8_plain(utf8_code(s, length));
}

/* A name within a line, whatever bytes a file's name may have. */
static void print_name(FILE *to, const char *name) {
  for (int length; *name; name += length > 1 ? length : 1) {
    length = utf8_length((const unsigned char *)name);
    if (fits_a_line((const unsigned char *)name, length))
      fwrite(name, 1, (size_t)length, to);
    else
      fputc('?', to);
  }
}

static void print_photo(FILE *to, const match_report *r, const char *begin) {
  const photo *p = r->photo;
  fprintf(to, "%sphotograph   ", begin);
  print_name(to, r->path);
  fprintf(to, "\n%s  %u x %u pixels of %.4g mm: %.4g mm wide%s; read as %s\n", begin, p->width,
          p->height, r->pixel, r->width, r->width_assumed ? " (assumed; say so with --width)" : "",
          p->space);
  fprintf(to, "%s  left out: %.2f %% as black, %.2f %% as highlights\n", begin, 100 * p->dark,
          100 * p->bright);
  if (p->light_high > p->light_low)
    fprintf(to, "%s  light evened out: it varied from %.2f to %.2f of its mean\n", begin,
            p->light_low, p->light_high);
  if (p->clipped > 0.01)
    fprintf(to, "%s  overexposed: %.0f %% of it is at the top of a channel's range\n", begin,
            100 * p->clipped);
}

static void print_parts(FILE *to, const match_report *r, const char *begin) {
  const match_result *m = r->result;
  const regions *g = &m->regions;
  fprintf(to, "%sparts        %s: the best split in two is %.1f deviations and dE2000 %.1f wide\n",
          begin, g->two ? "two" : "one", g->separation, g->difference);
  if (m->second_ignored)
    fprintf(to, "%s  the material has no colours for the second; the larger is matched\n", begin);
  for (size_t i = 0; i < m->part_count && m->part_count > 1; i++)
    fprintf(to, "%s  %s: %.0f %% of the photograph\n", begin, m->parts[i].name,
            100 * m->parts[i].share);
  if (m->has_boundary)
    fprintf(to, "%s  %s = %.2f, so that the face shows as much of either\n", begin,
            m->material.boundary, m->boundary);
}

static void print_shares(FILE *to, const match_report *r, const char *begin) {
  const match_shares *all = &r->result->shares;
  if (!all->found) return;
  fprintf(to, "%sshares        ranks lie %.3f deviations apart; with the preset's %.3f\n", begin,
          all->distance, all->preset_distance);
  for (size_t i = 0; i < all->count; i++) {
    const match_share *s = &all->of[i];
    fprintf(to, "%s  %-26s %.4f", begin, s->parameter, s->value);
    if (s->given)
      fputs("  as given\n", to);
    else
      fprintf(to, "  for the preset's %.4g\n", s->preset);
  }
}

static int byte_of(float x) { return (int)lroundf(255 * fminf(fmaxf(x, 0), 1)); }

static void print_colours(FILE *to, const match_report *r, const char *begin) {
  const match_result *m = r->result;
  fprintf(to, "%spalette      sRGB\n", begin);
  for (size_t i = 0; i < m->colour_count; i++) {
    const match_colour *c = &m->colours[i];
    fprintf(to, "%s  %-26s %.4f %.4f %.4f  #%02x%02x%02x%s\n", begin, c->parameter,
            (double)c->srgb[0], (double)c->srgb[1], (double)c->srgb[2], byte_of(c->srgb[0]),
            byte_of(c->srgb[1]), byte_of(c->srgb[2]),
            c->given     ? "  as given"
            : c->unseen  ? "  the preset's: too little of it shows"
            : c->derived ? "  by the preset's ratio"
                         : "");
  }
  if (!m->material.brightness) return;
  fprintf(to, "%s  %-26s %.4f", begin, m->material.brightness, m->brightness);
  if (!m->brightness_free)
    fputs("  as given\n", to);
  else if (m->shares.found)
    fprintf(to, "  for the preset's %.4g: by the shares' ranks\n", m->preset_brightness);
  else if (m->brightness_changed)
    fprintf(to, "  for the preset's %.4g: residual %.4f instead of %.4f\n", m->preset_brightness,
            m->residual, m->preset_residual);
  else
    fprintf(to, "  the preset's: no other is better (residual %.4f)\n", m->preset_residual);
}

static void print_part(FILE *to, const match_part *p, const char *begin) {
  fprintf(to, "%smean%s%-8s photograph                        result\n%s  %12s", begin,
          *p->name ? " of " : "", p->name, begin, "");
  for (int k = 0; k < 3; k++) fprintf(to, " %.5f", p->photo.mean[k]);
  fputs("          ", to);
  for (int k = 0; k < 3; k++) fprintf(to, " %.5f", p->result.mean[k]);
  fprintf(to, "   dE2000 %.3f\n%scovariance, times 1e4\n", p->mean_difference, begin);
  for (int row = 0; row < 3; row++) {
    fprintf(to, "%s  %9s", begin, "");
    for (int k = 0; k < 3; k++) fprintf(to, " %8.3f", 1e4 * p->photo.covariance[3 * row + k]);
    fputs("       ", to);
    for (int k = 0; k < 3; k++) fprintf(to, " %8.3f", 1e4 * p->result.covariance[3 * row + k]);
    if (row == 2) fprintf(to, "   relative difference %.4f", p->covariance_difference);
    fputc('\n', to);
  }
}

void match_print(FILE *to, const match_report *r, const char *begin) {
  print_photo(to, r, begin);
  print_parts(to, r, begin);
  print_shares(to, r, begin);
  print_colours(to, r, begin);
  fprintf(to, "%sstatistics   in %s\n", begin, r->working);
  for (size_t i = 0; i < r->result->part_count; i++) print_part(to, &r->result->parts[i], begin);
}

void match_write_recipe(FILE *to, const match_report *r) {
  fputs("# Proposed by sozai match.\n", to);
  match_print(to, r, "# ");
  fprintf(to, "material: %s\n", r->recipe->material);
  if (r->recipe->preset) fprintf(to, "preset: %s\n", r->recipe->preset);
  fputs("params:\n", to);
  for (size_t i = 0; i < r->recipe->param_count; i++) {
    fprintf(to, "  %s: ", r->recipe->params[i].id);
    print_quoted(to, r->recipe->params[i].text);
    fputc('\n', to);
  }
  fprintf(to, "surface: # the face that was compared\n  shape: plane\n  size: [%.6g, %.6g]\n",
          r->pixel * r->photo->width, r->pixel * r->photo->height);
}
