"""What can go wrong while a description is matched; caught where the matching began."""

from __future__ import annotations

from collections.abc import Sequence

from trees.beliefs.scene.believed_thing import BelievedThing


class UntellableError(Exception):
    """The description says something that the robot cannot tell of things, such as what they are made of.

    Attributes:
        message: The question that a person has to answer.
        among: The things that fit all else of the description.
    """

    def __init__(self, message: str, among: Sequence[BelievedThing]) -> None:
        self.message, self.among = message, tuple(among)
        super().__init__(message)


class NoneFitsError(Exception):
    """No thing fulfils one of the conditions of the description.

    Attributes:
        message: What is missing.
        had: Whether some thing fulfilled all conditions before this one.
    """

    def __init__(self, message: str, had: bool) -> None:
        self.message, self.had = message, had
        super().__init__(message)
