# SPDX-License-Identifier: Apache-2.0
"""Menus and panels, without a window."""
import os
import subprocess
from types import SimpleNamespace

import bpy
from addon_test import check, scratch, sozai_addon, state
from sozai_addon.grown import panel

ICONS = bpy.types.UILayout.bl_rna.functions["prop"].parameters["icon"].enum_items


class Layout:
    """Takes down what is drawn; a name that there is not is a mistake."""

    def __init__(self):
        self.drawn = []

    def column(self, **_named):
        return self

    row = column

    def prop(self, data, name, text=None, icon="NONE"):
        check("a property %s" % name, name in data.bl_rna.properties)
        self.drawn.append(name)

    def operator(self, name, text=None, icon="NONE"):
        kind = getattr(bpy.ops.sozai, name.partition(".")[2]).get_rna_type()
        check("an icon " + icon, icon in ICONS)
        self.drawn.append(name)
        return SimpleNamespace(bl_rna=kind)

    def menu(self, name, text=None, icon="NONE"):
        check("a menu " + name, hasattr(bpy.types, name) and icon in ICONS)
        self.drawn.append(name)

    def label(self, text="", icon="NONE"):
        self.drawn.append(text)

    def template_icon(self, icon_value, scale):
        pass


def drawn(cls, context):
    layout = Layout()
    cls.draw(SimpleNamespace(layout=layout), context)
    return layout.drawn


def panels():
    obj = next(o for o in bpy.data.objects if o.type == "CURVES" and o.sozai_grown.kind == "fiber")
    of_tree = next(o for o in bpy.data.objects if o.sozai_grown.kind == "tree")
    previews = sozai_addon.previews.icon
    sozai_addon.previews.icon = lambda kind, preset: 0  # each is a program's run
    for shown, names in ((None, {"SOZAI_MT_trees", "SOZAI_MT_strands"}),
                         (obj, {"preset", "hull", "p_count", "level", "sozai.grow_update"}),
                         (of_tree, {"preset", "field", "p_age", "sozai.wood_of_tree"})):
        context = SimpleNamespace(object=shown, region=SimpleNamespace(width=300))
        got = drawn(panel.SOZAI_PT_grown, context)
        check("the panel of %s" % shown, names <= set(got), got)
        groups = [c for c in panel._made if hasattr(c, "bl_parent_id") and c.poll(context)]
        got = [name for c in groups for name in drawn(c, context)]
        if shown:
            kind = shown.sozai_grown.kind
            wanted = ["p_" + p["id"] for p in state.grown[kind]["parameters"]
                      if p["kind"] != "buffer" and p["id"] != "field"]
            check("every parameter is in a panel", sorted(got) == sorted(wanted), got)
        else:
            check("no parameters of nothing", not got, got)
    sozai_addon.previews.icon = previews
    for cls, kind in ((panel.SOZAI_MT_trees, "tree"), (panel.SOZAI_MT_strands, "fiber")):
        got = drawn(cls, bpy.context)
        check("a line to each preset", len(got) == len(state.grown[kind]["presets"]), got)
    path = os.path.join(scratch, "preview.png")
    command = sozai_addon.previews.command("grown tree", "sugi", path)
    command[command.index("--spp") + 1] = "1"
    subprocess.run(command, check=True)
    image = bpy.data.images.load(path)
    check("a species' picture", tuple(image.size) == (sozai_addon.previews.SIDE,) * 2)
