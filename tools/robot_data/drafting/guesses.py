"""What was guessed about a robot, line by line, for a person to look through.

A guess is whatever the URDF does not tell: a value that was measured on its shapes, drawn, or borrowed from
another robot. The list stands beside the description, where the value itself is mended.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Guess:
    """One value that the URDF does not tell.

    Attributes:
        key: Where it stands in ``description.toml``.
        value: As it stands there, or what it comes to.
        why: What it was made from.
    """

    key: str
    value: str
    why: str


class Guesses:
    """All of one robot.

    Attributes:
        all: In the order in which they were made.
    """

    def __init__(self) -> None:
        self.all: list[Guess] = []

    def add(self, key: str, value: str, why: str) -> None:
        """Note one; of the same key the last one counts."""
        self.all = [one for one in self.all if one.key != key]
        self.all.append(Guess(key, value, why))

    def text(self) -> str:
        """One line a guess."""
        return "".join(f"{one.key} = {one.value}\n    {one.why}\n" for one in self.all)
