"""Take hold of a handle with a hand that gives way to it."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests import Grasp
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.control.yielding_hand import YieldingHand
from trees.contract import Contract
from trees.failures import Failure
from trees.handles import HandleTarget
from trees.held_handle import HeldHandle, scene_of_hand, tcp_m
from trees.leaf import DONE, RUNNING
from trees.motion_leaf import MotionLeaf, motion_failure
from trees.ports import ports

_QUIET_S = 0.25
"""Before the fingers move, the hand feels what counts as no force."""


class GraspHandle(MotionLeaf):
    """Close the gripper on the bar while the arm yields: fingers that meet it off centre move the hand.

    Its own way of settling tells where the bar really is.
    """

    INPUT_PORTS = ports(handle=HandleTarget, grasp=Grasp)
    OUTPUT_PORTS = ports(held=HeldHandle)
    CONTRACT = Contract(
        precondition="the open hand is about the bar",
        postcondition="opening and effort of the gripper say that it holds something",
        deadline_s=8.0,
        moves="body",
        on_success="the gripper presses on the bar",
        on_failure="the gripper keeps its state; the arm holds",
        on_cancel="the gripper keeps its state; the arm holds",
    )

    _fingers: MotionHandle | None = None
    _motion: YieldingHand | None = None

    def begin(self) -> None:
        """Forget an earlier run."""
        super().begin()
        self._fingers = self._motion = None

    def start(self) -> MotionHandle:
        """Let the arm yield."""
        self._motion = self._yielding(self.get_input("grasp"))
        return self.toolbox.motion.start(self._motion)

    def step(self) -> Status | Failure:
        """Yield, close, settle, judge."""
        outcome = super().step()
        if outcome is not RUNNING or self._motion is None:
            return outcome
        if self._fingers is None:
            if self.elapsed_s >= _QUIET_S:
                grasp: Grasp = self.get_input("grasp")
                self._fingers = self.toolbox.grippers[grasp.hand].close()
            return RUNNING
        if (ended := motion_failure(self._fingers)) is not None:
            return ended
        if self._fingers.status is not MotionStatus.RUNNING:
            self._motion.finish()
        return RUNNING

    def release(self, reason: str) -> None:
        """Hold."""
        if self._fingers is not None and not self._fingers.finished:
            self.toolbox.motion.cancel(self._fingers, reason)
        super().release(reason)

    def _yielding(self, grasp: Grasp) -> YieldingHand:
        target: HandleTarget = self.get_input("handle")
        toolbox = self.toolbox
        q = toolbox.motion.reference()
        return YieldingHand(
            toolbox.model,
            toolbox.motion.stance(),
            grasp.hand,
            q,
            scene_of_hand(toolbox, target, grasp),
            (target.part, target.handle),
            target.path.through(tcp_m(toolbox, grasp, q), target.opening),
            target.opening,
            target.opening,
        )

    def finish(self) -> Status | Failure:
        """Judge the grip, and note where the bar really is."""
        grasp: Grasp = self.get_input("grasp")
        target: HandleTarget = self.get_input("handle")
        if self._motion is None:
            raise RuntimeError(f"{self.name} has not begun")
        reading = self.toolbox.grippers[grasp.hand].reading()
        report = self._motion.report
        self.measured(
            opening_m=reading.opening_m,
            effort_nm=reading.effort_nm,
            holding=reading.holding,
            peak_force_n=report.peak_force_n,
        )
        if not reading.holding:
            return Failure.postcondition(
                "the fingers closed beside the handle",
                opening_m=reading.opening_m,
                effort_nm=reading.effort_nm,
            )
        place = tcp_m(self.toolbox, grasp, self.toolbox.motion.reference())
        path = target.path.through(place, target.opening)
        self._set_output("held", HeldHandle(target, grasp, path, report.bias))
        self.feedback_message = f"holding, {reading.opening_m * 1000:.0f} mm, {reading.effort_nm:.1f} Nm"
        return DONE
