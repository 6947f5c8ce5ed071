"""Ask whether the robot has to walk before it takes hold of a handle."""

from __future__ import annotations

from trees.leaves.stands_at_handle import StandsAtHandle


class StandsThereAlready(StandsAtHandle):
    """As ``StandsAtHandle``, before a walk; that it stands elsewhere is an answer."""

    ASKS = True
