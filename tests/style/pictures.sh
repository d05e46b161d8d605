#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# No picture of the tree tells where it was made: programs write paths and their own command lines
# into a PNG's text.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

failed=0
count=0
while IFS= read -r -d '' picture; do
  count=$((count + 1))
  if found=$(grep -aoE -m 1 'ImageHistory|oiiotool |/(tmp|home|root|var|usr|mnt)/[[:print:]]{1,40}' "$picture"); then
    echo "$picture says: ${found%%$'\n'*}"
    failed=1
  fi
done < <(find . -name '*.png' -not -path './build*' -not -path './.git/*' -print0)
echo "$count pictures looked into"
((count)) || failed=1
exit "$failed"
