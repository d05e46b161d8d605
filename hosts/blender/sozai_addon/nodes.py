# SPDX-License-Identifier: Apache-2.0
"""The node group that shades with a material's maps.

One group to a material: rebuilt when the material changes, so that whatever the
artist links to its outputs stays linked.

  Shader        all of it, for the material's output
  Albedo        diffuse reflectance
  Roughness     as the Principled BSDF counts it
  Normal        world space, of the relief
  Fibre         world space, unit; zero where there is none, as in open vessels
  Height        scene's units, for a Displacement node
"""
import bpy

from . import lobe
from .mesh_export import millimetres

OUTPUTS = (("Shader", "NodeSocketShader"), ("Albedo", "NodeSocketColor"),
           ("Roughness", "NodeSocketFloat"), ("Normal", "NodeSocketVector"),
           ("Fibre", "NodeSocketVector"), ("Height", "NodeSocketFloat"))
# Euler angles that turn sozai's axes back to the object's; see mesh_export.TURNS.
QUARTER = 1.5707963267948966
BACK = {"X": (0, 0, -QUARTER), "Y": None, "Z": (QUARTER, 0, 0)}


def add_output(tree, kind, name):
    if hasattr(tree, "interface"):  # Blender 4
        tree.interface.new_socket(name, in_out="OUTPUT", socket_type=kind)
    else:
        tree.outputs.new(kind, name)


def output_names(tree):
    if hasattr(tree, "interface"):
        return [i.name for i in tree.interface.items_tree if i.item_type == "SOCKET"]
    return [o.name for o in tree.outputs]


def group_of(material):
    """The material's group, made where there is none; its nodes are gone."""
    tree = material.sozai.group
    if tree is None:
        tree = bpy.data.node_groups.new("sozai: " + material.name, "ShaderNodeTree")
        material.sozai.group = tree
    elif any(m != material and m.sozai.group == tree for m in bpy.data.materials):
        tree = unshare(material, tree)
    there = output_names(tree)
    for name, kind in OUTPUTS:
        if name not in there:
            add_output(tree, kind, name)
    tree.nodes.clear()
    return tree


def unshare(material, tree):
    """A copied material begins with its model's group, and needs one of its own."""
    own = tree.copy()
    own.name = "sozai: " + material.name
    for node in material.node_tree.nodes:
        if node.type == "GROUP" and node.node_tree == tree:
            node.node_tree = own
    material.sozai.group = own
    return own


class Builder:
    """Adds nodes from left to right."""

    def __init__(self, tree):
        self.tree = tree
        self.column = 0

    def node(self, kind, label="", row=0, **settings):
        made = self.tree.nodes.new(kind)
        made.label = label
        made.location = (220 * self.column, -260 * row)
        for name, value in settings.items():
            setattr(made, name, value)
        self.column += 1
        return made

    def link(self, source, target):
        self.tree.links.new(source, target)

    def put(self, value, target):
        """A socket is linked, a number or a tuple is the input's own value."""
        if isinstance(value, bpy.types.NodeSocket):
            self.link(value, target)
        else:
            target.default_value = value

    def vector_math(self, operation, a, b=None, label="", row=0):
        made = self.node("ShaderNodeVectorMath", label, row, operation=operation)
        for socket, value in zip(made.inputs, (a, b)):
            if value is not None:
                self.put(value, socket)
        return made.outputs["Value" if operation in ("DOT_PRODUCT", "LENGTH") else "Vector"]

    def scaled(self, vector, factor, row=0):
        made = self.node("ShaderNodeVectorMath", "", row, operation="SCALE")
        self.put(vector, made.inputs[0])
        self.put(factor, made.inputs["Scale"])
        return made.outputs["Vector"]

    def math(self, operation, a, b, row=0):
        made = self.node("ShaderNodeMath", "", row, operation=operation)
        self.put(a, made.inputs[0])
        self.put(b, made.inputs[1])
        return made.outputs[0]


def first_input(node, *names):
    """Sockets were renamed in Blender 4."""
    for name in names:
        if name in node.inputs:
            return node.inputs[name]
    raise KeyError(names[0])


def place_of_texels(build, settings, extent):
    """Where in the picture a point lies; extent: mm that it shows."""
    if settings.mode == "OBJECT":
        coordinates = build.node("ShaderNodeTexCoord")
        mm = millimetres(bpy.context.scene)
        scale = [s * mm for s in settings.object_scale[:2]]
        factor = (scale[0] / extent[0], scale[1] / extent[1], 0.0)
        place = build.vector_math("MULTIPLY", coordinates.outputs["Object"], factor,
                                  "metres to pictures")
        return build.vector_math("ADD", place, (0.5, 0.5, 0.0), "from the corner")
    uv = build.node("ShaderNodeUVMap").outputs["UV"]
    if settings.mode == "UV":
        factor = (settings.uv_mm / extent[0], settings.uv_mm / extent[1], 0.0)
        uv = build.vector_math("MULTIPLY", uv, factor, "UVs to pictures")
    return uv


