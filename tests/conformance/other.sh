#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# other.sh SOURCE PLUGIN BUILD TEST few|all COMPILER [CMake option...] [-- RUNNER...]:
# build the plugin once more with COMPILER, and ask TEST whether it answers with
# the same bits as PLUGIN, the one built here, and with those recorded. few: on x86-64
# its kernels for one lane and for AVX2 alone; all: every one, and at length. RUNNER: what
# runs programs of another processor. Exits 77 without the compiler or the runner.
#
# Built here and not with everything else: only this test wants it, and a
# second compiler must not stand in the way of the first one's build.
set -euo pipefail
source=$1 plugin=$2 build=$3 test=("$4") kernels=$5 compiler=$6
shift 6
options=() runner=()
if [[ $kernels == all ]]; then
  test+=(--long)
elif [[ $(uname -m) == x86_64 ]]; then
  options+=(-DSOZAI_FEW_KERNELS=ON)
  # the other names stand for these
  export SOZAI_TEST_SETS="scalar avx2"
fi
while (($#)) && [[ $1 != -- ]]; do
  options+=("$1")
  shift
done
if (($#)); then
  shift
  runner=("$@")
fi
for program in "$compiler" "${runner[0]:-true}"; do
  command -v "$program" >/dev/null || {
    echo "no $program here"
    exit 77
  }
done

newer=$(find -L "$source/plugin" "$source/api" -name '*.[ch]' -newer "$plugin")
if [[ -n $newer ]]; then
  printf 'the plugin is older than its sources, build it first:\n%s\n' "$newer"
  exit 1
fi
mkdir -p "$build"
{
  cmake -S "$source/tests/conformance/other" -B "$build" -DSOZAI_SOURCE="$source" \
    -DCMAKE_C_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release "${options[@]}"
  cmake --build "$build"
} >"$build/log.txt" 2>&1 || {
  grep -E -m 20 'error|Error|not found' "$build/log.txt" || tail -n 20 "$build/log.txt"
  exit 1
}
# The recorded hashes too: all of them, or under emulation one in twelve.
hashes=("$source/tests/conformance/hashes.sh" check "$source/tests/conformance/hashes.txt"
  "$build/hash-worker" "$build/sozai.so")
if ((${#runner[@]})); then
  "${hashes[@]}" 12 "${runner[@]}"
else
  "${hashes[@]}"
fi
if ((${#runner[@]})); then
  exec "${test[@]}" --against "$build/sozai.so" --worker "$build/identity-worker" --runner "${runner[@]}"
fi
exec "${test[@]}" --against "$build/sozai.so"
