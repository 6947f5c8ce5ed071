"""What a touch of the hand, as the other joints of its arm feel it, means for one joint.

The torques ``r`` that joints give beyond what motion needs balance a wrench on the hand: ``r = -J^T w``.
A joint that is pressed from outside agrees with the wrench that the others tell; one that is held by its
own bearing or gear gives torque that no other joint feels.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.estimation.hand_force import (
    ARM_ERROR_NM,
    FORCE_EXPECTED_N,
    MOMENT_EXPECTED_NM,
    TORSO_ERROR_NM,
)
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel


class HandTouch:
    """Foretells the torque of one joint of arm or trunk from those of the others, as if one wrench on the
    hand were behind them all: a joint that feels something else is not touched at the hand.

    Attributes:
        joints: Indices of the joints that are looked at, arm first, then torso, among the body's joints.
    """

    def __init__(self, model: RobotModel, hand: Hand) -> None:
        """Prepare.

        Args:
            model: The robot.
            hand: Which hand.
        """
        groups = model.description.groups
        arm, torso = groups[f"{hand}_arm"], groups.get("torso", ())
        self._pin, self._data = model.pin, model.pin.createData()
        self._frame = model.frame_id(model.description.tcp_frames[hand])
        self.joints = model.indices([*arm, *torso])
        self._weight = 1.0 / np.array([ARM_ERROR_NM] * len(arm) + [TORSO_ERROR_NM] * len(torso))
        self._prior = np.diag([FORCE_EXPECTED_N**-2] * 3 + [MOMENT_EXPECTED_NM**-2] * 3)

    def foretold_nm(self, q: Array, outside: Array, joint: int) -> float:
        """Torque of one joint that the most likely wrench on the hand asks for, Nm.

        Args:
            q: Configuration, shape (nq,).
            outside: What the body's joints give beyond what their motion needs, shape (n,), Nm.
            joint: Index of the joint among the body's; its own torque is not looked at.

        Raises:
            ValueError: The joint is none of ``joints``.
        """
        k = self.joints
        (place,) = np.flatnonzero(k == joint)  # a joint of another chain makes this the promised ValueError
        pin.computeJointJacobians(self._pin, self._data, q)
        pin.updateFramePlacement(self._pin, self._data, self._frame)
        jacobian = pin.getFrameJacobian(self._pin, self._data, self._frame, pin.LOCAL_WORLD_ALIGNED)[:, 6 + k]
        weight = self._weight.copy()
        weight[place] = 0.0
        rows = (jacobian * weight).T
        wrench = np.linalg.solve(rows.T @ rows + self._prior, -rows.T @ (weight * outside[k]))
        return -float(jacobian[:, place] @ wrench)
