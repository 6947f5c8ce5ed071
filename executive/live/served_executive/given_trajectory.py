"""A trajectory that a program beside the robot hands in by the name of a file."""

from __future__ import annotations

from pathlib import Path

from executive.errors import TrajectoryFileError
from kinematics.errors import TrajectoryDocumentError
from kinematics.formats.joint_motion import JointMotion, read_joint_motion

MAX_BYTES = 16_000_000
"""Read while the robot stands and its heartbeat waits: a minute of a humanoid at 100 samples a second."""


def load_joint_motion(path: Path) -> JointMotion:
    """Read a motion of joints.

    Raises:
        TrajectoryFileError: File, place and reason.
    """
    try:
        if not path.is_file():
            raise TrajectoryFileError(path, "is no file")
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except OSError as failed:
        raise TrajectoryFileError(path, failed.strerror or "cannot be read") from failed
    if len(content) > MAX_BYTES:
        raise TrajectoryFileError(path, f"has more than {MAX_BYTES} bytes")
    try:
        return read_joint_motion(content.decode("utf-8"))
    except UnicodeDecodeError as broken:
        raise TrajectoryFileError(path, "is not UTF-8 text") from broken
    except TrajectoryDocumentError as broken:
        raise TrajectoryFileError(path, str(broken)) from broken
