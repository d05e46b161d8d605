#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The command over the plugin and colour service that are built beside it.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly picture=$4
readonly header=px,py,pz,nx,ny,nz,lx,ly,lz,vx,vy,vz,footprint

# Without SOZAI_PLUGIN it finds the plugin by itself.
unset SOZAI_PLUGIN
works list
check "the plugin beside the program" grep -qw keyaki "$scratch/out"

# fibre is a texture, and is grown too
works describe fiber
check "describe fiber is the texture's" grep -q 'strand_id' "$scratch/out"
works describe fiber --grown
check "describe --grown is the generator's" grep -q '^  hull' "$scratch/out"
refuses 2 "unknown thing to grow 'wood'" describe wood --grown
refuses 2 "packing|2|0.0001|0.7" eval fiber -p packing=2 <<<"$header"
works render fiber --preset denim -o "$scratch/denim.exr" --res 64x48 --spp 4 --shape sphere
check "denim: finite" "$picture" finite "$scratch/denim.exr"

works eval wood --preset keyaki <<<"$header"$'\n50,0,0,0,0,1,0,0,1,0,0,1,0.1\nnan,inf,-inf,nan,0,0,0,0,0,inf,0,0,nan\n1e30,-1e30,0,0,0,0,0,0,0,0,0,0,1e30'
check "every number is finite" not grep -qi 'nan\|inf' "$scratch/out"
same "rows" 4 "$(wc -l <"$scratch/out")"

refuses 2 "ring_width|-1|0.2|30" eval wood -p ring_width=-1 <<<"$header"
refuses 2 "ring_widht" eval wood -p ring_widht=1 <<<"$header"
SOZAI_CPU=z80 refuses 2 "SOZAI_CPU|z80|scalar" eval wood <<<"$header"
refuses 2 "none.ocio" eval wood --config "$scratch/none.ocio" <<<"$header"
refuses 2 "nope" render wood --view nope -o "$scratch/x.png"
check "no picture of it" test ! -e "$scratch/x.png"

for cut in flat end; do
  works render wood --preset mizunara --cut "$cut" -o "$scratch/$cut.exr" --res 64x48 --spp 4
  check "$cut: finite" "$picture" finite "$scratch/$cut.exr"
done
# Without a cut it is flat-sawn, 100 mm from the pith; with one, where the parameter says.
for how in "" "-p cut=flat -p cut_distance=100" "-p cut=flat" "-p cut_distance=60"; do
  # shellcheck disable=SC2086 # several words, or none
  works render wood --preset keyaki $how -o "$scratch/sawn${how//[^0-9a-z]/-}.exr" --res 64x48 --spp 2
done
check "a board by itself" "$picture" same "$scratch/sawn.exr" "$scratch/sawn-p-cut-flat--p-cut-distance-100.exr"
check "a board sawn by name" "$picture" same "$scratch/sawn-p-cut-flat.exr" "$scratch/sawn-p-cut-distance-60.exr"
check "which is another" not "$picture" same "$scratch/sawn.exr" "$scratch/sawn-p-cut-flat.exr"
# A board's length runs along the grain, and its end grain is across it.
check "flat: fibres along +y" "$picture" between "$scratch/flat.exr" 32 24 fiber.y 0.95 1
check "end: fibres along +z" "$picture" between "$scratch/end.exr" 32 24 fiber.z 0.95 1
works render wood --preset keyaki -o "$scratch/shown.png" --res 64x48 --spp 4
works render wood --preset keyaki -o "$scratch/raw.png" --res 64x48 --spp 4 --view Raw
check "the view is the display's" not cmp -s "$scratch/shown.png" "$scratch/raw.png"
# A board of the command line is sawn, and baked as it is rendered.
bake() { works bake wood --shape "$shape" --size "$size" --res 32 "${@:2}" -o "$scratch/$shape$1.exr"; }
for shape in board plane; do
  size=60x40
  if [[ $shape == board ]]; then size=60x40x20; fi
  bake ''
  bake -flat -p cut=flat -p cut_distance=100
  bake cut=log -p cut=log
  check "bake: a $shape is sawn flat" cmp -s "$scratch/$shape.exr" "$scratch/$shape-flat.exr"
  check "unless it is said how" not cmp -s "$scratch/$shape.exr" "$scratch/${shape}cut=log.exr"
