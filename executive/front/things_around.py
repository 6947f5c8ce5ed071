"""What a robot believes to be around it, as a model is told it: names and kinds, nearest first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from trees.readings.odometry import what_is_around
from trees.toolbox import Toolbox


def things_around(toolbox: Toolbox) -> Sequence[Mapping[str, Any]]:
    """The things that are believed to be there, as JSON values; names are what perception was told.

    Args:
        toolbox: The robot's.
    """
    around = what_is_around(toolbox)
    held = [{"words": label.words, "held": True} for label in around.held.values()]
    things = sorted(around.things, key=lambda one: float(np.hypot(*one.place_m[:2])))
    return [
        *held,
        *({"words": one.words, "kind": one.kind, "color": one.color, "on": one.support} for one in things),
    ]
