#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# valgrind.sh PROGRAM [argument...]: run it under valgrind; any error or leak
# fails. On AVX2, or what there is: valgrind knows no AVX-512. Exits 77 without
# valgrind.
set -euo pipefail
command -v valgrind >/dev/null || {
  echo "no valgrind here"
  exit 77
}
if grep -qw avx2 /proc/cpuinfo; then
  SOZAI_CPU=avx2
elif [[ $(uname -m) == x86_64 ]]; then
  SOZAI_CPU=sse2
else
  SOZAI_CPU=scalar
fi
export SOZAI_CPU
exec valgrind --quiet --leak-check=full --show-leak-kinds=definite,indirect,possible \
  --errors-for-leak-kinds=definite,indirect,possible --error-exitcode=9 "$@"
