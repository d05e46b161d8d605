#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# addon.sh SCRIPT SOZAI ADDON READER SCRATCH: run a script of this folder inside
# Blender, without a window. Exits 77 without Blender.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
readonly here script=$1
export SOZAI=$2 SOZAI_ADDON=$3 SOZAI_SCRATCH=$5
reader=$4
unset OCIO OIIO_LIBRARY_PATH

command -v blender >/dev/null || {
  echo "no blender here (Debian: blender)"
  exit 77
}
[[ -f $reader ]] || {
  echo "no $reader"
  exit 1
}
rm -rf "$SOZAI_SCRATCH"
mkdir -p "$SOZAI_SCRATCH"
export SOZAI_RESULT=$SOZAI_SCRATCH/result PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
# Blender keeps its own settings and temporary files to the scratch folder
export BLENDER_USER_CONFIG=$SOZAI_SCRATCH/config BLENDER_USER_SCRIPTS=$SOZAI_SCRATCH/scripts
export TMPDIR=$SOZAI_SCRATCH
mkdir -p "$BLENDER_USER_CONFIG" "$BLENDER_USER_SCRIPTS"
# -noaudio: a machine without sound; python-use-system-env: for PYTHONPATH
blender --background --factory-startup -noaudio --python-use-system-env \
  --python "$here/$script.py" >"$SOZAI_SCRATCH/log" 2>&1 || true
grep -vE '^(Fra:|Info:|Saved:| Time:|Read |Blender |$)' "$SOZAI_SCRATCH/log" || true
[[ -f $SOZAI_RESULT && $(<"$SOZAI_RESULT") == passed ]] || exit 1
rm -rf "$SOZAI_SCRATCH"
