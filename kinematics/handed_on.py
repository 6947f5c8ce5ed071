"""The face of a room: names that are loaded when they are first asked for.

Whoever asks a room for one name does not wait for all that it holds: the names of a robot's hands need no
numpy, and a sentence is parsed without a planner.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from typing import Any


def handed_on(room: str, where: Mapping[str, str]) -> Callable[[str], Any]:
    """The ``__getattr__`` of a room's ``__init__``.

    Args:
        room: The package, ``__name__``.
        where: For each name of its face the module of the room that defines it.
    """

    def found(name: str) -> Any:
        if name not in where:
            raise AttributeError(f"module {room!r} has no attribute {name!r}")
        return getattr(importlib.import_module(f"{room}.{where[name]}"), name)

    return found
