/* SPDX-License-Identifier: Apache-2.0 */
#include "options.h"

#include <stdio.h>
#include <string.h>

void bench_options_help(void) {
  fputs("usage: sozai-bench [options]\n"
        "\n"
        "What a point of a material costs, beside what a user would do instead: look up\n"
        "the baked picture.\n"
        "\n"
        "  --filter REGEX  only entries that match this POSIX extended expression\n"
        "  --list          the entries' names\n"
        "  --quick         a smaller board and few repetitions: a look, no measurement\n"
        "  --json          a list of {name, ns_per_point, yardstick_ns, ratio, ...}\n"
        "  -h, --help      this help\n"
        "\n"
        "SOZAI_PLUGIN names another sozai.so to load. Without an @ an entry runs on the\n"
        "best instruction set of the machine; SOZAI_CPU is not looked at.\n"
        "\n"
        "What is measured. A flat-sawn board of keyaki with compound grain, 256 mm square,\n"
        "its face towards +z, under a light, evaluated in raster order at steps and\n"
        "footprints of 1/16 mm: full is all channels (a layout's own only where\n"
        "there is one), other names one of them or another wood's albedo. wood.create is a "
        "create() and destroy(), wood.load a dlopen, init\n"
        "and first create() in a fresh process, OpenColorIO with them, load_alone without\n"
        "it; all stand beside their goal of 5 ms.\n"
        "\n"
        "The yardstick. OpenImageIO's TextureSystem::texture(), default options, three\n"
        "channels by file name, of that board's albedo as a half EXR of 4096 x 4096 with\n"
        "mipmaps in a cache that holds it, at the same points with derivatives of a texel.\n"
        "One CPU; yardstick and entry in turn in every repetition; medians; ratio is\n"
        "yardstick by entry, so more is faster. Times are of the thread, but of the clock\n"
        "for threads2 and load.\n"
        "\n"
        "oiio.tile is a tile of 64 x 64 texels of a .sozai file's albedo (texels of 1/16 mm,\n"
        "or as the name says), half, through OpenImageIO's ImageInput; its yardstick is the\n"
        "same tile of that picture baked, a tiled zip-compressed half EXR; both a texel.\n"
        "oiio.look is a tile of all that the shaders of hosts/osl and the nodes of\n"
        "hosts/blender read, in one subimage: of wood albedo and fiber, where it has relief\n"
        "normal; of stone albedo, roughness, normal. Its yardstick is one EXR of those\n"
        "channels, look_apart's an EXR of each output.\n"
        "\n"
        "The limit. ops a point are vector arithmetic instructions times the lanes of the\n"
        "instruction set: float and integer arithmetic, comparisons, conversions, blends,\n"
        "shifts and logic, one each, a division as well. They are counted by stepping\n"
        "through a sample of the points one instruction at a time, so they are those that\n"
        "were executed; loads, gathers, shuffles, masks and general registers are not\n"
        "counted, which for scalar leaves out the integer half. peak is what this core does\n"
        "of independent single-precision multiplications and additions in the same run.\n"
        "limit = ops / peak: what the kernel would take if nothing waited for anything.\n",
        stdout);
}

static bool take_filter(bench_options *o, const char *text, failure *why) {
  if (!text || !*text) return fail(why, EXIT_BAD_INPUT, "--filter needs a value: REGEX");
  o->filter = text;
  return true;
}

bool bench_options_read(bench_options *o, int argc, char **argv, failure *why) {
  *o = (bench_options){0};
  const struct {
    const char *name;
    bool *flag;
  } flags[] = {{"--json", &o->json},
               {"--quick", &o->quick},
               {"--list", &o->list},
               {"--help", &o->help},
               {"-h", &o->help}};
  for (int i = 1; i < argc; i++) {
    const char *text = argv[i];
    size_t k = 0;
    while (k < sizeof flags / sizeof *flags && strcmp(text, flags[k].name) != 0) k++;
    if (k < sizeof flags / sizeof *flags)
      *flags[k].flag = true;
    else if (strncmp(text, "--filter=", 9) == 0) {
      if (!take_filter(o, text + 9, why)) return false;
    } else if (strcmp(text, "--filter") == 0) {
      if (!take_filter(o, i + 1 < argc ? argv[++i] : NULL, why)) return false;
    } else
      return fail(why, EXIT_BAD_INPUT, "unknown %s %s; see sozai-bench --help",
                  text[0] == '-' ? "option" : "argument", text);
  }
  return true;
}
