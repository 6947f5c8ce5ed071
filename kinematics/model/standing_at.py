"""Which feet carry, the polygon that they span on the floor, and how far inside it the CoM is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.errors import KinematicsError
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance


def stance_at(model: RobotModel, q: Array, frames: Sequence[str] | None = None) -> Stance:
    """Return the stance of the soles where a configuration has them.

    Args:
        model: The robot.
        q: Configuration, shape (nq,).
        frames: Names of the sole frames that carry; all soles of the robot when left out (a welded
            robot has none, so its stance is empty).

    Raises:
        UnknownNameError: A frame is not in the model.
    """
    names = [sole.frame for sole in model.description.soles] if frames is None else list(frames)
    return Stance(tuple(zip(names, model.frame_poses(q, names), strict=True)))


def standing_at(model: RobotModel, q: Array, stance: Stance) -> Array:
    """Configuration with the same joints and the base where the soles of a stance put it, shape (nq,).

    Soles that disagree, because the joints do not keep their distance exactly, are averaged. A welded
    base is where it is mounted.

    Raises:
        KinematicsError: The stance has no sole, and the base is not welded.
        UnknownNameError: A sole's frame is not in the model.
    """
    if model.description.welded:
        return np.concatenate([model.q_home[:7], q[7:]])
    if not stance.soles:
        raise KinematicsError("a stance without soles puts the base nowhere")
    at_origin = q.copy()
    at_origin[:7] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    found = model.frame_poses(at_origin, [frame for frame, _ in stance.soles])
    bases = [
        world_T_sole @ poses.inverse(base_T_sole)
        for (_, world_T_sole), base_T_sole in zip(stance.soles, found, strict=True)
    ]
    base = bases[0]
    for k, other in enumerate(bases[1:], start=2):
        base = poses.interpolate(base, other, 1.0 / k)
    at_origin[:3] = base[:3, 3]
    at_origin[3:7] = poses.quaternion_from_rotation(base[:3, :3])
    return at_origin
