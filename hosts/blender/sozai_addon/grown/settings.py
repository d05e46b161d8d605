# SPDX-License-Identifier: Apache-2.0
"""What an object remembers of how it was grown: in the .blend, on the object itself."""
import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, PointerProperty, StringProperty

from .. import parameters

FROM_FILES = ("field",)  # text parameters whose place a file's name takes

_classes = []


def attribute(kind):
    """Of bpy.types.Object: where a kind's parameters are."""
    return "sozai_grown_" + kind


def _changed(group, _context):
    group.id_data.sozai_grown.changed = True


def _chooser(described):
    def chosen(group, context):
        parameters.load_preset(described, group)
        _changed(group, context)
    return chosen


def settings_class(grown):
    kinds = [("NONE", "None", "Not grown")]
    kinds += [(k, d["label"], d["doc"].rstrip(".")) for k, d in grown.items()]
    return type("SOZAI_PG_grown", (bpy.types.PropertyGroup,), {"__annotations__": {
        "kind": EnumProperty(name="Grown", items=kinds, options={"HIDDEN"}),
        "hull": PointerProperty(
            name="Hull", type=bpy.types.Object, update=_changed,
            poll=lambda _self, obj: obj.type == "MESH",
            description="The closed mesh that the strands fill, as its modifiers leave it"),
        "field": StringProperty(
            name="Field table", subtype="FILE_PATH", update=_changed,
            description="A measured tree's field table, which takes the place of stem and branches"),
        "level": IntProperty(
            name="Level of detail", min=0, max=8, default=0, update=_changed,
            description="0 is all there is; each more is about half of it"),
        "changed": BoolProperty(options={"HIDDEN"}),
    }})


def register(grown):
    """Properties of what `sozai describe --grown` says, by id."""
    for kind, described in grown.items():
        cls = parameters.group_class(described, _chooser(described), _changed, "grown_" + kind,
                                     FROM_FILES)
        bpy.utils.register_class(cls)
        _classes.append((attribute(kind), cls))
        setattr(bpy.types.Object, attribute(kind), parameters.pointer(cls))
    cls = settings_class(grown)
    bpy.utils.register_class(cls)
    _classes.append(("sozai_grown", cls))
    bpy.types.Object.sozai_grown = parameters.pointer(cls)


def unregister():
    while _classes:
        name, cls = _classes.pop()
        delattr(bpy.types.Object, name)
        bpy.utils.unregister_class(cls)


def is_grown(obj):
    return obj is not None and hasattr(obj, "sozai_grown") and obj.sozai_grown.kind != "NONE"
