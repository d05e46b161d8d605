/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood's evaluate: compiled once for each instruction set and width.
 */
#include "fibre.h"
#include "grain.h"
#include "vessels.h"

#define PASTE_(a, b) a##b
#define PASTE(a, b) PASTE_(a, b)
#define NAMED(name) PASTE(name, SOZAI_KERNEL_SUFFIX)
#define STRING_(a) #a
#define STRING(a) STRING_(a)

extern const wood_kernel NAMED(wood_kernel_);

/* Lanes past the end of the batch repeat the last point: they must not send
 * the others into a branch of their own. */
INLINE vf load_lanes(const float *p, uint32_t i, uint32_t n) {
  if (n == LANES) return load(p + i);
  if (n == 1) return splat(p[i]);
  vf r = splat(p[i + n - 1]);
  for (uint32_t k = 0; k + 1 < n; k++) r[k] = p[i + k];
  return r;
}

INLINE void store_lanes(const wood_io *io, int channel, uint32_t i, uint32_t n, vf x) {
  float *p = io->out[channel];
  if (!p) return;
  if (n == LANES && !io->active) {
    store(p + i, x);
    return;
  }
  for (uint32_t k = 0; k < n; k++) {
    if (!io->active || io->active[i + k]) p[i + k] = x[k];
  }
}

/* NaN to 0, and the rest within a kilometre. */
INLINE vf finite_coordinate(vf x) {
  x = sel(eq(x, x), x, splat(0.0f));
  return clamp(x, splat(-1e6f), splat(1e6f));
}

/* A direction of any length to a unit one; +z where it has none. */
INLINE void unit_direction(vf v[3]) {
  vf big = vmax(vmax(vabs(v[0]), vabs(v[1])), vabs(v[2]));
  /* NaN loses every comparison: a sum is NaN or infinite if any part is */
  vf all = vabs(v[0]) + vabs(v[1]) + vabs(v[2]);
  vm bad = not_(and_(gt(big, splat(1e-30f)), lt(all, splat(1e38f))));
  vf k = splat(1.0f) / sel(bad, splat(1.0f), big);
  for (int c = 0; c < 3; c++) v[c] = sel(bad, splat(c == 2 ? 1.0f : 0.0f), v[c] * k);
  vf l = splat(1.0f) / vsqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int c = 0; c < 3; c++) v[c] = v[c] * l;
}

INLINE void to_log(const wood_constants *w, const vf p[3], vf out[3]) {
  for (int c = 0; c < 3; c++) {
    out[c] = splat(w->turn[c][0]) * p[0] + splat(w->turn[c][1]) * p[1] +
             splat(w->turn[c][2]) * p[2];
  }
}

/* What has been asked for. */
typedef struct {
  int colour;   /* albedo or radiance */
  int radiance, late, vessel, fibre, dive, lobe, time, reference;
} wood_wants;

static int wanted(const wood_io *io, int first, int count) {
  for (int c = 0; c < count; c++) {
    if (io->out[first + c]) return 1;
  }
  return 0;
}

static wood_wants wants_of(const wood_io *io) {
  wood_wants q;
  q.radiance = wanted(io, WOOD_RADIANCE, 3);
  q.colour = wanted(io, WOOD_ALBEDO, 3) || q.radiance;
  q.late = wanted(io, WOOD_LATEWOOD, 1) || q.colour;
  q.vessel = wanted(io, WOOD_VESSEL, 1) || q.colour;
  q.fibre = wanted(io, WOOD_FIBER, 3);
  q.dive = wanted(io, WOOD_DIVE, 1);
  q.lobe = wanted(io, WOOD_SPECULAR, 2) || q.radiance;
  q.time = wanted(io, WOOD_TIME, 1);
  q.reference = wanted(io, WOOD_REFERENCE, 2);
  return q;
}

/* Average of the rings over a footprint that may be wide enough for their
 * curvature: the surface is followed across the grain through five nodes, and
 * between two nodes rho runs in a straight line. */
