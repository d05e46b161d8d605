#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# match of a stone: shares of specks and of minerals that are known come back
# from pictures made with them, of other blocks than the preset's.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
command -v oiiotool >/dev/null || { echo "skipped: no oiiotool"; exit 77; }
cd "$scratch" || exit 1

readonly colours=(-p "base_colour=0.70 0.66 0.62 @ sRGB" -p "second_colour=0.50 0.47 0.46 @ sRGB"
  -p "black_colour=0.16 0.15 0.15 @ sRGB" -p third_share=0)
granite() { # NAME [option...]: the albedo of a face of 120 x 80 mm
  local name=$1
  shift
  "$sozai" render stone --preset inada --shape plane --size 120x80 --camera front --res 600x400 \
    --spp 4 --sky 0 --channels albedo -o layers.exr "${colours[@]}" "$@" || failed "no picture $name"
  oiiotool layers.exr --ch albedo.R,albedo.G,albedo.B --chnames R,G,B -o "$name"
}
value_of() { awk -v name="$1" '$1 == name { print $2 }' out; } # parameter, in the last output
within() { # what, least, most, got
  checks=$((checks + 1))
  awk -v a="$2" -v b="$3" -v got="$4" 'BEGIN { exit !(got != "" && got + 0 >= a && got + 0 <= b) }' ||
    failed "$1: wanted $2 to $3, got $4"
}

# Specks are so few on such a face that from block to block a tenth of their area comes and goes, of
# a thirtieth twice that: their mean is told.
: >ratios
for share in 0.03 0.08 0.14; do
  for seed in 1 9; do
    granite block.exr -p seed=$seed -p black_share=$share
    works match block.exr --material stone --preset inada --width 120
    got=$(value_of black_share)
    within "specks of $share, block $seed" "$(awk "BEGIN { print 0.75 * $share }")" \
      "$(awk "BEGIN { print 1.25 * $share }")" "$got"
    within "no white specks" 0 0.01 "$(value_of white_share)"
    within "the second mineral" 0.28 0.38 "$(value_of second_share)"
    within "how far the ranks lie apart" 0 0.02 \
      "$(awk '/^shares/ { print $4 }' out)"
    awk "BEGIN { print $got / $share }" >>ratios
  done
done
within "specks, mean of all over what was asked for" 0.9 1.1 \
  "$(awk '{ sum += $1 } END { print sum / NR }' ratios)"

# Kinds that the preset has not, or that the stone has not.
granite white.exr -p seed=4 -p black_share=0.04 -p white_share=0.05
works match white.exr --material stone --preset inada --width 120 -o white.sozai
within "black specks beside white ones" 0.03 0.05 "$(value_of black_share)"
within "white specks beside black ones" 0.04 0.06 "$(value_of white_share)"
check "the file has them" grep -q '^  white_share: "0.0' white.sozai
granite none.exr -p seed=5 -p black_share=0
works match none.exr --material stone --preset inada --width 120
within "none" 0 0.002 "$(value_of black_share)"

# Crystals that vary twice as much do not pass for specks.
granite lively.exr -p seed=4 -p grain_variation=0.2 -p black_share=0.09
works match lively.exr --material stone --preset inada --width 120
within "specks among lively crystals" 0.07 0.11 "$(value_of black_share)"
within "the crystals' variation" 0.17 0.23 "$(value_of grain_variation)"

# A third mineral, its share and its colour; where there is none, what the second leaves is the base's.
for seed in 1 9; do
  granite third.exr -p seed=$seed -p black_share=0.08 -p third_share=0.2 \
    -p "third_colour=0.78 0.62 0.55 @ sRGB"
  works match third.exr --material stone --preset inada --width 120
  within "the third mineral, block $seed" 0.15 0.25 "$(value_of third_share)"
  within "the second beside it" 0.28 0.38 "$(value_of second_share)"
  within "specks beside it" 0.06 0.1 "$(value_of black_share)"
  within "its red" 0.75 0.81 "$(value_of third_colour)"
  within "the base's red" 0.68 0.72 "$(value_of base_colour)"
  within "its green" 0.59 0.65 "$(awk '$1 == "third_colour" { print $3 }' out)"
  within "its blue" 0.52 0.58 "$(awk '$1 == "third_colour" { print $4 }' out)"
done
granite two.exr -p seed=1 -p black_share=0.08
works match two.exr --material stone --preset inada --width 120
within "no third mineral" 0 0.02 "$(value_of third_share)"
within "the base's red" 0.68 0.72 "$(value_of base_colour)"

# What is given is kept.
works match lively.exr --material stone --preset inada --width 120 -p black_share=0.04
check "a share as given" grep -q 'black_share  *0.0400  as given' out
works match lively.exr --material stone --preset inada --width 120 -p black_share=0.09 -p white_share=0 \
  -p second_share=0.33 -p third_share=0
check "nothing to look for" test "$(grep -c '^shares' out)" = 0

# Mica near black is the stone's, a border as dark is not.
granite dark.exr -p seed=9 -p black_share=0.08 -p "black_colour=0.03 0.03 0.03 @ sRGB"
oiiotool dark.exr --pattern constant:color=0.003,0.003,0.003 660x460 3 --paste +30+30 -d half -o framed.exr
works match framed.exr --material stone --preset inada --width 132
within "the border, and no more" 20.5 22 "$(awk '/left out/ { print $3 }' out)"
within "its specks" 0.06 0.1 "$(value_of black_share)"
cd / || exit 1
finish
