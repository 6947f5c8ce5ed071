"""The coordinates that a standing robot is free to move: pelvis pose, trunk, arms and head.

The legs follow from the pelvis by the closed form, so that every point of this space has both feet
where they stand.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.leg_ik import LegIk
from kinematics.robot_model import RobotModel
from kinematics.trajectory import Stance

Array = NDArray[np.float64]

# A metre of the pelvis weighs like so many radians of a joint when lengths of paths are compared.
PELVIS_WEIGHT = 3.0


class FreeCoordinates:
    """Maps between configurations ``q`` and free coordinates ``x``.

    ``x`` has shape (size,): pelvis position (m), pelvis rotation vector (rad), then the joints that
    are in no leg, in the model's order.
    """

    def __init__(self, model: RobotModel, stance: Stance) -> None:
        self._model = model
        self._legs = LegIk(model, stance)
        groups = model.description.groups
        in_legs = {joint for name, members in groups.items() if name.endswith("_leg") for joint in members}
        self.joints = tuple(joint for joint in model.joints if joint not in in_legs)
        self._columns = 7 + model.indices(self.joints)
        self.size = 6 + len(self.joints)
        self.weights = np.concatenate([np.full(3, PELVIS_WEIGHT), np.ones(self.size - 3)])

    def index(self, joint: str) -> int:
        """Column of a joint in ``x``."""
        return 6 + self.joints.index(joint)

    def from_q(self, q: Array) -> Array:
        """Free coordinates of one configuration."""
        vector, w = q[3:6], q[6]
        if w < 0.0:
            vector, w = -vector, -w
        norm = float(np.linalg.norm(vector))
        turn = 2.0 * vector if norm < 1e-12 else vector * (2.0 * np.arctan2(norm, w) / norm)
        return np.concatenate([q[:3], turn, q[self._columns]])

    def to_q(self, x: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Configurations of many points.

        Args:
            x: Shape (n, size).

        Returns:
            Configurations, shape (n, nq), and whether both feet can be reached, shape (n,).
        """
        q = np.zeros((len(x), self._model.nq))
        q[:, :3] = x[:, :3]
        turn = x[:, 3:6]
        angle = np.sqrt(np.sum(turn * turn, axis=1))
        # sin(a/2)/a, with its series near zero
        half = np.where(angle < 1e-6, 0.5 - angle**2 / 48.0, np.sin(0.5 * angle) / np.maximum(angle, 1e-6))
        q[:, 3:6] = turn * half[:, None]
        q[:, 6] = np.cos(0.5 * angle)
        q[:, self._columns] = x[:, 6:]
        return q, self._legs.fill(q)

    def distance(self, a: Array, b: Array) -> float:
        """Weighted Euclidean distance of two points."""
        step = (b - a) * self.weights
        return float(np.sqrt(step @ step))
