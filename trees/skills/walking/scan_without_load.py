"""What a range sensor sees of the things in the robot's own hands."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from trees.readings.odometry import body_pose
from trees.toolbox import Toolbox

_AROUND_M = 0.12
"""A held thing is within this of where it is believed to be, with what the sensor's noise adds."""


def without_held(toolbox: Toolbox, scan: Array) -> Array:
    """The points of a scan, shape (n, 3), that are none of what hangs on a hand.

    Args:
        toolbox: Knows what is attached, and where the hands are.
        scan: In a level frame at the base, x ahead, z up from the floor.
    """
    attached = toolbox.world.scene.attached
    if not attached:
        return scan
    model, q = toolbox.model, toolbox.sensing.state().q
    level = poses.inverse(body_pose(toolbox).transform())
    for name in sorted(attached):
        item = attached[name]
        x, y, z = (level @ model.frame_pose(q, item.frame) @ item.frame_T_object)[:3, 3]
        shape = item.body.shape
        radius_m = (
            0.5 * float(np.hypot(*shape.size_m[:2])) if isinstance(shape, Box) else float(shape.radius_m)
        )
        beside = np.hypot(scan[:, 0] - x, scan[:, 1] - y) <= radius_m + _AROUND_M
        level_with = np.abs(scan[:, 2] - z) <= 0.5 * shape.height_m + _AROUND_M
        scan = scan[~(beside & level_with)]
    return scan
