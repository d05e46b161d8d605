# SPDX-License-Identifier: Apache-2.0
"""From a grown file to an object: a new one, or one that is there with other data in it."""
import bpy

from ..mesh_export import millimetres
from ..program import Problem
from . import gltf_file, hair_file, hull, looks, request as requests, strands, tree_mesh

PARTS = "sozai_parts"  # of the data: which part each slot of materials is
FORM = {"CURVES": "HAIR", "CURVE": "POLY"}
STORES = {"MESH": "meshes", "CURVES": "hair_curves", "CURVE": "curves"}


def remove(data, kind):
    getattr(bpy.data, STORES[kind]).remove(data)


def finish(request, path, context):
    """Read the file and show it: the object, and what was made in a few words."""
    obj = None
    if request.target:
        obj = bpy.data.objects.get(request.target)
        if obj is None or obj.sozai_grown.kind != request.kind:
            raise Problem("'%s' is gone: nothing to update" % request.target)
        if obj.mode != "OBJECT":
            raise Problem("'%s' is being edited: leave that mode first" % obj.name)
    name = request.preset or request.kind
    if request.kind == "fiber":
        data, words = fibre(request, hair_file.read(path), obj, name, context.scene)
    else:
        data, words = tree(request, gltf_file.read(path), obj, name, context.scene)
    if obj is None:
        obj = add(request, data, name, context)
    else:
        replace(obj, data)
    requests.remember(request, obj)
    return obj, words


def fibre(request, hair, obj, name, scene):
    form = FORM[obj.type] if obj else request.form
    if len(hair.first) < 2:
        raise Problem("there are no strands: give more, or a larger hull")
    values = looks.fibre_values(requests.described_as("fiber"), request)
    colours = strands.colours_of(hair)[0]
    kept = list(obj.data.materials) if obj else []
    looks.follow_strands(kept, form, values, colours)
    if len(kept) < (1 if form == "HAIR" else len(colours)):
        kept += looks.strand_materials(name + " strand", form, values, colours[len(kept):])
    data = strands.make(name, hair, millimetres(scene), form, kept)
    return data, "%d strands of %d points" % (len(hair.first) - 1, len(hair.points))


def tree(request, grown, obj, name, scene):
    kept = list(obj.data.materials) if obj else []
    keys = obj.data.get(PARTS, "").split(",")[:len(kept)] if obj and kept else []
    keys += [""] * (len(kept) - len(keys))
    for part in grown.parts:
        key = tree_mesh.key(part)
        if key in keys:
            looks.follow_part(kept[keys.index(key)], part)
        else:
            keys.append(key)
            kept.append(looks.tree_part(name, part, key))
    data = tree_mesh.make(name, grown, millimetres(scene), {k: i for i, k in enumerate(keys)})
    for material in kept:
        data.materials.append(material)
    data[PARTS] = ",".join(keys)
    return data, "%d faces, %d points" % (len(grown.triangles), len(grown.points))


def add(request, data, name, context):
    obj = bpy.data.objects.new(name, data)
    body = bpy.data.objects.get(request.hull) if request.hull else None
    if body:
        obj.matrix_world = hull.placing(body)
        # it would hide what is in it
        body.hide_render, body.display_type = True, "WIRE"
    else:
        obj.location = context.scene.cursor.location
    context.collection.objects.link(obj)
    for other in list(context.selected_objects):
        other.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj
    return obj


def replace(obj, data):
    """Whoever shows the old data shows the new."""
    old, kind, name = obj.data, obj.type, obj.data.name
    old.user_remap(data)
    remove(old, kind)
    data.name = name
