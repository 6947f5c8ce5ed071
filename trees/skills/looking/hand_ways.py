"""What of the places that a hand is to pass over has not been looked at."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry.shapes import Box
from kinematics.ik.gaze import gaze_joints
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import support_of, top_m
from trees.beliefs.sight.sight import in_view
from trees.beliefs.sight.sight_of_tops import ABOVE_M, SightOfTops, is_over
from trees.port_values import Step, Target
from trees.toolbox import Toolbox

_LOOKED_AT = 12
# Half a hand with open fingers, and what it keeps from things.
_BESIDE_M = 0.12
_DIRECTIONS = 6
# A hand that is higher than this above a top passes over what stands on it.
_TALL_M = 0.35
# Of the trunk, to see what is below the picture of who stands upright.
_LEANS_RAD = (0.3, 0.6)
# A hand that goes less far than this stays where it is.
_MOVED_M = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class UnseenPlaces(Sealed):
    """Places under the path of a hand that no look has shown, so that something may stand there.

    Attributes:
        points: Just above tops, odometry frame, shape (n, 3); none when all was looked at.
    """

    points: Array


def unseen_on_way(toolbox: Toolbox, target: Target, reach: Step, hand: Hand) -> UnseenPlaces:
    """Places under the way of a hand where something could stand on the target's furniture unseen.

    What no lean brings into the picture is left out.

    Args:
        toolbox: What was looked at.
        target: Something on a known piece of furniture; only its top counts.
        reach: The planned way to it.
        hand: The hand that goes there.
    """
    scene = toolbox.world.scene
    item = scene.objects.get(target.name)
    top = None if item is None else support_of(item, scene, toolbox.policy.support_gap_m)
    if top is None:
        return UnseenPlaces(np.empty((0, 3)))
    return _unseen(toolbox, _about(_way_of(toolbox, reach.trajectory, hand), top))


def unseen_below(toolbox: Toolbox, trajectory: Trajectory) -> UnseenPlaces:
    """The same for hands that are to go nowhere in particular: under their ways, on whatever has a top.

    Args:
        toolbox: What was looked at.
        trajectory: The planned motion; hands that stay where they are do not count.
    """
    scene = toolbox.world.scene
    tops = [item for item in scene.objects.values() if not item.movable and isinstance(item.shape, Box)]
    ways = [_way_of(toolbox, trajectory, hand) for hand in toolbox.model.description.hands]
    moved = [way for way in ways if float(np.abs(way - way[0]).max()) > _MOVED_M]
    places = [place for way in moved for top in tops for place in _about(way[way[:, 2] > top_m(top)], top)]
    return _unseen(toolbox, places)


def _way_of(toolbox: Toolbox, trajectory: Trajectory, hand: Hand) -> Array:
    """Places of a hand on its way, shape (n, 3)."""
    model = toolbox.model
    frame = model.description.tcp_frames[hand]
    rows = np.linspace(0, len(trajectory.q) - 1, _LOOKED_AT).astype(int)
    return np.array([model.frame_pose(q, frame)[:3, 3] for q in trajectory.q[rows]])


def _unseen(toolbox: Toolbox, places: list[Array]) -> UnseenPlaces:
    """Those of some places that no look has shown and a look can, leaning over if need be."""
    policy, camera = toolbox.policy, toolbox.model.description.camera
    sight = SightOfTops(toolbox.world.glimpses, camera, policy.blocked_by_hand_m)
    unseen = [
        place
        for place in places
        if not sight.shows(place)
        and (in_reach_of_the_eyes(toolbox, place) or _in_reach_of_a_lean(toolbox, place))
    ]
    return UnseenPlaces(np.array(unseen).reshape(-1, 3))


def in_reach_of_the_eyes(toolbox: Toolbox, place: Array) -> bool:
    """Whether the head alone can be turned so that a place, shape (3,), is in the picture."""
    return _in_reach(toolbox.model, toolbox.motion.reference(), place)


def _in_reach_of_a_lean(toolbox: Toolbox, place: Array) -> bool:
    """The same with the trunk: the near edge of a table is below the picture of who stands upright."""
    model, q = toolbox.model, toolbox.motion.reference()
    lean = model.description.camera.lean_joint
    if lean is None:
        return False
    for lean_rad in _LEANS_RAD:
        q[7 + model.joint_index(lean)] = lean_rad
        if _in_reach(model, q, place):
            return True
    return False


def _in_reach(model: RobotModel, q: Array, place: Array) -> bool:
    looking = q.copy()
    for joint, angle in gaze_joints(model, q, place).items():
        looking[7 + model.joint_index(joint)] = angle
    camera = model.description.camera
    return in_view(camera, model.frame_pose(looking, camera.frame), place)


def _about(way: Array, top: SceneObject) -> list[Array]:
    """Points just above a top, at and about a hand's way, where the hand is low; shape (3,) each."""
    height_m = top_m(top)
    turns = 2.0 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    about = _BESIDE_M * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(_DIRECTIONS)])
    low = way[way[:, 2] < height_m + _TALL_M].copy()
    low[:, 2] = height_m + ABOVE_M
    places = (low[:, None] + np.vstack([np.zeros(3), about])).reshape(-1, 3)
    return [place for place in places if is_over(top, place)]
