#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# prefix.sh CMAKE BUILD SCRATCH COMPILER LIBDIR CFLAGS
# Installs the build into a prefix, moves the prefix, and builds and runs the
# embedding example against it as two strangers would: by pkg-config and by
# find_package. The example is the installed one; of the source tree only the
# consumer's CMakeLists.txt is used.
set -euo pipefail
readonly cmake=$1 build=$2 scratch=$3 compiler=$4 libdir=$5
read -ra flags <<<"${6:-}"
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
readonly here prefix=$scratch/moved

rm -rf "$scratch"
mkdir -p "$scratch"
"$cmake" --install "$build" --prefix "$scratch/prefix" >"$scratch/install.log"
mv "$scratch/prefix" "$prefix"
(cd "$prefix" && find . -type f | LC_ALL=C sort)

# What the pages link to is there, and the add-on as Blender takes it.
docs=$(dirname -- "$(find "$prefix" -name README.md)")
links=0
while IFS=: read -r page target; do
  if [[ $target == *:* || $target == \#* ]]; then continue; fi
  links=$((links + 1))
  if [[ ! -e ${page%/*}/${target%%#*} ]]; then
    echo "FAILED: $page: $target is not installed"
    exit 1
  fi
done < <(find "$docs" -name '*.md' -print0 | xargs -0 grep -oHE '\]\([^) ]+\)' | sed -E 's/:\]\(/:/; s/\)$//')
((links > 100)) || { echo "FAILED: $links links in the pages"; exit 1; }
grep -q '](.*include/sozai.h)' "$docs/README.md" || { echo "FAILED: README.md's link to sozai.h"; exit 1; }
if [[ ! -s $prefix/share/sozai/sozai_addon.zip ]]; then
  echo "FAILED: no share/sozai/sozai_addon.zip"
  exit 1
fi

example=$(find "$prefix" -path '*/sozai/example/embed.c')
check() { # how, program, plugin
  if [[ ! -f $3 ]]; then
    echo "FAILED: $1: there is no $3"
    exit 1
  fi
  echo "$1:"
  "$here/../embed/run.sh" "$2" "$3" 4
}

export PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig
read -ra cflags < <(pkg-config --cflags sozai)
"$compiler" "${flags[@]}" -std=c99 "${cflags[@]}" "$example" -o "$scratch/by-pkg-config" -ldl
check pkg-config "$scratch/by-pkg-config" "$(pkg-config --variable=plugin sozai)"
if [[ $(pkg-config --variable=plugindir sozai)/sozai.so != "$(pkg-config --variable=plugin sozai)" ]]; then
  echo "FAILED: plugindir does not hold the plugin"
  exit 1
fi

"$cmake" -S "$here/consumer" -B "$scratch/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_C_COMPILER="$compiler" -DCMAKE_C_FLAGS="${6:-}" -DEXAMPLE="$example" >"$scratch/configure.log"
"$cmake" --build "$scratch/consumer" >"$scratch/build.log"
check find_package "$scratch/consumer/embed" "$(<"$scratch/consumer/plugin.txt")"

# The command, where it was built, finds the installed plugin by itself.
if [[ -x $prefix/bin/sozai ]]; then
  (cd / && env -u SOZAI_PLUGIN "$prefix/bin/sozai" list >"$scratch/list.txt")
  grep -qw wood "$scratch/list.txt"
  echo "bin/sozai list: $(grep -cw wood "$scratch/list.txt") line(s) with wood"
fi

# ... and the library that writes its pictures.
if [[ -x $prefix/bin/sozai ]]; then
  (cd / && env -u SOZAI_PLUGIN "$prefix/bin/sozai" render wood --res 16x16 --spp 1 -o "$scratch/wood.png")
  [[ $(head -c 4 "$scratch/wood.png") == $'\x89PNG' ]]
  echo "bin/sozai render: a PNG of $(stat -c %s "$scratch/wood.png") bytes"
fi

# And so does the reader for OpenImageIO.
if command -v iinfo >/dev/null && [[ -e $prefix/$libdir/sozai/sozai.imageio.so ]]; then
  printf 'material: wood\n' >"$scratch/oak.sozai"
  # shellcheck source=tests/cli/foreign.sh
  source "$here/../cli/foreign.sh" "$prefix/$libdir/sozai/sozai.imageio.so"
  (
    cd /
    unset SOZAI_PLUGIN
    OIIO_LIBRARY_PATH=$prefix/$libdir/sozai foreign iinfo "$scratch/oak.sozai"
  )
fi
