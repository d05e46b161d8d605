# SPDX-License-Identifier: Apache-2.0
"""Growing that goes on while Blender does: by timer to its end, by Esc to none."""
import os
import time
from types import SimpleNamespace

import bpy
from addon_test import check
from growing.shared import everything
from sozai_addon.grown import job, operators, request


def ended():
    """A job that is cancelled ends at once, and leaves no file and no process."""
    many = request.new("tree", "sugi", "age=60", level=0)
    before = everything()
    begun = request.begin(many, bpy.context.scene)
    while begun.progress() is None and not begun.finished():
        time.sleep(0.01)
    share = begun.progress()
    check("how far it is", share is not None and 0 <= share[0] <= 1 and share[1], share)
    check("it works in a folder of its own", os.path.isdir(begun.folder))
    check("it is not done yet", not begun.finished())
    begun.close()
    check("ended", begun.process.returncode is not None and begun.process.returncode != 0,
          begun.process.returncode)
    check("nothing is left", everything() == before and begun not in job.running)
    begun = request.begin(many, bpy.context.scene)
    job.close_all()
    check("disabled while it works", begun.finished() and not job.running and
          everything() == before)


class Growing(operators.Growing):
    """As Blender's operators are it, outside of them."""

    def __init__(self, wanted):
        self.wanted_first, self.said = wanted, []

    def request(self, _context):
        return self.wanted_first

    def report(self, kind, text):
        self.said.append((kind, text))


def window(told):
    """What modal operators use of a context, with a note of what they tell."""
    real = bpy.context
    manager = SimpleNamespace(
        event_timer_add=lambda step, window: told.append("timer") or "timer",
        event_timer_remove=lambda timer: told.append("no timer"),
        modal_handler_add=lambda operator: told.append("handler"),
        progress_begin=lambda a, b: told.append("begin"), progress_end=lambda: told.append("end"),
        progress_update=lambda share: told.append(share))
    return SimpleNamespace(
        scene=real.scene, collection=real.collection, view_layer=real.view_layer, object=real.object,
        selected_objects=list(real.selected_objects), window=None, window_manager=manager,
        workspace=SimpleNamespace(status_text_set=told.append))


def modal():
    """By timer to its end; by Esc to none."""
    told, tick = [], SimpleNamespace(type="TIMER")
    growing = Growing(request.new("tree", "sugi", "age=4", level=3))
    context, count = window(told), len(bpy.data.objects)
    check("it runs on", growing.start(context) == {"RUNNING_MODAL"})
    state_now = {"PASS_THROUGH"}
    while state_now == {"PASS_THROUGH"}:
        check("other events pass", growing.modal(context, SimpleNamespace(type="MOUSEMOVE")) ==
              {"PASS_THROUGH"})
        time.sleep(0.02)
        state_now = growing.modal(context, tick)
    check("finished", state_now == {"FINISHED"} and len(bpy.data.objects) == count + 1, state_now)
    check("it says what there is", "faces" in growing.said[0][1], growing.said)
    check("the status bar said so, and is free again", any("Esc cancels" in str(t) for t in told) and
          told[-1] is None and "no timer" in told and "end" in told, told)
    told.clear()
    before = everything()
    growing = Growing(request.new("tree", "sugi", "age=60", level=0))
    growing.start(context)
    growing.modal(context, tick)
    check("ended by Esc", growing.modal(context, SimpleNamespace(type="ESC")) == {"CANCELLED"} and
          growing.job.finished() and everything() == before and told[-1] is None)
    growing = Growing(request.Request("tree", target="no such tree", level=8))
    growing.start(context)
    growing.job.process.wait()
    check("an object that went meanwhile", growing.modal(context, tick) == {"CANCELLED"} and
          "is gone" in growing.said[0][1] and everything() == before, growing.said)
