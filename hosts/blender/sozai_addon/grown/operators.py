# SPDX-License-Identifier: Apache-2.0
"""Growing, from menus, buttons and scripts: bpy.ops.sozai.grow_*

Called from a menu the command runs beside Blender: its progress is in the status bar, Esc
ends it. A script's call returns when the object is there.
"""
import time

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, StringProperty

from .. import parameters, state
from ..program import Problem
from . import build, request as requests, settings

FORMS = (
    ("HAIR", "Hair", "Blender's hair curves: light to hold and to draw, round to Cycles"),
    ("POLY", "Curve", "A curve of poly splines with a bevel: for modifiers, exporters and older "
                      "tools; up to some thousand strands"),
)
TICK = 0.1  # seconds between looks at the command
TROUBLES = (Problem, OSError, MemoryError)


class Growing:
    """What the operators share; request(context) says what is wanted."""

    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        if not state.has(state.grown, cls):
            return False
        if context.mode != "OBJECT":
            cls.poll_message_set("leave the edit mode first")
            return False
        return True

    def begin(self, context):
        self.wanted = self.request(context)
        self.job = requests.begin(self.wanted, context.scene)

    def end(self, context):
        """The object, or one line on why there is none."""
        try:
            _, words = build.finish(self.wanted, self.job.result(), context)
            self.report({"INFO"}, words)
            return {"FINISHED"}
        except TROUBLES as trouble:
            return self.refuse(trouble)
        finally:
            self.job.close()

    def refuse(self, trouble):
        self.report({"ERROR"}, str(trouble) or "out of memory")
        return {"CANCELLED"}

    def execute(self, context):
        try:
            self.begin(context)
        except TROUBLES as trouble:
            return self.refuse(trouble)
        return self.end(context)

    def invoke(self, context, _event):
        if bpy.app.background or context.window is None:
            return self.execute(context)
        return self.start(context)

    def start(self, context):
        """Let the command run; modal() hears of it from now on."""
        try:
            self.begin(context)
        except TROUBLES as trouble:
            return self.refuse(trouble)
        self.began = time.monotonic()
        manager = context.window_manager
        self.timer = manager.event_timer_add(TICK, window=context.window)
        manager.modal_handler_add(self)
        manager.progress_begin(0, 100)
        self.tell(context)
        return {"RUNNING_MODAL"}

    def tell(self, context):
        share, what = self.job.progress() or (None, "growing")
        text = "sozai: %s %s%s, %.0f s; Esc cancels" % (
            self.wanted.preset or self.wanted.kind, what,
            "" if share is None else " %.0f %%" % (100 * share), time.monotonic() - self.began)
        context.workspace.status_text_set(text)
        if share is not None:
            context.window_manager.progress_update(100 * share)

    def modal(self, context, event):
        if event.type == "ESC":
            self.cancel(context)
            self.report({"WARNING"}, "cancelled: nothing was changed")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if not self.job.finished():
            self.tell(context)
            return {"PASS_THROUGH"}
        self.quiet(context)
        return self.end(context)

    def quiet(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def cancel(self, context):
        """By Esc, or by Blender when it ends or opens another file."""
        self.quiet(context)
        self.job.close()


class SOZAI_OT_grow_fiber(Growing, bpy.types.Operator):
    """Fill the active mesh with crimped strands: cotton, wool, felt, dust"""

    bl_idname = "sozai.grow_fiber"
    bl_label = "Fill with strands"
    preset: StringProperty(name="Preset", description="Empty: none")
    params: StringProperty(name="Parameters", description="NAME=VALUE, blanks between")
    form: EnumProperty(name="As", items=FORMS)
    level: IntProperty(name="Level of detail", min=0, max=8, default=requests.LEVEL["fiber"])

    def request(self, context):
        body = context.object
        return requests.new("fiber", self.preset, self.params, level=self.level, form=self.form,
                            hull=body.name if body else "")


class SOZAI_OT_grow_tree(Growing, bpy.types.Operator):
    """Grow a tree at the 3D cursor"""

    bl_idname = "sozai.grow_tree"
    bl_label = "Grow a tree"
    preset: StringProperty(name="Species", default="sugi", description="Empty: none")
    age: FloatProperty(name="Age (years)", default=0.0, min=0.0, description="0: the species' own")
    params: StringProperty(name="Parameters", description="NAME=VALUE, blanks between")
    field: StringProperty(name="Field table", subtype="FILE_PATH")
    level: IntProperty(name="Level of detail", min=0, max=8, default=requests.LEVEL["tree"])

    def request(self, _context):
        params = self.params + (" age=%.9g" % self.age if self.age else "")
        return requests.new("tree", self.preset, params, level=self.level, field=self.field)


class OfGrown:
    """Acts on the active object, which was grown."""

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if not settings.is_grown(context.object):
            cls.poll_message_set("select strands or a tree that sozai grew")
            return False
        return True


class SOZAI_OT_grow_update(OfGrown, Growing, bpy.types.Operator):
    """Grow the object again with its settings as they are now; place and materials stay"""

    bl_idname = "sozai.grow_update"
    bl_label = "Update"

    def request(self, context):
        return requests.of_object(context.object)


class SOZAI_OT_grow_set(OfGrown, Growing, bpy.types.Operator):
    """Set a parameter from text, as on sozai's command line; refused out of its range"""

    bl_idname = "sozai.grow_set"
    bl_label = "Set parameter"
    parameter: StringProperty(name="Parameter")
    value: StringProperty(name="Value")

    def execute(self, context):
        obj = context.object
        kind = obj.sozai_grown.kind
        try:
            name, value = requests.read(requests.described_as(kind),
                                        "%s=%s" % (self.parameter, self.value))
        except Problem as problem:
            return self.refuse(problem)
        setattr(getattr(obj, settings.attribute(kind)), "p_" + name, value)
        return {"FINISHED"}

    def invoke(self, context, _event):
        return self.execute(context)


_items = {}  # Blender wants the strings kept


def forget_items():
    _items.clear()


class SOZAI_OT_grow_preset(OfGrown, Growing, bpy.types.Operator):
    """Search the presets by name"""

    bl_idname = "sozai.grow_preset"
    bl_label = "Preset"
    bl_property = "preset"

    def items(self, context):
        obj = context.object if context else None
        if not settings.is_grown(obj):
            return []
        kind = obj.sozai_grown.kind
        if kind not in _items:
            _items[kind] = [(p["id"], p["label"], p["doc"]) for p in state.grown[kind]["presets"]]
        return _items[kind]

    preset: EnumProperty(name="Preset", items=items)

    def execute(self, context):
        obj = context.object
        getattr(obj, settings.attribute(obj.sozai_grown.kind)).preset = \
            self.preset or parameters.NONE
        return {"FINISHED"}

    def invoke(self, context, _event):
        context.window_manager.invoke_search_popup(self)
        return {"FINISHED"}


classes = (SOZAI_OT_grow_fiber, SOZAI_OT_grow_tree, SOZAI_OT_grow_update, SOZAI_OT_grow_set,
           SOZAI_OT_grow_preset)
