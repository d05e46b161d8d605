#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clean-root.sh [--keep] ROOT [COMMAND [ARGUMENT...]]
#
# Does a fresh clone build and pass on a Debian 12 that has nothing but its
# base system? Makes such a system in the folder ROOT (kept, and used again),
# copies it to ROOT.run, clones this repository's HEAD to /src/sozai there and
# runs COMMAND in the clone; without one, ./quickstart test. --keep: leave
# ROOT.run for a look. Needs root, debootstrap and this machine's Debian mirror.
set -euo pipefail

die() {
  printf 'clean-root: %s\n' "$*" >&2
  exit 1
}
usage() { sed -n '3,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }

# The second half of this script, in mount and process namespaces of its own:
# whatever happens, the mounts go when the last process does.
inside() {
  local run=$1
  shift
  mount -t proc proc "$run/proc"
  mount --rbind /dev "$run/dev"
  # Not this machine's environment: only what reaches the mirror.
  local proxies=() name
  for name in http_proxy https_proxy no_proxy; do
    if [[ -n ${!name:-} ]]; then proxies+=("$name=${!name}"); fi
  done
  exec chroot "$run" /usr/bin/env -i "${proxies[@]}" HOME=/root TERM=dumb LANG=C.UTF-8 CI=true \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    bash -c 'cd /src/sozai && exec "$@"' bash "$@" </dev/null
}
if [[ ${1:-} == --inside ]]; then
  shift
  inside "$@"
fi

keep=0
if [[ ${1:-} == --keep ]]; then
  keep=1
  shift
fi
if [[ $# == 0 || $1 == -* ]]; then
  usage
  exit 2
fi
((EUID == 0)) || die "chroot and mount want root"
command -v debootstrap >/dev/null || die "no debootstrap here (Debian: debootstrap)"
root=$(realpath -m "$1")
readonly keep root run=$root.run
shift
if (($# == 0)); then set -- ./quickstart test; fi
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
readonly here

# Debian's own among the machine's package sources, in whichever of apt's
# formats they are written: "deb URI SUITE COMPONENT" a line.
sources() {
  apt-get indextargets --format "\$(ORIGIN) deb \$(REPO_URI) \$(RELEASE) \$(COMPONENT)" \
    'Created-By: Packages' | sed -n '/ bookworm/s/^Debian //p' | sort -u
}

remove_run() {
  # Nothing may be mounted there any more; --one-file-system is for the day
  # that something is.
  if grep -q " $run/" /proc/self/mounts; then die "something is mounted below $run"; fi
  rm -rf --one-file-system "$run"
}

found=$(sources)
if [[ ! -f $root/etc/debian_version ]]; then
  mirror=$(awk '$3 == "bookworm" { print $2; exit }' <<<"$found")
  echo "== making a Debian 12 in $root from ${mirror:=http://deb.debian.org/debian}"
  debootstrap --variant=minbase --include=ca-certificates bookworm "$root" "$mirror" >"$root.log" ||
    die "debootstrap failed; see $root.log"
fi

echo "== copying it to $run"
if [[ -e $run ]]; then remove_run; fi
cp -a --reflink=auto "$root" "$run"
if [[ -n $found ]]; then printf '%s\n' "$found" >"$run/etc/apt/sources.list"; fi
# Proxies and whatever else this machine needs to reach its mirror.
apt-config dump | grep -E '^Acquire::(http|https|Check-|Retries)' \
  >"$run/etc/apt/apt.conf.d/99clean-root" || true
cp -L /etc/resolv.conf /etc/hosts "$run/etc/"

mkdir -p "$run/src"
if [[ -n $(git -C "$here" status --porcelain) ]]; then
  echo "== note: there are uncommitted changes, and a clone does not have them"
fi
git clone --quiet --no-hardlinks "$here" "$run/src/sozai"

echo "== running: $*"
start=$SECONDS
result=0
unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" --inside "$run" "$@" || result=$?
echo "== exit code $result after $((SECONDS - start)) s"
((keep)) || remove_run
exit "$result"
