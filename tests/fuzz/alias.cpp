// SPDX-License-Identifier: Apache-2.0
// A colour config's text, as it is looked through for aliases within their own nodes.
#include "fuzz.h"

#include <string>
#include "aliases.hpp"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const std::string yaml(reinterpret_cast<const char *>(data), size);
  const std::string name = sozai::colour::circular_alias(yaml);
  CHECK(name.empty() || yaml.find("*" + name) != std::string::npos);
  return 0;
}
