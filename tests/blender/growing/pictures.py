# SPDX-License-Identifier: Apache-2.0
"""Strands and trees as Cycles shows them."""
import bpy
import numpy
from addon_test import check, look_from, render, scene
from growing.shared import ball


def seen(name, obj, width, place, rotation):
    """The share of a picture that the object is on, and its mean there, before nothing at all."""
    s = bpy.context.scene
    for other in bpy.data.objects:
        other.hide_render = other != obj and other.type != "LIGHT"
    look_from(s, place, rotation, width)
    s.render.film_transparent = True
    rows = render(s, name, 48, 48, 8)
    pixels = numpy.array(rows).reshape(-1, 3)
    bright = pixels.max(1)
    return float((bright > 0.01).mean()), pixels[bright > 0.01].mean(0)


def pictures():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    s = scene("pictures", enable=False)
    s.world = bpy.data.worlds.new("sky")
    s.world.use_nodes = True
    s.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.5, 0.5, 0.5, 1)
    bpy.ops.object.light_add(type="SUN", rotation=(0.6, 0.3, 0))
    bpy.context.object.data.energy = 3
    ball(0.01)
    bpy.ops.sozai.grow_fiber(preset="felt", params="count=500 length=6 diameter=120 "
                             "colour=0.8,0.2,0.1 share_2=0")
    obj = bpy.context.object
    share, mean = seen("strands", obj, 0.024, (0, -1, 0), (numpy.pi / 2, 0, 0))
    print("strands: %.2f of the picture, mean %.3f %.3f %.3f" % (share, *mean))
    check("strands are seen, in the middle alone", 0.2 < share < 0.75, share)
    check("they are red", mean[0] > 2 * mean[1] > 0.02, mean)
    # the thickness counts
    bpy.ops.sozai.grow_set(parameter="diameter", value="6")
    bpy.ops.sozai.grow_update()
    dim = numpy.array(render(s, "thin", 48, 48, 8)).sum()
    bpy.ops.sozai.grow_set(parameter="diameter", value="120")
    bpy.ops.sozai.grow_update()
    thick = numpy.array(render(s, "thick", 48, 48, 8)).sum()
    print("light of strands of 6 um over that of 120 um: %.3f" % (dim / thick))
    check("a twentieth as thick, a tenth as much to see at most", 0 < dim < 0.1 * thick, (dim, thick))
    bpy.ops.sozai.grow_tree(preset="sugi", age=10, level=3)
    obj = bpy.context.object
    share, mean = seen("tree", obj, 6.5, (3, -20, 2.8), (numpy.pi / 2, 0, 0))
    print("tree: %.2f of the picture, mean %.3f %.3f %.3f" % (share, *mean))
    check("a tree is seen, and sky beside it", 0.05 < share < 0.6, share)
    check("it is green", mean[1] > 1.1 * max(mean[0], mean[2]), mean)
