# SPDX-License-Identifier: Apache-2.0
"""What is kept in a file, and what is refused in one line and leaves nothing."""
import os

import bpy
import numpy
from addon_test import check, scratch, state
from growing.shared import SHORT, grow, leaves_nothing, ball, points_of
from sozai_addon.grown import gltf_file, hair_file
from sozai_addon.program import Problem


def kept():
    ball(0.01)
    bpy.context.object.name = "body"
    bpy.ops.sozai.grow_fiber(preset="lint", params=SHORT)
    name = bpy.context.object.name
    bpy.ops.wm.save_mainfile()
    bpy.ops.wm.open_mainfile(filepath=bpy.data.filepath)
    obj = bpy.data.objects[name]
    group = obj.sozai_grown_fiber
    check("settings are kept", (obj.sozai_grown.kind, group.preset, group.p_count, group.p_length,
                                obj.sozai_grown.hull.name) == ("fiber", "lint", 300, 4.0, "body"))
    before = points_of(obj)
    bpy.context.view_layer.objects.active = obj
    bpy.ops.sozai.grow_update()
    check("the same strands again", numpy.array_equal(points_of(obj), before))
    bpy.data.objects.remove(bpy.data.objects["body"])
    leaves_nothing("a hull that is gone", ["no hull"], bpy.ops.sozai.grow_update)
    check("and the strands stay", numpy.array_equal(points_of(obj), before))


def refusals():
    bpy.context.view_layer.objects.active = None
    grow_fiber = bpy.ops.sozai.grow_fiber
    leaves_nothing("no hull", ["no hull", "nothing is active"], grow_fiber, preset="felt")
    camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.view_layer.objects.active = camera
    leaves_nothing("a camera for a hull", ["'eye'"], grow_fiber, preset="felt")
    bpy.ops.mesh.primitive_plane_add(size=0.02)
    leaves_nothing("a sheet for a hull", ["sozai: hull: ", "encloses nothing"], grow_fiber, preset="felt", params=SHORT)
    bpy.context.object.data.clear_geometry()
    leaves_nothing("a hull without faces", ["has no faces"], grow_fiber, preset="felt")
    body = ball(0.01)
    for value in ("-5", "1e30", "nan", "inf", "", "2.5", "50000001"):
        leaves_nothing("count=" + value, ["count", "'%s'" % value, "0", "5e+07"], grow_fiber,
                       params="count=" + value)
    leaves_nothing("no such preset", ["no preset 'cheese'"], grow_fiber, preset="cheese")
    leaves_nothing("no such parameter", ["no parameter 'hight'"], grow_fiber, params="hight=2")
    leaves_nothing("no value", ["'count' is not NAME=VALUE"], grow_fiber, params="count")
    leaves_nothing("a buffer", ["hull", "cannot be set"], grow_fiber, params="hull=x")
    leaves_nothing("a tree's age", ["age", "'301'", "300"], bpy.ops.sozai.grow_tree, age=301)
    body.data.vertices[0].co.x = float("nan")
    try:  # refused or mended, as the mesh reader has it; not a crash
        grow_fiber(params=SHORT)
    except RuntimeError as error:
        check("a hull with no number: one line", "\n" not in str(error).strip(), str(error))
    before, state.program_path = state.program_path, "/no/such/sozai"
    leaves_nothing("no program", ["/no/such/sozai"], bpy.ops.sozai.grow_tree)
    state.program_path = ""
    leaves_nothing("none found", ["not found"], bpy.ops.sozai.grow_tree)
    state.program_path = before


def files():
    """Truncated and hostile files end in one line."""
    ball(0.01)
    named = [w for p in SHORT.split() for w in ("-p", p)]
    for reader, path, arguments in (
            (hair_file.read, "cut.hair", ("fiber", "--hull", "ball", *named)),
            (gltf_file.read, "cut.gltf", ("tree", "--age", "2", "--level", "4"))):
        path = os.path.join(scratch, path)
        grow(*arguments, "-o", path)
        with open(path, "rb") as file:
            data = file.read()
        reader(path)
        for size in [0, 1, 4, 40, 127, 128, 129, 200, len(data) // 2, len(data) - 3]:
            with open(path, "wb") as file:
                file.write(data[:size])
            try:
                reader(path)
                check("%s of %d bytes" % (path, size), False)
            except Problem as problem:
                check("%s: one line" % path, "\n" not in str(problem))
        for at in (4, 8, 12):
            with open(path, "wb") as file:
                file.write(data[:at] + b"\xff\xff\xff\xff" + data[at + 4:])
            try:
                reader(path)
                check("%s with %d changed" % (path, at), False)
            except Problem:
                pass
