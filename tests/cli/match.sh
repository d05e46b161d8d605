#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# match: palettes that are known come back from pictures made with them, and
# what is no photograph of a material is refused.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly shipped=$4
command -v oiiotool >/dev/null || { echo "skipped: no oiiotool"; exit 77; }
cd "$scratch" || exit 1

# photograph NAME [option...]: the albedo of a board of 120 x 80 mm, without rays and parenchyma, of as many samples
# to a pixel as the filter's own error allows. Of 4, each under 0.1 mm, vessels have a ninth too
# much variance; of 64 it is what a camera integrates.
samples=4
readonly bare=(-p marginal_parenchyma=0 -p paratracheal_parenchyma=0 -p parenchyma_band_width=0 -p vessel_band_parenchyma=0)
photograph() {
  local name=$1
  shift
  "$sozai" render wood --cut flat --shape plane --size 120x80 --camera front --res 600x400 --spp "$samples" \
    --sky 0 -p ray_density=0 -p pigment=0 "${bare[@]}" --channels albedo -o layers.exr "$@" || failed "no picture $name"
  oiiotool layers.exr --ch albedo.R,albedo.G,albedo.B --chnames R,G,B -o "$name"
}

colour_of() { # parameter, in the last output: its sRGB
  awk -v name="$1" '$1 == name { print $2, $3, $4 }' out
}
near() { # what, tolerance, wanted "r g b", got
  checks=$((checks + 1))
  awk -v t="$2" -v w="$3" -v g="$4" 'BEGIN {
    n = split(w, a, " "); if (split(g, b, " ") != n) exit 1
    for (i = 1; i <= n; i++) { d = a[i] - b[i]; if (d > t || d < -t) exit 1 } }' ||
    failed "$1: wanted $3 within $2, got $4"
}
agrees() { # what, most dE2000 of the means, most relative difference of the covariances
  checks=$((checks + 1))
  awk -v de="$2" -v cov="$3" '
    match($0, /dE2000 [0-9.]+$/) { n++; if (substr($0, RSTART + 7) + 0 > de) bad = 1 }
    match($0, /relative difference [0-9.]+$/) { n++; if (substr($0, RSTART + 20) + 0 > cov) bad = 1 }
    END { exit bad || n < 2 }' out ||
    failed "$1: beyond dE2000 $2 or relative difference $3:"$'\n'"$(<out)"
}

readonly early="0.7200 0.5500 0.3800" late="0.5500 0.3800 0.2400" vessel="0.3500 0.2200 0.1300"
readonly known=(-p "earlywood_colour=$early @ sRGB" -p "latewood_colour=$late @ sRGB" -p "vessel_colour=$vessel @ sRGB")

# ---- a palette that is known -------------------------------------------------------
photograph known.exr --preset keyaki "${known[@]}"
works match known.exr --preset keyaki --width 120 -o known.sozai
agrees "the same board" 0.05 0.005
near "earlywood" 0.005 "$early" "$(colour_of earlywood_colour)"
near "latewood" 0.015 "$late" "$(colour_of latewood_colour)"
near "vessels" 0.03 "$vessel" "$(colour_of vessel_colour)"
check "one wood" grep -q '^parts *one' out
check "fibre brightness as it was" grep -q 'fibre_brightness.*0.1700.*preset' out

samples=64
photograph fine.exr --preset keyaki "${known[@]}"
works match fine.exr --preset keyaki --width 120
near "vessels as a camera sees them" 0.015 "$vessel" "$(colour_of vessel_colour)"

# Boards of other trees, and other species. From one tree to the next vessels come out with a
# standard deviation of 0.03, as the boards' own share of vessels has one: their mean is told.
samples=16
: >vessels
for tree in 2 3 4 5 7; do
  photograph other.exr --preset keyaki -p seed=$tree -p cut_distance=85 "${known[@]}"
  works match other.exr --preset keyaki --width 120
  agrees "a board of tree $tree" 0.05 0.01
  near "its earlywood" 0.02 "$early" "$(colour_of earlywood_colour)"
  near "its latewood" 0.04 "$late" "$(colour_of latewood_colour)"
  near "its vessels" 0.09 "$vessel" "$(colour_of vessel_colour | tee -a vessels)"
