// SPDX-License-Identifier: Apache-2.0
//
// A host whose C++ global locale writes 0,125 for 0.125 and 1.000 for 1000: the
// config is read rightly, or refused for that reason, but never misread.
#include "sozai_colour.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <locale>

namespace {
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// "" for right, else what is wrong.
const char *judge(const sozai_services_1 &factory) {
  sozai_services *services = nullptr;
  char message[512] = "";
  const int32_t result = factory.open(nullptr, &services, message, sizeof message);
  if (result != SOZAI_OK) {
    std::printf("%s\n", message);
    return result == SOZAI_ERROR_COLOUR && std::strstr(message, "locale") ? "" : "other refusal";
  }
  const auto *service = static_cast<const sozai_colour_1 *>(factory.get(services, SOZAI_COLOUR_1));
  float rgb[3] = {0.5f, 0.5f, 0.5f};
  const int32_t converted = service->to_working(service->self, "sRGB", rgb, 1, nullptr, 0);
  factory.close(services);
  return converted == SOZAI_OK && std::fabs(rgb[0] - 0.21404114f) < 1e-6f ? "" : "misread";
}
} // namespace

int main() {
  unsetenv("OCIO");
  void *library = dlopen(SOZAI_TEST_COLOUR, RTLD_NOW);
  const auto *entry =
      library ? static_cast<const sozai_entry_v1 *>(dlsym(library, SOZAI_COLOUR_ENTRY_SYMBOL))
              : nullptr;
  if (!entry || entry->init(SOZAI_TEST_COLOUR) != SOZAI_OK) return 1;
  const auto *factory = static_cast<const sozai_services_1 *>(entry->get_factory(SOZAI_SERVICES_1));

  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  const char *with_commas = judge(*factory);
  std::locale::global(before);
  const char *with_points = judge(*factory);

  std::printf("with commas: %s\nwith points: %s\n", with_commas, with_points);
  entry->deinit();
  dlclose(library);
  return *with_commas || *with_points;
}
