"""Press a button by feel."""

from __future__ import annotations

import math

import numpy as np
from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from kinematics.requests.move import RetreatRequest
from kinematics.scene.concessions import ConcessionReason, touching, with_touching
from kinematics.scene.opening_path import DrawerLine
from robots.control.hands.yield_order import YieldOrder
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import optional, ports
from trees.nodes.yielding_leaf import YieldingLeaf
from trees.skills.controls.control_target import ControlTarget

_LEAST_N = 8.0
"""What stops the hand with less is no button that is pressed fully: their springs are weaker."""
_BEFORE_M = 0.012
"""A button that is met so much before where it was seen is something else."""
_BACK_M = 0.08


class PressIn(YieldingLeaf):
    """Move the closed hand straight on until a button gives no more way, and tell what was felt.

    The hand stops where something resists. A spring resists less than what is behind it, so that a button
    that stops the hand is pressed.
    """

    INPUT_PORTS = ports(control=ControlTarget, grasp=Grasp, short_m=float)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the closed hand is before the button, at the end of the checked approach",
        postcondition="the hand was stopped, at the button, by more than a button's spring",
        deadline_s=20.0,
        moves="body",
        on_success="the hand is at the button, and has eased",
    )

    _deepest_m = 0.0

    def start(self) -> MotionHandle | Failure:
        """Go on along the way that the button faces."""
        toolbox = self.toolbox
        control: ControlTarget = self.get_input("control")
        grasp: Grasp = self.get_input("grasp")
        self._deepest_m = 0.0
        self._start = self._tcp_m(toolbox.motion.reference(), grasp)
        ahead = control.inwards * np.array([1.0, 1.0, 0.0])
        self._ahead = ahead / np.linalg.norm(ahead)
        way = self.get_input("short_m") + toolbox.model.description.pushing.button_past_m
        line = DrawerLine(
            self._start + way * self._ahead, math.atan2(float(self._ahead[1]), float(self._ahead[0]))
        )
        links = toolbox.model.description.grippers[grasp.hand].touch_links
        near = [
            name
            for name, item in toolbox.world.scene.objects.items()
            if name == control.name or (not item.movable and _is_beside(item.world_T_object, control))
        ]
        allowed = touching(links, near, ConcessionReason.HANDLE_IN_HAND, "press")
        return self.lead(
            YieldOrder(
                grasp.hand,
                with_touching(toolbox.world.scene, allowed),
                (),
                line,
                way,
                0.0,
                stop_from=way,
                holding=False,
                manner="gentle",
            )
        )

    def step(self) -> Status | Failure:
        """Follow the hand, and remember how far it came."""
        outcome = super().step()
        if outcome is RUNNING:
            here = self._tcp_m(self.toolbox.sensing.state().q, self.get_input("grasp"))
            self._deepest_m = max(self._deepest_m, float((here - self._start) @ self._ahead))
        return outcome

    def finish(self) -> Status | Failure:
        """Judge what stopped the hand, and where."""
        control: ControlTarget = self.get_input("control")
        report = self.led.report
        beyond_m = self._deepest_m - self.get_input("short_m")
        felt = {"beyond_m": round(beyond_m, 4), "peak_push_n": round(report.peak_pull_n, 1)}
        self.measured(**felt)
        self.feedback_message = (
            f"{1000.0 * beyond_m:.0f} mm beyond where it was seen, {report.peak_pull_n:.0f} N"
        )
        if report.peak_pull_n < _LEAST_N:
            return Failure.postcondition(
                f"nothing resisted where the {control.called} was seen", None, **felt
            )
        if beyond_m < -_BEFORE_M:
            return Failure.postcondition(f"the hand met something before the {control.called}", None, **felt)
        self._set_output("evidence", felt)
        return DONE

    def _tcp_m(self, q: np.ndarray, grasp: Grasp) -> np.ndarray:
        frame = self.toolbox.model.description.grippers[grasp.hand].tcp_frame
        return np.asarray(self.toolbox.model.frame_pose(q, frame)[:3, 3])


class DrawBackFrom(PlannedMotionLeaf):
    """Draw the hand straight back from a knob or button."""

    INPUT_PORTS = ports(control=ControlTarget, grasp=optional(Grasp))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="nothing is between the fingers",
        postcondition="the hand is clear of the knob or button, at rest",
        deadline_s=20.0,
        moves="body",
        on_success="the hand is before it",
    )

    def goal(self) -> RetreatRequest | None:
        """Against the way that the hand came; None where none has come."""
        control: ControlTarget = self.get_input("control")
        grasp: Grasp | None = self.optional("grasp")
        if grasp is None:
            return None
        toolbox = self.toolbox
        q = toolbox.motion.reference()
        frame = toolbox.model.description.grippers[grasp.hand].tcp_frame
        here = toolbox.model.frame_pose(q, frame)[:3, 3]
        if np.linalg.norm(here - control.odom_T_control[:3, 3]) > _NEAR_M:
            return None
        x, y, z = (float(value) for value in -_BACK_M * control.inwards)
        links = toolbox.model.description.grippers[grasp.hand].touch_links
        near = [
            name
            for name, item in toolbox.world.scene.objects.items()
            if name == control.name or (not item.movable and _is_beside(item.world_T_object, control))
        ]
        return RetreatRequest(
            q_start=q,
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            hand=grasp.hand,
            world_offset_m=(x, y, z),
            shares=(1.0, 0.6),
            concessions=touching(links, near, ConcessionReason.HANDLE_IN_HAND, "retreat"),
        )


_NEAR_M = 0.25
_BESIDE_M = 0.4


def _is_beside(world_T_object: np.ndarray, control: ControlTarget) -> bool:
    """Whether a solid is what a control is on, or about it."""
    return bool(np.linalg.norm(world_T_object[:3, 3] - control.odom_T_control[:3, 3]) < _BESIDE_M)
