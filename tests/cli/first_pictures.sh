#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every command of docs/first-pictures.md, small: each does what it says, and the picture that it
# names is there and is not of one colour.
set -uo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/cli/lib.sh
source "$here/lib.sh"
readonly picture=$1 page=$here/../../docs/first-pictures.md

cd "$scratch" || exit 1
run() { # a command of the page's
  local -a words
  eval "words=($1)"
  local size=()
  case ${words[1]:-} in
    render) size=(--res 96x72 --spp 2) ;;
    grow) size=(--res 72x96 --spp 2) ;;
    bake) size=(--res 64) ;;
  esac
  "$sozai" "${words[@]:1}" "${size[@]}" >/dev/null
}

pictures=0
while IFS= read -r line; do
  case $line in
    sozai\ *)
      check "$line" run "$line"
      [[ $line =~ -o\ ([a-z]+\.(png|exr)) ]] || continue
      check "$line: writes ${BASH_REMATCH[1]}" test -s "${BASH_REMATCH[1]}"
      check "$line: shows something" "$picture" varies "${BASH_REMATCH[1]}"
      pictures=$((pictures + 1))
      ;;
    printf\ *) eval "$line" ;;
    *) failed "the page has a line that is no command: $line" ;;
  esac
done < <(sed -n 's/^    //p' "$page")
check "the page has its pictures" test "$pictures" -ge 10
finish
