#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# shape.sh BENCH PLUGIN SCRATCH JSON_CHECK: options, exit codes, and the form of
# the results of a short run.
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
readonly json_check=$4
mkdir "$scratch/tmp"
export TMPDIR=$scratch/tmp

works --help
check "--help begins with its usage" grep -q '^usage: sozai-bench' "$scratch/out"
for option in --filter --list --quick --json --help; do
  check "--help lists $option" grep -q -- "$option" "$scratch/out"
done

works --list
for name in wood.full.batch{1024,16,1} wood.full.batch{1024,16,1}@scalar wood.threads2.batch1024 \
  stone.full.batch{1024,1} stone.full.batch{1024,1}@scalar \
  wood.create wood.load wood.load_alone wood.albedo.batch1024 wood.grain_wavy.batch1024 \
  wood.porosity_ring.batch1024 wood.footprint_{0.01,0.0625,0.1,0.3,1,3,10,30,100}.batch1024; do
  check "--list has $name" grep -qxF "$name" "$scratch/out"
done
same "names that stand twice" "" "$(sort "$scratch/out" | uniq -d)"
works --list --filter 'wood.full.*1$'
same "--filter picks" wood.full.batch1 "$out"

refuses 2 "--jsn" --jsn
refuses 2 "wood" wood
refuses 2 "--filter" --filter
refuses 2 "--filter|(|" --filter '('
refuses 2 "no such entry" --filter 'no such entry'
SOZAI_PLUGIN=$scratch/none.so refuses 2 "none.so" --quick --filter create

works --quick --json --filter '^wood\.(full\.batch1024|full\.batch1|time.*|create|load|load_alone)$'
check "it is JSON" "$json_check" "$scratch/out"
same "kind of JSON" "[" "${out:0:1}"
names=$(sed -n 's/^ *"name": "\(.*\)",$/\1/p' "$scratch/out" | tr '\n' ' ')
same "entries" \
  "wood.full.batch1024 wood.full.batch1 wood.time.batch1024 wood.create wood.load wood.load_alone " "$names"
for field in ns_per_point yardstick_ns ratio; do
  same "results with a positive $field" 6 \
    "$(grep -E "^ *\"$field\": [0-9.e+-]+,?\$" "$scratch/out" | grep -c '[1-9]')"
done
same "what it leaves behind" "" "$(ls "$TMPDIR")"

works --quick --filter 'wood.create'
check "a table without --json" grep -qE '^wood\.create +[a-z0-9]+ +[0-9.]+' "$scratch/out"
finish
