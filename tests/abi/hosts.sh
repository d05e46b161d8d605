#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# hosts.sh OLDEST NEWEST SCRATCH PLUGIN...: the host compiled against the oldest header and the one
# compiled against the newest are told the same by each plugin, to the bit; and the
# structs they hand over do differ in size.
set -uo pipefail
scratch=$3
declare -A program=([oldest]=$1 [newest]=$2)
shift 3
mkdir -p "$scratch"
failed=0
for plugin in "$@"; do
  for host in oldest newest; do
    "${program[$host]}" "$plugin" >"$scratch/$host.txt" 2>"$scratch/$host.err" || {
      echo "FAILED: the $host host with $plugin: exit code $?"
      tail -n 3 "$scratch/$host.txt" "$scratch/$host.err"
      failed=1
    }
  done
  if ! diff "$scratch/oldest.txt" "$scratch/newest.txt" | head -n 20; then failed=1; fi
  lines=$(wc -l <"$scratch/oldest.txt")
  if ((lines < 40)) || ! grep -q ' [0-9a-f]\{16\} ' "$scratch/oldest.txt"; then
    echo "FAILED: ${plugin##*/} said only $lines lines"
    failed=1
  fi
  echo "${plugin##*/}: $lines lines, the same from both"
done
if cmp -s "$scratch/oldest.err" "$scratch/newest.err"; then
  echo "FAILED: both hosts were compiled with the same header"
  failed=1
fi
paste -d' ' <(printf 'oldest\nnewest\n') <(cat "$scratch/oldest.err" "$scratch/newest.err")
exit "$failed"
