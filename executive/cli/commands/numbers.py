"""Numbers on the command line: a wrong one is named with what it may be."""

from __future__ import annotations

import math
from collections.abc import Callable

import typer


def number_from(low: float, high: float) -> Callable[[str | float], float]:
    """A reader of numbers in a range; typer hands it defaults as numbers."""

    def read(text: str | float) -> float:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not low <= value <= high:
            raise typer.BadParameter(f"{text!r} is not a number from {low:g} to {high:g}")
        return value

    return read


def whole_number_from(low: int, high: int | None = None) -> Callable[[str | int], int]:
    """A reader of whole numbers from ``low`` on, to ``high`` if there is one; as ``number_from``."""
    allowed = f"{low} or more" if high is None else f"from {low} to {high}"

    def read(text: str | int) -> int:
        try:
            value = int(text)
        except ValueError:
            value = low - 1
        if value < low or (high is not None and value > high):
            raise typer.BadParameter(f"{text!r} is not a whole number {allowed}")
        return value

    return read
