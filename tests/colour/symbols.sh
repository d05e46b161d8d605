#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# symbols.sh NM LIBRARY: the library exports one symbol, and it is data.
set -euo pipefail
found=$("$1" -D --defined-only "$2" | cut -d ' ' -f 2-)
echo "exported: $found"
[[ $found =~ ^[BDR]\ sozai_colour_entry$ ]]
