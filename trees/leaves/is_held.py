"""Ask whether the object of a task is in a hand already."""

from __future__ import annotations

from py_trees.common import Status

from trees.failures import Failure
from trees.leaves.take_held import TakeHeld


class IsHeld(TakeHeld):
    """As ``TakeHeld``; that it is not held is an answer. What a hand holds is never all that is meant."""

    ASKS = True

    def step(self) -> Status | Failure:
        """Ask, for a single thing."""
        task = self.get_input("task")
        if task.object is not None and task.count != 1:
            return Failure.postcondition("several things are meant")
        return super().step()