def add_maps(build, settings, images, extent):
    """Image nodes; the colour output of each by channel."""
    place = place_of_texels(build, settings, extent)
    out = {}
    column = build.column
    for row, (channel, image) in enumerate(images.items()):
        build.column = column
        node = build.node("ShaderNodeTexImage", channel, row, image=image,
                          extension="REPEAT" if settings.mode == "UV" else "EXTEND")
        build.link(place, node.inputs["Vector"])
        out[channel] = node.outputs["Color"]
    return out


def to_world(build, settings, vector, row):
    """A direction among the texture's axes, in world space, unit."""
    if settings.mode == "UV":
        tangent = build.node("ShaderNodeTangent", row=row, direction_type="UV_MAP")
        normal = build.node("ShaderNodeNewGeometry", row=row).outputs["Normal"]
        along = tangent.outputs["Tangent"]
        across = build.vector_math("CROSS_PRODUCT", normal, along, row=row)
        split = build.node("ShaderNodeSeparateXYZ", row=row)
        build.link(vector, split.inputs[0])
        parts = [build.scaled(axis, part, row)
                 for axis, part in zip((along, across, normal), split.outputs)]
        vector = build.vector_math("ADD", parts[0], parts[1], row=row)
        vector = build.vector_math("ADD", vector, parts[2], row=row)
        return build.vector_math("NORMALIZE", vector, row=row)
    if settings.mode == "SOLID" and BACK[settings.along]:
        turn = build.node("ShaderNodeVectorRotate", "to the object's axes", row,
                          rotation_type="EULER_XYZ")
        build.link(vector, turn.inputs["Vector"])
        turn.inputs["Rotation"].default_value = BACK[settings.along]
        vector = turn.outputs["Vector"]
    # Object to world scales, the texture's axes do not: take that out beforehand.
    vector = build.vector_math("DIVIDE", vector, tuple(settings.object_scale), row=row)
    transform = build.node("ShaderNodeVectorTransform", "", row, vector_type="VECTOR",
                           convert_from="OBJECT", convert_to="WORLD")
    build.link(vector, transform.inputs[0])
    return build.vector_math("NORMALIZE", transform.outputs[0], row=row)


def fibre_lobe(build, fibre, share, normal, figures, lustre, row):
    """A glossy lobe about the normal square to the fibre: Marschner's cone, nearly.

    share: of the texel, that has it. lustre: 1 of fibres, of rays' cells how much brighter."""
    width, ior = figures["cone_width"], figures["ior"]
    roughness, anisotropy = lobe.anisotropic(width, ior)
    # Through the surface the fibre is seen to dive more steeply.
    dive = build.vector_math("DOT_PRODUCT", fibre, normal, "sine of the dive", row)
    down = build.scaled(normal, build.math("MULTIPLY", dive, ior - 1.0, row), row)
    seen = build.vector_math("NORMALIZE", build.vector_math("ADD", fibre, down, row=row), row=row)
    dive = build.vector_math("DOT_PRODUCT", seen, normal, row=row)
    square = build.vector_math("SUBTRACT", normal, build.scaled(seen, dive, row), row=row)
    # End grain shows no cone, and has no such normal.
    fade = build.node("ShaderNodeMapRange", "end grain", row, interpolation_type="SMOOTHSTEP")
    build.link(build.vector_math("LENGTH", square, row=row), fade.inputs["Value"])
    fade.inputs["From Min"].default_value = lobe.END_GRAIN[0]
    fade.inputs["From Max"].default_value = lobe.END_GRAIN[1]
    square = build.vector_math("NORMALIZE", square, label="square to the fibre", row=row)
    glossy = build.node("ShaderNodeBsdfAnisotropic", "fibres", row, distribution="GGX")
    colour = tuple(min(1.0, lobe.SCALE * lustre * c) for c in tint_of(figures))
    strength = build.math("MULTIPLY", fade.outputs["Result"], share, row)
    build.link(build.scaled(colour, strength, row), glossy.inputs["Color"])
    glossy.inputs["Roughness"].default_value = roughness
    glossy.inputs["Anisotropy"].default_value = anisotropy
    build.link(square, glossy.inputs["Normal"])
    build.link(seen, glossy.inputs["Tangent"])
    return glossy.outputs["BSDF"]


def tint_of(figures):
    return [figures["cone_colour_" + c] for c in "rgb"]


