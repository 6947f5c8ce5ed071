"""Whether a trajectory fits on to what is commanded now."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.rest import AT_REST
from kinematics.checking.start_gap import LEAD_IN_M, start_gap
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.trajectory import Trajectory

_STANCE_M = 1e-3
_STANCE_RAD = 2e-3


def why_not(standing: StandingRobot, trajectory: Trajectory, reference: Array) -> str | None:
    """Tell why a trajectory cannot follow on a reference, shape (nq,), at rest; None if it can."""
    model = standing.model
    if tuple(trajectory.joints) != tuple(model.joints):
        return "its joints are not those of this robot"
    elsewhere = starts_elsewhere(model, trajectory, reference)
    if elsewhere is not None:
        return elsewhere
    for index, end in ((0, "start"), (-1, "end")):
        speed = np.abs(trajectory.v[index])
        if speed.max() > AT_REST:
            return f"it does not {end} at rest: {speed.max():.4g}"
    return _other_stance(trajectory.stance, standing.stance)


def starts_elsewhere(model: RobotModel, trajectory: Trajectory, reference: Array) -> str | None:
    """Tell how far a trajectory starts from a reference, shape (nq,), if it is farther than may be led in."""
    start = trajectory.q[0]
    moves_m = start_gap(model).moves_m(reference, start)
    if moves_m <= LEAD_IN_M:
        return None
    gap = np.abs(start[7:] - reference[7:])
    worst = int(np.argmax(gap))
    away_m = float(np.linalg.norm(start[:3] - reference[:3]))
    away_rad = poses.angle_between(
        poses.rotation_from_quaternion(start[3:7]), poses.rotation_from_quaternion(reference[3:7])
    )
    if gap[worst] >= max(away_m, away_rad):
        where = (
            f"it starts at {start[7 + worst]:.7g} rad of {model.joints[worst]}, "
            f"the robot is at {reference[7 + worst]:.7g}"
        )
    else:
        where = f"its base starts {1e3 * away_m:.3g} mm and {1e3 * away_rad:.3g} mrad from the robot's"
    return (
        f"{where}: a point of the robot would move by {1e3 * moves_m:.3g} mm that nobody checked, "
        f"{1e3 * LEAD_IN_M:g} mm at most are allowed"
    )


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
