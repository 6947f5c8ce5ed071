"""A person at keys: what is chosen, what is said to the robot, and the end, when it is asked what is so."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Protocol

from executive.manual.keys import Jogged, JogKeys
from executive.manual.words import Ending, JogWord

ENDING_KEYS: Mapping[str, Ending] = MappingProxyType(
    {"1": "held_right", "2": "held_left", "3": "go_on", "4": "give_up"}
)
"""The keys that say what is so when the robot is given back; any other goes on jogging."""


class Listener(Protocol):
    """Whoever is told what a person says."""

    def say(self, word: JogWord | None, may_touch: bool) -> None:
        """Say a word; None brakes."""
        ...

    def hand_back(self, ending: Ending) -> None:
        """Give the robot back, and say what is so."""
        ...


class JogConsole:
    """Takes keys, and tells the robot.

    Args:
        keys: What keys mean.
        robot: Who is told.

    Attributes:
        ending: Whether the person is asked what is so.
        given_back: How the robot was given back, or None.
    """

    def __init__(self, keys: JogKeys, robot: Listener) -> None:
        self._keys, self._robot = keys, robot
        self.ending = False
        self.given_back: Ending | None = None

    @property
    def jogged(self) -> Jogged:
        """What is chosen."""
        return self._keys.jogged

    def press(self, key: str, t_s: float) -> None:
        """Take a key.

        Args:
            key: Its name.
            t_s: When, on any clock that goes on.
        """
        if self.ending:
            self.ending = False
            if key in ENDING_KEYS:
                self.given_back = ENDING_KEYS[key]
                self._robot.hand_back(ENDING_KEYS[key])
            return
        pressed = self._keys.press(key, t_s)
        if pressed.brakes or pressed.word is not None:
            self._robot.say(None if pressed.brakes else pressed.word, pressed.jogged.may_touch)
        self.ending = pressed.gives_back
