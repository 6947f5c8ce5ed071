"""How far from a robot's posture a checked motion may begin, and why that needs no check of its own.

A checked motion is played from where the robot rests. Where its first posture is beside that, a lead-in
(``kinematics.motion.lead_in``) goes from one to the other, and nobody has checked the lead-in. Therefore
no point of
the robot, or of what it holds, may move by more than ``LEAD_IN_M`` on it. Two solids then approach each other
by no more than ``SPARE_M``, twice that, which the checker proves for every instant of a motion beyond the
distance that they must keep (``CheckSettings.spare_m``). The CoM, a mean of points, moves by no more than
``LEAD_IN_M`` either, a tenth of the checker's ``com_tolerance_m``; so do the soles, a hundredth of its
``stance_m``. The lead-in takes 0.05 s or more from rest to rest, so that the CoM is accelerated by less than
0.03 m/s^2 and the ZMP is a few millimetres beside it: less than the CoM margin that a checked posture has.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.checking.settings import SPARE_M
from kinematics.model.robot_model import RobotModel

LEAD_IN_M = 0.5 * SPARE_M
"""The farthest that a lead-in may move any point. Plans begin exactly at the posture that they are asked
from; a motion that goes on after a pause begins beside it by what its legs stray between samples, up to
4e-6 m."""

_HELD_M = 0.5
"""Farthest that what a hand holds reaches from the joint that carries the hand."""


class StartGap:
    """Measures how far a robot's points move between two postures near to each other."""

    def __init__(self, model: RobotModel) -> None:
        """Prepare for a robot; its collision geometry is read."""
        self._model = model.pin
        self._reach_m = np.zeros(model.pin.njoints)
        for item in model.geometry().geometryObjects:
            item.geometry.computeLocalAABB()
            centre = item.placement.act(np.array(item.geometry.aabb_center))
            reach_m = float(np.linalg.norm(centre)) + float(item.geometry.aabb_radius)
            self._reach_m[item.parentJoint] = max(self._reach_m[item.parentJoint], reach_m)
        for frame in model.description.tcp_frames.values():
            self._reach_m[model.pin.frames[model.frame_id(frame)].parentJoint] += _HELD_M
        offsets = [np.linalg.norm(place.translation) for place in model.pin.jointPlacements]
        self._size_m = float(np.sum(offsets[2:]) + self._reach_m.max())

    def moves_m(self, q_from: Array, q_to: Array) -> float:
        """The farthest that any point moves, from above, on the straight way between two configurations.

        The ends are compared exactly, body by body; between them a point leaves its chord by an eighth of
        its acceleration, which the squared sum of all turns bounds.

        Args:
            q_from, q_to: Shape (nq,).
        """
        placed = []
        for q in (q_from, q_to):
            data = self._model.createData()
            pin.forwardKinematics(self._model, data, q)
            placed.append(np.array([place.homogeneous for place in list(data.oMi)[1:]]))
        apart = placed[1] - placed[0]
        shift_m = np.linalg.norm(apart[:, :3, 3], axis=1)
        # a point moves by no more than the spectral norm of R_to - R_from, which is Frobenius' over sqrt(2)
        turn = np.linalg.norm(apart[:, :3, :3], axis=(1, 2)) / np.sqrt(2.0)
        turns = float(np.abs(q_to[7:] - q_from[7:]).sum() + turn[0])
        return float((shift_m + turn * self._reach_m[1:]).max()) + 0.125 * self._size_m * turns**2


def start_gap(model: RobotModel) -> StartGap:
    """The measure of a robot; made once, for the first one that asks."""
    return model.derived(StartGap)
