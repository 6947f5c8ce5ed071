"""The room in an open drawer, as far as looks have shown it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from kinematics.requests.place import Spot
from kinematics.scene.free_spots import footprint_radius_m
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import half_height_m, top_m
from robots.scenes.articulated import DRAWER, DRAWER_BOTTOM, DRAWER_WALL
from trees.beliefs.openings.handles import BODY_OF, without_inside
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure

LEAST_OPEN_M = 0.05
"""A drawer whose front is nearer than this to what it closes is shut, as far as a look can tell."""
_ROOM_M = 0.02
"""Left between an object and what is around it: errors of both."""
# Of an object's foot above the bottom, the lowest first: the hand has to stay above front and walls.
_HEIGHTS_M = (0.005, 0.02, 0.04, 0.06, 0.08, 0.10, 0.12, 0.14)
_SHARES = (0.0, 0.6, -0.6)
_CLEAR_M = 0.03
"""An object's foot passes so far above the front on its way in."""


@dataclass(frozen=True, slots=True)
class DrawerInside(Sealed):
    """The room inside an open drawer that can be reached from above.

    Attributes:
        odom_T_middle: Frame in the middle of its bottom's upper face, x into the furniture, shape (4, 4).
        size_m: Along x, across, and from the bottom up to the upper edge of the front.
        solids: Names in the planning scene of what is around it; what is put in may touch these.
    """

    odom_T_middle: Transform
    size_m: tuple[float, float, float]
    solids: tuple[str, ...]

    def holds(self, place: NDArray[np.float64]) -> bool:
        """Tell whether the middle of a thing, in the odometry frame, shape (3,), is in there."""
        x, y, z = (poses.inverse(self.odom_T_middle) @ np.append(place, 1.0))[:3]
        length, width, height = self.size_m
        return bool(abs(x) <= 0.5 * length and abs(y) <= 0.5 * width and 0.0 <= z <= height)


def inside_of_drawer(scene: PlanningScene) -> DrawerInside | Failure:
    """Measure the only drawer that is known; why not, when it is shut or was never seen from above."""
    front = _first(scene, DRAWER)
    bodies = [item for item in _all(scene, BODY_OF[DRAWER]) if isinstance(item.shape, Box)]
    if front is None or not bodies or not isinstance(front.shape, Box):
        return Failure.postcondition("no drawer seen")
    bottom, walls = _first(scene, DRAWER_BOTTOM), _all(scene, DRAWER_WALL)
    frame = front.world_T_object if bottom is None else bottom.world_T_object
    upright = poses.transform(poses.rotation_z(poses.yaw_of(frame[:3, :3])), frame[:3, 3])
    local_T_odom = poses.inverse(upright)
    floor_m = float(frame[2, 3]) + (0.0 if bottom is None else half_height_m(bottom))
    # what covers it: the body's parts that reach above the bottom, from their front edge on
    edges = [
        float((local_T_odom @ item.world_T_object)[0, 3]) - 0.5 * item.shape.size_m[0]
        for item in bodies
        if isinstance(item.shape, Box)
        and float(item.world_T_object[2, 3]) + half_height_m(item) > floor_m + _CLEAR_M
    ]
    begins = float((local_T_odom @ front.world_T_object)[0, 3]) + 0.5 * front.shape.size_m[0]
    length = min(edges, default=begins) - begins
    if length < LEAST_OPEN_M:
        return Failure.infeasible(
            "the drawer is shut: open it first ('open the drawer and put ... in it')",
            open_m=round(max(0.0, length), 3),
        )
    if bottom is None or not isinstance(bottom.shape, Box):
        return Failure.postcondition("the inside of the drawer is not seen")
    width = bottom.shape.size_m[1] - 2.0 * max(
        (min(wall.shape.size_m[:2]) for wall in walls if isinstance(wall.shape, Box)), default=0.0
    )
    height = top_m(front) - floor_m
    middle = upright @ poses.translation(begins + 0.5 * length, 0.0, 0.0)
    middle[2, 3] = floor_m
    around = (bottom.name, front.name, *(wall.name for wall in walls))
    return DrawerInside(middle, (length, width, height), around)


def without_drawn(scene: PlanningScene) -> PlanningScene:
    """A scene without what goes along with a drawer's front: its inside, and what stands in it."""
    inside = inside_of_drawer(scene)
    bare = without_inside(scene)
    if isinstance(inside, Failure):
        return bare
    for name, item in list(bare.objects.items()):
        if item.movable and inside.holds(item.world_T_object[:3, 3]):
            bare = bare.without_object(name)
    return bare


def spots_in_drawer(held: HeldObject, inside: DrawerInside) -> tuple[Spot, ...]:
    """Where the foot of a held object can go, the lowest first; none when it is too wide."""
    radius = footprint_radius_m(held.shape)
    room = 0.5 * np.array(inside.size_m[:2]) - radius - _ROOM_M
    if float(room.min()) < 0.0:
        return ()
    spots = []
    for foot_m in _HEIGHTS_M:
        for along in _SHARES:
            for across in _SHARES:
                local = (along * room[0], across * room[1], foot_m + 0.5 * held.shape.height_m)
                place = (inside.odom_T_middle @ np.append(local, 1.0))[:3]
                pose = poses.transform(np.eye(3), place)
                hover_m = max(_CLEAR_M, inside.size_m[2] - foot_m + _CLEAR_M)
                spots.append(Spot(pose, inside.solids, hover_m=hover_m, below_m=0.0))
    return tuple(spots)


def _all(scene: PlanningScene, kind: str) -> list[SceneObject]:
    return [
        item for name, item in sorted(scene.objects.items()) if not item.movable and kind_of(name) == kind
    ]


def _first(scene: PlanningScene, kind: str) -> SceneObject | None:
    found = _all(scene, kind)
    return found[0] if found else None
