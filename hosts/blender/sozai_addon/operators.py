# SPDX-License-Identifier: Apache-2.0
"""What the panel's buttons do. All may be called from scripts, bpy.ops.sozai.*"""
import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty

from . import bake, panel, parameters, program, state, update
from .grown import operators as grown_operators, panel as grown_panel


class Job:
    """Reports a Problem as one line and undoes nothing that was not begun."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not state.has(state.described, cls):
            return False
        if cls.material(context) is None:
            cls.poll_message_set("select an object with a material of sozai's")
            return False
        return True

    @staticmethod
    def material(context):
        material = getattr(context, "material", None)
        if material is None and context.object is not None:
            material = context.object.active_material
        return material

    def execute(self, context):
        try:
            remark = self.work(self.material(context), context)
        except (program.Problem, OSError) as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        if remark:
            self.report({"WARNING"}, remark)
        return {"FINISHED"}


class SOZAI_OT_update(Job, bpy.types.Operator):
    """Write the material's files, load its pictures and set up its nodes"""

    bl_idname = "sozai.update"
    bl_label = "Update"

    def work(self, material, context):
        return update.update(material, context.scene)


def make_material(obj, kind, preset, mode, scene, values=None, name=""):
    """A new material in the object's active slot, or a Problem and nothing. values: parameters
    by id, over the preset's."""
    described = state.described.get(kind)
    if described is None:
        raise program.Problem("no material '%s'; there is %s" % (kind, ", ".join(state.described)))
    if preset and preset not in [p["id"] for p in described["presets"]]:
        raise program.Problem("%s has no preset '%s'" % (kind, preset))
    material = bpy.data.materials.new(name or preset or kind)
    before = obj.active_material
    obj.active_material = material
    try:
        material.sozai.kind, material.sozai.mode = kind, mode
        group = state.of(material)[1]
        if preset:
            group.preset = preset
        if kind == "wood":  # boards, not logs
            group.p_cut = "flat"
        for key, value in (values or {}).items():
            setattr(group, "p_" + key, value)
        return update.update(material, scene)
    except (program.Problem, OSError, TypeError) as problem:
        obj.active_material = before
        bpy.data.materials.remove(material)
        raise program.Problem(str(problem)) from problem


class SOZAI_OT_new(Job, bpy.types.Operator):
    """A new material of sozai's on the active object, in its active slot"""

    bl_idname = "sozai.new"
    bl_label = "New sozai material"
    kind: StringProperty(name="Material", default="wood")
    preset: StringProperty(name="Preset", description="Empty: none")
    mode: StringProperty(name="Mode", default="OBJECT")

    @classmethod
    def poll(cls, context):
        if not state.has(state.described, cls):
            return False
        if context.object is None or context.object.type != "MESH":
            cls.poll_message_set("select a mesh")
            return False
        return True

    @staticmethod
    def material(context):
        return context.object

    def work(self, obj, context):
        return make_material(obj, self.kind, self.preset, self.mode, context.scene)


class SOZAI_OT_preset(Job, bpy.types.Operator):
    """Search the presets by name"""

    bl_idname = "sozai.preset"
    bl_label = "Preset"
    bl_property = "preset"

    def items(self, context):
        material = Job.material(context)
        if material is None or not state.described:
            return []
        # Blender wants the strings kept
        return _kept_items(material.sozai.kind)

    preset: EnumProperty(name="Preset", items=items)

    def invoke(self, context, _event):
        context.window_manager.invoke_search_popup(self)
        return {"FINISHED"}

    def work(self, material, context):
        state.of(material)[1].preset = self.preset


_items = {}


def _kept_items(kind):
    if kind not in _items:
        _items[kind] = [(p["id"], p["label"], p["doc"]) for p in state.described[kind]["presets"]]
    return _items[kind]


class SOZAI_OT_set(Job, bpy.types.Operator):
    """Set a parameter from text, as on sozai's command line; refused out of its range"""

    bl_idname = "sozai.set"
    bl_label = "Set parameter"
    parameter: StringProperty(name="Parameter")
    value: StringProperty(name="Value")

    def work(self, material, context):
        described, group = state.of(material)
        found = next((p for p in described["parameters"] if p["id"] == self.parameter), None)
        if found is None:
            raise program.Problem("%s has no parameter '%s'" % (described["id"], self.parameter))
        setattr(group, parameters.attribute(found), parameters.read(found, self.value))


class SOZAI_OT_bake(Job, bpy.types.Operator):
    """Write the pictures as images, for hosts and viewports that have no reader of .sozai files"""

    bl_idname = "sozai.bake"
    bl_label = "Bake to images"
    format: EnumProperty(name="Format", items=(("exr", "OpenEXR", "Half floats, as they are"),
                                               ("png", "PNG", "Of 16 bits; colours in sRGB")))
    pixels: IntProperty(name="Pixels", default=0, min=0, max=65536,
                        description="Of the longer side; 0: as the material has it")
    use: BoolProperty(name="Use them here", default=False,
                      description="Let this material's nodes show the images")

    def work(self, material, context):
        self.report({"INFO"}, bake.bake(material, context.scene, self.format, self.pixels, self.use))


class SOZAI_OT_connect(bpy.types.Operator):
    """Look for sozai again, after its place was named"""

    bl_idname = "sozai.connect"
    bl_label = "Look for sozai"

    def execute(self, _context):
        try:
            panel.unregister()
            grown_panel.unregister()
            _items.clear()
            grown_operators.forget_items()
            state.connect()
        except program.Problem as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        finally:
            panel.register()
            grown_panel.register()
        if state.trouble:
            self.report({"WARNING"}, state.trouble)
        return {"FINISHED"}


class SOZAI_Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    program: StringProperty(
        name="sozai", subtype="FILE_PATH",
        description="The program; empty: $SOZAI, the build tree around the add-on, PATH")
    reader: StringProperty(
        name="Reader's folder", subtype="DIR_PATH",
        description="Where %s is; empty: beside the program, or $%s"
                    % (program.READER, program.SEARCHED))

    def draw(self, _context):
        column = self.layout.column()
        column.prop(self, "program")
        column.prop(self, "reader")
        column.operator("sozai.connect")
        if state.trouble:
            column.label(text=state.trouble, icon="ERROR")
        elif state.program_path:
            column.label(text="%s: %s" % (state.program_path, ", ".join(state.described)),
                         icon="CHECKMARK")


classes = (SOZAI_Preferences, SOZAI_OT_update, SOZAI_OT_new, SOZAI_OT_preset, SOZAI_OT_set,
           SOZAI_OT_bake, SOZAI_OT_connect)
