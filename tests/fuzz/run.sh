#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run.sh BUILD [SECONDS [TARGET...]]: libFuzzer on each target of a build of the preset `fuzz` for so
# many seconds, one at a time, then a table of all runs so far: executions, seconds, edges
# covered, and inputs that ended it. Without SECONDS only the table. Logs, what was learnt (corpora) and crashes
# stay in BUILD/fuzz, or in $FUZZ_WORK. Exits 1 where an input ended a target.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$1 seconds=${2:-0}
shift $(($# > 1 ? 2 : 1))
work=${FUZZ_WORK:-$build/fuzz}
mkdir -p "$work"
touch "$work/runs.tsv"
targets=("$@")
if ((${#targets[@]} == 0)); then
  for program in "$build"/tests/bin/fuzz-*; do
    if [[ $program != */fuzz-meshfile ]]; then targets+=("${program##*/fuzz-}"); fi
  done
fi

# Refused memory is an answer, not a crash. Vectors that libraries of others grow, which are not
# instrumented, look as if they were read past their ends.
export ASAN_OPTIONS=${ASAN_OPTIONS:-allocator_may_return_null=1:detect_leaks=1:detect_container_overflow=0}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}

stat_of() { # log, name
  sed -n "s/^stat::$2: *//p" "$1" | tail -n 1
}

# Until the time is up: an input that ends the process is kept, and the rest goes on
# without it. Ten are enough to begin mending.
run() { # target
  local name=$1 end=$((SECONDS + seconds)) left=$seconds begin found=0 code executed log
  local folders options=()
  local longest=600 # bytes that are taken one by one
  case $name in
    recipe | csv | field | alias | png | ply | pieces | meshfile) longest=4096 ;;
  esac
  local dictionary=$here/dictionaries/$name.dict
  if [[ -f $dictionary ]]; then options+=("-dict=$dictionary"); fi
  mkdir -p "$work/corpus/$name" "$work/found/$name"
  folders=("$work/corpus/$name" "$here/corpus/$name")
  if [[ -d $here/regressions/$name ]]; then folders+=("$here/regressions/$name"); fi
  # the clock is read once a turn: libFuzzer takes 0 seconds for no limit
  while ((left > 0 && found < 10)); do
    begin=$SECONDS code=0
    log=$work/$name.$(date +%s).$found.log
    "$build/tests/bin/fuzz-$name" "-max_total_time=$left" -timeout=25 \
      -rss_limit_mb=2560 "-max_len=$longest" -len_control=0 -print_final_stats=1 -close_fd_mask=0 \
      "-artifact_prefix=$work/found/$name/" "${options[@]}" \
      "${folders[@]}" >"$log" 2>&1 || code=$?
    executed=$(stat_of "$log" number_of_executed_units)
    if ((code != 0)); then found=$((found + 1)); fi
    printf '%s\t%s\t%s\t%s\t%s\n' "$name" "${executed:-0}" $((SECONDS - begin)) \
      "$(grep -o 'cov: [0-9]*' "$log" | tail -n 1 | cut -d' ' -f2 || true)" \
      "$((code != 0))" >>"$work/runs.tsv"
    if ((code != 0)); then
      echo "$name: exit code $code, see $log"
      bad=1
    fi
    left=$((end - SECONDS))
  done
}

bad=0
if ((seconds > 0)); then
  for name in "${targets[@]}"; do run "$name"; done
fi
awk -F'\t' '
  { if (!($1 in runs)) order[++n] = $1
    runs[$1]++; executions[$1] += $2; seconds[$1] += $3; ended[$1] += $5
    if ($4 + 0 > covered[$1]) covered[$1] = $4 + 0
    all += $2; time += $3; bad += $5 }
  END { printf "%-10s %14s %9s %9s %7s\n", "target", "executions", "seconds", "edges", "ended"
    for (i = 1; i <= n; i++) { t = order[i]
      printf "%-10s %14d %9d %9d %7d\n", t, executions[t], seconds[t], covered[t], ended[t] }
    printf "%-10s %14d %9d %9s %7d\n", "together", all, time, "", bad }' "$work/runs.tsv"
exit $bad
