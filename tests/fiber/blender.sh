#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Blender reads the curves of a .usda and the lines of an .obj as they were grown.
set -eu
sozai=$1
command -v blender >/dev/null || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for ending in usda obj; do
  "$sozai" grow fiber --hull ball -o "$work/a.$ending" -p count=40 -p vertices=10 -p diameter=200
done
cat >"$work/read.py" <<'PYTHON'
import bpy, sys
folder = sys.argv[-1]
if not hasattr(bpy.ops.wm, "usd_import") or "usd_import" not in dir(bpy.ops.wm):
    print("NO USD")
bpy.ops.wm.read_factory_settings(use_empty=True)
try:
    bpy.ops.wm.usd_import(filepath=folder + "/a.usda")
    for o in bpy.data.objects:
        if o.type == "CURVE":
            s = o.data.splines
            print("CURVES", len(s), sum(len(x.points) for x in s), "%.4f" % max(p.radius for x in s for p in x.points))
        if o.type == "CURVES":
            print("CURVES", len(o.data.curves), len(o.data.points))
except Exception as e:
    print("NO USD", e)
bpy.ops.wm.read_factory_settings(use_empty=True)
try:
    bpy.ops.import_scene.obj(filepath=folder + "/a.obj")
except Exception:
    bpy.ops.wm.obj_import(filepath=folder + "/a.obj")
print("OBJ", sum(len(o.data.vertices) for o in bpy.data.objects if o.type == "MESH"),
      sum(len(o.data.edges) for o in bpy.data.objects if o.type == "MESH"))
PYTHON
blender --background --factory-startup --python "$work/read.py" -- "$work" >"$work/log" 2>&1 || {
  tail -5 "$work/log"
  exit 1
}
grep -E '^(CURVES|OBJ|NO USD)' "$work/log"
grep -q '^OBJ 400 360' "$work/log" || { tail -20 "$work/log"; exit 1; }
# Debian's Blender 3.4 is built without USD: then OBJ alone is read here.
if ! grep -q '^NO USD' "$work/log"; then
  grep -q '^CURVES 40 400' "$work/log" || { tail -20 "$work/log"; exit 1; }
fi
