# SPDX-License-Identifier: Apache-2.0
"""Geometry that `sozai grow` makes: strands that fill a mesh, and trees.

  settings.py     what an object remembers of how it was grown
  request.py      from there to the command's arguments
  job.py          the command, run beside Blender: progress, cancelling
  hull.py         the mesh that is filled, as a file in mm
  axes.py         sozai's axes and Blender's
  hair_file.py, gltf_file.py     reading what was grown
  strands.py, tree_mesh.py       from that to Blender's data
  looks.py        materials
  build.py        all of it on an object, or nothing
  operators.py, panel.py         what is seen of it
"""