INLINE ring_means rings_across(const wood_constants *w, const stem_place *p, const ring_place *ring,
                               const vf g[3], const vf n[3], int ball, vf s) {
  footprint2 f = footprint_through(g, g, n, ball, s);
  vf e = vsqrt(f.aa + splat(12.0f) * p->lost);
  ring_means m = ring_average(w, ring, p->rho, e);
  if (ball) return m;

  /* across: the horizontal direction in the surface */
  vf flat2 = n[0] * n[0] + n[2] * n[2];
  vm end = lt(flat2, splat(0.09f)); /* end grain: along the radius */
  vf k = splat(1.0f) / vsqrt(vmax(flat2, splat(1e-6f)));
  vf ux = sel(end, p->c, n[2] * k), uz = sel(end, p->s, splat(0.0f) - n[0] * k);
  vf ur = ux * p->c + uz * p->s, ut2 = vmax(splat(1.0f) - ur * ur, splat(0.0f));
  vf sag = s * s * ut2 / (splat(8.0f) * p->r);
  vm curved = gt(sag, splat(0.08f * w->ring_width));
  if (!any(curved)) return m;

  vf slope = p->rho_x * ux + p->rho_z * uz; /* of rho along u */
  vf radial = p->rho_x * p->c + p->rho_z * p->s;
  vf linear = slope - radial * ur;
  /* what is not along u widens every part */
  vf gn = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
  vf all = vmax(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] - gn * gn, splat(0.0f));
  vf side = vmax(all - slope * slope, splat(0.0f)) * s * s + splat(12.0f) * p->lost;
  vf widen = vsqrt(side + sag * sag * splat(0.01f));
  vf sum_late = splat(0.0f), sum_pore = sum_late, sum_row = sum_late, before = sum_late;
  for (int i = 0; i <= 4; i++) {
    vf a = s * splat(0.25f * (float)i - 0.5f);
    vf r = vsqrt(vmax(p->r * p->r + splat(2.0f) * p->r * ur * a + a * a, splat(1e-12f)));
    vf rho = vmax(p->rho + (r - p->r) * radial + linear * a, splat(0.0f));
    if (i) {
      vf middle = splat(0.5f) * (rho + before), span = rho - before;
      ring_place at = ring_at(w, middle);
      ring_means part = ring_average(w, &at, middle, vsqrt(span * span + widen * widen));
      sum_late = sum_late + part.late;
      sum_pore = sum_pore + part.pore;
      sum_row = sum_row + part.row;
    }
    before = rho;
  }
  m.late = sel(curved, sum_late * splat(0.25f), m.late);
  m.pore = sel(curved, sum_pore * splat(0.25f), m.pore);
  m.row = sel(curved, sum_row * splat(0.25f), m.row);
  return m;
}

