"""What every body offers to the control loop: read the sensors, take a setpoint.

Arrays are in the order of ``RobotDescription.actuated``: body joints, then gripper joints.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

from kinematics.arrays import Array, InFloat64
from kinematics.model.robot_description import RobotDescription
from robots.interface.hardware import Hardware


@dataclass(frozen=True, slots=True)
class RobotState(InFloat64):
    """The sensors' readings of one control period. Nothing here is the simulator's truth.

    Attributes:
        stamp_s: Time at the end of the period.
        q: Joint positions, rad, shape (n,).
        v: Joint velocities, rad/s, shape (n,).
        effort: Joint efforts averaged over the period, Nm, shape (n,).
        gyro: Angular velocity of the IMU in its own frame, rad/s, shape (3,).
        accelerometer: Specific force in the IMU's frame, m/s^2, shape (3,) (rest: gravity upwards).
        foot_wrench: Force and torque of the ground on each sole in the sole's frame (N, Nm), shape
            (feet, 6), in the order of ``RobotDescription.soles``; shape (0, 6) of a robot that feels none.
        following: Whether the motors follow setpoints with all their stiffness; not while they are damped, or
            are taken up again.
        feet_estimated: Whether no sensor told those, but the efforts of the legs and the IMU.
        battery: Share of the charge that is left, 0 to 1.
        age_s: How old the readings are; 0 where they are of this period.
        temperature_c: Of each motor, shape (n,); None where nobody measures it.
        motor_error: The code that each motor tells, shape (n,), 0 for none; None where they tell nothing.
        alarm: Why the body asks for its emergency stop: a button on it, a wire that fails; empty when it does
            not.

    Raises:
        InvalidArrayError: A reading holds no real numbers; numbers of another type are converted.
    """

    stamp_s: float
    q: Array
    v: Array
    effort: Array
    gyro: Array
    accelerometer: Array
    foot_wrench: Array
    battery: float = 1.0
    age_s: float = 0.0
    temperature_c: Array | None = None
    motor_error: Array | None = None
    alarm: str = ""
    feet_estimated: bool = False
    following: bool = True


@dataclass(frozen=True, slots=True)
class JointSetpoint(InFloat64):
    """What the joints shall do until the next setpoint.

    Attributes:
        stamp_s: When it was made.
        sequence: Rises by one from setpoint to setpoint.
        owner: Opaque id of who holds the joints ("hold", "stop", or a motion's id).
        q: Positions, rad, shape (n,).
        v: Velocities, rad/s, shape (n,).
        tau: Feed-forward efforts, Nm, shape (n,).

    Raises:
        InvalidArrayError: One of them holds no real numbers; numbers of another type are converted.
    """

    stamp_s: float
    sequence: int
    owner: str
    q: Array
    v: Array
    tau: Array


class Robot(Protocol):
    """A robot's body: sensors to read, joints to command.

    Only the control loop holds one, and only the gate calls ``command``.
    """

    @property
    def description(self) -> RobotDescription:
        """Where the robot's parts are."""
        ...

    @property
    def hardware(self) -> Hardware:
        """What it is made of."""
        ...

    def read(self) -> RobotState:
        """Return the readings of the last control period."""
        ...

    def command(self, setpoint: JointSetpoint) -> None:
        """Take a setpoint; it holds until the next one."""
        ...

    def advance(self, period_s: float) -> None:
        """Let one control period pass (lockstep: the physics; live: nothing)."""
        ...


@runtime_checkable
class ResettableRobot(Protocol):
    """A body that keeps something of its own against moving until a person has looked: a lost wire."""

    def reset(self) -> str | None:
        """A person has looked: forget it, or say why not."""
        ...


def reset_body(robot: Robot) -> str | None:
    """Have a body forget what only a person ends; None when nothing of it stands against moving."""
    return robot.reset() if isinstance(robot, ResettableRobot) else None
