# SPDX-License-Identifier: Apache-2.0
"""Trees: their meshes, materials and updates, measured ones, and their wood."""
import csv
import os

import bpy
import numpy
from addon_test import check, refused, scratch
from growing.shared import grow, everything, leaves_nothing
from sozai_addon import update
from sozai_addon.grown import gltf_file


def parts_of(obj):
    """How many faces each part has."""
    slots = numpy.empty(len(obj.data.polygons), "i4")
    obj.data.polygons.foreach_get("material_index", slots)
    return {name: int((slots == i).sum()) for i, name in
            enumerate(obj.data["sozai_parts"].split(",")) if (slots == i).any()}


def obj_counts(path):
    """Points, and faces by part, of an .obj."""
    points, faces, part = 0, {}, None
    with open(path, encoding="utf-8") as file:
        for line in file:
            points += line.startswith("v ")
            if line.startswith(("g ", "usemtl ", "o ")):
                part = line.split()[1]
            if line.startswith("f "):
                faces[part] = faces.get(part, 0) + 1
    return points, faces


def normals_of(obj, wanted):
    """Bark's and shoots', which are round; leaves are sheets."""
    obj.data.calc_normals_split()
    normals = numpy.empty((len(obj.data.loops), 3), "f4")
    obj.data.loops.foreach_get("normal", normals.ravel())
    round_ones = 3 * sum(p.triangles for p in wanted.parts if p.name in ("bark", "shoot"))
    theirs = wanted.normals[wanted.triangles.ravel()[:round_ones]][:, (0, 2, 1)] * (1, -1, 1)
    agree = (normals[:round_ones] * theirs).sum(1)
    check("normals are the tree's", numpy.percentile(agree, 5) > 0.95, numpy.percentile(
        agree, (0, 5, 50)))


def colours_of(obj, wanted):
    """At the points, bark's by its age and leaf by leaf; which materials read."""
    there = obj.data.attributes["colour"]
    colours = numpy.empty((len(there.data), 4), "f4")
    there.data.foreach_get("color", colours.ravel())
    check("colours at its points", (there.domain, there.data_type) == ("POINT", "FLOAT_COLOR") and
          numpy.allclose(colours[:, :3], wanted.colours, atol=1e-4))
    bark, twig, leaf = (numpy.unique(wanted.colours[numpy.unique(t)], axis=0) for t in
                        numpy.split(wanted.triangles, numpy.cumsum([p.triangles for p in
                                                                    wanted.parts])[:2]))
    check("bark of many ages, leaves of many colours", len(bark) > 20 and len(twig) > 20 and
          len(leaf) > 100, (len(bark), len(twig), len(leaf)))
    sources = [m.node_tree.nodes["Principled BSDF"].inputs["Base Color"].links for m in
               obj.data.materials]
    check("materials read them", all(s and s[0].from_node.attribute_name == "colour" for s in
                                     sources), [bool(s) for s in sources])
    through = obj.data.materials[2].node_tree.nodes["Translucent BSDF"].inputs["Color"].links
    check("and what comes through leaves", through and
          through[0].from_node.attribute_name == "colour")


def tree():
    bpy.context.scene.cursor.location = (3, 0, 0)
    bpy.ops.sozai.grow_tree(preset="sugi", age=8, level=2)
    obj = bpy.context.object
    path = os.path.join(scratch, "sugi.obj")
    grow("tree", "--species", "sugi", "--age", "8", "--level", "2", "-o", path)
    points, faces = obj_counts(path)
    faces["leaf"] = faces.pop("needle", 0)
    check("points as in the .obj", len(obj.data.vertices) == points, (len(obj.data.vertices), points))
    check("faces as in the .obj, part by part", parts_of(obj) == faces and faces["bark"] > 100 and
          faces["leaf"] > 1000, (parts_of(obj), faces))
    grow("tree", "--species", "sugi", "--age", "8", "--table", "statistics", "-o",
         os.path.join(scratch, "sugi.csv"))
    with open(os.path.join(scratch, "sugi.csv"), encoding="ascii") as file:
        height = float(next(csv.DictReader(file))["height"]) / 1000
    low, high = (max(c[2] for c in obj.bound_box) * s for s in (0, 1))
    check("as tall as the table says, in metres, z upwards", abs(high - height) < 0.05 and
          low == 0, (high, height))
    check("at the cursor", tuple(obj.location) == (3, 0, 0))
    check("UVs", len(obj.data.uv_layers) == 1 and
          max(u.uv[1] for u in obj.data.uv_layers[0].data) > 1)
    check("a mesh that Blender finds nothing to mend in", not obj.data.validate())
    grow("tree", "--species", "sugi", "--age", "8", "--level", "2", "-o",
         os.path.join(scratch, "sugi.gltf"))
    wanted = gltf_file.read(os.path.join(scratch, "sugi.gltf"))
    normals_of(obj, wanted)
    colours_of(obj, wanted)
    names = [m.name for m in obj.data.materials]
    check("a material to a part", [n.split()[1] for n in names] == ["bark", "shoot", "needle"], names)
    colours = [m.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value[:3]
               for m in obj.data.materials]
    wanted = numpy.array(obj.sozai_grown_tree.p_bark_colour)
    check("bark as the species has it", numpy.allclose(
        colours[0], ((wanted + 0.055) / 1.055) ** 2.4, atol=0.003), colours[0])
    return obj


