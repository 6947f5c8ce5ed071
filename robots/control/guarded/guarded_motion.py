"""Motions that are made as they go, inside declared bounds.

A guarded motion is not known beforehand, so it cannot be checked beforehand: it declares which
joints it moves and within what bounds, and the online checker judges each of its setpoints. What moves
more than head and fingers has to be a ``BodyMotion``, so that collisions and balance can be judged too.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

from kinematics.arrays import Array, Sealed
from kinematics.motion.sampler import MotionSample
from kinematics.scene.planning_scene import PlanningScene
from robots.interface.robot import RobotState


@dataclass(frozen=True, slots=True)
class MotionBounds(Sealed):
    """What a guarded motion promises to keep to; arrays have one entry for each of ``joints``.

    Attributes:
        joints: Actuated joints that it moves, and no others.
        lower_rad, upper_rad: Range of the setpoints.
        velocity: Largest speed of the setpoints, rad/s.
        effort: Largest measured effort, Nm.
        duration_s: It ends by then, or is stopped.
    """

    joints: tuple[str, ...]
    lower_rad: Array
    upper_rad: Array
    velocity: Array
    effort: Array
    duration_s: float


class GuardedMotion(Protocol):
    """A motion that decides each setpoint from what the sensors say."""

    @property
    def name(self) -> str:
        """What it is, for people: "close left gripper"."""
        ...

    @property
    def bounds(self) -> MotionBounds:
        """What it promises to keep to."""
        ...

    def sample(self, elapsed_s: float, state: RobotState) -> tuple[Array, Array] | None:
        """Positions and velocities for ``bounds.joints``, or None when it is done."""
        ...


@runtime_checkable
class BodyMotion(GuardedMotion, Protocol):
    """A guarded motion that says where the base is, and what it must not touch.

    The online checker judges ``body`` after each ``sample`` against ``scene``.
    """

    @property
    def body(self) -> MotionSample:
        """The last sample with base and accelerations; its joints are those that ``sample`` gave."""
        ...

    @property
    def in_contact(self) -> bool:
        """Whether a hand holds, or meets, something that may not move."""
        ...

    @property
    def scene(self) -> PlanningScene:
        """What is around now, and which pairs may touch."""
        ...
