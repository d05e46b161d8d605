#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# .sozai files: what they may hold, and how mistakes in them are named.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly points=$'px,py,pz\n1,2,3'

recipe() { # name: the text from standard input
  cat >"$scratch/$1.sozai"
}

recipe whole <<'YAML'
# everything there is
material: wood
preset: mock_oak
params:
  pitch: 2.5
  shiny: true
  cut: "end"
  tilt: [1, 2, 3]
  tint: [0.5, 0.75, 1]
surface:
  shape: board
  size: [100, 200, 18]
image:
  resolution: [4096, 2048]
  size: 500
YAML
works eval "$scratch/whole.sozai" --channels albedo <<<"$points"
same "a file's values" $'albedo_r,albedo_g,albedo_b\n0.125,0.125,0.125' "$out"
works eval "$scratch/whole.sozai" --channels albedo -p pitch=100 <<<"$points"
same "-p over the file" $'albedo_r,albedo_g,albedo_b\n0.5,0.75,1' "$out"
works eval "$scratch/whole.sozai?pitch=100&tint=0.25+0.5+%30.75&res=512" --channels albedo <<<"$points"
same "values in the name" $'albedo_r,albedo_g,albedo_b\n0.25,0.5,0.75' "$out"
works describe "$scratch/whole.sozai"
# as a card of some camera or an old share names files
for name in WHOLE.SOZAI Whole.Sozai; do
  cp "$scratch/whole.sozai" "$scratch/$name"
  works describe "$scratch/$name"
  works eval "$scratch/$name?pitch=100" --channels albedo <<<"$points"
done

mistake() { # words, then the file from standard input
  recipe bad
  refuses 2 "bad.sozai$1" eval "$scratch/bad.sozai" <<<"$points"
}
mistake ":2|'colour'|material, preset, params" <<<$'material: wood\ncolour: red'
mistake ":|no 'material'" <<<'preset: mock_oak'
mistake ":2|'material'|twice" <<<$'material: wood\nmaterial: wood'
mistake "|unknown material 'stile'|wood" <<<'material: stile'
mistake ":1|material|single value" <<<'material: [wood]'
mistake ":2|params|mapping" <<<$'material: wood\nparams: 3'
mistake ":4|pitch|5000|0.1|1000" <<<$'material: wood\nparams:\n  shiny: true\n  pitch: 5000'
mistake ":3|'ptch'" <<<$'material: wood\nparams:\n  ptch: 5'
mistake ":3|pitch|'wide'" <<<$'material: wood\nparams:\n  pitch: wide'
mistake ":4|'pitch'|twice" <<<$'material: wood\nparams:\n  pitch: 5\n  pitch: 6'
mistake ":3|'a'|an image|file, space" <<<$'material: wood\nparams:\n  pitch: {a: 1}'
mistake ":3|'ball'|plane, board, mesh" <<<$'material: wood\nsurface:\n  shape: ball'
mistake ":3|size|'-2'|0.001" <<<$'material: wood\nsurface:\n  size: [1, -2]'
mistake ":3|size|at most 3" <<<$'material: wood\nsurface:\n  size: [1, 2, 3, 4]'
mistake ":3|'mesh'" <<<$'material: wood\nsurface:\n  shape: mesh'
mistake ":3|resolution|whole" <<<$'material: wood\nimage:\n  resolution: 12.5'
mistake ":3|resolution|1048576" <<<$'material: wood\nimage:\n  resolution: [9999999, 2]'
mistake ":3|'depth'|resolution, size" <<<$'material: wood\nimage:\n  depth: 3'
mistake ":2|aliases" <<<$'material: &m wood\npreset: *m'
mistake ":|document" <<<$'material: wood\n---\nmaterial: wood'
mistake ":|empty" </dev/null
mistake ":1|mapping" <<<'- wood'
mistake ":2" <<<$'material: wood\n\tparams: 3'
mistake ":" < <(printf 'material: wood\npreset: \xff\xfe\n')
mistake "|recipe_bytes, 1048576" < <(
  echo "material: wood"
  head -c 2000000 /dev/zero | tr '\0' '#'
)
# Colours: how they are written, where they are not.
mistake ":3|tint|cannot read|#rrggbb|quotes|@ SPACE" <<<$'material: wood\nparams:\n  tint: #c08040'
mistake "|quotes" <<<$'material: wood\nparams: {tint: #c08040, pitch: 2}'
mistake ":3|tint|red|#rrggbb|r g b" <<<$'material: wood\nparams:\n  tint: red'
mistake ":3|'value'|file, space|#rrggbb|r g b @ SPACE" <<<$'material: wood\nparams:\n  tint: {value: "#c08040", space: sRGB}'
mistake ":3|'file'|r g b @ SPACE" <<<$'material: wood\nparams:\n  tint: {space: sRGB}'
refuses 2 "tint|red|#rrggbb" eval wood -p tint=red <<<"$points"
refuses 2 "cannot read" eval "$scratch/none.sozai"
mkdir "$scratch/folder.sozai"
refuses 2 "cannot read" eval "$scratch/folder.sozai"
refuses 2 "res=" eval "$scratch/whole.sozai?res=huge"
refuses 2 "'pitch'" eval "$scratch/whole.sozai?pitch"
finish