def add_lobes(build, settings, maps, normal, figures, out):
    """The lobes of the fibres, and of rays where those have a map: (BSDFs, what they leave).

    A map's vectors lie along the axis and are as long as its share of the texel."""
    bsdfs, taken = [], None
    for row, (channel, lustre) in enumerate((("fiber_lobe", 1.0),
                                             ("ray_lobe", figures["ray_lustre"])), 4):
        if channel not in maps:
            continue
        axis = to_world(build, settings, maps[channel], row)
        out.setdefault("Fibre", axis)
        share = build.vector_math("LENGTH", maps[channel], label="share of the texel", row=row)
        bsdfs.append(fibre_lobe(build, axis, share, normal, figures, lustre, row))
        part = build.scaled(tuple(lobe.REFLECTED * lustre * c for c in tint_of(figures)), share,
                            row)
        taken = part if taken is None else build.vector_math("ADD", taken, part, row=row)
    left = build.vector_math("SUBTRACT", (1.0, 1.0, 1.0), taken, row=4)
    return bsdfs, build.vector_math("MAXIMUM", left, (0.0, 0.0, 0.0), "what the lobes leave", 4)


def build_group(material, images, extent, figures):
    """images: by channel; extent: mm; figures: what is the same everywhere, by name."""
    settings = material.sozai
    build = Builder(group_of(material))
    maps = add_maps(build, settings, images, extent)
    out = {"Albedo": maps["albedo"]}

    principled = build.node("ShaderNodeBsdfPrincipled", "surface", 1)
    normal = build.node("ShaderNodeNewGeometry", row=2).outputs["Normal"]
    if "normal" in maps:
        normal = to_world(build, settings, maps["normal"], 2)
        build.link(normal, principled.inputs["Normal"])
    out["Normal"] = normal
    base = maps["albedo"]
    if "roughness" in maps:  # GGX's alpha, of which Blender takes the root
        out["Roughness"] = build.math("POWER", maps["roughness"], 0.5, 1)
        build.link(out["Roughness"], principled.inputs["Roughness"])
    else:
        value = build.node("ShaderNodeValue", "roughness", 1).outputs[0]
        value.default_value = figures["roughness"]
        build.link(value, principled.inputs["Roughness"])
        out["Roughness"] = value
    shine = first_input(principled, "Specular", "Specular IOR Level")
    ior = figures["ior"]
    if shine.name == "Specular":
        shine.default_value = figures["coat"] * lobe.reflectance_at_normal(ior) / 0.08
    else:
        principled.inputs["IOR"].default_value = ior
        shine.default_value = 0.5 * figures["coat"]
    surface = principled.outputs["BSDF"]
    if "fiber_lobe" in maps:
        bsdfs, left = add_lobes(build, settings, maps, normal, figures, out)
        base = build.vector_math("MULTIPLY", base, left)
        for bsdf in bsdfs:
            both = build.node("ShaderNodeAddShader")
            build.link(surface, both.inputs[0])
            build.link(bsdf, both.inputs[1])
            surface = both.outputs[0]
    build.link(base, principled.inputs["Base Color"])
    out["Shader"] = surface
    if "height" in maps:
        out["Height"] = build.math("DIVIDE", maps["height"], millimetres(bpy.context.scene), 3)
    end = build.node("NodeGroupOutput")
    for name, socket in out.items():
        build.link(socket, end.inputs[name])
    return settings.group


def use_group(material, tree):
    """Put the group into the material, and to its output where nothing else is linked there."""
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    group = next((n for n in nodes if n.type == "GROUP" and n.node_tree == tree), None)
    output = material.node_tree.get_output_node("CYCLES") or nodes.new("ShaderNodeOutputMaterial")
    if group is None:
        group = nodes.new("ShaderNodeGroup")
        group.node_tree = tree
        group.location = (output.location.x - 260, output.location.y)
        old = output.inputs["Surface"].links
        # the Principled BSDF that every new material has makes way
        if old and old[0].from_node.type == "BSDF_PRINCIPLED":
            nodes.remove(old[0].from_node)
        links.new(group.outputs["Shader"], output.inputs["Surface"])
    displacement = next((n for n in nodes if n.label == "sozai's height"), None)
    if material.sozai.displace and displacement is None:
        displacement = nodes.new("ShaderNodeDisplacement")
        displacement.label = "sozai's height"
        displacement.location = (output.location.x - 200, output.location.y - 220)
        displacement.inputs["Midlevel"].default_value = 0.0
        displacement.inputs["Scale"].default_value = 1.0
        links.new(group.outputs["Height"], displacement.inputs["Height"])
        links.new(displacement.outputs[0], output.inputs["Displacement"])
    elif not material.sozai.displace and displacement is not None:
        nodes.remove(displacement)
    method = "DISPLACEMENT" if material.sozai.displace else "BUMP"
    if hasattr(material, "displacement_method"):  # Blender 4.1
        material.displacement_method = method
    else:
        material.cycles.displacement_method = method
    return group
