/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood's evaluate: compiled once for each instruction set and width.
 */
#include "../core/lanes.h"
#include "cone.h"
#include "fibre.h"
#include "grain.h"
#include "heart.h"
#include "picture.h"
#include "vessels.h"

#define PASTE_(a, b) a##b
#define PASTE(a, b) PASTE_(a, b)
#define NAMED(name) PASTE(name, SOZAI_KERNEL_SUFFIX)
#define STRING_(a) #a
#define STRING(a) STRING_(a)

extern const wood_kernel NAMED(wood_kernel_);

INLINE void store_lanes(const wood_io *io, int channel, uint32_t i, uint32_t n, vf x) {
  if (io->wanted >> channel & 1) store_active(io->in, io->out[channel], i, n, x);
}

INLINE void to_log(const wood_constants *w, const vf p[3], vf out[3]) {
  if (!w->turned) {
    for (int c = 0; c < 3; c++) out[c] = p[c];
    return;
  }
  for (int c = 0; c < 3; c++) {
    out[c] =
        splat(w->turn[c][0]) * p[0] + splat(w->turn[c][1]) * p[1] + splat(w->turn[c][2]) * p[2];
  }
}

/* What has been asked for, and the stages that it takes. */
typedef struct {
  int radiance, colour, fibre, dive;
  int late, vessel, lobe, direction, section, picture, cone;
} wood_wants;

static int wanted(const wood_io *io, int first, int count) {
  return (io->wanted >> first & ((1ull << count) - 1)) != 0;
}

static wood_wants wants_of(const wood_constants *w, const wood_io *io) {
  wood_wants q;
  q.radiance = wanted(io, WOOD_RADIANCE, 3);
  q.colour = wanted(io, WOOD_ALBEDO, 3) || q.radiance;
  q.fibre = wanted(io, WOOD_FIBER, 3);
  q.dive = wanted(io, WOOD_DIVE, 1);
  q.vessel = wanted(io, WOOD_VESSEL, 1) || q.colour;
  q.late = wanted(io, WOOD_LATEWOOD, 1) || q.vessel;
  q.picture = w->picture && q.late;
  if (w->picture) q.late = q.vessel = 0;
  q.lobe = wanted(io, WOOD_SPECULAR, 2) || q.radiance;
  q.cone = wanted(io, WOOD_CONE_COLOUR, 5);
  q.direction = q.fibre || q.dive || q.radiance || q.cone;
  q.section =
      q.direction || q.vessel || q.picture || q.lobe || q.cone || wanted(io, WOOD_REFERENCE, 2);
  return q;
}

/* Average of a ring's profile over a footprint that may be wide enough for the
 * rings' curvature: the surface is followed across the grain through five
 * nodes, and between two nodes rho runs in a straight line. */
