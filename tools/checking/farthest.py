"""How far a motion can carry two solids against each other: what need not be looked at between two looks.

A joint that turns by an angle moves no point by more than the angle times the point's distance from it,
and that distance is at most what the links between measure, end to end. So the levers hold in every
posture.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from tools.checking.solid_world import SolidWorld

# Rotations are summed up in chords of quaternions, distances with Coal's precision.
ROUNDING = 1.0 + 1e-6


class Farthest:
    """Bounds of what the pairs of a world move against each other.

    Args:
        model: The robot.
        world: The pairs.
    """

    def __init__(self, model: RobotModel, world: SolidWorld) -> None:
        levers = [_levers(model.pin, item) for item in world.geometry.geometryObjects]
        pairs = [(pair.first, pair.second) for pair in world.geometry.collisionPairs]
        against = [_against(levers[first], levers[second]) for first, second in pairs]
        self._levers = ROUNDING * np.array(against).reshape(len(pairs), model.pin.njoints)

    def travelled(self, rows: Array) -> Array:
        """What each coordinate has gone since the first row: the base's shift and turn, then the joints.

        Args:
            rows: Configurations in order of time, shape (n, nq), near to each other.

        Returns:
            Shape (n, 2 + joints), m and rad.
        """
        step = np.diff(rows, axis=0)
        shift = np.linalg.norm(step[:, :3], axis=1)
        # the chord of two unit quaternions is twice the sine of a quarter of the angle between them
        chord = np.linalg.norm(step[:, 3:7], axis=1)
        turn = 4.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))
        gone = np.column_stack([shift, turn, np.abs(step[:, 7:])])
        return np.concatenate([np.zeros((1, gone.shape[1])), np.cumsum(gone, axis=0)])

    def apart_m(self, gone: Array, pairs: NDArray[np.intp]) -> Array:
        """The most that pairs can have moved while the coordinates went ``gone``, m.

        Args:
            gone: As of ``travelled``, shape (2 + joints, ...).
            pairs: Shape (p,).

        Returns:
            Shape (p, ...).
        """
        return np.asarray(self._levers[pairs] @ gone)

    def moving(self, gone: Array) -> NDArray[np.intp]:
        """Pairs that move at all while the coordinates go ``gone``."""
        return np.flatnonzero(self._levers @ gone > 0.0)


def _levers(model: pin.Model, item: pin.GeometryObject) -> Array:
    """By coordinate, how far a solid's points can be from the joint: base's shift and turn, then joints."""
    levers = np.zeros(model.njoints)
    joint = int(item.parentJoint)
    solid = item.geometry
    reach = float(np.linalg.norm(item.placement.act(solid.aabb_center))) + float(solid.aabb_radius)
    while joint > 0:
        # joint 1 is the base: entry 0 is its shift, entry 1 its turn, entry k that of joint k
        levers[joint] = reach
        reach += float(np.linalg.norm(model.jointPlacements[joint].translation))
        joint = int(model.parents[joint])
    levers[0] = 1.0 if levers[1] > 0.0 else 0.0
    return levers


def _against(first: Array, second: Array) -> Array:
    """Levers of two solids against each other: what carries both alike does not count."""
    return np.where((first > 0.0) & (second > 0.0), 0.0, np.maximum(first, second))
