"""Choose a piece of furniture to look at from nearby, where what is looked for may stand."""

from __future__ import annotations

import math

from py_trees.common import Status

from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import top_m
from robots.scenes.articulated import ARTICULATED_KINDS
from trees.beliefs.grounding.destination import Place, aim_of
from trees.beliefs.scene.furniture_pieces import are_one_piece
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.readings.odometry import feet_pose
from trees.skills.walking.standing_place import standing_place
from trees.tasks import ObjectDescription

_LEAST_SIDE_M = 0.3
"""Legs, walls and doors are narrower; nobody puts things there."""
_LOWEST_M, _HIGHEST_M = 0.3, 1.4
_NEARBY_M = 0.8
"""Who stands this near to where one looks from, and faces it, has looked."""
_CONFIDENCE = 0.5


class ChooseFurniture(Leaf):
    """Choose the nearest furniture with a top that the robot has not looked at from nearby.

    Small things on it are not seen from afar.
    """

    ASKS = True
    NONE_LEFT = Reason.NO_FURNITURE_LEFT
    INPUT_PORTS = ports(task=object, visited_before=optional(tuple))
    OUTPUT_PORTS = ports(furniture=Place, visited=tuple)
    CONTRACT = Contract(
        precondition="an object is looked for",
        postcondition="furniture that was seen, with a top that things stand on, and noted as visited",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look through what is known."""
        toolbox = self.toolbox
        aim = aim_of(self.get_input("task"))
        if not isinstance(aim, ObjectDescription) or aim.kind == "person":
            return Failure.postcondition("only things are looked for on furniture").because(self.NONE_LEFT)
        body, gap_m, scene = feet_pose(toolbox), toolbox.policy.support_gap_m, toolbox.world.scene
        visited: tuple[str, ...] = self.optional("visited_before") or ()
        been = [scene.objects[name] for name in visited if name in scene.objects]
        found: list[tuple[float, Place]] = []
        for item in scene.objects.values():
            if not _is_top(item) or any(are_one_piece(item, other) for other in been):
                continue
            place = Place(item.name, "furniture", item.shape, item.world_T_object, _CONFIDENCE)
            there = body.to(standing_place(place, scene, body, gap_m))
            away_m = math.hypot(there.x_m, there.y_m)
            if away_m > _NEARBY_M or abs(there.yaw_rad) > toolbox.policy.beside_rad:
                found.append((away_m, place))
        if not found:
            message = "no furniture is left to look at from nearby"
            return Failure.postcondition(message).because(self.NONE_LEFT)
        place = min(found, key=lambda one: one[0])[1]
        self._set_output("furniture", place)
        self._set_output("visited", (*visited, place.name))
        self.feedback_message = place.name
        return DONE


def _is_top(item: SceneObject) -> bool:
    if item.movable or not isinstance(item.shape, Box) or kind_of(item.name) in ARTICULATED_KINDS:
        return False
    return min(item.shape.size_m[:2]) >= _LEAST_SIDE_M and _LOWEST_M <= top_m(item) <= _HIGHEST_M
