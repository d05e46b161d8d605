# SPDX-License-Identifier: Apache-2.0
"""A board, a laid floor and an unwrapped mesh in Cycles, against the plugin's own albedo."""
import math
import os

import bpy
from mathutils import Vector
from addon_test import check, compare, evaluate, finish, look_from, render, scene, scratch, \
    show_output

HALF_TURN = math.pi


def middles(width, height, side):
    """Of a picture's pixels, in mm about its middle, from the bottom row up."""
    return [(side * (x + 0.5 - width / 2), side * (y + 0.5 - height / 2))
            for y in range(height) for x in range(width)]


def flatten(rows):
    return [p for row in rows for p in row]


def plane(name, size, preset, values, texel):
    """A floor on an object scaled unevenly, seen from straight above, 60 pixels wide."""
    s = scene(name, enable=False)
    bpy.ops.mesh.primitive_plane_add(size=1)
    bpy.context.object.scale = (size[0] / 1000, size[1] / 1000, 1)
    bpy.ops.sozai.new(kind="wood", preset=preset)
    material = bpy.context.object.active_material
    material.sozai.texel = texel
    for key, value in values.items():
        bpy.ops.sozai.set(parameter=key, value=value)
    bpy.ops.sozai.update()
    show_output(material, "Albedo")
    width, side = 60, size[0] / 60
    height = round(size[1] / side)
    look_from(s, (0, 0, 1), (0, 0, 0), max(size) / 1000)
    got = flatten(render(s, name, width, height, 64))
    points = [(x, y, 0) for x, y in middles(width, height, side)]
    recipe = os.path.join(scratch, "sozai", preset + ".sozai")
    return got, evaluate(recipe, points, (0, 0, 1), side)


def board():
    compare("board", *plane("board", (120, 240), "keyaki", {}, 0.25), 0.01, 0.002)


def floor():
    # 90 mm blocks under pixels of 33 mm: the joints are thinner than texels
    compare("herringbone floor",
            *plane("floor", (2000, 1200), "oak", {"layout": "herringbone", "tone_spread": "0.2"},
                   2.0), 0.02, 0.004)


def unwrapped():
    """A bevelled block whose length is x, seen from above, from the front and from its end."""
    s = scene("mesh", enable=False)
    bpy.ops.mesh.primitive_cube_add(size=1)
    block = bpy.context.object
    block.scale = (0.2, 0.12, 0.08)
    block.rotation_euler = (0, 0, 0)
    bevel = block.modifiers.new("bevel", "BEVEL")
    bevel.width = 0.02
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(island_margin=0.03)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.sozai.new(kind="wood", preset="douglas_fir")
    material = block.active_material
    material.sozai.mode, material.sozai.along = "SOLID", "X"
    material.sozai.mesh_pixels = 1024
    bpy.ops.sozai.update()
    show_output(material, "Albedo")
    recipe = os.path.join(scratch, "sozai", "douglas_fir.sozai")
    # width and height in mm that are seen, away from the bevels; where object space lies
    views = {
        "top": ((0, 0, 1), (0, 0, 0), (120, 60), lambda x, y: (x, y, 40), (0, 0, 1)),
        "front": ((0, -1, 0), (HALF_TURN / 2, 0, 0), (120, 30), lambda x, y: (x, -60, y),
                  (0, -1, 0)),
        "end": ((1, 0, 0), (HALF_TURN / 2, 0, HALF_TURN / 2), (60, 30), lambda x, y: (100, x, y),
                (1, 0, 0)),
    }
    for name, (place, rotation, seen, to_object, normal) in views.items():
        look_from(s, place, rotation, max(seen) / 1000)
        side = 1.5
        width, height = round(seen[0] / side), round(seen[1] / side)
        got = flatten(render(s, "mesh-" + name, width, height, 64))
        # sozai's axes of a block that lies along x: (-y, x, z)
        turn = lambda p: (-p[1], p[0], p[2])  # noqa: E731
        points = [turn(to_object(x, y)) for x, y in middles(width, height, side)]
        compare("unwrapped block, " + name, got, evaluate(recipe, points, turn(normal), side),
                0.01, 0.004)


