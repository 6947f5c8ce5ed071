"""Places to stand from which an object may be within reach; the planner says which of them are."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.model.stance import Stance
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.line_of_sight import hidden
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import half_height_m
from kinematics.walking.route.path_planning import Footprint
from trees.beliefs.grounding.destination import Place

_AHEAD_M = (0.0, -0.1, 0.1, -0.2)
_ASIDE_M = tuple(0.1 * k for k in range(-8, 9))
TURNED_RAD = (0.0, 0.3, -0.3, 0.6, -0.6)
_TURN_COST_M = 0.25
"""A turn of 1 rad is as bad as so many metres beside the usual place."""
_FARTHEST_M = 1.15
"""Of the object from the middle between the feet."""
_REACH_COST_M = 0.5
"""Where the hand gets there in none of the directions is as bad as so far beside the usual place."""
_SEEN_ASIDE_RAD = 1.2
"""The head turns so far that what is in this direction is well inside the picture."""
EYE_AHEAD_M = 0.12
"""Of the eyes from the middle between the feet."""
_SEEN_WIDER = 1.5
"""The edges of a cylinder so much wider than the object are seen: nobody stands exactly, or sees exactly."""
_SPARE_M = 0.06
"""Left between the body of the home posture and what stands about: swaying, and the errors of sight."""
_APPROACH_M = 0.45
"""The last stretch is walked straight ahead, with the arms of the home posture."""
_STEP_M = 0.08
_ELSEWHERE_M = 0.1
"""Farther apart are not two sightings of the same edge, but two sides of a table."""


@dataclass(frozen=True, slots=True)
class Stand:
    """Where to stand for one thing, in relation to that thing.

    It stays right when the thing is seen again in a slightly different place.

    Attributes:
        name: Name of the thing in the planning scene.
        x_m, y_m: From the thing to the middle between the feet, along the axes of the odometry frame.
        yaw_rad: Heading, in the odometry frame.
        usual_T_stand: The same from the place where one usually stands for the thing, which is known better
            once the robot is near.
    """

    name: str
    x_m: float
    y_m: float
    yaw_rad: float
    usual_T_stand: PlanarPose | None = None

    @classmethod
    def beside(cls, place: Place, body: PlanarPose, usual: PlanarPose | None = None) -> Stand:
        """A pose of the body as a stand for a place."""
        x, y = (float(value) for value in place.odom_T_place[:2, 3])
        apart = None if usual is None else usual.to(body)
        return cls(place.name, body.x_m - x, body.y_m - y, body.yaw_rad, apart)

    def body(self, place: Place) -> PlanarPose:
        """The pose of the body, in the odometry frame, for the place as it is seen now."""
        x, y = (float(value) for value in place.odom_T_place[:2, 3])
        return PlanarPose(x + self.x_m, y + self.y_m, self.yaw_rad)

    def seen_again(self, place: Place, usual: PlanarPose) -> PlanarPose:
        """The same where what the thing stands on was found to be a little elsewhere, too.

        Args:
            place: As it is seen now.
            usual: Where one usually stands for it, as that is seen now.
        """
        body = self.body(place)
        if self.usual_T_stand is None:
            return body
        beside = usual @ self.usual_T_stand
        return beside if beside.distance_m(body) < _ELSEWHERE_M else body


def places_about(
    usual: PlanarPose,
    thing_m: tuple[float, float],
    turned_rad: Sequence[float] = TURNED_RAD,
    reach: Callable[[PlanarPose], float] | None = None,
) -> list[PlanarPose]:
    """Poses of the body around the usual one, the most promising first, whether there is room or not.

    Those are near to the usual one, and the hands get to the object from them in many directions.

    Args:
        usual: Where one would stand without knowing better.
        thing_m: Where the object is, on the floor.
        turned_rad: How far it may be turned out of the usual heading.
        reach: The share of directions in which a hand gets to the object from a pose. Left out, all poses
            count alike.
    """
    ways = [(way, usual @ PlanarPose(*way)) for way in product(_AHEAD_M, _ASIDE_M, turned_rad)]
    near = [
        (way, body)
        for way, body in ways
        if math.hypot(thing_m[0] - body.x_m, thing_m[1] - body.y_m) <= _FARTHEST_M
    ]
    ranked = sorted(
        ((_cost(way, 1.0 if reach is None else reach(body)), body) for way, body in near),
        key=lambda one: one[0],
    )
    return [body for _, body in ranked]


class StandingRoom:
    """Tells where the robot has room to stand."""

    def __init__(
        self,
        usual: PlanarPose,
        obstacles: Sequence[Footprint],
        tall: Sequence[Footprint],
        settings: WalkingSettings,
    ) -> None:
        """Keep what is around.

        Args:
            usual: Where one would stand without knowing better; it keeps its own distance from what is low.
            obstacles: Everything that stands about.
            tall: What of it is as tall as the hands of the home posture.
            settings: The robot's sizes.
        """
        self._usual, self._obstacles, self._tall = usual, obstacles, tall
        self._low = _inside(settings, settings.half_width_m)
        self._high = _inside(settings, settings.hands_half_width_m)

    def has(self, body: PlanarPose) -> bool:
        """Whether there is room at a pose."""
        return _is_free(body, self._high, self._tall) and (
            body == self._usual or _is_free(body, self._low, self._obstacles)
        )


def stands_free(body: PlanarPose, tall: Sequence[Footprint], settings: WalkingSettings) -> bool:
    """Whether the arms of the home posture have room at a pose, and on the last stretch to it."""
    return _is_free(body, _inside(settings, settings.hands_half_width_m), tall)


def sees(body: PlanarPose, eye_m: float, item: SceneObject, scene: PlanningScene) -> bool:
    """Whether an object would be in sight from a pose of the body, with nothing between.

    Args:
        body: The pose.
        eye_m: Height of the camera.
        item: The object.
        scene: What may hide it.
    """
    x, y, z = (float(value) for value in item.world_T_object[:3, 3])
    eye = body @ PlanarPose(EYE_AHEAD_M)
    bearing = PlanarPose(eye.x_m, eye.y_m, body.yaw_rad).to(PlanarPose(x, y))
    if abs(math.atan2(bearing.y_m, bearing.x_m)) > _SEEN_ASIDE_RAD:
        return False
    half_m = half_height_m(item)
    radius_m = _SEEN_WIDER * getattr(item.shape, "radius_m", half_m)
    across = math.atan2(y - eye.y_m, x - eye.x_m) + 0.5 * math.pi
    points = [
        (x + side * radius_m * math.cos(across), y + side * radius_m * math.sin(across), z + up * half_m)
        for side in (-1.0, 0.0, 1.0)
        for up in (-0.5, 0.0, 0.9)
    ]
    others = [other for name, other in scene.objects.items() if name != item.name]
    return not hidden(np.array([eye.x_m, eye.y_m, eye_m]), np.array(points), others).any()


def stance_of(stance: Stance, here: PlanarPose, there: PlanarPose) -> Stance:
    """The feet as they stand, moved along with the body from one pose to another."""
    moved = (there @ here.inverse()).transform()
    return Stance(tuple((frame, moved @ sole) for frame, sole in stance.soles))


def _cost(way: tuple[float, float, float], share: float) -> tuple[float, float, float, float]:
    ahead_m, aside_m, turned_rad = way
    beside_m = abs(ahead_m) + abs(aside_m) + _TURN_COST_M * abs(turned_rad)
    return (beside_m + _REACH_COST_M * (1.0 - share), *way)


def _inside(settings: WalkingSettings, half_width_m: float) -> Array:
    """Points all over the room that a robot takes, and took on its last stretch, shape (n, 2)."""
    back_m = -settings.back_m - _APPROACH_M
    x = np.linspace(back_m, settings.front_m, math.ceil((settings.front_m - back_m) / _STEP_M))
    y = np.linspace(-half_width_m, half_width_m, math.ceil(2.0 * half_width_m / _STEP_M))
    return np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)


def _is_free(body: PlanarPose, points: Array, obstacles: Sequence[Footprint]) -> bool:
    c, s = math.cos(body.yaw_rad), math.sin(body.yaw_rad)
    turned = points @ np.array([[c, s], [-s, c]]) + (body.x_m, body.y_m)
    return all(float(one.distance_m(turned).min()) > _SPARE_M for one in obstacles)


def posture_at(q: Array, here: PlanarPose, there: PlanarPose) -> Array:
    """A configuration, shape (nq,), with its base carried from one place on the floor to another."""
    odom_T_base = poses.transform(poses.rotation_from_quaternion(q[3:7]), q[:3])
    moved = (there @ here.inverse()).transform() @ odom_T_base
    return np.concatenate([moved[:3, 3], poses.quaternion_from_rotation(moved[:3, :3]), q[7:]])
