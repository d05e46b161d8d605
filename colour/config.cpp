// SPDX-License-Identifier: Apache-2.0
//
// Which config, and whether it is fit for use.
#include "config.hpp"

#include "aliases.hpp"
#include "boundary.hpp"
#include "cpu.hpp"
#include "linear.hpp"
#include "quiet.hpp"
#include "references.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace sozai::colour {

static std::string choose(const char *path) {
  if (path) return path;
  const char *environment = std::getenv("OCIO");
  if (environment && *environment) return environment;
  const char *shipped = sozai_colour_shipped_config();
  if (!shipped) throw Failure(SOZAI_ERROR_STATE, "sozai-colour: open called before init");
  return shipped;
}

// Whether it is the name of a config built into OpenColorIO. The library's version
// counts, not that of the header.
static bool is_built_in(const std::string &path) {
  if (path.rfind("ocio://", 0) != 0) return false;
  if (ocio::GetVersionHex() >= 0x02020000) return true;
  throw Failure(SOZAI_ERROR_FILE, "colour config " + path +
                                      ": configs built into OpenColorIO need its version 2.2, and "
                                      "this is " +
                                      ocio::GetVersion());
}

// OpenColorIO says only that it could not read; the system knows why.
static void must_be_readable(const std::string &path) {
  struct stat status;
  std::string reason;
  if (stat(path.c_str(), &status) != 0 || access(path.c_str(), R_OK) != 0)
    reason = std::strerror(errno);
  else if (S_ISDIR(status.st_mode))
    reason = std::strerror(EISDIR);
  else if (!S_ISREG(status.st_mode))
    reason = "not a file"; // a device or a pipe may never come to its end
  if (reason.empty()) return;
  throw Failure(SOZAI_ERROR_FILE, "colour config " + path + ": " + reason);
}

static void must_not_repeat_itself(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.rfind("PK\3\4", 0) == 0) return; // an archive, of OpenColorIO 2.2 and later
  const std::string alias = circular_alias(text);
  if (!alias.empty())
    throw Failure(SOZAI_ERROR_FILE,
                  "colour config " + path + ": the YAML alias *" + alias + " is a part of itself");
}

// Some builds of OpenColorIO read numbers by the C++ global locale, which belongs to
// the host: 0.125 may be refused, or taken for 125. Rather none than wrong colours.
static void must_read_numbers(const std::string &path) {
  if (std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == '.') return;
  double read[3] = {};
  try {
    std::istringstream probe("ocio_profile_version: 1\n"
                             "luma: [0.125, 0.125, 0.125]\n"
                             "roles: {default: raw}\n"
                             "colorspaces: [!<ColorSpace> {name: raw}]\n");
    ocio::Config::CreateFromStream(probe)->getDefaultLumaCoefs(read);
  } catch (const ocio::Exception &) {
  }
  if (read[0] == 0.125) return;
  throw Failure(SOZAI_ERROR_COLOUR, "colour config " + path +
                                        ": OpenColorIO misreads numbers under the C++ global " +
                                        "locale \"" + std::locale().name() + "\"");
}

// Run body; what it throws becomes a Failure that names the config.
template <class Body>
static void naming(const std::string &path, int32_t result, const Body &body) {
  try {
    body();
  } catch (const Failure &failure) {
    throw Failure(failure.result, "colour config " + path + ": " + failure.what());
  } catch (const std::bad_alloc &) {
    throw;
  } catch (const std::exception &error) {
    throw Failure(result, "colour config " + path + ": " + error.what());
  }
}

// Data, or linear light as far as its numbers tell.
static bool can_be_worked_in(const ocio::Config &config, const ocio::ColorSpace &space) {
  if (space.isData()) return true;
  auto transform = space.getTransform(ocio::COLORSPACE_DIR_TO_REFERENCE);
  if (!transform) transform = space.getTransform(ocio::COLORSPACE_DIR_FROM_REFERENCE);
  if (!transform) return true; // it is the reference
  try {
    return matrix_of(*cpu_of(config.getProcessor(transform))).has_value();
  } catch (const ocio::Exception &) {
    return false; // a missing table, say
  }
}

static void choose_working_space(Config &config) {
  const ocio::Config &all = *config.ocio;
  const char *role = nullptr;
  if (all.hasRole(ocio::ROLE_SCENE_LINEAR) && all.getColorSpace(ocio::ROLE_SCENE_LINEAR))
    role = ocio::ROLE_SCENE_LINEAR;
  // What is made of a config without it, in this order. A space that only bears a
  // role's name does not do.
  for (const char *other : {ocio::ROLE_RENDERING, ocio::ROLE_REFERENCE, ocio::ROLE_DEFAULT}) {
    if (role) break;
    const auto space = all.hasRole(other) ? all.getColorSpace(other) : nullptr;
    if (space && can_be_worked_in(all, *space)) role = other;
  }
  if (!role)
    throw Failure(SOZAI_ERROR_COLOUR, "it has no role scene_linear, and none of its roles "
                                      "rendering, reference and default is linear light or data");
  const auto space = all.getColorSpace(role);
  config.working = space->getName();
  config.raw = space->isData();
  if (std::strcmp(role, ocio::ROLE_SCENE_LINEAR) != 0)
    config.warning = "colour config " + config.name + ": no role scene_linear; the role " + role +
                     " is taken, and the working space is \"" + config.working + "\"" +
                     (config.raw ? ", data: its numbers are not converted" : "");
}

Config open_config(const char *path) {
  const Quiet quiet;
  Config config;
  config.name = choose(path);
  if (!is_built_in(config.name)) {
    must_be_readable(config.name);
    must_not_repeat_itself(config.name);
  }
  must_read_numbers(config.name);
  naming(config.name, SOZAI_ERROR_FILE,
         [&] { config.ocio = ocio::Config::CreateFromFile(config.name.c_str()); });
  naming(config.name, SOZAI_ERROR_COLOUR, [&] {
    config.ocio->validate();
    must_end(*config.ocio);
    choose_working_space(config);
  });
  return config;
}

} // namespace sozai::colour
