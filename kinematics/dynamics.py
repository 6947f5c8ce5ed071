"""Joint efforts of a standing robot: inverse dynamics less what the ground takes.

The ground's wrenches on the soles are under-determined with two feet down; the smallest ones are
chosen, moments counting ten times dearer than forces, so that no foot is asked to twist or tip.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.poses import Transform
from kinematics.robot_model import RobotModel
from kinematics.trajectory import Stance

Array = NDArray[np.float64]

_MOMENT_WEIGHT = 0.1
"""Weight of a moment (Nm) against a force (N): a sole bears forces easily and tips under moments;
0.1 m is about the half-length of a sole."""


class StandingDynamics:
    """Inverse dynamics of a robot that stands on fixed soles.

    The map from the net wrench at the world's origin to the soles' wrenches depends on the stance
    alone, so it is inverted once; what is left for each call is one recursive Newton-Euler pass
    and one pass of joint Jacobians.
    """

    def __init__(self, model: RobotModel, stance: Stance) -> None:
        """Prepare for one stance.

        Args:
            model: The robot.
            stance: Soles that carry; their poses must be those that every ``q`` puts them at.
        """
        self._model = model.pin
        self._data = model.pin.createData()
        self._armature = np.array(
            [model.description.gains[name].armature for name in model.joints], dtype=np.float64
        )
        self._to_soles = _wrench_distribution(stance)
        self._chains = [chain_columns(model, frame) for frame, _ in stance.soles]
        self._rest_v = np.zeros(model.nv)
        self._rest_a = np.zeros(model.nv)

    def holding_efforts(self, q: Array) -> Array:
        """Efforts that hold a configuration, Nm, shape (n,), order of ``q[7:]``."""
        return self.efforts(q, self._rest_v, self._rest_a)

    def efforts(self, q: Array, v: Array, a: Array) -> Array:
        """Efforts that carry a motion out, Nm, shape (n,), order of ``q[7:]``.

        Args:
            q: Configuration with the soles where the stance has them, shape (nq,).
            v: Velocity, shape (nv,).
            a: Acceleration, shape (nv,); rotor inertia is counted in.
        """
        # ``dot`` throughout: on arrays this small the operator costs three times as much.
        generalized = pin.rnea(self._model, self._data, q, v, a)
        efforts: Array = self._armature * a[6:]
        efforts += generalized[6:]
        jacobian = pin.computeJointJacobians(self._model, self._data, q)
        # The free-flyer's generalized force, moved to the world's origin and turned into world axes.
        net = self._data.oMi[1].toDualActionMatrix().dot(generalized[:6])
        wrenches = self._to_soles.dot(net)
        for k, (columns, rows) in enumerate(self._chains):
            efforts[rows] -= wrenches[6 * k : 6 * k + 6].dot(jacobian[:, columns])
        return efforts


def _wrench_distribution(stance: Stance) -> Array:
    """Matrix from the net wrench at the origin to the soles' wrenches at the origin, shape (6 k, 6)."""
    transport = [_to_origin(world_T_sole) for _, world_T_sole in stance.soles]
    grasp_map = np.hstack(transport)
    weight = np.diag([1.0, 1.0, 1.0, _MOMENT_WEIGHT, _MOMENT_WEIGHT, _MOMENT_WEIGHT] * len(transport))
    local = weight @ np.linalg.pinv(grasp_map @ weight)
    at_origin = [transport[k] @ local[6 * k : 6 * k + 6] for k in range(len(transport))]
    return np.vstack(at_origin)


def _to_origin(world_T_sole: Transform) -> Array:
    """Matrix that moves a wrench (force, moment; world axes) from a sole's origin to the world's."""
    x, y, z = world_T_sole[:3, 3]
    move = np.eye(6)
    move[3:, :3] = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
    return move


def chain_columns(model: RobotModel, frame: str) -> tuple[slice, slice]:
    """Columns of the Jacobian, and rows of ``q[7:]``, of the joints between the base and a frame.

    Pinocchio numbers joints depth first, so the joints of one limb follow each other.
    """
    joint = int(model.pin.frames[model.frame_id(frame)].parentJoint)
    support = [int(i) for i in model.pin.supports[joint]][2:]
    first = int(model.pin.joints[support[0]].idx_v)
    last = int(model.pin.joints[support[-1]].idx_v)
    return slice(first, last + 1), slice(first - 6, last - 5)
