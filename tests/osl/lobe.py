#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How far is a microfacet lobe from the fibre cone?

hosts/osl/sozai_wood.osl and the Blender add-on stand a microfacet lobe in for the
cone of plugin/wood/cone.h, whose formula is written out here a second time:

    cone   T_i T_r g(width, psi_r + psi_i) / cos^2((psi_r - psi_i) / 2)
    facet  scale D(h) G / (4 cos_i cos_r), about the normal square to the fibre as
           it looks from above, alpha_along = along ior width, alpha_across = across

lobe.py             prints the table, and fails where it is past what is stated
lobe.py --fit       searches ACROSS, ALONG and SCALE anew, and prints them
lobe.py --sozai S   also holds the formula here against `S eval`'s radiance
"""
import argparse
import importlib
import math
import os
import subprocess
import sys

HOSTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 2, "hosts")
sys.dont_write_bytecode = True
sys.path[0] = os.path.join(HOSTS, "blender", "sozai_addon")
used = importlib.import_module("lobe")

NUMBERS = used.ALONG, used.ACROSS, used.SCALE
# By the dive in degrees: relative L2 error, reflectance's relative error, degrees between peaks.
STATED = {0: (0.4, 0.25, 4), 6: (0.55, 0.2, 6), 15: (0.8, 0.15, 8)}
LEAST = 1e-3


def unit(v):
    size = math.sqrt(sum(x * x for x in v))
    return [x / size for x in v]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def fresnel(eta, c):
    ct = math.sqrt(1 - (1 - c * c) / (eta * eta))
    p, s = (eta * c - ct) / (eta * c + ct), (c - eta * ct) / (c + eta * ct)
    return 0.5 * (p * p + s * s)


def inside(d, f, ior, coat):
    """Sine of the refracted inclination to the fibre, and what gets through; the normal is +z."""
    c = max(d[2], 1e-6)
    ct = math.sqrt(1 - (1 - c * c) / (ior * ior))
    s = d[0] / ior * f[0] + d[1] / ior * f[1] + ct * f[2]
    return max(-1.0, min(1.0, s)), 1 - coat * fresnel(ior, c)


def cone(i, r, f, width, ior, coat=0.0):
    si, ti = inside(i, f, ior, coat)
    sr, tr = inside(r, f, ior, coat)
    across = (math.asin(si) + math.asin(sr)) / width
    g = math.exp(-0.5 * across * across) / (width * math.sqrt(2 * math.pi))
    cd = math.sqrt((1 - si * si) * (1 - sr * sr)) + si * sr
    return ti * tr * g / max(0.5 * (1 + cd), LEAST)


def apparent(f, ior):
    """The fibre as it looks from above the surface, which steepens its dive."""
    return unit([f[0], f[1], ior * f[2]])


def facet(i, r, f, along, across):
    """GGX, anisotropic, with Smith's shadowing, about the normal square to the fibre f."""
    n = unit([-f[2] * f[0], -f[2] * f[1], 1 - f[2] * f[2]])
    b = [n[1] * f[2] - n[2] * f[1], n[2] * f[0] - n[0] * f[2], n[0] * f[1] - n[1] * f[0]]
    ci, cr = dot(i, n), dot(r, n)
    if ci <= 1e-4 or cr <= 1e-4:
        return 0.0
    h = unit([i[k] + r[k] for k in range(3)])
    hn, hx, hy = dot(h, n), dot(h, f), dot(h, b)
    t2 = ((hx / along) ** 2 + (hy / across) ** 2) / (hn * hn)
    d = 1 / (math.pi * along * across * hn**4 * (1 + t2) ** 2)

    def shadow(w, c):
        a = math.sqrt((dot(w, f) * along) ** 2 + (dot(w, b) * across) ** 2) / c
        return 0.5 * (math.sqrt(1 + a * a) - 1)

    return d / (1 + shadow(i, ci) + shadow(r, cr)) / (4 * ci * cr)


