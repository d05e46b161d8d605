#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What is baked is what OpenImageIO reads from the .sozai file itself, to the
# bit, at every level.
command -v oiiotool >/dev/null || {
  echo "no oiiotool on this machine"
  exit 77
}
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
readonly make_mesh=$4 reader=$5
export OIIO_LIBRARY_PATH=${reader%/*}
cd "$scratch" || exit 1
"$make_mesh" udim 8 >udim.obj
cat >mesh.sozai <<'YAML'
material: wood
preset: keyaki
surface: {shape: mesh, mesh: udim.obj}
image: {resolution: 160, udim: 1003}
YAML
cat >floor.sozai <<'YAML'
material: wood
params: {layout: herringbone}
image: {resolution: 200, size: [900, 700]}
YAML
cat >stone.sozai <<'YAML'
material: stone
image: {resolution: 128, size: [200, 200], wrap: periodic}
YAML
sed 's/udim: 1003/udim: 1003, samples: 2/' mesh.sozai >parts.sozai
sed 's/wrap: periodic/wrap: periodic, samples: 4/' stone.sozai >round.sozai
for name in mesh floor stone parts round; do
  works bake $name.sozai -o $name.exr --mip --outputs albedo
  for level in 0 1 3; do
    oiiotool $name.exr --selectmip $level -d half -o baked.exr
    oiiotool "$name.sozai?outputs=albedo" --selectmip $level -d half -o read.exr
    check "$name, level $level" oiiotool --fail 0 --failpercent 0 baked.exr read.exr --diff >diff.txt
  done
done
finish