done
near "vessels, mean of five trees" 0.04 "$vessel" \
  "$(awk '{ for (i = 1; i <= 3; i++) sum[i] += $i } END { print sum[1] / NR, sum[2] / NR, sum[3] / NR }' vessels)"
samples=4
photograph onigurumi.exr --preset onigurumi -p seed=3 "${known[@]}"
works match onigurumi.exr --preset onigurumi --width 120
agrees "a semi-ring-porous board" 0.05 0.01
near "its earlywood" 0.03 "$early" "$(colour_of earlywood_colour)"
photograph sugi.exr --preset sugi -p seed=3 "${known[@]}"
works match sugi.exr --preset sugi --width 120
agrees "a softwood's board" 0.05 0.01
near "its earlywood" 0.005 "$early" "$(colour_of earlywood_colour)"
# which is the deepest at a ring's end alone
near "its latewood" 0.03 "$late" "$(colour_of latewood_colour)"
check "it has no vessels to tell a colour by" grep -q 'vessel_colour.*too little' out

# Livelier fibres.
photograph lively.exr --preset keyaki -p fibre_brightness=0.3 -p seed=4
works match lively.exr --preset keyaki --width 120
agrees "lively fibres" 0.05 0.01
near "their brightness" 0.05 0.3 "$(awk '$1 == "fibre_brightness" { print $2 }' out)"

# What is given is kept.
works match known.exr --preset keyaki --width 120 -p "vessel_colour=$vessel @ sRGB" -p fibre_brightness=0.17
check "a colour as given" grep -q 'vessel_colour.*as given' out
near "which helps the others" 0.002 "$early" "$(colour_of earlywood_colour)"
near "which helps the others" 0.005 "$late" "$(colour_of latewood_colour)"

# ---- the file ----------------------------------------------------------------------------
check "statistics as comments" grep -q '^# .*relative difference' known.sozai
works render known.sozai --camera front --res 150x100 --spp 1 --channels albedo -o again.exr
works render known.sozai --camera front --res 600x400 --spp 4 --sky 0 --channels albedo -o again.exr
oiiotool again.exr --ch albedo.R,albedo.G,albedo.B --chnames R,G,B -o shown.exr
works match shown.exr --preset keyaki --width 120
agrees "what the file shows, matched again" 0.05 0.005
works match known.exr --preset keyaki --width 120 -p 'object=a"b\c' -o quoted.sozai
works describe quoted.sozai
cp known.exr $'new\nline.exr'
works match $'new\nline.exr' --preset keyaki -o line.sozai
works describe line.sozai
cp known.exr $'raw\xff\xe2\x80\xa8line.exr'
works match $'raw\xff\xe2\x80\xa8line.exr' --preset keyaki -o raw.sozai
works describe raw.sozai
check "what is no text of a name is not in it" grep -q 'photograph *raw??line.exr' raw.sozai
works match known.exr --preset keyaki -p $'object=\xc2\x85 \xc3\xa9' -o object.sozai
works describe object.sozai
refuses 2 "object|UTF-8" match known.exr --preset keyaki -p $'object=\xff' -o none.sozai
check "no file of it" test ! -e none.sozai
# A path is this folder's, wherever the file is.
mkdir -p sub
works match known.exr --preset keyaki -p section=known.exr -o sub/path.sozai
check "a whole path" grep -qF "section: \"$PWD/known.exr\"" sub/path.sozai
works render sub/path.sozai --res 8x8 --spp 1 -o path.png

# ---- integers, spaces, parts -----------------------------------------------------------------
OCIO=$shipped oiiotool known.exr --iscolorspace scene_linear --tocolorspace sRGB -d uint8 -o known.png
works match known.png --preset keyaki --width 120
check "PNG is sRGB by the file rules" grep -q 'read as sRGB' out
near "a PNG's earlywood" 0.01 "$early" "$(colour_of earlywood_colour)"
sed -e 's/scene_linear: .*/scene_linear: ACEScg/' "$shipped" >acescg.ocio
works match known.png --preset keyaki --width 120 --config acescg.ocio -o acescg.sozai
agrees "in another working space" 0.05 0.01
near "the same sRGB there" 0.02 "$early" "$(colour_of earlywood_colour)"
sed -e 's/{name: Default, colorspace: sRGB}/{name: Default, colorspace: ACEScct}/' "$shipped" >rules.ocio
works match known.png --preset keyaki --config rules.ocio
check "another config's file rules" grep -q 'read as ACEScct' out
works match known.png --preset keyaki --space Raw
check "a space by its name" grep -q 'read as Raw' out

