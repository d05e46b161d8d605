// SPDX-License-Identifier: Apache-2.0
//
// No YAML parser: it tells where the node of an anchor ends by indentation and
// brackets, which is enough to find an alias inside it.
#include "aliases.hpp"

#include <algorithm>
#include <vector>

namespace sozai::colour {
namespace {

// A node with an anchor that has not come to its end.
struct Open {
  std::string name;
  int depth;  // brackets around it
  int parent; // outside of brackets: the column that what ends it begins at, or left of it
  bool items; // that column's "- " still belongs to it
};

struct Scan {
  const std::string &text;
  std::vector<Open> open;
  int depth = 0;
  int column = 0;    // where the line's key or value begins, past any "- "
  int dash = -1;     // the column of the last "- " before it
  size_t begins = 0; // the same as column, in the text

  char at(size_t i) const { return i < text.size() ? text[i] : '\n'; }

  void begin_line(size_t i) {
    const size_t start = i;
    dash = -1;
    while (at(i) == ' ') i++;
    if (at(i) == '\n' || at(i) == '\r' || at(i) == '#') return;
    const int indent = static_cast<int>(i - start);
    const bool item = at(i) == '-' && (at(i + 1) == ' ' || at(i + 1) == '\n');
    if (depth <= 0)
      open.erase(std::remove_if(open.begin(), open.end(),
                                [&](const Open &o) {
                                  return indent < o.parent ||
                                         (indent == o.parent && !(item && o.items));
                                }),
                 open.end());
    while (at(i) == '-' && at(i + 1) == ' ') {
      dash = static_cast<int>(i - start);
      while (at(++i) == ' ') {
      }
    }
    column = static_cast<int>(i - start);
    begins = i;
  }

  // In brackets a node ends with the bracket around it, or at a comma.
  void end_in_brackets(bool comma) {
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](const Open &o) {
                                return o.depth > 0 &&
                                       (depth < o.depth || (comma && depth == o.depth));
                              }),
               open.end());
  }

  std::string name(size_t i) const {
    const size_t end = text.find_first_of(" \t\r\n,[]{}", i);
    return text.substr(i, end == std::string::npos ? end : end - i);
  }

  void anchor(size_t i) {
    Open o = {name(i + 1), std::max(depth, 0), column, true};
    // Nothing before it but a tag: the line is the node's own, not a key's.
    const bool tag = at(begins) == '!' && text.find(' ', begins) == i - 1;
    if (i == begins || tag) {
      o.parent = dash;
      o.items = false;
    }
    open.push_back(o);
  }
};

} // namespace

std::string circular_alias(const std::string &yaml) {
  Scan scan{yaml, {}};
  for (size_t i = 0; i < yaml.size(); i++) {
    if (i == 0 || yaml[i - 1] == '\n') scan.begin_line(i);
    const char c = yaml[i], before = i ? yaml[i - 1] : '\n';
    const bool starts = std::string(" \t\n[{,:").find(before) != std::string::npos;
    if (c == '[' || c == '{') scan.depth++;
    if (c == ']' || c == '}') scan.depth--;
    if (c == ']' || c == '}' || c == ',') scan.end_in_brackets(c == ',');
    if (!starts) continue;
    const size_t line_end = std::min(yaml.find('\n', i), yaml.size());
    if (c == '#') i = line_end - 1;
    if (c == '"' || c == '\'') {
      const size_t close = yaml.find(c, i + 1);
      if (close < line_end) i = close;
    }
    if (c == '&') scan.anchor(i);
    if (c == '*')
      for (const auto &open : scan.open)
        if (open.name == scan.name(i + 1)) return open.name;
  }
  return "";
}

} // namespace sozai::colour
