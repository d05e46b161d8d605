#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Pictures named in .sozai files and on the command line.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
command -v oiiotool >/dev/null || exit 77
readonly points=$'px,py,pz\n40,0,0\n-40,0,0\n0,0,40\n0,0,-40'

# Red to the left, green to the right, over the whole height; 8 bits, sRGB.
mkdir -p "$scratch/logs @ home"
oiiotool --create 64x64 3 --fill:color=1,0,0 32x64+0+0 --fill:color=0,1,0 32x64+32+0 -d uint8 \
  -o "$scratch/halves.png"
mv "$scratch/halves.png" "$scratch/logs @ home/" # which oiiotool would not write to
oiiotool --pattern constant:color=0.5,0.5,0.5 16x16 3 -d uint8 -o "$scratch/grey.png"
cat >"$scratch/logs @ home/log.sozai" <<'YAML'
material: wood
params:
  fibre_brightness: 0
  section: halves.png
  section_width: 200
  section_pith: given
  section_rim: none
YAML
readonly file="$scratch/logs @ home/log.sozai"

halves() { # the four answers, rounded
  same "$1" "0.00 1.00 0.00
1.00 0.00 0.00" "$(head -3 <<<"$out" | tail -2 | awk -F, '{printf "%.2f %.2f %.2f\n", $1, $2, $3}')"
}

works eval "$file" --channels albedo <<<"$points"
halves "a picture beside the file, in a folder of an awkward name"
(cd / && "$sozai" eval "$file" --channels albedo <<<"$points") >"$scratch/elsewhere"
same "from another folder" "$out" "$(<"$scratch/elsewhere")"
works eval wood -p "section=$scratch/logs @ home/halves.png @ " -p section_width=200 \
  -p section_pith=given -p section_rim=none -p fibre_brightness=0 --channels albedo <<<"$points"
halves "by -p"

# in full: raw numbers, one channel after the first
sed -i 's|section: halves.png|section: {file: halves.png, space: data, wrap: clamp}|' "$file"
works eval "$file" --channels albedo <<<"$points"
halves "in full"
works eval "$file?section=../grey.png" --channels albedo <<<"$points"
same "in the file's name, in sRGB" 0.216 "$(awk -F, 'NR == 2 {printf "%.3f", $1}' <<<"$out")"
works eval "$file?section=../grey.png+@+data" --channels albedo <<<"$points"
same "in the file's name, raw" 0.50 "$(awk -F, 'NR == 2 {printf "%.2f", $1}' <<<"$out")"

refuses 2 "section|none.png" eval "$file?section=none.png" <<<"$points"
refuses 2 "section|round|mirror" eval "$file?section=halves.png+@+wrap=round" <<<"$points"
refuses 2 "section|no-such-space" eval "$file?section=halves.png+@+no-such-space" <<<"$points"
refuses 2 "section" eval "$file?section=." <<<"$points"
sed -i 's|space: data|space: a @ b|' "$file"
refuses 2 "log.sozai:4|a @ b| @ " eval "$file" <<<"$points"
sed -i 's|space: a @ b|space: data|; s|file: halves.png|file: lost.png|' "$file"
refuses 2 "log.sozai:4|section|lost.png" eval "$file" <<<"$points"
sed -i 's|{file: lost.png, |{|' "$file"
refuses 2 "log.sozai:4|'file'" eval "$file" <<<"$points"
finish
