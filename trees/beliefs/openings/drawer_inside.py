"""The room in an open drawer, or in another named part of furniture, as far as looks have shown it."""

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
_PLATE_M = 0.005
"""What is thicker is no floor of a named region."""
_WALL_NEAR_M = 0.02
"""A wall begins so near to the floor's edge."""
_CLEAR_M = 0.03
"""An object's foot passes so far above the front on its way in."""


@dataclass(frozen=True, slots=True)
class DrawerInside(Sealed):
    """The room inside an open drawer, or a compartment, that can be reached from above.

    Attributes:
        odom_T_middle: Frame in the middle of its bottom's upper face, x into the furniture, shape (4, 4).
        size_m: Along x, across, and from the bottom up to the upper edge of the front.
        solids: Names in the planning scene of what is around it; what is put in may touch these.
    """

    odom_T_middle: Transform
    size_m: tuple[float, float, float]
    solids: tuple[str, ...]

    @property
    def rim_m(self) -> float:
        """Height of the upper edge of what is around it, odometry frame."""
        return float(self.odom_T_middle[2, 3]) + self.size_m[2]

    def holds(self, place: NDArray[np.float64]) -> bool:
        """Tell whether the middle of a thing, in the odometry frame, shape (3,), is in there."""
        x, y, z = (poses.inverse(self.odom_T_middle) @ np.append(place, 1.0))[:3]
        length, width, height = self.size_m
        return bool(abs(x) <= 0.5 * length and abs(y) <= 0.5 * width and 0.0 <= z <= height)


def inside_of_drawer(scene: PlanningScene, named: str = "") -> DrawerInside | Failure:
    """Measure a drawer that is known; why not, when it is shut or was never seen from above.

    Args:
        scene: What is believed.
        named: Name of its front; of several the one that is open the farthest, where it says none.
    """
    front = _front_of(scene, named)
    if front is None or not isinstance(front.shape, Box):
        return Failure.postcondition("no drawer seen")
    bodies = [item for item in _bodies_of(front, scene) if isinstance(item.shape, Box)]
    if not bodies:
        return Failure.postcondition("no drawer seen")
    bottom = next(iter(_parts_of(front, scene, DRAWER_BOTTOM)), None)
    walls = _parts_of(front, scene, DRAWER_WALL)
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


def inside_of_region(name: str, scene: PlanningScene) -> DrawerInside | Failure:
    """Measure a part of furniture that has a name and walls around it; why not, when it has none.

    Args:
        name: Of its floor, in the scene: a thin plate.
        scene: What is believed; the walls are the solids of furniture beside that plate.
    """
    floor, words = scene.objects[name], kind_of(name)
    if floor.movable or not isinstance(floor.shape, Box) or floor.shape.height_m > _PLATE_M:
        return Failure.infeasible(f"nothing can be put into the {words}")
    floor_m, half = top_m(floor), 0.5 * np.array(floor.shape.size_m[:2]) + _WALL_NEAR_M
    walls = [
        item
        for item in scene.objects.values()
        if not item.movable
        and top_m(item) > floor_m + _CLEAR_M
        and top_m(item) - 2.0 * half_height_m(item) < floor_m + _CLEAR_M
        and _is_beside(item, floor, half)
    ]
    if not walls:
        message = f"the {words} has no walls around it: say to put it on the {words}"
        return Failure.infeasible(message)
    below = [
        item.name
        for item in scene.objects.values()
        if not item.movable and abs(top_m(item) - floor_m) < _CLEAR_M and _is_beside(item, floor, half)
    ]
    middle = poses.transform(
        poses.rotation_z(poses.yaw_of(floor.world_T_object[:3, :3])), (*floor.world_T_object[:2, 3], floor_m)
    )
    size = (floor.shape.size_m[0], floor.shape.size_m[1], max(map(top_m, walls)) - floor_m)
    around = sorted({name, *(wall.name for wall in walls), *below})
    return DrawerInside(middle, size, tuple(around))


def _is_beside(item: SceneObject, floor: SceneObject, half_m: NDArray[np.float64]) -> bool:
    """Whether a solid reaches over a floor, shape (2,) to either side of its middle, along the floor."""
    if not isinstance(item.shape, Box):
        return False
    corners = np.array([[x, y, 0.0, 1.0] for x in (-0.5, 0.5) for y in (-0.5, 0.5)])
    corners[:, :2] *= item.shape.size_m[:2]
    local = corners @ (poses.inverse(floor.world_T_object) @ item.world_T_object).T
    low, high = local[:, :2].min(axis=0), local[:, :2].max(axis=0)
    return bool(np.all(low <= half_m) and np.all(high >= -half_m))


def without_drawn(scene: PlanningScene, named: str = "") -> PlanningScene:
    """A scene without what goes along with a drawer's front: its inside, and what stands in it.

    Args:
        scene: What is believed.
        named: As above.
    """
    inside = inside_of_drawer(scene, named)
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
    for foot_m in (height for height in _HEIGHTS_M if height < inside.size_m[2]):
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


def _front_of(scene: PlanningScene, named: str) -> SceneObject | None:
    """The front of that name; else of several with a model the farthest open one, or the first."""
    fronts = {item.name: item for item in _all(scene, DRAWER)}
    if named in fronts:
        return fronts[named]
    return max(fronts.values(), key=_open_m, default=None)


def _open_m(front: SceneObject) -> float:
    """How far a model tells that a drawer is open; 0 where none does."""
    if front.moves is None:
        return 0.0
    return max(0.0, -float((poses.inverse(front.moves.shut) @ front.world_T_object)[0, 3]))


def _bodies_of(front: SceneObject, scene: PlanningScene) -> list[SceneObject]:
    """What a drawer is in: the piece that its model says, else all chests."""
    return _all(scene, BODY_OF[DRAWER] if front.moves is None else front.moves.of)


def _parts_of(front: SceneObject, scene: PlanningScene, kind: str) -> list[SceneObject]:
    """The solids of a kind that go with a front."""
    if front.moves is None:
        return [item for item in _all(scene, kind) if item.moves is None]
    own = front.moves
    return [item for item in _all(scene, kind) if item.moves is not None and item.moves.is_of(own)]
