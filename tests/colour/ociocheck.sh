#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ociocheck.sh CONFIG: OpenColorIO's own opinion of the shipped config. Exits 77
# without ociocheck (Debian: opencolorio-tools).
set -euo pipefail
command -v ociocheck >/dev/null || {
  echo "no ociocheck here"
  exit 77
}
# It reports a failing space or view in its text alone.
said=$(ociocheck --iconfig "$1" 2>&1)
echo "$said"
! grep -qiE 'error|warning|failed' <<<"$said"