INLINE vf rings_across(const wood_constants *w, int what, const stem_place *p,
                       const ring_place *ring, const vf g[3], const vf n[3], int ball, vf s) {
  footprint2 f = footprint_through(g, g, n, ball, s);
  vf e = vsqrt(f.aa + splat(12.0f) * p->lost);
  vf mean = ring_average(w, what, ring, p->rho, e);
  /* the sag of s over a radius r is s^2 / 8 r at most */
  if (ball || !any(gt(s * s, splat(0.64f * w->ring_width) * p->r))) return mean;

  /* across: the horizontal direction in the surface */
  vf flat2 = n[0] * n[0] + n[2] * n[2];
  vm end = lt(flat2, splat(0.09f)); /* end grain: along the radius */
  vf k = inverse_root(vmax(flat2, splat(1e-6f)));
  vf ux = sel(end, p->c, n[2] * k), uz = sel(end, p->s, splat(0.0f) - n[0] * k);
  vf ur = ux * p->c + uz * p->s, ut2 = vmax(splat(1.0f) - ur * ur, splat(0.0f));
  vf sag = s * s * ut2 / (splat(8.0f) * p->r);
  vm curved = gt(sag, splat(0.08f * w->ring_width));
  if (!any(curved)) return mean;

  vf slope = p->rho_x * ux + p->rho_z * uz; /* of rho along u */
  vf radial = p->rho_x * p->c + p->rho_z * p->s;
  vf linear = slope - radial * ur;
  /* what is not along u widens every part */
  vf gn = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
  vf all = vmax(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] - gn * gn, splat(0.0f));
  vf side = vmax(all - slope * slope, splat(0.0f)) * s * s + splat(12.0f) * p->lost;
  vf widen = side + sag * sag * splat(0.01f);
  vf sum = splat(0.0f), before = sum;
  for (int i = 0; i <= 4; i++) {
    vf a = s * splat(0.25f * (float)i - 0.5f);
    vf r = vsqrt(vmax(p->r * p->r + splat(2.0f) * p->r * ur * a + a * a, splat(1e-12f)));
    vf rho = vmax(p->rho + (r - p->r) * radial + linear * a, splat(0.0f));
    if (i) {
      vf middle = splat(0.5f) * (rho + before), span = rho - before;
      ring_place at = ring_at(w, middle);
      sum = sum + ring_average(w, what, &at, middle, vsqrt(span * span + widen));
    }
    before = rho;
  }
  return sel(curved, sum * splat(0.25f), mean);
}

/* A block of LANES points on its way through the stages. The stages run over a
 * few blocks each before the next begins: the blocks do not wait for one
 * another, and what one leaves idle of the processor the next one uses. */
typedef struct {
  uint32_t i, n;      /* the first point, and how many */
  vf p[3];            /* log space */
  vf nrm[3];          /* normal, log space */
  vf s;               /* footprint */
  vf up2, inverse_up; /* squared length of +y within the surface, its inverse root */
  stem_place stem;
  ring_place ring;
  vf years, divisor, phase;
  grain_place grain;
  vf c, sn, x, z; /* reference section: direction and place */
  vf fibre[3];    /* unit, log space */
  vf sine;        /* of the dive angle */
  vf b[3];        /* row of the map from surface to rho */
  vf late, albedo[3];
} block;

INLINE void stage_load(const wood_constants *w, const wood_io *io, block *k) {
  vf p[3];
  for (int c = 0; c < 3; c++) p[c] = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n));
  to_log(w, p, k->p);
  for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + splat(w->shift[c]);
  k->s = splat(0.0f);
  if (io->in->footprint) {
    k->s = clamp(load_lanes(io->in->footprint, k->i, k->n), splat(0.0f), splat(1e4f));
  }
  k->up2 = splat(1.0f);
  vf normal[3] = {splat(0.0f), splat(0.0f), splat(1.0f)};
  if (io->in->normal[0]) {
    for (int c = 0; c < 3; c++) normal[c] = load_lanes(io->in->normal[c], k->i, k->n);
    unit_direction(normal);
  }
  to_log(w, normal, k->nrm);
  if (io->in->normal[0]) k->up2 = vmax(splat(1.0f) - k->nrm[1] * k->nrm[1], splat(0.0f));
  k->inverse_up = inverse_root(vmax(k->up2, splat(1e-12f)));
}

INLINE void stage_stem(const wood_constants *w, const wood_io *io, block *k) {
  k->stem = stem_at(w, k->p[0], k->p[1], k->p[2], k->s);
  k->ring = ring_at(w, k->stem.rho);
  k->years = to_float(k->ring.ring) + k->ring.phase;
  store_lanes(io, WOOD_TIME, k->i, k->n, k->years);
  k->divisor = grain_divisor(k->stem.rho);
}

