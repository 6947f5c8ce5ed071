"""Which things of a scene the hands of a robot could take where they are, and why not the others.

A hand keeps from furniture and from other things what the executive has it keep: where these are is not known
better. All else about how a robot takes hold of things is left out.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.validity import hand_judge
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import ABOVE_MIDDLE, NEAR_TOP
from kinematics.planning.grasps_of_shapes import any_grasp_table, every_height
from kinematics.planning.pick_task import APPROACH_M
from kinematics.scene.planning_scene import PlanningScene, SceneObject, floor
from kinematics.scene.support_of import TOUCHING_M, support_of
from robots.models.description import load_description
from robots.scenes.scene_description import RobotStart, SceneDescription, SceneItem
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_solids import planning_scene
from tools.evaluate.skills import rooms
from tools.evaluate.upon.hand_alone import hand_takes
from trees.policy import TreePolicy

_TOP_M, _WIDE_M, _HIGH_M = 0.04, 1.2, 0.8
"""Of a table's top that a thing stands on alone."""
_ARM_AWAY_M, _SIDES, _PEDESTAL_M = (0.5, 0.55, 0.45, 0.6, 0.65), 16, 0.17
"""How far from a thing an arm is bolted down, on one of so many sides, and what its pedestal needs around."""
_SMALL_M = 0.9
"""A humanoid whose base is lower than this at home stands before a low table,"""
_BEFORE_M = 0.2
"""and with the middle between its feet at least so far before its edge."""
_HEADINGS_RAD = tuple(np.linspace(-math.pi, math.pi, 12, endpoint=False).tolist())
_HEIGHTS = (ABOVE_MIDDLE, NEAR_TOP, *np.linspace(-0.4, 0.45, 18).tolist())
"""Of a palm: where it comes from, and how high above the middle, in shares of the thing's height."""


class Hands:
    """What a robot's hands can take, if they had no arms.

    Args:
        robot: Its name.

    Attributes:
        model: The robot.
    """

    def __init__(self, robot: str) -> None:
        self.model = RobotModel(load_description(robot))
        at = poses.translation(0.0, 0.0, _HIGH_M - 0.5 * _TOP_M)
        margin_m = TreePolicy().furniture_margin_m
        top = SceneObject("top", Box((_WIDE_M, _WIDE_M, _TOP_M)), at, margin_m, movable=False)
        self._table = PlanningScene().with_object(top)
        self._known: dict[str, bool] = {}

    def take_alone(self, item: SceneItem) -> bool:
        """Whether one of them can take something that stands on a table with nothing beside it."""
        known = item.mesh or item.name
        if known not in self._known:
            self._known[known] = self.take(self.alone(item), item.name)
        return self._known[known]

    def alone(self, item: SceneItem) -> PlanningScene:
        """Something on a table with nothing beside it."""
        pose = poses.translation(0.0, 0.0, _HIGH_M + 0.5 * item.shape.height_m)
        return self._table.with_object(SceneObject(item.name, item.shape, pose))

    def ranked(self, hand: Hand, scene: PlanningScene, target: str) -> Array:
        """Where the planner would have the TCP of a hand without an arm, best first, shape (n, 4, 4).

        Heights that it tries when the usual one fails come after that.
        """
        judge = hand_judge(self.model, hand, scene, target, 0.0)
        advance_m = self.model.description.grippers[hand].closing_advance_m
        ways = (advance_m, 0.0, -0.5 * APPROACH_M, -APPROACH_M)
        for heights in ((ABOVE_MIDDLE,), every_height([self.model.description.grippers[hand]])):
            table = any_grasp_table(scene.objects[target], self.model, hand, 0.0, APPROACH_M, heights, 0.0)
            if len(table) and (free := judge.fits_along(table.world_T_tcp, ways)).any():
                return table.world_T_tcp[free]
        return np.zeros((0, 4, 4))

    def take(self, scene: PlanningScene, target: str) -> bool:
        """Whether one of them can take something among all that is there."""
        return any(self._takes(hand, scene, target) for hand in self.model.description.gripping_hands)

    def _takes(self, hand: Hand, scene: PlanningScene, target: str) -> bool:
        gripper = self.model.description.grippers[hand]
        if gripper.palm_side_m is None:
            return hand_takes(self.model, hand, scene, target)
        # fingers that close on a palm hold what is of one width: looked for all around and all the way up
        judge = hand_judge(self.model, hand, scene, target, 0.0)
        tables = (
            any_grasp_table(scene.objects[target], self.model, hand, heading, APPROACH_M, _HEIGHTS, 0.0)
            for heading in _HEADINGS_RAD
        )
        ways = (0.0, -0.5 * APPROACH_M, -APPROACH_M)
        return any(bool(judge.fits_along(table.world_T_tcp, ways).any()) for table in tables if len(table))


