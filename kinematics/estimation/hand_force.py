"""The force on a hand, felt in the efforts of its arm and the trunk.

What the motors give beyond weight and inertia balances a wrench on the hand: ``J^T w = tau_needed -
tau_measured``. Near a stretched arm the pseudo-inverse of ``J^T`` makes 40 N out of noise, so the wrench is
estimated by damped least squares: the most likely one, given normal errors of the efforts and a
normal expectation of force and moment.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel

FORCE_EXPECTED_N, MOMENT_EXPECTED_NM = 60.0, 1.0
"""Standard deviations of what a hand meets before anything was felt."""
ARM_ERROR_NM, TORSO_ERROR_NM = 1.0, 3.0
"""Of the efforts: sensors, friction, and what the model of the masses gets wrong."""


class HandForce:
    """Estimates force and moment of the surroundings on a hand, from the efforts of its arm and the trunk."""

    def __init__(self, model: RobotModel, hand: Hand, viscous_nms_rad: float) -> None:
        """Prepare.

        Args:
            model: The robot.
            hand: Which hand.
            viscous_nms_rad: Effort that a joint loses to each rad/s.
        """
        description = model.description
        self._model = model.pin
        self._data = model.pin.createData()
        self._frame = model.frame_id(description.tcp_frames[hand])
        arm, torso = description.groups[f"{hand}_arm"], description.groups["torso"]
        self._joints = model.indices([*arm, *torso])
        self._weight = 1.0 / np.array([ARM_ERROR_NM] * len(arm) + [TORSO_ERROR_NM] * len(torso))
        self._armature = np.array([description.armature[joint] for joint in (*arm, *torso)])
        self._viscous = viscous_nms_rad
        self._prior = np.diag([FORCE_EXPECTED_N**-2] * 3 + [MOMENT_EXPECTED_NM**-2] * 3)

    def estimate(self, q: Array, v: Array, a: Array, effort: Array) -> Array:
        """Force and moment of the surroundings on the hand, odometry axes, N and Nm, shape (6,).

        Args:
            q: Configuration, shape (nq,).
            v, a: Velocity and acceleration, shape (nv,).
            effort: Of the body joints, averaged over the same time, shape (n,), Nm.
        """
        k = self._joints
        needed = pin.rnea(self._model, self._data, q, v, a)[6 + k]
        needed = needed + self._armature * a[6 + k] + self._viscous * v[6 + k]
        pin.computeJointJacobians(self._model, self._data, q)
        pin.updateFramePlacement(self._model, self._data, self._frame)
        jacobian = pin.getFrameJacobian(self._model, self._data, self._frame, pin.LOCAL_WORLD_ALIGNED)
        rows = (jacobian[:, 6 + k] * self._weight).T
        right = rows.T @ (self._weight * (needed - effort[k]))
        # The joints carry the outside wrench away from what they need: tau = needed - J^T w.
        return np.asarray(np.linalg.solve(rows.T @ rows + self._prior, right), dtype=np.float64)
