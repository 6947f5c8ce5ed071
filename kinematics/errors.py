"""Errors of the kinematics package.

KinematicsError
├── UnknownNameError      a frame, joint, group or object that is not there
├── ModelError            a robot description that cannot be turned into a model
├── MissingPartError      a part that this robot does not have
├── InvalidMotionError    arrays that cannot be a path or a trajectory
└── TrajectoryDocumentError  a stored trajectory that cannot be one: place and reason

Expected outcomes (no plan found, an unsafe trajectory) are return values, not errors.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence


class KinematicsError(Exception):
    """Base of every error that the kinematics package raises."""


class UnknownNameError(KinematicsError):
    """A name that the model or the scene does not have."""

    def __init__(self, what: str, name: str, known: Sequence[str]) -> None:
        close = difflib.get_close_matches(name, known, n=1)
        hint = f"; did you mean {close[0]!r}?" if close else ""
        super().__init__(f"no {what} {name!r} among {len(known)}{hint}")


class ModelError(KinematicsError):
    """A robot description that cannot be turned into a model."""


class MissingPartError(KinematicsError):
    """A part that was asked for and that this robot does not have."""

    def __init__(self, robot: str, part: str) -> None:
        super().__init__(f"{robot} has no {part}")


class InvalidMotionError(KinematicsError):
    """Arrays that cannot be a path or a trajectory."""


class TrajectoryDocumentError(KinematicsError):
    """A stored trajectory that cannot be one: the place in the document and the reason."""

    def __init__(self, place: str, reason: str) -> None:
        self.place, self.reason = place, reason
        super().__init__(f"{place}: {reason}")
