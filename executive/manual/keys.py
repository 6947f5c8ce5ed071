"""From keys to words: modes, frames, speeds, and steps; pure, so that it is known without a terminal.

In each mode a key has one meaning. Keys of every mode are those of ``COMMON``; a mode's own are in ``KEYS``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Literal

import numpy as np

from executive.manual.words import WORD_HOLDS_S, BaseJog, GripJog, JogWord
from kinematics.following.jog_reference import HandJog, JogFrame, JointJog
from kinematics.model.robot_description import Hand, RobotDescription

Mode = Literal["hand", "joints", "base"]
Pace = Literal["slow", "usual", "fast"]

LINEAR_M_S: Mapping[Pace, float] = MappingProxyType({"slow": 0.015, "usual": 0.05, "fast": 0.12})
ANGULAR_RAD_S: Mapping[Pace, float] = MappingProxyType({"slow": 0.08, "usual": 0.2, "fast": 0.4})
JOINT_RAD_S: Mapping[Pace, float] = MappingProxyType({"slow": 0.06, "usual": 0.15, "fast": 0.3})
BASE_SHARE: Mapping[Pace, float] = MappingProxyType({"slow": 0.4, "usual": 0.7, "fast": 1.0})
"""Of the highest speeds of the base."""
BASE_M_S, BASE_RAD_S = 0.3, 0.4
"""Highest speeds of the base that keys ask for."""

COMMON: Mapping[str, str] = MappingProxyType(
    {
        "h": "mode hand",
        "n": "mode joints",
        "b": "mode base",
        "x": "other hand",
        "z": "next speed",
        "s": "step or hold",
        "g": "close fingers",
        "f": "open fingers",
        "[": "head left",
        "]": "head right",
        "-": "head down",
        "=": "head up",
        "p": "fingers may touch",
        " ": "brake",
        "enter": "give back",
    }
)
"""What keys mean in every mode."""
_HAND: Mapping[str, tuple[int, ...]] = MappingProxyType(
    {
        "up": (1, 0, 0, 0, 0, 0),
        "down": (-1, 0, 0, 0, 0, 0),
        "left": (0, 1, 0, 0, 0, 0),
        "right": (0, -1, 0, 0, 0, 0),
        ";": (0, 0, 1, 0, 0, 0),
        ".": (0, 0, -1, 0, 0, 0),
        "u": (0, 0, 0, 1, 0, 0),
        "o": (0, 0, 0, -1, 0, 0),
        "i": (0, 0, 0, 0, 1, 0),
        "k": (0, 0, 0, 0, -1, 0),
        "j": (0, 0, 0, 0, 0, 1),
        "l": (0, 0, 0, 0, 0, -1),
    }
)
"""Along and about the axes of the frame."""
_FRAMES: Mapping[str, JogFrame] = MappingProxyType({"w": "world", "e": "tool", "q": "base"})
_BASE: Mapping[str, tuple[int, int]] = MappingProxyType(
    {
        "u": (1, 1),
        "i": (1, 0),
        "o": (1, -1),
        "j": (0, 1),
        "k": (0, 0),
        "l": (0, -1),
        "m": (-1, -1),
        ",": (-1, 0),
        ".": (-1, 1),
    }
)
_JOINTS = tuple("1234567")
_HEAD: Mapping[str, tuple[int, int]] = MappingProxyType(
    {"[": (0, 1), "]": (0, -1), "-": (1, 1), "=": (1, -1)}
)
KEYS: Mapping[Mode, frozenset[str]] = MappingProxyType(
    {
        "hand": frozenset((*_HAND, *_FRAMES)),
        "joints": frozenset((*_JOINTS, "r")),
        "base": frozenset(_BASE),
    }
)
"""The keys of each mode alone."""


@dataclass(frozen=True, slots=True)
class Jogged:
    """What a person has chosen so far.

    Attributes:
        mode: What the keys of the mode move.
        hand: Which hand, and which arm's joints and fingers.
        frame: Whose axes the hand goes along.
        pace: How fast.
        steps: Whether a key makes one step and a key held down none more.
        reversed: Whether joints go the other way.
        may_touch: Whether fingers may come near to what can be picked up.
    """

    mode: Mode = "hand"
    hand: Hand = "right"
    frame: JogFrame = "world"
    pace: Pace = "usual"
    steps: bool = False
    reversed: bool = False
    may_touch: bool = False


@dataclass(frozen=True, slots=True)
class Pressed:
    """What becomes of one key.

    Attributes:
        jogged: What is chosen now.
        word: What is said to the robot, or None.
        brakes: Whether it comes to rest now.
        gives_back: Whether the person wants to give the robot back.
        known: Whether the key means anything here.
    """

    jogged: Jogged
    word: JogWord | None = None
    brakes: bool = False
    gives_back: bool = False
    known: bool = True


class JogKeys:
    """Takes keys with their times, and makes words of them.

    Args:
        arms: Joints of each arm, in the order of the keys ``1`` to ``7``.
        head: The head's joints, the turning one first; may be empty.
        jogged: What is chosen at the beginning.
    """

    def __init__(
        self, arms: Mapping[Hand, tuple[str, ...]], head: tuple[str, ...] = (), jogged: Jogged | None = None
    ) -> None:
        hands = tuple(arms)
        first: Hand = "right" if "right" in hands or not hands else hands[0]
        self._arms, self._head = dict(arms), head
        self._last: tuple[str, float] | None = None
        self.jogged = jogged or Jogged(hand=first)

    def press(self, key: str, t_s: float) -> Pressed:
        """Take a key: a character, "up", "down", "left", "right" or "enter".

        Args:
            key: Which.
            t_s: When, on any clock that goes on.
        """
        last, self._last = self._last, (key, t_s)
        pressed = self._meaning(key)
        self.jogged = pressed.jogged
        repeated = last is not None and last[0] == key and t_s - last[1] <= WORD_HOLDS_S
        if self.jogged.steps and repeated and pressed.word is not None:
            return replace(pressed, word=None)
        return pressed

    def _meaning(self, key: str) -> Pressed:
        now = self.jogged
        if key in COMMON:
            return self._common(key, now)
        match now.mode:
            case "hand" if key in _FRAMES:
                return Pressed(replace(now, frame=_FRAMES[key]))
            case "hand" if key in _HAND:
                way = np.array(_HAND[key], dtype=float)
                linear, angular = LINEAR_M_S[now.pace] * way[:3], ANGULAR_RAD_S[now.pace] * way[3:]
                return Pressed(now, HandJog(now.hand, now.frame, linear, angular))
            case "joints" if key == "r":
                return Pressed(replace(now, reversed=not now.reversed))
            case "joints" if key in _JOINTS:
                return self._joint(int(key) - 1, now)
            case "base" if key in _BASE:
                forward, turn = _BASE[key]
                share = BASE_SHARE[now.pace]
                word = BaseJog(share * BASE_M_S * forward, share * BASE_RAD_S * turn)
                return Pressed(now, word, brakes=not (forward or turn))
        return Pressed(now, known=False)

    def _common(self, key: str, now: Jogged) -> Pressed:
        if key in _HEAD:
            return self._turn_head(*_HEAD[key], now)
        paces: tuple[Pace, ...] = ("slow", "usual", "fast")
        match key:
            case "h":
                return Pressed(replace(now, mode="hand"))
            case "n":
                return Pressed(replace(now, mode="joints"))
            case "b":
                return Pressed(replace(now, mode="base"))
            case "x":
                other: Hand = "left" if now.hand == "right" else "right"
                return Pressed(replace(now, hand=other) if other in self._arms else now)
            case "z":
                return Pressed(replace(now, pace=paces[(paces.index(now.pace) + 1) % len(paces)]))
            case "s":
                return Pressed(replace(now, steps=not now.steps))
            case "p":
                return Pressed(replace(now, may_touch=not now.may_touch))
            case "g" | "f":
                return Pressed(now, GripJog(now.hand, opens=key == "f"))
            case "enter":
                return Pressed(now, brakes=True, gives_back=True)
            case _:
                return Pressed(now, brakes=True)

    def _joint(self, number: int, now: Jogged) -> Pressed:
        joints = self._arms.get(now.hand, ())
        if number >= len(joints):
            return Pressed(now, known=False)
        rate = JOINT_RAD_S[now.pace] * (-1.0 if now.reversed else 1.0)
        return Pressed(now, JointJog(joints[number], rate))

    def _turn_head(self, number: int, sign: int, now: Jogged) -> Pressed:
        if number >= len(self._head):
            return Pressed(now, known=False)
        return Pressed(now, JointJog(self._head[number], sign * JOINT_RAD_S[now.pace]))


def keys_for(description: RobotDescription, jogged: Jogged | None = None) -> JogKeys:
    """The keys of a robot: its arms with fingers, and its head."""
    groups = description.groups
    arms = {hand: tuple(groups[f"{hand}_arm"]) for hand in description.tcp_frames}
    return JogKeys(arms, tuple(groups.get("head", ())), jogged)
