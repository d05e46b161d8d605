# SPDX-License-Identifier: Apache-2.0
"""sozai's axes are +x, +y up, +z; Blender's +x, +z up, -y. No part of Blender is used here."""
import numpy


def to_sozai(points):
    """Rows of x y z."""
    return numpy.stack((points[:, 0], points[:, 2], -points[:, 1]), axis=1)


def to_blender(points):
    return numpy.stack((points[:, 0], -points[:, 2], points[:, 1]), axis=1)


def linear(codes):
    """Light of display-referred sRGB."""
    codes = numpy.asarray(codes, dtype=numpy.float64)
    return numpy.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055) ** 2.4)
