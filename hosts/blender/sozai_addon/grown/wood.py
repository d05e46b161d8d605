# SPDX-License-Identifier: Apache-2.0
"""The wood of a grown tree, as a material: its branches are the knots."""

import bpy
from bpy.props import EnumProperty

from .. import operators, parameters, program, state
from . import request as requests, settings

CARRIED = ("seed", "age")  # what wood knows of a tree, beside the species and a field table


def values_of(tree):
    """Wood's parameters, and those of the tree's that wood has no place for."""
    request = requests.of_object(tree)
    start = parameters.start_values(requests.described_as("tree"), request.preset or parameters.NONE)
    all_values = start | request.values
    values = {"tree": request.preset, "tree_age": all_values["age"], "seed": int(all_values["seed"])}
    if request.field:
        with open(bpy.path.abspath(request.field), encoding="utf-8") as file:
            values["tree_field"] = file.read()
    elif not request.preset:
        raise program.Problem("'%s' is of no species: choose a preset" % tree.name)
    return values, [k for k in request.values if k not in CARRIED and not k.endswith("_colour")]


_items = []  # Blender wants the strings kept


def woods(_self, _context):
    wood = state.described.get("wood")
    if wood and len(_items) != len(wood["presets"]):
        _items[:] = [(p["id"], p["label"], p["doc"]) for p in wood["presets"]]
    return _items


def own_wood(tree):
    """The preset of wood that has the species' name, or ''."""
    name = getattr(tree, settings.attribute("tree")).preset
    return name if name in [i[0] for i in woods(None, None)] else ""


class SOZAI_OT_wood_of_tree(bpy.types.Operator):
    """A new wood material, sawn from the active tree, on the other meshes that are selected"""

    bl_idname = "sozai.wood_of_tree"
    bl_label = "Wood of this tree"
    bl_options = {"UNDO"}
    bl_property = "wood"
    wood: EnumProperty(name="Wood", items=woods)

    @classmethod
    def poll(cls, context):
        tree = context.object
        if not state.has(state.described, cls):
            return False
        if not ("wood" in state.described and settings.is_grown(tree) and
                tree.sozai_grown.kind == "tree"):
            cls.poll_message_set("select a mesh, then a tree that sozai grew as the active object")
            return False
        return True

    def invoke(self, context, _event):
        if own_wood(context.object):
            return self.execute(context)
        context.window_manager.invoke_search_popup(self)
        return {"FINISHED"}

    def execute(self, context):
        tree = context.object
        targets = [o for o in context.selected_objects if o.type == "MESH" and o != tree]
        try:
            if not targets:
                raise program.Problem("select the mesh as well that is to be of this tree's wood")
            wood = self.wood if self.properties.is_property_set("wood") else own_wood(tree)
            if not wood:
                raise program.Problem("wood has no preset '%s': name one" % getattr(
                    tree, settings.attribute("tree")).preset)
            values, lost = values_of(tree)
            for target in targets:
                operators.make_material(target, "wood", wood, "OBJECT", context.scene, values,
                                        "%s from %s" % (wood, tree.name))
        except (program.Problem, OSError, UnicodeDecodeError) as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        if lost:
            self.report({"WARNING"}, "the wood grows its tree from species, age and seed, without "
                        "what was changed of " + ", ".join(lost))
        return {"FINISHED"}


classes = (SOZAI_OT_wood_of_tree,)
