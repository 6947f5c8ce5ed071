"""Which hand is about an object that nobody says it holds: a cancelled task left it there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.scene.held_object import HeldObject
from trees.toolbox import Toolbox

_ABOUT_M = 0.03
"""A TCP nearer than this to an object has fingers beside it: they reach so far past the TCP."""


def objects_in_open_grasp(toolbox: Toolbox) -> tuple[HeldObject, ...]:
    """For each hand that holds nothing, as the world model has it, the object that it is about.

    Args:
        toolbox: Knows the commanded posture and what stands where.
    """
    scene, model = toolbox.world.scene, toolbox.model
    things = [item for item in scene.objects.values() if item.movable]
    if not things:
        return ()
    q = toolbox.motion.reference()
    holding = {body.frame for body in scene.attached.values()}
    found = []
    for hand in toolbox.grippers:
        frame = model.description.tcp_frames[hand]
        if frame in holding:
            continue
        tcp = model.frame_pose(q, frame)
        near = [
            (outside_m, item.name)
            for item in things
            if (outside_m := _outside_m(item, tcp[:3, 3])) <= _ABOUT_M
        ]
        if near:
            item = scene.objects[min(near)[1]]
            tcp_T_object = poses.inverse(tcp) @ item.world_T_object
            found.append(HeldObject(item.name, hand, item.shape, tcp_T_object, item.label))
    return tuple(found)


def _outside_m(item: SceneObject, point: NDArray[np.float64]) -> float:
    """Distance of a point, shape (3,), from the box about an object; 0 inside."""
    local = (point - item.world_T_object[:3, 3]) @ item.world_T_object[:3, :3]
    shape = item.shape
    if isinstance(shape, Box):
        half = 0.5 * np.array(shape.size_m)
    elif isinstance(shape, Ball):
        half = np.full(3, shape.radius_m)
    else:
        half = np.array([shape.radius_m, shape.radius_m, 0.5 * shape.height_m])
    return float(np.linalg.norm(np.maximum(np.abs(local) - half, 0.0)))
