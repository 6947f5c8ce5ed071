"""A robot whose feet have no sensors, with wrenches that are estimated in their place."""

from __future__ import annotations

from dataclasses import replace

from kinematics.estimation.leg_wrench import LegWrench
from kinematics.model.robot_description import RobotDescription
from kinematics.model.robot_model import RobotModel
from robots.interface.hardware import Hardware
from robots.interface.robot import JointSetpoint, Robot, RobotState, reset_body


def with_felt_feet(robot: Robot, model: RobotModel) -> Robot:
    """The same robot, or one that tells what its legs feel where its feet feel nothing."""
    description = model.description
    return robot if description.foot_sensors or description.welded else FeltFeet(robot, model)


class FeltFeet:
    """A ``Robot`` whose readings have estimated foot wrenches; everything else is the robot's own."""

    def __init__(self, robot: Robot, model: RobotModel) -> None:
        """Begin to estimate.

        Args:
            robot: The robot.
            model: Its model.
        """
        self._robot, self._estimate, self._bodies = robot, LegWrench(model), len(model.joints)
        self._reading: tuple[RobotState, RobotState] | None = None

    @property
    def description(self) -> RobotDescription:
        """Where the robot's parts are."""
        return self._robot.description

    @property
    def hardware(self) -> Hardware:
        """What it is made of."""
        return self._robot.hardware

    def read(self) -> RobotState:
        """Return the readings of the last control period, with what the legs feel."""
        own = self._robot.read()
        if self._reading is None or self._reading[0] is not own:
            n = self._bodies
            wrench = self._estimate.update(
                own.stamp_s, own.q[:n], own.v[:n], own.effort[:n], own.gyro, own.accelerometer
            )
            self._reading = own, replace(own, foot_wrench=wrench.copy(), feet_estimated=True)
        return self._reading[1]

    def command(self, setpoint: JointSetpoint) -> None:
        """Take a setpoint; it holds until the next one."""
        self._robot.command(setpoint)

    def advance(self, period_s: float) -> None:
        """Let one control period pass."""
        self._robot.advance(period_s)

    def reset(self) -> str | None:
        """A person has looked at the robot."""
        return reset_body(self._robot)
