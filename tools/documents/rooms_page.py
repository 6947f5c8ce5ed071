"""The page of the rooms: every package of every floor, in the order of the layers, in its own words."""

from __future__ import annotations

from collections.abc import Iterator

from tools.documents.markdown import table
from tools.documents.rooms import FLOORS, layers, packages, says

_HEAD = """\
# The rooms

Every package, floor by floor, from the top down. A room is one concept; the sentence beside it is the first
of its `__init__.py`. `pyproject.toml` holds the order: a room imports only what stands below it. How the
floors work together is told in [architecture](architecture.md).

![Floors and rooms, imports go down](../pictures/rooms.svg)
"""
_WIDE = ("trees.skills", "trees.beliefs", "robots.control", "robots.live", "robots.simulated")
_WIDER = ("kinematics.walking", "executive.live", "executive.language")


def rooms_page() -> str:
    """The page: a table for each floor."""
    parts = [_HEAD]
    for floor in FLOORS:
        parts += [f"## {floor}\n", table(("room", "what it is"), _rows(floor))]
    return "\n".join(parts)


def _rows(floor: str) -> Iterator[tuple[str, str]]:
    there = packages(floor)
    ordered = [name.split(".")[0] for row in layers(floor) for name in row]
    for name in dict.fromkeys(name for name in (*ordered, *there) if name in there):
        room = f"{floor}.{name}"
        yield f"`{room}`", says(room)
        if room in (*_WIDE, *_WIDER):
            for inner in packages(room):
                if says(f"{room}.{inner}"):
                    yield f"`{room}.{inner}`", says(f"{room}.{inner}")
