#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gallery: a picture for every preset, an index that names them all.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"

# of the materials that the mock has not, each picture is left out, and counted
left_out() { sed -n 's/.* \([0-9]*\) left out.*/\1/p' "$scratch/out"; }
works gallery -o "$scratch/choice" --spp 1
check "the choice has the sheet of woods" test -s "$scratch/choice/gallery.png"
chosen=$(left_out)
works gallery --all -o "$scratch/pictures" --spp 1
check "the choice is fewer than all" test "$chosen" -lt "$(left_out)"
check "it says where the index is" grep -qF "$scratch/pictures/index.html" "$scratch/out"
for name in gallery flat-mock_oak quarter-mock_maple; do
  check "$name.png is there" test -s "$scratch/pictures/$name.png"
done
while IFS= read -r name; do
  check "$name, which the index shows, is there" test -s "$scratch/pictures/$name"
done < <(grep -o 'img src="[^"]*"' "$scratch/pictures/index.html" | cut -d'"' -f2)
while IFS= read -r name; do
  case $name in
  \#*) check "$name, which a link leads to, is there" \
    grep -q "id=\"${name#\#}\"" "$scratch/pictures/index.html" ;;
  *) check "$name, which a link leads to, is there" test -s "$scratch/pictures/$name" ;;
  esac
done < <(grep -o 'href="[^"]*"' "$scratch/pictures/index.html" | cut -d'"' -f2)
check "woods have a section" grep -q '<h2 id=.*>Wood</h2>' "$scratch/pictures/index.html"
check "a link leads to it" grep -q '<a href="#.*>Wood</a>' "$scratch/pictures/index.html"
check "and one to its sheet" grep -q '<a href="gallery.png">' "$scratch/pictures/index.html"
same "nothing half-made" "" "$(find "$scratch/pictures" -name '.*.png' -o -name '.*.html')"
refuses 2 "no output" gallery
: >"$scratch/file"
refuses 2 "--output|$scratch/file" gallery -o "$scratch/file"
finish
