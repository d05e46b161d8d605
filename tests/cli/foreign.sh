# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# source foreign.sh PLUGIN: programs of the distribution that load what is built here.
# Where that is built with AddressSanitizer or ThreadSanitizer, they need its runtime before
# all else; what they leak is their own.
runtime=$(ldd "$1" | awk '$1 ~ /^lib[at]san/ { print $3 }')

foreign() { # program argument...
  if [[ $runtime ]]; then
    LD_PRELOAD=$runtime ASAN_OPTIONS=${ASAN_OPTIONS-}:detect_leaks=0 command "$@"
  else
    command "$@"
  fi
}
