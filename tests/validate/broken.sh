#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# broken.sh PROGRAM TABLE FOLDER REPORTS SANITIZED [long]: of every line of the table the plugin
# FOLDER/NAME.so fails the checks that it names and no others of their groups; of those after a
# question mark any may fail. long: and no others at all.
set -uo pipefail
readonly program=$1 table=$2 folder=$3 reports=$4 sanitized=$5 long=${6:-}
if [[ $sanitized == yes ]]; then
  echo "a sanitizer's build: it would end the process before the suite sees what becomes of it"
  exit 77
fi
rm -rf "$reports"
mkdir -p "$reports"
failed=0
caught=0
# shellcheck source=tests/locale.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../locale.sh"
readonly first='^(symbols|version)\.|^(init\.succeeds|init\.tables|describe\.(listed|strings|unique)|create\.default|evaluate\.answers|geometry\.grows|refuse\.(range|unknown))$'
comma=yes
comma_locale "$reports/locales" || comma=no

# The words of the first list that are in none of the others.
without() {
  local word
  for word in $1; do
    [[ " ${*:2} " == *" $word "* ]] || printf '%s ' "$word"
  done
}

while read -r name _ expected _; do
  if [[ $expected == surroundings.comma && $comma == no ]]; then
    echo "$name: not tried, no locale with a decimal comma can be made here"
    continue
  fi
  may=${expected#*\?}
  [[ $may == "$expected" ]] && may=''
  must=${expected%%\?*}
  must=${must//,/ } may=${may//,/ }
  # A slow machine is no failure; but the one that never ends is not waited for.
  limit=3600
  [[ $name == HANGS ]] && limit=10
  only=.
  if [[ ! $long ]]; then
    # those that others need come first: of a plugin that fails them the others say nothing
    only=$first
    for check in $must $may; do only+="|^${check%%.*}\\."; done
  fi
  "$program" "$folder/$name.so" --only "$only" --seed 1 --time-limit "$limit" >"$reports/$name.txt" 2>&1
  code=$?
  is=''
  while read -r word check _; do
    [[ $word == FAILED ]] && is+=" $check"
  done <"$reports/$name.txt"
  missed=$(without "$must" "$is")
  more=$(without "$is" "$must $may")
  if ((code != 1)) || [[ $missed || $more ]]; then
    echo "FAILED: $name: exit code $code; not caught by: $missed; failed besides: $more"
    sed 's/^/  /' "$reports/$name.txt" | grep -v '^    passed' | grep .
    failed=$((failed + 1))
  else
    caught=$((caught + 1))
  fi
done < <(grep '^[A-Z]' "$table")
echo "$caught defects of $((caught + failed)) caught by the checks that should and no others${long:+ of all}"
((failed == 0 && caught >= 25))