def directions(rings, spokes):
    """Of equal projected solid angle."""
    out = []
    for k in range(rings):
        s = math.sqrt((k + 0.5) / rings)
        for j in range(spokes):
            a = 2 * math.pi * (j + 0.5) / spokes
            out.append([s * math.cos(a), s * math.sin(a), math.sqrt(1 - s * s)])
    return out


def compare(width, ior, dive, theta, azimuth, along, across, scale, to):
    f = [math.cos(dive), 0.0, math.sin(dive)]
    i = [math.sin(theta) * math.cos(azimuth), math.sin(theta) * math.sin(azimuth), math.cos(theta)]
    a = [cone(i, r, f, width, ior) for r in to]
    seen = apparent(f, ior)
    b = [scale * facet(i, r, seen, along, across) for r in to]
    e = math.pi / len(to)
    square = sum(x * x for x in a) * e
    # where the two are brightest, as the inclination of the half vector to the fibre
    def peak(values):
        r = to[max(range(len(to)), key=values.__getitem__)]
        return math.degrees(math.asin(dot(unit([i[k] + r[k] for k in range(3)]), f)))
    return {
        "cone": sum(a) * e, "facet": sum(b) * e, "square": square,
        "error": sum((x - y) ** 2 for x, y in zip(a, b)) * e,
        "peak": abs(peak(a) - peak(b)),
    }


CASES = [(math.radians(w), math.radians(d)) for w in (6, 11, 20) for d in (0, 6, 15)]
LIGHTS = [(math.radians(t), math.radians(a)) for t in (5, 35, 60) for a in (0, 45, 90, 180)]
IOR = 1.55


def over(width, dive, to):
    along, across, scale = NUMBERS
    rows = [compare(width, IOR, dive, t, a, along * IOR * width, across, scale, to)
            for t, a in LIGHTS]
    count = len(rows)
    return {
        "error": math.sqrt(sum(r["error"] for r in rows) / sum(r["square"] for r in rows)),
        "cone": sum(r["cone"] for r in rows) / count,
        "facet": sum(r["facet"] for r in rows) / count,
        "peak": sum(r["peak"] for r in rows) / count,
    }


def fit(to):
    """The scale that is best follows from the other two."""
    best = None
    for across in (0.3, 0.4, 0.6, 0.8, 1.0):
        for along in (0.4, 0.5, 0.6, 0.8, 1.0):
            ab = aa = bb = 0.0
            for width, dive in CASES:
                f = [math.cos(dive), 0.0, math.sin(dive)]
                seen = apparent(f, IOR)
                for theta, azimuth in LIGHTS:
                    i = [math.sin(theta) * math.cos(azimuth), math.sin(theta) * math.sin(azimuth),
                         math.cos(theta)]
                    for r in to:
                        x = cone(i, r, f, width, IOR)
                        y = facet(i, r, seen, along * IOR * width, across)
                        # narrow lobes are high: weigh them as the wide ones
                        ab, aa, bb = ab + x * y * width, aa + x * x * width, bb + y * y * width
            error = math.sqrt(1 - ab * ab / (aa * bb))
            if best is None or error < best[0]:
                best = (error, along, across, ab / bb)
                print("error %.3f  along %.2f  across %.2f  scale %.2f" % best, flush=True)


