// SPDX-License-Identifier: Apache-2.0
//
// Which config, and whether it is fit for use.
#include "config.hpp"

#include "boundary.hpp"
#include "quiet.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
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

// OpenColorIO says only that it could not read; the system knows why.
static void must_be_readable(const std::string &path) {
  if (path.rfind("ocio://", 0) == 0) return; // a config built into OpenColorIO 2.2 and later
  struct stat status;
  int error = 0;
  if (stat(path.c_str(), &status) != 0 || access(path.c_str(), R_OK) != 0)
    error = errno;
  else if (S_ISDIR(status.st_mode))
    error = EISDIR;
  if (error == 0) return;
  throw Failure(SOZAI_ERROR_FILE, "colour config " + path + ": " + std::strerror(error));
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
  } catch (const Failure &) {
    throw;
  } catch (const std::bad_alloc &) {
    throw;
  } catch (const std::exception &error) {
    throw Failure(result, "colour config " + path + ": " + error.what());
  }
}

Config open_config(const char *path) {
  const Quiet quiet;
  Config config;
  config.name = choose(path);
  must_be_readable(config.name);
  must_read_numbers(config.name);
  naming(config.name, SOZAI_ERROR_FILE,
         [&] { config.ocio = ocio::Config::CreateFromFile(config.name.c_str()); });
  naming(config.name, SOZAI_ERROR_COLOUR, [&] {
    config.ocio->validate();
    const auto working = config.ocio->getColorSpace(ocio::ROLE_SCENE_LINEAR);
    // A space may bear the role's name without the role being there.
    if (!working || !config.ocio->hasRole(ocio::ROLE_SCENE_LINEAR))
      throw Failure(SOZAI_ERROR_COLOUR,
                    "colour config " + config.name + " has no role scene_linear");
    config.working = working->getName();
  });
  return config;
}

} // namespace sozai::colour
