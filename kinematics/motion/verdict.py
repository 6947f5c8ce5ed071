"""The verdict on a trajectory: checked, or unsafe with its findings; the tolerance that judges share."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

from kinematics.errors import InvalidMotionError
from kinematics.motion.trajectory import HeldLoad, Trajectory

SETPOINT_FRACTION = 1e-4
"""Setpoints may pass limits of speed, acceleration and jerk by this fraction: a brake is judged by
differences along a path that uses its limits fully, and where one was refused for a millionth, a harder one
was left."""


class FindingKind(Enum):
    """What a trajectory can be refused for."""

    POSITION_LIMIT = "position limit"
    VELOCITY_LIMIT = "velocity limit"
    ACCELERATION_LIMIT = "acceleration limit"
    JERK_LIMIT = "jerk limit"
    EFFORT_LIMIT = "effort limit"
    SELF_COLLISION = "self-collision"
    SCENE_COLLISION = "scene collision"
    HELD_OBJECT_COLLISION = "held object collision"
    BALANCE = "balance"
    STANCE = "stance"
    DISCONTINUITY = "discontinuity"
    BOUNDARY_VELOCITY = "boundary velocity"
    CONCESSION = "concession"


@dataclass(frozen=True, slots=True)
class Finding:
    """One defect of a trajectory.

    Attributes:
        kind: What is wrong.
        t_s: When it is first found.
        subject: The joint, or the two names of a colliding pair, or the sole.
        value: The measured quantity (rad, rad/s, m of distance, m of margin, ...).
        limit: What it had to keep to.
        place_m: Where a pair first touches, midway between the nearest points of the two, in the odometry
            frame; None for anything else, and where nobody measured it.
    """

    kind: FindingKind
    t_s: float
    subject: tuple[str, ...]
    value: float
    limit: float
    place_m: tuple[float, float, float] | None = None

    def __str__(self) -> str:
        names = " and ".join(self.subject)
        return f"{self.kind.value} of {names} at {self.t_s:.3f} s: {self.value:.4g}, limit {self.limit:.4g}"


@dataclass(frozen=True, slots=True)
class Unsafe:
    """The checker's refusal; ``findings`` are in order of time, at least one."""

    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        more = f" (and {len(self.findings) - 1} more)" if len(self.findings) > 1 else ""
        return f"Unsafe trajectory: {self.findings[0]}{more}"


class _Seal:
    """Proof that the checker let this very trajectory pass; no other one can be put into its place."""

    __slots__ = ("of",)

    def __init__(self, of: Trajectory) -> None:
        self.of = of


@dataclass(frozen=True, slots=True)
class CheckedTrajectory:
    """A trajectory that the checker proved safe.

    Attributes:
        trajectory: The motion.
        min_distance_m: Smallest distance between pairs that must not touch, as far as it was
            measured (pairs proven far apart are not refined).
        min_com_margin_m: Smallest distance of the CoM to the edge of the support polygon.
        loads: What the hands carry in it: balance and efforts were judged with that.
        unweighed: What they carry besides, whose mass nobody knows yet; a mass of 0 stands for it.
    """

    trajectory: Trajectory
    min_distance_m: float
    min_com_margin_m: float
    seal: _Seal
    loads: tuple[HeldLoad, ...] = ()
    unweighed: tuple[HeldLoad, ...] = ()

    def __post_init__(self) -> None:
        if getattr(self.seal, "of", None) is not self.trajectory:
            raise InvalidMotionError("only the trajectory checker can make a CheckedTrajectory")

    @property
    def margins(self) -> str:
        """What was measured, in words; empty where nothing was."""
        measured = (
            ("nearest measured distance", self.min_distance_m),
            ("CoM margin", self.min_com_margin_m),
        )
        return ", ".join(f"{name} {value_m:.4f} m" for name, value_m in measured if math.isfinite(value_m))

    def __str__(self) -> str:
        return f"Safe trajectory: {self.margins}" if self.margins else "Safe trajectory"
