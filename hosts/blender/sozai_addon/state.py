# SPDX-License-Identifier: Apache-2.0
"""What the add-on knows while it is enabled: the program, its materials, and the
properties that are made of them."""
import bpy

from . import parameters, program, settings
from .grown import settings as grown_settings

program_path = ""
described = {}  # by material id
grown = {}  # by the id of what `sozai grow` makes
trouble = ""  # why there is no program, or no reader
_classes = []
_pending = set()  # names of materials to be updated


def attribute(kind):
    """Of bpy.types.Material: where a kind's parameters are."""
    return "sozai_" + kind


def preferences():
    addon = bpy.context.preferences.addons.get(__package__)
    return addon.preferences if addon else None


def connect():
    """Find the program, and make properties of what it describes. Problem when it cannot."""
    global program_path, described, grown, trouble
    disconnect()
    chosen = preferences()
    try:
        program_path = program.find(chosen.program if chosen else "")
        described, grown = program.describe_all(program_path)
        trouble = ""
    except program.Problem as problem:
        program_path, described, grown, trouble = "", {}, {}, str(problem)
        raise
    for kind, material in described.items():
        cls = parameters.group_class(material, _preset_chosen, _changed)
        bpy.utils.register_class(cls)
        _classes.append((kind, cls))
        setattr(bpy.types.Material, attribute(kind), parameters.pointer(cls))
    cls = settings.settings_class(described, _changed)
    bpy.utils.register_class(cls)
    _classes.append((None, cls))
    bpy.types.Material.sozai = parameters.pointer(cls)
    grown_settings.register(grown)
    try:
        offer_reader()
    except program.Problem as problem:
        trouble = str(problem)


def has(things, operator):
    """Whether `described` or `grown` was; a script's call is told why not."""
    if not things:
        operator.poll_message_set(trouble or "sozai: the add-on is not enabled")
    return bool(things)


def disconnect():
    grown_settings.unregister()
    while _classes:
        kind, cls = _classes.pop()
        delattr(bpy.types.Material, attribute(kind) if kind else "sozai")
        bpy.utils.unregister_class(cls)


def offer_reader():
    chosen = preferences()
    folder = program.reader_folder(program_path, chosen.reader if chosen else "")
    program.offer_reader(folder)
    return folder


def of(material):
    """Description and parameter group of the material's kind."""
    kind = material.sozai.kind
    return described[kind], getattr(material, attribute(kind))


def _preset_chosen(group, context):
    material = group.id_data
    kind = next(k for k in described if getattr(material, attribute(k)) == group)
    parameters.load_preset(described[kind], group)
    _changed(group, context)


def _changed(group, _context):
    """Update a little later, once for all that changes until then."""
    material = group.id_data
    if bpy.app.background or not material.sozai.group or not material.sozai.automatic:
        return
    _pending.add(material.name)
    if not bpy.app.timers.is_registered(_update_pending):
        bpy.app.timers.register(_update_pending, first_interval=0.4)


def _update_pending():
    from . import update
    global trouble
    names = list(_pending)
    _pending.clear()
    for name in names:
        material = bpy.data.materials.get(name)
        try:
            if material:
                update.update(material, bpy.context.scene)
            trouble = ""
        except (program.Problem, OSError) as problem:
            trouble = str(problem)
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            area.tag_redraw()
