"""Opening and closing one gripper."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from robots.control.grip.grip_keeper import GripKeeper
from robots.control.grip.joint_tracker import JointTracker
from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.motion_handle import MotionHandle
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.interface.gripper_reading import GripperReading
from robots.interface.hardware import RobotData
from robots.interface.robot import RobotState

_FELT = 0.8
"""Share of the closing effort at which the fingers have met something: the rest comes by itself
once the setpoint stands, and waiting for all of it would wait for the noise."""
_SETTLE_S = 0.6
"""Time beyond the stroke for the effort to build up and for the fingers to settle."""
_COME_BACK_S = 0.5
"""The motors of a hand that has several are back at the hand's position by then, before it opens."""
_OVERSHOOT = 1.25
"""Measured effort may exceed the closing effort by this share: fingers that meet something at
speed are braked by the servo's damping too."""


class GripperControl:
    """One hand's gripper: satisfies ``trees.toolbox.Gripper``."""

    def __init__(self, data: RobotData, hand: Hand, streamer: MotionStreamer) -> None:
        """Command the gripper of ``hand`` through the streamer."""
        self._data, self._hand = data, hand
        self._streamer = streamer
        self._keeper = streamer.keeper(hand)

    def open(self, opening_m: float | None = None) -> MotionHandle:
        """Open fully, or so far; a grip that was pressing lets go."""
        return self._streamer.start(OpenGripper(self._data, self._hand, self._keeper, opening_m))

    def close(self) -> MotionHandle:
        """Close until something resists or the fingers meet, then keep pressing.

        The handle is done when the grip stands; the pressing goes on until the next motion.
        """
        return self._streamer.start(CloseGripper(self._data, self._hand, self._keeper))

    def reading(self) -> GripperReading:
        """What its sensors say now."""
        return self._keeper.reading()


class _GripperMotion:
    """A guarded motion of one gripper, steered by a tracker from where the setpoint is."""

    verb = ""

    def __init__(
        self,
        data: RobotData,
        hand: Hand,
        keeper: GripKeeper,
        effort_nm: float | None = None,
        before_s: float = 0.0,
    ) -> None:
        gripper, grip = data.description.grippers[hand], data.hardware.grips[hand]
        joints = keeper.joints
        stroke_s = abs(gripper.closed_rad - gripper.open_rad) / grip.closing_speed_rad_s
        self.name = f"{self.verb} {gripper.hand} gripper"
        ends = [joints.setpoint(end, 0.0)[0] for end in (gripper.open_rad, gripper.closed_rad)]
        fastest = abs(joints.setpoint(0.0, min(grip.closing_speed_rad_s, joints.limits.velocity))[1])
        limits = np.array([data.description.limits[name].effort for name in joints.names])
        one_effort = limits if effort_nm is None else np.minimum(effort_nm, limits)
        self.bounds = MotionBounds(
            joints=joints.names,
            lower_rad=np.minimum(*ends),
            upper_rad=np.maximum(*ends),
            velocity=fastest,
            effort=one_effort if joints.single else joints.most_effort,
            duration_s=stroke_s + before_s + _SETTLE_S,
        )
        self._gripper = gripper
        self._arrived_rad = grip.arrived_rad
        self._keeper = keeper
        self._joints = joints
        self._tracker: JointTracker | None = None

    def _steer(self, target_rad: float) -> tuple[Array, Array]:
        if self._tracker is None:
            self._tracker = self._keeper.tracker()
        self._tracker.step_towards(target_rad)
        return self._joints.setpoint(self._tracker.q_rad, self._tracker.v_rad_s)

    def _stands_at(self, target_rad: float) -> bool:
        tracker = self._tracker
        return tracker is not None and tracker.v_rad_s == 0.0 and abs(tracker.q_rad - target_rad) < 1e-6


class OpenGripper(_GripperMotion):
    """Open one gripper, fully where no width is said."""

    verb = "open"

    def __init__(
        self, data: RobotData, hand: Hand, keeper: GripKeeper, opening_m: float | None = None
    ) -> None:
        """Prepare to open."""
        before_s = 0.0 if keeper.joints.single else _COME_BACK_S
        super().__init__(data, hand, keeper, before_s=before_s)
        gripper = self._gripper
        self._target_rad = gripper.open_rad if opening_m is None else gripper.position_at(opening_m)

    def sample(self, elapsed_s: float, state: RobotState) -> tuple[Array, Array] | None:
        """Next setpoint, or None once the fingers are open."""
        self._keeper.pressing = False
        if self._keeper.shifted:
            return self._joints.setpoint(*self._keeper.setpoint)
        target = self._target_rad
        arrived = abs(self._joints.position(state.q) - target) < self._arrived_rad
        if elapsed_s > 0.0 and arrived and self._stands_at(target):
            return None
        return self._steer(target)


class CloseGripper(_GripperMotion):
    """Close one gripper until something resists."""

    verb = "close"

    def __init__(self, data: RobotData, hand: Hand, keeper: GripKeeper) -> None:
        """Prepare to close."""
        self._effort_nm = data.hardware.grips[hand].effort_nm
        super().__init__(data, hand, keeper, _OVERSHOOT * self._effort_nm)

    def sample(self, elapsed_s: float, state: RobotState) -> tuple[Array, Array] | None:
        """Next setpoint, or None once the grip stands, empty or not."""
        target = self._gripper.closed_rad
        reading = self._keeper.reading()
        stands = self._stands_at(target)
        felt = (self._joints.single or stands) and reading.effort_nm >= _FELT * self._effort_nm
        # A thin thing meets the pads so late that the closed position never builds up the effort.
        closed = stands and elapsed_s >= self.bounds.duration_s - 0.5 * _SETTLE_S
        arrived = stands and abs(self._joints.position(state.q) - target) < self._arrived_rad
        if felt or closed or arrived:
            self._keeper.pressing = True
            return None
        return self._steer(target)
