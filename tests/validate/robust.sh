#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# robust.sh PROGRAM PLUGIN SCRATCH: what is no plugin is refused or judged, never waited for; names
# and options of any kind come out well in every report.
set -uo pipefail
readonly program=$1 plugin=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"
failures=0

wrong() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# refused CODE 'words' argument...: that exit code, one line on standard error with the words.
refused() {
  local wanted=$1 words=$2 code
  shift 2
  "$program" "$@" >"$scratch/out" 2>"$scratch/err"
  code=$?
  ((code == wanted)) || wrong "$*: exit code $code, not $wanted: $(<"$scratch/err")"
  [[ $(grep -c '' "$scratch/err") == 1 ]] || wrong "$*: not one line: $(<"$scratch/err")"
  grep -qF -- "$words" "$scratch/err" || wrong "$*: no '$words' in: $(<"$scratch/err")"
}

# judged 'FAILED check' plugin argument...: exit code 1, that check failed, others skipped.
judged() {
  local check=$1 code
  shift
  "$program" "$@" --seed 1 >"$scratch/out" 2>"$scratch/err"
  code=$?
  ((code == 1)) || wrong "$*: exit code $code, not 1: $(<"$scratch/err")"
  [[ $(awk '$1 == "FAILED" { print $2 }' "$scratch/out") == "$check" ]] ||
    wrong "$*: failed: $(grep FAILED "$scratch/out"), not $check"
}

# ---- what is no plugin
refused 2 "no such file" "$scratch/none.so"
refused 2 "a folder" "$scratch"
mkfifo "$scratch/fifo"
refused 2 "not a file" "$scratch/fifo"
refused 2 "not a file" /dev/null
echo "not a library" >"$scratch/text.so"
refused 2 "ELF" "$scratch/text.so"
: >"$scratch/empty.so"
refused 2 "ELF" "$scratch/empty.so"
printf '\177ELF' >"$scratch/four.so"
judged symbols.opens "$scratch/four.so"
size=$(stat -c %s "$plugin")
for part in 100 1000 $((size / 3)) $((size / 2)); do
  head -c "$part" "$plugin" >"$scratch/cut.so"
  "$program" "$scratch/cut.so" --seed 1 >"$scratch/out" 2>&1
  code=$?
  ((code == 1)) || wrong "cut to $part bytes: exit code $code"
  # What is cut behind its segments may open; then it is the table of symbols that is missing.
  grep -Eq 'FAILED  symbols.(opens|entry)' "$scratch/out" || wrong "cut to $part bytes: passed"
done
# Rubbish in the tables of a file that loads no more, or still does: judged, not died of.
for seed in 1 2 3 4 5 6; do
  cp "$plugin" "$scratch/rubbish.so"
  for place in 40 48 60 $((64 + 56 * seed)) $((size - 64 * seed)) $((size - 200 * seed)); do
    printf '\xff\xff\xff\x7f' | dd of="$scratch/rubbish.so" bs=1 seek="$place" conv=notrunc status=none
  done
  "$program" "$scratch/rubbish.so" --only '^symbols' >"$scratch/out" 2>&1
  code=$?
  ((code <= 1)) || wrong "rubbish $seed: exit code $code: $(<"$scratch/out")"
done
# A library, but of another kind.
if command -v cc >/dev/null; then
  echo 'int another;' >"$scratch/other.c"
  if cc -shared -fPIC -o "$scratch/other.so" "$scratch/other.c" 2>/dev/null; then
    "$program" "$scratch/other.so" >"$scratch/out" 2>&1
    grep -q 'FAILED  symbols.entry' "$scratch/out" || wrong "a library without entry passes"
  fi
fi

# ---- options
refused 2 "no check's name matches" "$plugin" --only '^none$'
refused 2 "no regular expression" "$plugin" --only '('
refused 2 "has no 'marble'" "$plugin" --texture marble
refused 2 "--seed" "$plugin" --seed -1
refused 2 "--jobs" "$plugin" --jobs 0
refused 2 "--time-limit" "$plugin" --time-limit 0
refused 2 "cannot write" "$plugin" --only '^symbols' --junit "$scratch/none/report.xml"
refused 2 "cannot write" "$plugin" --only '^symbols' --json="$scratch/none/report.json"
refused 2 "unexpected argument" "$plugin" another
refused 2 "no plugin is given" --seed 1

# ---- names
odd="$scratch/a \"b\" <c> & 'd'"$'\n\t\e[31m\xff'"é.so"
cp "$plugin" "$odd"
"$program" "$odd" --only '^(symbols|version|init)\.' --junit "$scratch/odd.xml" \
  --json="$scratch/odd.json" >"$scratch/out" || wrong "an odd name: exit code $?"
grep -q $'\e' "$scratch/out" && wrong "a terminal's control in the text"
[[ $(head -2 "$scratch/out" | tail -1) == *" checks, seed "* ]] || wrong "an odd name is no line"
"$program" "$odd" --only '^symbols\.' --json >"$scratch/out.json" || wrong "--json: exit code $?"
python3 - "$scratch" <<'EOF' || wrong "a report is malformed"
import json, sys, xml.etree.ElementTree as tree
scratch = sys.argv[1]
for name in ("odd.json", "out.json"):
    plugin = json.load(open(f"{scratch}/{name}", encoding="utf-8"))["plugin"]
    assert '"b" <c> & \'d\'\n\t\x1b' in plugin, plugin
suites = tree.parse(scratch + "/odd.xml").getroot()
assert "\"b\" <c> & 'd'\n\t" in suites.get("name"), suites.get("name")
EOF

# ---- the seed repeats a run
"$program" "$plugin" --seed 77 --only '^inputs\.' --json >"$scratch/one.json"
"$program" "$plugin" --seed 77 --only '^inputs\.(lanes|hostile)' --json >"$scratch/two.json"
python3 - "$scratch" <<'EOF' || wrong "the seed does not repeat a run"
import json, sys
one, two = (json.load(open(f"{sys.argv[1]}/{n}.json")) for n in ("one", "two"))
asked = {r["name"]: (r["asked"], r["outcome"], r["seed"]) for r in one["results"]}
for r in two["results"]:
    assert asked[r["name"]] == (r["asked"], r["outcome"], r["seed"]) and r["seed"] == 77, r
EOF

# ---- a full disk
if [[ -e /dev/full ]]; then
  "$program" "$plugin" --only '^symbols' >/dev/full 2>"$scratch/err" && wrong "a full disk is no failure"
  grep -q 'cannot write standard output: No space left on device' "$scratch/err" || wrong "a full disk: $(<"$scratch/err")"
fi
# ---- restricted to a texture, everything else is skipped or passed
"$program" "$plugin" --texture plain --seed 1 >"$scratch/out" || wrong "--texture plain fails"
"$program" "$plugin" --texture rod --seed 1 >"$scratch/out" || wrong "--texture rod fails"
((failures == 0)) && echo "all as they should be"
exit $((failures != 0))
