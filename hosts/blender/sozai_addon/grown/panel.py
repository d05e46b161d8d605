# SPDX-License-Identifier: Apache-2.0
"""The sidebar's tab in the 3D view, and Add > Mesh, Add > Curve."""
import bpy

from .. import panel as shared, parameters, previews, state
from . import settings


class Place:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "sozai"


class SOZAI_MT_trees(bpy.types.Menu):
    bl_label = "Tree (sozai)"
    bl_idname = "SOZAI_MT_trees"

    def draw(self, _context):
        presets(self.layout, "tree", "sozai.grow_tree")


class SOZAI_MT_strands(bpy.types.Menu):
    bl_label = "Strands in the mesh (sozai)"
    bl_idname = "SOZAI_MT_strands"

    def draw(self, _context):
        presets(self.layout, "fiber", "sozai.grow_fiber")


def presets(layout, kind, operator):
    # an operator drawn in a menu is executed, unless told to be invoked: it would block
    layout.operator_context = "INVOKE_DEFAULT"
    for preset in state.grown.get(kind, {}).get("presets", ()):
        layout.operator(operator, text=preset["label"]).preset = preset["id"]


def add_mesh(self, _context):
    if "tree" in state.grown:
        self.layout.menu(SOZAI_MT_trees.bl_idname, icon="OUTLINER_OB_FORCE_FIELD")


def add_curve(self, _context):
    if "fiber" in state.grown:
        self.layout.menu(SOZAI_MT_strands.bl_idname, icon="OUTLINER_OB_CURVES")


class SOZAI_PT_grown(Place, bpy.types.Panel):
    bl_label = "sozai: grown"

    def draw(self, context):
        column = self.layout.column()
        if state.trouble:
            for line in shared.wrapped(state.trouble, context.region.width):
                column.label(text=line)
        if not state.grown:
            column.operator("sozai.connect")
            return
        obj = context.object
        if not settings.is_grown(obj):
            column.menu(SOZAI_MT_trees.bl_idname, text="Grow a tree")
            row = column.row()
            row.enabled = obj is not None and obj.type == "MESH"
            row.menu(SOZAI_MT_strands.bl_idname, text="Fill '%s' with strands" % obj.name
                     if row.enabled else "Fill a mesh with strands")
            return
        grown = obj.sozai_grown
        group = getattr(obj, settings.attribute(grown.kind))
        column.use_property_split = True
        row = column.row(align=True)
        row.prop(group, "preset", text="Species" if grown.kind == "tree" else "Preset")
        row.operator("sozai.grow_preset", text="", icon="VIEWZOOM")
        picture = previews.icon("grown " + grown.kind, group.preset)
        if picture:
            column.template_icon(icon_value=picture, scale=6)
        if grown.kind == "fiber":
            column.prop(grown, "hull")
            column.prop(group, "p_count")
        else:
            column.prop(group, "p_age")
            column.prop(grown, "field")
        column.prop(grown, "level")
        row = column.row()
        row.operator_context = "INVOKE_DEFAULT"
        row.alert = grown.changed
        row.operator("sozai.grow_update", icon="FILE_REFRESH")
        if grown.kind == "tree":
            column.operator_context = "INVOKE_DEFAULT"
            column.operator("sozai.wood_of_tree", icon="MATERIAL")


def group_panel(kind, name):
    """A panel to each group of parameters."""
    def poll(cls, context):
        obj = context.object
        return kind in state.grown and settings.is_grown(obj) and obj.sozai_grown.kind == kind

    def draw(self, context):
        group = getattr(context.object, settings.attribute(kind))
        parameters.draw_group(self.layout, group, state.grown[kind], name)

    return type("SOZAI_PT_grown_%s_%s" % (kind, name.replace(" ", "_")),
                (Place, bpy.types.Panel), {
                    "bl_label": name.capitalize(), "bl_parent_id": "SOZAI_PT_grown",
                    "bl_options": {"DEFAULT_CLOSED"}, "poll": classmethod(poll), "draw": draw})


_made = []


def register():
    made = [SOZAI_MT_trees, SOZAI_MT_strands, SOZAI_PT_grown]
    for kind, described in state.grown.items():
        shown = [p["group"] for p in described["parameters"]
                 if p["kind"] != "buffer" and p["id"] not in settings.FROM_FILES]
        made += [group_panel(kind, name) for name in dict.fromkeys(shown)]
    for cls in made:
        bpy.utils.register_class(cls)
        _made.append(cls)
    bpy.types.VIEW3D_MT_mesh_add.append(add_mesh)
    bpy.types.VIEW3D_MT_curve_add.append(add_curve)


def unregister():
    if _made:
        bpy.types.VIEW3D_MT_mesh_add.remove(add_mesh)
        bpy.types.VIEW3D_MT_curve_add.remove(add_curve)
    while _made:
        bpy.utils.unregister_class(_made.pop())
