#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every command and every option of it answers --help.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"

works --version
check "--version says the ABI" grep -q 'ABI 1\.' "$scratch/out"
works --help
check "--help lists render" grep -q '^  render ' "$scratch/out"
for name in list describe eval render bake colour figures gallery match grow saw validate; do
  works "$name" --help
  check "$name --help begins with its usage" grep -q "^usage: sozai $name" "$scratch/out"
  check "$name --help lists itself" grep -q -- '--help' "$scratch/out"
done
# Wherever it stands, and whatever else is wrong.
works render wood --spp nonsense --help

refuses 2 "unknown command 'rendr'" rendr
run_command
same "exit code without a command" 2 "$code"
check "without a command, the help goes to standard error" grep -q '^usage' "$scratch/err"
finish
