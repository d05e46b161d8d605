// SPDX-License-Identifier: Apache-2.0
// What sozai's shaders share. OSL 1.12 and later.
//
// file is a .sozai file, whose outputs are subimages of their channels' names,
// or a name with <output> in it, for files that were baked one by one. Or all
// outputs lie in one subimage, of a .sozai file or an EXR baked of it: channel
// is then the first of the output's, else -1.
#ifndef SOZAI_OSL_H
#define SOZAI_OSL_H

string sozai_file(string file, string output_name) {
  int found[2];
  if (regex_search(file, found, "<output>"))
    return concat(substr(file, 0, found[0]), output_name, substr(file, found[1]));
  return file;
}

// As the shader's own (s, t) says; t runs upwards, as in sozai's pictures.
color sozai_colour(string file, string output_name, int channel, float s, float t, string wrap) {
  if (channel >= 0) return (color)texture(file, s, 1 - t, "wrap", wrap, "firstchannel", channel);
  string name = sozai_file(file, output_name);
  if (name != file) return (color)texture(name, s, 1 - t, "wrap", wrap);
  return (color)texture(name, s, 1 - t, "wrap", wrap, "subimage", output_name);
}

float sozai_number(string file, string output_name, int channel, float s, float t, string wrap) {
  if (channel >= 0) return (float)texture(file, s, 1 - t, "wrap", wrap, "firstchannel", channel);
  string name = sozai_file(file, output_name);
  if (name != file) return (float)texture(name, s, 1 - t, "wrap", wrap);
  return (float)texture(name, s, 1 - t, "wrap", wrap, "subimage", output_name);
}

// A direction of the texture's axes (x along s, y along t, z out of the surface
// for a plane; the object's own for an unwrapped mesh), as the renderer has it,
// unit. fallback where there is none.
vector sozai_turned(vector d, int unwrapped, vector fallback) {
  if (length(d) < 0.01) return fallback;
  if (unwrapped) return normalize(transform("object", "common", d));
  vector along = normalize(dPdu - dot(dPdu, N) * N);
  return normalize(d[0] * along + d[1] * normalize(cross(N, along)) + d[2] * N);
}

vector sozai_direction(string file, string output_name, int channel, float s, float t, string wrap,
                       int unwrapped, vector fallback) {
  return sozai_turned((vector)sozai_colour(file, output_name, channel, s, t, wrap), unwrapped,
                      fallback);
}

// Fibres below a surface reflect on a cone about their axis. In its place: a
// microfacet lobe about the normal that is square to the fibre, narrow along it
// and wide across. Seen through the surface a fibre dives more steeply than it
// does. tests/osl/lobe.py fits the three numbers and says how near this comes.
closure color sozai_fibres(vector fibre, normal n, color tint, float width, float ior) {
  vector seen = normalize(fibre + (ior - 1) * dot(fibre, n) * n);
  vector level = n - dot(n, seen) * seen;
  // end grain shows no cone, and has no such normal
  float fade = smoothstep(0.2, 0.7, length(level));
  if (fade <= 0) return 0;
  float along = clamp(0.8 * ior * width, 0.001, 1.0);
  float across = max(0.8, along);
  color white = 1;
  return fade * 3.4 * tint *
         generalized_schlick_bsdf((normal)normalize(level), seen, white, color(0), along, across,
                                  white, white, 5.0, "ggx");
}

#endif