oiiotool known.exr --crop 300x200+100+100 -o part.exr
works match part.exr --preset keyaki --width 60
grep -v '^photograph' out >part
works match known.exr --preset keyaki --width 120 --crop 100,100,300,200
same "--crop is the part" "$(<part)" "$(grep -v '^photograph' out)"

# A black border, and highlights of one percent.
oiiotool known.exr --pattern constant:color=0,0,0 700x480 3 --paste +60+40 --fill:color=4,4,4 50x48+300+200 -d half -o lit.exr
works match known.exr --preset keyaki --width 120
awk '/^mean/ { getline; print $1, $2, $3 }' out >clean
works match lit.exr --preset keyaki --width 140
near "the mean without border and highlights" 0.004 "$(<clean)" "$(awk '/^mean/ { getline; print $1, $2, $3 }' out)"
check "what was left out is said" grep -qE 'left out: 2[0-9]\.[0-9]* % as black, 0\.[5-9]' out

# Light from one side.
oiiotool --pattern fill:left=0.6,0.6,0.6:right=1.4,1.4,1.4 600x400 3 known.exr --mul -o slanted.exr
works match slanted.exr --preset keyaki --width 120 --even-light
check "slanting light is one wood" grep -q '^parts *one' out
near "earlywood under even light" 0.03 "$early" "$(colour_of earlywood_colour)"
works match slanted.exr --preset keyaki --width 120
check "and without it" grep -q '^parts *one' out

# ---- heartwood and sapwood -----------------------------------------------------------------------
readonly pale="0.8500 0.7400 0.5600" pale_late="0.7200 0.5800 0.4000"
photograph heart.exr --preset keyaki "${known[@]}"
photograph sap.exr --preset keyaki -p seed=5 -p "earlywood_colour=$pale @ sRGB" \
  -p "latewood_colour=$pale_late @ sRGB" -p "vessel_colour=$vessel @ sRGB"
oiiotool heart.exr sap.exr --mosaic 2x1 -o both.exr
works match both.exr --preset keyaki --width 240 -o both.sozai
check "two woods" grep -q '^parts *two' out
check "half of it heartwood" grep -qE 'heartwood: (4[5-9]|50) %' out
agrees "both" 0.1 0.02
near "heartwood" 0.02 "$early" "$(colour_of earlywood_colour)"
near "sapwood" 0.03 "$pale" "$(colour_of sapwood_earlywood_colour)"
near "its latewood" 0.04 "$pale_late" "$(colour_of sapwood_latewood_colour)"
check "where one becomes the other" grep -q 'heartwood_years:' both.sozai
works render both.sozai --camera front --res 64x32 --spp 1 -o both.png

# ---- stone ---------------------------------------------------------------------------------------
readonly base="0.7000 0.6600 0.6200" second="0.5000 0.4700 0.4600" mica="0.1600 0.1500 0.1500"
readonly ground=(-p third_share=0 -p black_share=0.08 -p white_share=0.05)
readonly stone=(-p "base_colour=$base @ sRGB" -p "second_colour=$second @ sRGB" -p "black_colour=$mica @ sRGB")
granite() { # NAME [option...]: the albedo of a face of 120 x 80 mm
  local name=$1
  shift
  "$sozai" render stone --preset inada --shape plane --size 120x80 --camera front --res 600x400 \
    --spp 4 --sky 0 --channels albedo -o layers.exr "${ground[@]}" "${stone[@]}" "$@" || failed "no picture $name"
  oiiotool layers.exr --ch albedo.R,albedo.G,albedo.B --chnames R,G,B -o "$name"
}
granite granite.exr
works match granite.exr --material stone --preset inada --width 120 "${ground[@]}" -o granite.sozai
agrees "the same granite" 0.05 0.01
near "its base" 0.01 "$base" "$(colour_of base_colour)"
near "its second mineral" 0.02 "$second" "$(colour_of second_colour)"
near "its mica" 0.05 "$mica" "$(colour_of black_colour)"
works render granite.sozai --camera front --res 64x64 --spp 1 -o granite.png
granite other-block.exr -p seed=9
works match other-block.exr --material stone --preset inada --width 120 "${ground[@]}"
agrees "a face of another block" 0.1 0.02
near "its base" 0.03 "$base" "$(colour_of base_colour)"
near "its second mineral" 0.05 "$second" "$(colour_of second_colour)"
near "its mica" 0.08 "$mica" "$(colour_of black_colour)"

