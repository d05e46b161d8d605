#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# format.sh [--fix]: is every C and C++ source as .clang-format has it?
# Exits 77 without clang-format. Versions differ in small ways, so only the one
# that the sources are formatted with, Debian 12's, may fail.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
readonly version_used=14

command -v clang-format >/dev/null || {
  echo "no clang-format here"
  exit 77
}
mapfile -t files < <(find api plugin colour hosts tests docs \
  -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' | sort)
if [[ ${1:-} == --fix ]]; then
  exec clang-format -i "${files[@]}"
fi
# one start for all: it takes longer to load than to read a file
mapfile -t bad < <(clang-format --dry-run "${files[@]}" 2>&1 | sed -n 's/^\([^:]*\):[0-9]*:.*/\1/p' | sort -u)
if ((${#bad[@]} == 0)); then
  echo "${#files[@]} files are formatted"
  exit 0
fi
printf 'not formatted: %s\n' "${bad[@]}"
version=$(clang-format --version | grep -o '[0-9]*\.[0-9]' | head -n 1)
if [[ ${version%%.*} != "$version_used" ]]; then
  echo "warning only: this clang-format is $version, the sources' is $version_used"
  exit 0
fi
echo "cmake --build build --target format mends it"
exit 1
