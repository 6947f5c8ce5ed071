"""What can go wrong while a description is matched; caught where the matching began."""

from __future__ import annotations

from collections.abc import Sequence

from trees.beliefs.scene.believed_thing import BelievedThing


class UntellableError(Exception):
    """Something that was said cannot be told from what is known; the message asks for it.

    Attributes:
        message: The question.
        among: The things that fit otherwise.
    """

    def __init__(self, message: str, among: Sequence[BelievedThing]) -> None:
        self.message, self.among = message, tuple(among)
        super().__init__(message)


class NoneFitsError(Exception):
    """A condition that nothing fulfils.

    Attributes:
        message: What is missing.
        had: Whether anything fitted before this condition.
    """

    def __init__(self, message: str, had: bool) -> None:
        self.message, self.had = message, had
        super().__init__(message)
