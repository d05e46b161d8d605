#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# alone.sh SOURCE BUILD SECONDS: build the targets that test parsers by clang with libFuzzer, and
# run each for so long. Exits 77 without clang or its libFuzzer.
set -euo pipefail
source=$1 build=$2 seconds=$3
mkdir -p "$build"
echo 'int LLVMFuzzerTestOneInput(const char *d, long n) { return d && n < 0; }' >"$build/has.c"
if ! clang -fsanitize=fuzzer,address "$build/has.c" -o "$build/has" >/dev/null 2>&1 ||
  ! command -v clang++ >/dev/null; then
  echo "no clang with libFuzzer here (Debian: clang, libclang-rt-14-dev)"
  exit 77
fi
{
  cmake -S "$source/tests/fuzz/alone" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug
  cmake --build "$build"
} >"$build/log.txt" 2>&1 || {
  tail -n 20 "$build/log.txt"
  exit 1
}
# what was learnt before stays out: a test begins the same each time
rm -rf "$build/fuzz"
"$source/tests/fuzz/run.sh" "$build" "$seconds" || {
  grep -hE 'ERROR|runtime error|CHECK|^    #[0-4] ' "$build"/fuzz/*.log | head -n 20
  exit 1
}
