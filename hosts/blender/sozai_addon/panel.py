# SPDX-License-Identifier: Apache-2.0
"""The panel in the material's properties."""
import bpy

from . import parameters, previews, state


class Place:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


class SOZAI_PT_material(Place, bpy.types.Panel):
    bl_label = "sozai"

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def draw(self, context):
        column = self.layout.column()
        if state.trouble:
            for line in wrapped(state.trouble, context.region.width):
                column.label(text=line)
            if not state.described:
                column.operator("sozai.connect")
                return
        material = context.material
        if material is None or material.sozai.group is None:
            for kind, described in state.described.items():
                column.operator("sozai.new", text="New " + described["label"].lower()).kind = kind
            if material is None:
                return
        s, group = material.sozai, state.of(material)[1]
        column.use_property_split = True
        column.prop(s, "kind")
        row = column.row(align=True)
        row.prop(group, "preset")
        row.operator("sozai.preset", text="", icon="VIEWZOOM")
        picture = previews.icon(s.kind, group.preset)
        if picture:
            column.template_icon(icon_value=picture, scale=6)
        column.separator()
        column.prop(s, "mode")
        if s.mode == "SOLID":
            column.prop(s, "along")
            column.prop(s, "mesh_pixels")
        else:
            if s.mode == "UV":
                column.prop(s, "uv_mm")
            column.prop(s, "size")
            column.prop(s, "texel")
            column.prop(s, "most_pixels")
        column.prop(s, "samples")
        column.prop(s, "displace")
        column.prop(s, "automatic")
        row = column.row()
        row.operator("sozai.update", icon="FILE_REFRESH")
        row.operator("sozai.bake", icon="IMAGE_DATA")


def wrapped(text, width):
    most = max(20, width // 8)
    line = ""
    for word in text.split():
        if line and len(line) + 1 + len(word) > most:
            yield line
            line = ""
        line += (" " if line else "") + word
    yield line


def group_panel(kind, name):
    """A panel to each group of a material's parameters."""
    def poll(cls, context):
        material = context.material
        return material is not None and kind in state.described and \
            material.sozai.group is not None and material.sozai.kind == kind

    def draw(self, context):
        group = getattr(context.material, state.attribute(kind))
        parameters.draw_group(self.layout, group, state.described[kind], name)

    return type("SOZAI_PT_%s_%s" % (kind, name), (Place, bpy.types.Panel), {
        "bl_label": name.capitalize(), "bl_parent_id": "SOZAI_PT_material",
        "bl_options": {"DEFAULT_CLOSED"}, "poll": classmethod(poll), "draw": draw})


_made = []


def register():
    bpy.utils.register_class(SOZAI_PT_material)
    _made.append(SOZAI_PT_material)
    for kind, described in state.described.items():
        for name in dict.fromkeys(p["group"] for p in described["parameters"]):
            cls = group_panel(kind, name)
            bpy.utils.register_class(cls)
            _made.append(cls)


def unregister():
    while _made:
        bpy.utils.unregister_class(_made.pop())
