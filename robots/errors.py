"""Errors of the robots package.

RobotsError
├── UnknownRobotError       no folder of that name under robots/models
├── UnknownRobotFolderError  a path that leads to no folder with a robot's data
├── DescriptionError        a robot's data that is missing or contradicts its URDF
├── SceneError              a scene file that cannot be a world: file, key and reason
├── CannotImportError       a mesh or scene of somebody else that nothing can be made of
├── SetpointRefusedError    a setpoint that the gate refused reached the robot anyway
├── RenderingUnavailableError  no OpenGL library for pictures
└── SilentModelError        a model that was asked what pictures show gave no answer
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence


class RobotsError(Exception):
    """Base of every error that the robots package raises."""


class UnknownRobotError(RobotsError):
    """A robot name without data."""

    def __init__(self, name: str, known: Sequence[str]) -> None:
        close = difflib.get_close_matches(name, known, n=1, cutoff=0.0)
        hint = f"; the nearest is {close[0]!r}" if close else ""
        super().__init__(f"no robot {name!r}{hint}")


class UnknownRobotFolderError(RobotsError):
    """A robot named by a path that leads to no folder with a robot's data."""

    def __init__(self, path: str, file: str) -> None:
        super().__init__(
            f"no robot in {path!r}: expected a folder with a {file}; "
            "python -m tools.robot_data new URDF drafts one"
        )


class DescriptionError(RobotsError):
    """A robot's data that is missing or contradicts its URDF."""


class SceneError(RobotsError):
    """A scene file that cannot be a world."""

    def __init__(self, source: str, key: str, reason: str) -> None:
        self.source, self.key, self.reason = source, key, reason
        super().__init__(f"{source}: {key}: {reason}")


class CannotImportError(RobotsError):
    """A file that no object or scene can be made of, or not without a library; the message says why."""


class SetpointRefusedError(RobotsError):
    """A setpoint that breaks the robot's contract (wrong shape, not finite)."""


class RenderingUnavailableError(RobotsError):
    """No OpenGL library was found for pictures."""
