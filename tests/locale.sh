# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# comma_locale FOLDER: a locale with a decimal comma, made there where this machine has the
# means, and named to programs by LOCPATH; else 1.
comma_locale() {
  command -v localedef >/dev/null || return 1
  mkdir -p "$1"
  # It warns of what does not matter here, with another exit code.
  localedef --no-archive -i de_DE -f UTF-8 "$1/de_DE.UTF-8" >/dev/null 2>&1
  [[ -e $1/de_DE.UTF-8/LC_NUMERIC ]] || return 1
  export LOCPATH=$1
}