INLINE void stage_grain(const wood_constants *w, const wood_io *io, block *k) {
  k->grain = grain_at(w, k->p[1], k->years, k->s * (k->up2 * k->inverse_up));
  k->phase = k->grain.d * k->divisor;
  vf s, c, unused;
  sine_cosine(k->phase, &s, &c);
  k->c = k->stem.c * c + k->stem.s * s;
  k->sn = k->stem.s * c - k->stem.c * s;
  vf radius = k->stem.rho * (splat(1.0f) + outline_at(w, k->c, k->sn, &unused));
  k->x = radius * k->c;
  k->z = radius * k->sn;
  store_lanes(io, WOOD_REFERENCE, k->i, k->n, k->x);
  store_lanes(io, WOOD_REFERENCE + 1, k->i, k->n, k->z);
}

/* The fibre's direction: theta' and rho are constant along it. */
INLINE void stage_fibre(const wood_constants *w, const wood_io *io, const wood_wants *want,
                        block *k) {
  const stem_place *stem = &k->stem;
  vf one = splat(1.0f), zero = splat(0.0f), f[3];
  vf omega = k->grain.g_filtered * k->divisor;
  vf rho_r = stem->rho_x * stem->c + stem->rho_z * stem->s;
  vf rho_t = stem->r * (stem->rho_z * stem->c - stem->rho_x * stem->s);
  vf climb = (zero - stem->rho_y - rho_t * omega) / vmax(rho_r, splat(0.05f));
  vf around = stem->r * omega;
  f[0] = climb * stem->c - around * stem->s + stem->pith.dx;
  f[2] = climb * stem->s + around * stem->c + stem->pith.dz;
  f[1] = inverse_root(f[0] * f[0] + one + f[2] * f[2]);
  f[0] = f[0] * f[1];
  f[2] = f[2] * f[1];
  for (int c = 0; c < 3; c++) k->fibre[c] = f[c];
  k->sine = zero - (f[0] * k->nrm[0] + f[1] * k->nrm[1] + f[2] * k->nrm[2]);
  if (want->fibre) {
    for (int c = 0; c < 3; c++) {
      vf back = f[c];
      if (w->turned) {
        back =
            splat(w->turn[0][c]) * f[0] + splat(w->turn[1][c]) * f[1] + splat(w->turn[2][c]) * f[2];
      }
      store_lanes(io, WOOD_FIBER + c, k->i, k->n, back);
    }
  }
  if (want->dive) store_lanes(io, WOOD_DIVE, k->i, k->n, arcsin(k->sine));
}

INLINE void stem_row(block *k) {
  const stem_place *stem = &k->stem;
  k->b[0] = stem->rho_x;
  k->b[1] = stem->rho_y - stem->rho_x * stem->pith.dx - stem->rho_z * stem->pith.dz;
  k->b[2] = stem->rho_z;
}

INLINE void stage_rings(const wood_constants *w, const wood_io *io, block *k) {
  const stem_place *stem = &k->stem;
  stem_row(k);
  k->late = rings_across(w, MEAN_LATE, stem, &k->ring, k->b, k->nrm, !io->in->normal[0], k->s);
  store_lanes(io, WOOD_LATEWOOD, k->i, k->n, k->late);
}

/* The footprint over (arc, rho) of the reference section. */
INLINE footprint2 footprint_in_section(const wood_io *io, const block *k) {
  const stem_place *stem = &k->stem;
  vf zero = splat(0.0f);
  /* the row of the map from surface to arc */
  vf ratio = stem->rho * stem->inverse_r;
  vf phi_rho =
      (k->grain.d_t * k->ring.inverse_width - k->phase * stem->rho * k->divisor) * k->divisor;
  vf shear = stem->rho * phi_rho, g = stem->rho * k->grain.g * k->divisor;
  vf tx = zero - ratio * stem->s, tz = ratio * stem->c;
  vf a[3] = {tx - shear * k->b[0],
             zero - tx * stem->pith.dx - tz * stem->pith.dz - g - shear * k->b[1],
             tz - shear * k->b[2]};
  return footprint_through(a, k->b, k->nrm, !io->in->normal[0], k->s);
}

