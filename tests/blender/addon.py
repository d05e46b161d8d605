# SPDX-License-Identifier: Apache-2.0
"""The add-on without a window: what it lists, what it refuses, what it writes and keeps."""
import json
import os
import subprocess

import bpy
from addon_test import check, finish, refused, scene, scratch, sozai, sozai_addon, state
from sozai_addon import parameters, program, recipe

folder = os.path.join(scratch, "sozai")


def read(name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return file.read()


def plane(**named):
    bpy.ops.mesh.primitive_plane_add(size=0.2)
    bpy.ops.sozai.new(**named)
    return bpy.context.object.active_material


def lists():
    """Every material, preset and parameter that sozai describes, with its range and its text."""
    names = [line.split()[0] for line in subprocess.check_output([sozai, "list"], text=True)
             .splitlines() if line[0] != " "]
    # fiber is a texture and a generator, and what is only grown has no channels
    names = [n for n in dict.fromkeys(names) if json.loads(subprocess.check_output(
        [sozai, "describe", n, "--json"]))["channels"]]
    check("materials", list(state.described) == names and len(names) >= 2, names)
    for name in names:
        wanted = json.loads(subprocess.check_output([sozai, "describe", name, "--json"]))
        cls = next(c for k, c in state._classes if k == name).bl_rna.properties
        presets = [i.identifier for i in cls["preset"].enum_items]
        check(name + "'s presets", presets == [parameters.NONE] + [p["id"] for p in
                                                                   wanted["presets"]], presets)
        for p in wanted["parameters"]:
            if p["kind"] == "buffer":
                continue
            made = cls.get("p_" + p["id"])
            if made is None:
                check("a property for " + p["id"], False)
                continue
            check(p["id"] + "'s tooltip is its doc", made.description.startswith(
                p["doc"].rstrip(".")), made.description)
            check(p["id"] + "'s unit is seen", p["unit"] in made.name, made.name)
            if p["kind"] == "float":
                near = lambda a, b: abs(a - b) <= 1e-6 * max(1, abs(b))  # noqa: E731
                got = (made.hard_min, made.hard_max, made.soft_min, made.soft_max, made.default)
                ranges = (*p["hard_range"], *p["soft_range"], p["default"])
                check(p["id"] + "'s ranges", all(map(near, got, ranges)), got)
            if p["kind"] == "choice":
                got = [i.identifier for i in made.enum_items]
                check(p["id"] + "'s choices", got == [c["id"] for c in p["choices"]], got)


def numbers():
    for value in (0.1, 1 / 3, 1e-7, 123456.789, -2.0, 1000.0):
        text = recipe.number(value)
        check("number %r is kept" % value, abs(float(text) - value) <= 6e-8 * abs(value), text)
    check("a whole number is short", recipe.number(1000.0) == "1000", recipe.number(1000.0))
    check("text is quoted", recipe.scalar('a "b": #c') == '"a \\"b\\": #c"')


def edits():
    material = plane(kind="wood", preset="keyaki")
    group = material.sozai_wood
    set_ = bpy.ops.sozai.set
    for value in ("0.1", "31", "nan", "inf", "1e30", "", "two", "1 2"):
        refused("ring_width=" + value, ["ring_width", "'%s'" % value, "0.2", "30", "mm"], set_,
                parameter="ring_width", value=value)
    refused("a choice that is none", ["grain", "'curly'", "spiral"], set_, parameter="grain",
            value="curly")
    refused("a colour of two", ["latewood_colour", "three numbers"], set_,
            parameter="latewood_colour", value="0.1 0.2")
    refused("a seed of 1.5", ["seed", "whole number"], set_, parameter="seed", value="1.5")
    refused("an unknown one", ["no parameter 'rings'"], set_, parameter="rings", value="1")
    check("nothing was changed by those", parameters.changes(*state.of(material)) ==
          {"cut": "flat"}, parameters.changes(*state.of(material)))
    group.p_ring_width = 1e6
    check("Blender holds its sliders to the range", group.p_ring_width == 30, group.p_ring_width)
    set_(parameter="ring_width", value="1.7")
    set_(parameter="latewood_colour", value="0.2 0.1 0.05")
    set_(parameter="object", value='name: "q"')
    bpy.ops.sozai.update()
    text = read("keyaki.sozai")
    for line in ("preset: keyaki", "  ring_width: 1.7", '  object: "name: \\"q\\""', '  cut: "flat"',
                 "  latewood_colour: [0.2, 0.1, 0.05]"):
        check("written: " + line, line in text.splitlines(), text)
    check("nothing else is written", text.count("\n  ") == 4 + 1 + 2, text)
    group.preset = "oak"
    check("a preset sets every parameter", not parameters.changes(*state.of(material)),
          parameters.changes(*state.of(material)))


def nodes():
    material = plane(kind="wood", preset="oak")
    tree = material.sozai.group
    maps = {n.label for n in tree.nodes if n.type == "TEX_IMAGE"}
    check("a plain board's maps, of broad rays", maps == {"albedo", "fiber_lobe", "ray_lobe"}, maps)
    lobes = [n for n in tree.nodes if n.type == "BSDF_ANISOTROPIC"]
    check("fibres and rays each have a lobe", len(lobes) == 2, len(lobes))
    for glossy in lobes:
        check("they give the tangent", bool(glossy.inputs["Tangent"].links))
        check("and the normal", bool(glossy.inputs["Normal"].links))
    out = material.node_tree.get_output_node("CYCLES").inputs["Surface"].links[0]
    check("the group shades", out.from_node.node_tree == tree)
    # what an artist links stays
    glow = material.node_tree.nodes.new("ShaderNodeEmission")
    group = out.from_node
    material.node_tree.links.new(group.outputs["Albedo"], glow.inputs["Color"])
    bpy.ops.sozai.set(parameter="layout", value="strip")
    material.sozai.displace = True
    bpy.ops.sozai.update()
    maps = {n.label for n in tree.nodes if n.type == "TEX_IMAGE"}
    check("a displaced floor's maps", maps == {"albedo", "fiber_lobe", "ray_lobe", "height"}, maps)
    check("links outlive an update", bool(glow.inputs["Color"].links))
    check("displacement", bool(material.node_tree.get_output_node("CYCLES")
                               .inputs["Displacement"].links))
    count = len(tree.nodes)
    bpy.ops.sozai.update()
    check("an update adds no nodes", len(tree.nodes) == count, len(tree.nodes))
    check("one group and no more", sum(n.type == "GROUP" for n in material.node_tree.nodes) == 1)
    bpy.ops.sozai.set(parameter="ray_lustre", value="0")
    bpy.ops.sozai.update()
    maps = {n.label for n in tree.nodes if n.type == "TEX_IMAGE"}
    check("dull rays want no map", maps == {"albedo", "fiber_lobe", "height"}, maps)
    material.sozai.displace = False
    bpy.ops.sozai.set(parameter="layout", value="none")
    bpy.ops.sozai.set(parameter="surface", value="brushed")
    bpy.ops.sozai.update()
    maps = {n.label for n in tree.nodes if n.type == "TEX_IMAGE"}
    check("a brushed board has a relief", maps == {"albedo", "fiber_lobe", "normal"}, maps)
    stone = plane(kind="stone", preset="sandstone")
    bpy.ops.sozai.set(parameter="finish", value="split")
    bpy.ops.sozai.update()
    maps = {n.label for n in stone.sozai.group.nodes if n.type == "TEX_IMAGE"}
    check("a stone's maps", maps == {"albedo", "roughness", "normal"}, maps)


def solid():
    material = plane(kind="stone", preset="carrara")
    material.sozai.mode, material.sozai.mesh_pixels = "SOLID", 64
    obj = bpy.context.object
    obj.data.uv_layers.remove(obj.data.uv_layers[0])
    refused("a mesh without UVs", ["no UV map"], bpy.ops.sozai.update)
    obj.data.uv_layers.new()
    bpy.ops.sozai.update()
    check("the mesh is in mm", "v 100 100 0" in read("carrara.obj"), read("carrara.obj"))
    check("the recipe names it", 'mesh: "carrara.obj"' in read("carrara.sozai"))
    check("one part to a pixel", "samples" not in read("carrara.sozai"))
    material.sozai.samples = "4"
    bpy.ops.sozai.update()
    check("four parts to a pixel", "samples: 4" in read("carrara.sozai"), read("carrara.sozai"))
    for corner in obj.data.uv_layers[0].data:
        corner.uv[0] *= 2
    bpy.ops.sozai.update()
    image = next(i for i in bpy.data.images if i.get("sozai_channel") == "albedo"
                 and i.get("sozai_material") == material.name)
    check("two UDIM tiles", [t.number for t in image.tiles] == [1001, 1002] and
          "udim: 1002" in read("carrara.albedo.1002.sozai"))
    other = obj.copy()
    bpy.context.scene.collection.objects.link(other)
    refused("two objects of one block", ["2 objects"], bpy.ops.sozai.update)


def bake():
    material = plane(kind="wood", preset="teak")
    material.sozai.texel = 2
    bpy.ops.sozai.bake(format="exr", use=True)
    names = sorted(os.listdir(os.path.join(folder, "baked")))
    check("baked", names == ["teak.albedo.exr", "teak.fiber.exr", "teak.fiber_lobe.exr",
                              "teak.roughness.exr"], names)
    image = next(n.image for n in material.sozai.group.nodes if n.label == "albedo") \
        if material.sozai.group else None
    check("not before there are nodes" if image is None else "used",
          image is not None and image.filepath.endswith("baked/teak.albedo.exr"), image)
    check("Blender reads them itself", tuple(image.size) == (100, 100), tuple(image.size))
    bpy.ops.sozai.bake(format="png", pixels=32)
    check("PNG", os.path.isfile(os.path.join(folder, "baked", "teak.albedo.png")))
    refused("PNG is not used here", ["OpenEXR"], bpy.ops.sozai.bake, format="png", use=True)


def kept():
    material = plane(kind="wood", preset="sugi")
    bpy.ops.sozai.set(parameter="ring_width", value="3.25")
    bpy.ops.sozai.update()
    name, before = material.name, read("sugi.sozai")
    bpy.ops.wm.save_mainfile()
    bpy.ops.wm.open_mainfile(filepath=bpy.data.filepath)
    material = bpy.data.materials[name]
    check("preset is kept", material.sozai_wood.preset == "sugi", material.sozai_wood.preset)
    check("a value is kept", material.sozai_wood.p_ring_width == 3.25)
    check("the group is kept", material.sozai.group is not None)
    path = next(i.filepath for i in bpy.data.images if i.get("sozai_material") == name)
    check("paths are relative", path.startswith("//sozai/"), path)
    from sozai_addon import update
    for entry in os.listdir(folder):
        if entry.startswith("sugi"):
            os.remove(os.path.join(folder, entry))
    update.update(material, bpy.context.scene)
    check("the same file again", read("sugi.sozai") == before)


def names():
    """Names that a shell, YAML or OpenImageIO would take for more; and copies."""
    written = set()
    for name in ('a/b', "a_b", "a.b", 'q"#: {', "x?res=1&<UDIM>.%04d", "欅の床", "-o"):
        material = plane(kind="stone", preset="jura")
        material.name, material.sozai.texel = name, 20
        bpy.ops.sozai.update()
        path = next(n.image.filepath for n in material.sozai.group.nodes if n.label == "albedo")
        path = bpy.path.abspath(path)
        check("a file for %r" % name, os.path.isfile(path) and path not in written, path)
        check("its name is plain", not set('?<>&%"#:') & set(os.path.basename(path)), path)
        written.add(path)
    copied = material.copy()
    bpy.context.object.active_material = copied
    bpy.ops.sozai.update()
    check("a copy has a group of its own", copied.sozai.group != material.sozai.group and
          copied.node_tree.nodes["Group"].node_tree == copied.sozai.group)
    first, second = ({n.image.filepath for n in m.sozai.group.nodes if n.type == "TEX_IMAGE"}
                     for m in (material, copied))
    check("and files", first and second and not first & second, (first, second))


def previews():
    from sozai_addon import previews as drawn
    path = os.path.join(scratch, "preview.png")
    subprocess.run(drawn.command("wood", "keyaki", path), check=True)
    image = bpy.data.images.load(path)
    check("a preset's picture", tuple(image.size) == (drawn.SIDE, drawn.SIDE), tuple(image.size))


def refusals():
    refused("an unknown material", ["no material 'cheese'", "wood"], plane, kind="cheese")
    refused("an unknown preset", ["no preset 'cheddar'"], plane, kind="wood", preset="cheddar")
    material = plane(kind="wood")
    count = len(bpy.data.materials)
    bpy.ops.sozai.set(parameter="section", value="/no/such.png")
    refused("a missing section", ["/no/such.png"], bpy.ops.sozai.update)
    check("no material is left over", len(bpy.data.materials) == count)
    bpy.data.materials.remove(material)
    # without the program, and without the reader
    before = state.program_path
    for place in ("/no/such/sozai", "/etc/passwd"):
        try:
            program.find(place)
            check("no program at " + place, False)
        except program.Problem as problem:
            check("it says where", place in str(problem) and "\n" not in str(problem))
    old = os.environ.pop("SOZAI")
    os.environ["SOZAI"], path = "/no/such", os.environ["PATH"]
    os.environ["PATH"] = "/nowhere"
    find = program.os.path.realpath
    program.os.path.realpath = lambda p: "/nowhere/a/b/c"
    try:
        bpy.ops.sozai.connect()
        check("no program is refused", False)
    except RuntimeError as error:
        check("no program: one line", "not found" in str(error), str(error))
    finally:
        program.os.path.realpath = find
    check("and the panel says so", "not found" in state.trouble and not state.described)
    bpy.ops.mesh.primitive_plane_add(size=0.2)
    refused("and a script's call", ["not found on PATH", "preferences"], bpy.ops.sozai.new,
            kind="wood")
    refused("and one that grows", ["not found on PATH"], bpy.ops.sozai.grow_tree, preset="sugi")
    os.environ["SOZAI"], os.environ["PATH"] = old, path
    bpy.ops.sozai.connect()
    check("found again", state.program_path == before and not state.trouble, state.trouble)
    try:
        program.reader_folder(state.program_path, "/no/such/folder")
        check("no reader", False)
    except program.Problem as problem:
        check("no reader: it says where", "/no/such/folder" in str(problem))


def unsaved():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    plane(kind="stone", preset="inada")
    image = next(i for i in bpy.data.images if i.get("sozai_channel"))
    check("unsaved: in Blender's temporary folder", image.filepath.startswith(bpy.app.tempdir),
          image.filepath)


scene("addon")
for part in (lists, numbers, edits, nodes, solid, bake, kept, names, previews, refusals, unsaved):
    part()
sozai_addon.unregister()
check("nothing is left when disabled", not hasattr(bpy.types.Material, "sozai") and
      not hasattr(bpy.types.Material, "sozai_wood"))
finish()
