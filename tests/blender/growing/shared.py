# SPDX-License-Identifier: Apache-2.0
"""What the tests of growing share: growing, and what there is of an object."""
import os
import subprocess

import bpy
import numpy
from addon_test import check, refused, sozai

SHORT = "count=300 length=4 vertices=12"


def grow(*arguments):
    subprocess.run([sozai, "grow", *arguments], check=True, capture_output=True)


def everything():
    """Names of all that growing could leave behind."""
    data = bpy.data
    return {k: sorted(b.name for b in getattr(data, k)) for k in
            ("objects", "meshes", "curves", "hair_curves", "materials", "node_groups")} | \
        {"files": sorted(f for f in os.listdir(bpy.app.tempdir) if f.startswith("sozai-"))}


def leaves_nothing(what, words, call, **named):
    before = everything()
    refused(what, words, call, **named)
    check(what + ": nothing is left", everything() == before,
          {k: (before[k], v) for k, v in everything().items() if v != before[k]})


def ball(radius=0.01, **named):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16, radius=radius, **named)
    return bpy.context.object


def points_of(obj):
    """Of strands, in the world."""
    if obj.type == "CURVES":
        points = numpy.empty(3 * len(obj.data.points), "f4")
        obj.data.position_data.foreach_get("vector", points)
    else:
        points = numpy.array([c for s in obj.data.splines for p in s.points for c in p.co[:3]])
    turn = numpy.array(obj.matrix_world)
    return points.reshape(-1, 3) @ turn[:3, :3].T + turn[:3, 3]


def radii_of(obj):
    if obj.type == "CURVES":
        radii = numpy.empty(len(obj.data.points), "f4")
        obj.data.attributes["radius"].data.foreach_get("value", radii)
        return radii
    return numpy.array([p.radius for s in obj.data.splines for p in s.points])


def near(a, b, by=1e-6):
    return bool(numpy.allclose(a, b, rtol=by, atol=0))
