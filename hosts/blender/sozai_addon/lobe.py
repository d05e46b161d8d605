# SPDX-License-Identifier: Apache-2.0
"""A microfacet lobe in place of the fibres' cone; tests/osl/lobe.py says how near it comes.

No part of Blender is used here.
"""
import math

# Fitted by tests/osl/lobe.py --fit.
ALONG, ACROSS, SCALE = 0.8, 0.8, 3.4
END_GRAIN = 0.2, 0.7  # cosines of the dive between which the lobe fades in
REFLECTED = 2.1  # of white fibres, about, when light comes from all sides; the rest is diffuse


def anisotropic(width, ior):
    """Roughness and anisotropy of the Glossy (Anisotropic) BSDF for a cone of width radians."""
    along = min(max(ALONG * ior * width, 1e-3), 1.0)
    across = max(ACROSS, along)
    # Cycles: alpha = roughness^2 (1 - a) along the tangent and roughness^2 / (1 - a) across
    return (along * across) ** 0.25, 1.0 - math.sqrt(along / across)


def reflectance_at_normal(ior):
    return ((ior - 1.0) / (ior + 1.0)) ** 2
