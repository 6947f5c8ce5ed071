"""What a gripper does while no motion moves it: it stays, or it goes on pressing."""

from __future__ import annotations

import math

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from robots.control.grip.hand_joints import HandJoints
from robots.control.grip.joint_tracker import JointTracker
from robots.control.grip.steady_motors import SteadyMotors
from robots.interface.gripper_reading import GripperReading, read_gripper
from robots.interface.hardware import RobotData
from robots.interface.robot import RobotState

_POSITION_TIME_S = 0.03
"""The fingers' position is averaged over this before the grip follows it."""
_EFFORT_TIME_S = 0.02
"""Efforts are averaged over this for a reading."""


class GripKeeper:
    """Keeps one gripper's setpoint between motions, and averages what its sensors say.

    Pressing is a force law made of positions: the servo's effort is its stiffness times the gap
    between setpoint and fingers, so the setpoint is kept ``effort / stiffness`` further closed than
    the fingers are. When the fingers give way (the object was taken, or slips) it follows them, and
    so an emptied gripper closes. The motors of a hand that has several press with what they may give:
    there the setpoint goes on to the end, and then each motor's own comes back to its finger.

    Attributes:
        joint: Name of the driven joint; of several, of the first one that moves.
        joints: All of them, among the robot's.
        pressing: Whether it presses; else it stays where it is.
    """

    def __init__(self, data: RobotData, hand: Hand, start_rad: float, period_s: float) -> None:
        """Hold a gripper where it is.

        Args:
            data: The robot's data.
            hand: Which gripper.
            start_rad: Where its setpoint is now.
            period_s: The control period.
        """
        description, grip = data.description, data.hardware.grips[hand]
        gripper = description.grippers[hand]
        self.joint = gripper.joint
        self.joints = HandJoints(description, hand)
        limits = self.joints.limits
        self.pressing = False
        self._gripper, self._grip = gripper, grip
        self._inwards = math.copysign(1.0, gripper.closed_rad - gripper.open_rad)
        stiffness = data.hardware.gains[gripper.joint].stiffness
        self._squeeze_rad = grip.effort_nm / stiffness if self.joints.single else math.inf
        speed = min(grip.closing_speed_rad_s, limits.velocity)
        self._make_tracker = (speed, limits.acceleration, period_s, limits.jerk)
        self._period_s = period_s
        self._tracker = JointTracker(start_rad, *self._make_tracker)
        self._committed = (start_rad, 0.0, 0.0)
        self._load_code()
        self._position_share = min(1.0, period_s / _POSITION_TIME_S)
        self._effort_share = min(1.0, period_s / _EFFORT_TIME_S)
        self._fingers_rad = start_rad
        self._effort_nm = 0.0
        self._motors = SteadyMotors(data, self.joints, period_s)
        self._motors_rad = self.joints_at

    def _load_code(self) -> None:
        """Let compiled code be loaded before the first closing: a control period has no time for it."""
        loading = self.tracker()
        for _ in range(2):
            loading.step_towards(self._gripper.closed_rad)
            loading.step_to_rest()

    @property
    def setpoint(self) -> tuple[float, float]:
        """Position of the gripper, rad, and velocity, rad/s, that are commanded now."""
        return self._tracker.q_rad, self._tracker.v_rad_s

    @property
    def joints_at(self) -> Array:
        """Positions of the driven joints that are commanded now, shape (m,)."""
        return self.joints.setpoint(*self.setpoint)[0]

    @property
    def moving(self) -> bool:
        """Whether a setpoint of its joints is on its way."""
        return self._tracker.v_rad_s != 0.0 or self._motors.moving

    @property
    def shifted(self) -> bool:
        """Whether a motor of several is elsewhere than the gripper's position has it."""
        return self._motors.shifted

    def write(self, q: Array, v: Array) -> None:
        """Put the setpoint where it belongs among those of the actuated joints, shape (n,)."""
        self.joints.write(*self.setpoint, q, v)
        if self._motors.shifted:
            q[self.joints.indices] += self._motors.shift
            v[self.joints.indices] += self._motors.speed

    def sense(self, state: RobotState) -> None:
        """Take the newest readings in; once a control period."""
        measured = self.joints.position(state.q)
        self._fingers_rad += self._position_share * (measured - self._fingers_rad)
        self._effort_nm += self._effort_share * (self.joints.effort(state.effort) - self._effort_nm)
        if not self.joints.single:
            self._motors_rad += self._position_share * (state.q[self.joints.indices] - self._motors_rad)

    def tracker(self) -> JointTracker:
        """Return a fresh tracker that goes on from the present setpoint, for a motion to steer by."""
        tracker = JointTracker(self._tracker.q_rad, *self._make_tracker)
        tracker.v_rad_s, tracker.a_rad_s2 = self._tracker.v_rad_s, self._tracker.a_rad_s2
        return tracker

    def propose(self) -> tuple[float, float]:
        """Advance one period; ``commit`` makes it so, ``revert`` takes it back."""
        self._propose_motors()
        if self.pressing:
            wanted = self._fingers_rad + self._inwards * self._squeeze_rad
            most = self._gripper.closed_rad
            target = max(wanted, most) if self._inwards < 0.0 else min(wanted, most)
            near = self._grip.met_rad if self._tracker.moving else self._grip.deadband_rad
            if abs(target - self._tracker.rest_rad) > near:
                self._tracker.step_towards(target)
                return self.setpoint
        self._tracker.step_to_rest()
        return self.setpoint

    def follow(self, q_rad: float, v_rad_s: float) -> None:
        """Propose what a motion commands on the first joint that moves."""
        self._propose_motors()
        at, speed = self.joints.stroke(q_rad, v_rad_s)
        self._tracker.q_rad, self._tracker.v_rad_s = at, speed
        self._tracker.a_rad_s2 = (speed - self._committed[1]) / self._period_s

    def commit(self) -> None:
        """What was proposed is what the robot follows now."""
        self._committed = (*self.setpoint, self._tracker.a_rad_s2)
        self._motors.commit()

    def revert(self) -> None:
        """Go back to what the robot follows: the rest was refused."""
        self._tracker.q_rad, self._tracker.v_rad_s, self._tracker.a_rad_s2 = self._committed
        self._motors.revert()

    def halt(self) -> None:
        """Rest where the robot was told to stay: at the last position that it follows."""
        self._tracker.q_rad, self._tracker.v_rad_s, self._tracker.a_rad_s2 = self._committed[0], 0.0, 0.0
        self._motors.halt()
        self.commit()

    def reading(self) -> GripperReading:
        """What the gripper's sensors say now, efforts averaged over some control periods."""
        return read_gripper(self._gripper, self._grip, self._fingers_rad, self._effort_nm)

    def _propose_motors(self) -> None:
        """Those of several come back to their fingers once all of them press."""
        short_rad = abs(self._tracker.q_rad - self._gripper.closed_rad)
        presses = self.pressing and not self._tracker.moving and short_rad <= self._grip.deadband_rad
        if presses and not self.joints.single:
            self._motors.come_to(self._motors_rad, self.joints_at)
        else:
            self._motors.go_back()
