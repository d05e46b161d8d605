# SPDX-License-Identifier: Apache-2.0
"""The command `sozai` and the OpenImageIO reader: where they are, and running them.

No part of Blender is used here.
"""
import glob
import json
import os
import shutil
import subprocess

READER = "sozai.imageio.so"
SEARCHED = "OIIO_LIBRARY_PATH"


class Problem(Exception):
    """What the user is told, in one line."""


def find(chosen=""):
    """The program's path: what was chosen, $SOZAI, the tree that this file is in, PATH."""
    if chosen:
        path = os.path.abspath(os.path.expanduser(chosen))
        if os.path.isdir(path):
            path = os.path.join(path, "sozai")
        if os.access(path, os.X_OK) and os.path.isfile(path):
            return path
        raise Problem("sozai: no program at '%s', as the add-on's preferences say" % chosen)
    here = os.path.dirname(os.path.realpath(__file__))
    built = os.path.join(here, *[os.pardir] * 3, "build", "bin", "sozai")
    installed = os.path.join(here, *[os.pardir] * 4, "bin", "sozai")
    for path in (os.environ.get("SOZAI"), built, installed):
        if path and os.path.isfile(path) and os.access(path, os.X_OK):
            return os.path.normpath(path)
    path = shutil.which("sozai")
    if path:
        return path
    raise Problem("sozai: the program was not found on PATH; name it in the add-on's preferences")


def run(program, *arguments, stdin=None):
    """Its standard output; Problem with its own message when it fails."""
    try:
        done = subprocess.run([program, *arguments], input=stdin, capture_output=True, text=True,
                              check=False)
    except OSError as error:
        raise Problem("sozai: cannot run '%s': %s" % (program, error.strerror)) from error
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["exit code %d" % done.returncode]
        raise Problem(lines[-1])
    return done.stdout


def describe(program, name, *options):
    try:
        return json.loads(run(program, "describe", name, *options, "--json"))
    except ValueError as error:
        raise Problem("sozai: '%s describe' wrote no JSON: %s" % (program, error)) from error


def describe_all(program):
    """What `sozai describe --json` says of each material, and of each thing that `sozai grow`
    makes: both by id, in its own order."""
    ids = [line.split()[0] for line in run(program, "list").splitlines()
           if line and not line[0].isspace()]
    materials, grown = {}, {}
    for name in dict.fromkeys(ids):
        described = describe(program, name)
        if described["channels"]:  # what is grown has none
            materials[name] = described
        if not described["channels"] or ids.count(name) > 1:
            grown[name] = describe(program, name, "--grown")
    return materials, grown


def evaluate(program, recipe, channels, footprints):
    """Components of the channels at the origin, face up, under each footprint in mm; a recipe that
    is refused raises Problem."""
    rows = "".join("0,0,0,0,0,1,%.9g\n" % f for f in footprints)
    out = run(program, "eval", recipe, "--channels", ",".join(channels),
              stdin="px,py,pz,nx,ny,nz,footprint\n" + rows).splitlines()
    names = out[0].split(",")
    return [dict(zip(names, map(float, line.split(",")))) for line in out[1:]]


def reader_folder(program, chosen=""):
    """The folder of sozai.imageio.so; Problem when there is none."""
    beside = os.path.join(os.path.dirname(os.path.realpath(program)), os.pardir)
    if chosen:
        places = [os.path.abspath(os.path.expanduser(chosen))]
    else:
        places = [p for p in os.environ.get(SEARCHED, "").split(os.pathsep) if p]
        places += [os.path.join(beside, *rest) for rest in
                   (("lib",), ("lib", "sozai"), ("lib64", "sozai"))]
        places += glob.glob(os.path.join(beside, "lib", "*", "sozai"))
    for place in places:
        if os.path.isfile(os.path.join(place, READER)):
            return os.path.normpath(place)
    raise Problem("sozai: %s was not found in %s; name its folder in the add-on's preferences"
                  % (READER, ", ".join(os.path.normpath(p) for p in places)))


def offer_reader(folder):
    """Put the folder where OpenImageIO looks for readers.

    OpenImageIO reads the variable whenever it meets an ending that it does not
    know yet, so this works at any time before the first .sozai file is opened.
    """
    places = [p for p in os.environ.get(SEARCHED, "").split(os.pathsep) if p]
    if folder not in places:
        os.environ[SEARCHED] = os.pathsep.join([folder, *places])
