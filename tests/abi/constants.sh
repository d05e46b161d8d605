#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# constants.sh check|write API_DIR RECORD COMPILER: the macros of the public
# headers, numbers and ids, are the recorded ones. No debugging information
# has them, so abidiff cannot see one change.
set -euo pipefail
readonly action=$1 api=$2 record=$3 compiler=$4

constants() {
  "$compiler" -E -dM -x c "$api/sozai_colour.h" | grep '^#define SOZAI_' | sed 's/ $//' | LC_ALL=C sort
}
if [[ $action == write ]]; then
  constants >"$record"
  echo "recorded in $record"
elif constants | diff -u "$record" -; then
  echo "the $(wc -l <"$record") constants are as recorded"
else
  echo "FAILED: a constant has changed; docs/abi.md says what is allowed and how to record it"
  exit 1
fi
