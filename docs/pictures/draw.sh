#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# draw.sh [FOLDER] [PICTURE...]: pictures of these pages, by the command. FOLDER: the script's
# own, unless given. PICTURE: stones, fibres, log, barks, collars, and of a whole gallery gallery, figured, plies,
# knots, layouts and trees; none: all. SOZAI: the program, unless build/bin/sozai.
# Blender's: hosts/blender/examples/draw.sh.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
sozai=${SOZAI:-$here/../../build/bin/sozai}
readonly here sozai
readonly folder=${1:-$here}
[[ -d $folder ]] || {
  echo "no folder $folder" >&2
  exit 1
}
(($#)) && shift
[[ -x $sozai ]] || {
  echo "no $sozai: build first, or name it by SOZAI" >&2
  exit 1
}
command -v oiiotool >/dev/null || {
  echo "no oiiotool here (Debian: openimageio-tools)" >&2
  exit 1
}
# oiiotool's own command line, which names folders of this machine, stays out of its pictures
readonly untold=(--eraseattrib '.*' --nosoftwareattrib)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# tile FILE MATERIAL PRESET OPTION...: of the stones' picture, or the fibres'
tile() {
  "$sozai" render "$2" --preset "$3" -o "$scratch/$1.png" --shape plane --res 400x300 --spp 32 "${@:4}"
}
stone() { tile "$1" stone "${@:2}"; }

# sheet FILE: of the twelve tiles
sheet() {
  oiiotool "$scratch"/{1,2,3,4,5,6,7,8,9,10,11,12}.png --mosaic 4x3 "${untold[@]}" -d uint8 -o "$folder/$1.png"
}

# Inada granite, Ogatsu slate, Baltic Brown, Rosso Verona; travertine, Calacatta, Rosso Levanto, terrazzo;
# Rosa Beta flamed, setts in fans, a mossy path, araidashi
draw_stones() {
  stone 1 inada --camera front --size 80x60
  stone 2 slate --camera front --size 400x300 --light 20,60
  stone 3 baltic_brown --camera front --size 240x180
  stone 4 rosso_verona --camera front --size 320x240
  stone 5 travertino --camera front --size 320x240
  stone 6 calacatta --camera front --size 1600x1200
  stone 7 rosso_levanto --camera front --size 400x300
  stone 8 terrazzo --camera front --size 160x120
  stone 9 rosa_beta --camera front --size 80x60 -p finish=flamed --light 20,24
  stone 10 granite_fan --camera front --size 1400x1050 --light 35,28 --sky 0.6
  stone 11 ishidatami --camera -50,42,14 --zoom 5 --size 12000x9000 -p layout=chidori \
    -p stone_length=600 -p stone_width=300 -p moss=0.42 -p moss_spread=30
  stone 12 araidashi --camera front --size 100x75 --light 30,30
  sheet stones
}

# Red felt, grey felt, fleece, cashmere; denim, tweed, linen, burlap; silk satin, velvet, flannel, coir
draw_fibres() {
  local number=0 preset size
  for preset in felt:12x9 felt_grey:60x45 fleece:10x7.5 cashmere:8x6 denim:12x9 tweed:30x22.5 \
    linen:10x7.5 burlap:24x18 silk_satin:6x4.5 velvet:160x120 flannel:16x12 coir:60x45; do
    size=${preset#*:}
    tile $((number += 1)) fiber "${preset%:*}" --camera front --size "$size"
  done
  sheet fibres
}

draw_log() {
  "$sozai" saw --species akamatsu --log-length 1800 --res 880x480 -o "$scratch/log"
  cp "$scratch/log/log.png" "$folder/log.png"
}

# Akamatsu, kuromatsu, sugi, hinoki; Douglas fir, mizunara, yamazakura, shirakaba: their feet
draw_barks() {
  local number=0 species age height zoom
  while read -r species age height zoom; do
    "$sozai" grow tree --species "$species" --age "$age" -p foliage=none -p orders=1 \
      --camera 25,2,20 --target "0,$height,0" --zoom "$zoom" --res 300x400 --spp 32 \
      -o "$scratch/bark$((number += 1)).png"
  done <<<'akamatsu 32 2200 13
kuromatsu 60 900 16
sugi 60 900 18
hinoki 60 900 18
douglas_fir 80 900 14
mizunara 90 900 16
cherry 40 900 15
shirakaba 60 1500 13'
  oiiotool "$scratch"/bark{1,2,3,4,5,6,7,8}.png --mosaic 4x2 "${untold[@]}" -d uint8 -o "$folder/barks.png"
}

# Keyaki, mizunara, yamazakura, momiji, shirakaba: where limbs leave their stems
draw_collars() {
  local number=0 species age view target zoom
  while read -r species age view target zoom; do
    "$sozai" grow tree --species "$species" --age "$age" -p foliage=none -p orders=1 \
      --camera "$view,20" --target "$target" --zoom "$zoom" --res 240x360 --spp 32 \
      -o "$scratch/collar$((number += 1)).png"
  done <<<'keyaki 60 60,15 -60,4800,0 26
mizunara 90 25,10 0,7350,0 24
cherry 40 25,5 0,3900,0 16
momiji 50 25,25 0,1650,0 18
shirakaba 60 25,5 -60,10000,0 40'
  oiiotool "$scratch"/collar{1,2,3,4,5}.png --mosaic 5x1 "${untold[@]}" -d uint8 -o "$folder/collars.png"
}

# Sheets of the whole gallery, as they are there but for figured.
draw_sheet() {
  [[ -d $scratch/gallery ]] || "$sozai" gallery --all -o "$scratch/gallery"
  local -r from=$scratch/gallery/$1.png
  if [[ $1 == figured ]]; then
    oiiotool "$from" --resize 960x344 "${untold[@]}" -d uint8 -o "$folder/$1.png"
  else
    cp "$from" "$folder/$1.png"
  fi
}

names=("$@")
(($#)) || names=(stones fibres log barks collars gallery figured plies knots layouts trees)
for name in "${names[@]}"; do
  case $name in
    stones | fibres | log | barks | collars) "draw_$name" ;;
    gallery | figured | plies | knots | layouts | trees) draw_sheet "$name" ;;
    *)
      echo "no picture $name: stones, fibres, log, barks, collars, gallery, figured, plies, knots, layouts or trees" >&2
      exit 1
      ;;
  esac
  echo "drawn: $folder/$name.png"
done
