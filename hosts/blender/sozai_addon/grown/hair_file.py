# SPDX-License-Identifier: Apache-2.0
"""Reading .hair files: a header of 128 bytes, then arrays, little-endian. No part of Blender
is used here."""
import struct
from dataclasses import dataclass

import numpy

from ..program import Problem

HEADER = 128
SEGMENTS, POINTS, THICKNESS, TRANSPARENCY, COLOURS = 1, 2, 4, 8, 16  # which arrays there are


@dataclass
class Hair:
    first: numpy.ndarray  # strand i has points first[i] up to first[i + 1]
    points: numpy.ndarray  # rows of x y z, the file's unit
    radii: numpy.ndarray
    colours: numpy.ndarray  # of each strand, rows of r g b


def read(path):
    """Problem when the file is none, or is cut short."""
    with open(path, "rb") as file:
        data = file.read()
    if len(data) < HEADER or data[:4] != b"HAIR":
        raise Problem("'%s' is no .hair file" % path)
    strands, points, arrays, segments = struct.unpack_from("<4I", data, 4)
    thickness, _, *colour = struct.unpack_from("<5f", data, 20)
    at = HEADER

    def take(there, kind, count):
        nonlocal at
        if not arrays & there:
            return None
        size = count * numpy.dtype(kind).itemsize
        if at + size > len(data):
            raise Problem("'%s' is cut short: %d bytes" % (path, len(data)))
        at += size
        return numpy.frombuffer(data, kind, count, at - size)

    counts = take(SEGMENTS, "<u2", strands)
    counts = numpy.full(strands, segments) if counts is None else counts
    first = numpy.concatenate(([0], numpy.cumsum(counts.astype(numpy.int64) + 1)))
    if first[-1] != points or not arrays & POINTS:
        raise Problem("'%s': its strands have %d points, not %d" % (path, first[-1], points))
    place = take(POINTS, "<f4", 3 * points).reshape(-1, 3)
    thick = take(THICKNESS, "<f4", points)
    take(TRANSPARENCY, "<f4", points)
    of_points = take(COLOURS, "<f4", 3 * points)
    colours = numpy.tile(numpy.float32(colour), (strands, 1)) if of_points is None else \
        of_points.reshape(-1, 3)[first[:-1]]
    radii = numpy.full(points, thickness / 2, "f4") if thick is None else thick / 2
    return Hair(first, place, radii, colours)
