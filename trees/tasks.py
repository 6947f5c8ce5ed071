"""What a person can ask for, as frozen values; the slots are those of the command-line contract.

Later skills add their own task types and join the ``Task`` union.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.robot_description import Hand


@dataclass(frozen=True, slots=True)
class ObjectDescription:
    """Which object is meant: absent slots say nothing."""

    kind: str | None = None
    color: str | None = None

    def __str__(self) -> str:
        words = [word for word in (self.color, self.kind or "thing") if word]
        return " ".join(words)


@dataclass(frozen=True, slots=True)
class PickTask:
    """Grasp an object and hold it lifted.

    Attributes:
        text: The sentence that it came from.
        object: What to pick.
        source: Where it is said to be ("table"), or None.
        hand: The hand to use, or None for the better one.
    """

    text: str
    object: ObjectDescription
    source: str | None = None
    hand: Hand | None = None

    action = "pick"


@dataclass(frozen=True, slots=True)
class GoHomeTask:
    """Bring arms, trunk and head to the home posture."""

    text: str

    action = "go_home"


Task = PickTask | GoHomeTask
