#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every command and every option of it answers --help.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"

works --version
check "--version says the ABI" grep -q 'ABI 1\.' "$scratch/out"
works help
check "help is --help" grep -q '^  render ' "$scratch/out"
works help bake
same "help bake" "$("$sozai" bake --help)" "$out"
works help grow fiber
same "help grow fiber" "$("$sozai" grow fiber --help)" "$out"
refuses 2 "unknown command 'bke'" help bke
works --help
check "--help lists render" grep -q '^  render ' "$scratch/out"
for name in list describe eval render bake colour figures gallery match grow saw validate; do
  works "$name" --help
  check "$name --help begins with its usage" grep -q "^usage: sozai $name" "$scratch/out"
  check "$name --help lists itself" grep -q -- '--help' "$scratch/out"
done
# Wherever it stands, and whatever else is wrong.
works render wood --spp nonsense --help

if [[ -c /dev/full ]]; then # what is not taken is told
  for words in --help --version "render --help" "grow fiber --help" list "describe wood --json" "validate --list"; do
    read -ra arguments <<<"$words"
    "$sozai" "${arguments[@]}" >/dev/full 2>"$scratch/err"
    same "exit code of: sozai $words, to a full device" 1 "$?"
    check "and why: $(<"$scratch/err")" \
      grep -q 'cannot write standard output: No space left on device' "$scratch/err"
  done
fi
# A pipe that nobody reads any more is no mistake of ours.
for words in list "describe wood" "describe wood --json" limits "bake --help"; do
  read -ra arguments <<<"$words"
  mkfifo "$scratch/unread"
  true <"$scratch/unread" &
  exec 3>"$scratch/unread"
  wait
  "$sozai" "${arguments[@]}" >&3 2>"$scratch/err"
  same "exit code of: sozai $words, to a closed pipe" 141 "$?"
  same "and no word" "" "$(<"$scratch/err")"
  exec 3>&-
  rm "$scratch/unread"
done
refuses 2 "unknown option --nosuch|see sozai grow fiber --help" grow fiber --nosuch

refuses 2 "unknown command 'rendr'" rendr
run_command
same "exit code without a command" 2 "$code"
check "without a command, the help goes to standard error" grep -q '^usage' "$scratch/err"
finish
