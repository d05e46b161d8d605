#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# symbols.sh LIBRARY SYMBOL [--libc-only]: the library exports that one symbol,
# a datum, and nothing else. --libc-only: it needs no library but libc, and
# asks libc for nothing that a guest in a renderer must not do.
set -euo pipefail
readonly library=$1 symbol=$2 mode=${3:-}
failed=0

# Letters as nm's: D and R are writable and read-only data, B is zeroed data.
exported=$(nm -D --defined-only --format=posix "$library" | awk '{ print $1, $2 }')
echo "exported: $exported"
if ! [[ $exported =~ ^$symbol\ [DRB]$ ]]; then
  echo "FAILED: expected the datum $symbol alone"
  failed=1
fi

if [[ $mode == --libc-only ]]; then
  needed=$(readelf -d "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
  echo "needs: ${needed//$'\n'/ }"
  if grep -Eq '^lib(asan|ubsan|tsan)\.' <<<"$needed"; then
    echo "a sanitizer's build: the rest does not apply"
    exit "$((failed ? 1 : 77))"
  fi
  # The loader may be named too: on some machines it defines __tls_get_addr.
  others=$(grep -Ev '^(libc\.so\.6|ld-linux[^ ]*)$' <<<"$needed" || true)
  if [[ -n $others ]]; then
    echo "FAILED: needs more than libc: ${others//$'\n'/ }"
    failed=1
  fi
  # exit and abort end the host, printing writes into its terminal, and locale,
  # rounding mode and signal handlers are the host's own.
  forbidden=$(nm -D --undefined-only --format=posix "$library" | sed 's/[@ ].*//' |
    grep -Ex '_?exit|_Exit|quick_exit|abort|__assert_fail|raise|signal|sigaction|setlocale|fesetround|fesetenv|feenableexcept|v?printf|__v?printf_chk|puts|putchar|perror|stdout|stderr' || true)
  if [[ -n $forbidden ]]; then
    echo "FAILED: calls what the header rules out: ${forbidden//$'\n'/ }"
    failed=1
  fi
fi
exit "$failed"
