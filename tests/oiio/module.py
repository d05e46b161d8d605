# SPDX-License-Identifier: Apache-2.0
"""OpenImageIO's Python module over a .sozai file. module.py SOZAI SCRATCH"""
import os
import subprocess
import sys

try:
    import OpenImageIO as oiio
except ImportError:
    print("no OpenImageIO module (Debian: python3-openimageio)")
    sys.exit(77)

sozai, scratch = sys.argv[1:3]
os.makedirs(scratch, exist_ok=True)
path = os.path.join(scratch, "inada.sozai")
with open(path, "w") as file:
    file.write("material: stone\npreset: inada\nimage: {resolution: 128, size: 64, format: float}\n")


def evaluate(level):
    """The albedo at that level's texels, by the command."""
    n = 128 >> level
    rows = ["px,py,pz,nx,ny,nz,footprint"]
    for y in range(n):
        for x in range(n):
            rows.append("%.9g,%.9g,0,0,0,1,%.9g" % (((x + 0.5) / n - 0.5) * 64,
                                                    -((y + 0.5) / n - 0.5) * 64, 64 / n))
    out = subprocess.run([sozai, "eval", path, "--channels", "albedo"], input="\n".join(rows),
                         capture_output=True, text=True, check=True).stdout.split()
    return [[float(v) for v in row.split(",")[:3]] for row in out[1:]]


def compare(got, wanted, tolerance):
    worst = max(abs(a - b) for g, w in zip(got, wanted) for a, b in zip(g, w))
    assert len(got) == len(wanted) and worst <= tolerance, worst
    return worst


picture = oiio.ImageInput.open(path)
assert picture, oiio.geterror()
spec = picture.spec()
assert (spec.width, spec.height, spec.nchannels, spec.tile_width) == (128, 128, 3, 64)
assert spec.channelnames == ("R", "G", "B")
for level in range(8):
    pixels = picture.read_image(0, level, 0, 3, oiio.FLOAT)
    assert pixels is not None, picture.geterror()
    worst = compare(pixels.reshape(-1, 3).tolist(), evaluate(level), 1e-6)
    print("level %d: at most %.2g off" % (level, worst))
picture.close()

buffer = oiio.ImageBuf(path + "?res=256&outputs=height")
assert buffer.read(), buffer.geterror()
assert buffer.spec().width == 256 and buffer.nchannels == 1
assert not oiio.ImageInput.open(path + "?res=none")
assert "res=none" in oiio.geterror()
