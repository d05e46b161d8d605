/* SPDX-License-Identifier: Apache-2.0 */
#include "fiber_lobe.h"

#include <math.h>

#define PI 3.14159265f

fiber_lobe fiber_lobe_make(float roughness, float round, float tilt, float index) {
  fiber_lobe l = {.index = index};
  float s = roughness * PI / 180, v = s * s;
  const float variance[LOBES] = {v, v / 4, 4 * v, 4 * v};
  for (int p = 0; p < LOBES; p++) l.variance[p] = variance[p];
  float b = fmaxf(round, 0.05f);
  l.spread = 0.626657069f * (0.265f * b + 1.194f * b * b + 5.372f * powf(b, 22));
  float a = tilt * PI / 180;
  for (int k = 0; k < 3; k++, a *= 2) l.sine[k] = sinf(a), l.cosine[k] = cosf(a);
  return l;
}

vec fiber_lobe_absorption(vec c, float b) {
  float fit = 5.969f - 0.215f * b + 2.532f * b * b - 10.73f * powf(b, 3) + 5.574f * powf(b, 4) +
              0.245f * powf(b, 5);
  float in[3] = {c.x, c.y, c.z}, out[3];
  for (int k = 0; k < 3; k++) {
    float s = logf(fminf(fmaxf(in[k], 1e-3f), 0.999f)) / fit;
    out[k] = s * s;
  }
  return (vec){out[0], out[1], out[2]};
}

/* ---- along the fibre --------------------------------------------------- */

static float log_bessel(float x) {
  if (x > 12) return x + 0.5f * (-logf(2 * PI * x) + 1 / (8 * x));
  float sum = 1, term = 1, z = 0.25f * x * x;
  for (int k = 1; k < 24; k++) {
    term *= z / (float)(k * k);
    if (term < 2.9e-8f * sum) break; /* below half a rounding, and so are those after it */
    sum += term;
  }
  return logf(sum);
}

static float along(float sine_i, float cosine_i, float sine_o, float cosine_o, float v) {
  float a = cosine_i * cosine_o / v, b = sine_i * sine_o / v;
  float log = log_bessel(a) - b - 1 / v + 0.6931472f + logf(1 / (2 * v));
  if (v > 0.1f) return expf(log_bessel(a) - b) / (sinhf(1 / v) * 2 * v);
  return expf(log);
}

/* ---- around it --------------------------------------------------------- */

static float logistic_share(float x, float s) { return 1 / (1 + expf(-x / s)); }

/* Cut to a full turn, and of integral 1 over it. */
static float around(float x, float s) {
  while (x > PI) x -= 2 * PI;
  while (x < -PI) x += 2 * PI;
  float e = expf(-fabsf(x) / s);
  return e / (s * (1 + e) * (1 + e)) / (logistic_share(PI, s) - logistic_share(-PI, s));
}

static float around_sample(float u, float s) {
  float low = logistic_share(-PI, s), k = logistic_share(PI, s) - low;
  float x = -s * logf(1 / fminf(fmaxf(u * k + low, 1e-6f), 1 - 1e-6f) - 1);
  return fminf(fmaxf(x, -PI), PI);
}

/* ---- what goes where --------------------------------------------------- */

static float fresnel(float cosine, float index) {
  float s = sqrtf(fmaxf(0, 1 - cosine * cosine)) / index, t = sqrtf(fmaxf(0, 1 - s * s));
  float a = (index * cosine - t) / (index * cosine + t),
        b = (cosine - index * t) / (cosine + index * t);
  return 0.5f * (a * a + b * b);
}

static float mean_of(vec v) { return (v.x + v.y + v.z) / 3; }
static vec each_exp(vec v) { return (vec){expf(v.x), expf(v.y), expf(v.z)}; }

