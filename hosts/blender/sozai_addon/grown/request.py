# SPDX-License-Identifier: Apache-2.0
"""What is to be grown, as plain values: it outlives what the artist does meanwhile."""
from dataclasses import dataclass, field

import bpy

from .. import parameters, recipe, state
from ..program import Problem
from . import hull, job, settings

PRESET = {"fiber": "--material", "tree": "--species"}
ENDING = {"fiber": ".hair", "tree": ".gltf"}
LEVEL = {"fiber": 0, "tree": 2}  # a whole tree is millions of faces


@dataclass
class Request:
    kind: str
    preset: str = ""
    values: dict = field(default_factory=dict)  # of parameters, where they are not the preset's
    level: int = 0
    field: str = ""  # a file
    hull: str = ""  # objects are named, not held: they may be gone when this is done
    target: str = ""  # the object that is grown again; empty: a new one
    form: str = "HAIR"


def described_as(kind):
    if kind not in state.grown:
        raise Problem("sozai grows no '%s'" % kind)
    return state.grown[kind]


def new(kind, preset, params, **more):
    """params: NAME=VALUE, blanks between. Problem names what is wrong."""
    described = described_as(kind)
    if preset and preset not in [p["id"] for p in described["presets"]]:
        raise Problem("%s has no preset '%s'" % (kind, preset))
    values = dict(read(described, word) for word in params.split())
    return Request(kind, preset, values, **more)


def read(described, text):
    """NAME=VALUE as the parameter's id and value."""
    name, equals, value = text.partition("=")
    if not equals:
        raise Problem("'%s' is not NAME=VALUE" % text)
    found = next((p for p in described["parameters"] if p["id"] == name), None)
    if found is None:
        raise Problem("%s has no parameter '%s'" % (described["id"], name))
    if name in settings.FROM_FILES:
        raise Problem("%s: name the table's file under 'Field table'" % name)
    return name, parameters.read(found, value)


def of_object(obj):
    """To grow the object again, as its settings are now."""
    grown = obj.sozai_grown
    described = described_as(grown.kind)
    group = getattr(obj, settings.attribute(grown.kind))
    preset = "" if group.preset == parameters.NONE else group.preset
    return Request(grown.kind, preset, parameters.changes(described, group), grown.level,
                   grown.field, grown.hull.name if grown.hull else "", obj.name)


def remember(request, obj):
    """The other way round, onto the object."""
    grown, group = obj.sozai_grown, getattr(obj, settings.attribute(request.kind))
    grown.kind, grown.level, grown.field = request.kind, request.level, request.field
    grown.hull = bpy.data.objects.get(request.hull) if request.hull else None
    group.preset = request.preset or parameters.NONE
    for name, value in request.values.items():
        setattr(group, "p_" + name, value)
    grown.changed = False


def text(value):
    """As `sozai grow -p NAME=` takes it."""
    if isinstance(value, str):
        return value
    return ",".join(map(recipe.number, value)) if isinstance(value, list) else recipe.scalar(value)


def arguments(request):
    out = [PRESET[request.kind], request.preset] if request.preset else []
    for name, value in request.values.items():
        out += ["-p", "%s=%s" % (name, text(value))]
    if request.level:
        out += ["--level", str(request.level)]
    if request.kind == "tree" and request.field:
        out += ["--field", bpy.path.abspath(request.field)]
    return out


def begin(request, scene):
    """The command at work on it. Problem when it cannot begin."""
    if not state.program_path:
        raise Problem(state.trouble or "sozai: the program was not found")
    prepare = None
    if request.kind == "fiber":
        body = bpy.data.objects.get(request.hull) if request.hull else None
        if body is None or body.type != "MESH":
            raise Problem("no hull: %s, and strands fill a mesh" % (
                "'%s' is none" % body.name if body else
                "'%s' is gone" % request.hull if request.hull else "nothing is active"))
        points, triangles = hull.arrays(body, scene)

        def prepare(folder):
            path = folder + "/hull.ply"
            hull.write(path, points, triangles)
            return ["--hull", path]
    return job.Job(state.program_path, request.kind, arguments(request), ENDING[request.kind],
                   prepare, bpy.app.tempdir or None)
