# SPDX-License-Identifier: Apache-2.0
"""A tree as a Blender mesh: a slot of materials to each part, UVs, the tree's own normals, and
its colours: bark's go by its age."""
import bpy
import numpy

from . import axes
from .strands import COLOUR


def key(part):
    """Parts that may stand in one another's place: what is foliage has one material."""
    return "leaf" if part.name in ("leaf", "needle") else part.name


def make(name, tree, mm, slot_of):
    """A data-block that nobody uses yet; slot_of: of materials, by part's key."""
    mesh = bpy.data.meshes.new(name)
    try:
        fill(mesh, tree, mm, slot_of)
    except BaseException:
        bpy.data.meshes.remove(mesh)
        raise
    return mesh


def fill(mesh, tree, mm, slot_of):
    count = len(tree.triangles)
    corners = tree.triangles.ravel()
    mesh.vertices.add(len(tree.points))
    mesh.vertices.foreach_set(
        "co", numpy.ascontiguousarray(axes.to_blender(tree.points) / mm, "f4").ravel())
    mesh.loops.add(3 * count)
    mesh.loops.foreach_set("vertex_index", corners.astype("i4"))
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, 3 * count, 3, dtype="i4"))
    if bpy.app.version < (3, 6):
        mesh.polygons.foreach_set("loop_total", numpy.full(count, 3, "i4"))
    slots = numpy.repeat([slot_of[key(p)] for p in tree.parts],
                         [p.triangles for p in tree.parts])
    mesh.polygons.foreach_set("material_index", slots.astype("i4"))
    mesh.polygons.foreach_set("use_smooth", numpy.ones(count, bool))
    uv = mesh.uv_layers.new(name="UVMap")
    uv.data.foreach_set("uv", numpy.ascontiguousarray(tree.uvs[corners], "f4").ravel())
    colours = numpy.ones((len(tree.points), 4), "f4")
    colours[:, :3] = tree.colours
    there = mesh.attributes.new(COLOUR, "FLOAT_COLOR", "POINT")
    there.data.foreach_set("color", colours.ravel())
    mesh.update(calc_edges=True)
    if hasattr(mesh, "use_auto_smooth"):  # until 4.0 the normals are not used without
        mesh.use_auto_smooth = True
    normals = numpy.ascontiguousarray(axes.to_blender(tree.normals), "f4")
    mesh.normals_split_custom_set_from_vertices(normals)
