"""Path (geometry), trajectory (with time) and checked trajectory (proven).

Configurations ``q`` have shape (nq,), free-flyer first (x, y, z, quaternion x, y, z, w), then the
body joints; velocities ``v`` have shape (nv,), free-flyer twist first (in the base's own frame),
in Pinocchio's order. The frame is the robot's odometry frame, z up, floor at z = 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed, sealed
from kinematics.errors import InvalidArrayError, InvalidMotionError
from kinematics.poses import Transform

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Stance(Sealed):
    """The soles that carry and where they stand: sole frame name to ``world_T_sole``.

    Raises:
        InvalidArrayError: A pose is no array of real numbers.
    """

    soles: tuple[tuple[str, Transform], ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "soles", tuple((frame, sealed(pose, frame)) for frame, pose in self.soles))

    @property
    def key(self) -> tuple[tuple[str, bytes], ...]:
        """The same for stances that are equal to the bit, for tables of what was computed once."""
        return tuple((frame, pose.tobytes()) for frame, pose in self.soles)

    @property
    def height_m(self) -> float:
        """Height of the plane that the soles stand on, where the ZMP is: their mean; 0 without soles."""
        return sum(float(pose[2, 3]) for _, pose in self.soles) / max(len(self.soles), 1)


@dataclass(frozen=True, slots=True)
class HeldLoad:
    """A mass that a frame of the robot carries.

    The own inertia of an object no larger than a hand is a hundredth of what its distance from the
    shoulder makes of its mass, so a load is a point.

    Attributes:
        frame: Model frame that carries it.
        mass_kg: How heavy it is.
        point_m: Where its centre of mass is in that frame.
    """

    frame: str
    mass_kg: float
    point_m: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Path(Sealed):
    """Waypoints without time; ``q`` has shape (n, nq)."""

    joints: tuple[str, ...]
    stance: Stance
    q: Array


@dataclass(frozen=True, slots=True)
class Trajectory(Sealed):
    """A motion in time, which nobody can change: what it is made of is copied.

    Between two samples a joint moves as the cubic Hermite polynomial of their positions and
    velocities; the base likewise (its orientation by the normalised blend of quaternions).

    Attributes:
        joints: Names of the body joints, the order of ``q[7:]`` and ``v[6:]``.
        stance: Where the feet stand during the whole motion.
        t_s: Times, shape (n,), rising from 0; real numbers of any type, kept as float64, as all three.
        q: Configurations, shape (n, nq).
        v: Velocities, shape (n, nv).

    Raises:
        InvalidMotionError: Shapes disagree, times do not rise, a value is not finite or no real number.
    """

    joints: tuple[str, ...]
    stance: Stance
    t_s: Array
    q: Array
    v: Array

    def __post_init__(self) -> None:
        try:
            Sealed.__post_init__(self)
        except InvalidArrayError as error:
            raise InvalidMotionError(f"of a trajectory, {error}") from error
        if self.t_s.ndim != 1:
            raise InvalidMotionError(f"times need one dimension, got shape {self.t_s.shape}")
        n, k = len(self.t_s), len(self.joints)
        if self.q.shape != (n, k + 7) or self.v.shape != (n, k + 6):
            raise InvalidMotionError(
                f"{k} joints and {n} samples need q {(n, k + 7)} and v {(n, k + 6)}, "
                f"got {self.q.shape} and {self.v.shape}"
            )
        if n < 2 or self.t_s[0] != 0.0 or not np.all(np.diff(self.t_s) > 0.0):
            raise InvalidMotionError("times must rise from 0 over at least two samples")
        if not (np.isfinite(self.q).all() and np.isfinite(self.v).all() and np.isfinite(self.t_s).all()):
            raise InvalidMotionError("a trajectory must be finite everywhere")

    @property
    def duration_s(self) -> float:
        """Time of the last sample."""
        return float(self.t_s[-1])


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
    """

    kind: FindingKind
    t_s: float
    subject: tuple[str, ...]
    value: float
    limit: float

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
