#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Displays, views and looks by name: the pictures are what oiiotool makes of the
# same scene-linear numbers, files say what their colours are, and names that
# the config lacks are refused before the work.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly shipped=$4
command -v oiiotool >/dev/null || { echo "skipped: no oiiotool"; exit 77; }
cd "$scratch" || exit 1

# The shipped config, with two displays and two looks, and another working space.
sed -e 's/scene_linear: .*/scene_linear: ACEScg/' \
  -e 's/^active_views: .*/looks:\n  - !<Look> {name: warm, process_space: Linear Rec.709, transform: !<CDLTransform> {slope: [1.3, 1, 0.7]}}\n  - !<Look> {name: dim, process_space: Linear Rec.709, transform: !<CDLTransform> {slope: [0.5, 0.5, 0.5]}}\n/' \
  -e 's/^active_displays: .*//' \
  -e 's/^displays:/displays:\n  Other:\n    - !<View> {name: Log, colorspace: ACEScct}\n    - !<View> {name: Warm, colorspace: sRGB, looks: warm}/' \
  "$shipped" >other.ocio
# Nor can this one say where its working space lies.
sed -e '/aces_interchange/d' -e '/cie_xyz_d65_interchange/d' "$shipped" >mute.ocio

readonly small=(wood --preset keyaki --res 64x48 --spp 4)

# ---- what files say -----------------------------------------------------------
attributes() { oiiotool --info -v "$1" | grep -E '^ *(chromaticities|colorSpace|oiio:ColorSpace):' | sed 's/^ *//'; }
works render "${small[@]}" --channels dive -o plain.exr
same "an EXR's space" 'colorSpace: "Linear Rec.709"' "$(attributes plain.exr | grep '^colorSpace')"
same "its chromaticities" 'chromaticities: 0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329' \
  "$(attributes plain.exr | grep chromaticities)"
works render "${small[@]}" --channels dive --config other.ocio -o acescg.exr
same "another working space" 'colorSpace: "ACEScg"' "$(attributes acescg.exr | grep '^colorSpace')"
# shellcheck disable=SC2016 # awk's own $
check "its chromaticities" awk -F'[:,]' '
  /chromaticities/ { n = split("0.713 0.293 0.165 0.83 0.128 0.044 0.32168 0.33767", w, " ")
    for (i = 1; i <= n; i++) { d = $(i + 1) - w[i]; if (d < -2e-5 || d > 2e-5) bad = 1 }
    found = 1 }
  END { exit bad || !found }' <(attributes acescg.exr)
works render "${small[@]}" --channels dive --config mute.ocio -o mute.exr
same "where the config cannot say" "" "$(attributes mute.exr | grep chromaticities)"
same "the name is there all the same" 'colorSpace: "Linear Rec.709"' "$(attributes mute.exr | grep '^colorSpace')"

chunks() { # the types of a PNG's chunks before its pixels
  head -c 400 "$1" | grep -aoE 'sRGB|gAMA|cHRM' | sort -u | tr '\n' ' '
}
works render "${small[@]}" -o shown.png
check "a PNG for an sRGB display says so" grep -q sRGB <(chunks shown.png)
works render "${small[@]}" --view Raw -o raw.png
same "raw numbers do not" "" "$(chunks raw.png)"
works render "${small[@]}" --config other.ocio -o log.png
same "nor does what is for another display" "" "$(chunks log.png)"

# ---- the numbers are OpenColorIO's ------------------------------------------------
# The EXR is in half: a step of 8 bits is allowed.
compare() { # picture, linear picture, config, display, view, looks in place of the view's
  OCIO=$3 oiiotool "$2" --ch R,G,B --iscolorspace scene_linear \
    ${6:+--ociolook:from=scene_linear:to=scene_linear "$6"} --ociodisplay "$4" "$5" -d uint8 -o "wanted-$1" 2>oiiotool.log ||
    failed "oiiotool: $(<oiiotool.log)"
  checks=$((checks + 1))
  oiiotool --hardfail 0.00393 --fail 0.00393 "$1" "wanted-$1" --diff >diff.log 2>&1 ||
    failed "$1 is not what oiiotool makes of $2: $(<diff.log)"
}
compare shown.png plain.exr "$shipped" sRGB sozai
compare raw.png plain.exr "$shipped" sRGB Raw
works render "${small[@]}" --display sRGB --view Standard -o standard.png
compare standard.png plain.exr "$shipped" sRGB Standard
compare log.png acescg.exr other.ocio Other Log
works render "${small[@]}" --config other.ocio --view Warm -o warm.png
compare warm.png acescg.exr other.ocio Other Warm
works render "${small[@]}" --config other.ocio --display sRGB -o second.png
compare second.png acescg.exr other.ocio sRGB sozai
works render "${small[@]}" --config other.ocio --display sRGB --view Standard --look warm -o look.png
compare look.png acescg.exr other.ocio sRGB Standard warm
works render "${small[@]}" --config other.ocio --display sRGB --view Standard --look 'warm, -dim' -o looks.png
compare looks.png acescg.exr other.ocio sRGB Standard warm,-dim
works render "${small[@]}" --config other.ocio --view Warm --look '' -o none.png
for other in raw standard; do check "shown and $other differ" not cmp -s shown.png "$other.png"; done
check "a look changes the picture" not cmp -s second.png look.png
check "two looks differ from one" not cmp -s look.png looks.png
check "--look '' leaves the view's own out" not cmp -s warm.png none.png
check "names in any case of letters" "$sozai" render "${small[@]}" --display srgb --view STANDARD -o case.png
check "they are the same" cmp standard.png case.png

# ---- figures --------------------------------------------------------------------------
works figures wood -o figures
works figures wood --view Raw -o figures-raw
check "figures through a view" not cmp -s figures/wood-07.png figures-raw/wood-07.png
check "ink is no colour" cmp figures/wood-05.png figures-raw/wood-05.png
check "figures say that they are sRGB" grep -q sRGB <(chunks figures/wood-07.png)

# ---- names that there are not, before hours of work --------------------------------------
readonly long=(wood --res 16384x16384 --spp 4096 -o late.png)
refuses 2 "--display|'Wall'|sRGB" render "${long[@]}" --display Wall
refuses 2 "--view|'Filmic'|display sRGB|sozai, Standard, Raw" render "${long[@]}" --view Filmic
refuses 2 "--look|'warm'|there is none" render "${long[@]}" --look warm
refuses 2 "--display|'Wall'|Other, sRGB" render "${long[@]}" --config other.ocio --display Wall
refuses 2 "--view|'sozai'|display Other|Log, Warm" render "${long[@]}" --config other.ocio --view sozai
refuses 2 "--look|'cold'|warm, dim" render "${long[@]}" --config other.ocio --look 'warm, -cold'
refuses 2 "--view|a PNG|'late.exr'" render wood -o late.exr --res 16384x16384 --view Filmic
refuses 2 "--view|'Filmic'" figures -o late --view Filmic
refuses 2 "--display|'Wall'" gallery -o late --display Wall
same "nothing is made of them" "" "$(find . -name '*late*' -o -name '.sozai-*')"
cd / || exit 1
finish
