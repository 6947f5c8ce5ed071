"""The tree under way, and what is believed, as JSON values for programs beside the robot.

Both are cut to what fits a message of the protocol: long texts are shortened, and of a crowd of things the
nearest are told.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from kinematics.scene.free_spots import footprint_radius_m
from trees.beliefs.scene.believed_thing import BelievedThing, Surroundings
from trees.snapshot import NodeSnapshot

_LONGEST = 160
"""Characters of a text."""
_MOST_BYTES = 40_000
"""Of either as it is written: a message of the protocol holds 65,536, and what else a status says."""


def tree_json(root: NodeSnapshot) -> list[Mapping[str, Any]]:
    """The nodes of a tree from the root down, each with its depth.

    Where they are too many for a message the idle ones are left out, and then the last.
    """
    nodes = list(_nodes(root, 0))
    if len(beginning(nodes)) < len(nodes):
        nodes = [one for one in nodes if one["status"] != "idle"]
    return beginning(nodes)


def statuses(node: NodeSnapshot) -> str:
    """The first letter of each node's status, from the root down; none is left out."""
    return node.status[0] + "".join(map(statuses, node.children))


def beginning(told: list[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """As many of the first values as fit a message beside what else a status says."""
    ends = np.cumsum([len(json.dumps(one)) + 1 for one in told])
    return told[: int(np.searchsorted(ends, _MOST_BYTES, side="right"))]


def _nodes(node: NodeSnapshot, depth: int) -> Sequence[Mapping[str, Any]]:
    told = {
        "depth": depth,
        "name": node.name[:_LONGEST],
        "status": node.status,
        "message": node.message[:_LONGEST],
    }
    return [told, *(below for child in node.children for below in _nodes(child, depth + 1))]


def scene_json(around: Surroundings) -> list[Mapping[str, Any]]:
    """What is believed to be around the robot, what its hands hold first, then the nearest.

    Places are in metres from the point on the floor below the base: x ahead, y to the left, z up.
    """
    held = [{"name": name, "words": label.words, "held": True} for name, label in around.held.items()]
    things = sorted(around.things, key=lambda one: float(np.hypot(*one.place_m[:2])))
    return beginning([*held, *map(_thing, things)])


def _thing(one: BelievedThing) -> Mapping[str, Any]:
    label = one.label
    told = {
        "name": one.name,
        "words": one.words,
        "kind": one.kind,
        "color": one.color,
        "names": list(label.names),
        "categories": list(label.categories),
        "traits": list(label.traits),
        "is": "object" if one.movable else "person" if one.is_person else "furniture",
        "on": one.support,
        "place_m": [round(float(value), 3) for value in one.place_m],
        "height_m": round(2.0 * one.half_height_m, 3),
        "radius_m": round(footprint_radius_m(one.shape), 3),
    }
    return {key: value for key, value in told.items() if value not in (None, [])}
