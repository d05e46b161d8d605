#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every source says its license in its first lines.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

mapfile -t files < <(find quickstart .ci CMakeLists.txt cmake api plugin colour hosts tests docs \
  -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' -o -name '*.sh' -o -name '*.py' \
  -o -name '*.ocio' -o -name '*.osl' -o -name CMakeLists.txt -o -name '*.cmake' -o -name quickstart \
  -o -path .ci/run \))
failed=$((${#files[@]} == 0))
for file in "${files[@]}"; do
  lines=()
  mapfile -t -n 3 lines <"$file" # without a process for each
  if [[ ${lines[*]} != *'SPDX-License-Identifier: Apache-2.0'* ]]; then
    echo "no SPDX line: $file"
    failed=1
  fi
done
echo "${#files[@]} files looked at"
exit "$failed"
