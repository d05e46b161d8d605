// SPDX-License-Identifier: Apache-2.0
#include "looks.hpp"

#include <algorithm>

namespace sozai::colour {

static std::string trimmed(const std::string &text) {
  static const char white[] = " \t\r\n";
  const size_t first = text.find_first_not_of(white);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

static std::vector<std::string> split(const std::string &text, char at) {
  std::vector<std::string> parts;
  for (size_t from = 0; from <= text.size();) {
    const size_t to = std::min(text.find(at, from), text.size());
    parts.push_back(trimmed(text.substr(from, to - from)));
    from = to + 1;
  }
  return parts;
}

std::vector<std::string> look_names(const char *looks) {
  std::vector<std::string> names;
  for (const auto &option : split(looks ? looks : "", '|')) {
    const char between = option.find(',') != std::string::npos ? ',' : ':';
    for (const auto &signed_name : split(option, between)) {
      const size_t first = signed_name.find_first_not_of("+-");
      if (first != std::string::npos) names.push_back(signed_name.substr(first));
    }
  }
  return names;
}

} // namespace sozai::colour
