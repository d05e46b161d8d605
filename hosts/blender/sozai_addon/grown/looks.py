# SPDX-License-Identifier: Apache-2.0
"""Materials of strands and of trees' parts.

What the artist has changed stays: a value follows the parameters as long as it is what was
set here last.
"""
import math

import bpy

from .. import nodes, parameters
from .strands import COLOUR

IOR = 1.55
KEPT = "sozai_set"
BRIGHTEST = 0.98  # a hair BSDF of white or more loses no light, or turns dark


def hair_roughness(degrees):
    """Of the Principled Hair BSDF, for a highlight of that standard deviation along the strand:
    the fit of Chiang et al. 2016, turned round."""
    wanted, low, high = math.radians(degrees), 0.0, 1.0
    for _ in range(40):
        b = 0.5 * (low + high)
        low, high = (b, high) if 0.726 * b + 0.812 * b * b + 3.7 * b ** 20 < wanted else (low, b)
    return 0.5 * (low + high)


def put(material, values):
    """values: by 'label of the node:name of its input'."""
    kept = dict(material.get(KEPT, {}))
    for key, value in values.items():
        label, name = key.split(":")
        node = next((n for n in material.node_tree.nodes if n.label == label), None)
        if node is None or name not in node.inputs:
            continue
        socket = node.inputs[name]
        now, before = numbers(socket.default_value), kept.get(key)
        if before is not None and numbers(before) != now:
            continue
        socket.default_value = value
        kept[key] = numbers(socket.default_value)
    material[KEPT] = kept


def numbers(value):
    return [float(v) for v in value] if hasattr(value, "__len__") else [float(value)]


def builder(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.node_tree.nodes.clear()
    return material, nodes.Builder(material.node_tree)


def hair_values(values):
    """values: of the fibre's parameters."""
    reach = math.sqrt(3) * values["colour_spread"]  # evenly spread, of that standard deviation
    return {"strand:Roughness": hair_roughness(values["roughness"]),
            "strand:Radial Roughness": values["roughness_round"],
            "strand:Offset": math.radians(values["tilt"]),
            "from strand to strand:To Min": max(0.2, 1 - reach),
            "from strand to strand:To Max": min(2.0, 1 + reach)}


def hair(name, values, colour):
    """For hair curves; the strands' colours are the attribute's."""
    material, build = builder(name)
    attribute = build.node("ShaderNodeAttribute", "strands' colours", attribute_name=COLOUR)
    chance = build.node("ShaderNodeHairInfo", row=1).outputs["Random"]
    lightness = build.node("ShaderNodeMapRange", "from strand to strand", 1)
    build.link(chance, lightness.inputs["Value"])
    tint = build.scaled(attribute.outputs["Color"], lightness.outputs["Result"])
    tint = build.vector_math("MINIMUM", tint, (BRIGHTEST,) * 3, "below white")
    strand = build.node("ShaderNodeBsdfHairPrincipled", "strand", parametrization="COLOR")
    strand.inputs["IOR"].default_value = IOR
    build.link(tint, strand.inputs["Color"])
    build.link(strand.outputs[0], build.node("ShaderNodeOutputMaterial").inputs["Surface"])
    put(material, hair_values(values))
    material.diffuse_color = (*colour, 1)
    return material


def surface_values(colour, roughness):
    return {"surface:Base Color": (*colour, 1), "surface:Roughness": roughness}


def surface(name, colour, roughness, sheet=False, at_points=False):
    """sheet: leaves, which light comes through. at_points: its colour is the attribute's, and
    the colour given what an artist has who takes the link away."""
    material, build = builder(name)
    principled = build.node("ShaderNodeBsdfPrincipled", "surface")
    if at_points:
        attribute = build.node("ShaderNodeAttribute", "leaf by leaf" if sheet else "bark by its age",
                               attribute_name=COLOUR)
        build.link(attribute.outputs["Color"], principled.inputs["Base Color"])
    shader = principled.outputs["BSDF"]
    if sheet:
        through = build.node("ShaderNodeBsdfTranslucent", "light through it", 1)
        if at_points:
            build.link(attribute.outputs["Color"], through.inputs["Color"])
        both = build.node("ShaderNodeMixShader", "how much of it")
        both.inputs["Fac"].default_value = 0.3
        build.link(shader, both.inputs[1])
        build.link(through.outputs[0], both.inputs[2])
        shader = both.outputs[0]
    build.link(shader, build.node("ShaderNodeOutputMaterial").inputs["Surface"])
    values = surface_values(colour, roughness)
    if sheet:
        values["light through it:Color"] = (*colour, 1)
    put(material, values)
    material.diffuse_color = (*colour, 1)
    return material


def tree_part(name, part, key):
    leaf = key == "leaf"
    return surface("%s %s" % (name, part.name), part.colour, 0.5 if leaf else 0.85, leaf, True)


def follow_part(material, part):
    if material and KEPT in material:
        put(material, {"surface:Base Color": (*part.colour, 1),
                       "light through it:Color": (*part.colour, 1)})


def fibre_values(described, request):
    """Every parameter as it was asked for."""
    return parameters.start_values(described, request.preset or parameters.NONE) | request.values


def strand_materials(name, form, values, colours):
    if form == "HAIR":
        return [hair(name, values, colours[0])]
    rough = math.radians(values["roughness"]) ** 0.5  # Blender's is the root of the width
    return [surface(name, c, min(1.0, rough)) for c in colours]


def follow_strands(materials, form, values, colours):
    for k, material in enumerate(materials):
        if material is None or KEPT not in material:
            continue
        if form == "HAIR":
            put(material, hair_values(values))
        elif k < len(colours):
            put(material, {"surface:Base Color": (*colours[k], 1)})
