#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# valgrind.sh DIRECTORY PROGRAM ROUNDS PLUGIN: run PROGRAM ROUNDS PLUGIN under
# valgrind; any error or leak fails. On AVX2, or what there is: valgrind knows
# no AVX-512. Exits 77 without valgrind.
#
# On copies without debugging information: valgrind 3.19 gives up over clang's.
# The names of functions stay.
set -euo pipefail
directory=$1 program=$2 rounds=$3 plugin=$4
for tool in valgrind strip; do
  command -v "$tool" >/dev/null || {
    echo "no $tool here"
    exit 77
  }
done
if grep -qw avx2 /proc/cpuinfo; then
  SOZAI_CPU=avx2
elif [[ $(uname -m) == x86_64 ]]; then
  SOZAI_CPU=sse2
else
  SOZAI_CPU=scalar
fi
export SOZAI_CPU
mkdir -p "$directory"
strip --strip-debug -o "$directory/program" "$program"
strip --strip-debug -o "$directory/sozai.so" "$plugin"
exec valgrind --quiet --leak-check=full --show-leak-kinds=definite,indirect,possible \
  --errors-for-leak-kinds=definite,indirect,possible --error-exitcode=9 \
  "$directory/program" "$rounds" "$directory/sozai.so"
