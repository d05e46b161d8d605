#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every script passes shellcheck. Exits 77 where that is missing.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

command -v shellcheck >/dev/null || {
  echo "no shellcheck here"
  exit 77
}
mapfile -t files < <(find quickstart .ci/run tests hosts plugin colour docs \
  -type f \( -name '*.sh' -o -name quickstart -o -path .ci/run \))
((${#files[@]})) # none found is a mistake here
shellcheck "${files[@]}"
echo "${#files[@]} scripts checked"
