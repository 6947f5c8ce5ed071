"""Choose where to stand to see what is behind something tall."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import top_m
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.furniture_pieces import are_one_piece
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.readings.odometry import feet_pose
from trees.skills.walking.reachable_standing import Stand
from trees.skills.walking.walking_room import room_if_it_walks

_TALL_M = 1.2
"""Over what is lower a standing robot sees."""
_WIDEST_M = 2.0
"""What is wider is a wall: what is behind it is another room."""
_BESIDE_M = 1.0
_BEHIND_M = 1.5
"""So far behind it the robot looks from beside it."""
_FARTHEST_M = 6.0
_CONFIDENCE = 0.5


class ChooseOutlook(Leaf):
    """Choose a place beside the nearest tall thing from where the robot can see what is behind it.

    Tall things that it has looked behind are left out.
    """

    ASKS = True
    NONE_LEFT = Reason.NO_OUTLOOKS_LEFT
    INPUT_PORTS = ports(hiding_before=optional(tuple))
    OUTPUT_PORTS = ports(hides=Place, outlook=Stand, hiding=tuple)
    CONTRACT = Contract(
        precondition="something is looked for",
        postcondition="a place with room to turn beside something tall, which is noted as looked behind",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look through what is known."""
        toolbox = self.toolbox
        room = room_if_it_walks(toolbox)
        if room is None:
            message = f"{toolbox.model.description.name} cannot walk here"
            return Failure.infeasible(message).because(Reason.CANNOT_WALK)
        scene, body = toolbox.world.scene, feet_pose(toolbox)
        done: tuple[str, ...] = self.optional("hiding_before") or ()
        for piece in _tall_pieces(scene, body):
            if any(part.name in done for part in piece):
                continue
            free = (stand for stand in _beside(piece, body) if room.tightest(scene, stand).lack_m <= 0.0)
            stand = next(free, None)
            if stand is not None:
                first = piece[0]
                place = Place(first.name, "furniture", first.shape, first.world_T_object, _CONFIDENCE)
                self._set_output("hides", place)
                self._set_output("outlook", Stand.beside(place, stand))
                self._set_output("hiding", (*done, *(part.name for part in piece)))
                self.feedback_message = f"behind the {kind_of(first.name)}"
                return DONE
        return Failure.postcondition("nothing tall is left to look behind").because(self.NONE_LEFT)


def _tall_pieces(scene: PlanningScene, body: PlanarPose) -> list[list[SceneObject]]:
    """The parts of each tall thing, the nearest thing first; boards and sides of one have the same kind."""
    tall = [
        item
        for item in scene.objects.values()
        if not item.movable and isinstance(item.shape, Box) and top_m(item) >= _TALL_M
    ]
    pieces: list[list[SceneObject]] = []
    for item in sorted(tall, key=lambda one: _away_m(one, body)):
        same = (piece for piece in pieces if are_one_piece(piece[0], item))
        piece = next(same, None)
        if piece is not None:
            piece.append(item)
        elif _away_m(item, body) <= _FARTHEST_M:
            pieces.append([item])
    return pieces


def _away_m(item: SceneObject, body: PlanarPose) -> float:
    return math.hypot(item.world_T_object[0, 3] - body.x_m, item.world_T_object[1, 3] - body.y_m)


def _beside(piece: Sequence[SceneObject], body: PlanarPose) -> Iterator[PlanarPose]:
    """Places level with a thing to its left and right as it is seen from here, the nearer one first."""
    middle = np.mean([part.world_T_object[:2, 3] for part in piece], axis=0)
    ahead = PlanarPose(body.x_m, body.y_m, math.atan2(middle[1] - body.y_m, middle[0] - body.x_m))
    corners = np.array([(seen.x_m, seen.y_m) for part in piece for seen in _corners(part, ahead)])
    (near, right), (far, left) = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    if left - right > _WIDEST_M:
        return
    deep, behind = 0.5 * (near + far), far + _BEHIND_M
    for aside in sorted((left + _BESIDE_M, right - _BESIDE_M), key=abs):
        facing = math.atan2(0.5 * (left + right) - aside, behind - deep)
        yield ahead @ PlanarPose(deep, aside, facing)


def _corners(part: SceneObject, ahead: PlanarPose) -> Iterator[PlanarPose]:
    """The corners of a box on the floor, as seen from a pose."""
    half = 0.5 * np.asarray(part.shape.size_m if isinstance(part.shape, Box) else (0.0, 0.0, 0.0))
    for signs in itertools.product((-1.0, 1.0), repeat=2):
        corner = part.world_T_object @ poses.translation(signs[0] * half[0], signs[1] * half[1], 0.0)
        yield ahead.to(PlanarPose(float(corner[0, 3]), float(corner[1, 3])))
