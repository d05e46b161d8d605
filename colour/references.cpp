// SPDX-License-Identifier: Apache-2.0
//
// What in a config is made of what, followed to its ends. Both directions of
// everything count, as OpenColorIO follows both when it looks for variables.
#include "references.hpp"

#include "boundary.hpp"
#include "looks.hpp"
#include "ceilings.h"

#include <algorithm>
#include <map>
#include <vector>

namespace ocio = OCIO_NAMESPACE;

namespace sozai::colour {
namespace {

// Far above real configs, whose chains are of three or four, and far below what
// a thread's stack holds.
constexpr size_t deepest = CONFIG_DEEPEST;
constexpr unsigned long most_steps = CONFIG_MOST_STEPS;

// What making something takes: how many steps, and how many inside one another.
struct Cost {
  unsigned long steps = 0;
  size_t depth = 0;
  Cost &operator+=(const Cost &other) {
    steps += other.steps;
    depth = std::max(depth, other.depth);
    return *this;
  }
  Cost operator+(const Cost &other) const { return Cost(*this) += other; }
};

class Walk {
public:
  explicit Walk(const ocio::Config &config) : config(config), context(config.getCurrentContext()) {}

  Cost space(const char *name) {
    const auto found = config.getColorSpace(name);
    if (!found) return named_transform(name);
    return visit("colour space \"" + std::string(found->getName()) + '"', [&] {
      return transform(found->getTransform(ocio::COLORSPACE_DIR_TO_REFERENCE)) +
             transform(found->getTransform(ocio::COLORSPACE_DIR_FROM_REFERENCE));
    });
  }

  Cost look(const char *name) {
    const auto found = config.getLook(name);
    if (!found) return {};
    return visit("look \"" + std::string(found->getName()) + '"', [&] {
      return transform(found->getTransform()) + transform(found->getInverseTransform()) +
             space(found->getProcessSpace());
    });
  }

  Cost view_transform(const char *name) {
    const auto found = name && *name ? config.getViewTransform(name) : nullptr;
    if (!found) return {};
    return visit("view transform \"" + std::string(found->getName()) + '"', [&] {
      return transform(found->getTransform(ocio::VIEWTRANSFORM_DIR_TO_REFERENCE)) +
             transform(found->getTransform(ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE));
    });
  }

  Cost named_transform(const char *name) {
    const auto found = config.getNamedTransform(name);
    if (!found) return {};
    return visit("named transform \"" + std::string(found->getName()) + '"', [&] {
      return transform(found->getTransform(ocio::TRANSFORM_DIR_FORWARD)) +
             transform(found->getTransform(ocio::TRANSFORM_DIR_INVERSE));
    });
  }

private:
  // Each thing is followed once and remembered.
  template <class Body> Cost visit(const std::string &what, const Body &body) {
    const auto known = costs.find(what);
    if (known != costs.end()) return known->second;
    for (const auto &open : path)
      if (open == what)
        throw Failure(SOZAI_ERROR_COLOUR, what + " is defined by itself: " + chain(what));
    if (path.size() == deepest) throw too_deep(what);
    path.push_back(what);
    Cost cost = body();
    path.pop_back();
    cost.steps++;
    cost.depth++;
    if (cost.steps > most_steps || cost.depth > deepest) throw too_deep(what);
    return costs[what] = cost;
  }

  static Failure too_deep(const std::string &what) {
    return {SOZAI_ERROR_COLOUR, what + " is made of too many others"};
  }

  // The last few links, which close the circle unless it is long.
  std::string chain(const std::string &what) const {
    std::string text;
    size_t first = 0;
    while (path[first] != what) first++;
    for (; first < path.size() && text.size() < 200; first++) text += path[first] + ", ";
    return text + what;
  }

  std::string resolved(const char *name) const { return context->resolveStringVar(name); }

  // A conversion of a scene's space to a display's goes by the default view transform.
  Cost conversion(const std::string &from, const std::string &to) {
    Cost cost = space(from.c_str()) + space(to.c_str());
    const auto a = config.getColorSpace(from.c_str()), b = config.getColorSpace(to.c_str());
    if (a && b && a->getReferenceSpaceType() != b->getReferenceSpaceType()) {
      const auto view = config.getDefaultSceneToDisplayViewTransform();
      if (view) cost += view_transform(view->getName());
    }
    return cost;
  }

  Cost looks(const char *names) {
    Cost cost;
    for (const auto &name : look_names(names)) cost += look(name.c_str());
    return cost;
  }

  Cost view(const ocio::DisplayViewTransform &t) {
    const char *display = t.getDisplay(), *view = t.getView();
    std::string to = config.getDisplayViewColorSpaceName(display, view);
    if (to == ocio::OCIO_VIEW_USE_DISPLAY_NAME) to = display;
    return conversion(resolved(t.getSrc()), to) +
           view_transform(config.getDisplayViewTransformName(display, view)) +
           looks(config.getDisplayViewLooks(display, view));
  }

  // Groups nest as deep as the YAML, which yaml-cpp limits.
  Cost transform(const ocio::ConstTransformRcPtr &t) {
    if (!t) return {};
    Cost cost = {1, 0};
    if (const auto group = ocio::DynamicPtrCast<const ocio::GroupTransform>(t)) {
      for (int i = 0; i < group->getNumTransforms(); i++) cost += transform(group->getTransform(i));
    } else if (const auto space = ocio::DynamicPtrCast<const ocio::ColorSpaceTransform>(t)) {
      cost += conversion(resolved(space->getSrc()), resolved(space->getDst()));
    } else if (const auto look = ocio::DynamicPtrCast<const ocio::LookTransform>(t)) {
      cost += conversion(look->getSrc(), look->getDst()) + looks(look->getLooks());
    } else if (const auto shown = ocio::DynamicPtrCast<const ocio::DisplayViewTransform>(t)) {
      cost += view(*shown);
    }
    return cost;
  }

  const ocio::Config &config;
  const ocio::ConstContextRcPtr context;
  std::map<std::string, Cost> costs;
  std::vector<std::string> path;
};

} // namespace

void must_end(const ocio::Config &config) {
  Walk walk(config);
  const auto all = ocio::SEARCH_REFERENCE_SPACE_ALL;
  const int spaces = config.getNumColorSpaces(all, ocio::COLORSPACE_ALL);
  for (int i = 0; i < spaces; i++)
    walk.space(config.getColorSpaceNameByIndex(all, ocio::COLORSPACE_ALL, i));
  for (int i = 0; i < config.getNumLooks(); i++) walk.look(config.getLookNameByIndex(i));
  for (int i = 0; i < config.getNumViewTransforms(); i++)
    walk.view_transform(config.getViewTransformNameByIndex(i));
  const int named = config.getNumNamedTransforms(ocio::NAMEDTRANSFORM_ALL);
  for (int i = 0; i < named; i++)
    walk.named_transform(config.getNamedTransformNameByIndex(ocio::NAMEDTRANSFORM_ALL, i));
}

} // namespace sozai::colour
