"""Where on a table something is "in front of Ben": a spot near somebody who stands at it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.scene.free_spots import FreeSpot, footprint_radius_m, spots_on
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.grounding.destination import person_meant
from trees.beliefs.grounding.grounding import Ambiguous, Found
from trees.beliefs.grounding.questions import OTHER, which_is_meant
from trees.beliefs.scene.believed_thing import PERSON, Surroundings
from trees.beliefs.sight.sight_of_tops import SightOfTops
from trees.failures import Failure
from trees.tasks import Destination, ObjectDescription

_WITHIN_M = 0.95
"""From the middle of somebody: so far people get to a thing on a table without a step."""
_OFF_RAD = math.radians(40)
"""From the direction that was named, as for things."""
_NEARER_TO_PERSON = 1.5
"""What a metre nearer to the person is worth, in metres nearer to where the hand puts things down easily."""


def person_compared_with(
    to: Destination, scene: PlanningScene, around: Surroundings
) -> SceneObject | Failure | None:
    """Who a relation compares with; None where that is no person who was seen.

    Args:
        to: What is compared with; "me" is the nearest person.
        scene: What is believed to be around.
        around: The same from where the robot stands.
    """
    people = [thing for thing in around.things if thing.is_person]
    if to == "me":
        people.sort(key=lambda thing: thing.distance_m)
        return scene.objects[people[0].name] if people else Failure.postcondition("no person seen")
    if isinstance(to, str):
        named = [thing.name for thing in people if thing.name.casefold() == to.casefold()]
        return scene.objects[named[0]] if named else None
    if not isinstance(to, ObjectDescription) or to.kind != PERSON or to.name:
        return None
    match person_meant(to, around):
        case Found(names):
            return scene.objects[names[0]]
        case Ambiguous() as unclear:
            return which_is_meant(unclear, OTHER)
        case missing:
            return Failure.postcondition(missing.message)


def spots_by_person(
    person: SceneObject,
    tops: Sequence[SceneObject],
    angles_rad: Sequence[float],
    shape: Shape,
    scene: PlanningScene,
    odom_T_base: Transform,
    wish: Callable[[Array], float],
    sight: SightOfTops,
) -> tuple[SceneObject, list[FreeSpot]] | None:
    """Free spots by somebody, on the top where the best of them is; None where there is none.

    Args:
        person: Who.
        tops: What things are put on.
        angles_rad: Directions from the person that are meant, from where the robot looks to.
        shape: What is put there.
        scene: What is believed to be around.
        odom_T_base: Pose of the robot's base, shape (4, 4).
        wish: Cost of a place, shape (3,): how hard it is for the hand.
        sight: What has been looked at.
    """
    middle, heading = person.world_T_object[:2, 3], poses.yaw_of(odom_T_base[:3, :3])
    radius = footprint_radius_m(shape)

    def cost(place: Array) -> float:
        return wish(place) + _NEARER_TO_PERSON * float(np.linalg.norm(place[:2] - middle))

    def is_by(place: Array) -> bool:
        away = place[:2] - middle
        direction = math.atan2(away[1], away[0]) - heading
        off = min(abs(math.remainder(direction - angle, 2.0 * math.pi)) for angle in angles_rad)
        return off <= _OFF_RAD and float(np.linalg.norm(away)) <= _WITHIN_M

    def spots_of(top: SceneObject) -> list[FreeSpot]:
        seen = sight.about(top, radius, odom_T_base)
        return spots_on(top, scene, radius, cost, lambda place: is_by(place) and seen(place))

    found = [(top, spots) for top in tops if (spots := spots_of(top))]
    return min(found, key=lambda one: (one[1][0].cost, one[0].name), default=None)
