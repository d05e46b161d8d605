# SPDX-License-Identifier: Apache-2.0
"""Reading sozai's own glTF: one buffer of millimetres within the file, a primitive and a
material to each part. No part of Blender is used here."""
import base64
import json
from dataclasses import dataclass

import numpy

from ..program import Problem

MARK = b"base64,"
TYPES = {5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


@dataclass
class Part:
    name: str
    colour: tuple  # light
    triangles: int


@dataclass
class Mesh:
    points: numpy.ndarray  # rows of x y z, mm
    normals: numpy.ndarray
    uvs: numpy.ndarray
    triangles: numpy.ndarray  # rows of three points, part by part
    parts: list
    colours: numpy.ndarray  # of each point, light: its own, or its part's


def read(path):
    """Problem when it is not as sozai writes it."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        return parse(data)
    except (ValueError, KeyError, IndexError, TypeError) as error:
        raise Problem("'%s' is no glTF of sozai's, or is cut short: %s" % (path, error)) from error


def parse(data):
    begin = data.index(MARK) + len(MARK)
    end = data.index(b'"', begin)
    # JSON's reader need not see the numbers
    head = json.loads(data[:begin] + data[end:])
    numbers = base64.b64decode(memoryview(data)[begin:end], validate=True)

    def array(index):
        a = head["accessors"][index]
        view = head["bufferViews"][a["bufferView"]]
        width = WIDTHS[a["type"]]
        flat = numpy.frombuffer(numbers, TYPES[a["componentType"]], width * a["count"],
                                view["byteOffset"] + a.get("byteOffset", 0))
        return flat.reshape(-1, width) if width > 1 else flat

    primitives = head["meshes"][0]["primitives"]
    at = primitives[0]["attributes"]
    points, normals, uvs = (array(at[k]) for k in ("POSITION", "NORMAL", "TEXCOORD_0"))
    indices, parts = [], []
    colours = numpy.zeros((len(points), 3), "f4")
    for primitive in primitives:
        material = head["materials"][primitive["material"]]
        indices.append(array(primitive["indices"]).reshape(-1, 3))
        colour = material["pbrMetallicRoughness"]["baseColorFactor"]
        own = primitive["attributes"].get("COLOR_0")
        if own is not None:  # by which a white material is multiplied
            colour = material["extras"]["colour"]
        here = indices[-1].ravel()
        colours[here] = colour[:3] if own is None else array(own)[here, :3] / 65535
        parts.append(Part(material["name"], tuple(colour[:3]), len(indices[-1])))
    triangles = numpy.concatenate(indices)
    if len(triangles) and triangles.max() >= len(points):
        raise ValueError("point %d of %d" % (triangles.max(), len(points)))
    return Mesh(points, normals, uvs, triangles, parts, colours)