def fibre():
    """The fibre's direction in the world, aslant, of a block that is turned and scaled unevenly."""
    s = bpy.context.scene
    block = next(o for o in bpy.data.objects if o.type == "MESH")
    bpy.ops.sozai.set(parameter="grain", value="spiral")
    bpy.ops.sozai.set(parameter="spiral_slope", value="0.5")
    bpy.ops.sozai.update()
    block.rotation_euler = (0, 0, HALF_TURN / 2)
    show_output(block.active_material, "Fibre")
    look_from(s, (0, 0, 1), (0, 0, 0), 0.03)
    pixels = flatten(render(s, "fibre", 20, 20))
    mean = [sum(p[c] for p in pixels) / len(pixels) for c in range(3)]
    # of the middle, where both the block's turn and sozai's axes leave x and y as they are
    recipe = os.path.join(scratch, "sozai", "douglas_fir.sozai")
    points = [(x, y, 40) for x, y in middles(20, 20, 1.5)]
    rows = evaluate(recipe, points, (0, 0, 1), 1.5, "fiber")
    wanted = [sum(r[c] for r in rows) / len(rows) for c in range(3)]
    apart = max(abs(a - b) for a, b in zip(mean, wanted))
    print("fibre, turned and scaled: %.3f %.3f %.3f, off by %.4f (allowed 0.005)" % (*mean, apart))
    check("the fibre is the plugin's", apart < 0.005, (mean, wanted))
    check("and lies aslant", min(abs(mean[0]), abs(mean[1])) > 0.2, mean)


def flash():
    """Flakes of quarter-sawn oak beside its fibres, in the sun from aside and from along them."""
    s = scene("flash", enable=False)
    bpy.ops.mesh.primitive_plane_add(size=0.12)
    bpy.ops.sozai.new(kind="wood", preset="mizunara")
    bpy.context.object.active_material.sozai.texel = 0.25
    bpy.ops.sozai.set(parameter="cut", value="quarter")
    bpy.ops.sozai.update()
    look_from(s, (0, 0, 1), (0, 0, 0), 0.12)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = math.pi, 0
    s.collection.objects.link(sun)
    points = [(x, y, 0) for x, y in middles(120, 120, 1)]
    recipe = os.path.join(scratch, "sozai", "mizunara.sozai")
    rays = [r[0] for r in evaluate(recipe, points, (0, 0, 1), 1, "ray")]
    flashes = []
    for name, light in (("aside", (0.57, 0, 0.82)), ("along", (0, 0.57, 0.82))):
        sun.rotation_euler = Vector(light).to_track_quat("Z", "Y").to_euler()
        seen = [p[0] for p in flatten(render(s, "flash-" + name, 120, 120))]
        told = [p[0] for p in evaluate(recipe, points, (0, 0, 1), 1, "radiance", light)]
        over = []
        for values in (seen, told):
            flakes = [v for v, r in zip(values, rays) if r > 0.8]
            fibres = [v for v, r in zip(values, rays) if r < 0.05]
            over.append(sum(flakes) / len(flakes) - sum(fibres) / len(fibres))
        print("sun from %s: flakes over fibres by %.4f in Cycles, %.4f in radiance" %
              (name, *over))
        check("flakes as bright as radiance's, sun from " + name,
              abs(over[0] - over[1]) < 0.3 * abs(over[1]), over)
        flashes.append(over)
    more = [b - a for a, b in zip(*flashes)]
    check("they flash from along the fibres", more[1] > 0.05 and 0.4 < more[0] / more[1] < 1.4,
          more)


def missing():
    """Without its file a picture is Cycles' magenta, and the render goes on."""
    block = next(o for o in bpy.data.objects if o.type == "MESH")
    material = block.active_material
    show_output(material, "Albedo")
    path = os.path.join(scratch, "sozai", "douglas_fir.albedo.sozai")
    os.rename(path, path + ".gone")
    pixels = flatten(render(bpy.context.scene, "missing", 4, 4, 1))
    check("a missing file is magenta", all(p[0] > 0.9 and p[1] < 0.1 and p[2] > 0.9
                                           for p in pixels), pixels[0])
    with open(path, "w", encoding="utf-8") as out:
        out.write("material: wood\nparams:\n  ring_width: 1e30\n")
    pixels = flatten(render(bpy.context.scene, "hostile", 4, 4, 1))
    check("a refused file is magenta", all(p[0] > 0.9 and p[1] < 0.1 and p[2] > 0.9
                                           for p in pixels), pixels[0])


scene("start")
board()
floor()
unwrapped()
fibre()
missing()
flash()
finish()
