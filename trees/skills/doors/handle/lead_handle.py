"""Lead a held handle along its way."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from kinematics.following.opening_motion import scene_at
from kinematics.scene.opening_measure import moved_by
from robots.control.hands.yield_order import YieldOrder
from robots.control.motion_handle import MotionHandle
from trees.beliefs.openings.handles import INSIDE_KINDS, SHUT, goes_with
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import ports
from trees.nodes.yielding_leaf import YieldingLeaf
from trees.skills.doors.handle.held_handle import HeldHandle, bar_m, scene_of_hand

_MOST_S = 40.0
_SLIPPED_AT_N, _SLIPPED_SHARE = 38.0, 0.4
"""A hand that loses its hold of what was shut at such a pull, with so little of the way made, slipped off it.

Off locked drawers it went on for 5.3 to 8.2 cm of 30 until the fingers read empty. What was seen shut before
the pull and is seen shut before the next has not moved: two such slips say that it is stuck.
"""


class LeadHandle(YieldingLeaf):
    """Open or close a door or drawer by leading the held handle along its path, with the whole body.

    The hand pulls along the path, gives way across it, and notices when the handle is stuck. How far it came
    is measured by the way of the hand: for a door, the angle about the centre of the circle that the hand has
    described.
    """

    INPUT_PORTS = ports(held=HeldHandle, lead_to=float)
    OUTPUT_PORTS = ports(opening=float, opened=dict)
    CONTRACT = Contract(
        precondition="the hand was measured to hold the handle",
        postcondition="the handle was led to where it should be, with the hand still about it; the world "
        "model knows the door or drawer there",
        deadline_s=_MOST_S,
        moves="body",
        on_success="the hand holds the handle at the end of its way",
        on_failure="the hand holds where it came to; from something stuck it has gone back to the start",
        on_cancel="hand and arm hold where they are, the handle in the hand; the next task lets go of it",
    )

    _told = False

    def begin(self) -> None:
        """Forget an earlier run."""
        super().begin()
        self._told = False

    def start(self) -> MotionHandle | Failure:
        """Begin to lead."""
        held: HeldHandle = self.get_input("held")
        target, toolbox = held.target, self.toolbox
        self._points: list[NDArray[np.float64]] = []
        lead_to: float = self.get_input("lead_to")
        closing = lead_to < target.opening
        return self.lead(
            YieldOrder(
                held.grasp.hand,
                scene_of_hand(toolbox, target, held.grasp),
                (target.part, target.handle),
                held.path,
                target.opening,
                lead_to,
                bias=held.bias,
                stop_from=_STOP_FROM[target.kind] if closing else None,
                holding=not target.pushed,
            )
        )

    def step(self) -> Status | Failure:
        """Follow the motion, and remember where the hand has been."""
        outcome = super().step()
        held: HeldHandle = self.get_input("held")
        if outcome is RUNNING:
            self._points.append(bar_m(self.toolbox, held.grasp, self.toolbox.sensing.state().q))
        return outcome

    def finish(self) -> Status | Failure:
        """Judge how it ended."""
        held: HeldHandle = self.get_input("held")
        target, report = held.target, self.led.report
        opening = target.opening + moved_by(np.array(self._points), held.path)
        self._tell_world(held, opening)
        shown: dict[str, Any] = {f"opening_{target.unit}": round(target.shown(opening), 4)}
        felt: dict[str, Any] = {
            "peak_force_n": round(report.peak_force_n, 1),
            "peak_pull_n": round(report.peak_pull_n, 1),
        }
        self.measured(**shown, **felt)
        self.feedback_message = f"{target.shown(opening):.2f} {target.unit}, {report.peak_pull_n:.0f} N"
        if report.outcome == "stuck":
            message = f"the {target.part} is stuck"
            return Failure.execution(message, **shown, **felt).because(Reason.STUCK)
        shut, near = SHUT[target.kind], _SLIPPED_SHARE * target.open_to
        slipped = report.peak_pull_n >= _SLIPPED_AT_N and target.opening <= shut and opening < near
        if report.outcome == "lost" and slipped:
            message = f"the {target.part} is stuck: the hand slips off it"
            return Failure.execution(message, **shown, **felt).because(Reason.SLIPPED_OFF_STUCK)
        if report.outcome == "lost":
            return Failure.execution(f"the hand lost the handle of the {target.part}", **shown, **felt)
        self._set_output("opening", opening)
        self._set_output("opened", {**shown, **felt})
        return DONE

    def release(self, reason: str) -> None:
        """Brake and hold; whoever lets go later has to know where the handle is by then."""
        super().release(reason)
        if self._yielding is not None and not self._told:
            self._tell_world(self.get_input("held"), self._yielding.report.s)

    def _tell_world(self, held: HeldHandle, opening: float) -> None:
        """Turn the door in the world model; the handle is where the hand has it."""
        self._told = True
        world, target = self.toolbox.world, held.target
        named = dict.fromkeys((target.part, target.handle))
        inside = [
            name
            for name, item in world.scene.objects.items()
            if kind_of(name) in INSIDE_KINDS and goes_with(item, target)
        ]
        parts = tuple(name for name in (*named, *sorted(inside)) if name in world.scene.objects)
        if not parts or opening == target.opening:
            return
        scene = scene_at(world.scene, parts, target.path, target.opening, opening)
        if target.handle in scene.objects and not target.pushed:
            bar = scene.objects[target.handle]
            pose = bar.world_T_object.copy()
            pose[:2, 3] = bar_m(self.toolbox, held.grasp, self.toolbox.sensing.state().q)[:2]
            scene = scene.with_object(replace(bar, world_T_object=pose))
        world.update(scene)


_STOP_FROM = {kind: 3.0 * shut for kind, shut in SHUT.items()}
"""A closing door or drawer that stops nearer than this to being shut has met its frame."""


def is_stuck(failure: Failure) -> bool:
    """Tell whether what was led did not give way."""
    return failure.reason in (Reason.STUCK, Reason.SLIPPED_OFF_STUCK)


def slips_off(failure: Failure) -> bool:
    """Tell whether it was so because the hand slid off before it could have given way."""
    return failure.reason is Reason.SLIPPED_OFF_STUCK
