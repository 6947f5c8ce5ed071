"""Whether a trajectory fits on to what is commanded now."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics import poses
from kinematics.check_rest import AT_REST
from kinematics.trajectory import Stance, Trajectory

Array = NDArray[np.float64]

_START_RAD = 1e-3
_START_M = 1e-3
_STANCE_M = 1e-3
_STANCE_RAD = 2e-3


def why_not(trajectory: Trajectory, reference: Array, stance: Stance, joints: Sequence[str]) -> str | None:
    """Tell why a trajectory cannot follow on a reference, shape (nq,), at rest; None if it can."""
    if tuple(trajectory.joints) != tuple(joints):
        return "its joints are not those of this robot"
    gap = np.abs(trajectory.q[0, 7:] - reference[7:])
    worst = int(np.argmax(gap))
    if gap[worst] > _START_RAD:
        return (
            f"it starts at {trajectory.q[0, 7 + worst]:.4f} rad of {joints[worst]}, "
            f"the robot is at {reference[7 + worst]:.4f}"
        )
    away_m = float(np.linalg.norm(trajectory.q[0, :3] - reference[:3]))
    away_rad = poses.angle_between(
        poses.rotation_from_quaternion(trajectory.q[0, 3:7]), poses.rotation_from_quaternion(reference[3:7])
    )
    if away_m > _START_M or away_rad > _START_RAD:
        return f"its base starts {1e3 * away_m:.1f} mm and {1e3 * away_rad:.1f} mrad from the robot's"
    for index, end in ((0, "start"), (-1, "end")):
        speed = np.abs(trajectory.v[index])
        if speed.max() > AT_REST:
            return f"it does not {end} at rest: {speed.max():.4g}"
    return _other_stance(trajectory.stance, stance)


def _other_stance(planned: Stance, actual: Stance) -> str | None:
    here = dict(actual.soles)
    if {frame for frame, _ in planned.soles} != set(here):
        return f"it stands on {[frame for frame, _ in planned.soles]}, the robot on {list(here)}"
    for frame, pose in planned.soles:
        away_m = float(np.linalg.norm(pose[:3, 3] - here[frame][:3, 3]))
        away_rad = poses.angle_between(pose[:3, :3], here[frame][:3, :3])
        if away_m > _STANCE_M or away_rad > _STANCE_RAD:
            return f"its {frame} stands {1e3 * away_m:.1f} mm and {1e3 * away_rad:.1f} mrad from the robot's"
    return None
