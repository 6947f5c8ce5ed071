"""Whether all that stands beside a thing has been looked at: what no look showed may be its twin."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import half_height_m, support_of
from trees.beliefs.sight.sight_of_tops import ABOVE_M, SightOfTops
from trees.skills.looking.hand_ways import in_reach_of_the_eyes
from trees.toolbox import Toolbox

_EDGE_M = 0.04
"""What stands nearer to an edge than this is half in the air."""
_APART_M = 0.10


def seen_wholly(toolbox: Toolbox, name: str) -> bool:
    """Whether looks have shown the whole top that a thing stands on, as far as the head can turn to it.

    Args:
        toolbox: What was looked at.
        name: Something in the world model's scene; what stands on nothing flat is alone there.
    """
    scene, policy = toolbox.world.scene, toolbox.policy
    top = support_of(scene.objects[name], scene, policy.support_gap_m)
    if top is None or not isinstance(top.shape, Box):
        return True
    camera = toolbox.model.description.camera
    sight = SightOfTops(toolbox.world.glimpses, camera, policy.blocked_by_hand_m)
    return all(
        sight.shows(place) or not in_reach_of_the_eyes(toolbox, place) for place in _over(top, top.shape)
    )


def _over(top: SceneObject, shape: Box) -> list[Array]:
    """Points just above a top, shape (3,) each, odometry frame."""
    half = 0.5 * np.asarray(shape.size_m)[:2] - _EDGE_M
    along, across = (np.linspace(-h, h, max(2, round(2.0 * h / _APART_M) + 1)) for h in np.maximum(half, 0.0))
    height = half_height_m(top) + ABOVE_M
    local = np.array([(x, y, height, 1.0) for x in along for y in across])
    return list((local @ top.world_T_object.T)[:, :3])
