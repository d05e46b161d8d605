# SPDX-License-Identifier: Apache-2.0
"""From a material's settings to its files, its images and its nodes."""
import math
import os
import zlib

import bpy

from . import mesh_export, nodes, parameters, program, recipe, state
from .program import Problem

RAW = "Non-Color"  # as stored: light in sozai is scene-linear already
BROAD_RAY = 100.0  # um: of wider ones each is seen to flash, and is worth a map of its own


def folder():
    """Beside the .blend, or in Blender's own temporary folder as long as that is unsaved."""
    if bpy.data.filepath:
        return os.path.join(os.path.dirname(bpy.data.filepath), "sozai")
    return os.path.join(bpy.app.tempdir, "sozai")


def clean(name):
    """As part of a file's name, which neither OpenImageIO nor a shell takes for more; other
    names stay other files."""
    plain = bpy.path.clean_name(name).replace("<", "_").replace(">", "_")
    return plain if plain == name else "%s-%08x" % (plain, zlib.crc32(name.encode()))


def users(material):
    return [o for o in bpy.data.objects
            if o.type == "MESH" and any(s.material == material for s in o.material_slots)]


def the_object(material):
    """The one object whose shape or place the picture depends on."""
    found = users(material)
    name = material.name
    if not found:
        raise Problem("'%s' is on no object; assign it first" % name)
    if len(found) > 1:
        raise Problem("'%s' is on %d objects (%s, %s ...): give each a material of its own, or "
                      "use the mode UV" % (name, len(found), found[0].name, found[1].name))
    return found[0]


def extent_of(settings, obj, scene):
    """mm that the picture shows, about the object's origin."""
    size = list(settings.size)
    if settings.mode == "OBJECT" and min(size) <= 0:
        mm = mesh_export.millimetres(scene)
        for k in range(2):
            if size[k] <= 0:
                reach = max(abs(corner[k]) for corner in obj.bound_box)
                size[k] = max(1.0, 2 * reach * abs(obj.scale[k]) * mm)
    return [s if s > 0 else 1000.0 for s in size]


def resolution_of(settings, extent, scene):
    """Pixels, so that a texel is as wide as asked for, within the largest allowed."""
    most = settings.most_pixels
    if scene.render.use_simplify and scene.cycles.texture_limit_render != "OFF":
        # Cycles would read the whole picture first and shrink it then
        most = min(most, int(scene.cycles.texture_limit_render))
    longest = max(extent)
    pixels = min(most, max(1, math.ceil(longest / settings.texel - 1e-3)))
    return [max(1, round(pixels * side / longest)) for side in extent]


def rays_flash(group):
    return (getattr(group, "p_reflection", "") == "fibre_cone" and group.p_ray_lustre > 0 and
            group.p_ray_density > 0 and group.p_ray_width >= BROAD_RAY)


def wanted_channels(described, material, group):
    there = {c["id"] for c in described["channels"]}
    wanted = ["albedo"]
    layout = getattr(group, "p_layout", "none") != "none"
    if "fiber_lobe" in there:
        wanted.append("fiber_lobe")
        if rays_flash(group):
            wanted.append("ray_lobe")
        relief = layout or getattr(group, "p_surface", "smooth") != "smooth"
    else:
        relief = getattr(group, "p_finish", "") != "polished"
        wanted += [c for c in ("roughness",) if c in there]
    if relief and not material.sozai.displace:
        wanted += [c for c in ("normal",) if c in there]
    if material.sozai.displace:
        wanted += [c for c in ("height",) if c in there]
    return wanted


def figures_of(described, group, base, programme, texel):
    """What is about the same everywhere; creating the texture also checks every parameter."""
    there = {c["id"] for c in described["channels"]}
    asked = ("albedo", "cone_colour", "cone_width", "ray_lustre", "coat", "coat_roughness")
    asked = [c for c in asked if c in there]
    # lobes are not to be wider by slopes that the maps have, nor a coat less where those are steep
    afar, figures = program.evaluate(programme, base, asked, (1000, texel))
    figures.update((name, afar[name]) for name in afar if name.startswith("albedo_"))
    figures["ior"] = getattr(group, "p_ior", 1.5)
    figures.setdefault("coat", 1.0)  # a stone's surface reflects all that it does
    figures["roughness"] = figures.pop("coat_roughness", 0.5)
    return figures


