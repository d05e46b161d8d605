#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every link of the documentation into this tree leads to a file, and to a heading of it.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

# anchors FILE: its headings as links name them.
anchors() {
  sed -nE 's/^#+ +(.*)$/\1/p' "$1" | tr '[:upper:]' '[:lower:]' |
    sed -E 's/[^[:alnum:]_ -]//g; s/ /-/g'
}

failed=0
count=0
while IFS=: read -r page target; do
  if [[ $target == http* ]]; then continue; fi
  anchor=${target#"${target%%#*}"}
  file=$page
  if [[ -n ${target%%#*} ]]; then file=${page%/*}/${target%%#*}; fi
  count=$((count + 1))
  if [[ ! -e $file ]]; then
    echo "$page: there is no $target"
    failed=1
  elif [[ -n $anchor && $file == *.md ]] && ! anchors "$file" | grep -qxF -- "${anchor#\#}"; then
    echo "$page: no such heading: $target"
    failed=1
  fi
done < <(find . -name '*.md' -not -path './build*' -print0 |
  xargs -0 grep -oHE '\]\([^)]+\)' | sed -E 's/:\]\(/:/; s/\)$//')
echo "$count links followed"
((count)) || failed=1
exit "$failed"
