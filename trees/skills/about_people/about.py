"""What is going to be told about somebody."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class About:
    """What is going to be told about somebody, and what it rests on.

    Attributes:
        words: The answer.
        whose: The person's name in the planning scene.
        traits: All that was seen of the person.
        known: Whether what was asked is known; else the words say that it is not.
    """

    words: str
    whose: str
    traits: tuple[str, ...]
    known: bool
