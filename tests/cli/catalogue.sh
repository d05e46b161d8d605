#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The printed catalogues of parameters and presets are the plugin's own, and the
# figures can be drawn, each with its numbers.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly json_check=$4
printed=$(dirname -- "${BASH_SOURCE[0]}")/../../docs

for material in wood stone fiber; do
  file=catalogue-$material.txt
  works describe "$material"
  check "docs/$file is current (renew it: sozai describe $material > docs/$file)" \
    cmp "$scratch/out" "$printed/$file"
done

# those of fibre take minutes: what is in them is tested with the strands
for which in wood stone tree-sawn; do works figures "$which" -o "$scratch/figures"; done
# shellcheck disable=SC2016
check "knots are where the branches are" awk -F'[:,]' \
  '/branches_that_cross/ { said = $2 } /of_which_are_knots/ { seen = $2 }
   END { exit !(said > 0 && said == seen) }' "$scratch/figures/tree-sawn.json"
for figure in wood-05 wood-06 wood-07 wood-09 stone-05 stone-06 tree-sawn; do
  check "$figure.png" test -s "$scratch/figures/$figure.png"
  check "$figure.json" "$json_check" "$scratch/figures/$figure.json"
done
# the highlights lie where the dive angle is the light's, to a tenth of a mm
# shellcheck disable=SC2016 # awk's own $2
check "figure 9's highlights" awk -F'[:,]' \
  '/mean_distance_mm/ { n++; if ($2 < 0 || $2 > 0.1) bad = 1 } END { exit !(n == 3 && !bad) }' \
  "$scratch/figures/wood-09.json"
# the highest code is 256 whatever dh is, less what a pixel's footprint smooths; and the plane's corners are where they were put
# shellcheck disable=SC2016
check "figure 5's heights" awk -F'[:,]' \
  '/highest_code/ { n++; if ($2 < 235 || $2 > 256.1) bad = 1 } END { exit !(n == 5 && !bad) }' \
  "$scratch/figures/stone-05.json"
# shellcheck disable=SC2016
check "figure 6's corners" awk -F'[:,]' \
  '/corner_error_mm/ { n++; if ($2 < 0 || $2 > 1e-6) bad = 1 } END { exit !(n == 1 && !bad) }' \
  "$scratch/figures/stone-06.json"
finish
