#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# grow: what it takes for a tree, and what it refuses. The files are read back in
# tests/tree/files.c.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
cd "$scratch" || exit 1

# ---- which tree -------------------------------------------------------------------
works grow tree -o usual.field --age 5
works grow tree -o sugi.field --age 5 --species sugi
check "a sugi, where no species is named, as the help says" cmp -s usual.field sugi.field
works grow tree --help
check "the help says so" grep -qF '(default: sugi)' out
works grow tree -o preset.field --age 5 --preset keyaki
works grow tree -o species.field --age 5 --species keyaki
check "--preset is --species" cmp -s preset.field species.field
works grow fiber --hull ball -o preset.hair -p count=50 --preset felt
works grow fiber --hull ball -o material.hair -p count=50 --material felt
check "--preset is --material" cmp -s preset.hair material.hair
works list
check "list says what is grown" grep -q '^tree  .*sozai grow tree' out
check "and what is not" grep -qx 'wood  Wood' out
refuses 2 "unknown material 'oak'|wood --preset oak" render oak -o gone.png
# what `sozai list` shows is pointed at, where it is no material
printf 'material: tree\n' >tree.sozai
for words in "render tree -o gone.png" "bake tree -o gone.png" "eval tree" "colour tree" "render tree.sozai -o gone.png"; do
  read -ra arguments <<<"$words"
  refuses 2 "unknown material 'tree'|which is grown: sozai grow tree;" "${arguments[@]}" <<<$'px,py,pz\n1,2,3'
done
refuses 2 "unknown material 'sugi_paper'|sozai grow tree --preset sugi_paper" render sugi_paper -o gone.png

# ---- a view shows bark by its age, and not its part's colour -------------------------------
if command -v oiiotool >/dev/null; then
  works grow tree -o bark.exr --age 30 -p orders=0 -p bark_colour=0,0,1 -p rhytidome_colour=1,0,0 \
    -p rhytidome_from=0 -p rhytidome_age=10 --res 40x60 --spp 4 --zoom 8 --target 0,1500,0
  # the stem's, in the middle: red is all of it
  oiiotool bark.exr --cut 4x4+18+28 -o middle.exr
  oiiotool --stats middle.exr >stats
  # shellcheck disable=SC2016 # awk's own fields
  check "an old foot is of rhytidome's colour: $(grep Avg stats)" \
    awk '/Stats Avg/ { seen = $3 > 4 * $5 } END { exit !seen }' stats
fi

# ---- a field table that nothing would read again is not written -------------------------
works grow tree -o most.field --age 20
works grow tree --field most.field -o most.obj -p orders=1
refuses 2 "--output|65536|field_bytes" grow tree -o gone.field --age 40

# ---- a measured one ---------------------------------------------------------------
works grow tree --field sugi.field -o measured.obj
: >empty.field
# What would have no effect is refused, before the work.
for option in --display=sRGB --view=Raw --look=warm; do
  refuses 2 "${option%%=*}|.png|'gone.exr'" grow tree -o gone.exr "$option"
  refuses 2 "${option%%=*}|.png|'gone.exr'" grow fiber --hull ball -o gone.exr "$option"
done
for option in --res=9x9 --spp=2 --camera=1,2 --target=1,2,3 --zoom=2 --display=sRGB --view=Raw --look=warm \
  --config=none.ocio; do
  for ending in obj gltf usda field csv; do
    refuses 2 "${option%%=*}|.png|'gone.$ending'" grow tree -o "gone.$ending" "$option"
  done
done
for option in --res=9x9 --spp=2 --bounces=2 --camera=1,2 --target=1,2,3 --light=1,2 --zoom=2 --display=sRGB \
  --view=Raw --look=warm --config=none.ocio; do
  for ending in obj gltf usda hair pbrt csv; do
    refuses 2 "${option%%=*}|.png|'gone.$ending'" grow fiber --hull ball -o "gone.$ending" "$option"
  done
done
refuses 2 "--level|.gltf|'gone.csv'" grow tree -o gone.csv --table branches --level 2
refuses 2 "--level|.gltf|'gone.field'" grow tree -o gone.field --level 2
refuses 2 "--level|.gltf|'gone.csv'" grow fiber --hull ball -o gone.csv --table strands --level 2
refuses 2 "--level|.gltf|'gone.png'" grow fiber --hull ball -o gone.png --level 2
refuses 2 "--scale|'ball'" grow fiber --hull ball -o gone.usda --scale 2
refuses 2 "--field|'empty.field'|empty" grow tree --field empty.field -o gone.obj
refuses 2 "--field|'/dev/null'|empty" grow tree --field /dev/null -o gone.obj
printf 'trunk\n1 2 x 4\n' >bad.field
refuses 2 "--field: bad.field: line 2|\"x\"" grow tree --field bad.field -o gone.obj
refuses 2 "--field: bad.field: line 2|\"x\"" saw --field bad.field --wood sugi -o gone
same "nothing is left of them" "" "$(find . -name '*gone*' -o -name '.sozai-*')"
finish
