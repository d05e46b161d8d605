#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The example for Slurm, on a cluster of one node that is this machine: its
# own configuration, key, ports and folders. Debian: slurm-wlm.
for tool in sbatch slurmctld slurmd munged; do
  PATH=$PATH:/usr/sbin command -v $tool >/dev/null || {
    echo "no $tool on this machine"
    exit 77
  }
done
PATH=$PATH:/usr/sbin
# shellcheck source=tests/cli/lib.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/lib.sh" "$@"
readonly example=$4
[[ $sozai == /* ]] || exit 1
# Sockets' names may not be long.
cluster=$(mktemp -d /tmp/sozai-slurm-XXXXXX)
readonly cluster
daemons=()
stop() {
  local process
  for process in "${daemons[@]}"; do kill "$process" 2>/dev/null; done
  wait
  rm -rf "$cluster"
}
trap stop EXIT

user=$(id -un)
name=$(hostname -s)
port=$((20000 + $$ % 20000))
mkdir "$cluster/state" "$cluster/spool"
chmod 755 "$cluster"
dd if=/dev/urandom of="$cluster/munge.key" bs=1024 count=1 status=none
chmod 600 "$cluster/munge.key"
export SLURM_CONF=$cluster/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=sozai
SlurmctldHost=$name(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/builtin
SelectType=select/linear
SchedulerParameters=batch_sched_delay=0,sched_interval=1
NodeName=$name NodeAddr=127.0.0.1 CPUs=1 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES State=UP OverSubscribe=FORCE:4
CONF
munged --foreground --force --socket="$cluster/munge.socket" --key-file="$cluster/munge.key" \
  --pid-file="$cluster/munge.pid" --seed-file="$cluster/munge.seed" \
  --log-file="$cluster/munge.log" --num-threads=2 &>"$cluster/munged.out" &
daemons+=($!)
slurmctld -D -c &>"$cluster/slurmctld.out" &
daemons+=($!)
slurmd -D -N "$name" &>"$cluster/slurmd.out" &
daemons+=($!)

up=no
for ((i = 0; i < 150; i++)); do
  if sinfo -h -o %T 2>/dev/null | grep -qE 'idle|mixed'; then
    up=yes
    break
  fi
  sleep 0.2
done
if [[ $up == no ]]; then
  echo "Slurm does not start here:"
  tail -n 3 "$cluster"/*.out "$cluster"/*.log
  exit 77
fi

cd "$scratch" || exit 1
works bake wood --res 256 --size 60x60 --mip -o one.exr
jobs=$(SOZAI=$sozai "$example" 4 wood --res 256 --size 60x60 --mip -o cluster.exr)
read -r array merge <<<"$jobs"
check "two jobs: $jobs" test -n "$merge"
# Until neither is waiting or running any more.
while [[ -n $(squeue -h -j "$array,$merge" 2>/dev/null) ]]; do sleep 0.2; done
check "the merged picture: $(cat bake-*.log)" cmp one.exr cluster.exr
same "four shares ran" 4 "$(find . -name "bake-$array-*.log" | wc -l)"
check "the pieces are gone" test ! -e cluster.exr.bake

# Arguments that are wrong: the shares fail, and nothing is merged.
jobs=$(SOZAI=$sozai "$example" 2 wood --res 0 -o wrong.exr)
read -r array merge <<<"$jobs"
while [[ -n $(squeue -h -j "$array,$merge" 2>/dev/null) ]]; do sleep 0.2; done
check "a failed share says why" grep -q "resolution: '0'" "bake-$array-1.log"
check "and there is no picture" test ! -e wrong.exr
finish
