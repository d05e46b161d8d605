# SPDX-License-Identifier: Apache-2.0
"""Grown wood, laid floors and stone in Cycles, through OpenImageIO; strands and trees.

  program.py      the command sozai: finding and running it
  state.py        what is known while the add-on is enabled
  settings.py     how a picture meets an object
  parameters.py   properties from `sozai describe --json`
  recipe.py       the text of .sozai files
  mesh_export.py  the object's mesh, for the unwrapping
  update.py       from all that to files, images and nodes
  nodes.py        the node group; lobe.py its numbers
  bake.py         images for hosts without a reader
  operators.py, panel.py, previews.py    what is seen of it
  grown/          strands and trees, from `sozai grow`
"""
bl_info = {
    "name": "sozai",
    "author": "the sozai authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Material > sozai; 3D View > Sidebar > sozai; Add > Mesh, Curve",
    "description": "Materials that are grown: wood, floors, stone, for Cycles; strands, trees",
    "category": "Material",
}

import bpy  # noqa: E402

from . import operators, panel, previews, program, state  # noqa: E402
from .grown import job, operators as grown_operators, panel as grown_panel, wood  # noqa: E402

classes = (*operators.classes, *grown_operators.classes, *wood.classes)


def register():
    for cls in classes:
        bpy.utils.register_class(cls)
    previews.register()
    try:
        state.connect()
    except program.Problem as problem:
        print(problem)
    panel.register()
    grown_panel.register()


def unregister():
    job.close_all()
    grown_panel.unregister()
    panel.unregister()
    state.disconnect()
    previews.unregister()
    for cls in reversed(classes):
        bpy.utils.unregister_class(cls)
