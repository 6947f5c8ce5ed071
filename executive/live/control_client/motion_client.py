"""The trees' way to the motors, across the socket."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from executive.live.control_client.control_link import ControlLink
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from robots.control.guarded.guarded_motion import GuardedMotion
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.interface.gripper_reading import GripperReading

_KEPT = 16
"""Admitted trajectories that are remembered; the other side forgets older ones too."""


class MotionClient:
    """Starts and cancels motions of a served robot; satisfies ``trees.toolbox.MotionControl``."""

    def __init__(self, link: ControlLink) -> None:
        """Command through a link."""
        self._link = link
        self._count = 0
        self._admitted: list[tuple[CheckedTrajectory, int]] = []
        self._streamed: tuple[MotionHandle, Trajectory] | None = None

    @property
    def period_s(self) -> float:
        """The control period."""
        return float(self._link.about["period_s"])

    def admitted(self, checked: CheckedTrajectory, number: int) -> None:
        """Know under which number the other side admitted a trajectory."""
        self._admitted = [*self._admitted, (checked, number)][-_KEPT:]

    def start(self, motion: CheckedTrajectory | GuardedMotion) -> MotionHandle:
        """Start what the other side has admitted; anything else is refused."""
        if not isinstance(motion, CheckedTrajectory):
            _, handle = self.new(motion.name)
            return refused(handle, "the control process makes guarded motions itself, and knows no such one")
        count, handle = self.new("trajectory")
        number = next((number for known, number in self._admitted if known is motion), None)
        if number is None:
            return refused(handle, "the control process has not admitted it")
        self._link.start(handle, count, number)
        self._streamed = handle, motion.trajectory
        return handle

    @property
    def planned(self) -> Trajectory | None:
        """The trajectory that is streamed; None while none is."""
        if self._streamed is None or self._streamed[0].finished:
            return None
        return self._streamed[1]

    def start_guarded(self, name: str, hand: Hand, opening_m: float = 0.0) -> MotionHandle:
        """Ask for a guarded motion that the other side makes; 0 opens as far as it goes."""
        count, handle = self.new(f"{name} ({hand})")
        self._link.start_guarded(handle, count, name, hand, opening_m)
        return handle

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Brake a running motion, then hold; a finished one is left alone."""
        if handle.finished:
            return
        self._link.cancel(handle, reason)
        handle.status, handle.reason = MotionStatus.CANCELED, reason

    def reference(self) -> NDArray[np.float64]:
        """Configuration that is commanded now, shape (nq,)."""
        return self._link.report.reference.copy()

    def stance(self) -> Stance:
        """Where the feet stand."""
        return self._link.report.stance

    def new(self, name: str) -> tuple[int, MotionHandle]:
        """Number and handle of a motion that is about to be asked for."""
        self._count += 1
        return self._count, MotionHandle(name, f"remote-{self._count}")


class GripperClient:
    """One gripper of a served robot; satisfies ``trees.toolbox.Gripper``."""

    def __init__(self, link: ControlLink, motion: MotionClient, hand: Hand) -> None:
        """Command the gripper of one hand."""
        self._link, self._motion, self._hand = link, motion, hand

    def open(self, opening_m: float | None = None) -> MotionHandle:
        """Open fully, or so far."""
        return self._motion.start_guarded("open gripper", self._hand, opening_m or 0.0)

    def close(self) -> MotionHandle:
        """Close until something resists, then keep pressing."""
        return self._motion.start_guarded("close gripper", self._hand)

    def reading(self) -> GripperReading:
        """What its sensors said last."""
        return self._link.report.grippers[self._hand]


def refused(handle: MotionHandle, reason: str) -> MotionHandle:
    """A handle of what was not even asked for."""
    handle.status, handle.reason = MotionStatus.REFUSED, reason
    return handle
