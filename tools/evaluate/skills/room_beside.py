"""Whether a thing fits beside another one at all, by the truth: nobody can be asked for what does not.

Looser than any robot would be in each respect: reach, hands and what perception errs are not looked at.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.scene.free_spots import footprint_radius_m
from robots.scenes.scene_description import Furniture, SceneItem

EDGE_M = 0.01
GAP_M = 0.04
_STEP_RAD, _STEP_M = math.radians(5.0), 0.01


def has_room(
    item: SceneItem,
    other: SceneItem,
    objects: Sequence[SceneItem],
    carrier: Furniture,
    headings_rad: Sequence[float],
    off_rad: float,
    within_m: float,
    farthest_m: float = math.inf,
) -> bool:
    """Tell whether the foot of a thing has room on a piece of furniture, in some direction from another one.

    Args:
        item: What is to stand there.
        other: Beside what.
        objects: Everything that stands about, both among them.
        carrier: An upright table that is not turned.
        headings_rad: Directions from ``other``, in the world.
        off_rad: So far off these counts as well.
        within_m: Of the middle of ``other``.
        farthest_m: From the world's origin.
    """
    radius = footprint_radius_m(item.shape)
    middle = other.world_T_object[:2, 3]
    nearest = radius + footprint_radius_m(other.shape) + GAP_M
    half = 0.5 * np.array(carrier.size_m[:2]) - radius - EDGE_M
    around = [one for one in objects if one.name not in (item.name, other.name)]
    turns = np.arange(-off_rad, off_rad + 1e-9, _STEP_RAD)
    for heading in headings_rad:
        for turn in turns:
            way = np.array([math.cos(heading + turn), math.sin(heading + turn)])
            for far in np.arange(nearest, within_m, _STEP_M):
                place = middle + far * way
                on_it = bool(np.all(np.abs(place - np.array(carrier.position_m)) <= half))
                near = math.hypot(*place) <= farthest_m
                if on_it and near and all(_apart(place, radius, one) for one in around):
                    return True
    return False


def _apart(place: NDArray[np.float64], radius_m: float, one: SceneItem) -> bool:
    between = float(np.linalg.norm(place - one.world_T_object[:2, 3]))
    return between >= radius_m + footprint_radius_m(one.shape) + GAP_M
