"""Knobs and buttons as a look shows them, and which of them is meant."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry.poses import Transform
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.fixture import CONTROL_KINDS
from trees.tasks import ObjectDescription

ON_RAD = 1.1
"""How far a knob is turned to switch something on."""
IS_ON_RAD, IS_OFF_RAD = 0.7, 0.2
"""It is on when it is seen turned by so much, and off when by less."""


@dataclass(frozen=True, slots=True)
class ControlTarget(Sealed):
    """A knob or button.

    Attributes:
        name: In the planning scene.
        kind: "knob" or "button".
        called: What it is called with what it belongs to: "stove knob".
        odom_T_control: Its pose, x inwards, shape (4, 4).
    """

    name: str
    kind: str
    called: str
    odom_T_control: Transform

    @property
    def inwards(self) -> Array:
        """Unit vector in which a hand comes to it, shape (3,)."""
        return self.odom_T_control[:3, 0]

    @property
    def faces_front(self) -> bool:
        """Whether it stands out to who stands before it, and not up or down."""
        return abs(float(self.inwards[2])) < _LEVEL

    @property
    def turned_rad(self) -> float:
        """How far a knob is turned, clockwise for who looks at it."""
        left = np.cross((0.0, 0.0, 1.0), self.inwards)
        upwards = self.odom_T_control[:3, 2]
        return math.atan2(-float(upwards @ left), float(upwards[2]))


_LEVEL = 0.3


def controls_in(seen: Mapping[str, ObjectEstimate], kind: str) -> list[ControlTarget]:
    """All of a kind that a look saw, from left to right.

    Args:
        seen: What it saw, by name in the planning scene.
        kind: "knob" or "button".
    """
    found = [
        ControlTarget(name, kind, item.names[0] if item.names else kind, item.odom_T_object)
        for name, item in seen.items()
        if item.kind == kind and item.kind in CONTROL_KINDS
    ]
    return sorted(found, key=lambda one: -float(one.odom_T_control[1, 3]))


def meant_controls(wanted: ObjectDescription, found: list[ControlTarget]) -> list[ControlTarget]:
    """Those that somebody may mean: "the left knob", "the power button", "the stove".

    Args:
        wanted: What is said.
        found: All that are there, from left to right.
    """
    if wanted.name is not None and (named := [one for one in found if one.name == wanted.name]):
        return named
    fitting = found
    if wanted.kind not in CONTROL_KINDS and wanted.kind is not None:
        fitting = [one for one in fitting if _belongs(one, wanted.kind)]
    relation = wanted.relation
    of = None if relation is None else relation.to
    place = of.kind if isinstance(of, ObjectDescription) else of
    if isinstance(place, str):
        fitting = [one for one in fitting if _belongs(one, place)]
    if wanted.ordinal == "leftmost":
        return fitting[:1]
    if wanted.ordinal == "rightmost":
        return fitting[-1:]
    if wanted.ordinal == "middle" and len(fitting) % 2:
        return [fitting[len(fitting) // 2]]
    return fitting


def _belongs(control: ControlTarget, piece: str) -> bool:
    """Whether a control is called by what it belongs to: "stove" of the "flat stove knob"."""
    words = control.called.lower().split()
    said = piece.lower().split()
    return any(words[k : k + len(said)] == said for k in range(len(words)))
