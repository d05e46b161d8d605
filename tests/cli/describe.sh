#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# list and describe: valid JSON that holds everything the plugin says.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh" "$@"
readonly json_check=$4

works list
check "list names wood" grep -qw wood "$scratch/out"
works list --json
check "list --json is JSON" "$json_check" "$scratch/out"
works describe wood
check "describe says where presets come from" grep -q 'Source: ' "$scratch/out"
works describe wood --json
check "describe --json is JSON and complete" "$json_check" "$scratch/out" "$SOZAI_PLUGIN" wood

refuses 2 "unknown material 'stile'|wood" describe stile
refuses 2 "no material" describe
refuses 2 "'more'" describe wood more
refuses 2 "--yaml" describe wood --yaml
finish
