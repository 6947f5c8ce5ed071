"""A yielding hand's order as text, and back: read strictly, as everything that crosses the socket."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.formats.json_reader import Node, parse_document
from kinematics.formats.solid_document import MAX_POSITION
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.scene.opening_path import DoorArc, DrawerLine, OpeningPath
from robots.control.hands.yield_order import MANNERS, Manner, YieldOrder
from robots.live.documents.scene_part import SCENE_KEYS, read_scene_part, scene_part

_MOST_PARTS = 20
_MOST_WAY = 10.0
"""Radians or metres along a path: more than any door or drawer has."""
_MOST_FELT = 10.0
"""N and Nm that may count as none: a hand that touches nothing feels less than one of them, and who could set
more would set how hard a hand pulls."""
_WRENCH = ("fx", "fy", "fz", "mx", "my", "mz")


def write_yield_order(order: YieldOrder, model: RobotModel) -> str:
    """The document of an order.

    Raises:
        TypeError: Its path is of a kind that has no document.
    """
    return json.dumps(
        {
            "hand": order.hand,
            **scene_part(order.scene, model),
            "parts": list(order.parts),
            "path": _path_json(order.path),
            "s_from": order.s_from,
            "s_to": order.s_to,
            "bias": None if order.bias is None else order.bias.tolist(),
            "stop_from": order.stop_from,
            "holding": order.holding,
            "manner": order.manner,
        },
        allow_nan=False,
    )


def read_yield_order(text: str, model: RobotModel, q: NDArray[np.float64]) -> YieldOrder:
    """The order of a document.

    Args:
        text: JSON.
        model: The robot that shall carry it out.
        q: Its configuration, shape (nq,): where what it holds is.

    Raises:
        KinematicsError: It is none, or not of this robot; with the place and the reason.
    """
    root = parse_document(text)
    root.only(
        tuple(field.name for field in dataclasses.fields(YieldOrder) if field.name != "scene") + SCENE_KEYS
    )
    hands = model.description.gripping_hands
    hand: Hand = "left" if root.key("hand").choice(hands) == "left" else "right"
    manner: Manner = "gentle" if root.key("manner").choice(tuple(MANNERS)) == "gentle" else "usual"
    bias, stop = root.key("bias"), root.key("stop_from")
    holding = root.key("holding")
    if not isinstance(holding.value, bool):
        raise holding.error(f"must be true or false, not {holding.shown()}")
    return YieldOrder(
        hand=hand,
        scene=read_scene_part(root, model, q),
        parts=tuple(item.text() for item in root.key("parts").items(0, _MOST_PARTS)),
        path=_path(root.key("path")),
        s_from=root.key("s_from").number(_MOST_WAY),
        s_to=root.key("s_to").number(_MOST_WAY),
        bias=None if bias.value is None else bias.numbers(_WRENCH, _MOST_FELT),
        stop_from=None if stop.value is None else stop.number(_MOST_WAY),
        holding=holding.value,
        manner=manner,
    )


def _path_json(path: OpeningPath) -> dict[str, Any]:
    if not isinstance(path, DoorArc | DrawerLine):
        raise TypeError(f"no document for a path of kind {type(path).__name__}")
    document: dict[str, Any] = {"kind": "door" if isinstance(path, DoorArc) else "drawer"}
    for field in dataclasses.fields(path):
        value = getattr(path, field.name)
        document[field.name] = value.tolist() if isinstance(value, np.ndarray) else value
    return document


def _path(node: Node) -> OpeningPath:
    if node.key("kind").choice(("door", "drawer")) == "drawer":
        node.only(("kind", "closed_m", "yaw_rad"))
        closed_m = node.key("closed_m").numbers(("x", "y", "z"), MAX_POSITION)
        return DrawerLine(closed_m, node.key("yaw_rad").number(MAX_POSITION))
    node.only(("kind", "hinge_m", "closed_yaw_rad", "side", "radius_m", "standoff_m", "height_m"))
    return DoorArc(
        hinge_m=node.key("hinge_m").numbers(("x", "y"), MAX_POSITION),
        closed_yaw_rad=node.key("closed_yaw_rad").number(MAX_POSITION),
        side=1.0 if node.key("side").number(1.0) > 0.0 else -1.0,
        radius_m=node.key("radius_m").number(MAX_POSITION),
        standoff_m=node.key("standoff_m").number(MAX_POSITION),
        height_m=node.key("height_m").number(MAX_POSITION),
    )
