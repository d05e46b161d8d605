#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every link of the documentation into this tree leads to a file.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

failed=0
count=0
while IFS=: read -r page target; do
  target=${target%%#*}
  if [[ -z $target || $target == http* ]]; then continue; fi
  count=$((count + 1))
  if [[ ! -e ${page%/*}/$target ]]; then
    echo "$page: there is no $target"
    failed=1
  fi
done < <(find . -name '*.md' -not -path './build*' -print0 |
  xargs -0 grep -oHE '\]\([^)]+\)' | sed -E 's/:\]\(/:/; s/\)$//')
echo "$count links followed"
exit "$failed"
