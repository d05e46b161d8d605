// SPDX-License-Identifier: Apache-2.0
//
// A picture in a file.
#include "boundary.hpp"
#include "png.hpp"
#include "source.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace sozai::images {

using colour::Failure;

namespace {

constexpr size_t block_bytes = size_t(16) << 20; // read at a time
constexpr int block_rows = 64;

// A file that is open, closed at the end.
class Descriptor {
public:
  explicit Descriptor(int number) : number(number) {}
  ~Descriptor() {
    if (number >= 0) close(number);
  }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;
  const int number;
};

// As hosts/oiio knows its own, in capitals or not.
bool is_sozai(const std::string &path) {
  static const char ending[] = ".sozai";
  constexpr size_t length = sizeof ending - 1;
  for (size_t at = path.find('.'); at != std::string::npos; at = path.find('.', at + 1))
    if (strncasecmp(path.c_str() + at, ending, length) == 0 &&
        (path.size() == at + length || path[at + length] == '?'))
      return true;
  return false;
}

// Opens it. OpenImageIO says little, opens whatever has a name, and waits for a pipe.
int must_be_a_file(const std::string &path) {
  const auto refuse = [&](const char *why) {
    throw Failure(SOZAI_ERROR_FILE, "picture " + path + ": " + why);
  };
  struct stat status;
  // Opening it would make a texture while one is being made, of itself perhaps.
  if (is_sozai(path)) refuse("a .sozai file, which is no picture for another");
  if (stat(path.c_str(), &status) != 0) refuse(std::strerror(errno));
  if (S_ISDIR(status.st_mode)) refuse(std::strerror(EISDIR));
  if (!S_ISREG(status.st_mode)) refuse("not a file of pixels");
  if (status.st_size == 0) refuse("empty");
  const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) refuse(std::strerror(errno));
  return file;
}

// The name by which OpenImageIO opens it: what follows a question mark it takes for
// arguments.
std::string safe_name(const std::string &path, const Descriptor &file) {
  if (path.find('?') == std::string::npos) return path;
  return "/proc/self/fd/" + std::to_string(file.number);
}

// Readers pile up a line for each attempt; the first says why.
std::string first_line(const std::string &text) { return text.substr(0, text.find('\n')); }

bool is_cmyk(const OIIO::ImageSpec &spec) {
  for (const char *key : {"jpeg:ColorSpace", "tiff:ColorSpace", "oiio:ColorSpace"}) {
    const std::string value(spec.get_string_attribute(key));
    if (value == "CMYK" || value == "YCCK") return true;
  }
  return false;
}

class FileSource final : public Source {
public:
  FileSource(const char *path, const Choice &choice, uint64_t most_pixels)
      : name(path), file(must_be_a_file(name)) {
    if (const char *why = png_damage(name.c_str())) refuse(why);
    OIIO::ImageSpec hints;
    // As it is: OpenImageIO would multiply by alpha before the colour is linear, and
    // round to 8 bits.
    hints.attribute("oiio:UnassociatedAlpha", 1);
    input = OIIO::ImageInput::open(safe_name(name, file), &hints);
    if (!input) {
      const std::string why = first_line(OIIO::geterror());
      refuse(why.empty() ? "no kind of picture that OpenImageIO knows" : why);
    }
    try {
      look_at(choice, most_pixels);
    } catch (...) {
      (void)input->geterror(); // or OpenImageIO would print it
      throw;
    }
  }

  ~FileSource() override {
    (void)input->close();
    (void)input->geterror();
  }

  const Layout &layout() const override { return about; }

  void read(const Row &sink) override {
    const size_t stride = from.size();
    row.assign(size_t(about.width) * stride, 0.0f);
    int y = spec.full_y; // the next row to hand on
    const int end = spec.full_y + spec.full_height;
    const auto blank_until = [&](int until) {
      for (; y < std::min(until, end); y++) {
        std::fill(row.begin(), row.end(), 0.0f);
        sink(row.data());
      }
    };
    blank_until(spec.y);
    for (int begin = spec.y; begin < spec.y + spec.height; begin += rows_at_once) {
      const int stop = std::min(begin + rows_at_once, spec.y + spec.height);
      block_in(begin, stop);
      for (int at = begin; at < stop; at++) {
        if (at < spec.full_y || at >= end) continue;
        pick(size_t(at - begin));
        sink(row.data());
        y++;
      }
    }
    blank_until(end);
    must_have_been_whole();
  }

private:
  [[noreturn]] void refuse(const std::string &why) const {
    throw Failure(SOZAI_ERROR_FILE, "picture " + name + ": " + why);
  }

  // The window with pixels, and the one to be seen: both cost time, the latter room.
  void must_fit(uint64_t most_pixels) const {
    const auto side = [](int size) { return uint64_t(std::max(0, size)); };
    const std::string what = "picture " + name;
    must_be_sane(what, side(spec.width), side(spec.height));
    must_be_sane(what, side(spec.full_width), side(spec.full_height));
    must_be_allowed(what, side(spec.width), side(spec.height), most_pixels);
    must_be_allowed(what, side(spec.full_width), side(spec.full_height), most_pixels);
  }