# ---- refusals --------------------------------------------------------------------------------------
cp known.sozai kept.sozai
oiiotool --create 1x1 3 -d uint8 -o one.png
oiiotool --pattern constant:color=0.5,0.3,0.2 200x100 3 -d uint8 -o flat.png
oiiotool --pattern constant:color=0,0,0 200x100 3 -d uint8 -o black.png
oiiotool known.png --ch R -o grey.png
oiiotool known.png --ch R,R,R --chnames R,G,B -o greys.png
oiiotool known.png --ch R,G,B,=0 --chnames R,G,B,A -o clear.png
oiiotool --pattern constant:color=nan,nan,nan 64x64 3 known.exr --paste +9+9 -d float -o nan.exr
python3 - <<'EOF' # a TIFF of 20000x20000 that is all hole
import struct
entries = [(256, 4, 1, 20000), (257, 4, 1, 20000), (258, 3, 3, 200), (259, 3, 1, 1), (262, 3, 1, 2), (273, 4, 1, 256),
           (277, 3, 1, 3), (278, 4, 1, 20000), (279, 4, 1, 1200000000), (284, 3, 1, 1)]
with open("huge.tif", "wb") as f:
    f.write(struct.pack("<2sHIH", b"II", 42, 8, len(entries)) + b"".join(struct.pack("<HHII", *e) for e in entries))
    f.seek(200)
    f.write(struct.pack("<HHH", 8, 8, 8))
    f.truncate(1200000256)
EOF
oiiotool known.png -o whole.jpg
head -c 9000 whole.jpg >cut.jpg
head -c 9000 known.exr >cut.exr
head -c 9000 known.png >cut.png
: >empty.png
echo hello >text.jpg
mkdir folder.jpg
bad() { # words, photograph, option...
  run_command match "${@:2}" -o kept.sozai
  same "exit code of: match ${*:2}" 2 "$code"
  local word
  while IFS= read -r word; do
    check "'$word' in: $err" grep -qF -- "$word" err
  done < <(tr '|' '\n' <<<"$1")
}
bad "none.jpg" none.jpg
bad "folder.jpg" folder.jpg
bad "empty.png" empty.png
bad "text.jpg" text.jpg
bad "cut.jpg|end of" cut.jpg
bad "cut.exr" cut.exr
bad "cut.png" cut.png
bad "one.png|1 pixel|1024" one.png
bad "flat.png|one colour" flat.png
bad "black.png" black.png
bad "grey.png|1 channel" grey.png
bad "greys.png|grey" greys.png
bad "clear.png|transparent" clear.png
bad "nan.exr|not finite" nan.exr
bad "huge.tif|20000x20000|67108864" huge.tif
bad "--space|nope" known.png --space nope
bad "--material|'glass'|wood" known.png --material glass
bad "--crop|'1,2,3'" known.png --crop 1,2,3
bad "--crop|0,0,601,10|600x400" known.png --crop 0,0,601,10
bad "--crop|-1" known.png --crop=-1,0,50,50
bad "300 pixels|1024" known.png --crop 0,0,3,100
bad "--width|'0'|0.1|100000" known.png --width 0
bad "no_such_wood" known.png --preset no_such_wood
bad "ring_width|-3|0.2" known.png -p ring_width=-3
bad "widht" known.png -p widht=3
check "the file that was there is untouched" cmp known.sozai kept.sozai
refuses 2 "--output|'x.txt'|.sozai" match known.png -o x.txt
refuses 2 "cannot write|nowhere" match known.png -o nowhere/x.sozai
refuses 2 "no photograph" match
same "nothing half-made" "" "$(find . -name '.*sozai')"
cd / || exit 1
finish
