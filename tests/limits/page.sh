#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Whether docs/limits.md lists the ceilings that `sozai limits` prints, and no
# others. To renew the page's table: page.sh SOZAI PAGE --print
set -uo pipefail
readonly sozai=$1 page=$2
unset SOZAI_LIMITS

rows() { # as lines of the page's table
  "$sozai" limits | awk 'NR > 1 {
    layer = $1; id = $2; value = $3; most = $4
    unit = substr($0, 61, 2); doc = substr($0, 64)
    gsub(/ /, "", unit)
    printf "| %s | `%s` | %s | %s | %s | %s |\n", layer, id, value, most, unit, doc
  }'
}

if [[ ${3-} == --print ]]; then
  rows
  exit
fi
printed=$(rows)
if [[ $(grep -c '' <<<"$printed") -lt 30 ]]; then
  echo "FAILED: few ceilings were printed: $printed"
  exit 1
fi
layers="plugin|programs"
grep -q "^| pictures" <<<"$printed" && layers+="|pictures" # else built without them
if ! diff <(printf "%s\n" "$printed") <(grep -E "^\\| ($layers) \\|" "$page"); then
  echo "FAILED: $page lists other ceilings than sozai limits"
  exit 1
fi
