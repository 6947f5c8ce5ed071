"""Grasps of a thing of any shape by fingers that close on a palm: where they meet one width of it.

Candidates are those of the outline. Where the thing is not as wide as that between the fingers, the hand
comes as near as the thing's own width wants. The thumb and the finger nearer to the foot press on one width
of it; above them it may get thinner, as a bottle does towards its neck, for each finger is driven alone. At a
neck itself they would push it along, and where it is too deep they do not close around it.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import GripperDescription
from kinematics.planning.grasps import GraspTable, widest_between_pads_m

NARROWER_M = 0.006
"""By less than this a thing may be thinner before the thumb, or before the lower finger, than elsewhere."""
_THUMB_M = 0.005
"""So far above and below its middle counts how wide a thing is before the thumb. A bottle whose belly ended
at that middle leaned by 2 to 6 degrees once held, one whose belly ended 5 mm below it by 4 to 8."""
_POINTS = 900
_LEAST_POINTS = 6
"""For a width to be known."""


def with_one_width(
    table: GraspTable, parts: ConvexParts, gripper: GripperDescription, world_T_object: Transform
) -> GraspTable:
    """Those of a table's grasps that hold the thing itself, moved to where it is between the fingers.

    Args:
        table: Grasps of the thing's outline by a hand with a palm.
        parts: What the thing is made of, with points of its surface.
        gripper: The hand's.
        world_T_object: Where the thing is, shape (4, 4).
    """
    if not len(table):
        return table
    surface = parts.surface[:_POINTS] @ world_T_object[:3, :3].T + world_T_object[:3, 3]
    narrowest, widest = gripper.opening_table[1][1], widest_between_pads_m(gripper)
    rows, places, widths = [], [], []
    for row, place in enumerate(table.world_T_tcp):
        x, y, z = ((surface - place[:3, 3]) @ place[:3, :3]).T
        z = math.copysign(1.0, place[2, 2]) * z
        between = np.abs(z) <= gripper.side_overlap_m
        upper, lower = between & (z >= 0.0), between & (z < -0.5 * gripper.side_overlap_m)
        thumb = np.abs(z) <= _THUMB_M
        if min(upper.sum(), lower.sum(), thumb.sum()) < _LEAST_POINTS:
            continue
        low, high = float(y[between].min()), float(y[between].max())
        width = high - low
        if not narrowest <= width <= widest or np.ptp(x[between]) > gripper.around_m:
            continue
        if min(np.ptp(y[lower]), np.ptp(y[thumb])) < width - NARROWER_M:
            continue
        moved = place.copy()
        # from where the outline's middle was to be, to where this one's is to be
        aside = 0.5 * (low + high) - gripper.grasped_at_m(width)
        moved[:3, 3] += aside * place[:3, 1] + 0.5 * (x[between].min() + x[between].max()) * place[:3, 0]
        rows.append(row)
        places.append(moved)
        widths.append(width)
    kept = np.array(rows, np.intp)
    names, yaw, kind, suffix = table.label
    return replace(
        table,
        world_T_tcp=np.array(places).reshape(-1, 4, 4),
        diameter_m=np.array(widths),
        cost=table.cost[kept],
        label=(names, yaw[kept], kind[kept], [suffix[row] for row in rows]),
        off_centre_m=np.array([gripper.held_at_m(width) for width in widths]),
    )
