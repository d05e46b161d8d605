# SPDX-License-Identifier: Apache-2.0
"""How much memory does a picture of 16384 x 16384 pixels take in Cycles?

Cycles holds whole pictures: at its full size a .sozai picture takes what a file
takes, 8 bytes a texel. But a file is read whole whatever Simplify's texture
limit says, and shrunk then; a .sozai picture is only ever made as large as the
limit. So the render, in a process of its own, must stay below the baked file's
size: estimated from a 64th of it, baked at the same width of texel.

With SOZAI_TEST_FULL=1 the whole is baked (minutes, and some GB of disk), and
rendered with and without the limit.
"""
import os
import resource
import subprocess
import sys

import bpy
from addon_test import check, finish, look_from, render, scene, scratch, show_output, sozai

PIXELS, SIDE, LIMIT = 16384, 1024.0, "2048"
TEXEL = SIDE / PIXELS
MIB = 1 << 20


def child(name, limit, picture):
    """A cold render of a board; picture: a baked file in place of the .sozai file's, or ''."""
    s = scene(name)
    bpy.ops.mesh.primitive_plane_add(size=SIDE / 1000)
    if limit:
        s.render.use_simplify, s.cycles.texture_limit_render = True, limit
    bpy.ops.sozai.new(kind="wood", preset="keyaki")
    material = bpy.context.object.active_material
    material.sozai.texel, material.sozai.most_pixels = TEXEL, PIXELS
    bpy.ops.sozai.update()
    # one picture alone
    for node in material.sozai.group.nodes:
        if node.type == "TEX_IMAGE" and node.label == "albedo" and picture:
            node.image.filepath = picture
    show_output(material, "Albedo")
    look_from(s, (0, 0, 1), (0, 0, 0), SIDE / 1000)
    pixels = render(s, name, 64, 64, 4)
    red = sum(p[0] for row in pixels for p in row) / 4096
    with open(os.path.join(scratch, name + ".peak"), "w", encoding="ascii") as out:
        out.write("%d %.6f" % (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, red))


def measure(name, limit="", picture=""):
    """Peak resident bytes of the render alone, and its mean red."""
    environment = os.environ | {"SOZAI_CHILD": "|".join((name, limit, picture))}
    subprocess.run([bpy.app.binary_path, "--background", "--factory-startup", "-noaudio",
                    "--python-use-system-env", "--python", __file__], env=environment,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    with open(os.path.join(scratch, name + ".peak"), encoding="ascii") as file:
        peak, red = file.read().split()
    return int(peak) * 1024, float(red)


def bake(pixels, name):
    path = os.path.join(scratch, name)
    side = TEXEL * pixels
    subprocess.run([sozai, "bake", "wood", "--preset", "keyaki", "-p", "cut=flat", "--outputs",
                    "albedo", "--shape", "plane", "--size", "%gx%g" % (side, side), "--res", str(pixels), "-o", path],
                   check=True)
    return path, os.path.getsize(path)


if "SOZAI_CHILD" in os.environ:
    child(*os.environ["SOZAI_CHILD"].split("|"))
    sys.exit()
full = os.environ.get("SOZAI_TEST_FULL") == "1"
path, size = bake(PIXELS if full else PIXELS // 8, "baked.exr")
if not full:
    size *= 64
print("baked file, %d x %d, zip: %d MiB%s" % (PIXELS, PIXELS, size / MIB,
                                             "" if full else " (64 times a 64th)"))
empty, _ = measure("small", "128")
peak, red = measure("limited", LIMIT)
print("a picture of 128 x 128: %d MiB" % (empty / MIB))
print("a .sozai picture of %d, limit %s: %d MiB" % (PIXELS, LIMIT, peak / MIB))
check("less than the baked file", peak < size, (peak, size))
check("the limit costs its picture and not more", peak - empty < 3 * 8 * int(LIMIT) ** 2 * 2,
      peak - empty)
check("there is wood to see", 0.2 < red < 0.8, red)
if full:
    for name, limit, picture in (("whole", "", ""), ("file", "", path), ("shrunk", LIMIT, path)):
        peak, red = measure(name, limit, picture)
        print("%s, limit %s: %d MiB" % ("baked file" if picture else ".sozai picture",
                                        limit or "none", peak / MIB))
finish()
