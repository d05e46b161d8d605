# SPDX-License-Identifier: Apache-2.0
"""Strands in a mesh and trees, by the add-on: counts, places, materials, refusals, pictures."""
import csv
import os
import subprocess
import time
from types import SimpleNamespace

import bpy
import numpy
from addon_test import check, finish, look_from, refused, render, scene, scratch, sozai, \
    sozai_addon, state
from sozai_addon import update
from sozai_addon.grown import gltf_file, hair_file, hull, job, looks, operators, panel, \
    request
from sozai_addon.program import Problem

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


# ---- what is listed ----------------------------------------------------------


def lists():
    check("what is grown", list(state.grown) == ["fiber", "tree"], list(state.grown))
    check("what is grown is no material", "tree" not in state.described, list(state.described))
    for kind, described in state.grown.items():
        cls = next(c for n, c in sozai_addon.grown.settings._classes
                   if n == "sozai_grown_" + kind).bl_rna.properties
        for p in described["parameters"]:
            if p["kind"] == "buffer" or p["id"] == "field":
                continue
            made = cls.get("p_" + p["id"])
            check("a property for %s's %s" % (kind, p["id"]), made is not None)
            check(p["id"] + "'s unit is seen", p["unit"] in made.name, made.name)
            if p["kind"] == "float":
                got = (made.hard_min, made.hard_max, made.soft_min, made.soft_max, made.default)
                wanted = (*p["hard_range"], *p["soft_range"], p["default"])
                check(p["id"] + "'s ranges", numpy.allclose(got, wanted, rtol=1e-6), got)


# ---- strands -----------------------------------------------------------------


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


# ---- trees -------------------------------------------------------------------


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
    normals_of(obj, gltf_file.read(os.path.join(scratch, "sugi.gltf")))
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


# ---- kept, refused, ended ----------------------------------------------------


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


def ended():
    """A job that is cancelled ends at once, and leaves no file and no process."""
    many = request.new("tree", "sugi", "age=60", level=0)
    before = everything()
    begun = request.begin(many, bpy.context.scene)
    while begun.progress() is None and not begun.finished():
        time.sleep(0.01)
    share = begun.progress()
    check("how far it is", share is not None and 0 <= share[0] <= 1 and share[1], share)
    check("it works in a folder of its own", os.path.isdir(begun.folder))
    check("it is not done yet", not begun.finished())
    begun.close()
    check("ended", begun.process.returncode is not None and begun.process.returncode != 0,
          begun.process.returncode)
    check("nothing is left", everything() == before and begun not in job.running)
    begun = request.begin(many, bpy.context.scene)
    job.close_all()
    check("disabled while it works", begun.finished() and not job.running and
          everything() == before)


# ---- menus and panels, without a window --------------------------------------


class Growing(operators.Growing):
    """As Blender's operators are it, outside of them."""

    def __init__(self, wanted):
        self.wanted_first, self.said = wanted, []

    def request(self, _context):
        return self.wanted_first

    def report(self, kind, text):
        self.said.append((kind, text))


def window(told):
    """What modal operators use of a context, with a note of what they tell."""
    real = bpy.context
    manager = SimpleNamespace(
        event_timer_add=lambda step, window: told.append("timer") or "timer",
        event_timer_remove=lambda timer: told.append("no timer"),
        modal_handler_add=lambda operator: told.append("handler"),
        progress_begin=lambda a, b: told.append("begin"), progress_end=lambda: told.append("end"),
        progress_update=lambda share: told.append(share))
    return SimpleNamespace(
        scene=real.scene, collection=real.collection, view_layer=real.view_layer, object=real.object,
        selected_objects=list(real.selected_objects), window=None, window_manager=manager,
        workspace=SimpleNamespace(status_text_set=told.append))


