"""How near two solids of a motion are at an instant, by Coal, and where they are nearest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import coal
import numpy as np

from kinematics.checking.kinematics import BodyPoses
from kinematics.checking.solids import Solid
from kinematics.checking.timeline import Configurations, Timeline


class _Kinematics(Protocol):
    def poses(self, configurations: Configurations) -> BodyPoses: ...


def touching_place(
    kinematics: _Kinematics, timeline: Timeline, two: Sequence[Solid], t_s: float
) -> tuple[float, float, float] | None:
    """Midway between the nearest points of two solids at an instant, m; None where Coal knows none.

    Args:
        kinematics: Of the robot.
        timeline: The motion.
        two: The solids.
        t_s: The instant.
    """
    function = coal.ComputeDistance(two[0].geometry, two[1].geometry)
    _, result = measured(function, two, kinematics.poses(timeline.at(np.array([t_s]))), 0)
    x, y, z = (0.5 * (result.getNearestPoint1() + result.getNearestPoint2())).tolist()
    return (x, y, z) if np.isfinite((x, y, z)).all() else None


def measured(
    function: coal.ComputeDistance, two: Sequence[Solid], placed: BodyPoses, at: int
) -> tuple[float, coal.DistanceResult]:
    """Signed distance of two solids at one of the instants for which bodies are placed, and Coal's result."""
    request, result = coal.DistanceRequest(), coal.DistanceResult()
    request.enable_signed_distance = True
    places = [
        coal.Transform3s(
            rotation @ solid.body_T_solid[:3, :3],
            rotation @ solid.body_T_solid[:3, 3] + placed.origin_m[solid.body, at],
        )
        for solid in two
        for rotation in (placed.rotation[solid.body, at],)
    ]
    return float(function(places[0], places[1], request, result)), result
