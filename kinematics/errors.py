"""Errors of the kinematics package.

KinematicsError
├── UnknownNameError      a frame, joint, group or object that is not there
├── ModelError            a robot description that cannot be turned into a model
├── MissingPartError      a part that this robot does not have
├── InvalidArrayError     values that are no array of real numbers of the shape that is wanted
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


class InvalidArrayError(KinematicsError):
    """Values that are no array of real numbers of the shape that is wanted."""

    def __init__(self, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(f"{what} {reason}")

    def __reduce__(self) -> tuple[type[InvalidArrayError], tuple[str, str]]:
        """For worker processes: an exception is made anew from its arguments."""
        return InvalidArrayError, (self.what, self.reason)


class InvalidMotionError(KinematicsError):
    """Arrays that cannot be a path or a trajectory."""


class TrajectoryDocumentError(KinematicsError):
    """A stored trajectory that cannot be one: the place in the document and the reason."""

    def __init__(self, place: str, reason: str) -> None:
        self.place, self.reason = place, reason
        super().__init__(f"{place}: {reason}")
