"""What was computed for a robot on a stance, kept for the next who asks."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance

T = TypeVar("T")

_KEPT = 16
"""A robot stands in few places at a time."""


class StanceTable(Generic[T]):
    """Values of one kind, made once for each robot and stance; the oldest are forgotten."""

    def __init__(self, make: Callable[..., T]) -> None:
        """Take ``make(model, stance, *more)``."""
        self._make = make
        self._found: dict[Hashable, tuple[RobotModel, T]] = {}

    def __call__(self, model: RobotModel, stance: Stance, *more: Hashable) -> T:
        """The value for a robot on a stance; ``more`` is passed on and must be told apart, too."""
        key = id(model), stance.key, more
        found = self._found.get(key)
        if found is None or found[0] is not model:
            while len(self._found) >= _KEPT:
                self._found.pop(next(iter(self._found)))
            found = self._found[key] = model, self._make(model, stance, *more)
        return found[1]
