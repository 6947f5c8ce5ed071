"""A person's words as messages to a served executive's desk, and back."""

from __future__ import annotations

import numpy as np

from executive.live.desk_messages import Jog
from executive.manual.words import BaseJog, GripJog, JogWord
from kinematics.following.jog_reference import FRAMES, HandJog, JointJog
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from robots.live.wire.errors import ProtocolError

MOVES = ("hand", "joint", "base", "grip", "brake")
_MOST = 10.0
"""m/s or rad/s: more makes no sense."""


def jog_message(word: JogWord | None, may_touch: bool) -> Jog:
    """The message of a word; None brakes."""
    match word:
        case HandJog(hand, frame, linear, angular):
            (x, y, z), (rx, ry, rz) = linear.tolist(), angular.tolist()
            return Jog("hand", hand, frame, x, y, z, rx, ry, rz, may_touch)
        case JointJog(joint, rate_rad_s):
            return Jog("joint", joint, x=rate_rad_s, may_touch=may_touch)
        case BaseJog(linear_m_s, angular_rad_s):
            return Jog("base", x=linear_m_s, rz=angular_rad_s, may_touch=may_touch)
        case GripJog(hand, opens):
            return Jog("grip", hand, x=1.0 if opens else -1.0, may_touch=may_touch)
        case None:
            return Jog("brake", may_touch=may_touch)


def word_of(message: Jog, model: RobotModel) -> JogWord | None:
    """The word of a message; None brakes.

    Raises:
        ProtocolError: It is none of this robot's.
    """
    numbers = (message.x, message.y, message.z, message.rx, message.ry, message.rz)
    if max(map(abs, numbers)) > _MOST:
        raise ProtocolError(f"jog: a velocity beyond {_MOST:g}")
    match message.move:
        case "hand":
            frame = next((one for one in FRAMES if one == message.frame), None)
            if frame is None:
                raise ProtocolError(f"jog: no frame {message.frame[:20]!r}; there are {', '.join(FRAMES)}")
            return HandJog(_hand(message, model), frame, np.array(numbers[:3]), np.array(numbers[3:]))
        case "joint":
            groups = model.description.groups
            legs = {*groups.get("left_leg", ()), *groups.get("right_leg", ())}
            if message.part not in model.joints or message.part in legs:
                raise ProtocolError(f"jog: no joint {message.part[:40]!r} of trunk, arms or head")
            return JointJog(message.part, message.x)
        case "base":
            return BaseJog(message.x, message.rz)
        case "grip":
            return GripJog(_hand(message, model), message.x > 0.0)
        case "brake":
            return None
        case other:
            raise ProtocolError(f"jog: no move {other[:20]!r}; there are {', '.join(MOVES)}")


def _hand(message: Jog, model: RobotModel) -> Hand:
    known = model.description.hands
    found = next((hand for hand in known if hand == message.part), None)
    if found is None:
        raise ProtocolError(f"jog: no hand {message.part[:20]!r}; there are {', '.join(known)}")
    return found
