#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# within.sh CMAKE SOURCE SCRATCH COMPILER
# As a part of another project sozai leaves that project's settings and documents alone. It is
# configured and installed, and not built: an empty file stands for the plugin.
set -euo pipefail
readonly cmake=$1 source=$2 scratch=$3 compiler=$4
unset CMAKE_BUILD_TYPE
rm -rf "$scratch"
mkdir -p "$scratch/parent" "$scratch/prefix/share/doc/sozai"
failed=0

check() { # what, command...
  local what=$1
  shift
  "$@" || { echo "FAILED: $what"; failed=1; }
}

cat >"$scratch/parent/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.25)
project(parent LANGUAGES C)
include(GNUInstallDirs)
install(FILES README.md GUIDE.md TYPE DOC)
add_subdirectory("$source" sozai)
install(FILES LATE.md TYPE DOC)
CMAKE
for page in README GUIDE LATE; do
  printf '# %s of the parent\n[a header](api/sozai.h), [a source](plugin/textures.c)\n' "$page" \
    >"$scratch/parent/$page.md"
done
# of whoever else has put something there
cp "$scratch/parent/GUIDE.md" "$scratch/prefix/share/doc/sozai/NOTES.md"

"$cmake" -S "$scratch/parent" -B "$scratch/build" -G Ninja -DCMAKE_C_COMPILER="$compiler" \
  -DSOZAI_COLOUR=OFF -DCMAKE_INSTALL_PREFIX="$scratch/prefix" >"$scratch/log" 2>&1 ||
  { cat "$scratch/log"; exit 1; }
check "the parent's build type is its own: $(grep '^CMAKE_BUILD_TYPE' "$scratch/build/CMakeCache.txt")" \
  grep -qx 'CMAKE_BUILD_TYPE:STRING=' "$scratch/build/CMakeCache.txt"

# where the build would put it
plugin=$(sed -n 's/^build \([^ ]*sozai\.so\):.*/\1/p' "$scratch/build/build.ninja" | head -n 1)
mkdir -p "$scratch/build/${plugin%/*}"
: >"$scratch/build/$plugin"
"$cmake" --install "$scratch/build" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
readonly doc=$scratch/prefix/share/doc
for page in README GUIDE LATE; do
  check "the parent's $page.md is as it was" cmp "$scratch/parent/$page.md" "$doc/parent/$page.md"
done
[[ $(ls "$doc/parent") == $'GUIDE.md\nLATE.md\nREADME.md' ]] ||
  { echo "FAILED: in the parent's documents:" "$doc"/parent/*; failed=1; }
check "sozai's are in a folder of its own" test -s "$doc/sozai/docs/guide.md"
check "their links lead to the headers" grep -q '](.*include/sozai.h)' "$doc/sozai/README.md"
check "a page beside them is left alone" cmp "$scratch/parent/GUIDE.md" "$doc/sozai/NOTES.md"
echo "$(find "$doc/sozai" -name '*.md' | wc -l) pages in $doc/sozai"
exit $failed
