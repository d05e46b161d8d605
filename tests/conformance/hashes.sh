#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# hashes.sh check HASHES WORKER PLUGIN [EVERY [RUNNER...]]
# hashes.sh write HASHES WORKER PLUGIN
# check: PLUGIN answers with the bits recorded in HASHES, on every instruction set that the
# machine has. EVERY: one in so many lines only. RUNNER: what runs programs of another processor.
# write: renew HASHES and say what changed; refused where a look changed and its texture's
# `revision` did not grow, or a lower one is found. docs/guide.md says when.
set -euo pipefail
readonly action=$1 hashes=$2 worker=$3 plugin=$4
shift 4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

say_hash() { # CPU [EVERY [RUNNER...]]: into $scratch/CPU; exit code of the worker
  local cpu=$1 every=${2:-1} code=0
  shift $(($# > 1 ? 2 : 1))
  SOZAI_CPU=$cpu "$@" "$worker" "$plugin" "$every" >"$scratch/$cpu" || code=$?
  if ((code != 0 && code != 77)); then
    echo "FAILED: the worker on $cpu: exit code $code"
    exit 1
  fi
  return "$code"
}

recorded() { # a table of what stands in a file: "what is it: hash"
  sed -n 's/^\(texture\|geometry\) \([^ ]*\) \(.*\) \([^ ]*\)$/\1 \2 \3:\4/p' "$1" | sort
}

# Lines of $2 that say otherwise than $1 does, as "what it is".
changed() {
  join -t: -j 1 <(recorded "$1") <(recorded "$2") | awk -F: '$2 != $3 { print $1 }'
}

if [[ $action == write ]]; then
  # on one lane, which every machine has
  say_hash scalar
  new=$scratch/scalar refused=0
  if [[ -f $hashes ]]; then
    while read -r what kind; do
      was=$(sed -n "s/^$what $kind revision //p" "$hashes")
      is=$(sed -n "s/^$what $kind revision //p" "$new")
      mapfile -t lines < <(changed "$hashes" "$new" | grep "^$what $kind " | grep -v ' revision$' || true)
      if ((${#lines[@]} && is <= was)); then
        echo "FAILED: of $what $kind ${#lines[@]} lines changed, ${lines[0]} the first, and its revision is $is as before"
        refused=1
      fi
      if ((is < was)); then refused=1; fi
    done < <(sed -n 's/^\(.*\) revision .*/\1/p' "$hashes")
    if ((refused)); then
      echo "A change of what the same values look like raises the revision in the material's or"
      echo "generator's describe(); then record again. Nothing was written."
      exit 1
    fi
    echo "changed:"
    changed "$hashes" "$new" | sed 's/^/  /'
    echo "new:"
    join -t: -v 2 <(recorded "$hashes") <(recorded "$new") | sed 's/^/  /'
    echo "gone:"
    join -t: -v 1 <(recorded "$hashes") <(recorded "$new") | sed 's/^/  /'
  fi
  {
    echo "# What every texture and generator answers, as hashes: tests/conformance/hash_worker.c."
    echo "# Written by: cmake --build build --target hash-record"
    cat "$new"
  } >"$scratch/file"
  cp "$scratch/file" "$hashes"
  echo "recorded in $hashes"
  exit 0
fi

every=${1:-1}
shift $(($# > 0))
read -ra sets <<<"${SOZAI_TEST_SETS:-scalar sse2 avx2 avx512}" # other.sh
if (($#)) || [[ $(uname -m) == aarch64 ]]; then sets=(scalar neon); fi
failed=0
for cpu in "${sets[@]}"; do
  say_hash "$cpu" "$every" "$@" || {
    echo "$cpu: not on this machine"
    continue
  }
  count=$(grep -cv revision "$scratch/$cpu")
  if ((count < 240 / every)); then
    echo "FAILED: only $count hashes on $cpu"
    failed=1
  fi
  mapfile -t lines < <(changed "$hashes" "$scratch/$cpu")
  mapfile -t unknown < <(join -t: -v 2 <(recorded "$hashes") <(recorded "$scratch/$cpu"))
  missing=()
  if ((every == 1)); then
    mapfile -t missing < <(join -t: -v 1 <(recorded "$hashes") <(recorded "$scratch/$cpu"))
  fi
  echo "$cpu: $count hashes, ${#lines[@]} other than recorded, ${#unknown[@]} not recorded, ${#missing[@]} gone"
  printf '  %s\n' "${lines[@]:0:10}" "${unknown[@]:0:10}" "${missing[@]:0:10}" | grep -v '^ *$' || true
  if ((${#lines[@]} + ${#unknown[@]} + ${#missing[@]})); then failed=1; fi
done
if ((failed)); then
  cat <<'END'
FAILED: these answers are not those recorded in tests/conformance/hashes.txt.
  Not meant: something depends on the compiler, the machine or chance, or a change
    reaches further than it should. conformance.identity says whether builds differ among themselves.
  Meant: scenes of before will look different. Raise that texture's or generator's `revision`, then
    cmake --build build --target hash-record
    and read what it prints. What is new or gone alone needs no revision, only the target.
END
fi
exit "$failed"
