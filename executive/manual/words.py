"""What a person who has taken the robot over says to it, word by word, and what it says back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from kinematics.following.jog_reference import HandJog, JointJog
from kinematics.model.robot_description import Hand

Ending = Literal["held_left", "held_right", "go_on", "give_up"]
"""What is so when the task is given back: the thing is in a hand, the robot may go on, or may not."""
ENDINGS: tuple[Ending, ...] = get_args(Ending)

WORD_HOLDS_S = 0.15
"""A word that is not repeated within so long was the last one."""


@dataclass(frozen=True, slots=True)
class BaseJog:
    """A velocity of the base: forward speed, and turning speed to the left."""

    linear_m_s: float
    angular_rad_s: float


@dataclass(frozen=True, slots=True)
class GripJog:
    """Fingers that open or close."""

    hand: Hand
    opens: bool


TakenOver = Literal["in its middle", "after its failure", "from the beginning"]
"""When a person took a task over; a record keeps it, so that a replay does so at the same point."""
TAKEN_OVER: tuple[TakenOver, ...] = get_args(TakenOver)

BY_HAND = "jog the robot"


@dataclass(frozen=True, slots=True)
class ByHandTask:
    """What is carried out while a person jogs the robot and no task was to be continued."""

    text: str

    action = "jog"


JogWord = HandJog | JointJog | BaseJog | GripJog


@dataclass(frozen=True, slots=True)
class HeardWord:
    """A word with the control time at which it came, and its number."""

    word: JogWord
    heard_s: float
    number: int


class JogFeed:
    """Between whoever listens to the person and whoever moves the robot.

    Attributes:
        asked: Whether a person wants to take over what is under way.
        active: Whether a person has the robot now.
        newest: The newest word, or None; a space bar takes it back.
        ending: What is so, once the person has given the robot back; None until then.
        may_touch: Whether fingers may come near to what can be picked up.
        told: What holds the robot back, for people; empty when nothing does.
    """

    def __init__(self) -> None:
        self.asked = self.active = self.may_touch = False
        self.newest: HeardWord | None = None
        self.ending: Ending | None = None
        self.told = ""
        self._count = 0

    def take_over(self) -> None:
        """Ask for the robot."""
        self.asked, self.ending, self.newest, self.told = True, None, None, ""

    def say(self, word: JogWord, now_s: float) -> None:
        """Say a word in the place of the one before."""
        self._count += 1
        self.newest = HeardWord(word, now_s, self._count)

    def brake(self) -> None:
        """Come to rest now."""
        self.newest = None

    def hand_back(self, ending: Ending) -> None:
        """Give the robot back, and say what is so."""
        self.ending = ending
        self.newest = None

    def fresh(self, now_s: float) -> HeardWord | None:
        """The newest word while it is good."""
        newest = self.newest
        return newest if newest is not None and now_s - newest.heard_s < WORD_HOLDS_S else None
