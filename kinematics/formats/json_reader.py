"""A JSON document read strictly: every error names the place and, for a misspelt word, the nearest."""

from __future__ import annotations

import difflib
import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.errors import TrajectoryDocumentError

_SHOWN = 40
"""Longer values are cut where an error repeats them."""
_BYTE_ORDER_MARK = "\ufeff"
MAX_TEXT = 200
"""No name is longer."""


class _DoubledError(Exception):
    pass


def parse_document(text: str) -> Node:
    """The root of a JSON document.

    Raises:
        TrajectoryDocumentError: It is no JSON, is nested too deeply, or has a key twice.
    """
    try:
        return Node(
            "document", json.loads(text.removeprefix(_BYTE_ORDER_MARK), object_pairs_hook=_no_doubles)
        )
    except _DoubledError as doubled:
        raise TrajectoryDocumentError("document", f"the key {doubled.args[0]!r} is there twice") from None
    except RecursionError:
        raise TrajectoryDocumentError("document", "is nested too deeply") from None
    except ValueError as broken:
        raise TrajectoryDocumentError("document", f"is no JSON: {broken}") from None


def _no_doubles(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    table = dict(pairs)
    if len(table) < len(pairs):
        keys = [key for key, _ in pairs]
        raise _DoubledError(next(key for key in keys if keys.count(key) > 1))
    return table


class Node:
    """One value of a document and its place."""

    __slots__ = ("place", "value")

    def __init__(self, place: str, value: Any) -> None:
        self.place, self.value = place, value

    def error(self, reason: str) -> TrajectoryDocumentError:
        """An error at this place."""
        return TrajectoryDocumentError(self.place, reason)

    def shown(self) -> str:
        """The value, shortened to be repeated in an error."""
        return _shown(self.value)

    def has(self, key: str) -> bool:
        """Whether this object has a key."""
        return key in self.value

    def only(self, needed: Sequence[str], optional: Sequence[str] = ()) -> None:
        """Refuse anything but an object with these keys."""
        if not isinstance(self.value, dict):
            raise self.error(f"must be an object, not {self.shown()}")
        known = [*needed, *optional]
        for key in self.value:
            if key not in known:
                close = difflib.get_close_matches(key, known, n=1)
                hint = f"did you mean {close[0]!r}?" if close else f"known are {', '.join(known)}"
                raise self.error(f"unknown key {_shown(key)}; {hint}")
        for key in needed:
            if key not in self.value:
                raise self.error(f"{key!r} is missing")

    def key(self, key: str) -> Node:
        """One value of an object."""
        if not isinstance(self.value, dict) or key not in self.value:
            raise self.error(f"must be an object with {key!r}")
        return Node(key if self.place == "document" else f"{self.place}.{key}", self.value[key])

    def entries(self, most: int) -> list[tuple[str, Node]]:
        """Keys and values of an object that names things."""
        if not isinstance(self.value, dict):
            raise self.error(f"must be an object, not {self.shown()}")
        if len(self.value) > most:
            raise self.error(f"has {len(self.value)} entries, more than {most}")
        return [(key, Node(f"{self.place}.{key}", value)) for key, value in self.value.items()]

    def items(self, least: int, most: int) -> list[Node]:
        """The values of a list of a bounded length."""
        if not isinstance(self.value, list):
            raise self.error(f"must be a list, not {self.shown()}")
        if not least <= len(self.value) <= most:
            wanted = f"{least}" if least == most else f"{least} to {most}"
            raise self.error(f"must have {wanted} entries, not {len(self.value)}")
        return [Node(f"{self.place}[{i}]", value) for i, value in enumerate(self.value)]

    def text(self) -> str:
        """A name."""
        if not isinstance(self.value, str) or not self.value.strip() or len(self.value) > MAX_TEXT:
            raise self.error(f"must be a text of 1 to {MAX_TEXT} characters, not {self.shown()}")
        return self.value

    def choice(self, known: Sequence[str]) -> str:
        """One of some words."""
        if self.value not in known:
            raise self.error(f"must be one of {', '.join(known)}, not {self.shown()}")
        return str(self.value)

    def truth(self) -> bool:
        """True or false."""
        if not isinstance(self.value, bool):
            raise self.error(f"must be true or false, not {self.shown()}")
        return self.value

    def number(self, most: float, positive: bool = False) -> float:
        """A finite number of at most this size."""
        value = self.value
        if type(value) is not float and type(value) is not int:
            raise self.error(f"must be a number, not {self.shown()}")
        # compared before it is made a float: a huge integer has none; NaN compares false
        if not -most <= value <= most:
            raise self.error(f"must be a finite number within ±{most:g}, not {self.shown()}")
        if positive and value <= 0:
            raise self.error(f"must be above 0, not {self.shown()}")
        return float(value)

    def numbers(self, names: Sequence[str], most: float, positive: bool = False) -> Array:
        """A list of finite numbers, one for each name, shape (len(names),)."""
        value = self.value
        if not isinstance(value, list):
            raise self.error(f"must be a list of {len(names)} numbers, not {self.shown()}")
        if len(value) != len(names):
            raise self.error(f"must have {len(names)} numbers, not {len(value)}")
        for i, item in enumerate(value):
            fine = (type(item) is float or type(item) is int) and -most <= item <= most
            if not fine or (positive and item <= 0):
                Node(f"{self.place}[{i}] ({names[i]})", item).number(most, positive)
        return np.array(value, dtype=np.float64)


def _shown(value: Any) -> str:
    if isinstance(value, dict | list):
        return "an object" if isinstance(value, dict) else "a list"
    try:
        text = json.dumps(value)
    except ValueError:  # an integer of more digits than Python prints
        text = "a huge number"
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "…"
