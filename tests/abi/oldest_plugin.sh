#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# oldest_plugin.sh SOZAI OLDEST SAME SCRATCH: today's program with a plugin compiled against the
# oldest header: what it has works as with SAME, which is compiled from the same source
# against today's; what it lacks is refused with one line that names it.
set -uo pipefail
readonly sozai=$1 oldest=$2 same=$3 scratch=$4
rm -rf "$scratch"
mkdir -p "$scratch"
failures=0

fail() {
  echo "FAILED: $*"
  failures=1
}

works() { # argument...: with both, with the same output
  local plugin code
  for plugin in "$oldest" "$same"; do
    SOZAI_PLUGIN=$plugin "$sozai" "$@" >"$scratch/${plugin##*/}.txt" 2>&1
    code=$?
    if ((code)); then fail "$* with ${plugin##*/}: $code, $(head -n 1 "$scratch/${plugin##*/}.txt")"; fi
  done
  cmp "$scratch/${oldest##*/}.txt" "$scratch/${same##*/}.txt" || fail "$* differs"
  echo "$*: $(wc -c <"$scratch/${oldest##*/}.txt") bytes"
}

refused() { # word, argument...
  local word=$1 message code
  shift
  message=$(SOZAI_PLUGIN=$oldest "$sozai" "$@" 2>&1 >/dev/null)
  code=$?
  echo "$message"
  if ((code != 1 && code != 2)) || [[ -z $message || $message == *$'\n'* || $message != *"$word"* ]]; then
    fail "$*: exit code $code, wanted one line with '$word'"
  fi
}

printf 'px,py,pz,nx,ny,nz,lx,ly,lz\n1,2,3,0,0,1,0,0,1\n11,-7,1e9,1,0,0,0,1,1\nnan,0,0,0,0,0,0,0,0\n' \
  >"$scratch/points.csv"
printf 'material: wood\npreset: mock_oak\nparams:\n  pitch: 3\n' >"$scratch/r.sozai"
works list
works list --json
works describe wood
works describe wood --json
works eval wood --input "$scratch/points.csv"
works eval "$scratch/r.sozai" --input "$scratch/points.csv" -p tint='0.1 0.2 0.3'
works render wood -o "$scratch/r.png" --res 32x32
works bake "$scratch/r.sozai" -o "$scratch/b.exr" --res 32x32

for what in "grow tree -o $scratch/t.obj" "grow fiber --hull ball -o $scratch/f.usda" "saw --species sugi -o $scratch/saw"; do
  # shellcheck disable=SC2086 # words
  refused sozai.geometry/1 $what
done
refused tree describe --grown tree
refused stone describe stone
refused section eval wood --input "$scratch/points.csv" -p section=end.png
refused knots eval wood --input "$scratch/points.csv" -p knots=x
exit "$failures"
