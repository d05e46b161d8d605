// SPDX-License-Identifier: Apache-2.0
//
// The chromaticities of a space, from what the config's interchange roles make of
// its red, green, blue and white.
//
// A config adapts every space's white to that of the interchange space, so that
// white goes to white: which white it was is not in the numbers, and for each
// white there is one set of primaries that would give them. So the white is
// recognised by its primaries: of the spaces that are in use, the one whose
// primaries come out right under its own white. Primaries of no known space are
// given as they look when adapted to D65. The adaptation is undone by Bradford's
// matrix, which OpenColorIO's builtin transforms and the ACES configs use.
#include "chromaticities.hpp"

#include "boundary.hpp"
#include "linear.hpp"

#include <cmath>

namespace sozai::colour {
namespace {

struct xy {
  double x, y;
};
using Colour = std::array<double, 3>;

struct Standard {
  xy red, green, blue, white;
};

constexpr xy d65 = {0.3127, 0.3290}, aces_white = {0.32168, 0.33767}, dci_white = {0.314, 0.351},
             d50 = {0.3457, 0.3585};

// SMPTE ST 2065-1.
constexpr Standard ap0 = {{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, aces_white};

// What is in use, with the standard that says so.
constexpr Standard standards[] = {
    {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65},              // ITU-R BT.709, sRGB
    {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65},        // ITU-R BT.2020
    {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65},        // SMPTE EG 432-1, P3-D65
    {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, dci_white},  // SMPTE RP 431-2, P3-DCI
    {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, aces_white}, // P3-D60, of ACES outputs
    {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, aces_white}, // AMPAS S-2014-004, AP1
    ap0,                                                          // SMPTE ST 2065-1, AP0
    {{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, d65},              // Adobe RGB (1998)
    {{0.734699, 0.265301},
     {0.159597, 0.840403},
     {0.036598, 0.000105}, // ISO 22028-2, ROMM RGB
     d50},
};
// Rounded matrices move primaries less, as CAT02 in place of Bradford does AP1's, and
// other spaces are farther off.
constexpr double close_enough = 4e-3;

constexpr Matrix bradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

Colour operator*(const Matrix &m, const Colour &v) {
  Colour out;
  for (size_t i = 0; i < 3; i++) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

Matrix operator*(const Matrix &a, const Matrix &b) {
  Matrix out;
  for (size_t i = 0; i < 3; i++)
    for (size_t j = 0; j < 3; j++)
      out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return out;
}

Matrix diagonal(const Colour &d) { return {{{d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]}}}; }

Matrix inverse(const Matrix &m) {
  Matrix out;
  for (size_t i = 0; i < 3; i++)
    for (size_t j = 0; j < 3; j++) {
      const size_t p = (j + 1) % 3, q = (j + 2) % 3, r = (i + 1) % 3, s = (i + 2) % 3;
      out[i][j] = m[p][r] * m[q][s] - m[p][s] * m[q][r];
    }
  const double determinant = m[0][0] * out[0][0] + m[0][1] * out[1][0] + m[0][2] * out[2][0];
  for (auto &row : out)
    for (double &element : row) element /= determinant;
  return out;
}

Colour xyz_of(xy c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

xy xy_of(const Colour &xyz) {
  const double sum = xyz[0] + xyz[1] + xyz[2];
  return {xyz[0] / sum, xyz[1] / sum};
}

// Linear light to XYZ, white at Y = 1.
Matrix to_xyz(const Standard &s) {
  Matrix corners;
  const xy primaries[] = {s.red, s.green, s.blue};
  for (size_t j = 0; j < 3; j++) {
    corners[0][j] = primaries[j].x;
    corners[1][j] = primaries[j].y;
    corners[2][j] = 1 - primaries[j].x - primaries[j].y;
  }
  return corners * diagonal(inverse(corners) * xyz_of(s.white));
}

Matrix adaptation(xy from, xy to) {
  const Colour a = bradford * xyz_of(from), b = bradford * xyz_of(to);
  return inverse(bradford) * diagonal({b[0] / a[0], b[1] / a[1], b[2] / a[2]}) * bradford;
}

std::array<xy, 4> corners_of(const Matrix &m) {
  return {xy_of(m * Colour{1, 0, 0}), xy_of(m * Colour{0, 1, 0}), xy_of(m * Colour{0, 0, 1}),
          xy_of(m * Colour{1, 1, 1})};
}

double distance(const std::array<xy, 4> &c, const Standard &s) {
  const xy want[] = {s.red, s.green, s.blue, s.white};
  double furthest = 0;
  for (size_t i = 0; i < 4; i++)
    furthest = std::fmax(furthest, std::hypot(c[i].x - want[i].x, c[i].y - want[i].y));
  return furthest;
}

// to_d65: from linear light to XYZ adapted to D65.
std::array<xy, 4> recognised(const Matrix &to_d65) {
  std::array<xy, 4> best = corners_of(to_d65);
  double nearest = close_enough;
  for (const auto &standard : standards) {
    const auto corners = corners_of(adaptation(d65, standard.white) * to_d65);
    const double off = distance(corners, standard);
    if (!(off < nearest)) continue;
    nearest = off;
    best = corners;
  }
  return best;
}

} // namespace

void find_chromaticities(const Config &config, Processors &processors, const char *space,
                         float out_xy[8]) {
  const std::string name = space ? space : config.working;
  const auto known = config.ocio->getColorSpace(name.c_str());
  if (!known)
    throw Failure(SOZAI_ERROR_COLOUR,
                  "no colour space \"" + name + "\" in colour config " + config.name);
  const std::string what = "colour space \"" + name + "\" of colour config " + config.name;
  if (known->isData()) throw Failure(SOZAI_ERROR_COLOUR, what + " is data, not colours");

  // The one of its own side first: the other is reached through a view transform.
  const char *aces = ocio::ROLE_INTERCHANGE_SCENE, *xyz = ocio::ROLE_INTERCHANGE_DISPLAY;
  const bool display = known->getReferenceSpaceType() == ocio::REFERENCE_SPACE_DISPLAY;
  const char *role = display ? xyz : aces;
  if (!config.ocio->hasRole(role)) role = display ? aces : xyz;
  if (!config.ocio->hasRole(role))
    throw Failure(SOZAI_ERROR_COLOUR, "colour config " + config.name +
                                          " has neither of the roles " + aces + " and " + xyz +
                                          ", so that it does not say what its primaries are");

  const auto matrix = matrix_of(*processors.between(name.c_str(), role));
  if (!matrix) throw Failure(SOZAI_ERROR_COLOUR, what + " is not linear light");
  const Matrix to_d65 =
      role == aces ? adaptation(aces_white, d65) * to_xyz(ap0) * *matrix : *matrix;
  const auto corners = recognised(to_d65);
  for (const auto &corner : corners)
    if (!(std::isfinite(corner.x) && std::isfinite(corner.y)))
      throw Failure(SOZAI_ERROR_COLOUR, what + " has no primaries");
  for (size_t i = 0; i < 4; i++) {
    out_xy[2 * i] = static_cast<float>(corners[i].x);
    out_xy[2 * i + 1] = static_cast<float>(corners[i].y);
  }
}

} // namespace sozai::colour