static void attenuate(const fiber_lobe *l, fiber_view_from *f, vec absorption) {
  float sine_t = f->sine / l->index, cosine_t = sqrtf(fmaxf(1e-6f, 1 - sine_t * sine_t));
  float bent =
      sqrtf(fmaxf(1e-6f, l->index * l->index - f->sine * f->sine)) / fmaxf(f->cosine, 1e-4f);
  float g = f->h / bent, cosine_g = sqrtf(fmaxf(0, 1 - g * g)),
        gamma_t = asinf(fminf(fmaxf(g, -1), 1));
  vec t = each_exp(vec_scale(-2 * cosine_g / cosine_t, absorption));
  float r = fresnel(f->cosine * sqrtf(fmaxf(0, 1 - f->h * f->h)), l->index), sum = 0;
  f->attenuation[0] = (vec){r, r, r};
  f->attenuation[1] = vec_scale((1 - r) * (1 - r), t);
  f->attenuation[2] = vec_scale(r, vec_mul(f->attenuation[1], t));
  vec last = vec_scale(r, vec_mul(f->attenuation[2], t));
  f->attenuation[3] = (vec){last.x / (1 - r * t.x), last.y / (1 - r * t.y), last.z / (1 - r * t.z)};
  for (int p = 0; p < LOBES; p++) {
    f->share[p] = mean_of(f->attenuation[p]) + 1e-5f;
    sum += f->share[p];
    f->turn[p] = 2 * (float)p * gamma_t - 2 * f->gamma + (float)p * PI;
  }
  for (int p = 0; p < LOBES; p++) f->share[p] /= sum;
}

/* The scales turn each lobe out of the mirror's direction by its own angle. */
static void tilt(const fiber_lobe *l, fiber_view_from *f) {
  const int which[LOBES] = {1, 0, 2, 0};
  const float way[LOBES] = {1, -1, -1, 0};
  for (int p = 0; p < LOBES; p++) {
    float s = way[p] * l->sine[which[p]], c = way[p] != 0 ? l->cosine[which[p]] : 1;
    f->up_sine[p] = f->sine * c - f->cosine * s;
    f->up_cosine[p] = fabsf(f->cosine * c + f->sine * s);
  }
}

fiber_view_from fiber_lobe_from(const fiber_lobe *l, vec tangent, vec normal, vec eye,
                                vec absorption) {
  fiber_view_from f = {.tangent = tangent};
  f.sine = fminf(fmaxf(vec_dot(eye, tangent), -1), 1);
  f.cosine = sqrtf(fmaxf(0, 1 - f.sine * f.sine));
  vec flat = vec_along(eye, -f.sine, tangent);
  f.across = vec_length(flat) > 1e-5f ? vec_unit(flat) : normal;
  f.up = vec_cross(tangent, f.across);
  f.h = fminf(fmaxf(-vec_dot(normal, f.up), -0.999f), 0.999f);
  f.gamma = asinf(f.h);
  attenuate(l, &f, absorption);
  tilt(l, &f);
  return f;
}

static vec value_at(const fiber_lobe *l, const fiber_view_from *f, float sine_i, float cosine_i,
                    float phi, float *density) {
  vec sum = {0, 0, 0};
  *density = 0;
  for (int p = 0; p < LOBES; p++) {
    float m = along(sine_i, cosine_i, f->up_sine[p], f->up_cosine[p], l->variance[p]);
    float n = p < 3 ? around(phi - f->turn[p], l->spread) : 1 / (2 * PI);
    sum = vec_along(sum, m * n, f->attenuation[p]);
    *density += f->share[p] * m * n;
  }
  return sum;
}

vec fiber_lobe_value(const fiber_lobe *l, const fiber_view_from *f, vec light) {
  float s = fminf(fmaxf(vec_dot(light, f->tangent), -1), 1), c = sqrtf(fmaxf(0, 1 - s * s)),
        density;
  float phi = atan2f(vec_dot(light, f->up), vec_dot(light, f->across));
  return value_at(l, f, s, c, phi, &density);
}

vec fiber_lobe_sample(const fiber_lobe *l, const fiber_view_from *f, const float u[4],
                      vec *weight) {
  int p = 0;
  float left = u[0];
  while (p < LOBES - 1 && left >= f->share[p]) left -= f->share[p++];
  float v = l->variance[p];
  float c = 1 + v * logf(fmaxf(u[1], 1e-5f) + (1 - fmaxf(u[1], 1e-5f)) * expf(-2 / v));
  float s = sqrtf(fmaxf(0, 1 - c * c));
  float sine_i = -c * f->up_sine[p] + s * cosf(2 * PI * u[2]) * f->up_cosine[p];
  sine_i = fminf(fmaxf(sine_i, -1), 1);
  float cosine_i = sqrtf(fmaxf(0, 1 - sine_i * sine_i)), density;
  float phi = p < 3 ? f->turn[p] + around_sample(u[3], l->spread) : 2 * PI * u[3];
  vec value = value_at(l, f, sine_i, cosine_i, phi, &density);
  *weight = density > 1e-8f ? vec_scale(1 / density, value) : (vec){0, 0, 0};
  vec d = vec_scale(sine_i, f->tangent);
  d = vec_along(d, cosine_i * cosf(phi), f->across);
  return vec_unit(vec_along(d, cosine_i * sinf(phi), f->up));
}
