#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run.sh PROGRAM PLUGIN LINES: the program prints that many different lines of
# numbers when given the plugin, and fails when given something else.
set -euo pipefail
readonly program=$1 plugin=$2 lines=$3

output=$("$program" "$plugin")
printf '%s\n' "$output"
# A row of finite numbers, of which the colour is between 0 and 1.
readonly colour='0\.[0-9]+ 0\.[0-9]+ 0\.[0-9]+'
count=$(grep -Ec "albedo $colour" <<<"$output" || true)
distinct=$(sort -u <<<"$output" | wc -l)
if [[ $count != "$lines" || $distinct != "$lines" ]]; then
  echo "expected $lines different lines with 'albedo' and three numbers between 0 and 1"
  exit 1
fi
if grep -Eiq 'nan|inf' <<<"$output"; then
  echo "a number is not finite"
  exit 1
fi
if "$program" /dev/null; then
  echo "took /dev/null for a plugin"
  exit 1
fi
