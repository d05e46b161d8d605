#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# refused.sh SOZAI FOLDER SCRATCH
# A plugin that cannot be used is refused with a line that says why, and exit
# code 2: a missing file, no library, one of another ABI, one that does not
# initialise, one without textures, one without an entry.
set -uo pipefail
readonly sozai=$1 folder=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"
failures=0

refused() { # plugin, words that the message must hold
  local plugin=$1 word message code
  shift
  message=$(SOZAI_PLUGIN=$plugin "$sozai" list 2>&1 >"$scratch/out")
  code=$?
  echo "$message"
  if ((code != 2)) || [[ -s $scratch/out || $message == *$'\n'* ]]; then
    echo "FAILED: exit code $code, wanted 2, one line, and no output"
    failures=1
  fi
  for word in "$plugin" "$@"; do
    [[ $message == *"$word"* ]] || {
      echo "FAILED: no '$word' in it"
      failures=1
    }
  done
}

refused "$scratch/none.so" "no such plugin"
echo "not a library" >"$scratch/text.so"
refused "$scratch/text.so" "cannot load"
refused "$folder/sozai-mock-other-abi.so" "ABI version 99." "needs 1"
refused "$folder/sozai-mock-no-init.so" "did not initialise"
refused "$folder/sozai-mock-no-factory.so" "sozai.textures/1"
refused "$folder/sozai-mock-no-entry.so" "sozai_entry"
SOZAI_PLUGIN=$folder/sozai-mock.so "$sozai" list >/dev/null || {
  echo "FAILED: the sound one is refused too"
  failures=1
}
exit "$failures"
