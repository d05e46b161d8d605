#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# command.sh SOZAI PLUGIN SCRATCH: `sozai validate` is the program beside it, with its options
# and exit codes.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$1" "$2" "$3"
readonly plugin=$2

works validate "$plugin" --only '^symbols\.' --seed 5
check "groups are headed" grep -q '^symbols: ' "$scratch/out"
check "the seed is said" grep -q 'seed 5' "$scratch/out"
refuses 2 "--list|--json" validate --list --json
refuses 2 "--list|--json" validate --list --json="$scratch/list.json"
refuses 2 "--list|--junit" validate --list --junit "$scratch/list.xml"
works validate --list
check "the list names checks" grep -q '^  evaluate.guard-bands ' "$scratch/out"
works validate --help
check "its help is of sozai validate" grep -q '^usage: sozai validate' "$scratch/out"
refuses 2 "no plugin is given" validate
refuses 2 "unknown option --lst" validate --lst
finish