  void look_at(const Choice &choice, uint64_t most_pixels) {
    spec = input->spec();
    if (spec.deep) refuse("deep, and only flat pictures are taken");
    if (spec.depth > 1 || spec.full_depth > 1) refuse("a volume, and only flat pictures are taken");
    if (is_cmyk(spec)) refuse("CMYK, which has no space in a config; convert it to RGB first");
    if (spec.full_width < 1 || spec.full_height < 1) {
      spec.full_x = spec.x, spec.full_width = spec.width;
      spec.full_y = spec.y, spec.full_height = spec.height;
    }
    must_fit(most_pixels);
    // So that no sum of a corner and a side overflows.
    for (const int corner : {spec.x, spec.y, spec.full_x, spec.full_y})
      if (corner < -(1 << 29) || corner > 1 << 29) refuse("its corner is out of all bounds");
    if (spec.nchannels < 1 || choice.first >= uint32_t(spec.nchannels))
      refuse("no channel " + std::to_string(choice.first) + ", it has " +
             std::to_string(std::max(0, spec.nchannels)));
    about.width = spec.full_width;
    about.height = spec.full_height;
    about.orientation = spec.get_int_attribute("Orientation", 1);
    if (about.orientation < 1 || about.orientation > 8) about.orientation = 1;
    about.premultiplied = spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    choose(choice);

    const bool tiled = spec.tile_width > 0 && spec.tile_height > 0;
    const size_t row_bytes = sizeof(float) * size_t(spec.width) * size_t(high - low);
    rows_at_once = std::clamp(int(block_bytes / row_bytes), 1, block_rows);
    if (tiled) rows_at_once = std::max(rows_at_once / spec.tile_height, 1) * spec.tile_height;
    block.resize(size_t(spec.width) * size_t(high - low) * size_t(rows_at_once));
  }

  void choose(const Choice &choice) {
    const int alpha = spec.alpha_channel < spec.nchannels ? spec.alpha_channel : -1;
    for (uint32_t i = 0; i < choice.channels; i++)
      from.push_back(channel_for(choice, i, spec.nchannels, alpha));
    const bool among = std::find(from.begin(), from.begin() + std::min<long>(3, long(from.size())),
                                 alpha) != from.begin() + std::min<long>(3, long(from.size()));
    about.alpha = choice.colour && choice.channels > 2 && alpha >= 0 && !among;
    if (about.alpha) from.push_back(alpha);
    low = spec.nchannels, high = 0;
    for (const int channel : from) {
      if (channel < 0) continue;
      low = std::min(low, channel);
      high = std::max(high, channel + 1);
    }
  }

  void block_in(int begin, int stop) {
    const bool tiled = spec.tile_width > 0 && spec.tile_height > 0;
    const bool ok =
        tiled ? input->read_tiles(0, 0, spec.x, spec.x + spec.width, begin, stop, spec.z,
                                  spec.z + 1, low, high, OIIO::TypeDesc::FLOAT, block.data())
              : input->read_scanlines(0, 0, begin, stop, spec.z, low, high, OIIO::TypeDesc::FLOAT,
                                      block.data());
    if (ok) return;
    const std::string why = first_line(input->geterror());
    refuse("cannot be read to its end" + (why.empty() ? why : ": " + why));
  }

  // The part of a row of the file that lies in the window to be seen.
  void pick(size_t at) {
    std::fill(row.begin(), row.end(), 0.0f);
    const size_t stride = from.size(), of = size_t(high - low);
    const int begin = std::max(spec.x, spec.full_x);
    const int stop = std::min(spec.x + spec.width, spec.full_x + spec.full_width);
    for (int x = begin; x < stop; x++) {
      const float *in = block.data() + (at * size_t(spec.width) + size_t(x - spec.x)) * of;
      float *out = row.data() + size_t(x - spec.full_x) * stride;
      for (size_t c = 0; c < stride; c++) out[c] = from[c] < 0 ? 1.0f : in[from[c] - low];
    }
  }

  // Some readers fill up what is missing and leave no more than a message.
  void must_have_been_whole() {
    const std::string left = first_line(input->geterror());
    if (left.empty()) return;
    // libjpeg also remarks on what does no harm, such as a stray byte.
    if (std::strcmp(input->format_name(), "jpeg") == 0 &&
        left.find("remature end") == std::string::npos)
      return;
    refuse("cannot be read to its end: " + left);
  }

  const std::string name;
  const Descriptor file;
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;
  Layout about = {};
  std::vector<int> from; // the file's channel for each number of a row; -1: it is 1
  int low = 0, high = 0; // the file's channels to be read
  int rows_at_once = 1;
  std::vector<float> block, row;
};

} // namespace

std::unique_ptr<Source> file_source(const char *path, const Choice &choice, uint64_t most_pixels) {
  return std::make_unique<FileSource>(path, choice, most_pixels);
}

} // namespace sozai::images