INLINE void stage_tissue(const wood_constants *w, const wood_io *io, const wood_wants *want,
                         block *k) {
  const stem_place *stem = &k->stem;
  vf one = splat(1.0f), zero = splat(0.0f);
  int ball = !io->in->normal[0];
  footprint2 f = footprint_in_section(io, k);

  vessel_cover_t v = {zero, zero, zero, zero};
  if (w->has_pores || w->rows) {
    vessel_place place = {k->x, k->z, k->c, k->sn, stem->rho, k->ring, f};
    v = vessels_at(w, &place);
  }
  vf pores = v.pores, rows = v.rows, over_late = v.pores;
  if (w->has_pores && any(gt(v.pores_faded, zero))) {
    vf expected = one;
    if (w->pore_growth != 0.0f) {
      expected = rings_across(w, MEAN_PORE, stem, &k->ring, k->b, k->nrm, ball, k->s);
    }
    pores = mix(pores, splat(w->pores.coverage) * expected, v.pores_faded);
    over_late = mix(over_late, splat(w->late_vessel), v.pores_faded);
  }
  if (w->rows && any(gt(v.rows_faded, zero))) {
    vf expected = rings_across(w, MEAN_ROW, stem, &k->ring, k->b, k->nrm, ball, k->s);
    rows = mix(rows, splat(w->row.coverage) * expected, v.rows_faded);
  }
  vf cover = pores + rows - pores * rows; /* they stand where they like */
  store_lanes(io, WOOD_VESSEL, k->i, k->n, cover);
  if (!want->colour) return;
  /* earlywood rows stand where there is no latewood; pores everywhere */
  vf late = k->late * (one - vmin(over_late, one));
  vf shift = one + fibre_shift(w, k->x, k->z, f.aa + f.bb);
  vf early = vmax(one - cover - late, zero) * shift, dark = late * shift;
  vf heart = heart_share(w, k->years, k->c, k->sn, vsqrt(f.bb) * k->ring.inverse_width);
  vm pale = lt(heart, one);
  int some = any(pale);
  for (int c = 0; c < 3; c++) {
    vf light = splat(w->early[c]), deep = splat(w->late[c]);
    if (some) {
      light = sel(pale, mix(splat(w->sap_early[c]), light, heart), light);
      deep = sel(pale, mix(splat(w->sap_late[c]), deep, heart), deep);
    }
    k->albedo[c] = light * early + deep * dark + splat(w->vessel[c]) * cover;
    store_lanes(io, WOOD_ALBEDO + c, k->i, k->n, k->albedo[c]);
  }
}

/* The same from a picture of the section: it shows rings, vessels and fibres
 * down to its pixels, and the fibres' noise goes on below them. */
INLINE void stage_picture(const wood_constants *w, const wood_io *io, block *k) {
  const stem_place *stem = &k->stem;
  stem_row(k);
  footprint2 f = footprint_in_section(io, k);
  vf unused, widen = splat(1.0f) + outline_at(w, k->c, k->sn, &unused);
  picture_place p = picture_fold(w, k->x, k->z, k->c, k->sn, stem->rho);
  picture_albedo(w, &p, k->c, k->sn, widen, &f, k->n, k->albedo);
  store_lanes(io, WOOD_LATEWOOD, k->i, k->n, picture_late(w, k->albedo));
  store_lanes(io, WOOD_VESSEL, k->i, k->n, splat(0.0f));
  vf shift = splat(1.0f) + fibre_shift(w, p.x, p.z, f.aa + f.bb);
  for (int c = 0; c < 3; c++) {
    k->albedo[c] = k->albedo[c] * shift;
    store_lanes(io, WOOD_ALBEDO + c, k->i, k->n, k->albedo[c]);
  }
}

/* Radiance of a channel, under the light's colour. */
INLINE void store_lit(const wood_io *io, const block *k, int c, vf r) {
  if (io->in->light_colour[c]) {
    vf e = load_lanes(io->in->light_colour[c], k->i, k->n);
    r = r * sel(lt(vabs(e), splat(1e30f)), e, splat(0.0f));
  }
  store_lanes(io, WOOD_RADIANCE + c, k->i, k->n, r);
}

