"""Names of a scene's things in the simulator, apart from those of the robot and of the floor.

A scene may call a cup "floor", or "arm_left_7_link": only what has the mark in front is the scene's.
"""

from __future__ import annotations

_MARK = "scene:"


def in_simulator(name: str) -> str:
    """The simulator's name of a body or geom that a scene calls so: "red cup", "table/top", "Ana/hand"."""
    return _MARK + name


def in_scene(name: str) -> str | None:
    """What the scene calls a body or geom of the simulator; None for what is the robot's or the floor."""
    return name.removeprefix(_MARK) if name.startswith(_MARK) else None
