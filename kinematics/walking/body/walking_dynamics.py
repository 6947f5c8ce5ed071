"""Joint efforts of a robot whose soles get given wrenches."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.dynamics.standing_dynamics import chain_columns
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.sampler import MotionSample
from kinematics.walking.body.foot_wrenches import SoleWrench


class WalkingDynamics:
    """Joint efforts of a walking robot: those of the motion, less those that the floor takes over.

    The motion is the reference; the wrenches on the soles are those that the stabiliser wants. What the two
    differ by is what brings the robot back to the reference. Inertia counts: without it the feet
    overshoot by a fifth.
    """

    def __init__(self, model: RobotModel) -> None:
        self._model, self._data = model.pin, model.pin.createData()
        self._armature = np.array([model.description.armature[name] for name in model.joints])
        self._chains = {sole.side: chain_columns(model, sole.frame) for sole in model.description.soles}

    def efforts(self, sample: MotionSample, soles: Mapping[Hand, SoleWrench]) -> Array:
        """Efforts of the body joints, Nm, shape (n,)."""
        generalized = pin.rnea(self._model, self._data, sample.q, sample.v, sample.a)
        efforts: Array = self._armature * sample.a[6:]
        efforts += generalized[6:]
        jacobian = pin.computeJointJacobians(self._model, self._data, sample.q)
        wrench = np.empty(6)
        for side, sole in soles.items():
            columns, rows = self._chains[side]
            fx, fy, fz = sole.force_n.tolist()
            px, py, pz = sole.at_m.tolist()
            wrench[:3], wrench[3:] = sole.force_n, sole.moment_nm
            wrench[3] += py * fz - pz * fy
            wrench[4] += pz * fx - px * fz
            wrench[5] += px * fy - py * fx
            efforts[rows] -= wrench.dot(jacobian[:, columns])
        return efforts
