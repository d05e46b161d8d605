#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# record.sh check|write LIBRARY RECORD
# check: the library's ABI is the recorded one: its symbols, and every type they
# lead to, as its debugging information has them. write: record it.
# Exits 77 without libabigail.
set -euo pipefail
readonly action=$1 library=$2 record=$3

if ! command -v abidiff >/dev/null; then
  echo "no abidiff here (Debian: abigail-tools)"
  exit 77
fi
elf=$(readelf -dSW "$library")
if [[ $elf =~ NEEDED[^$'\n']*lib(asan|ubsan|tsan)\. ]]; then
  echo "a sanitizer's build: its symbols are not the release's"
  exit 77
fi
if [[ $elf != *.debug_info* ]]; then
  echo "FAILED: $library has no debugging information"
  exit 1
fi

if [[ $action == write ]]; then
  # Without machine, paths and lines, which are this build's and not the ABI's.
  abidw --exported-interfaces-only --no-architecture --no-elf-needed \
    --no-corpus-path --no-comp-dir-path --no-show-locs "$library" |
    sed -E "s| path='[^']*/([^'/]*)'| path='\1'|" >"$record"
  echo "recorded in $record"
  exit 0
fi
set +e
# --harmless: a const more or less counts as well.
abidiff --exported-interfaces-only --no-architecture --harmless "$record" "$library"
result=$?
set -e
# abidiff: bits 1 and 2 for trouble, 4 for a change, 8 for an incompatible one.
if ((result == 0)); then
  echo "the ABI is as recorded in ${record##*/}"
elif ((result & 3)); then
  echo "FAILED: abidiff itself failed ($result)"
else
  echo "FAILED: the ABI has changed; docs/abi.md says what is allowed and how to record it"
fi
exit "$((result != 0))"
