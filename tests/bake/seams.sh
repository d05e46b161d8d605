#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Seen through its UVs alone, a baked mesh shows the wood that is at each of
# its points, and no less so along the seams.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
readonly make_mesh=$4 look_up=$5
cd "$scratch" || exit 1

# The mean and the largest difference between what is looked up in a picture
# and what the material answers at the same points.
compare() { # mesh picture where
  "$look_up" "$1" "$2" 4000 "$3" || failed "look-up"
  works eval wood --preset keyaki -i points.csv -o evaluated.csv --channels albedo
  paste -d, looked-up.csv evaluated.csv | awk -F, -v what="$1 $3" '
    NR > 1 {
      for (k = 1; k <= 3; k++) {
        d = $k - $(k + 3)
        if (d < 0) d = -d
        sum += d
        if (d > most) most = d
      }
    }
    END { printf "%s: mean %.5f most %.4f of %d\n", what, sum / (3 * (NR - 1)), most, NR - 1 }'
}

for mesh in leg box; do
  "$make_mesh" $mesh 16 >$mesh.obj
  works bake wood --preset keyaki -o $mesh.exr --shape $mesh.obj --res 1024 --outputs albedo --bits 32
  all=$(compare $mesh.obj $mesh.exr points)
  seams=$(compare $mesh.obj $mesh.exr seams)
  printf '%s\n%s\n' "$all" "$seams"
  all_mean=${all#*mean } seam_mean=${seams#*mean }
  all_mean=${all_mean%% *} seam_mean=${seam_mean%% *}
  check "$mesh: the points' own wood" awk "BEGIN { exit !($all_mean < 0.01) }"
  check "$mesh: at the seams as elsewhere" awk "BEGIN { exit !($seam_mean < 1.5 * $all_mean) }"
done
finish
