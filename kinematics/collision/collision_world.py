"""Does a configuration collide? The planner's own, discrete judge, with Coal on convex hulls.

The trajectory checker is a judge of its own and shares none of this.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, count

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.distance.link_solids import coal_solids
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import FLOOR, PlanningScene, floor


class CollisionWorld:
    """A robot in a planning scene.

    Args:
        model: The robot.
        scene: What is around, what is held, and which pairs may touch.
        extra_margin_m: Added to every margin of the scene; what planning keeps in reserve
            against the checker.
        self_margin_m: Distance kept between the robot's own links.
    """

    def __init__(
        self,
        model: RobotModel,
        scene: PlanningScene,
        extra_margin_m: float = 0.0,
        self_margin_m: float = 0.0,
    ) -> None:
        self._model = model
        self._geometry = model.geometry()
        links = [model.link_of(item) for item in self._geometry.geometryObjects]
        robot = range(len(links))
        margins = [self_margin_m] * self._drop_pairs_between_legs()
        names = list(links)
        scene = with_floor(model, scene) if model.description.welded else scene
        for item in scene.objects.values():
            for index in self._add(item.name, 0, item.world_T_object, item.shape):
                names.append(item.name)
                for i in robot:
                    if not scene.is_allowed(names[i], item.name):
                        self._geometry.addCollisionPair(pin.CollisionPair(i, index))
                        margins.append(item.margin_m + extra_margin_m)
        for name, body in scene.attached.items():
            frame = model.pin.frames[model.frame_id(body.frame)]
            placement = frame.placement.homogeneous @ body.frame_T_object
            for index in self._add(name, frame.parentJoint, placement, body.body.shape):
                names.append(name)
                for i in range(index):
                    free = names[i] in body.touch_links or scene.is_allowed(names[i], name)
                    if free or self._geometry.geometryObjects[i].parentJoint == frame.parentJoint:
                        continue
                    self._geometry.addCollisionPair(pin.CollisionPair(i, index))
                    other = scene.objects.get(names[i])
                    margins.append(extra_margin_m if other is None else other.margin_m + extra_margin_m)
        self._names = names
        self._data = model.pin.createData()
        self._geometry_data = self._geometry.createData()
        for request, margin in zip(self._geometry_data.collisionRequests, margins, strict=True):
            request.security_margin = margin

    def collides(self, q: Array) -> bool:
        """Tell whether any pair that may not touch is nearer than its margin."""
        return bool(
            pin.computeCollisions(self._model.pin, self._data, self._geometry, self._geometry_data, q, True)
        )

    def colliding_pair(self, q: Array) -> tuple[str, str] | None:
        """Names of the first pair that collides, or None."""
        if not self.collides(q):
            return None
        for pair, result in zip(
            self._geometry.collisionPairs, self._geometry_data.collisionResults, strict=True
        ):
            if result.isCollision():
                return self._names[pair.first], self._names[pair.second]
        return None

    def _drop_pairs_between_legs(self) -> int:
        """Forget pairs of leg links, which a standing motion hardly changes; the checker has them."""
        groups = self._model.description.groups
        legs = {
            self._model.pin.getJointId(joint)
            for group, joints in groups.items()
            if group.endswith("_leg")
            for joint in joints
        }
        joint_of = [item.parentJoint for item in self._geometry.geometryObjects]
        kept = [
            (pair.first, pair.second)
            for pair in self._geometry.collisionPairs
            if not (joint_of[pair.first] in legs and joint_of[pair.second] in legs)
        ]
        self._geometry.removeAllCollisionPairs()
        for first, second in kept:
            self._geometry.addCollisionPair(pin.CollisionPair(first, second))
        return len(kept)

    def _add(self, name: str, joint: int, placement: Transform, shape: Shape) -> list[int]:
        at = pin.SE3(placement[:3, :3], placement[:3, 3])
        return [
            int(self._geometry.addGeometryObject(pin.GeometryObject(f"{name}{part}", joint, at, solid)))
            for part, solid in zip(_part_numbers(), coal_solids(shape), strict=False)
        ]


def _part_numbers() -> Iterator[str]:
    """What is behind the name of the first solid of a thing, of the second and so on."""
    return chain([""], (f"/{number}" for number in count(1)))


def with_floor(model: RobotModel, scene: PlanningScene) -> PlanningScene:
    """A scene with the floor, which the soles may touch, and the links of a welded base bolted to it.

    Plans of who stands leave it out, as he has his hands up; an arm on a table could reach into it.
    """
    if FLOOR not in scene.objects:
        scene = scene.with_object(floor())
    if not model.description.welded:
        return scene.allowing((sole.link, FLOOR) for sole in model.description.soles)
    base = model.pin.frames[model.frame_id(model.description.base_link)].parentJoint
    parts = model.geometry().geometryObjects
    return scene.allowing((model.link_of(part), FLOOR) for part in parts if part.parentJoint == base)


class HandCollision:
    """Does an open hand alone fit at a pose? A cheap filter before any inverse kinematics.

    Args:
        model: The robot.
        hand: Whose gripper.
        scene: What is around.
        target: Object that the fingers may touch; the rest of the hand is judged against it elsewhere.
        extra_margin_m: Added to the margins of the scene.
    """

    def __init__(
        self, model: RobotModel, hand: Hand, scene: PlanningScene, target: str, extra_margin_m: float
    ) -> None:
        gripper = model.description.grippers[hand]
        tcp = model.pin.frames[model.frame_id(gripper.tcp_frame)]
        joint_T_tcp = np.array(tcp.placement.homogeneous)
        tcp_T_joint = np.linalg.inv(joint_T_tcp)
        self._parts = [
            (item.geometry, tcp_T_joint @ np.array(item.placement.homogeneous))
            for item in model.geometry().geometryObjects
            if item.parentJoint == tcp.parentJoint
        ]
        others = [item for item in scene.objects.values() if item.name != target]
        self._solids = [
            (solid, _coal_transform(item.world_T_object), item.margin_m + extra_margin_m)
            for item in others
            for solid in coal_solids(item.shape)
        ]
        self._corners = np.concatenate(
            [
                np.array(geometry.points()) @ tcp_T_part[:3, :3].T + tcp_T_part[:3, 3]
                for geometry, tcp_T_part in self._parts
                if isinstance(geometry, coal.ConvexBase)
            ]
        )
        self._boxes = [
            (item.world_T_object, 0.5 * np.array(item.shape.size_m) + item.margin_m + extra_margin_m)
            for item in others
            if isinstance(item.shape, Box) and item.shape.parts is None
        ]

    def collisions(self, world_T_tcp: Array) -> NDArray[np.bool_]:
        """``collides`` of many poses, shape (n, 4, 4), shape (n,)."""
        return np.array([self.collides(pose) for pose in world_T_tcp], dtype=bool)

    def fits_along(self, world_T_tcp: Array, along_m: Sequence[float]) -> NDArray[np.bool_]:
        """Whether there is room at poses, shape (n, 4, 4), moved along their x axis by each distance."""
        fits = np.ones(len(world_T_tcp), dtype=bool)
        for step_m in along_m:
            left = np.flatnonzero(fits)
            fits[left] = ~self.collisions(world_T_tcp[left] @ poses.translation(step_m, 0.0, 0.0))
        return fits

    def collides(self, world_T_tcp: Transform) -> bool:
        """Tell whether the open hand, TCP at a pose, is too near to anything but the target."""
        if self._corner_in_a_box(world_T_tcp):
            return True
        request, result = coal.CollisionRequest(), coal.CollisionResult()
        for geometry, tcp_T_part in self._parts:
            placed = _coal_transform(world_T_tcp @ tcp_T_part)
            for solid, at, margin in self._solids:
                request.security_margin = margin
                result.clear()
                if coal.collide(geometry, placed, solid, at, request, result):
                    return True
        return False

    def _corner_in_a_box(self, world_T_tcp: Transform) -> bool:
        """A tenth of the time of asking Coal, and most hands that do not fit are in a table."""
        corners = self._corners @ world_T_tcp[:3, :3].T + world_T_tcp[:3, 3]
        return any(
            bool(np.any(np.all(np.abs((corners - pose[:3, 3]) @ pose[:3, :3]) < reach, axis=1)))
            for pose, reach in self._boxes
        )

    def clearance_m(self, world_T_tcp: Transform, enough_m: float) -> float:
        """Room between the open hand and everything but the target, beyond the margins.

        No more than ``enough_m`` is measured; 0 or less means that ``collides`` is true.
        """
        request, result = coal.DistanceRequest(), coal.DistanceResult()
        room = enough_m
        for geometry, tcp_T_part in self._parts:
            placed = _coal_transform(world_T_tcp @ tcp_T_part)
            for solid, at, margin in self._solids:
                result.clear()
                distance = float(coal.distance(geometry, placed, solid, at, request, result))
                room = min(room, distance - margin)
                if room <= 0.0:
                    return room
        return room


def _coal_transform(pose: Transform) -> coal.Transform3s:
    return coal.Transform3s(pose[:3, :3], pose[:3, 3])
