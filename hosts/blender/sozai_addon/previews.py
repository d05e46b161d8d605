# SPDX-License-Identifier: Apache-2.0
"""Small pictures of the presets, drawn by `sozai render` when first shown, and kept."""
import os
import subprocess

import bpy
import bpy.utils.previews

from . import parameters, state

SIDE = 192
_icons = None
_drawing = {}  # path to the process that draws it


def folder():
    return os.path.join(bpy.utils.user_resource("CONFIG"), "sozai_previews")


def command(kind, preset, path):
    """A board, or a slab, from close by; a ball of strands; a tree of middling age."""
    if kind.startswith("grown "):
        kind = kind.split()[1]
        what = ["--species", preset, "--age", "15", "--level", "2"] if kind == "tree" else \
            ["--hull", "ball", "--material", preset]
        return [state.program_path, "grow", kind, *what, "-o", path, "--res",
                "%dx%d" % (SIDE, SIDE), "--spp", "16", "--threads", "1"]
    return [state.program_path, "render", kind, "--preset", preset, "-o", path, "--shape", "board",
            "--size", "120x120x20", "--res", "%dx%d" % (SIDE, SIDE), "--spp", "16", "--threads",
            "1", *(["--cut", "flat"] if kind == "wood" else [])]


def icon(kind, preset):
    """The picture's number for Blender's layouts; 0: none yet."""
    if preset == parameters.NONE or _icons is None:
        return 0
    name = "%s-%s" % (kind.replace(" ", "_"), preset)
    if name in _icons:
        return _icons[name].icon_id
    path = os.path.join(folder(), name + ".png")
    if os.path.isfile(path):
        return _icons.load(name, path, "IMAGE").icon_id
    if path not in _drawing:
        os.makedirs(folder(), exist_ok=True)
        # a program of its own: the panel is not to wait
        _drawing[path] = subprocess.Popen(command(kind, preset, path), stdout=subprocess.DEVNULL,
                                          stderr=subprocess.DEVNULL)
        if not bpy.app.timers.is_registered(_look):
            bpy.app.timers.register(_look, first_interval=0.5)
    return 0


def _look():
    """Show those that are finished; again in half a second while any is not."""
    for path, process in list(_drawing.items()):
        if process.poll() == 0:
            del _drawing[path]
            for window in bpy.context.window_manager.windows:
                for area in window.screen.areas:
                    area.tag_redraw()
    return 0.5 if any(p.poll() is None for p in _drawing.values()) else None


def register():
    global _icons
    _icons = bpy.utils.previews.new()


def unregister():
    global _icons
    for process in _drawing.values():
        if process.poll() is None:
            process.terminate()
        process.wait()
    _drawing.clear()
    if _icons is not None:
        bpy.utils.previews.remove(_icons)
    _icons = None
