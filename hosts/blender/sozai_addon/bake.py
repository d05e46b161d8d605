# SPDX-License-Identifier: Apache-2.0
"""Images on disk through `sozai bake`, for hosts and viewports without the reader."""
import os

import bpy

from . import program, state, update


def shared_channels(described, material, group):
    """What the nodes use, and what other hosts' materials take."""
    wanted = update.wanted_channels(described, material, group)
    if "normal" in wanted or "height" in wanted:
        wanted += ["normal", "height"]
    there = [c["id"] for c in described["channels"]]
    return [c for c in there if c in wanted + ["roughness", "fiber"]]


def bake(material, scene, kind, pixels, use):
    if use and kind != "exr":
        raise program.Problem("bake: to be used here, directions must be OpenEXR, not PNG")
    described, group = state.of(material)
    settings = material.sozai
    obj = update.the_object(material) if settings.mode != "UV" else None
    settings.object_scale = obj.scale if obj else (1.0, 1.0, 1.0)
    extent = update.extent_of(settings, obj, scene)
    _, tiles, base = update.write_recipes(material, described, group, scene, extent)
    folder = os.path.join(os.path.dirname(base), "baked")
    os.makedirs(folder, exist_ok=True)
    middle = "<output>" if tiles == [1001] else "<output>.<UDIM>"
    pattern = os.path.join(folder, "%s.%s.%s" % (update.clean(material.name), middle, kind))
    channels = shared_channels(described, material, group)
    arguments = ["bake", base, "-o", pattern, "--outputs", ",".join(channels)]
    if pixels:
        arguments += ["--res", str(pixels)]
    if kind == "png":
        arguments += ["--bits", "16"]
    program.run(state.program_path, *arguments)
    if use:
        show(material, pattern, update.wanted_channels(described, material, group), tiles)
    where = bpy.path.relpath(folder) if bpy.data.filepath else folder
    return "baked %s to %s" % (", ".join(channels), where)


def show(material, pattern, channels, tiles):
    """The material's image nodes show the baked files until the next update."""
    for channel in channels:
        path = pattern.replace("<output>", channel).replace("<UDIM>", "1001")
        if not os.path.isfile(path):
            raise program.Problem("bake: %s was not written" % path)
        update.image_for(material, channel, path, tiles)
