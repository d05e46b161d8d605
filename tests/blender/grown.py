# SPDX-License-Identifier: Apache-2.0
"""Strands in a mesh and trees, by the add-on: counts, places, materials, refusals, pictures."""
import bpy

from addon_test import check, finish, scene, sozai_addon
from growing import jobs, listed, panels, pictures, refusals, strands, trees

scene("grown")
listed.lists()
made = strands.fill()
strands.look(made)
strands.update_strands(made)
strands.poly()
made = trees.tree()
trees.update_tree(made)
trees.wood(made)
trees.measured()
refusals.kept()
refusals.refusals()
refusals.files()
jobs.ended()
jobs.modal()
panels.panels()
pictures.pictures()
sozai_addon.unregister()
check("nothing is left when disabled", not hasattr(bpy.types.Object, "sozai_grown") and
      not hasattr(bpy.types.Object, "sozai_grown_tree"))
finish()
