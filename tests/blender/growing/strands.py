# SPDX-License-Identifier: Apache-2.0
"""Strands in a mesh: as many and where sozai says, the fibre's look, updates."""
import csv
import os

import bpy
import numpy
from addon_test import check, scratch, state
from growing.shared import SHORT, grow, everything, ball, points_of, radii_of, near
from sozai_addon.grown import hair_file, hull, looks


def fill():
    """An uneven, turned hull: strands are as many and where sozai says, radii in metres."""
    body = ball(0.01, location=(1, 2, 3), rotation=(0.3, 0.2, 0.1))
    body.scale = (1, 2, 0.5)
    bpy.context.view_layer.update()
    bpy.ops.sozai.grow_fiber(preset="felt", params=SHORT)
    obj = bpy.context.object
    check("hair curves", obj.type == "CURVES" and obj != body, obj.type)
    path = os.path.join(scratch, "felt.hair")
    # the same hull, by Blender's own hand
    points, triangles = hull.arrays(body, bpy.context.scene)
    check("the hull in mm", near(numpy.ptp(points, 0), (20, 10, 40), 0.02), numpy.ptp(points, 0))
    hull.write(os.path.join(scratch, "hull.ply"), points, triangles)
    named = [w for p in SHORT.split() for w in ("-p", p)]
    grow("fiber", "--hull", os.path.join(scratch, "hull.ply"), "--material", "felt", *named,
         "-o", path)
    grow("fiber", "--hull", os.path.join(scratch, "hull.ply"), "--material", "felt", *named,
         "--table", "strands", "-o", os.path.join(scratch, "felt.csv"))
    with open(os.path.join(scratch, "felt.csv"), encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    grow("fiber", "--hull", os.path.join(scratch, "hull.ply"), "--material", "felt", *named,
         "-o", os.path.join(scratch, "felt.obj"))
    with open(os.path.join(scratch, "felt.obj"), encoding="ascii") as file:
        places = numpy.array([line.split()[1:4] for line in file if line.startswith("v ")], "f8")
    check("strands as in the table", len(obj.data.curves) == len(rows) == 300,
          (len(obj.data.curves), len(rows)))
    check("points as in the .obj", len(obj.data.points) == len(places) == 3600,
          (len(obj.data.points), len(places)))
    check("radii in metres", near(radii_of(obj), hair_file.read(path).radii / 1000) and
          2e-6 < radii_of(obj).max() < 1e-4, radii_of(obj).max())
    local = numpy.empty((len(places), 3), "f4")
    obj.data.position_data.foreach_get("vector", local.ravel())
    sozais = numpy.stack((local[:, 0], local[:, 2], -local[:, 1]), 1) * 1000
    check("points where sozai has them", numpy.abs(sozais - places).max() < 2e-3,
          numpy.abs(sozais - places).max())
    world = points_of(obj)
    inside = numpy.array(body.matrix_world.inverted())
    unit = world @ inside[:3, :3].T + inside[:3, 3]
    reach = numpy.linalg.norm(unit, axis=1).max()
    check("all inside the hull", 0.006 < reach <= 0.0101, reach)
    check("the hull is out of the way", body.hide_render and body.display_type == "WIRE")
    colours = {tuple(round(c, 5) for c in v.color) for v in obj.data.attributes["colour"].data}
    check("a colour to a strand, as light", len(colours) in (1, 2) and
          all(0 < c[0] < 1 and c[3] == 1 for c in colours), colours)
    check("no helpers are left", not any(n.startswith("sozai:") for k in everything().values()
                                         for n in k), everything())
    return obj


def look(obj):
    """The material's numbers are the fibre's; an artist's own stay."""
    group = obj.sozai_grown_fiber
    strand = next(n for n in obj.active_material.node_tree.nodes if n.label == "strand")
    value = lambda name: strand.inputs[name].default_value  # noqa: E731
    check("a hair BSDF", strand.type == "BSDF_HAIR_PRINCIPLED", strand.type)
    b = value("Roughness")
    check("roughness is the highlight's width",
          near(numpy.degrees(0.726 * b + 0.812 * b * b + 3.7 * b ** 20), group.p_roughness, 1e-4), b)
    check("roughness round", near(value("Radial Roughness"), group.p_roughness_round))
    check("tilt", near(value("Offset"), numpy.radians(group.p_tilt), 1e-5), value("Offset"))
    check("the BSDF's end of the range", looks.hair_roughness(60) < 1)


def update_strands(obj):
    material, data = obj.active_material, obj.data.name
    strand = next(n for n in material.node_tree.nodes if n.label == "strand")
    strand.inputs["Offset"].default_value = 0.2
    obj.location.x += 5
    place = obj.location.copy()
    bpy.ops.sozai.grow_set(parameter="count", value="120")
    bpy.ops.sozai.grow_set(parameter="diameter", value="200")
    bpy.ops.sozai.grow_set(parameter="diameter_spread", value="0")
    bpy.ops.sozai.grow_set(parameter="taper", value="1")
    bpy.ops.sozai.grow_set(parameter="roughness", value="20")
    check("the panel knows of the change", obj.sozai_grown.changed)
    before = everything()
    bpy.ops.sozai.grow_update()
    check("the same object", bpy.context.object == obj and len(obj.data.curves) == 120,
          len(obj.data.curves))
    check("0.2 mm thick", near(radii_of(obj), 1e-4, 1e-4), radii_of(obj))
    check("where it was moved to", obj.location == place)
    check("with its material", obj.active_material == material and len(obj.data.materials) == 1)
    check("what the artist set stays", near(strand.inputs["Offset"].default_value, 0.2))
    check("the rest follows", near(strand.inputs["Roughness"].default_value,
                                   looks.hair_roughness(20)))
    check("nothing more than before", everything() == before and obj.data.name == data)
    check("settled", not obj.sozai_grown.changed)
    obj.sozai_grown_fiber.preset = "wool_merino"
    group, wanted = obj.sozai_grown_fiber, state.grown["fiber"]["presets"]
    length = next(p for p in wanted if p["id"] == "wool_merino")["values"]["length"]
    check("a preset sets the parameters", near(group.p_length, length), group.p_length)
    obj.sozai_grown.level = 1
    bpy.ops.sozai.grow_set(parameter="count", value="64")
    bpy.ops.sozai.grow_update()
    vertices = group.p_vertices
    check("a level is fewer points", len(obj.data.points) < 64 * vertices, len(obj.data.points))


def poly():
    body = ball(0.01)
    bpy.ops.sozai.grow_fiber(preset="wool_merino", params=SHORT + " share_2=0.5 colour_2=0.1,0.2,0.3",
                             form="POLY")
    obj = bpy.context.object
    check("poly splines", obj.type == "CURVE" and len(obj.data.splines) == 300 and
          {s.type for s in obj.data.splines} == {"POLY"}, obj.type)
    check("their points", sum(len(s.points) for s in obj.data.splines) == 3600)
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    tube = max(v.co.length for v in mesh.vertices)
    line = numpy.linalg.norm(points_of(obj), axis=1).max()
    check("they are thick, not as thick as metres", line < tube < line + 2 * radii_of(obj).max(),
          (line, tube))
    slots = {s.material_index for s in obj.data.splines}
    check("two colours, two materials", slots == {0, 1} and len(obj.data.materials) == 2, slots)
    again = [m.name for m in obj.data.materials]
    bpy.ops.sozai.grow_set(parameter="count", value="50")
    bpy.ops.sozai.grow_update()
    check("updated as what it is", obj.type == "CURVE" and len(obj.data.splines) == 50 and
          [m.name for m in obj.data.materials] == again)
    bpy.context.scene.unit_settings.scale_length = 0.001
    bpy.context.view_layer.objects.active = body
    body.scale = (1000,) * 3
    bpy.context.view_layer.update()
    bpy.ops.sozai.grow_fiber(params=SHORT)
    thick = radii_of(bpy.context.object)
    check("in a scene of millimetres radii are mm", 0.02 < thick.max() < 0.05, thick.max())
    bpy.context.scene.unit_settings.scale_length = 1
