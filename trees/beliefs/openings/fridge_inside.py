"""The boards behind an open door, and the room on them, as far as looks have shown it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import Hand
from kinematics.requests.place import Spot
from kinematics.scene.free_spots import EDGE_M, GAP_M, footprint_radius_m
from kinematics.scene.line_of_sight import hidden
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import top_m
from robots.scenes.articulated import DOOR
from trees.beliefs.openings.handles import BODY_OF, MEANT_BY
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.scene.scene_update import kind_of
from trees.beliefs.sight.sight_of_tops import ABOVE_M, SightOfTops, is_over
from trees.failures import Failure
from trees.tasks import Destination, ObjectDescription

LEAST_OPEN_RAD = math.radians(60.0)
"""A door that is less open leaves no way for an arm beside it."""
_BOARD_M = 0.05
"""Boards are no thicker, and no smaller than the next one either way."""
_LEAST_BOARD_M = 0.2
_TOP_M = 0.05
"""What is so near to the top of everything is no board but the lid."""
_COMFORTABLE_M = 1.1
"""Boards that are about so high are tried first."""
# Of an object's foot from the front edge of a board, beyond what any spot keeps from an edge.
_DEPTHS_M = (0.0, 0.03, 0.06, 0.10, 0.14)
_ASIDE_STEP_M = 0.05
_WALL_M = 0.06
"""Left to the walls beside: half a finger and an error of sight."""
_APART_M = 0.05
_FINGERS_M = 0.05
"""An opening finger sweeps so far beyond the foot of what it lets go."""
_RING = np.array(
    [(math.cos(turn), math.sin(turn), 0.0) for turn in np.linspace(0.0, 2.0 * math.pi, 8, endpoint=False)]
)
"""Directions around a place."""
_MOST = 12


@dataclass(frozen=True, slots=True)
class FridgeInside:
    """The boards inside a piece of furniture whose door is open.

    Attributes:
        boards: The boards that were seen, the most comfortable height first; x of each points inwards.
    """

    boards: tuple[SceneObject, ...]


def is_behind_door(to: Destination | None) -> bool:
    """Whether what something is put into has a door, by its name alone."""
    noun = to.kind if isinstance(to, ObjectDescription) else to
    return isinstance(noun, str) and MEANT_BY.get(noun) == DOOR


def door_opening_rad(scene: PlanningScene) -> float | None:
    """How far the only door that is believed is open; None when it, or what it shuts, was never seen."""
    door, body = _first(scene, DOOR), _first(scene, BODY_OF[DOOR])
    if door is None or body is None:
        return None
    turned = poses.yaw_of(door.world_T_object[:3, :3]) - poses.yaw_of(body.world_T_object[:3, :3])
    return abs(math.remainder(turned, 2.0 * math.pi))


def hinge_hand(scene: PlanningScene) -> Hand | None:
    """The hand on the side of the hinge of who stands before the door that is believed; None without one."""
    door, inside = _first(scene, DOOR), inside_of_fridge(scene)
    if door is None or isinstance(inside, Failure):
        return None
    edge = front_of(inside.boards[0])
    return "left" if float((poses.inverse(edge) @ door.world_T_object)[1, 3]) > 0.0 else "right"


def inside_of_fridge(scene: PlanningScene) -> FridgeInside | Failure:
    """The boards of the fridge that is known; why not, when it is shut or none was seen."""
    opening = door_opening_rad(scene)
    if opening is not None and opening < LEAST_OPEN_RAD:
        return Failure.infeasible(
            "the fridge is shut: open it first ('open the fridge and put ... into it')",
            open_deg=round(math.degrees(opening), 1),
        )
    solids = [item for kind in (DOOR, BODY_OF[DOOR]) for item in _all(scene, kind)]
    highest_m = max((top_m(item) for item in solids), default=0.0)
    boards = [item for item in solids if _is_board(item) and top_m(item) < highest_m - _TOP_M]
    if not boards:
        return Failure.postcondition("the inside of the fridge is not seen")
    boards.sort(key=lambda item: (abs(top_m(item) - _COMFORTABLE_M), item.name))
    return FridgeInside(tuple(boards))


def spots_in_fridge(
    held: HeldObject,
    inside: FridgeInside,
    scene: PlanningScene,
    sight: SightOfTops | None = None,
) -> tuple[Spot, ...]:
    """Where a held object can stand near the front of the boards, the best first.

    Args:
        held: The object.
        inside: The boards.
        scene: What stands on them.
        sight: What has been looked at; None to leave that open.
    """
    spots: list[Spot] = []
    for board in inside.boards:
        chosen: list[Array] = []
        for place in _places(held, board):
            apart = all(math.dist(place, other) >= _APART_M for other in chosen)
            if not apart or not _is_free(place, held, board, scene):
                continue
            if sight is not None and not _were_seen(_about(place, held, board), sight, scene):
                continue
            chosen.append(place)
            up = np.array([0.0, 0.0, 0.5 * held.shape.height_m])
            spots.append(Spot(poses.transform(np.eye(3), place + up), (board.name,)))
            if len(chosen) == _MOST:
                break
    return tuple(spots)


def spots_in_sight(
    spots: tuple[Spot, ...], held: HeldObject, scene: PlanningScene, eye: Array
) -> tuple[Spot, ...]:
    """Those spots on boards all of whose surroundings can be seen from a place, shape (3,)."""
    if not spots:
        return ()
    half = np.array([0.0, 0.0, 0.5 * held.shape.height_m])
    around = [
        _about(spot.world_T_object[:3, 3] - half, held, scene.objects[spot.touches[0]]) for spot in spots
    ]
    covered = hidden(eye, np.concatenate([np.array(points) for points in around]), scene.objects.values())
    ends = np.cumsum([len(points) for points in around])
    parts = np.split(covered, ends[:-1])
    return tuple(spot for spot, part in zip(spots, parts, strict=True) if not part.any())


def front_of(board: SceneObject) -> Transform:
    """The middle of a board's front edge on its upper side, x inwards, shape (4, 4)."""
    size = board.shape.size_m if isinstance(board.shape, Box) else (0.0, 0.0, 0.0)
    turn = poses.rotation_z(poses.yaw_of(board.world_T_object[:3, :3]))
    middle = poses.transform(turn, board.world_T_object[:3, 3])
    return np.asarray(middle @ poses.translation(-0.5 * size[0], 0.0, 0.5 * size[2]))


