"""What the floor does to each sole, from the efforts of the legs and the IMU, for feet without sensors.

The inverse dynamics of the robot in the air need other efforts of a leg than it gives; what is missing, the
floor does: ``w = J^-T (rnea(q, v, a) - tau)``, with the Jacobian of the sole over the six joints of its leg.
The accelerometer stands in for gravity and the base's acceleration, so that no orientation is needed.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel

_ACCELERATION_SHARE = 0.15
"""Of a new difference of speeds: encoders' noise of 0.002 rad/s would be 1 rad/s^2 each period."""
_WRENCH_SHARE = 0.5
_SINGULAR = 1e-4
"""Determinant of a leg's Jacobian below which it is as good as stretched, and tells nothing along it."""


class LegWrench:
    """Estimates the wrenches of all soles, one control period after the other.

    Of a robot of 34 kg vertical forces are found to 5 N standing and 16 N walking (standard deviation); a
    stretched leg keeps its last wrench.
    """

    def __init__(self, model: RobotModel) -> None:
        """Begin without any acceleration.

        Args:
            model: A robot on legs of six hinges, with an IMU.
        """
        description = model.description
        self._model, self._pin = model, pin.Model(model.pin)
        self._pin.gravity.linear = np.zeros(3)
        self._data = self._pin.createData()
        home = model.q_home
        self._q, self._v, self._a = home.copy(), np.zeros(model.nv), np.zeros(model.nv)
        self._q[:3], self._q[3:7] = 0.0, (0.0, 0.0, 0.0, 1.0)
        base_T_imu = np.linalg.inv(model.frame_pose(home, description.base_link)) @ model.frame_pose(
            home, description.imu_link
        )
        self._base_R_imu, self._imu_m = base_T_imu[:3, :3], base_T_imu[:3, 3]
        self._frames = [model.frame_id(sole.frame) for sole in description.soles]
        self._legs = [6 + model.group(f"{sole.side}_leg") for sole in description.soles]
        armature = np.array([description.armature[name] for name in model.joints])
        self._armature, self._viscosity = armature, description.joint_viscosity_nms_rad
        self._wrench = np.zeros((len(self._frames), 6))
        self._stamp_s: float | None = None

    def update(
        self, stamp_s: float, q: Array, v: Array, effort: Array, gyro: Array, accelerometer: Array
    ) -> Array:
        """Take one set of readings in; gives the wrenches in the soles' frames, N and Nm, shape (soles, 6).

        Args:
            stamp_s: When they were taken; the same readings may come again.
            q, v, effort: Of the body joints, shape (joints,).
            gyro, accelerometer: In the IMU's frame, shape (3,).
        """
        first = self._stamp_s is None
        elapsed_s = 0.0 if self._stamp_s is None else stamp_s - self._stamp_s
        if not first and elapsed_s <= 0.0:
            return self._wrench
        self._stamp_s = stamp_s
        if not first:
            self._a[6:] += _ACCELERATION_SHARE * ((v - self._v[6:]) / elapsed_s - self._a[6:])
        turning = self._base_R_imu @ gyro
        specific = self._base_R_imu @ accelerometer
        self._q[7:], self._v[6:], self._v[3:6] = q, v, turning
        # at the base: the IMU is carried around it; the frame's own turning is not the velocity's
        self._a[:3] = specific - np.cross(turning, np.cross(turning, self._imu_m))
        missing = np.asarray(pin.rnea(self._pin, self._data, self._q, self._v, self._a))[6:]
        missing = missing + self._armature * self._a[6:] + self._viscosity * v - effort
        pin.computeJointJacobians(self._pin, self._data, self._q)
        pin.updateFramePlacements(self._pin, self._data)
        share = 1.0 if first else _WRENCH_SHARE
        for k, (frame, columns) in enumerate(zip(self._frames, self._legs, strict=True)):
            J = np.asarray(pin.getFrameJacobian(self._pin, self._data, frame, pin.LOCAL))[:, columns]
            if abs(np.linalg.det(J)) < _SINGULAR:
                continue
            found = np.linalg.solve(J.T, missing[columns - 6])
            self._wrench[k] += share * (found - self._wrench[k])
        return self._wrench
