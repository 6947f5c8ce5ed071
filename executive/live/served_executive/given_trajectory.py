"""A trajectory that a program beside the robot hands in by the name of a file."""

from __future__ import annotations

from pathlib import Path

from executive.errors import TrajectoryFileError
from executive.motion_file import read_motion_file
from kinematics.formats.joint_motion import JointMotion, read_joint_motion

MAX_BYTES = 16_000_000
"""Read while the robot stands and its heartbeat waits: a minute of a humanoid at 100 samples a second."""


def load_joint_motion(path: Path) -> JointMotion:
    """Read a motion of joints.

    Raises:
        TrajectoryFileError: File, place and reason.
    """
    if not path.is_file():  # nobody waits for what a pipe may bring
        raise TrajectoryFileError(path, "is no file")
    return read_motion_file(path, MAX_BYTES, read_joint_motion)
