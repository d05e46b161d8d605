#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# headers.sh API_DIR LAYOUT COMPILER [c|c++]: each public header compiles alone,
# in every standard, without a warning and without hidden padding; and LAYOUT,
# the recorded sizes and offsets, holds. Exits 77 without the compiler.
set -euo pipefail
readonly api=$1 layout=$2 compiler=$3 language=$4

command -v "$compiler" >/dev/null || {
  echo "no $compiler here"
  exit 77
}
case $language in
  c) standards=(c99 c11 c17) ;;
  c++) standards=(c++11 c++14 c++17 c++20) ;;
  *) exit 2 ;;
esac
flags=(-x "$language" -pedantic -Wpadded -Wall -Wextra -Werror -fsyntax-only -I "$api")

failed=0
check() { # what, standard, then the compiler's input
  if "$compiler" "${flags[@]}" "-std=$2" "${@:3}"; then
    echo "ok: $1 as $2"
  else
    echo "FAILED: $1 as $2"
    failed=1
  fi
}
for standard in "${standards[@]}"; do
  for header in "$api"/*.h; do
    # Twice: the include guard has to hold.
    check "${header##*/}" "$standard" - <<<"#include \"$header\"
#include \"$header\"
int main(void);"
  done
  # Static assertions came with C11.
  if [[ $standard != c99 ]]; then check "${layout##*/}" "$standard" "$layout"; fi
done
exit "$failed"
