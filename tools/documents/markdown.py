"""Pieces of Markdown pages, and what docstrings say of a class and its fields."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Sequence

_FIELD = re.compile(r"^ {4}(?P<names>\w+(?:, \w+)*): (?P<text>.*)$")


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; a bar inside a cell is escaped."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(_cell(cell) for cell in line)} |" for line in lines) + "\n"


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")


def summary(of: type) -> str:
    """The first paragraph of a class's own docstring, on one line."""
    return " ".join((inspect.getdoc(of) or "").partition("\n\n")[0].split())


def attributes(of: type) -> dict[str, str]:
    """What the section ``Attributes`` of a class's docstring says of each name."""
    _, _, section = (inspect.getdoc(of) or "").partition("Attributes:\n")
    said: dict[str, str] = {}
    names: list[str] = []
    for line in section.splitlines():
        begun = _FIELD.match(line)
        if begun:
            names = begun["names"].split(", ")
            said.update(dict.fromkeys(names, begun["text"]))
        elif line.startswith(" " * 8):
            said.update({name: f"{said[name]} {line.strip()}" for name in names})
        else:
            break
    return said
