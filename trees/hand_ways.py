"""What of the places that a hand is to pass over has not been looked at."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.gaze import gaze_joints
from kinematics.robot_description import Hand
from kinematics.scene import SceneObject
from kinematics.support import half_height_m, support_of
from trees.sight import in_view
from trees.sight_of_tops import ABOVE_M, SightOfTops, is_over
from trees.steps import Step, Target
from trees.toolbox import Toolbox

Array = NDArray[np.float64]

_LOOKED_AT = 12
# Half a hand with open fingers, and what it keeps from things.
_BESIDE_M = 0.12
_DIRECTIONS = 6
# A hand that is higher than this above a top passes over what stands on it.
_TALL_M = 0.35


def unseen_on_way(toolbox: Toolbox, target: Target, reach: Step, hand: Hand) -> Array:
    """Places under the way of a hand where something could stand on the target's furniture unseen.

    What the head alone cannot be turned to is left out: a strip along the near edge.

    Args:
        toolbox: What was looked at.
        target: Something on a known piece of furniture; only its top counts.
        reach: The planned way to it.
        hand: The hand that goes there.

    Returns:
        Points just above the top, odometry frame, shape (n, 3); none when all was looked at.
    """
    scene, policy, model = toolbox.world.scene, toolbox.policy, toolbox.model
    item = scene.objects.get(target.name)
    top = None if item is None else support_of(item, scene, policy.support_gap_m)
    if top is None:
        return np.empty((0, 3))
    sight = SightOfTops(toolbox.world.glimpses, model.description.camera, policy.blocked_by_hand_m)
    frame = model.description.tcp_frames[hand]
    rows = np.linspace(0, len(reach.trajectory.q) - 1, _LOOKED_AT).astype(int)
    way = np.array([model.frame_pose(q, frame)[:3, 3] for q in reach.trajectory.q[rows]])
    places = [
        place for place in _about(way, top) if not sight.shows(place) and in_reach_of_the_eyes(toolbox, place)
    ]
    return np.array(places).reshape(-1, 3)


def in_reach_of_the_eyes(toolbox: Toolbox, place: Array) -> bool:
    """Whether the head alone can be turned so that a place, shape (3,), is in the picture."""
    model, q = toolbox.model, toolbox.motion.reference()
    for joint, angle in gaze_joints(model, q, place).items():
        q[7 + model.joint_index(joint)] = angle
    camera = model.description.camera
    return in_view(camera, model.frame_pose(q, camera.frame), place)


def _about(way: Array, top: SceneObject) -> list[Array]:
    """Points just above a top, at and about a hand's way, where the hand is low; shape (3,) each."""
    height_m = float(top.world_T_object[2, 3]) + half_height_m(top)
    turns = 2.0 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    about = _BESIDE_M * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(_DIRECTIONS)])
    low = way[way[:, 2] < height_m + _TALL_M].copy()
    low[:, 2] = height_m + ABOVE_M
    places = (low[:, None] + np.vstack([np.zeros(3), about])).reshape(-1, 3)
    return [place for place in places if is_over(top, place)]
