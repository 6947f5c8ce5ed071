"""See the knob or button that is meant."""

from __future__ import annotations

from py_trees.common import Status

from robots.scenes.furniture_names import BUTTON, KNOB
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.report_words import listed
from trees.failures import Failure, OpenChoice
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.controls.control_target import (
    IS_OFF_RAD,
    IS_ON_RAD,
    ControlTarget,
    controls_in,
    meant_controls,
)
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import LookLeaf, View
from trees.tasks import ObjectDescription, PressTask, TurnKnobTask


class DetectControl(LookLeaf):
    """See the knob or button that the task names, and remember it in the world model.

    That one look does not show it is an answer, not a failure: a search looks in several directions.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(control=ControlTarget)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="exactly one knob or button that fits was seen; everything seen is in the world model",
        deadline_s=2.0,
    )

    def judge(self, views: list[View]) -> Status | Failure:
        """Update the world model, then choose."""
        update = folded_look(self.toolbox, views)
        self.measured(frames=len(views), things=len(update.seen), scene_version=update.scene.version)
        task: TurnKnobTask | PressTask = self.get_input("task")
        kind = KNOB if isinstance(task, TurnKnobTask) else BUTTON
        wanted = task.object
        if not isinstance(wanted, ObjectDescription):
            raise TypeError("the object of an earlier task was not filled in")
        found = controls_in(update.seen, kind)
        fitting = meant_controls(wanted, found)
        if not fitting:
            there = f"; I see {listed([f'the {one.called}' for one in found])}" if found else ""
            return Failure.postcondition(f"no {kind} of {with_article(wanted.kind or kind)} seen{there}")
        if len(fitting) > 1:
            choices = tuple(one.name for one in fitting)
            told = listed([f"the {one.called}" for one in fitting])
            return Failure.asking(f"which {kind}? there are {told}", OpenChoice(_words(fitting), choices))
        (control,) = fitting
        self._set_output("control", control)
        self.feedback_message = f"{control.called}, turned by {control.turned_rad:.2f} rad"
        return self.chosen(control)

    def chosen(self, _control: ControlTarget) -> Status | Failure:
        """What is said of the one that is meant."""
        return DONE


def _words(fitting: list[ControlTarget]) -> tuple[str, ...]:
    """What tells them from each other: what they are called, else the side."""
    called = tuple(one.called for one in fitting)
    if len(set(called)) == len(called):
        return called
    sides = ("left", *(["middle"] * (len(fitting) - 2)), "right")
    return tuple(f"{side} {one.kind}" for side, one in zip(sides, fitting, strict=True))


class VerifyKnob(DetectControl):
    """See that the knob is turned as it was to be."""

    OUTPUT_PORTS = ports(control=ControlTarget, evidence=dict)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="the knob that is meant is seen to be turned to on, or back to off",
        deadline_s=2.0,
    )

    def chosen(self, control: ControlTarget) -> Status | Failure:
        """Judge the angle that is seen."""
        task: TurnKnobTask = self.get_input("task")
        angle = control.turned_rad
        self.measured(turned_rad=round(angle, 3))
        if angle > IS_OFF_RAD if task.off else angle < IS_ON_RAD:
            state = "off" if task.off else "on"
            return Failure.postcondition(f"the {control.called} is not seen {state}", turned_rad=angle)
        self._set_output("evidence", {"turned_rad": round(angle, 3)})
        return DONE
