#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Bake on a Slurm cluster: an array job of shares, and a job that merges them
# once all have ended well. The folder of the output must be one that every
# node sees.
#
#   docs/example/bake-slurm.sh 16 floor.sozai -o floor.exr --res 32768 --mip
#
# SOZAI names another sozai; SBATCH_PARTITION, SBATCH_TIMELIMIT and the like are
# sbatch's own. A share that is preempted or fails is taken up where it stopped
# when it is queued again.
set -euo pipefail
sozai=${SOZAI:-sozai}

if [[ -n ${SLURM_ARRAY_TASK_ID:-} ]]; then
  exec "$sozai" bake "$@" --threads "${SLURM_CPUS_PER_TASK:-1}" \
    --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
fi
if [[ -n ${SLURM_JOB_ID:-} ]]; then
  exec "$sozai" bake "$@" --merge
fi

if (($# < 2)); then
  echo "usage: $0 SHARES <material|file.sozai> -o FILE [options of sozai bake]" >&2
  exit 2
fi
shares=$1
shift
array=$(sbatch --parsable --requeue --job-name=bake --array="1-$shares" \
  --output=bake-%A-%a.log "$0" "$@")
merge=$(sbatch --parsable --job-name=bake-merge --dependency="afterok:$array" \
  --kill-on-invalid-dep=yes --output=bake-merge-%j.log "$0" "$@")
echo "$array $merge"
