# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# For the scripts beside it, which are run as: SCRIPT SOZAI PLUGIN SCRATCH [TOOL...]
# Every check says what it wanted, what it got, and fails the script at its end.
set -uo pipefail
readonly sozai=$1 scratch=$3
export SOZAI_PLUGIN=$2
shift 3
unset OCIO
rm -rf "$scratch"
mkdir -p "$scratch"
failures=0
checks=0

# shellcheck source=tests/cli/foreign.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/foreign.sh" "$SOZAI_PLUGIN"
for program in iinfo oiiotool maketx; do
  if [[ $runtime ]] && command -v $program >/dev/null; then
    eval "$program() { foreign $program \"\$@\"; }"
  fi
done

failed() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$*"
}

check() { # what, command...
  local what=$1
  shift
  checks=$((checks + 1))
  "$@" || failed "$what"
}

not() { # command...
  ! "$@"
}

same() { # what, wanted, got
  checks=$((checks + 1))
  [[ $2 == "$3" ]] || failed "$1"$'\n  wanted: '"$2"$'\n  got:    '"$3"
}

# run_command [argument...]: standard output to $out, standard error to $err,
# exit code to $code; standard input as it is.
run_command() {
  "$sozai" "$@" >"$scratch/out" 2>"$scratch/err"
  code=$?
  # shellcheck disable=SC2034 # for the scripts
  out=$(<"$scratch/out")
  err=$(<"$scratch/err")
}

works() { # [argument...]
  run_command "$@"
  same "exit code of: sozai $*"$'\n'"$err" 0 "$code"
}

# refuses CODE 'word|word|...' [argument...]: exits with the code, with one line on
# standard error that holds every word, and nothing on standard output.
refuses() {
  local wanted=$1 word words lines
  IFS='|' read -ra words <<<"$2"
  shift 2
  run_command "$@"
  same "exit code of: sozai $*" "$wanted" "$code"
  mapfile -t lines <"$scratch/err"
  same "lines of message of: sozai $*" 1 "${#lines[@]}"
  for word in "${words[@]}"; do
    checks=$((checks + 1))
    [[ $err == *"$word"* ]] || failed "sozai $*"$'\n'"  wanted '$word' in: $err"
  done
}

finish() {
  if ((failures)); then
    printf '%d of %d checks failed\n' "$failures" "$checks"
    exit 1
  fi
  printf '%d checks passed\n' "$checks"
  rm -rf "$scratch"
}