/* Towards the eye, log space; the normal where no view is given, or none that
 * is a direction. */
INLINE void view_of(const wood_constants *w, const wood_io *io, const block *k, vf out[3]) {
  for (int c = 0; c < 3; c++) out[c] = k->nrm[c];
  if (!io->in->view[0]) return;
  vf v[3], turned[3], size = splat(0.0f);
  for (int c = 0; c < 3; c++) {
    v[c] = load_lanes(io->in->view[c], k->i, k->n);
    size = size + vabs(v[c]);
  }
  vm given = and_(gt(size, splat(0.0f)), lt(size, splat(1e38f)));
  unit_direction(v);
  to_log(w, v, turned);
  for (int c = 0; c < 3; c++) out[c] = sel(given, turned[c], k->nrm[c]);
}

/* What a host needs to build the cone itself. */
INLINE void stage_cone(const wood_constants *w, const wood_io *io, block *k) {
  cone_dive dive = cone_dive_of(k->sine);
  vf scale = w->cone ? cone_along(w->cone_scale, &dive) : splat(1.0f);
  for (int c = 0; c < 3; c++) {
    store_lanes(io, WOOD_CONE_COLOUR + c, k->i, k->n, splat(w->fibre_colour[c]) * scale);
  }
  vf width2 = splat(w->cone_width * w->cone_width) + splat(4.0f) * k->grain.variance;
  store_lanes(io, WOOD_CONE_WIDTH, k->i, k->n, vsqrt(width2));
  store_lanes(io, WOOD_COAT, k->i, k->n, splat(w->coat));
}

/* Figure, Kawai's equation (4): the lobe's normal dives with the fibre; slopes
 * that the footprint averages widen it instead. */
INLINE void stage_figure(const wood_constants *w, const wood_io *io, const wood_wants *want,
                         block *k) {
  vf one = splat(1.0f), zero = splat(0.0f);
  vf exponent = splat(w->shininess), strength = splat(w->specular);
  vf roughness = splat(w->roughness);
  vm widened = gt(k->grain.variance * exponent, splat(1e-4f));
  if (any(widened)) {
    vf across = k->nrm[2] * k->stem.c - k->nrm[0] * k->stem.s;
    vf wide = one / (one + exponent * (k->grain.variance * across * across));
    wide = sel(widened, wide, one);
    exponent = exponent * wide;
    strength = strength * vsqrt(wide);
    roughness = vmin(vsqrt(splat(2.0f) / (exponent + splat(2.0f))), one);
  }
  store_lanes(io, WOOD_SPECULAR, k->i, k->n, strength);
  store_lanes(io, WOOD_ROUGHNESS, k->i, k->n, roughness);
  if (!want->radiance) return;

  vf light[3], l[3];
  for (int c = 0; c < 3; c++) light[c] = load_lanes(io->in->light[c], k->i, k->n);
  unit_direction(light);
  to_log(w, light, l);
  if (w->cone) {
    vf r[3], v[3];
    view_of(w, io, k, v);
    cone_radiance(w, l, v, k->nrm, k->fibre, k->sine, k->grain.variance, k->albedo, r);
    for (int c = 0; c < 3; c++) store_lit(io, k, c, r[c]);
    return;
  }
  vf incident = l[0] * k->nrm[0] + l[1] * k->nrm[1] + l[2] * k->nrm[2];
  /* up the stem within the surface */
  vf rise = (l[1] - k->nrm[1] * incident) * k->inverse_up;
  rise = sel(gt(k->up2, splat(1e-6f)), rise, zero);
  vf cosine = vsqrt(vmax(one - k->sine * k->sine, zero));
  vf tilted = clamp01(incident * cosine + rise * k->sine);
  vf gloss = strength * power01(tilted, exponent);
  vf diffuse = splat(w->diffuse) * vmax(incident, zero);
  for (int c = 0; c < 3; c++) {
    store_lit(io, k, c, diffuse * k->albedo[c] + gloss * splat(w->tint_colour[c]));
  }
}

