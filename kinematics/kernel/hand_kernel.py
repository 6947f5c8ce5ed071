"""Does an open hand alone fit at a pose? As ``kinematics.collision.collision_world.HandCollision``, by the
kernel.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform, quaternions_from_rotations
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.kernel.robot_arrays import RobotArrays
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene


def hand_arrays(model: RobotModel, hand: Hand) -> RobotArrays:
    """A robot that is nothing but a hand in the air: its base is the TCP."""
    tcp = model.pin.frames[model.frame_id(model.description.grippers[hand].tcp_frame)]
    alone, geometry = pin.Model(), pin.GeometryModel()
    base = alone.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "tcp")
    names = []
    for item in model.geometry().geometryObjects:
        if item.parentJoint == tcp.parentJoint:
            place = tcp.placement.inverse() * item.placement
            geometry.addGeometryObject(pin.GeometryObject(item.name, base, place, item.geometry))
            names.append(model.link_of(item))
    return RobotArrays(alone, geometry, names)


class HandKernel:
    """An open hand in a scene.

    Args:
        hand: Its arrays, made once.
        scene: What is around.
        target: Object that the fingers may touch; the rest of the hand is judged against it elsewhere.
        extra_margin_m: Added to the margins of the scene.
    """

    def __init__(self, hand: RobotArrays, scene: PlanningScene, target: str, extra_margin_m: float) -> None:
        others = [item for item in scene.objects.values() if item.name != target]
        self._kernel = CollisionKernel(hand, PlanningScene().with_objects(others), None, None, extra_margin_m)
        counts = [1 if item.shape.parts is None else len(item.shape.parts.ends) for item in others]
        self._margins_m = np.repeat([item.margin_m + extra_margin_m for item in others], counts)

    def collisions(self, world_T_tcp: Array) -> NDArray[np.bool_]:
        """Tell whether the hand is too near to anything, by pose, shape (n, 4, 4) to (n,)."""
        return self._kernel.contacts(_configurations(world_T_tcp))

    def fits_along(self, world_T_tcp: Array, along_m: Sequence[float]) -> NDArray[np.bool_]:
        """Tell whether it has room at poses, shape (n, 4, 4), moved along their x axis by each distance."""
        start = _configurations(world_T_tcp)
        ahead = world_T_tcp[:, :3, 0]
        left = np.arange(len(start))
        for step_m in along_m:
            moved = start[left]
            moved[:, :3] += step_m * ahead[left]
            left = left[~self._kernel.contacts(moved)]
        fits = np.zeros(len(start), dtype=bool)
        fits[left] = True
        return fits

    def clearance_m(self, world_T_tcp: Transform, enough_m: float) -> float:
        """Room between the hand and everything but the target, beyond the margins.

        No more than ``enough_m`` is measured; 0 or less means that it collides.
        """
        if not len(self._margins_m):
            return enough_m
        cap_m = enough_m + float(self._margins_m.max())
        distances_m = self._kernel.distances_m(_configurations(world_T_tcp[None])[0], cap_m)
        room_m = distances_m.reshape(len(self._margins_m), -1).min(axis=1) - self._margins_m
        return float(min(enough_m, room_m.min()))


def _configurations(world_T_tcp: Array) -> Array:
    rotations = np.asarray(world_T_tcp[:, :3, :3])
    return np.hstack([world_T_tcp[:, :3, 3], quaternions_from_rotations(rotations)])
