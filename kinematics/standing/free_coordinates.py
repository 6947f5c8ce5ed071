"""The coordinates that a robot is free to move: pelvis pose, trunk, arms and head.

The legs follow from the pelvis, so that every point of this space has both feet where they stand. A
welded base does not move: its robot has its joints alone.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, as_float64
from kinematics.model.robot_build import model_tree
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.leg_ik import LegIk

if TYPE_CHECKING:
    from kinematics.model.tree import Tree
    from kinematics.standing.flat_coordinates import Coordinates


# A metre of the pelvis weighs like so many radians of a joint when lengths of paths are compared.
PELVIS_WEIGHT = 3.0


class FreeCoordinates:
    """Maps between configurations ``q`` and free coordinates ``x``.

    ``x`` has shape (size,): pelvis position (m), pelvis rotation vector (rad), then the joints that
    are in no leg, in the model's order. When the base is welded there are the joints alone.

    Attributes:
        base_size: How many of the coordinates are the pelvis's: the first 6, or 0 when welded.
        joints: Names of the joints that follow them.
        size: All together.
        weights: Of each coordinate in the length of a path, shape (size,).
    """

    def __init__(self, robot: StandingRobot) -> None:
        self._robot, self._model = robot, robot.model
        model = robot.model
        self._legs = robot.derived(LegIk)
        self.joints = model.free_joints
        self._columns = 7 + model.indices(self.joints)
        self._mount = model.q_home[:7] if model.description.welded else None
        self.base_size = 0 if model.description.welded else 6
        self.size = self.base_size + len(self.joints)
        self.weights = np.ones(self.size)
        self.weights[: min(3, self.base_size)] = PELVIS_WEIGHT
        self._asked: bytes | None = None
        self._answer = np.empty((0, 0)), np.empty(0, dtype=bool)

    @cached_property
    def home(self) -> Array:
        """The home posture over these feet, shape (size,)."""
        return self.from_q(self._robot.q_home)

    def index(self, joint: str) -> int:
        """Column of a joint in ``x``."""
        return self.base_size + self.joints.index(joint)

    def from_q(self, q: Array) -> Array:
        """Free coordinates of one configuration.

        Raises:
            InvalidArrayError: It has not the shape (nq,), or holds no real numbers.
        """
        q = as_float64(q, (self._model.nq,), "q")
        if self._mount is not None:
            return np.array(q[self._columns])
        vector, w = q[3:6], q[6]
        if w < 0.0:
            vector, w = -vector, -w
        norm = math.sqrt(vector @ vector)
        turn = 2.0 * vector if norm < 1e-12 else vector * (2.0 * math.atan2(norm, w) / norm)
        return np.concatenate([q[:3], turn, q[self._columns]])

    def start(self, q: Array) -> Array:
        """Free coordinates in which a plan can begin for a robot that rests at a configuration.

        Plans keep away from the joint limits by a margin; a motion that was stopped, or led by what the hand
        felt, may have ended inside of it. Such joints begin where the margin ends, and ``lead_in`` takes them
        there.
        """
        x = self.from_q(q)
        margin, limited = self._model.description.planning_margin_rad, self._columns - 7
        lower, upper = self._model.lower_rad[limited] + margin, self._model.upper_rad[limited] - margin
        x[self.base_size :] = np.clip(x[self.base_size :], lower, upper)
        return x

    def from_many(self, q: Array) -> Array:
        """``from_q`` of many configurations, shape (n, nq), at once, shape (n, size); raises alike."""
        q = as_float64(q, (None, self._model.nq), "q")
        if self._mount is not None:
            return q[:, self._columns]
        # a quaternion and its negative are one rotation
        turn = np.where(q[:, 6:7] < 0.0, -q[:, 3:7], q[:, 3:7])
        norm = np.sqrt(np.sum(turn[:, :3] ** 2, axis=1))
        tiny = norm < 1e-12
        scale = np.where(tiny, 2.0, 2.0 * np.arctan2(norm, turn[:, 3]) / np.where(tiny, 1.0, norm))
        return np.hstack([q[:, :3], turn[:, :3] * scale[:, None], q[:, self._columns]])

    def to_q(self, x: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Configurations of many points.

        Args:
            x: Shape (n, size).

        Returns:
            Configurations, shape (n, nq), and whether both feet can be reached, shape (n,).

        Raises:
            InvalidArrayError: They have another shape, or are no real numbers.
        """
        x = as_float64(x, (None, self.size), "x")
        q = np.zeros((len(x), self._model.nq))
        if self._mount is not None:
            q[:, :7], q[:, self._columns] = self._mount, x
            return q, np.ones(len(x), dtype=bool)
        if self._legs.closed:
            # imported here: it brings the compiler
            from kinematics.standing.posture import configurations

            reached = np.empty(len(x), dtype=bool)
            configurations(*self._flattened, x, q, reached)
            return q, reached
        asked = x.tobytes() if len(x) == 1 else None
        if asked is not None and asked == self._asked:  # who judges a setpoint asks twice
            return self._answer[0].copy(), self._answer[1].copy()
        q[:, self._columns] = x[:, self.base_size :]
        q[:, :3] = x[:, :3]
        turn = x[:, 3:6]
        angle = np.sqrt(np.sum(turn * turn, axis=1))
        # sin(a/2)/a, with its series near zero
        half = np.where(angle < 1e-6, 0.5 - angle**2 / 48.0, np.sin(0.5 * angle) / np.maximum(angle, 1e-6))
        q[:, 3:6] = turn * half[:, None]
        q[:, 6] = np.cos(0.5 * angle)
        reached = self._legs.fill(q)
        if asked is not None:
            self._asked, self._answer = asked, (q.copy(), reached.copy())
        return q, reached

    @cached_property
    def _flattened(self) -> tuple[Coordinates, Tree]:
        from kinematics.standing.model_coordinates import standing_coordinates

        return standing_coordinates(self._robot), model_tree(self._model)

    def distance(self, a: Array, b: Array) -> float:
        """Weighted Euclidean distance of two points."""
        step = (b - a) * self.weights
        return float(np.sqrt(step @ step))


def free_coordinates(robot: StandingRobot) -> FreeCoordinates:
    """The free coordinates of a robot where it stands; made once."""
    return robot.derived(FreeCoordinates)
