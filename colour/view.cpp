// SPDX-License-Identifier: Apache-2.0
#include "view.hpp"

#include "boundary.hpp"
#include "looks.hpp"

namespace sozai::colour {

// As "it has a, b, c", of any number of names.
template <class Name> static std::string choice(int count, const Name &name) {
  std::string text = count ? "; it has " : "; it has none";
  for (int i = 0; i < count; i++) text += (i ? ", " : "") + std::string(name(i));
  return text;
}

static Failure unknown(const Config &config, const char *kind, const std::string &name,
                       const std::string &choice) {
  return {SOZAI_ERROR_COLOUR,
          std::string("no ") + kind + " \"" + name + "\" in colour config " + config.name + choice};
}

static std::string space_name(const ocio::Config &all, const View &view) {
  const std::string name =
      all.getDisplayViewColorSpaceName(view.display.c_str(), view.view.c_str());
  return name == ocio::OCIO_VIEW_USE_DISPLAY_NAME ? view.display : name;
}

View known_view(const Config &config, const char *display, const char *view, const char *look) {
  const ocio::Config &all = *config.ocio;
  View known;
  known.display = display ? display : all.getDefaultDisplay();
  if (known.display.empty() || all.getNumViews(known.display.c_str()) == 0)
    throw unknown(config, "display", known.display,
                  choice(all.getNumDisplays(), [&](int i) { return all.getDisplay(i); }));
  known.view = view ? view : all.getDefaultView(known.display.c_str());
  if (known.view.empty() || space_name(all, known).empty())
    throw unknown(config, "view", known.view,
                  " on display \"" + known.display + "\"" +
                      choice(all.getNumViews(known.display.c_str()),
                             [&](int i) { return all.getView(known.display.c_str(), i); }));
  for (const auto &name : look_names(look))
    if (!all.getLook(name.c_str()))
      throw unknown(config, "look", name,
                    choice(all.getNumLooks(), [&](int i) { return all.getLookNameByIndex(i); }));
  return known;
}

// Data is shown as it is: no view applies to it, and no look.
static bool is_data(const ocio::Config &all, const std::string &space) {
  const auto known = all.getColorSpace(space.c_str());
  return known && known->isData();
}

ocio::ConstTransformRcPtr transform_of(const Config &config, const View &view, const char *look) {
  const ocio::Config &all = *config.ocio;
  const auto shown = ocio::DisplayViewTransform::Create();
  shown->setSrc(config.working.c_str());
  shown->setDisplay(view.display.c_str());
  shown->setView(view.view.c_str());
  shown->setLooksBypass(look != nullptr);
  if (look_names(look).empty() || config.raw || is_data(all, space_name(all, view))) return shown;

  // A look leaves the colours in the space that it works in: the view goes on from
  // there, as it does after looks of its own.
  const auto looks = ocio::LookTransform::Create();
  looks->setSrc(config.working.c_str());
  looks->setDst(
      ocio::LookTransform::GetLooksResultColorSpace(config.ocio, all.getCurrentContext(), look));
  looks->setLooks(look);
  shown->setSrc(looks->getDst());
  const auto both = ocio::GroupTransform::Create();
  both->appendTransform(looks);
  both->appendTransform(shown);
  return both;
}

} // namespace sozai::colour
