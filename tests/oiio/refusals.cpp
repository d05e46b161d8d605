// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file, or with what is asked after its name, is said in
// one line through OpenImageIO's geterror(); nothing throws, crashes or hangs.
#include <OpenImageIO/imageio.h>
#include <cstdio>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"

using namespace OIIO;

namespace {

int count;

void refuse(const std::string &name, const std::vector<std::string> &words) {
  count++;
  std::string message;
  {
    auto in = ImageInput::create("any.sozai"); // the reader alone, as hosts do
    if (!in) {
      (void)OIIO::geterror();
      in = ImageInput::create("sozai");
    }
    assert_non_null(in.get());
    ImageSpec spec;
    if (in->open(name, spec)) fail_msg("%.200s: opened", name.c_str());
    message = in->geterror();
  }
  if (message.empty() || message.find('\n') != std::string::npos)
    fail_msg("%.200s: not one line: '%s'", name.c_str(), message.c_str());
  for (const std::string &word : words)
    if (message.find(word) == std::string::npos)
      fail_msg("%.200s: no '%s' in: %s", name.c_str(), word.c_str(), message.c_str());
  // And by the front door.
  auto in = ImageInput::open(name);
  assert_null(in.get());
  assert_false(OIIO::geterror().empty());
}

void refuse_text(const std::string &text, const std::vector<std::string> &words) {
  refuse(direct_write("bad.sozai", text.c_str()), words);
}

void files(void **) {
  refuse("/nowhere/none.sozai", {"none.sozai"});
  refuse_text("", {"bad.sozai:", "empty"});
  refuse_text("materiel: wood\n", {":1:", "'materiel'", "material"});
  refuse_text("material: granite\n", {"'granite'", "wood", "stone"});
  refuse_text("material: wood\npreset: plastic\n", {"plastic"});
  refuse_text("material: wood\nparams: {ring_width: wide}\n", {":2:", "ring_width", "wide"});
  refuse_text("material: wood\nparams: {ring_width: 1e30}\n", {":2:", "ring_width", "0.2", "30"});
  refuse_text("material: wood\nparams: {ring_width: .nan}\n", {"ring_width"});
  refuse_text("material: wood\nparams: {no_such: 1}\n", {":2:", "no_such"});
  refuse_text("material: wood\nparams: [1, 2]\n", {":2:", "mapping"});
  refuse_text("material: wood\nimage: {resolution: 1000000000}\n",
              {":2:", "resolution", "1048576"});
  refuse_text("material: wood\nimage: {resolution: 0}\n", {"resolution"});
  refuse_text("material: wood\nimage: {resolution: -5}\n", {"resolution"});
  refuse_text("material: wood\nimage: {resolution: 1.5}\n", {"resolution", "whole"});
  refuse_text("material: wood\nimage: {resolution: {a: b}}\n", {":2:", "single value"});
  refuse_text("material: wood\nimage: {size: nan}\n", {"size", "nan"});
  refuse_text("material: wood\nimage: {size: 1e30}\n", {"size", "1e30"});
  refuse_text("material: wood\nimage: {pixels: 4}\n", {":2:", "'pixels'", "resolution"});
  refuse_text("material: wood\nimage: {format: double}\n", {"format", "'double'", "half"});
  refuse_text("material: wood\nimage: {wrap: round}\n", {"wrap", "'round'", "mirror"});
  refuse_text("material: wood\nimage: {wrap: periodic}\n", {"periodic", "wood"});
  refuse_text(
      "material: stone\nsurface: {shape: board, size: [9, 9, 9]}\nimage: {wrap: periodic}\n",
      {"periodic", "plane"});
  refuse_text("material: stone\npreset: granite_fan\nimage: {wrap: periodic}\n",
              {"bad.sozai", "periodic", "layout", "'fan'", "clamp"});
  refuse_text(
      "material: stone\npreset: carrara\nparams: {layout: stack}\nimage: {wrap: periodic}\n",
      {"periodic", "layout", "'stack'"});
  const std::string paper = "material: stone\nparams: {colour_mode: paper_rgb, paper_texel: 0.5, ";
  refuse_text(
      paper + "paper_pattern: igeta}\nimage: {wrap: periodic, size: [500, 300]}\n",
      {"bad.sozai", "500 x 300 mm", "200 x 200 mm", "(paper_pattern)", "600 x 400 mm would be"});
  refuse_text(paper + "paper_pattern: cut}\nimage: {wrap: periodic, size: [300, 20]}\n",
              {"300 x 20 mm", "100 x 100 mm", "300 x 100 mm would be"});
  refuse_text("material: wood\nimage: {normals: up}\n", {"normals", "'up'", "tangent"});
  refuse_text("material: wood\nimage: {outputs: [albedo, colour]}\n",
              {"outputs", "'colour'", "albedo"});
  refuse_text("material: wood\nimage: {outputs: albedo albedo}\n", {"outputs"});
  refuse_text("material: wood\nimage: {outputs: [albedo, albedo]}\n", {"outputs", "twice"});
  refuse_text("material: wood\nimage: {outputs: []}\n", {"outputs"});
  refuse_text("material: wood\nimage: {outputs: radiance}\n", {"radiance", "light"});
  refuse_text("material: wood\nimage: {resolution: [8, 8, 8], outputs: specular}\n",
              {"specular", "normal"});
  refuse_text("material: wood\nimage: {resolution: [8, 8, 8], normals: tangent}\n", {"volume"});
  refuse_text("material: wood\nimage: {subimages: both}\n",
              {":2:", "subimages", "'both'", "separate", "single"});
  refuse_text("material: wood\nimage: {subimages: 1}\n", {":2:", "subimages", "'1'", "single"});
  refuse_text("material: wood\nimage: {subimages: [single, separate]}\n", {":2:", "subimages"});
  refuse_text("material: wood\nimage: {subimages: .nan}\n", {":2:", "subimages", "single"});
  refuse_text("material: wood\nimage: {subimages: {a: b}}\n", {":2:", "single value"});
  refuse_text("material: wood\nimage: {subimages: single, outputs: [albedo, albedo]}\n",
              {"outputs", "twice"});
  refuse_text("material: wood\nimage: {resolution: [8, 8, 8], subimages: single, outputs: [albedo, "
              "specular]}\n",
              {"specular", "normal"});
  refuse_text("material: wood\nimage: {udim: 1001}\n", {"udim", "mesh"});
  refuse_text("material: wood\nimage: {udim: 12}\n", {"udim", "1001"});
  refuse_text("material: wood\nsurface: {shape: ball}\n", {":2:", "'ball'", "plane"});
  refuse_text("material: wood\nsurface: {shape: board, size: [10, 10, 5]}\nimage: {size: 20}\n",
              {"size", "board"});
  refuse_text("material: wood\nsurface: {shape: mesh}\n", {"mesh"});
  refuse_text("material: wood\nsurface: {shape: mesh, mesh: none.obj}\n", {"none.obj"});
  refuse_text("material: wood\nsurface: {shape: mesh, mesh: bad.sozai}\n", {"bad.sozai"});
}

void meshes(void **) {
  direct_write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  direct_write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                             "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  refuse_text("material: wood\nsurface: {shape: mesh, mesh: bare.obj}\n", {"bare.obj", "UV"});
  refuse_text("material: wood\nsurface: {shape: mesh, mesh: square.obj}\nimage: {udim: 1002}\n",
              {"1002", "1001"});
  refuse_text(
      "material: wood\nsurface: {shape: mesh, mesh: square.obj}\nimage: {normals: tangent}\n",
      {"tangent", "mesh"});
  refuse_text("material: wood\nsurface: {shape: mesh, mesh: square.obj}\nimage: {size: 3}\n",
              {"size", "mesh"});
  refuse_text("material: wood\nsurface: {shape: mesh, mesh: square.obj, scale: 0}\n", {"scale"});
  refuse_text(
      "material: stone\nsurface: {shape: mesh, mesh: square.obj}\nimage: {wrap: periodic}\n",
      {"periodic", "plane"});
}

void includes(void **) {
  direct_write("one.sozai", "include: two.sozai\nmaterial: wood\n");
  direct_write("two.sozai", "include: three.sozai\n");
  direct_write("three.sozai", "include: ./one.sozai\n");
  std::string folder = std::string(direct_folder()) + "/";
  refuse(folder + "one.sozai", {"three.sozai:1:", "includes itself"});
  refuse_text("include: bad.sozai\n", {"includes itself"});
  refuse_text("include: missing.sozai\n", {"bad.sozai:1:", "missing.sozai"});
  refuse_text("material: wood\ninclude: two.sozai\n", {":2:", "first"});
  for (int i = 0; i < 10; i++)
    direct_write(("deep" + std::to_string(i) + ".sozai").c_str(),
                 ("include: deep" + std::to_string(i + 1) + ".sozai\n").c_str());
  direct_write("deep10.sozai", "material: wood\n");
  refuse(folder + "deep0.sozai", {"deep7.sozai:1: ", "recipe_includes, 8"});
  direct_write("wrong.sozai", "material: wood\nparams: {ring_width: wide}\n");
  refuse_text("include: wrong.sozai\n", {"wrong.sozai:2:", "ring_width"}); // where it stands
  refuse_text("include: deep10.sozai\nparams: {grain: odd}\n", {"bad.sozai:2:", "grain"});
}

void queries(void **) {
  std::string good = direct_write("good.sozai", "material: wood\n") + std::string("?");
  refuse(good + "res=huge", {"res=huge", "resolution"});
  refuse(good + "res=1e9", {"1048576"});
  refuse(good + "res=0x0", {"res=0x0"});
  refuse(good + "res=4x4x4x4", {"res="});
  refuse(good + "res=", {"res="});
  refuse(good + "size=-1", {"size=-1"});
  refuse(good + "format=int", {"format"});
  refuse(good + "outputs=", {"outputs"});
  refuse(good + "outputs=,", {"outputs"});
  refuse(good + "preset=none", {"none"});
  refuse(good + "ring_width=inf", {"ring_width"});
  refuse(good + "grain=wobbly", {"grain", "wobbly", "wavy"});
  refuse(good + "colour=red", {"colour"});
  refuse(good + "a=" + std::string(100000, 'x'), {"a"});
  refuse(good + "grain=%ff%fe", {"grain"});
  refuse(good + "udim=1001", {"udim"});
  refuse(good + "subimages=", {"subimages", "separate, single"});
  refuse(good + "samples=3", {"samples", "'3'", "1, 2, 4, 8"});
  refuse(good + "samples=1e30", {"samples", "'1e30'"});
  refuse(good + "resolution=8,8,8&samples=2", {"samples", "volume"});
  refuse(good + "subimages=Single", {"subimages", "'Single'"});
  refuse(good + "subimages=single,single", {"subimages", "single,single"});
  refuse(good + "subimages=1e30", {"subimages", "'1e30'"});
  refuse(good + "subimages=%ff%00", {"subimages"});
  refuse(good + "subimages=" + std::string(3000, 's'), {"subimages"});
}

void hostile(void **) {
  std::string deep = "material: wood\nparams: ";
  for (int i = 0; i < 200000; i++) deep += "[";
  refuse_text(deep, {"bad.sozai"});
  deep = "material: wood\nparams: {ring_width: ";
  for (int i = 0; i < 3000; i++) deep += "{a: ";
  refuse_text(deep, {"bad.sozai:2:"});
  refuse_text("material: &a [*a, *a]\n", {":1:"});
  refuse_text("material: wood\nparams: {ring_width: \"1\n", {"bad.sozai:"}); // cut off
  refuse_text("material: wood\nimage: {resolution: [1, 2\n", {"bad.sozai:"});
  refuse_text("material: \"wo\\0od\"\n", {"bad.sozai:1:"});
  refuse_text("\x7f"
              "ELF\x02\x01\x01\xff\xfe\x80\x90",
              {"bad.sozai"});
  refuse_text("%YAML 9.9\n---\nmaterial: wood\n", {"bad.sozai"});
  refuse_text("material: wood\n---\nmaterial: stone\n", {"document"});
  refuse_text("material: " + std::string(70000, 'w') + "\n", {"too long"});
  refuse_text("material: wood\n#" + std::string(2000000, 'x'), {"recipe_bytes, 1048576"});
  std::string longest(4000, 'n');
  refuse("/tmp/" + longest + ".sozai", {"cannot read"});
  refuse(direct_folder(), {"not a .sozai file"});
  refuse("/dev/zero.sozai", {"zero.sozai"});
  refuse("wood", {"not a .sozai file"});
}

// What was refused leaves a reader that opens the next, and reads refuse what is not there.
void afterwards(void **) {
  std::string good =
      direct_write("after.sozai", "material: wood\nimage: {resolution: 100, outputs: [albedo]}\n");
  auto in = ImageInput::create("sozai");
  ImageSpec spec;
  assert_false(in->open(good + "?res=no", spec));
  assert_false(in->geterror().empty());
  std::vector<float> tile(64 * 64 * 3);
  assert_false(in->read_tile(0, 0, 0, TypeFloat, tile.data())); // nothing is open
  (void)in->geterror();
  assert_true(in->open(good, spec));
  assert_true(in->read_tile(64, 64, 0, TypeFloat, tile.data()));
  assert_false(in->read_tiles(0, 0, 3, 67, 0, 64, 0, 1, 0, 3, TypeFloat, tile.data()));
  assert_false(in->read_tiles(0, 99, 0, 64, 0, 64, 0, 1, 0, 3, TypeFloat, tile.data()));
  assert_false(in->read_tiles(1, 0, 0, 64, 0, 64, 0, 1, 0, 3, TypeFloat, tile.data()));
  assert_false(in->read_tiles(-1, 0, 0, 64, 0, 64, 0, 1, 0, 3, TypeFloat, tile.data()));
  assert_false(in->read_tiles(0, 0, 0, 64, 0, 64, 0, 1, 3, 4, TypeFloat, tile.data()));
  assert_false(in->read_native_tile(0, 0, 64000, 0, 0, tile.data()));
  assert_false(in->geterror().empty());
  assert_false(in->seek_subimage(1, 0));
  assert_false(in->seek_subimage(0, 7));
  assert_true(in->read_tile(0, 64, 0, TypeFloat, tile.data()));
  assert_true(in->open(good + "?subimages=single&outputs=albedo,normal", spec));
  assert_int_equal(spec.nchannels, 6);
  tile.resize(64 * 64 * 6);
  assert_true(in->read_tiles(0, 0, 0, 64, 0, 64, 0, 1, 5, 6, TypeFloat, tile.data()));
  assert_false(in->read_tiles(0, 0, 0, 64, 0, 64, 0, 1, 6, 7, TypeFloat, tile.data()));
  assert_false(in->read_tiles(0, 0, 0, 64, 0, 64, 0, 1, 4, 4, TypeFloat, tile.data()));
  assert_false(in->read_tiles(0, 0, 0, 64, 0, 64, 0, 1, -1, 3, TypeFloat, tile.data()));
  assert_false(in->read_tiles(1, 0, 0, 64, 0, 64, 0, 1, 0, 3, TypeFloat, tile.data()));
  assert_false(in->seek_subimage(1, 0));
  assert_false(in->geterror().empty());
  assert_true(in->close());
  assert_true(in->close());
  std::printf("%d refused\n", count);
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(files),    cmocka_unit_test(meshes),
                              cmocka_unit_test(includes), cmocka_unit_test(queries),
                              cmocka_unit_test(hostile),  cmocka_unit_test(afterwards)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