def against_plugin(sozai):
    """The formula above is the plugin's: its radiance less its diffuse part, of straight fibres."""
    params = {"reflection": "fibre_cone", "cone_width": "11", "ior": "1.55", "coat": "0",
              "specular_tint": "0", "earlywood_colour": "0 0 0", "latewood_colour": "0 0 0",
              "vessel_colour": "0 0 0", "porosity": "none", "slope_noise": "0", "taper": "0",
              "pith_wander": "0", "undulation": "0", "fibre_brightness": "0", "section_wobble": "0",
              "fibre_reflectance": "0.07", "heartwood_years": "100000", "diffuse": "0"}
    arguments = [sozai, "eval", "wood", "--channels", "radiance,fiber,albedo"]
    for name, value in params.items():
        arguments += ["-p", name + "=" + value]
    rows = []
    for theta, azimuth in LIGHTS:
        for t, a in ((0.3, 0.5), (0.6, 2.0), (0.9, 3.5), (0.5, 5.0), (theta, azimuth + math.pi)):
            rows.append(([math.sin(theta) * math.cos(azimuth), math.cos(theta),
                          math.sin(theta) * math.sin(azimuth)],
                         [math.sin(t) * math.cos(a), math.cos(t), math.sin(t) * math.sin(a)]))
    dive = math.radians(10)  # of the fibre, which runs up +y: by leaning the normal
    n = [math.cos(dive), math.sin(dive), 0.0]
    side = [0.0, 0.0, 1.0]
    up = [-math.sin(dive), math.cos(dive), 0.0]

    def place(d):  # d: x along the fibre's trace, y out of the surface, z aside
        return [d[0] * up[k] + d[1] * n[k] + d[2] * side[k] for k in range(3)]

    text = "px,py,pz,nx,ny,nz,lx,ly,lz,vx,vy,vz\n"
    for light, view in rows:
        text += ",".join("%.9g" % x for x in [50, 0, 20] + n + place(light) + place(view)) + "\n"
    done = subprocess.run(arguments, input=text, capture_output=True, text=True, check=True)
    worst = 0.0
    for (light, view), line in zip(rows, done.stdout.splitlines()[1:]):
        got = [float(x) for x in line.split(",")]
        assert max(got[6:9]) < 1e-6, "the albedo was to be black"
        f = [dot(got[3:6], up), dot(got[3:6], side), dot(got[3:6], n)]
        swap = lambda d: [d[0], d[2], d[1]]  # noqa: E731
        i, r = swap(light), swap(view)
        wanted = 0.07 * math.pi * i[2] * cone(i, r, f, math.radians(11), 1.55)
        worst = max(worst, abs(got[0] - wanted))
    print("formula against sozai eval, %d pairs: largest difference %.2g" % (len(rows), worst))
    return worst < 2e-4


def report(r, width, dive):
    print("%4.0f %6.0f %17.2f %6.2f %18.2f %12.1f deg" % (
        math.degrees(width), math.degrees(dive), r["cone"], r["facet"], r["error"], r["peak"]))
    error, reflectance, peak = STATED[round(math.degrees(dive))]
    if r["error"] <= error and abs(1 - r["facet"] / r["cone"]) <= reflectance and \
            r["peak"] <= peak:
        return 0
    print("FAILED: past %.2f, %.0f %%, %.0f deg" % (error, 100 * reflectance, peak))
    return 1


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--fit", action="store_true")
    options.add_argument("--sozai")
    asked = options.parse_args()
    to = directions(14, 28)
    if asked.fit:
        fit(to)
        return 0
    failed = 0
    shared = {
        "sozai.h": ("clamp(%g * ior * width" % NUMBERS[0], "max(%g, along)" % NUMBERS[1],
                    "fade * %g * tint" % NUMBERS[2], "smoothstep(%g, %g, " % used.END_GRAIN),
        "sozai_wood.osl": ("min(%g * (fibre_colour" % used.REFLECTED,)}
    for name, texts in shared.items():
        with open(os.path.join(HOSTS, "osl", name), encoding="utf-8") as file:
            shader = file.read()
        for text in texts:
            if text not in shader:
                print("FAILED: hosts/osl/%s has other numbers: no '%s'" % (name, text))
                failed = 1
    if asked.sozai and not against_plugin(asked.sozai):
        print("FAILED: the formula is not the plugin's")
        failed = 1
    print("width  dive   reflectance: cone  facet   relative L2 error   peaks apart")
    for width, dive in CASES:
        failed |= report(over(width, dive, to), width, dive)
    return failed


if __name__ == "__main__":
    sys.exit(main())
