/* SPDX-License-Identifier: Apache-2.0
 * OSL's types, globals and functions as C++ knows them, as far as the shaders of
 * hosts/osl use them, from the OSL 1.12 language specification. Declarations
 * alone: the shaders are looked at, not run. */
#ifndef SOZAI_OSL_AS_CXX_H
#define SOZAI_OSL_AS_CXX_H

struct string {
  string(const char *text);
};
int operator==(const string &a, const string &b);
int operator!=(const string &a, const string &b);
string concat(const string &a, const string &b, const string &c);
string substr(const string &s, int start, int length);
string substr(const string &s, int start);
int regex_search(const string &subject, int (&results)[2], const string &regex);

/* Triples differ in type, and convert only where they are told to. */
template <int Kind> struct triple {
  triple();
  triple(float all);
  triple(float x, float y, float z);
  template <int Other> explicit triple(const triple<Other> &t);
  float &operator[](int i);
  float operator[](int i) const;
  triple &operator+=(const triple<1> &t);
};
typedef triple<0> color;
typedef triple<1> vector;
typedef triple<2> normal;
typedef triple<3> point;

template <int K> triple<K> operator*(const triple<K> &a, const triple<K> &b);
template <int K> triple<K> operator*(const triple<K> &a, float b);
template <int K> triple<K> operator*(float a, const triple<K> &b);
template <int K> triple<K> operator+(const triple<K> &a, const triple<K> &b);
template <int K> triple<K> operator-(const triple<K> &a, const triple<K> &b);
template <int K> triple<K> operator-(float a, const triple<K> &b);
/* vectors and normals mix */
vector operator+(const vector &a, const normal &b);
vector operator-(const vector &a, const normal &b);
vector operator-(const normal &a, const vector &b);
float dot(const vector &a, const vector &b);
float dot(const vector &a, const normal &b);
float dot(const normal &a, const vector &b);
vector cross(const vector &a, const vector &b);
vector cross(const normal &a, const vector &b);
vector normalize(const vector &v);
vector normalize(const normal &v);
float length(const vector &v);
color min(const color &a, const color &b);
float max(float a, float b);
float smoothstep(float low, float high, float x);
float clamp(float x, float low, float high);
vector transform(const string &from, const string &to, const vector &v);
vector calculatenormal(const point &p);

extern float u, v;
extern point P;
extern normal N;
extern vector dPdu, dPdv;

struct texel {
  operator color() const;
  operator float() const;
};
template <class... Options>
texel texture(const string &file, float s, float t, const Options &...options);

struct closure_color {
  closure_color(int zero = 0);
};
closure_color operator+(const closure_color &a, const closure_color &b);
closure_color operator*(const color &a, const closure_color &b);
closure_color operator*(float a, const closure_color &b);
closure_color oren_nayar_diffuse_bsdf(const normal &n, const color &albedo, float roughness);
closure_color dielectric_bsdf(const normal &n, const vector &u, const color &reflection,
                              const color &transmission, float roughness_x, float roughness_y,
                              float ior, const string &distribution);
closure_color generalized_schlick_bsdf(const normal &n, const vector &u, const color &reflection,
                                       const color &transmission, float roughness_x,
                                       float roughness_y, const color &f0, const color &f90,
                                       float exponent, const string &distribution);
closure_color layer(const closure_color &top, const closure_color &base);
extern closure_color Ci;

#endif
