#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sound.sh PROGRAM PLUGIN SCRATCH LEAST [option...]: a sound plugin fails nothing, and at least
# LEAST checks were passed and not skipped; both reports say the same.
set -uo pipefail
readonly program=$1 plugin=$2 scratch=$3 least=$4
shift 4
rm -rf "$scratch"
mkdir -p "$scratch"
# shellcheck source=tests/locale.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../locale.sh"
comma_locale "$scratch/locales" || echo "no locale with a decimal comma can be made here"
# The limit is there for what never ends; a slow machine is no failure.
"$program" "$plugin" --seed 1 --time-limit 3600 --json="$scratch/report.json" --junit "$scratch/report.xml" "$@" \
  >"$scratch/out"
code=$?
grep -v '^  passed' "$scratch/out" | grep .
if ((code != 0)); then
  echo "FAILED: exit code $code"
  exit 1
fi
python3 - "$scratch" "$least" <<'EOF'
import json, sys, xml.etree.ElementTree as tree
scratch, least = sys.argv[1], int(sys.argv[2])
report = json.load(open(scratch + "/report.json"))
suites = tree.parse(scratch + "/report.xml").getroot()
outcomes = [r["outcome"] for r in report["results"]]
assert report["checks"] == len(outcomes) >= 80, report["checks"]
assert report["failed"] == outcomes.count("failed") == 0
assert report["skipped"] == outcomes.count("skipped")
assert report["passed"] == outcomes.count("passed") >= least, report["passed"]
assert int(suites.get("tests")) == len(outcomes) == len(suites.findall("*/testcase"))
assert int(suites.get("failures")) == 0
assert int(suites.get("skipped")) == report["skipped"] == len(suites.findall("*/testcase/skipped"))
for r in report["results"]:
    assert r["outcome"] != "passed" or r["asked"] > 0, r
    assert r["outcome"] != "skipped" or r["reason"], r
    assert r["seed"] in (None, 1), r
seeded = sum(r["seed"] is not None for r in report["results"])
assert seeded > 20, seeded
print(f"{report['checks']} checks, {report['passed']} passed, {report['skipped']} skipped, "
      f"{sum(r['asked'] for r in report['results'])} questions, {report['seconds']:.0f} s")
EOF