def update_tree(obj):
    own = bpy.data.materials.new("my leaves")
    bark = obj.data.materials[0]
    obj.data.materials[2] = own
    obj.rotation_euler = (0, 0, 1)
    twin = obj.copy()  # shows the same data
    bpy.context.scene.collection.objects.link(twin)
    obj.sozai_grown_tree.preset = "keyaki"
    bpy.ops.sozai.grow_set(parameter="age", value="6")
    bpy.ops.sozai.grow_set(parameter="bark_colour", value="0.5 0.2 0.1")
    before = everything()
    bpy.ops.sozai.grow_update()
    path = os.path.join(scratch, "keyaki.obj")
    grow("tree", "--species", "keyaki", "--age", "6", "--level", "2", "-o", path)
    points, faces = obj_counts(path)
    check("another tree in the same object", len(obj.data.vertices) == points and
          parts_of(obj) == faces, (parts_of(obj), faces))
    check("its leaves have the artist's material", obj.data.materials[2] == own)
    base = bark.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value[:3]
    check("the bark's follows", obj.data.materials[0] == bark and
          numpy.allclose(base, (0.2140, 0.0331, 0.0100), atol=0.003), tuple(base))
    check("its turn is kept", obj.rotation_euler.z == 1)
    check("its twin shows it too", twin.data == obj.data)
    check("nothing more than before", everything() == before)
    bpy.data.objects.remove(twin)


def measured():
    path = os.path.join(scratch, "measured.field")
    with open(path, "w", encoding="ascii") as out:
        out.write("trunk\n50  10 88  6\n40 200 85  5.5\n30   0 90  -\nB100\n0\n35  45 20  2\n")
    bpy.ops.sozai.grow_tree(preset="sugi", field=path, params="orders=1")
    obj = bpy.context.object
    top = max(v.co.z for v in obj.data.vertices)
    check("a measured tree's height", 1.15 < top < 1.25, top)
    with open(path, "a", encoding="ascii") as out:
        out.write("B999\n1 2\n")
    count = len(obj.data.vertices)
    leaves_nothing("a malformed table", ["line 8"], bpy.ops.sozai.grow_update)
    check("the old tree stays", len(obj.data.vertices) == count)
    bpy.data.objects.remove(obj)
    leaves_nothing("a table that is missing", ["/no/such.field"], bpy.ops.sozai.grow_tree,
                   field="/no/such.field")


def wood(tree_object):
    bpy.context.view_layer.objects.active = tree_object
    tree_object.select_set(True)
    for other in list(bpy.context.selected_objects):
        other.select_set(other == tree_object)
    refused("wood for nothing", ["select the mesh"], bpy.ops.sozai.wood_of_tree)
    bpy.ops.mesh.primitive_plane_add(size=0.2)
    board = bpy.context.object
    tree_object.select_set(True)
    bpy.context.view_layer.objects.active = tree_object
    bpy.ops.sozai.wood_of_tree()
    made = board.active_material
    group = made.sozai_wood
    check("the tree's species, age and seed", (group.preset, group.p_tree, group.p_tree_age,
                                               group.p_seed, group.p_cut) ==
          ("keyaki", "keyaki", 6.0, 1, "flat"), (group.preset, group.p_tree, group.p_tree_age))
    with open(os.path.join(scratch, "sozai", update.clean(made.name) + ".sozai"),
              encoding="utf-8") as file:
        text = file.read()
    check("its file says so", 'tree: "keyaki"' in text and "tree_age: 6" in text, text)
    count = len(bpy.data.materials)
    tree_object.sozai_grown_tree.preset = "momiji"
    refused("a species without a wood", ["no preset 'momiji'"], bpy.ops.sozai.wood_of_tree)
    check("no material is left over", len(bpy.data.materials) == count)
    bpy.ops.sozai.wood_of_tree(wood="itayakaede")
    check("but another may be named", board.active_material.sozai_wood.p_tree == "momiji")