done
works render wood -o "$scratch/plane-by-itself.exr" --shape plane --camera front --size 60x40 --res 48x32 --spp 1
works render wood -o "$scratch/plane-sawn.exr" --shape plane --camera front --size 60x40 --res 48x32 --spp 1 \
  -p cut=flat -p cut_distance=100
check "and rendered so" "$picture" same "$scratch/plane-by-itself.exr" "$scratch/plane-sawn.exr"
printf 'material: wood\nsurface: {shape: board, size: [60, 40, 20]}\nimage: {resolution: 32}\n' >"$scratch/board.sozai"
works bake "$scratch/board.sozai" -o "$scratch/file.exr"
check "and a file's is as any host sees it" cmp -s "$scratch/file.exr" "$scratch/boardcut=log.exr"
# What strands leave bare is a card that half of the light comes back from; where they are dense, dark.
works render fiber --preset dust --shape plane --camera front --size 4000x3000 --res 16x12 --spp 1 -o "$scratch/dust.exr"
check "dust over a grey card" "$picture" between "$scratch/dust.exr" 8 6 R 0.2 0.6
works render fiber --preset coir --shape plane --camera front --size 4000x3000 --res 16x12 --spp 1 -o "$scratch/coir.exr"
check "coir is its own ground" "$picture" between "$scratch/coir.exr" 8 6 B 0.002 0.08
# What no line may run through.
printf 'material: stone\npreset: granite_fan\nimage: {resolution: 32, wrap: periodic}\n' >"$scratch/fan.sozai"
refuses 2 "fan.sozai|wrap: periodic|layout|'fan'" bake "$scratch/fan.sozai" -o "$scratch/fan.exr"
sed -i 's/image:/params: {layout: none, colour_mode: paper_rgb, paper_pattern: cut}\n&/' "$scratch/fan.sozai"
works bake "$scratch/fan.sozai" -o "$scratch/fan.exr"
# What docs/oiio.md shows is taken as it stands.
docs=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../docs" && pwd)
for heading in 'The file' Values; do
  awk -v "heading=## $heading" '$0 == heading { on = 1; next } on && /^    / { print substr($0, 5); any = 1; next }
    on && any { exit }' "$docs/oiio.md" >"$scratch/page.sozai"
  check "docs/oiio.md, $heading: an example" grep -q '^material: wood' "$scratch/page.sozai"
  works bake "$scratch/page.sozai" -o "$scratch/page.png" --res 32
done
# Ids are no shares, and go past what a half can say.
readonly boards=(bake wood -p layout=herringbone --size 2000x2000 --res 64 --outputs board_id)
refuses 2 "--outputs|'board_id'|0 and 1|EXR" "${boards[@]}" -o "$scratch/id.tif"
refuses 2 "--outputs|'board_id'|0 and 1|EXR" "${boards[@]}" -o "$scratch/id.png"
printf 'material: wood\nimage: {format: half}\n' >"$scratch/half.sozai"
works "${boards[@]}" -o "$scratch/id.exr"
works "${boards[@]}" -o "$scratch/id16.exr" --bits 16
works "${boards[@]/#wood/$scratch/half.sozai}" -o "$scratch/idhalf.exr"
check "ids stay float with --bits 16" cmp -s "$scratch/id.exr" "$scratch/id16.exr"
check "and with format: half" cmp -s "$scratch/id.exr" "$scratch/idhalf.exr"
# The paper's tile repeats by itself, if the picture is whole tiles.
cat >"$scratch/paper.sozai" <<'YAML'
material: stone
params: {colour_mode: paper_rgb, paper_texel: 0.3, paper_pattern: chidori}
image: {wrap: periodic, size: [180, 120]}
YAML
works bake "$scratch/paper.sozai" -o "$scratch/paper.png" --res 90x60
refuses 2 "paper.sozai|periodic|180 x 100 mm|60 x 120 mm|180 x 120 mm would be" bake "$scratch/paper.sozai" \
  -o "$scratch/gone.png" --res 90x50 --size 180x100
finish
