#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# sozai grow fiber: what it refuses, in one line that names the option.
set -eu
sozai=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

refuses() { # words, then the options
  words=$1
  shift
  code=0
  "$sozai" grow fiber "$@" >"$work/out" 2>"$work/err" || code=$?
  if [ "$code" -ne 2 ] || ! grep -qF -- "$words" "$work/err" || [ "$(wc -l <"$work/err")" -ne 1 ]; then
    echo "grow fiber $*: exit $code, not 2 with one line holding '$words':"
    cat "$work/err"
    exit 1
  fi
  if [ -e "$work/x.usda" ]; then
    echo "grow fiber $*: left a file behind"
    exit 1
  fi
}

refuses "--hull" -o "$work/x.usda"
refuses "-o FILE" --hull ball
refuses "none of: bunny" --hull rabbit -o "$work/x.usda"
refuses "cannot read mesh" --hull "$work/none.obj" -o "$work/x.usda"
refuses "ends in none of" --hull ball -o "$work/x.png.txt"
refuses "--table" --hull ball -o "$work/x.csv"
refuses "length: -1 is outside" --hull ball -o "$work/x.usda" -p length=-1
refuses "fiber has no parameter" --hull ball -o "$work/x.usda" -p lenght=1
refuses "no preset" --hull ball -o "$work/x.usda" --material fur
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/one.obj"
refuses "hull:" --hull "$work/one.obj" -o "$work/x.usda"
: >"$work/empty.obj"
refuses "empty.obj" --hull "$work/empty.obj" -o "$work/x.usda"

"$sozai" grow fiber --hull ball -o "$work/t.csv" --table statistics -p count=20 --material cotton
grep -q whole_inside "$work/t.csv"
"$sozai" grow fiber --hull serpent -o "$work/t.pbrt" -p count=20 -p taper=0.2
grep -c 'Shape "curve"' "$work/t.pbrt" | grep -qx '[1-9][0-9]*'
"$sozai" grow fiber --hull slab -o "$work/t.gltf" -p count=20
"$sozai" grow fiber --hull lump -o "$work/t.png" -p count=50 --res 32x32 --spp 2
# from outside a hull comes back in: any mesh
"$sozai" grow tree -o "$work/tree.obj" --age 2 -p foliage=none
"$sozai" grow fiber --hull "$work/tree.obj" -o "$work/x.hair" -p count=20 -p length=2 -p cells=256
[ "$(head -c 4 "$work/x.hair")" = HAIR ]
