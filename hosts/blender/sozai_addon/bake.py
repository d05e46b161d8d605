# SPDX-License-Identifier: Apache-2.0
"""Images on disk, through `sozai bake`."""
import bpy

from . import program, update


def bake(material, scene, kind, pixels, use):
    raise program.Problem("not yet")
