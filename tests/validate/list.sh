#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# list.sh PROGRAM PAGE [--write]: the page's table is what --list prints, line for line, and
# every name begins with its group's. --write renews it.
set -euo pipefail
readonly program=$1 page=$2 mode=${3:-}

table() {
  "$program" --list | awk '
    /^[a-z]/ { split($0, head, ": "); group = head[1]
               printf "\n### %s\n\n%s.\n\n| check | holds when |\n|---|---|\n", group, toupper(substr(head[2], 1, 1)) substr(head[2], 2); next }
    { name = $1; if (index(name, group ".") != 1) { print "BAD NAME " name; exit 1 }
      sub(/^ *[^ ]+ +/, ""); gsub(/\|/, "\\|"); printf "| `%s` | %s |\n", name, $0 }'
}

between() {
  sed -n '/^<!-- checks -->$/,/^<!-- end of checks -->$/p' "$page" | sed '1d;$d'
}

if [[ $mode == --write ]]; then
  table >"$page.table"
  sed -i -e "/^<!-- checks -->\$/,/^<!-- end of checks -->\$/{//!d}" \
    -e "/^<!-- checks -->\$/r $page.table" "$page"
  rm "$page.table"
  exit
fi

if ! diff <(table) <(between); then
  echo "FAILED: the table of $page is not that of --list; renew it with: $0 $program $page --write"
  exit 1
fi
count=$("$program" --list | grep -c '^  ')
echo "$count checks listed, as in the page"
((count >= 80))
doubled=$("$program" --list | awk '/^  / { print $1 }' | sort | uniq -d)
if [[ $doubled ]]; then
  echo "FAILED: named twice: $doubled"
  exit 1
fi