def image_for(material, channel, path, tiles):
    """The material's image of that channel, pointed at the file."""
    name = "sozai: %s %s" % (material.name, channel)
    image = next((i for i in bpy.data.images
                  if i.get("sozai_channel") == channel and i.get("sozai_material") ==
                  material.name), None)
    if image is None:
        image = bpy.data.images.load(path, check_existing=False)
        image.name = name
        image["sozai_channel"], image["sozai_material"] = channel, material.name
    image.source = "TILED" if tiles != [1001] else "FILE"
    image.filepath = bpy.path.relpath(path) if bpy.data.filepath else path
    if image.source == "TILED":
        image.filepath = image.filepath.replace(".1001.", ".<UDIM>.")
        for number in tiles:
            if image.tiles.get(number) is None:
                image.tiles.new(tile_number=number)
    image.colorspace_settings.name = RAW
    image.alpha_mode = "CHANNEL_PACKED"
    image.reload()
    return image


def texts(value):
    """Paths as the .sozai file is to have them."""
    head, mark, rest = value.partition(" @ ")
    return (bpy.path.abspath(head) if head.startswith("//") else head) + mark + rest


def params_of(described, group):
    kinds = {p["id"]: p["kind"] for p in described["parameters"]}
    changed = parameters.changes(described, group)
    return {key: texts(value) if kinds[key] in ("path", "image") else value
            for key, value in changed.items()}


def write_recipes(material, described, group, scene, extent):
    """The .sozai files, and the mesh; (path by channel, UDIM tiles, path of the one with all)."""
    settings, where, name = material.sozai, folder(), clean(material.name)
    tiles, surface, image = [1001], {"shape": "plane"}, {}
    if settings.mode == "SOLID":
        obj = the_object(material)
        mesh = os.path.join(where, name + ".obj")
        tiles = mesh_export.export(obj, mesh, settings.along, scene)
        surface = {"shape": "mesh", "mesh": os.path.basename(mesh)}
        image["resolution"] = min(settings.most_pixels, settings.mesh_pixels)
    else:
        image["size"] = [float(s) for s in extent]
        image["resolution"] = resolution_of(settings, extent, scene)
    if settings.samples != "1":
        image["samples"] = int(settings.samples)
    preset = "" if group.preset == parameters.NONE else group.preset
    params = params_of(described, group)
    base = os.path.join(where, name + ".sozai")
    recipe.write(base, recipe.text(described["id"], preset, params, surface, image))
    paths = {}
    for channel in wanted_channels(described, material, group):
        for tile in tiles:
            more = {"outputs": [channel]}
            middle = channel
            if tiles != [1001]:
                more["udim"], middle = tile, "%s.%d" % (channel, tile)
            path = os.path.join(where, "%s.%s.sozai" % (name, middle))
            recipe.write(path, recipe.output(os.path.basename(base), more))
            paths.setdefault(channel, path)
    if tiles != [1001]:  # Blender wants to hear of the first
        paths = {c: os.path.join(where, "%s.%s.1001.sozai" % (name, c)) for c in paths}
    return paths, tiles, base


def update(material, scene):
    """Everything; Problem says in one line what is to be mended. Returns a remark, or ''."""
    settings = material.sozai
    described, group = state.of(material)
    state.offer_reader()
    obj = the_object(material) if settings.mode != "UV" else None
    settings.object_scale = obj.scale if obj else (1.0, 1.0, 1.0)
    extent = extent_of(settings, obj, scene)
    paths, tiles, base = write_recipes(material, described, group, scene, extent)
    if tiles != [1001] and 1001 not in tiles:
        raise Problem("'%s': Blender wants the first UDIM tile, 1001, to be in use" % material.name)
    figures = figures_of(described, group, base, state.program_path, settings.texel)
    images = {c: image_for(material, c, path, tiles) for c, path in paths.items()}
    tree = nodes.build_group(material, images, extent, figures)
    nodes.use_group(material, tree)
    # for viewports that show no textures
    material.diffuse_color = [figures["albedo_" + c] for c in "rgb"] + [1.0]
    if not bpy.data.filepath:
        return "unsaved: files are in %s until the .blend is saved and updated" % folder()
    return ""
