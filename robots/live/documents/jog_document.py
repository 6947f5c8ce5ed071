"""What a person's jogging begins with and asks for, as text, and back: read strictly."""

from __future__ import annotations

import json
from typing import Any

from kinematics.arrays import Array
from kinematics.errors import KinematicsError
from kinematics.following.jog_reference import FRAMES, HandJog, Jog, JointJog
from kinematics.formats.json_reader import parse_document
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene
from robots.live.documents.scene_part import SCENE_KEYS, read_scene_part, scene_part

_MOST_M_S, _MOST_RAD_S = 1.0, 4.0
"""More is asked for by nobody; what moves is slower by far."""
_AXES = ("x", "y", "z")


def write_jogging(scene: PlanningScene, model: RobotModel) -> str:
    """The document that jogging begins with: what is around."""
    return json.dumps(scene_part(scene, model), allow_nan=False)


def read_jogging(text: str, model: RobotModel, q: Array) -> PlanningScene:
    """What is around, from such a document.

    Args:
        text: JSON.
        model: The robot.
        q: Its configuration, shape (nq,): where what it holds is.

    Raises:
        KinematicsError: It is none, or not of this robot; with the place and the reason.
    """
    root = parse_document(text)
    root.only(SCENE_KEYS)
    return read_scene_part(root, model, q)


def write_jog(jog: Jog | None) -> str:
    """The document of one word; None brakes."""
    values: dict[str, Any]
    match jog:
        case HandJog(hand, frame, linear_m_s, angular_rad_s):
            values = {"kind": "hand", "hand": hand, "frame": frame}
            values |= {"linear_m_s": linear_m_s.tolist(), "angular_rad_s": angular_rad_s.tolist()}
        case JointJog(joint, rate_rad_s):
            values = {"kind": "joint", "joint": joint, "rate_rad_s": rate_rad_s}
        case None:
            values = {"kind": "brake"}
    return json.dumps(values, allow_nan=False)


def read_jog(text: str, model: RobotModel) -> Jog | None:
    """The word of a document; None brakes.

    Raises:
        KinematicsError: It is none, or not of this robot; with the place and the reason.
    """
    root = parse_document(text)
    kind = root.key("kind").choice(("hand", "joint", "brake"))
    if kind == "brake":
        root.only(("kind",))
        return None
    if kind == "joint":
        root.only(("kind", "joint", "rate_rad_s"))
        joint = root.key("joint").choice(model.joints)
        return JointJog(joint, root.key("rate_rad_s").number(_MOST_RAD_S))
    root.only(("kind", "hand", "frame", "linear_m_s", "angular_rad_s"))
    named, framed = root.key("hand").text(), root.key("frame").text()
    hand = next((one for one in model.description.hands if one == named), None)
    frame = next((one for one in FRAMES if one == framed), None)
    if hand is None or frame is None:
        raise KinematicsError(f"no hand {named[:20]!r} or no frame {framed[:20]!r}")
    linear = root.key("linear_m_s").numbers(_AXES, _MOST_M_S)
    return HandJog(hand, frame, linear, root.key("angular_rad_s").numbers(_AXES, _MOST_RAD_S))
