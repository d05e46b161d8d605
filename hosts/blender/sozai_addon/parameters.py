# SPDX-License-Identifier: Apache-2.0
"""Blender properties made from what `sozai describe` says of a material."""
import math
import struct

import bpy
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty,
                       IntProperty, PointerProperty, StringProperty)

from . import program

NONE = "NONE"  # the preset's place when there is none
MOST_INT = 2**31 - 1  # of Blender's integers
TEXTS = ("text", "string", "path", "image")


def attribute(parameter):
    """Names of the group's own, such as `name`, are not to be met."""
    return "p_" + parameter["id"]


def label(parameter):
    return "%s (%s)" % (parameter["label"], parameter["unit"]) if parameter["unit"] else \
        parameter["label"]


def tooltip(parameter):
    text = parameter["doc"].rstrip(".")
    hard = parameter.get("hard_range")
    if hard and parameter["kind"] in ("float", "int", "float3"):
        text += ". From %g to %g %s" % (*hard, parameter["unit"])
    return text.strip()  # Blender adds the full stop


def definition(parameter, changed):
    """The property, or None for what has no place in a panel (tables)."""
    kind = parameter["kind"]
    common = {"name": label(parameter), "description": tooltip(parameter), "update": changed}
    default = parameter.get("default")
    if kind in ("float", "int", "float3"):
        low, high = parameter["hard_range"]
        soft_low, soft_high = parameter["soft_range"]
        if kind == "int":
            clamp = lambda x: int(max(-MOST_INT, min(MOST_INT, x)))  # noqa: E731
            return IntProperty(default=clamp(default), min=clamp(low), max=clamp(high),
                               soft_min=clamp(soft_low), soft_max=clamp(soft_high), **common)
        common |= {"min": low, "max": high, "soft_min": soft_low, "soft_max": soft_high,
                   "precision": 3, "step": max(1, int(100 * (soft_high - soft_low) / 100))}
        if kind == "float3" and "colour" in parameter["id"] and (low, high) == (0, 1):
            return FloatVectorProperty(size=3, subtype="COLOR_GAMMA", default=default, **common)
        if kind == "float3":
            return FloatVectorProperty(size=3, default=default, **common)
        return FloatProperty(default=default, **common)
    if kind == "bool":
        return BoolProperty(default=bool(default), **common)
    if kind == "choice":
        return EnumProperty(items=[(c["id"], c["id"].replace("_", " "), c["doc"].rstrip("."))
                                   for c in parameter["choices"]], default=default, **common)
    if kind == "colour":
        # The numbers are display-referred, as in a colour picker of gamma-corrected colours.
        return FloatVectorProperty(size=3, subtype="COLOR_GAMMA", default=default, min=0.0,
                                   max=1.0, **common)
    if kind in TEXTS:
        subtype = "FILE_PATH" if kind in ("path", "image") else "NONE"
        return StringProperty(default=default or "", subtype=subtype, **common)
    return None


def preset_definition(described, changed):
    items = [(NONE, "(none)", "Every parameter at its default")]
    items += [(p["id"], p["label"], p["doc"].rstrip(".")) for p in described["presets"]]
    return EnumProperty(name="Preset", items=items, update=changed,
                        description="A species, or a stone; sets every parameter")


def group_class(described, preset_changed, changed, name="", without=()):
    """A PropertyGroup with `preset` and a property to each parameter. name: of the class;
    without: parameters that are set elsewhere."""
    annotations = {"preset": preset_definition(described, preset_changed)}
    for parameter in described["parameters"]:
        made = definition(parameter, changed)
        if made is not None and parameter["id"] not in without:
            annotations[attribute(parameter)] = made
    return type("SOZAI_PG_" + (name or described["id"]), (bpy.types.PropertyGroup,),
                {"__annotations__": annotations,
                 "__doc__": "Parameters of sozai's " + described["label"]})


def plain(value):
    """A property's value as Python's own."""
    return list(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


def start_values(described, preset):
    """Values by id before anything is changed: defaults, and over them the preset's."""
    values = {p["id"]: p.get("default") for p in described["parameters"]}
    for entry in described["presets"]:
        if entry["id"] == preset:
            values.update(entry["values"])
    return {key: value["rgb"] if isinstance(value, dict) else value
            for key, value in values.items()}


def load_preset(described, group):
    values = start_values(described, group.preset)
    for parameter in described["parameters"]:
        name = attribute(parameter)
        value = values[parameter["id"]]
        if name in group.__annotations__ and value is not None:
            # whole numbers may be written as 1e+06
            setattr(group, name, int(value) if parameter["kind"] == "int" else value)
        elif name in group.__annotations__:
            group.property_unset(name)


def same(a, b):
    if isinstance(a, list):
        return isinstance(b, list) and len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, float) and not isinstance(b, str) and b is not None:
        return struct.pack("f", a) == struct.pack("f", b)
    return a == b


def changes(described, group):
    """Parameters that are not as the preset has them, in the order of the description."""
    start = start_values(described, group.preset)
    out = {}
    for parameter in described["parameters"]:
        name = attribute(parameter)
        if name not in group.__annotations__:
            continue
        value, before = plain(getattr(group, name)), start[parameter["id"]]
        if parameter["kind"] in TEXTS:
            before = before or ""
        if not same(value, before):
            out[parameter["id"]] = value
    return out


def read(parameter, text):
    """The text as the parameter's value; program.Problem names what is wrong with it."""
    kind, name = parameter["kind"], parameter["id"]
    if kind in TEXTS:
        return text
    if kind == "choice":
        ids = [c["id"] for c in parameter["choices"]]
        if text not in ids:
            raise program.Problem("%s: '%s' is none of %s" % (name, text, ", ".join(ids)))
        return text
    if kind == "bool":
        if text not in ("true", "false"):
            raise program.Problem("%s: '%s' is neither true nor false" % (name, text))
        return text == "true"
    if kind not in ("float", "int", "float3", "colour"):
        raise program.Problem("%s: a %s cannot be set here" % (name, kind))
    words, wanted = text.replace(",", " ").split(), 3 if kind in ("float3", "colour") else 1
    try:
        values = [int(w) if kind == "int" else float(w) for w in words]
    except ValueError:
        values = []
    low, high = parameter["hard_range"]
    if kind == "int":
        high = min(high, MOST_INT)
    if len(values) != wanted or not all(math.isfinite(v) and low <= v <= high for v in values):
        raise program.Problem(("%s: '%s' is not %s from %g to %g %s" % (
            name, text, "a whole number" if kind == "int" else
            "a number" if wanted == 1 else "three numbers", low, high, parameter["unit"])).strip())
    return values if wanted == 3 else values[0]


def pointer(cls):
    return PointerProperty(type=cls)


def draw_group(layout, values, described, name):
    """What may be set of one group of parameters."""
    column = layout.column()
    column.use_property_split = True
    for parameter in described["parameters"]:
        if parameter["group"] == name and attribute(parameter) in values.__annotations__:
            column.prop(values, attribute(parameter))
