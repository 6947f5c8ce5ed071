"""Ask whether the object of a task is in a hand already."""

from __future__ import annotations

from trees.leaves.take_held import TakeHeld


class IsHeld(TakeHeld):
    """As ``TakeHeld``; that it is not held is an answer."""

    ASKS = True
