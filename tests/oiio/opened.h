// SPDX-License-Identifier: Apache-2.0
// Pictures opened, or the test fails and says why.
#ifndef TESTS_OIIO_OPENED_H
#define TESTS_OIIO_OPENED_H

#include <OpenImageIO/imageio.h>
#include <memory>
#include <string>
#include "cmocka_cpp.h"

inline std::unique_ptr<OIIO::ImageInput> opened(const std::string &name) {
  auto in = OIIO::ImageInput::open(name);
  if (!in) fail_msg("%s: %s", name.c_str(), OIIO::geterror().c_str());
  return in;
}

// 80 x 40 mm of a scale of 10, over the tiles 1001 and 1002.
constexpr char square_obj[] =
    "v -4 -2 1\nv 4 -2 1\nv 4 2 1\nv -4 2 1\nvt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

#endif