#define BLOCKS (LANES == 1 ? 1 : 2)

static void evaluate(const wood_constants *w, const wood_io *io, uint32_t from, uint32_t to) {
  wood_wants want = wants_of(w, io);
  block blocks[BLOCKS];
  for (uint32_t i = from; i < to;) {
    uint32_t count = 0;
    for (; count < BLOCKS && i < to; count++, i += LANES) {
      blocks[count].i = i;
      blocks[count].n = to - i < LANES ? to - i : LANES;
    }
    for (uint32_t k = 0; k < count; k++) stage_load(w, io, &blocks[k]);
    for (uint32_t k = 0; k < count; k++) stage_stem(w, io, &blocks[k]);
    if (want.section) {
      for (uint32_t k = 0; k < count; k++) stage_grain(w, io, &blocks[k]);
    }
    if (want.direction) {
      for (uint32_t k = 0; k < count; k++) stage_fibre(w, io, &want, &blocks[k]);
    }
    if (want.late) {
      for (uint32_t k = 0; k < count; k++) stage_rings(w, io, &blocks[k]);
    }
    if (want.vessel) {
      for (uint32_t k = 0; k < count; k++) stage_tissue(w, io, &want, &blocks[k]);
    }
    if (want.picture) {
      for (uint32_t k = 0; k < count; k++) stage_picture(w, io, &blocks[k]);
    }
    if (want.cone) {
      for (uint32_t k = 0; k < count; k++) stage_cone(w, io, &blocks[k]);
    }
    if (want.lobe) {
      for (uint32_t k = 0; k < count; k++) stage_figure(w, io, &want, &blocks[k]);
    }
  }
}

/* R(t, theta, y): rho of the year from the table, then the radius whose rho it
 * is, by Newton's method from above, where the field is all but linear. */
static void ring_radius(const wood_constants *w, uint32_t count, const float *t, const float *theta,
                        const float *y, float *out) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    vf years = clamp(finite_coordinate(load_lanes(t, i, n)), splat(0.0f), splat(1e5f));
    vf height = finite_coordinate(load_lanes(y, i, n));
    vf angle = load_lanes(theta, i, n);
    angle = sel(lt(vabs(angle), splat(1e4f)), angle, splat(0.0f));
    vf s, c, unused;
    sine_cosine(angle, &s, &c);
    vi whole;
    vf phase = years - vfloor(years, &whole);
    vi turns;
    vfloor(to_float(whole) * splat(1.0f / WOOD_RINGS), &turns);
    vi j = whole - turns * splati(WOOD_RINGS);
    vf rho = to_float(turns) * splat(w->ring_period) + gather(w->start, j) +
             phase / gather(w->inverse_width, j);
    stem_pith pith = pith_at(w, height);
    vf r = rho * (splat(1.0f) + outline_at(w, c, s, &unused));
    for (int k = 0; k < 8; k++) {
      stem_place p = stem_at(w, r * c + pith.x, height, r * s + pith.z, splat(0.0f));
      vf slope = vmax(p.rho_x * p.c + p.rho_z * p.s, splat(0.2f));
      r = vmax(r + (rho - p.rho) / slope, splat(0.0f));
    }
    for (uint32_t k = 0; k < n; k++) out[i + k] = lane(r, k);
  }
}

static void pith(const wood_constants *w, uint32_t count, const float *y, float *out_x,
                 float *out_z) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    stem_pith p = pith_at(w, finite_coordinate(load_lanes(y, i, n)));
    for (uint32_t k = 0; k < n; k++) {
      out_x[i + k] = lane(p.x, k);
      out_z[i + k] = lane(p.z, k);
    }
  }
}

const wood_kernel NAMED(wood_kernel_) = {STRING(SOZAI_ISA_NAME), LANES, evaluate, ring_radius,
                                         pith};
