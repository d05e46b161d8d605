// SPDX-License-Identifier: Apache-2.0
#include "processors.hpp"

#include "boundary.hpp"
#include "cpu.hpp"
#include "formula.hpp"
#include "quiet.hpp"
#include "view.hpp"

namespace sozai::colour {

template <class Make>
ocio::ConstCPUProcessorRcPtr Processors::cached(const std::string &key, const std::string &what,
                                                const Make &make) {
  const std::lock_guard<std::mutex> guard(lock);
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  const Quiet quiet;
  try {
    auto cpu = cpu_of(make());
    made.emplace(key, cpu);
    return cpu;
  } catch (const std::bad_alloc &) {
    throw;
  } catch (const std::exception &error) {
    throw Failure(SOZAI_ERROR_COLOUR,
                  what + " of colour config " + config.name + ": " + error.what());
  }
}

// Where the config says nothing of colours, and does not know the name either.
static ocio::ConstTransformRcPtr formula(const Config &config, const char *space) {
  if (!config.raw || config.ocio->getColorSpace(space)) return nullptr;
  return by_formula(space);
}

bool Processors::knows(const char *space) const {
  return config.ocio->getColorSpace(space) || formula(config, space);
}

// By its own name, so that a role or an alias shares the processor.
std::string Processors::known_space(const char *space) const {
  const auto known = config.ocio->getColorSpace(space);
  if (!known)
    throw Failure(SOZAI_ERROR_COLOUR,
                  std::string("no colour space \"") + space + "\" in colour config " + config.name);
  return known->getName();
}

ocio::ConstCPUProcessorRcPtr Processors::to_working(const char *space) {
  const auto known = formula(config, space);
  if (!known) return between(space, config.working.c_str());
  return cached(std::string("decode\n") + space, space,
                [&] { return config.ocio->getProcessor(known); });
}

ocio::ConstCPUProcessorRcPtr Processors::from_working(const char *space) {
  const auto known = formula(config, space);
  if (!known) return between(config.working.c_str(), space);
  return cached(std::string("encode\n") + space, space,
                [&] { return config.ocio->getProcessor(known, ocio::TRANSFORM_DIR_INVERSE); });
}

ocio::ConstCPUProcessorRcPtr Processors::between(const char *from, const char *to) {
  const std::string a = known_space(from), b = known_space(to);
  // To name in messages: the one that is not the working space.
  const std::string &named = a == config.working ? b : a;
  return cached("convert\n" + a + '\n' + b, "colour space \"" + named + "\"",
                [&] { return config.ocio->getProcessor(a.c_str(), b.c_str()); });
}

ocio::ConstCPUProcessorRcPtr Processors::to_display(const char *display, const char *view,
                                                    const char *look) {
  const View shown = known_view(config, display, view, look);
  const std::string looks = look ? std::string("\nlooks ") + look : "";
  return cached("show\n" + shown.display + '\n' + shown.view + looks,
                "view \"" + shown.view + "\" on display \"" + shown.display + "\"",
                [&] { return config.ocio->getProcessor(transform_of(config, shown, look)); });
}

} // namespace sozai::colour
