"""The mass of what a hand holds, felt in the efforts of its arm and the trunk at rest."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.estimation.hand_force import ARM_ERROR_NM, TORSO_ERROR_NM
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel

GRAVITY_M_S2 = 9.81


class HeldMass:
    """Weighs what one hand holds, by the efforts of its arm and the trunk while the robot rests.

    At rest the efforts beyond those that hold the robot itself are those that hold a point mass where the
    object's centre is, so that one number is estimated, by weighted least squares. The noise of one
    reading is worth some hundred grams: many have to be taken in.

    Attributes:
        trunk_joints: How many of the joints are the trunk's; they come after the arm's.
    """

    def __init__(self, model: RobotModel, hand: Hand) -> None:
        """Have weighed nothing.

        Args:
            model: The robot, with what its other hand carries.
            hand: Which hand.
        """
        description = model.description
        self._model, self._data = model.pin, model.pin.createData()
        self._frame = model.frame_id(description.tcp_frames[hand])
        arm, torso = description.groups[f"{hand}_arm"], description.groups["torso"]
        self._joints = model.indices([*arm, *torso])
        self._weight = np.array([ARM_ERROR_NM**-2] * len(arm) + [TORSO_ERROR_NM**-2] * len(torso))
        self.trunk_joints = len(torso)
        self._viscous = description.joint_viscosity_nms_rad
        self._payload_kg = description.grippers[hand].payload_kg
        self._sum, self._square = 0.0, 0.0

    def residual(self, q: Array, v: Array, effort: Array) -> Array:
        """Efforts beyond those of the robot itself, Nm, of the arm's joints and the trunk's.

        Args:
            q: Configuration, shape (nq,).
            v: Velocities of the body joints, shape (n,).
            effort: Efforts of the body joints, shape (n,), Nm.
        """
        k = self._joints
        needed = pin.computeGeneralizedGravity(self._model, self._data, q)[6 + k]
        return np.asarray(effort[k] - needed - self._viscous * v[k], dtype=np.float64)

    def add(self, q: Array, v: Array, effort: Array, point_m: Array, count: int = 1) -> None:
        """Take readings at rest in.

        Args:
            q, v, effort: As of ``residual``; the mean of several readings where there are.
            point_m: Where the object's centre is in the TCP's frame, shape (3,).
            count: How many readings.
        """
        felt, lever = self.residual(q, v, effort), self.lever(q, point_m)
        self._sum += count * float((self._weight * lever) @ felt)
        self._square += count * float((self._weight * lever) @ lever)

    def lever(self, q: Array, point_m: Array) -> Array:
        """Efforts that hold each kilogram at a place in the TCP's frame, shape (3,), Nm/kg."""
        return _per_kg(self._model, self._data, self._frame, q, point_m)[self._joints]

    @property
    def mass_kg(self) -> float:
        """The estimate: no less than nothing, and no more than the hand's payload."""
        if self._square <= 0.0:
            return 0.0
        return min(max(self._sum / self._square, 0.0), self._payload_kg)


def effort_per_kg(model: RobotModel, frame: str, q: Array, point_m: Array) -> Array:
    """Efforts that hold each kilogram at a place of a frame, at rest.

    Args:
        model: The robot.
        frame: Model frame that carries it.
        q: Configuration, shape (nq,).
        point_m: Where in that frame, shape (3,).

    Returns:
        Of the body joints, shape (n,), Nm/kg.

    Raises:
        UnknownNameError: The model has no such frame.
    """
    return _per_kg(model.pin, model.pin.createData(), model.frame_id(frame), q, point_m)


def _per_kg(model: pin.Model, data: pin.Data, frame: int, q: Array, point_m: Array) -> Array:
    pin.computeJointJacobians(model, data, q)
    pin.updateFramePlacement(model, data, frame)
    jacobian = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)[:, 6:]
    x, y, _ = data.oMf[frame].rotation @ point_m
    # the vertical speed of the place for each joint's: that of the frame, and what turning adds
    return np.asarray(GRAVITY_M_S2 * (jacobian[2] + jacobian[3] * y - jacobian[4] * x))