hands_of = functools.lru_cache(maxsize=4)(Hands)
"""A worker runs many episodes of one robot."""


def why_not_asked_for(scene: SceneDescription, hands: Hands) -> Mapping[str, str]:
    """Of each thing why nobody can be asked to pick it up there; empty of what a hand could take.

    Args:
        scene: Where the things are.
        hands: The robot's.
    """
    kept = TreePolicy()
    there = planning_scene(scene).with_object(floor()).objects.values()
    solids = PlanningScene().with_objects(
        replace(one, margin_m=kept.object_margin_m if one.movable else kept.furniture_margin_m)
        for one in there
    )
    return {item.name: _why_not(item, scene, solids, hands) for item in scene.objects}


def _why_not(item: SceneItem, scene: SceneDescription, solids: PlanningScene, hands: Hands) -> str:
    if not named_alone(item, scene.objects):
        return "others are called so"
    on = support_of(solids.objects[item.name], solids, TOUCHING_M)
    if on is None or on.name == floor().name:
        return "stands on no furniture"
    if hands.model.description.welded and not bolted_before(item, scene):
        return "nowhere within an arm's reach of it has a pedestal room"
    if not _in_reach(item, on, hands.model):
        return "farther from the edge of what it stands on than this body reaches"
    if not hands.take_alone(item):
        return "no hand can take it even where nothing else is"
    return "" if hands.take(solids, item.name) else "no hand has room beside it"


def workspace_of(model: RobotModel) -> rooms.Workspace:
    """Tables that suit a robot."""
    if model.description.welded:
        return rooms.BENCH
    return rooms.LOW if model.q_home[2] < _SMALL_M else rooms.STANDING


def _in_reach(item: SceneItem, on: SceneObject, model: RobotModel) -> bool:
    """Whether somebody who stands before what it stands on gets so far; an arm is bolted down near it."""
    if model.description.welded or not isinstance(on.shape, Box):
        return True
    middle = poses.inverse(on.world_T_object) @ item.world_T_object
    in_m = 0.5 * np.array(on.shape.size_m[:2]) - np.abs(middle[:2, 3])
    return float(in_m.min()) <= workspace_of(model).farthest_m - _BEFORE_M


def bolted_before(item: SceneItem, scene: SceneDescription) -> list[RobotStart]:
    """Where an arm may be bolted down that is to reach a thing, looking at it; best first.

    Args:
        item: The thing.
        scene: What stands around.
    """
    solids = [one for one in planning_scene(scene).objects.values() if one.name != item.name]
    x, y = item.world_T_object[:2, 3].tolist()
    starts = (
        RobotStart(x - away_m * math.cos(yaw), y - away_m * math.sin(yaw), yaw)
        for away_m in _ARM_AWAY_M
        for yaw in np.linspace(-math.pi, math.pi, _SIDES, endpoint=False).tolist()
    )
    return [start for start in starts if all(_beside_m(start, one) > _PEDESTAL_M for one in solids)]


def _beside_m(start: RobotStart, solid: SceneObject) -> float:
    """From the middle of a base to the nearest point of a solid, along the floor."""
    place = np.array([start.x_m, start.y_m, 0.0])
    off = solid.world_T_object[:3, :3].T @ (place - solid.world_T_object[:3, 3] * (1.0, 1.0, 0.0))
    if isinstance(solid.shape, Box):
        return float(
            np.linalg.norm(np.maximum(np.abs(off[:2]) - 0.5 * np.array(solid.shape.size_m[:2]), 0.0))
        )
    return float(np.linalg.norm(off[:2]) - solid.shape.radius_m)


def named_alone(item: SceneItem, others: tuple[SceneItem, ...] | list[SceneItem]) -> bool:
    """Whether no other thing's name is a part of its own, or the other way round."""
    return not any(item.name in one.name or one.name in item.name for one in others if one is not item)


@functools.lru_cache(maxsize=8)
def asked_for_in(scene: str, robot: str) -> tuple[str, ...]:
    """Names of what a robot may be asked to pick up in a scene as it is.

    Args:
        scene: Its name or file.
        robot: The robot's name.

    Raises:
        ValueError: There is nothing; it says why of each thing.
    """
    reasons = why_not_asked_for(load_scene(scene), hands_of(robot))
    found = tuple(name for name, reason in reasons.items() if not reason)
    if not found:
        told = "; ".join(f"{name}: {reason}" for name, reason in reasons.items())
        raise ValueError(f"{scene}: the hands of {robot} can take nothing of what is in it ({told})")
    return found
