# SPDX-License-Identifier: Apache-2.0
"""An object's evaluated mesh as a Wavefront OBJ in millimetres, with its UVs."""
import os

import bpy

from .program import Problem

# The object's axis that the grain follows, turned to sozai's +y: signs and source axes.
TURNS = {
    "X": ((-1, 1), (1, 0), (1, 2)),  # (-y, x, z)
    "Y": ((1, 0), (1, 1), (1, 2)),
    "Z": ((1, 0), (1, 2), (-1, 1)),  # (x, z, -y)
}


def millimetres(scene):
    """Of one of the scene's units."""
    return 1000.0 * scene.unit_settings.scale_length


def turned(vector, along):
    return tuple(sign * vector[axis] for sign, axis in TURNS[along])


def lines(mesh, uv, scale, mm, along):
    """The file's text, line by line; scale: the object's, mm: of one of the scene's units."""
    for vertex in mesh.vertices:
        place = turned([vertex.co[k] * scale[k] * mm for k in range(3)], along)
        yield "v %.7g %.7g %.7g\n" % place
    for corner in uv:
        yield "vt %.9g %.9g\n" % (corner.uv[0], corner.uv[1])
    for corner in range(len(mesh.loops)):
        normal = mesh.loops[corner].normal
        # normals go by the inverse of the scale
        yield "vn %.6g %.6g %.6g\n" % turned([normal[k] / scale[k] for k in range(3)], along)
    for triangle in mesh.loop_triangles:
        yield "f " + " ".join(
            "%d/%d/%d" % (v + 1, c + 1, c + 1)
            for v, c in zip(triangle.vertices, triangle.loops)) + "\n"


def export(obj, path, along, scene):
    """Write it; the UDIM tiles that the UVs reach into, ascending."""
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    try:
        if mesh is None or not mesh.polygons:
            raise Problem("'%s' has no faces to unwrap" % obj.name)
        if mesh.uv_layers.active is None:
            raise Problem("'%s' has no UV map: unwrap it (U in edit mode), or use a mode "
                          "without UVs" % obj.name)
        if min(abs(s) for s in obj.scale) < 1e-9:
            raise Problem("'%s' is scaled to nothing" % obj.name)
        if hasattr(mesh, "calc_normals_split"):  # gone in 4.1, which has them ready
            mesh.calc_normals_split()
        mesh.calc_loop_triangles()
        uv = mesh.uv_layers.active.data
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path + ".part", "w", encoding="ascii") as out:
            out.write("# %d vertices in mm, by Blender's add-on sozai\n" % len(mesh.vertices))
            out.writelines(lines(mesh, uv, obj.scale, millimetres(scene), along))
        os.replace(path + ".part", path)
        return tiles(uv)
    finally:
        evaluated.to_mesh_clear()


def tiles(uv):
    found = set()
    for corner in uv:
        u, v = corner.uv
        # a chart may end on a tile's border
        i, j = int(max(0.0, u - 1e-5)), int(max(0.0, v - 1e-5))
        if i > 9 or u < -1e-5 or v < -1e-5 or j > 899:
            raise Problem("a UV of %g, %g lies in no UDIM tile" % (u, v))
        found.add(1001 + i + 10 * j)
    return sorted(found)
