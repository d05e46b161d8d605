#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# settings.sh WORKER PLUGIN COUNT [SEED|any]: COUNT textures of random settings answer with the same
# bits whatever else is in the batch, and on every instruction set that the machine has.
set -euo pipefail
worker=$1 plugin=$2 count=$3 seed=${4:-1}
if [[ $seed == any ]]; then seed=$RANDOM$RANDOM; fi
echo "seed $seed"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
first=
for cpu in scalar sse2 avx2 avx512 neon; do
  code=0
  SOZAI_CPU=$cpu "$worker" "$plugin" "$count" "$seed" >"$scratch/$cpu" 2>"$scratch/why" || code=$?
  if ((code == 77)); then continue; fi # this machine has it not
  sed "s/^/$cpu: /" "$scratch/why"
  if ((code)); then exit 1; fi
  if [[ -z $first ]]; then first=$cpu; fi
  if ! cmp -s "$scratch/$first" "$scratch/$cpu"; then
    echo "FAILED: $cpu does not answer as $first does; kind, seed and hash:"
    diff "$scratch/$first" "$scratch/$cpu" | head
    exit 1
  fi
done
