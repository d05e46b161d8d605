#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gallery: a picture for every preset, an index that names them all.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"

works gallery -o "$scratch/choice" --spp 1
check "the choice is fewer than all" test ! -e "$scratch/choice/sphere.png"
check "and has the sheet of woods" test -s "$scratch/choice/gallery.png"
works gallery --all -o "$scratch/pictures" --spp 1
check "sphere.png is there" test -s "$scratch/pictures/sphere.png"
check "it says where the index is" grep -qF "$scratch/pictures/index.html" "$scratch/out"
for name in gallery flat-mock_oak quarter-mock_maple; do
  check "$name.png is there" test -s "$scratch/pictures/$name.png"
done
while IFS= read -r name; do
  check "$name, which the index shows, is there" test -s "$scratch/pictures/$name"
done < <(grep -o 'img src="[^"]*"' "$scratch/pictures/index.html" | cut -d'"' -f2)
same "nothing half-made" "" "$(find "$scratch/pictures" -name '.*.png' -o -name '.*.html')"
refuses 2 "no output" gallery
: >"$scratch/file"
refuses 2 "--output|$scratch/file" gallery -o "$scratch/file"
finish
