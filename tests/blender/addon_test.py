# SPDX-License-Identifier: Apache-2.0
"""Run inside Blender by addon.sh: what the tests share.

Each check prints what it wanted and what it got where they differ; finish()
says how many there were, and sets the exit code through $SOZAI_RESULT, since
Blender's own is 0 whatever a script does.
"""
import csv
import io
import math
import os
import subprocess
import sys

import bpy

sys.path.insert(0, os.environ["SOZAI_ADDON"])
import sozai_addon  # noqa: E402
from sozai_addon import state  # noqa: E402,F401

scratch = os.environ["SOZAI_SCRATCH"]
sozai = os.environ["SOZAI"]
_counts = [0, 0]


def check(what, truth, got=None):
    _counts[0] += 1
    if not truth:
        _counts[1] += 1
        print("FAILED: %s%s" % (what, "" if got is None else "\n  got: %r" % (got,)))


def refused(what, words, call, *arguments, **named):
    """The operator reports one line with all the words."""
    try:
        call(*arguments, **named)
    except RuntimeError as error:
        text = str(error).strip()
        check(what, all(w in text for w in words) and len(text.splitlines()) == 1, text)
    else:
        check(what + " is refused", False)


def finish():
    print("%d of %d checks failed" % (_counts[1], _counts[0]) if _counts[1] else
          "%d checks passed" % _counts[0])
    with open(os.environ["SOZAI_RESULT"], "w", encoding="ascii") as out:
        out.write("failed\n" if _counts[1] else "passed\n")


def scene(name, enable=True):
    """An empty one, saved, that renders linear floats without a view transform."""
    if enable:
        sozai_addon.register()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.save_as_mainfile(filepath=os.path.join(scratch, name + ".blend"))
    s = bpy.context.scene
    s.render.engine = "CYCLES"
    s.cycles.device = "CPU"
    s.cycles.use_denoising = False
    s.view_settings.view_transform = "Raw"
    s.render.resolution_percentage = 100
    s.render.image_settings.file_format = "OPEN_EXR"
    s.render.image_settings.color_depth = "32"
    s.render.threads_mode, s.render.threads = "FIXED", 2
    return s


def show_output(material, name):
    """Its node group's output as the surface's emission: Cycles then renders the value itself."""
    tree = material.node_tree
    group = next(n for n in tree.nodes if n.type == "GROUP")
    glow = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(group.outputs[name], glow.inputs["Color"])
    tree.links.new(glow.outputs[0], tree.get_output_node("CYCLES").inputs["Surface"])


def look_from(s, place, rotation, width):
    """A camera without perspective; width: of the picture, in metres."""
    data = bpy.data.cameras.new("camera")
    data.type, data.ortho_scale = "ORTHO", width
    camera = bpy.data.objects.new("camera", data)
    camera.location, camera.rotation_euler = place, rotation
    s.collection.objects.link(camera)
    s.camera = camera
    return camera


def render(s, name, width, height, samples=16):
    """Rows from the bottom up, of [r, g, b]."""
    s.render.resolution_x, s.render.resolution_y = width, height
    s.cycles.samples = samples
    s.cycles.pixel_filter_type = "BOX"
    s.cycles.filter_width = 1.0
    s.render.filepath = os.path.join(scratch, name + ".exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(s.render.filepath, check_existing=False)
    image.colorspace_settings.name = "Non-Color"
    values = image.pixels[:]
    bpy.data.images.remove(image)
    return [[values[4 * (y * width + x):4 * (y * width + x) + 3] for x in range(width)]
            for y in range(height)]


def evaluate(recipe, points, normal, footprint, channel="albedo", light=(0, 0, 1)):
    """[r, g, b] of each point in mm, by the plugin, without OpenImageIO or Blender; seen along the
    normal."""
    lines = ["px,py,pz,nx,ny,nz,footprint,lx,ly,lz,vx,vy,vz"]
    lines += [",".join("%.9g" % v for v in (*p, *normal, footprint, *light, *normal))
              for p in points]
    done = subprocess.run([sozai, "eval", recipe, "--channels", channel],
                          input="\n".join(lines) + "\n", capture_output=True, text=True,
                          check=True)
    rows = list(csv.reader(io.StringIO(done.stdout)))
    return [[float(v) for v in row] for row in rows[1:]]


def compare(what, pixels, wanted, rms_allowed, mean_allowed):
    """Two lists of [r, g, b]."""
    count = len(wanted)
    square = sum((a - b) ** 2 for p, w in zip(pixels, wanted) for a, b in zip(p, w))
    rms = math.sqrt(square / (3 * count))
    means = [sum(v[c] for v in wanted) / count for c in range(3)]
    off = max(abs(sum(p[c] for p in pixels) / count - means[c]) for c in range(3))
    spread = math.sqrt(sum((w[c] - means[c]) ** 2 for w in wanted for c in range(3)) / (3 * count))
    print("%-28s rms %.4f (allowed %.3f)  mean %.4f (allowed %.3f)  contrast %.4f  %d pixels"
          % (what, rms, rms_allowed, off, mean_allowed, spread, count))
    check(what + ": rms", rms <= rms_allowed, rms)
    check(what + ": mean", off <= mean_allowed, off)
    check(what + ": there is something to see", spread > 2 * rms_allowed, spread)