def _places(held: HeldObject, board: SceneObject) -> list[Array]:
    """On the board's upper side: near the front edge and the middle first."""
    radius = footprint_radius_m(held.shape)
    length, width = board.shape.size_m[:2] if isinstance(board.shape, Box) else (0.0, 0.0)
    aside_m = 0.5 * width - radius - _WALL_M
    if aside_m < 0.0:
        return []
    steps = int(aside_m / _ASIDE_STEP_M)
    sides = [_ASIDE_STEP_M * k for k in range(-steps, steps + 1)]
    depths = [deep for deep in _DEPTHS_M if radius + EDGE_M + deep <= length - radius - EDGE_M]
    grid = sorted(
        ((deep, side) for deep in depths for side in sides),
        key=lambda one: (abs(one[0] - _DEPTHS_M[1]) + 0.3 * abs(one[1]), *one),
    )
    edge = front_of(board)
    return [(edge @ [radius + EDGE_M + deep, side, 0.0, 1.0])[:3] for deep, side in grid]


def _is_free(place: Array, held: HeldObject, board: SceneObject, scene: PlanningScene) -> bool:
    radius = footprint_radius_m(held.shape)
    for item in scene.objects.values():
        above_m = float(item.world_T_object[2, 3]) - top_m(board)
        if not item.movable or not 0.0 <= above_m <= item.shape.height_m + held.shape.height_m:
            continue
        away_m = math.dist(place[:2], item.world_T_object[:2, 3])
        if away_m < radius + footprint_radius_m(item.shape) + GAP_M:
            return False
    return True


def _about(place: Array, held: HeldObject, board: SceneObject) -> list[Array]:
    """Above a place and around it, over the board, shape (3,) each.

    A side wall hides the corner behind it from who stands beside an open door: no more is asked for than the
    fingers need. What an earlier look from the front has shown is in the scene.
    """
    middle = place + np.array([0.0, 0.0, ABOVE_M])
    far_m = footprint_radius_m(held.shape) + _FINGERS_M
    return [middle, *(point for point in middle + far_m * _RING if is_over(board, point))]


def _were_seen(points: list[Array], sight: SightOfTops, scene: PlanningScene) -> bool:
    """Whether each point was in some picture, with nothing of what is known before it."""
    left = np.array(points)
    solids = list(scene.objects.values())
    for glimpse in sight.glimpses:
        if len(left) == 0:
            return True
        shown = np.array([glimpse.shows(sight.camera, point, sight.hidden_m) for point in left])
        inside = np.flatnonzero(shown)
        shown[inside] = ~hidden(glimpse.odom_T_camera[:3, 3], left[inside], solids)
        left = left[~shown]
    return len(left) == 0


def _is_board(item: SceneObject) -> bool:
    if not isinstance(item.shape, Box):
        return False
    x, y, z = item.shape.size_m
    return z <= _BOARD_M and min(x, y) >= _LEAST_BOARD_M


def _all(scene: PlanningScene, kind: str) -> list[SceneObject]:
    return [
        item for name, item in sorted(scene.objects.items()) if not item.movable and kind_of(name) == kind
    ]


def _first(scene: PlanningScene, kind: str) -> SceneObject | None:
    found = _all(scene, kind)
    return found[0] if found else None
