#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# draw.sh [FOLDER] [PICTURE...]: the pictures of docs/blender.md, by the add-on and
# Cycles, without a window. FOLDER: docs/pictures of this checkout, unless given.
# PICTURE: board, floor, oak-behind, oak-aside, felt, sugi, pine; none: all.
# SOZAI: the program, unless build/bin/sozai.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../../.." && pwd)
readonly here root
export SOZAI=${SOZAI:-$root/build/bin/sozai} SOZAI_ADDON=$root/hosts/blender
readonly folder=${1:-$root/docs/pictures}
[[ -d $folder ]] || {
  echo "no folder $folder" >&2
  exit 1
}
SOZAI_PICTURES=$(cd -- "$folder" && pwd)
export SOZAI_PICTURES
(($#)) && shift
command -v blender >/dev/null || {
  echo "no blender here (Debian: blender)" >&2
  exit 1
}
[[ -x $SOZAI ]] || {
  echo "no $SOZAI: build first, or name it by SOZAI" >&2
  exit 1
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export SOZAI_SCRATCH=$scratch SOZAI_WANTED="$*" PYTHONDONTWRITEBYTECODE=1
# settings and temporary files of its own
export BLENDER_USER_CONFIG=$scratch/config BLENDER_USER_SCRIPTS=$scratch/scripts TMPDIR=$scratch
mkdir -p "$BLENDER_USER_CONFIG" "$BLENDER_USER_SCRIPTS"
unset OCIO OIIO_LIBRARY_PATH
blender --background --factory-startup -noaudio --python-exit-code 1 --python "$here/draw.py" \
  >"$scratch/log" 2>&1 || {
  grep -vE '^(Fra:| Time:|Read |$)' "$scratch/log" >&2
  exit 1
}
grep '^drawn: ' "$scratch/log"
