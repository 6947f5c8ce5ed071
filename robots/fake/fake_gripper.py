"""A gripper of the fake robot: closes on what stands between its fingers."""

from __future__ import annotations

import numpy as np

from kinematics.model.robot_description import GripperDescription
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.fake.fake_motion import FakeMotion
from robots.fake.scripted_world import PoseOf, ScriptedWorld, diameter_m
from robots.interface.gripper_reading import GripperReading, read_gripper
from robots.interface.hardware import GripSettings


class FakeGripper:
    """A gripper of the fake robot; satisfies ``trees.toolbox.Gripper``.

    Attributes:
        empty: While true, the fingers always miss.
        holding: Name of what it holds, or None.
        speed_rad_s: How fast the fingers move.
        position_rad, effort_nm: What its sensors read; effort negative when it closes.
    """

    def __init__(
        self,
        gripper: GripperDescription,
        grip: GripSettings,
        world: ScriptedWorld,
        motion: FakeMotion,
        pose_of: PoseOf,
    ) -> None:
        """An open hand."""
        self.empty = False
        self.holding: str | None = None
        self.position_rad = gripper.open_rad
        self.effort_nm = 0.0
        self.speed_rad_s = grip.closing_speed_rad_s
        self._gripper, self._grip, self._world, self._motion, self._pose_of = (
            gripper,
            grip,
            world,
            motion,
            pose_of,
        )
        self._handle: MotionHandle | None = None
        self._goal_rad = gripper.open_rad

    def open(self, opening_m: float | None = None) -> MotionHandle:
        """Open fully, or so far; what was held falls."""
        self._handle = self._motion.note(f"open {self._gripper.hand} gripper")
        if not self._handle.finished:
            gripper = self._gripper
            self._goal_rad = gripper.open_rad if opening_m is None else gripper.position_at(opening_m)
            if self.holding is not None and self._world.carried_by(self.holding) is not None:
                self._world.drop(self.holding)
            self.holding, self.effort_nm = None, 0.0
        return self._handle

    def close(self) -> MotionHandle:
        """Close on what is between the fingers."""
        found = self._world.between(self._pose_of(self._gripper.tcp_frame), self._gripper.max_opening_m)
        self._handle = self._motion.note(f"close {self._gripper.hand} gripper")
        if not self._handle.finished:
            self._goal_rad = self._gripper.closed_rad
            if found is not None and not self.empty:
                self.holding = found.name
                self._goal_rad = self._angle_rad(diameter_m(found.shape))
        return self._handle

    def reading(self) -> GripperReading:
        """What its sensors say now."""
        return read_gripper(self._gripper, self._grip, self.position_rad, self.effort_nm)

    def advance(self, period_s: float) -> None:
        """Move the fingers; when what they held is gone, they close."""
        if self.holding is not None and self._lost(self.holding):
            self.holding, self.effort_nm = None, 0.0
            self._goal_rad = self._gripper.closed_rad
        if self._handle is not None and self._handle.status is MotionStatus.CANCELED:
            self._goal_rad, self._handle = self.position_rad, None
        reach_rad = self.speed_rad_s * period_s
        self.position_rad += max(-reach_rad, min(reach_rad, self._goal_rad - self.position_rad))
        if self._handle is not None and not self._handle.finished and self.position_rad == self._goal_rad:
            self._handle.status, self._handle.progress = MotionStatus.DONE, 1.0
            if self.holding is not None:
                self.effort_nm = -self._grip.effort_nm
                self._world.grip(self.holding, self._gripper.hand, self._gripper.tcp_frame)

    def _lost(self, name: str) -> bool:
        """Whether what was gripped is no longer in this hand."""
        return self.effort_nm != 0.0 and self._world.carried_by(name) != self._gripper.hand

    def _angle_rad(self, opening_m: float) -> float:
        angles, openings = zip(*self._gripper.opening_table, strict=True)
        return float(np.interp(opening_m, openings, angles))
