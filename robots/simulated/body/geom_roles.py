"""Which kind of thing a simulated geom belongs to, what it is called there, and what may touch what.

A scene may call a cup "floor", or "arm_left_7_link": only what has the mark in front of its name is
the scene's.
"""

from __future__ import annotations

from enum import IntEnum


class Role(IntEnum):
    """What a colliding geom is part of."""

    NONE = 0
    """Drawn only; touches nothing."""
    FLOOR = 1
    BODY = 2
    """The robot, but for its fingers: convex hulls and soles."""
    FINGER = 3
    """Finger hulls. They fill the concave fingers, so that they would hold an object without friction;
    they touch furniture, persons and the robot, never objects."""
    PAD = 4
    """Finger pads: the only part of the robot that grasps. They fill the gap between two fingers of one side,
    so the robot itself does not touch them: into that gap its thigh goes as far as the hulls let it."""
    FURNITURE = 5
    OBJECT = 6
    PERSON = 7
    HANDLE = 8
    """Of a door or drawer: like an object, held by pads alone, but part of furniture."""


_BODY_BIT, _FINGER_BIT, _WORLD_BIT, _OBJECT_BIT, _PAD_BIT = 1, 2, 4, 8, 16

CONTYPE: dict[Role, int] = {
    Role.NONE: 0,
    Role.FLOOR: _WORLD_BIT,
    Role.BODY: _BODY_BIT,
    Role.FINGER: _FINGER_BIT,
    Role.PAD: _PAD_BIT,
    Role.FURNITURE: _WORLD_BIT,
    Role.OBJECT: _OBJECT_BIT,
    Role.PERSON: _WORLD_BIT,
    Role.HANDLE: _OBJECT_BIT,
}
CONAFFINITY: dict[Role, int] = {
    Role.NONE: 0,
    Role.FLOOR: _BODY_BIT | _FINGER_BIT | _OBJECT_BIT | _PAD_BIT,
    Role.BODY: _BODY_BIT | _FINGER_BIT,
    Role.FINGER: _FINGER_BIT,
    Role.PAD: _PAD_BIT,
    Role.FURNITURE: _BODY_BIT | _FINGER_BIT | _OBJECT_BIT | _PAD_BIT,
    Role.OBJECT: _BODY_BIT | _OBJECT_BIT | _PAD_BIT,
    Role.PERSON: _BODY_BIT | _FINGER_BIT | _OBJECT_BIT | _PAD_BIT,
    Role.HANDLE: _BODY_BIT | _OBJECT_BIT | _PAD_BIT,
}

DRAWN_GROUP = 2
"""Visual meshes."""
FINGER_DRAWN_GROUP = 1
"""Visual meshes of the fingers: also what hides things from the camera, their hulls being too thick."""
WORLD_GROUP = 0
"""Floor, furniture, objects, persons: drawn and colliding."""
HULL_GROUP = 3
"""The robot's collision shapes."""
UNSEEN_GROUP = 4
"""Collision shapes that hide nothing from the camera: its own head, and the finger hulls."""


_MARK = "scene:"


def in_simulator(name: str) -> str:
    """The simulator's name of a body or geom that a scene calls so: "red cup", "table/top", "Ana/hand"."""
    return _MARK + name


def in_scene(name: str) -> str | None:
    """What the scene calls a body or geom of the simulator; None for what is the robot's or the floor."""
    return name.removeprefix(_MARK) if name.startswith(_MARK) else None
