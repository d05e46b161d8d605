# SPDX-License-Identifier: Apache-2.0
"""The mesh that strands fill, as its modifiers leave it, written as PLY in millimetres."""
import bpy
import numpy

from ..mesh_export import millimetres
from ..program import Problem
from . import axes


def placing(obj):
    """Where the object's strands are to be: its place and turn in the world, without its scale."""
    place, turn, _ = obj.matrix_world.decompose()
    placed = turn.to_matrix().to_4x4()
    placed.translation = place
    return placed


def arrays(obj, scene):
    """Points in mm about the object's origin, scaled, not turned; triangles."""
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    try:
        if mesh is None or not mesh.polygons:
            raise Problem("'%s' has no faces: strands fill a closed mesh" % obj.name)
        mesh.calc_loop_triangles()
        points = numpy.empty((len(mesh.vertices), 3), "f4")
        mesh.vertices.foreach_get("co", points.ravel())
        triangles = numpy.empty((len(mesh.loop_triangles), 3), "i4")
        mesh.loop_triangles.foreach_get("vertices", triangles.ravel())
    finally:
        evaluated.to_mesh_clear()
    # whatever is left of the matrix after place and turn: scale, and shear from parents
    rest = numpy.array((placing(obj).inverted() @ obj.matrix_world).to_3x3())
    points = points.astype("f8") @ rest.T * millimetres(scene)
    return axes.to_sozai(points).astype("<f4"), triangles.astype("<i4")


def write(path, points, triangles):
    head = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\n"
            "property float x\nproperty float y\nproperty float z\nelement face %d\n"
            "property list uchar int vertex_indices\nend_header\n" % (len(points), len(triangles)))
    faces = numpy.empty(len(triangles), [("n", "u1"), ("v", "<i4", 3)])
    faces["n"], faces["v"] = 3, triangles
    with open(path, "wb") as out:
        out.write(head.encode("ascii"))
        out.write(points.tobytes())
        out.write(faces.tobytes())
