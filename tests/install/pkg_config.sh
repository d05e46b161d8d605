#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pkg_config.sh CMAKE SOURCE SCRATCH COMPILER
# What sozai.pc says for each way in which a distribution may name its folders.
set -euo pipefail
readonly cmake=$1 source=$2 scratch=$3 compiler=$4
rm -rf "$scratch"
failed=0

# says NAME WANTED-INCLUDE WANTED-PLUGIN [OPTION...]: as installed under /opt/it.
says() {
  local name=$1 include=$2 plugin=$3
  shift 3
  "$cmake" -S "$source" -B "$scratch/$name" -G Ninja -DCMAKE_C_COMPILER="$compiler" \
    -DSOZAI_TESTS=OFF -DSOZAI_HOSTS=OFF -DSOZAI_COLOUR=OFF -DCMAKE_INSTALL_PREFIX=/opt/it "$@" \
    >"$scratch.log" 2>&1 || { cat "$scratch.log"; exit 1; }
  # where the file will be tells what stands relative to it
  local folder
  folder=$(sed -n 's/^CMAKE_INSTALL_LIBDIR:[A-Z]*=//p' "$scratch/$name/CMakeCache.txt")
  [[ $folder == /* ]] || folder=/opt/it/$folder
  local said=$scratch/$name/package/sozai.pc given
  given=$(pkg-config --define-variable=pcfiledir="$folder/pkgconfig" --variable=includedir "$said")
  [[ $(realpath -m "$given") == "$include" ]] || { echo "FAILED: $name: includedir $given"; failed=1; }
  given=$(pkg-config --define-variable=pcfiledir="$folder/pkgconfig" --variable=plugin "$said")
  [[ $(realpath -m "$given") == "$plugin" ]] || { echo "FAILED: $name: plugin $given"; failed=1; }
  echo "$name: $include, $plugin"
}

says relative /opt/it/include /opt/it/lib/sozai/sozai.so -DCMAKE_INSTALL_LIBDIR=lib
says multiarch /opt/it/include /opt/it/lib/x86_64/sozai/sozai.so -DCMAKE_INSTALL_LIBDIR=lib/x86_64
says absolute_libraries /opt/it/include /elsewhere/lib/sozai/sozai.so \
  -DCMAKE_INSTALL_LIBDIR=/elsewhere/lib
says absolute_headers /elsewhere/include /opt/it/lib/sozai/sozai.so \
  -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_INCLUDEDIR=/elsewhere/include
exit $failed
