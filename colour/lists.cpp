// SPDX-License-Identifier: Apache-2.0
#include "lists.hpp"

#include "sozai_colour.h"

#include <algorithm>

namespace ocio = OCIO_NAMESPACE;

namespace sozai::colour {

// The item of that name to the front; the others keep their order.
static void put_first(std::vector<Item> &items, const std::string &name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item &item) { return item.name == name; });
  if (found != items.end()) std::rotate(items.begin(), found, found + 1);
}

static std::vector<Item> views_of(const ocio::Config &config, const char *display) {
  std::vector<Item> views;
  for (int i = 0; i < config.getNumViews(display); i++) {
    const char *view = config.getView(display, i);
    views.push_back({view, config.getDisplayViewLooks(display, view)});
  }
  put_first(views, config.getDefaultView(display));
  return views;
}

// getColorSpace also knows what is hidden, so a role is sure to have one.
static std::string name_of(const ocio::Config &config, const char *space) {
  const auto known = config.getColorSpace(space);
  return known ? known->getName() : "";
}

Lists::Lists(const ocio::Config &config) {
  const auto all = ocio::SEARCH_REFERENCE_SPACE_ALL;
  const auto active = ocio::COLORSPACE_ACTIVE;
  for (int i = 0; i < config.getNumColorSpaces(all, active); i++) {
    const auto space = config.getColorSpace(config.getColorSpaceNameByIndex(all, active, i));
    if (space) spaces.push_back({space->getName(), space->getEncoding()});
  }
  for (int i = 0; i < config.getNumRoles(); i++) {
    const char *role = config.getRoleName(i);
    roles.push_back({role, name_of(config, role)});
  }
  for (int i = 0; i < config.getNumDisplays(); i++) displays.push_back({config.getDisplay(i), ""});
  put_first(displays, config.getDefaultDisplay());
  for (int i = 0; i < config.getNumDisplaysAll(); i++) {
    const char *display = config.getDisplayAll(i);
    views.emplace(display, views_of(config, display));
  }
  for (int i = 0; i < config.getNumLooks(); i++) {
    const char *look = config.getLookNameByIndex(i);
    looks.push_back({look, config.getLook(look)->getProcessSpace()});
  }
}

const std::vector<Item> *Lists::find(uint32_t list, const char *display) const {
  switch (list) {
  case SOZAI_LIST_SPACES:
    return &spaces;
  case SOZAI_LIST_ROLES:
    return &roles;
  case SOZAI_LIST_DISPLAYS:
    return &displays;
  case SOZAI_LIST_LOOKS:
    return &looks;
  case SOZAI_LIST_VIEWS:
    break;
  default:
    return nullptr;
  }
  if (!display && displays.empty()) return nullptr;
  const auto found = views.find(display ? display : displays.front().name);
  return found == views.end() ? nullptr : &found->second;
}

} // namespace sozai::colour
