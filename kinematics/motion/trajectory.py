"""Path (geometry), trajectory (with time) and checked trajectory (proven).

Configurations ``q`` have shape (nq,), free-flyer first (x, y, z, quaternion x, y, z, w), then the
body joints; velocities ``v`` have shape (nv,), free-flyer twist first (in the base's own frame),
in Pinocchio's order. The frame is the robot's odometry frame, z up, floor at z = 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.errors import InvalidArrayError, InvalidMotionError
from kinematics.model.stance import Stance


@dataclass(frozen=True, slots=True)
class HeldLoad:
    """A mass that a frame of the robot carries.

    A load is a point: the inertia of an object no larger than a hand about its own centre is a hundredth of
    that about the shoulder.

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
