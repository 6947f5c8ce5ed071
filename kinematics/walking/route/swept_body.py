"""Where a robot that walks comes to what is believed to be around, every link and everything that it holds.

The body goes over the floor as it stands, arms wherever they are; a walk sways it from side to side. A range
sensor looks over and under the board of a table: what is known counts whether it is seen just now or not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import coal
import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.distance.link_solids import coal_solids
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.planning_scene import PlanningScene, SceneObject

_ALONG_M = 0.02
"""Of the sway, along the way and downwards: the CoM goes from foot to foot, hardly ahead and hardly down."""
_NEARER_M = 0.01
"""What comes no nearer than this goes away from it, or along it."""
_Kind = Literal["arm", "leg", "body"]


@dataclass(frozen=True, slots=True)
class Meeting:
    """What of the robot would come to what.

    Attributes:
        part: Of the robot, as people call it.
        item: What is there, by its name.
        distance_m: How near it would come.
    """

    part: str
    item: str
    distance_m: float


@dataclass(frozen=True, slots=True)
class _Part:
    called: str
    solid: coal.CollisionGeometry
    world_T_solid: Array
    middle_m: Array
    radius_m: float
    kind: _Kind


class SweptBody:
    """A robot as it stands, to be moved over the floor as one piece.

    Args:
        model: The robot.
        q: Configuration, shape (nq,), in the scene's frame.
        scene: What is believed, and what is held.
        settings: How far a walk sways.
    """

    def __init__(self, model: RobotModel, q: Array, scene: PlanningScene, settings: WalkingSettings) -> None:
        self._items = tuple(scene.objects.values())
        self._solids = {item.name: coal_solids(item.shape) for item in self._items}
        self._sway_m = settings.sway_m
        yaw = poses.yaw_of(poses.rotation_from_quaternion(q[3:7]))
        self._base = PlanarPose(float(q[0]), float(q[1]), yaw).transform()
        self._parts = (*_links(model, q), *_held(model, q, scene))
        self._middles_m = np.array([[*part.middle_m, 1.0] for part in self._parts])
        self._radii_m = np.array([part.radius_m for part in self._parts])

    def meets(self, way: Sequence[PlanarPose]) -> Meeting | None:
        """What the robot would come to on a way; None where it has room, or only goes away.

        Args:
            way: Where the base comes by, seen from where it is; the first is where it is.
        """
        aside_m = self._sway_m - _ALONG_M
        found = [
            meeting
            for side in (0.0, -1.0, 1.0)
            for meeting in self._meetings(self._moved(way, side * aside_m), is_aside=side != 0.0)
        ]
        return min(found, key=lambda one: one.distance_m, default=None)

    def _meetings(self, moved: Array, *, is_aside: bool) -> Iterator[Meeting]:
        """All that parts come to on a way, shape (n, 4, 4), swayed aside or not."""
        for item in self._items:
            gaps_m = self._gaps_m(item, moved)
            for k, part in enumerate(self._parts):
                if part.kind == "leg" and is_aside:
                    continue  # a leg steps out ahead, and hardly sways beside the feet
                kept_m = item.margin_m + (self._sway_m if part.kind == "leg" else _ALONG_M)
                close = moved[gaps_m[:, k] < kept_m]
                met = self._nearest(part, item, moved[0], close, kept_m) if len(close) else None
                if met is not None:
                    yield met

    def _nearest(
        self, part: _Part, item: SceneObject, first: Array, close: Array, kept_m: float
    ) -> Meeting | None:
        """How near a part comes to a thing; None where that is far enough, or it only goes away."""
        begins_m = self._distance_m(part, item, first)
        if begins_m <= 0.0 and part.kind == "arm":  # what is beside an arm sways into it, wherever it goes
            return Meeting(part.called, item.name, begins_m)
        most_m = min(kept_m, begins_m - _NEARER_M)
        nearest_m = min(self._distance_m(part, item, there) for there in close)
        return Meeting(part.called, item.name, nearest_m) if nearest_m < most_m else None

    def _moved(self, way: Sequence[PlanarPose], aside_m: float) -> Array:
        """How the world as the base sees it goes with it along a way, swayed aside, shape (n, 4, 4)."""
        back, sway = poses.inverse(self._base), poses.translation(0.0, aside_m, 0.0)
        return np.array([self._base @ place.transform() @ sway @ back for place in way])

    def _gaps_m(self, item: SceneObject, moved: Array) -> Array:
        """At least how far parts are from a thing, shape (places, parts): from ball to box."""
        shape, pose = item.shape, item.world_T_object
        if isinstance(shape, Box):
            half = 0.5 * np.array(shape.size_m)
        else:
            half = np.array([shape.radius_m, shape.radius_m, 0.5 * shape.height_m])
        middles_m = np.einsum("nij,kj->nki", moved, self._middles_m)[..., :3]
        outside = np.maximum(np.abs((middles_m - pose[:3, 3]) @ pose[:3, :3]) - half, 0.0)
        return np.asarray(np.sqrt(np.sum(outside**2, axis=2)) - self._radii_m)

    def _distance_m(self, part: _Part, item: SceneObject, moved: Array) -> float:
        at, pose = moved @ part.world_T_solid, item.world_T_object
        here = coal.Transform3s(at[:3, :3], at[:3, 3])
        there = coal.Transform3s(pose[:3, :3], pose[:3, 3])
        request = coal.DistanceRequest()
        return min(
            float(coal.distance(part.solid, here, solid, there, request, coal.DistanceResult()))
            for solid in self._solids[item.name]
        )


def _links(model: RobotModel, q: Array) -> list[_Part]:
    geometry, data = model.geometry(), model.pin.createData()
    placed = geometry.createData()
    pin.updateGeometryPlacements(model.pin, data, geometry, placed, q)
    description = model.description
    called = {
        link: f"the {hand} hand" for hand, one in description.grippers.items() for link in one.touch_links
    }
    groups = {f"{hand}_arm": f"the {hand} arm" for hand in description.hands}
    groups |= {"left_leg": "a leg", "right_leg": "a leg"}
    of_joint = {joint: name for group, name in groups.items() for joint in description.groups.get(group, ())}
    parts = []
    for item, at in zip(geometry.geometryObjects, placed.oMg, strict=True):
        name = called.get(model.link_of(item)) or of_joint.get(model.pin.names[item.parentJoint], "the body")
        kind: _Kind = "leg" if name == "a leg" else "body" if name == "the body" else "arm"
        middle = at.act(np.array(item.geometry.aabb_center))
        radius_m = float(item.geometry.aabb_radius)
        parts.append(_Part(name, item.geometry, at.homogeneous.copy(), middle, radius_m, kind))
    return parts


def _held(model: RobotModel, q: Array, scene: PlanningScene) -> list[_Part]:
    parts = []
    for held in scene.attached.values():
        at = model.frame_pose(q, held.frame) @ held.frame_T_object
        for solid in coal_solids(held.body.shape):
            solid.computeLocalAABB()
            middle = at[:3, :3] @ np.array(solid.aabb_center) + at[:3, 3]
            called = f"the {held.body.name} in its hand"
            parts.append(_Part(called, solid, at, middle, float(solid.aabb_radius), "arm"))
    return parts