def modal():
    """By timer to its end; by Esc to none."""
    told, tick = [], SimpleNamespace(type="TIMER")
    growing = Growing(request.new("tree", "sugi", "age=4", level=3))
    context, count = window(told), len(bpy.data.objects)
    check("it runs on", growing.start(context) == {"RUNNING_MODAL"})
    state_now = {"PASS_THROUGH"}
    while state_now == {"PASS_THROUGH"}:
        check("other events pass", growing.modal(context, SimpleNamespace(type="MOUSEMOVE")) ==
              {"PASS_THROUGH"})
        time.sleep(0.02)
        state_now = growing.modal(context, tick)
    check("finished", state_now == {"FINISHED"} and len(bpy.data.objects) == count + 1, state_now)
    check("it says what there is", "faces" in growing.said[0][1], growing.said)
    check("the status bar said so, and is free again", any("Esc cancels" in str(t) for t in told) and
          told[-1] is None and "no timer" in told and "end" in told, told)
    told.clear()
    before = everything()
    growing = Growing(request.new("tree", "sugi", "age=60", level=0))
    growing.start(context)
    growing.modal(context, tick)
    check("ended by Esc", growing.modal(context, SimpleNamespace(type="ESC")) == {"CANCELLED"} and
          growing.job.finished() and everything() == before and told[-1] is None)
    growing = Growing(request.Request("tree", target="no such tree", level=8))
    growing.start(context)
    growing.job.process.wait()
    check("an object that went meanwhile", growing.modal(context, tick) == {"CANCELLED"} and
          "is gone" in growing.said[0][1] and everything() == before, growing.said)


ICONS = bpy.types.UILayout.bl_rna.functions["prop"].parameters["icon"].enum_items


class Layout:
    """Takes down what is drawn; a name that there is not is a mistake."""

    def __init__(self):
        self.drawn = []

    def column(self, **_named):
        return self

    row = column

    def prop(self, data, name, text=None, icon="NONE"):
        check("a property %s" % name, name in data.bl_rna.properties)
        self.drawn.append(name)

    def operator(self, name, text=None, icon="NONE"):
        kind = getattr(bpy.ops.sozai, name.partition(".")[2]).get_rna_type()
        check("an icon " + icon, icon in ICONS)
        self.drawn.append(name)
        return SimpleNamespace(bl_rna=kind)

    def menu(self, name, text=None, icon="NONE"):
        check("a menu " + name, hasattr(bpy.types, name) and icon in ICONS)
        self.drawn.append(name)

    def label(self, text="", icon="NONE"):
        self.drawn.append(text)

    def template_icon(self, icon_value, scale):
        pass


def drawn(cls, context):
    layout = Layout()
    cls.draw(SimpleNamespace(layout=layout), context)
    return layout.drawn


def panels():
    obj = next(o for o in bpy.data.objects if o.type == "CURVES" and o.sozai_grown.kind == "fiber")
    of_tree = next(o for o in bpy.data.objects if o.sozai_grown.kind == "tree")
    previews = sozai_addon.previews.icon
    sozai_addon.previews.icon = lambda kind, preset: 0  # each is a program's run
    for shown, names in ((None, {"SOZAI_MT_trees", "SOZAI_MT_strands"}),
                         (obj, {"preset", "hull", "p_count", "level", "sozai.grow_update"}),
                         (of_tree, {"preset", "field", "p_age", "sozai.wood_of_tree"})):
        context = SimpleNamespace(object=shown, region=SimpleNamespace(width=300))
        got = drawn(panel.SOZAI_PT_grown, context)
        check("the panel of %s" % shown, names <= set(got), got)
        groups = [c for c in panel._made if hasattr(c, "bl_parent_id") and c.poll(context)]
        got = [name for c in groups for name in drawn(c, context)]
        if shown:
            kind = shown.sozai_grown.kind
            wanted = ["p_" + p["id"] for p in state.grown[kind]["parameters"]
                      if p["kind"] != "buffer" and p["id"] != "field"]
            check("every parameter is in a panel", sorted(got) == sorted(wanted), got)
        else:
            check("no parameters of nothing", not got, got)
    sozai_addon.previews.icon = previews
    for cls, kind in ((panel.SOZAI_MT_trees, "tree"), (panel.SOZAI_MT_strands, "fiber")):
        got = drawn(cls, bpy.context)
        check("a line to each preset", len(got) == len(state.grown[kind]["presets"]), got)
    path = os.path.join(scratch, "preview.png")
    command = sozai_addon.previews.command("grown tree", "sugi", path)
    command[command.index("--spp") + 1] = "1"
    subprocess.run(command, check=True)
    image = bpy.data.images.load(path)
    check("a species' picture", tuple(image.size) == (sozai_addon.previews.SIDE,) * 2)


# ---- pictures ----------------------------------------------------------------


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


scene("grown")
lists()
made = fill()
look(made)
update_strands(made)
poly()
made = tree()
update_tree(made)
wood(made)
measured()
kept()
refusals()
files()
ended()
modal()
panels()
pictures()
sozai_addon.unregister()
check("nothing is left when disabled", not hasattr(bpy.types.Object, "sozai_grown") and
      not hasattr(bpy.types.Object, "sozai_grown_tree"))
finish()
