"""An action that a language model writes as a record: "Action: grasp; Object: red cup".

It is read as the sentence that it stands for ("grasp red cup"). How its keys are called is data:
``records.toml``.
"""

from __future__ import annotations

import importlib.resources
import itertools
import re
import tomllib
from collections.abc import Iterator
from functools import cache

_ENTRY = re.compile(r"[\s\-*]*([^\W\d][\w ]{0,14}?)\s*:\s*([^:;,\n]{1,60}?)\s*")
"""A key and its value."""

_BETWEEN = re.compile(r"[;,\n]")
_SIGNS = re.compile(r"[<>\[\]{}|$\\`]")
"""What nobody says, unless it is quoted."""
_RECORD_BEGINS = re.compile(r"\W*(?:\d+\W+)?[^\W\d][\w ]{0,14}?\s*:")
_MORE_THAN_A_PART = re.compile(
    r"\b(?:and|or|then|but|not|before|after|if|when|until|unless|except|without)\b"
)
"""Words of a value that is more than one part of one action."""

_ORDER = ("object", "text", "target", "from", "location", "to", "on", "in", "hand")
_MOST = 12
"""Sentences that one text may stand for."""

Record = list[tuple[str, str]]


@cache
def _data() -> tuple[dict[str, str], dict[str, list[str]]]:
    """What each key is for, and how each part may be said; read when a text first has keys."""
    text = importlib.resources.files("executive.language.words").joinpath("records.toml").read_text("utf-8")
    data = tomllib.loads(text)
    return {key: slot for slot, keys in data["keys"].items() for key in keys}, data["said"]


def sentences_of_records(text: str) -> tuple[str, ...]:
    """The sentences that records may stand for; none where the text is anything else."""
    if _RECORD_BEGINS.match(text) is None or not _BETWEEN.search(text):
        return ()
    records = _records(text)
    if records is None:
        return ()
    spoken = [list(itertools.islice(_spoken(record), _MOST + 1)) for record in records]
    sentences = [". ".join(each) for each in itertools.islice(itertools.product(*spoken), _MOST + 1)]
    return tuple(sentences) if len(sentences) <= _MOST else ()


def _records(text: str) -> list[Record] | None:
    """The records of a text, each with its action first; None where some part of it is none."""
    keys, _ = _data()
    found: list[Record] = []
    for part in _BETWEEN.split(text.strip().rstrip(".;,")):
        entry = _ENTRY.fullmatch(part)
        slot = keys.get(entry.group(1).lower()) if entry else None
        if entry is None or slot is None or _MORE_THAN_A_PART.search(entry.group(2).lower()):
            return None
        if slot == "text" and _SIGNS.search(entry.group(2)):
            return None
        if slot == "action":
            found.append([])
        if not found or any(slot == before for before, _ in found[-1]):
            return None
        found[-1].append((slot, entry.group(2)))
    return found if any(len(record) > 1 for record in found) else None


def _spoken(record: Record) -> Iterator[str]:
    """The ways to say one action."""
    _, said = _data()
    values = dict(record)
    slots = [slot for slot in _ORDER if slot in values]
    for forms in itertools.product(*(said[slot] for slot in slots)):
        parts = (form.format(values[slot]) for slot, form in zip(slots, forms, strict=True))
        yield " ".join((values["action"], *parts))
