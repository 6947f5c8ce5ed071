"""A motion of some joints, handed in from outside, and the whole robot's motion that it makes.

As text it is a JSON object: ``joints``, the names, and ``points``, each with ``t_s``, ``positions`` and
perhaps ``velocities``, in the order of the names; rad and rad/s, m and m/s of joints that slide.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.errors import TrajectoryDocumentError, UnknownNameError
from kinematics.formats.json_reader import parse_document
from kinematics.formats.solid_document import MAX_POSITION, require_unique
from kinematics.formats.trajectory_document import (
    MAX_DURATION_S,
    MAX_JOINTS,
    MAX_SAMPLES,
    MAX_VELOCITY,
    MIN_SPACING_S,
)
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory

START_RAD = 0.02
"""A motion may say that it begins this far from where a joint is."""


@dataclass(frozen=True, slots=True)
class JointMotion(Sealed):
    """Some joints over time.

    Attributes:
        joints: Their names.
        t_s: Times, shape (n,), rising from 0 or later.
        positions: Shape (n, joints).
        velocities: Shape (n, joints); a point that was given none is passed at rest.
    """

    joints: tuple[str, ...]
    t_s: Array
    positions: Array
    velocities: Array


def read_joint_motion(text: str) -> JointMotion:
    """Read one.

    Raises:
        TrajectoryDocumentError: With the place, such as "points[3].t_s", and the reason.
    """
    root = parse_document(text)
    root.only(("joints", "points"))
    joints = tuple(node.text() for node in root.key("joints").items(1, MAX_JOINTS))
    require_unique(root, "joints", joints)
    nodes = root.key("points").items(1, MAX_SAMPLES)
    t_s = np.empty(len(nodes))
    positions, velocities = np.empty((len(nodes), len(joints))), np.zeros((len(nodes), len(joints)))
    for i, node in enumerate(nodes):
        node.only(("t_s", "positions"), ("velocities",))
        t_s[i] = node.key("t_s").number(MAX_DURATION_S)
        if t_s[i] < 0.0 or (i > 0 and not t_s[i] - t_s[i - 1] >= MIN_SPACING_S):
            raise node.key("t_s").error("times must rise, from 0 or later")
        positions[i] = node.key("positions").numbers(joints, MAX_POSITION)
        if node.has("velocities"):
            velocities[i] = node.key("velocities").numbers(joints, MAX_VELOCITY)
    if len(nodes) == 1 and t_s[0] == 0.0:
        raise root.key("points").error("a single point at 0 s is no motion")
    return JointMotion(joints, t_s, positions, velocities)


def whole_motion(motion: JointMotion, model: RobotModel, q_start: Array, stance: Stance) -> Trajectory:
    """The motion of the whole robot: joints that are not named, and the base, stay where they are.

    Args:
        motion: Of some joints. Where its first time is later than 0 it is gone to from rest.
        model: The robot.
        q_start: Where the robot is, shape (nq,).
        stance: Where it stands.

    Raises:
        TrajectoryDocumentError: A joint is none of the robot's body, or is elsewhere than at the beginning.
    """
    for name in motion.joints:
        if name not in model.joints:
            raise TrajectoryDocumentError("joints", str(UnknownNameError("joint", name, list(model.joints))))
    columns = np.array([model.joints.index(name) for name in motion.joints], dtype=np.intp)
    here = q_start[7 + columns]
    t_s, positions, velocities = motion.t_s, motion.positions.copy(), motion.velocities
    if t_s[0] > 0.0:
        t_s = np.concatenate([[0.0], t_s])
        positions, velocities = np.vstack([here, positions]), np.vstack([np.zeros_like(here), velocities])
    else:
        away = np.abs(positions[0] - here)
        if away.max() > START_RAD:
            worst = int(np.argmax(away))
            raise TrajectoryDocumentError(
                "points[0].positions",
                f"{motion.joints[worst]} is at {here[worst]:.3f}, not at {positions[0, worst]:.3f}; "
                "begin where the robot is, or give the first point a later time",
            )
        positions[0] = here
    q = np.tile(q_start, (len(t_s), 1))
    v = np.zeros((len(t_s), 6 + len(model.joints)))
    q[:, 7 + columns], v[:, 6 + columns] = positions, velocities
    return Trajectory(model.joints, stance, t_s, q, v)
