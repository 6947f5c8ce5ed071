"""What a thing is called."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Label:
    """What a thing is called, as perception tells it.

    Attributes:
        kind: What it is, out of an open vocabulary: "cup", "can", "teapot".
        color: Its colour, or None when it could not be told.
        names: What it is called besides, the usual name first: "tomato soup".
        categories: What sorts of things it belongs to: "food", "groceries".
        traits: What is seen of a person: "sitting", "waving", "red shirt".
    """

    kind: str
    color: str | None = None
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()
    traits: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """How people are told of it: by its name, or by colour, if known, and kind."""
        if self.names:
            return self.names[0]
        return self.kind if self.color is None else f"{self.color} {self.kind}"
