# SPDX-License-Identifier: Apache-2.0
"""The pictures of docs/blender.md: what an artist would set up, by the add-on's own operators."""
import math
import os
import sys

import bpy
from mathutils import Vector

sys.path.insert(0, os.environ["SOZAI_ADDON"])
import sozai_addon  # noqa: E402

# fewer for a look at the set-up
SAMPLES = int(os.environ.get("SOZAI_SAMPLES", "64"))


def scene(name, width, height, sun, sky=0.07):
    """Empty and saved, since files of the add-on lie beside it; lit by a sky and a sun."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.save_as_mainfile(filepath=os.path.join(os.environ["SOZAI_SCRATCH"],
                                                      name + ".blend"))
    s = bpy.context.scene
    s.render.engine = "CYCLES"
    s.cycles.samples = SAMPLES
    s.cycles.use_denoising = False
    s.render.resolution_x, s.render.resolution_y = width, height
    s.render.resolution_percentage = 100
    s.render.image_settings.file_format = "PNG"
    # what a PNG would tell of this machine and of the hour
    for stamp in dir(s.render):
        if stamp.startswith("use_stamp_"):
            setattr(s.render, stamp, False)
    s.view_settings.view_transform = "Filmic"
    s.view_settings.look = "Medium High Contrast"
    s.world = bpy.data.worlds.new("sky")
    s.world.use_nodes = True
    tree = s.world.node_tree
    background = tree.nodes["Background"]
    texture = tree.nodes.new("ShaderNodeTexSky")
    texture.sky_type = "NISHITA"
    texture.sun_disc = True
    texture.sun_size = math.radians(4)
    texture.sun_elevation, texture.sun_rotation = (math.radians(a) for a in sun)
    background.inputs["Strength"].default_value = sky
    tree.links.new(texture.outputs["Color"], background.inputs["Color"])
    return s


def camera(s, place, at, lens):
    data = bpy.data.cameras.new("camera")
    data.lens, data.clip_start = lens, 0.001
    eye = bpy.data.objects.new("camera", data)
    eye.location = place
    eye.rotation_euler = (Vector(at) - Vector(place)).to_track_quat("-Z", "Y").to_euler()
    s.collection.objects.link(eye)
    s.camera = eye


def plane(size, **named):
    bpy.ops.mesh.primitive_plane_add(size=size)
    if named:
        bpy.ops.sozai.new(**named)
    return bpy.context.object


def settle(values=(), **settings):
    """Parameters of the active object's material, and of how its picture meets it."""
    material = bpy.context.object.active_material
    for key, value in settings.items():
        setattr(material.sozai, key, value)
    for key, value in dict(values).items():
        bpy.ops.sozai.set(parameter=key, value=value)
    bpy.ops.sozai.update()


def painted(obj, colour):
    material = bpy.data.materials.new("plain")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1)
    surface.inputs["Roughness"].default_value = 0.7
    obj.data.materials.append(material)


def board():
    s = scene("board", 960, 640, sun=(30, 235))
    plane(2.0, kind="stone", preset="inada")
    settle({"finish": "polished"}, texel=0.25)
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 0.0131))
    block = bpy.context.object
    block.scale = (0.3, 0.11, 0.026)
    bpy.ops.object.transform_apply(location=False, rotation=False)  # a bevel alike all round
    block.rotation_euler = (0, 0, 0.42)
    bevel = block.modifiers.new("bevel", "BEVEL")
    bevel.width, bevel.segments = 0.002, 3
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(island_margin=0.02)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.sozai.new(kind="wood", preset="black_walnut")
    settle(mode="SOLID", along="X", mesh_pixels=4096)
    camera(s, (0.06, -0.37, 0.26), (0.0, -0.004, 0.008), 42)


def floor():
    s = scene("floor", 960, 640, sun=(30, 300))
    plane(3.2, kind="wood", preset="mizunara")
    settle({"layout": "herringbone", "tone_spread": "0.15"}, texel=0.8)
    camera(s, (0.0, -1.05, 0.8), (0.0, 0.0, 0.0), 32)


def oak(name, sun):
    s = scene(name, 640, 480, sun=(35, sun))
    plane(1.6, kind="wood", preset="mizunara")
    settle({"layout": "strip", "cut": "quarter", "board_width": "130"}, texel=0.4)
    camera(s, (0.0, -0.6, 0.5), (0.0, 0.02, 0.0), 50)


def felt():
    s = scene("felt", 640, 640, sun=(42, 215))
    painted(plane(40.0), (0.4, 0.37, 0.33))
    bpy.ops.mesh.primitive_uv_sphere_add(segments=48, ring_count=24, radius=0.02,
                                         location=(0, 0, 0.0195))
    bpy.ops.sozai.grow_fiber(preset="felt", params="count=20000 length=25 diameter=35 "
                             "colour=0.72,0.08,0.06")
    camera(s, (0.02, -0.115, 0.06), (0.004, 0, 0.0175), 60)


def sugi():
    s = scene("sugi", 600, 800, sun=(40, 150), sky=0.12)
    painted(plane(400.0), (0.13, 0.14, 0.07))
    bpy.ops.sozai.grow_tree(preset="sugi", age=20, level=0)
    tree = bpy.context.object
    top = max((tree.matrix_world @ Vector(c)).z for c in tree.bound_box)
    camera(s, (0, -1.9 * top, 0.2 * top), (0, 0, 0.49 * top), 52)


def pine():
    s = scene("pine", 600, 800, sun=(32, 100), sky=0.05)
    painted(plane(400.0), (0.13, 0.14, 0.07))
    bpy.ops.sozai.grow_tree(preset="akamatsu", age=34, level=0)
    camera(s, (1.6, -4.6, 1.7), (0.25, 0, 2.3), 45)


# the same, but for where the sun stands
DRAWN = {"board": board, "floor": floor, "oak-behind": lambda: oak("behind", 180),
         "oak-aside": lambda: oak("aside", 90), "felt": felt, "sugi": sugi, "pine": pine}

wanted = os.environ["SOZAI_WANTED"].split() or list(DRAWN)
unknown = [w for w in wanted if w not in DRAWN]
if unknown:
    sys.exit("no picture %s: there are %s" % (unknown[0], ", ".join(DRAWN)))
sozai_addon.register()
for name in wanted:
    DRAWN[name]()
    to = os.path.join(os.environ["SOZAI_PICTURES"], "blender-%s.png" % name)
    bpy.context.scene.render.filepath = to
    bpy.ops.render.render(write_still=True)
    print("drawn: " + to)
