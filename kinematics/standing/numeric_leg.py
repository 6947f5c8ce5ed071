"""Inverse kinematics of a leg whose axes have no closed form, by Newton's method over many poses at once.

A leg has as many joints as a foot has coordinates, so that away from a stretched knee each pose of the
foot has a few isolated solutions. The search begins at the home posture, with short steps, and so takes the
one on home's side of a stretched knee. Each pose is solved on its own: its neighbours have no say.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.errors import ModelError
from kinematics.geometry.poses import Transform
from kinematics.model.robot_model import RobotModel

Mask = NDArray[np.bool_]

BENT_RAD = 0.1
"""Knees of what is searched stay so far from being stretched, which shortens a leg by a thousandth: nearer to
it, the next millimetre is out of reach, and no method that goes by derivatives comes there."""
_KNEE, _ANGLES = 3, 721
_NEXT, _AFTER = [1, 2, 0], [2, 0, 1]


@dataclass(frozen=True, slots=True)
class LegChain:
    """The hinges of one leg, hip to ankle, each in the frame of the one before it; the first in the base's.

    Attributes:
        joints: Pinocchio's ids.
        turns: Rotation of each, shape (6, 3, 3).
        offsets_m: Its place, shape (6, 3).
        axes: Its axis, in its own frame, shape (6, 3).
        foot_T_sole: The sole on the last link, shape (4, 4).
    """

    joints: tuple[int, ...]
    turns: Array
    offsets_m: Array
    axes: Array
    foot_T_sole: Transform


class NumericLeg:
    """One leg, for one place of its foot.

    Attributes:
        chain: Its hinges.
        knee: Name of the fourth of them.

    Raises:
        ModelError: The leg is not a chain of six hinges that hangs on the base.
    """

    def __init__(self, model: RobotModel, group: str, frame: str, world_T_sole: Transform) -> None:
        ids = [model.pin.getJointId(name) for name in model.description.groups[group]]
        parents = [int(model.pin.parents[i]) for i in ids]
        if len(ids) != 6 or parents != [1, *ids[:-1]]:
            raise ModelError(f"{group}: not a chain of six joints from the base")
        sole = model.pin.frames[model.frame_id(frame)]
        if int(sole.parentJoint) != ids[-1]:
            raise ModelError(f"{group}: {frame} is not on its last link")
        self._columns = 7 + model.group(group)
        self.knee = model.description.groups[group][_KNEE]
        self._knee_rad = model.description.limits[self.knee].position
        self._turn = np.array([np.array(model.pin.jointPlacements[i].rotation) for i in ids])
        self._offset = np.array([np.array(model.pin.jointPlacements[i].translation) for i in ids])
        self._axis = np.array([_axis(model.pin, i) for i in ids])
        self._hinges = np.stack(_hinges(self._turn, self._offset, self._axis))
        self._foot_T_sole = np.array(sole.placement.homogeneous)
        self._world_T_sole = world_T_sole
        self._home = np.ascontiguousarray(model.q_home[self._columns])
        self.chain = LegChain(
            tuple(int(i) for i in ids), self._turn, self._offset, self._axis, self._foot_T_sole
        )

    def bent_range(self) -> tuple[float, float]:
        """Where the knee is bent as at home, and not nearly stretched; within its limits, rad."""
        lower_rad, upper_rad = self._knee_rad
        angles = np.linspace(lower_rad, upper_rad, _ANGLES)
        joints = np.tile(self._home, (_ANGLES, 1))
        joints[:, _KNEE] = angles
        at, _, origins, axes = self._forward(joints)
        volume = np.linalg.det(np.concatenate([_crossed(axes, at[:, None] - origins), axes], axis=2))
        stretched, home = float(angles[int(np.argmin(np.abs(volume)))]), float(self._home[_KNEE])
        if home > stretched:
            return max(lower_rad, min(home, stretched + BENT_RAD)), upper_rad
        return lower_rad, min(upper_rad, max(home, stretched - BENT_RAD))

    def fill(self, q: Array, base_R: Array) -> Mask:
        """Write the leg's joints into configurations.

        Args:
            q: Shape (n, nq); the leg's columns are overwritten.
            base_R: ``world_R_base`` of each, shape (n, 3, 3).

        Returns:
            Whether the foot is reached, shape (n,).
        """
        inverse = np.swapaxes(base_R, 1, 2)
        position = (inverse @ (self._world_T_sole[:3, 3] - q[:, :3])[..., None])[..., 0]
        rotation = inverse @ self._world_T_sole[:3, :3]
        joints, reached = self._solve(position, rotation)
        q[:, self._columns] = joints
        return reached

    def _solve(self, position: Array, rotation: Array) -> tuple[Array, Mask]:
        """From home to many poses of the sole in the base's frame."""
        # imported here: it brings the compiler
        from kinematics.standing.leg_newton import solve_poses

        joints, reached = np.empty((len(position), len(self._home))), np.empty(len(position), dtype=bool)
        solve_poses(
            self._home,
            self._hinges,
            self._axis,
            self._foot_T_sole,
            np.ascontiguousarray(position),
            np.ascontiguousarray(rotation),
            joints,
            reached,
        )
        return joints, reached

    def _forward(self, joints: Array) -> tuple[Array, Array, Array, Array]:
        """Sole position and rotation, joint origins and axes, all in the base's frame."""
        sine, versine = np.sin(joints)[..., None, None], (1.0 - np.cos(joints))[..., None, None]
        still, by_sine, by_versine = self._hinges
        hinges = still + sine * by_sine + versine * by_versine
        links = np.empty_like(hinges)
        links[:, 0] = hinges[:, 0]
        for k in range(1, 6):
            np.matmul(links[:, k - 1], hinges[:, k], out=links[:, k])
        sole = links[:, 5] @ self._foot_T_sole
        # a turn about its own axis leaves that where it is
        axes = (links[:, :, :3, :3] @ self._axis[..., None])[..., 0]
        return sole[:, :3, 3], sole[:, :3, :3], links[:, :, :3, 3], axes


def _hinges(turns: Array, offsets_m: Array, axes: Array) -> tuple[Array, Array, Array]:
    """What each hinge's pose is made of, by Rodrigues' formula, shape (6, 4, 4) each.

    The pose at an angle is the first, and sin(angle) of the second, and 1 - cos(angle) of the third.
    """
    across = np.zeros((len(axes), 3, 3))
    for row, column, which, sign in ((0, 1, 2, -1), (0, 2, 1, 1), (1, 2, 0, -1)):
        across[:, row, column], across[:, column, row] = sign * axes[:, which], -sign * axes[:, which]
    still, by_sine, by_versine = np.zeros((3, len(axes), 4, 4))
    still[:, :3, :3], still[:, :3, 3], still[:, 3, 3] = turns, offsets_m, 1.0
    by_sine[:, :3, :3], by_versine[:, :3, :3] = turns @ across, turns @ across @ across
    return still, by_sine, by_versine


def _axis(tree: pin.Model, joint: int) -> Array:
    subspace = np.array(tree.joints[joint].createData().S).reshape(6, -1)
    if subspace.shape[1] != 1 or subspace[:3].any():
        raise ModelError(f"joint {tree.names[joint]!r} is not a hinge")
    return np.asarray(subspace[3:, 0], dtype=np.float64)


def _crossed(a: Array, b: Array) -> Array:
    """Cross products along the last axis; numpy's own takes most of the time of a step of few poses."""
    return a[..., _NEXT] * b[..., _AFTER] - a[..., _AFTER] * b[..., _NEXT]
