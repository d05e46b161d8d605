#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# colour: which config is in force and why, what it offers, and what materials
# and files ask of it.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly json_check=$4 shipped=$5
sed -e 's/scene_linear: .*/scene_linear: ACEScg/' -e 's/^    aliases: \[sRGB - Texture.*//' \
  -e 's/^    name: sRGB$/    name: Encoded/; s/: sRGB$/: Encoded/; s/colorspace: sRGB}/colorspace: Encoded}/' \
  "$shipped" >"$scratch/lacking.ocio"

holds() { # line that the output must have, blanks squeezed
  checks=$((checks + 1))
  sed 's/  */ /g; s/^ //' "$scratch/out" | grep -qxF -- "$1" || failed "no line '$1' in:"$'\n'"$out"
}

# ---- which, and why -------------------------------------------------------------
works colour
holds "config $(dirname "$SOZAI_PLUGIN")/sozai.ocio"
holds "chosen shipped with sozai"
holds "working space Linear Rec.709"
holds "green x 0.30000 y 0.60000"
holds "scene_linear Linear Rec.709"
holds "ACEScg scene-linear"
holds "sRGB (default)"
holds "sozai (default)"
holds "Standard"
holds "in use: wood"
holds "sRGB -> sRGB"
check "presets by their names" grep -q 'defaults, onigurumi, .*keyaki' "$scratch/out"
works colour --config "$shipped"
holds "chosen given with --config"
export OCIO=$scratch/lacking.ocio
works colour
holds "chosen \$OCIO"
holds "working space ACEScg"
holds "red x 0.71300 y 0.29300"
holds "sRGB -> MISSING: the config has no such space"
unset OCIO

# ---- what is asked of it ------------------------------------------------------------
works colour wood --preset keyaki -p 'earlywood_colour=0.5 0.4 0.3 @ lin_rec709' \
  -p 'latewood_colour=0.2 0.1 0.1@scene_linear' -p 'vessel_colour=0.1 0.1 0.1 @ Nope'
holds "in use: wood"
holds "lin_rec709 -> Linear Rec.709"
holds "scene_linear -> Linear Rec.709"
holds "Nope -> MISSING: the config has no such space"
check "it lists nothing of other materials" not grep -q defaults "$scratch/out"
printf 'material: wood\nparams:\n  earlywood_colour: "0.5 0.4 0.3 @ acescg"\n' >"$scratch/some.sozai"
works colour "$scratch/some.sozai"
holds "in use: $scratch/some.sozai"
holds "acescg -> ACEScg"
holds "knot_colour, knot_bark_colour, parenchyma_colour, sapwood_parenchyma_colour, ray_colour, canal_colour, latewood_colour, vessel_colour, sapwood_earlywood_colour, sapwood_latewood_colour, sapwood_vessel_colour, pigment_colour, streak_colour, aged_colour, grey_colour, joint_colour, glue_colour"

# ---- JSON ---------------------------------------------------------------------------
json() { works colour --json "$@" && check "JSON of: $*" "$json_check" "$scratch/out"; }
json --config "$scratch/lacking.ocio"
check "a space that is missing is null" grep -q '"resolved": null' "$scratch/out"
json wood -p 'vessel_colour=0 0 0 @ a"b'
check "a name as it is" grep -q '"name": "a\\"b"' "$scratch/out"
json
for member in '"config":' '"chosen": "shipped with sozai"' '"working_space": "Linear Rec.709"' \
  '"chromaticities": {' '"roles": \[' '"spaces": \[' '"displays": \[' '"views": \[' '"looks": \[' \
  '"in_use": \[' '"resolved": "sRGB"' '"default": true'; do
  check "JSON has $member" grep -q -- "$member" "$scratch/out"
done

# ---- refusals ----------------------------------------------------------------------------
refuses 2 "none.ocio" colour --config "$scratch/none.ocio"
refuses 2 "unknown material 'ood'|wood" colour ood
refuses 2 "preset 'no_such_wood'" colour wood --preset no_such_wood
refuses 2 "parameter 'tint'" colour wood -p tint=1
refuses 2 "--preset" colour --preset keyaki
refuses 2 "unexpected argument 'two'" colour one two
refuses 2 "cannot read" colour "$scratch/none.sozai"
"$sozai" colour >/dev/full 2>"$scratch/err"
same "exit code for a full disk" 1 $?
finish
