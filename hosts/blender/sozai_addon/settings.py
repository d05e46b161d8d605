# SPDX-License-Identifier: Apache-2.0
"""What a material has beside its parameters: how the picture meets the object."""
import bpy
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty,
                       IntProperty, PointerProperty)

MODES = (
    ("SOLID", "Solid", "Cut from one piece: the object's mesh, which must have UVs, is unwrapped; "
                       "grain runs on round every edge and over every seam"),
    ("OBJECT", "Plane", "The object's x and y, in its own space: floors, walls, table tops. Needs "
                        "no UVs"),
    ("UV", "UV", "The active UV map, taken for a plane"),
)
ALONG = (("X", "X", "The object's x becomes sozai's +y"),
         ("Y", "Y", "The object's axes are sozai's"),
         ("Z", "Z", "The object's z becomes sozai's +y"))
SAMPLES = tuple((n, n, "%s x %s parts of each pixel" % (n, n)) for n in ("1", "2", "4", "8"))


def settings_class(described, changed):
    kinds = [(kind, m["label"], m["doc"].rstrip(".")) for kind, m in described.items()]
    return type("SOZAI_PG_settings", (bpy.types.PropertyGroup,), {"__annotations__": {
        "kind": EnumProperty(name="Material", items=kinds, update=changed,
                             description="Which of sozai's materials"),
        "mode": EnumProperty(name="Mode", items=MODES, update=changed, default="OBJECT",
                             description="How the object meets the material"),
        "along": EnumProperty(
            name="Length along", items=ALONG, default="Y", update=changed,
            description="The object's axis that lies along sozai's +y: a board's length"),
        "size": FloatVectorProperty(
            name="Size (mm)", size=2, min=0.0, max=1e6, update=changed,
            description="What the picture shows, about the origin; 0: as far as the object "
                        "reaches. In the mode UV it repeats beyond, 0: 1000 mm"),
        "texel": FloatProperty(
            name="Texel (mm)", default=0.25, min=0.001, max=1000.0, soft_min=0.02, soft_max=2.0,
            precision=3, update=changed,
            description="Width of a pixel of the picture on the object"),
        "most_pixels": IntProperty(
            name="Most pixels", default=4096, min=16, max=65536, update=changed,
            description="Of the picture's longer side, for Cycles holds the whole picture: "
                        "4096 x 4096 pixels take 128 MB to a map of colours, 256 MB to one of directions"),
        "mesh_pixels": IntProperty(
            name="Pixels", default=2048, min=16, max=65536, update=changed,
            description="A side of the unwrapped mesh's picture, each UDIM tile's"),
        "samples": EnumProperty(
            name="Samples", items=SAMPLES, default="1", update=changed,
            description="Of how many parts across, and down, a pixel is the mean. Cloth and felt "
                        "whose strands or yarns are a pixel or less want 4, which takes some "
                        "twenty times as long; wood and stone want 1"),
        "uv_mm": FloatProperty(
            name="UV unit (mm)", default=1000.0, min=0.001, max=1e6, update=changed,
            description="How many mm one unit of the UV map is"),
        "displace": BoolProperty(
            name="Displace", update=changed,
            description="Move the surface by the height, in place of tilting its normal; the "
                        "mesh must be fine enough"),
        "automatic": BoolProperty(
            name="Update by itself", default=True,
            description="Write the files and load the pictures again whenever a value changes"),
        "object_scale": FloatVectorProperty(size=3, default=(1, 1, 1), options={"HIDDEN"}),
        "group": PointerProperty(type=bpy.types.NodeTree, options={"HIDDEN"}),
    }})