/* One block of LANES points, or fewer. */
INLINE void evaluate_block(const wood_constants *w, const wood_io *io, const wood_wants *want,
                           uint32_t i, uint32_t n) {
  vf zero = splat(0.0f), one = splat(1.0f);

  /* ---- inputs, to log space */
  vf p[3], q[3];
  for (int c = 0; c < 3; c++) p[c] = finite_coordinate(load_lanes(io->point[c], i, n));
  to_log(w, p, q);
  for (int c = 0; c < 3; c++) q[c] = q[c] + splat(w->shift[c]);
  vf s = zero;
  if (io->footprint) s = clamp(load_lanes(io->footprint, i, n), zero, splat(1e4f));
  int ball = !io->normal[0];
  vf normal[3] = {zero, zero, one}, nrm[3];
  if (!ball) {
    for (int c = 0; c < 3; c++) normal[c] = load_lanes(io->normal[c], i, n);
    unit_direction(normal);
  }
  to_log(w, normal, nrm);

  /* ---- ring and grain */
  stem_place stem = stem_at(w, q[0], q[1], q[2], s);
  ring_place ring = ring_at(w, stem.rho);
  vf years = to_float(ring.ring) + ring.phase;
  if (want->time) store_lanes(io, WOOD_TIME, i, n, years);
  vf up2 = ball ? one : vmax(one - nrm[1] * nrm[1], zero);
  grain_place grain = grain_at(w, q[1], years, s * vsqrt(up2));
  vf divisor = one / grain_radius(stem.rho);

  /* ---- the reference section */
  vf phase = grain.d * divisor, turn_s, turn_c;
  sine_cosine(phase, &turn_s, &turn_c);
  vf c = stem.c * turn_c + stem.s * turn_s, sn = stem.s * turn_c - stem.c * turn_s;
  vf unused, radius = stem.rho * (one + outline_at(w, c, sn, &unused));
  vf x = radius * c, z = radius * sn;
  if (want->reference) {
    store_lanes(io, WOOD_REFERENCE, i, n, x);
    store_lanes(io, WOOD_REFERENCE + 1, i, n, z);
  }

  /* ---- fibre direction: theta' and rho constant along it */
  vf f[3], sine = zero;
  if (want->fibre || want->dive || want->lobe) {
    vf omega = grain.g_filtered * divisor;
    vf rho_r = stem.rho_x * stem.c + stem.rho_z * stem.s;
    vf rho_t = stem.r * (stem.rho_z * stem.c - stem.rho_x * stem.s);
    vf climb = (zero - stem.rho_y - rho_t * omega) / vmax(rho_r, splat(0.05f));
    vf around = stem.r * omega;
    f[0] = climb * stem.c - around * stem.s + stem.pith.dx;
    f[1] = one;
    f[2] = climb * stem.s + around * stem.c + stem.pith.dz;
    vf l = one / vsqrt(f[0] * f[0] + one + f[2] * f[2]);
    for (int k = 0; k < 3; k++) f[k] = f[k] * l;
    sine = zero - (f[0] * nrm[0] + f[1] * nrm[1] + f[2] * nrm[2]);
    if (want->fibre) {
      for (int k = 0; k < 3; k++) {
        store_lanes(io, WOOD_FIBER + k, i, n,
                    splat(w->turn[0][k]) * f[0] + splat(w->turn[1][k]) * f[1] +
                        splat(w->turn[2][k]) * f[2]);
      }
    }
    if (want->dive) store_lanes(io, WOOD_DIVE, i, n, arcsin(sine));
  }

  vf albedo[3] = {zero, zero, zero};
  if (want->late || want->vessel) {
    /* ---- how the surface maps to (arc, rho): rows of the derivative */
    vf b[3] = {stem.rho_x, stem.rho_y - stem.rho_x * stem.pith.dx - stem.rho_z * stem.pith.dz,
               stem.rho_z};
    ring_means rings = rings_across(w, &stem, &ring, b, nrm, ball, s);
    vf late = rings.late, cover = zero, over_late = zero;
    if (want->late) store_lanes(io, WOOD_LATEWOOD, i, n, late);
    if (want->vessel) {
      vf k = stem.rho / stem.r;
      vf phi_rho = (grain.d_t * ring.inverse_width - phase * stem.rho * divisor) * divisor;
      vf shear = stem.rho * phi_rho, g = stem.rho * grain.g * divisor;
      vf tx = zero - k * stem.s, tz = k * stem.c;
      vf a[3] = {tx - shear * b[0], zero - tx * stem.pith.dx - tz * stem.pith.dz - g - shear * b[1],
                 tz - shear * b[2]};
      vessel_place place = {x, z, c, sn, stem.rho, ring, footprint_through(a, b, nrm, ball, s)};
      vessel_cover_t v = vessels_at(w, &place);
      vf expected_pores = splat(w->pores.coverage) * rings.pore;
      vf expected_rows = splat(w->row.coverage) * rings.row;
      vf pores = mix(v.pores, expected_pores, v.pores_faded);
      vf rows = mix(v.rows, expected_rows, v.rows_faded);
      cover = vmin(pores + rows, one);
      /* earlywood rows stand where there is no latewood; pores everywhere */
      over_late = vmin(mix(v.pores, splat(w->late_vessel), v.pores_faded), one);
      late = late * (one - over_late);
      store_lanes(io, WOOD_VESSEL, i, n, cover);
      if (want->colour) {
        vf shift = one + fibre_shift(w, x, z, vsqrt(place.f.aa + place.f.bb));
        vf early = vmax(one - cover - late, zero) * shift, dark = late * shift;
        for (int ch = 0; ch < 3; ch++) {
          albedo[ch] = splat(w->early[ch]) * early + splat(w->late[ch]) * dark +
                       splat(w->vessel[ch]) * cover;
          store_lanes(io, WOOD_ALBEDO + ch, i, n, albedo[ch]);
        }
      }
    }
  }

  if (want->lobe) {
    /* ---- figure, Kawai's equation (4): the lobe's normal dives with the fibre;
     * slopes that the footprint averages widen it instead */
    vf across = ball ? zero : nrm[2] * stem.c - nrm[0] * stem.s;
    vf variance = grain.variance * across * across;
    vf wide = one / (one + splat(w->shininess) * variance);
    vf exponent = splat(w->shininess) * wide, strength = splat(w->specular) * vsqrt(wide);
    store_lanes(io, WOOD_SPECULAR, i, n, strength);
    store_lanes(io, WOOD_ROUGHNESS, i, n, vmin(vsqrt(splat(2.0f) / (exponent + splat(2.0f))), one));
    if (want->radiance) {
      vf light[3];
      for (int k = 0; k < 3; k++) light[k] = load_lanes(io->light[k], i, n);
      unit_direction(light);
      vf incident = light[0] * normal[0] + light[1] * normal[1] + light[2] * normal[2];
      vf l[3];
      to_log(w, light, l);
      /* up the stem within the surface */
      vf inverse = one / vsqrt(vmax(up2, splat(1e-12f)));
      vf rise = (l[1] - nrm[1] * incident) * inverse;
      rise = sel(gt(up2, splat(1e-6f)), rise, zero);
      vf cosine = vsqrt(vmax(one - sine * sine, zero));
      vf tilted = clamp01(incident * cosine + rise * sine);
      vf gloss = strength * power01(tilted, exponent);
      vf diffuse = splat(w->diffuse) * vmax(incident, zero);
      for (int ch = 0; ch < 3; ch++) {
        vf r = diffuse * albedo[ch] + gloss * splat(w->tint_colour[ch]);
        if (io->light_colour[ch]) {
          vf e = load_lanes(io->light_colour[ch], i, n);
          e = sel(lt(vabs(e), splat(1e30f)), e, zero);
          r = r * e;
        }
        store_lanes(io, WOOD_RADIANCE + ch, i, n, r);
      }
    }
  }
}

static void evaluate(const wood_constants *w, const wood_io *io, uint32_t from, uint32_t to) {
  wood_wants want = wants_of(io);
  for (uint32_t i = from; i < to; i += LANES) {
    uint32_t n = to - i < LANES ? to - i : LANES;
    evaluate_block(w, io, &want, i, n);
  }
}

/* R(t, theta, y): rho of the year from the table, then the radius whose rho it
 * is, by Newton's method from above, where the field is all but linear. */
static void ring_radius(const wood_constants *w, uint32_t count, const float *t,
                        const float *theta, const float *y, float *out) {
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
    for (uint32_t k = 0; k < n; k++) out[i + k] = r[k];
  }
}

static void pith(const wood_constants *w, uint32_t count, const float *y, float *out_x,
                 float *out_z) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    stem_pith p = pith_at(w, finite_coordinate(load_lanes(y, i, n)));
    for (uint32_t k = 0; k < n; k++) {
      out_x[i + k] = p.x[k];
      out_z[i + k] = p.z[k];
    }
  }
}

const wood_kernel NAMED(wood_kernel_) = {STRING(SOZAI_ISA_NAME), LANES, evaluate, ring_radius, pith};
