# SPDX-License-Identifier: Apache-2.0
"""What can be grown, as properties."""
import numpy
from addon_test import check, sozai_addon, state


def lists():
    check("what is grown", list(state.grown) == ["fiber", "tree"], list(state.grown))
    check("what is grown is no material", "tree" not in state.described, list(state.described))
    for kind, described in state.grown.items():
        cls = next(c for n, c in sozai_addon.grown.settings._classes
                   if n == "sozai_grown_" + kind).bl_rna.properties
        for p in described["parameters"]:
            if p["kind"] == "buffer" or p["id"] == "field":
                continue
            made = cls.get("p_" + p["id"])
            check("a property for %s's %s" % (kind, p["id"]), made is not None)
            check(p["id"] + "'s unit is seen", p["unit"] in made.name, made.name)
            if p["kind"] == "float":
                got = (made.hard_min, made.hard_max, made.soft_min, made.soft_max, made.default)
                wanted = (*p["hard_range"], *p["soft_range"], p["default"])
                check(p["id"] + "'s ranges", numpy.allclose(got, wanted, rtol=1e-6), got)
