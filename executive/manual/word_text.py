"""A person's words as text for the record of a run, and back, to the last digit."""

from __future__ import annotations

import json
import math
from typing import Any, TypeVar

import numpy as np

from executive.manual.words import BaseJog, GripJog, JogWord
from kinematics.arrays import Array
from kinematics.following.jog_reference import FRAMES, HandJog, JointJog
from kinematics.model.robot_description import HANDS

C = TypeVar("C", bound=str)


def write_word(word: JogWord | None, may_touch: bool) -> str:
    """The text of what was said.

    Args:
        word: The word; None brakes.
        may_touch: Whether fingers may come near to what can be picked up.
    """
    values: dict[str, Any]
    match word:
        case HandJog(hand, frame, linear_m_s, angular_rad_s):
            values = {"hand": hand, "frame": frame}
            values |= {"linear_m_s": linear_m_s.tolist(), "angular_rad_s": angular_rad_s.tolist()}
        case JointJog(joint, rate_rad_s):
            values = {"joint": joint, "rate_rad_s": rate_rad_s}
        case BaseJog(linear_m_s, angular_rad_s):
            values = {"base_m_s": linear_m_s, "base_rad_s": angular_rad_s}
        case GripJog(hand, opens):
            values = {"fingers": hand, "opens": opens}
        case None:
            values = {}
    return json.dumps(values | ({"may_touch": True} if may_touch else {}), allow_nan=False)


def read_word(text: str) -> tuple[JogWord | None, bool]:
    """What was said, and whether fingers might touch.

    Raises:
        ValueError: It is no such text.
    """
    values = json.loads(text)
    if not isinstance(values, dict):
        raise ValueError(f"a word is a table, not {text[:40]!r}")
    may_touch = values.pop("may_touch", False) is True
    match values:
        case {"hand": hand, "frame": frame, "linear_m_s": linear, "angular_rad_s": angular}:
            named, axes = _one_of(HANDS, hand), _one_of(FRAMES, frame)
            return HandJog(named, axes, _three(linear), _three(angular)), may_touch
        case {"joint": str(joint), "rate_rad_s": rate}:
            return JointJog(joint, _number(rate)), may_touch
        case {"base_m_s": linear, "base_rad_s": angular}:
            return BaseJog(_number(linear), _number(angular)), may_touch
        case {"fingers": hand, "opens": bool(opens)}:
            return GripJog(_one_of(HANDS, hand), opens), may_touch
        case {}:
            if not values:
                return None, may_touch
    raise ValueError(f"no word of a person: {text[:80]!r}")


def _one_of(known: tuple[C, ...], value: object) -> C:
    found = next((one for one in known if one == value), None)
    if found is None:
        raise ValueError(f"no {str(value)[:20]!r}; there are {', '.join(known)}")
    return found


def _three(values: object) -> Array:
    if not isinstance(values, list) or len(values) != 3:
        raise ValueError(f"not three numbers: {str(values)[:40]!r}")
    return np.array([_number(value) for value in values])


def _number(value: object) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not math.isfinite(value):
        raise ValueError(f"not a number: {str(value)[:20]!r}")
    return float(value)
