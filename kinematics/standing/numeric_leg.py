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

# Solved to this distance (m) and angle (rad); a double leaves some 1e-16.
SOLVED = 1e-12
# Of 2,000 poses about a standing one, all that are reached at all were within 10.
ITERATIONS = 16
# No joint turns farther in one iteration: a longer step may come down behind a singularity.
LONGEST_STEP = 0.4
# Damping, of the squared error: none is left where Newton's method converges.
DAMPING = 1e-2


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
        self._still, self._by_sine, self._by_versine = _hinges(self._turn, self._offset, self._axis)
        self._foot_T_sole = np.array(sole.placement.homogeneous)
        self._world_T_sole = world_T_sole
        self._home = model.q_home[self._columns]
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
        """Newton's method from home to many poses of the sole in the base's frame, damped while far away."""
        joints = np.tile(self._home, (len(position), 1))
        open_ = np.arange(len(joints))
        for _ in range(ITERATIONS):
            error, jacobian = self._errors(joints[open_], position[open_], rotation[open_])
            size = np.max(np.abs(error), axis=1)
            going = size > SOLVED
            open_, error, jacobian, size = open_[going], error[going], jacobian[going], size[going]
            if not len(open_):
                break
            transposed = np.swapaxes(jacobian, 1, 2)
            damped = jacobian @ transposed + (DAMPING * size**2 + 1e-15)[:, None, None] * np.eye(6)
            step = (transposed @ np.linalg.solve(damped, error[..., None]))[..., 0]
            longest = np.max(np.abs(step), axis=1)
            joints[open_] += step * np.minimum(1.0, LONGEST_STEP / np.maximum(longest, 1e-12))[:, None]
        reached = np.ones(len(joints), dtype=bool)
        if len(open_):
            error, _ = self._errors(joints[open_], position[open_], rotation[open_])
            reached[open_] = np.max(np.abs(error), axis=1) <= SOLVED
        return joints, reached

    def _errors(self, joints: Array, position: Array, rotation: Array) -> tuple[Array, Array]:
        """Distance and turn to the wanted pose, shape (n, 6), and the Jacobian, shape (n, 6, 6)."""
        at, at_R, origins, axes = self._forward(joints)
        turn = _rotation_vector(rotation @ np.swapaxes(at_R, 1, 2))
        jacobian = np.concatenate([_crossed(axes, at[:, None] - origins), axes], axis=2)
        return np.concatenate([position - at, turn], axis=1), np.swapaxes(jacobian, 1, 2)

    def _forward(self, joints: Array) -> tuple[Array, Array, Array, Array]:
        """Sole position and rotation, joint origins and axes, all in the base's frame."""
        sine, versine = np.sin(joints)[..., None, None], (1.0 - np.cos(joints))[..., None, None]
        hinges = self._still + sine * self._by_sine + versine * self._by_versine
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


def _rotation_vector(rotations: Array) -> Array:
    """Rotation vectors, shape (n, 3); of half a turn, where the axis is lost, one about x."""
    m = rotations
    twice = np.stack([m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]], axis=1)
    sine = 0.5 * np.sqrt(np.sum(twice * twice, axis=1))
    cosine = 0.5 * (m[:, 0, 0] + m[:, 1, 1] + m[:, 2, 2] - 1.0)
    angle = np.arctan2(sine, cosine)
    # angle / sin(angle), with its limit at zero
    vector = 0.5 * twice * np.where(sine < 1e-8, 1.0, angle / np.maximum(sine, 1e-8))[:, None]
    vector[(sine < 1e-8) & (cosine < 0.0)] = (np.pi, 0.0, 0.0)
    return np.asarray(vector)
