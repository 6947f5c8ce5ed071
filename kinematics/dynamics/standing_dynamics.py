"""Joint efforts of a standing robot: inverse dynamics less what the ground takes."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.dynamics.sole_shares import SoleShares
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot


class StandingDynamics:
    """Inverse dynamics of a robot that stands on fixed soles.

    Each call takes one recursive Newton-Euler pass and one pass of joint Jacobians; which part of the
    ground's wrench each sole takes is for ``SoleShares`` to say.
    """

    def __init__(self, robot: StandingRobot) -> None:
        """Prepare for one stance.

        Args:
            robot: Where it stands; its soles' poses must be those that every ``q`` puts them at.
        """
        model, stance = robot.model, robot.stance
        self._model = model.pin
        self._data = model.pin.createData()
        self._armature = np.array(
            [model.description.armature[name] for name in model.joints], dtype=np.float64
        )
        self._shares = SoleShares(stance, model.description.soles)
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
        wrenches = self._shares.wrenches(net)
        for k, (columns, rows) in enumerate(self._chains):
            efforts[rows] -= wrenches[6 * k : 6 * k + 6].dot(jacobian[:, columns])
        return efforts


def chain_columns(model: RobotModel, frame: str) -> tuple[slice, slice]:
    """Columns of the Jacobian, and rows of ``q[7:]``, of the joints between the base and a frame.

    Pinocchio numbers joints depth first, so the joints of one limb follow each other.
    """
    joint = int(model.pin.frames[model.frame_id(frame)].parentJoint)
    support = [int(i) for i in model.pin.supports[joint]][2:]
    first = int(model.pin.joints[support[0]].idx_v)
    last = int(model.pin.joints[support[-1]].idx_v)
    return slice(first, last + 1), slice(first - 6, last - 5)
