// SPDX-License-Identifier: Apache-2.0
// OpenImageIO may throw, and so may the standard library; nothing gets past
// this file.
#include "tile.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "clock.h"
#include "guarded.hpp"

struct tile {
  std::string text;               // path
  std::vector<std::string> baked; // paths
  std::unique_ptr<OIIO::ImageInput> sozai;
  std::vector<std::unique_ptr<OIIO::ImageInput>> exr;
  std::vector<uint16_t> room;
};

namespace {

constexpr int side = 1024;

bool bake(const std::string &name, const std::string &baked, failure *why) {
  auto in = OIIO::ImageInput::open(name);
  if (!in) return fail(why, EXIT_FAILURE, "%s", OIIO::geterror().c_str());
  int channels = in->spec().nchannels;
  OIIO::ImageSpec spec(side, side, channels, OIIO::TypeDesc::HALF);
  spec.channelnames = in->spec().channelnames;
  OIIO::ImageBuf picture(spec);
  if (!picture.localpixels()) return fail(why, EXIT_FAILURE, "out of memory");
  if (!in->read_image(0, 0, 0, channels, OIIO::TypeDesc::HALF, picture.localpixels()))
    return fail(why, EXIT_FAILURE, "%s", in->geterror().c_str());
  OIIO::ImageSpec config;
  config.set_format(OIIO::TypeDesc::HALF);
  config.tile_width = config.tile_height = int(TILE_SIDE);
  config.attribute("compression", "zip");
  std::ostringstream said;
  return OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, picture, baked, config,
                                          &said) ||
         fail(why, EXIT_FAILURE, "cannot make the texture %s: %s", baked.c_str(),
              said.str().c_str());
}

bool open_input(std::unique_ptr<OIIO::ImageInput> &in, const std::string &path, failure *why) {
  in = OIIO::ImageInput::open(path);
  if (!in) return fail(why, EXIT_FAILURE, "%s", OIIO::geterror().c_str());
  in->threads(1);
  return true;
}

bool write_text(const tile_kind *kind, const std::string &path, failure *why) {
  std::FILE *file = std::fopen(path.c_str(), "w");
  bool ok = file &&
            std::fprintf(file,
                         "material: %s\npreset: %s\nparams: {%s}\nimage: {resolution: %d, "
                         "size: %.9g, format: half, outputs: [%s], subimages: single, "
                         "samples: %d}\n",
                         kind->material, kind->preset, kind->params ? kind->params : "", side,
                         side * kind->texel, kind->outputs, kind->samples ? kind->samples : 1) > 0;
  if (file && std::fclose(file) != 0) ok = false;
  return ok || fail(why, EXIT_FAILURE, "cannot write %s", path.c_str());
}

bool make(tile *t, const tile_kind *kind, const char *folder, const char *plugin_path,
          failure *why) {
  setenv("SOZAI_PLUGIN", plugin_path, 1);
  OIIO::attribute("plugin_searchpath", SOZAI_BENCH_READER);
  // Times are of this thread, so that what others do for it would not count.
  OIIO::attribute("exr_threads", -1);
  OIIO::attribute("threads", 1);
  t->text = std::string(folder) + "/tile.sozai";
  if (!write_text(kind, t->text, why) || !open_input(t->sozai, t->text, why)) return false;
  t->room.resize(TILE_SIDE * TILE_SIDE * size_t(t->sozai->spec().nchannels));
  std::vector<std::string> parts = {kind->outputs};
  if (kind->apart) parts = OIIO::Strutil::splits(kind->outputs, ",");
  t->exr.resize(parts.size());
  for (size_t i = 0; i < parts.size(); i++) {
    t->baked.push_back(std::string(folder) + "/tile" + std::to_string(i) + ".exr");
    if (!bake(t->text + "?outputs=" + parts[i], t->baked[i], why) ||
        !open_input(t->exr[i], t->baked[i], why))
      return false;
  }
  return true;
}

bool read(tile *t, const std::vector<OIIO::ImageInput *> &files, double *ns, failure *why) {
  constexpr int tiles = side / int(TILE_SIDE);
  bool ok = true;
  double begin = thread_ns();
  for (uint32_t k = 0; k < TILE_COUNT; k++) {
    // here and there: every tile once within four repetitions' worth
    int at = int(k * 37 % (tiles * tiles));
    int x = at % tiles * int(TILE_SIDE), y = at / tiles * int(TILE_SIDE);
    for (OIIO::ImageInput *in : files)
      ok &= in->read_tiles(0, 0, x, x + int(TILE_SIDE), y, y + int(TILE_SIDE), 0, 1, 0, -1,
                           OIIO::TypeDesc::HALF, t->room.data());
  }
  *ns = thread_ns() - begin;
  return ok || fail(why, EXIT_FAILURE, "a tile was not read: %s", files[0]->geterror().c_str());
}

} // namespace

tile *tile_open(const tile_kind *kind, const char *folder, const char *plugin_path, failure *why) {
  tile *t = nullptr;
  bool ok = guarded(why, [&] {
    t = new tile{};
    return make(t, kind, folder, plugin_path, why);
  });
  if (ok) return t;
  tile_close(t);
  return nullptr;
}

void tile_close(tile *t) {
  if (!t) return;
  failure ignored;
  guarded(&ignored, [=] {
    t->sozai.reset();
    t->exr.clear();
    std::remove(t->text.c_str());
    for (const std::string &path : t->baked) std::remove(path.c_str());
    delete t;
    return true;
  });
}

bool tile_read_sozai(tile *t, double *ns, failure *why) {
  return guarded(why, [=] { return read(t, {t->sozai.get()}, ns, why); });
}

bool tile_read_baked(tile *t, double *ns, failure *why) {
  return guarded(why, [=] {
    std::vector<OIIO::ImageInput *> files;
    for (auto &in : t->exr) files.push_back(in.get());
    return read(t, files, ns, why);
  });
}
