"""What the robot's perception cannot tell, found out before it looks for it in vain."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterator, Sequence

from executive.meaning import Command
from executive.understanding.canonical_words import vocabulary
from robots.scenes.articulated import PART_KINDS
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.furniture_names import kind_called
from robots.scenes.scene_words import OBJECT_KINDS
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.report_words import listed
from trees.beliefs.openings.handles import INSIDE_KINDS
from trees.beliefs.scene.labels import can_be_told
from trees.tasks import ObjectDescription

_SLOTS = ("object", "source", "on", "to")
THINGS = frozenset({"KIND", "SUBSTANCE", "PAIR", "CONTAINER", "DOOR", "FURNITURE"})
"""Classes of words that name what perception may tell."""
_NO_THINGS = frozenset({"PERSON", "NAME", "ROOM"})
_MOST_TOLD = 12
_SAID_AS = {"drawers": "chest of drawers"}
"""What people call what perception tells."""
_ANYWHERE = frozenset({*OBJECT_KINDS, *FURNITURE_KINDS, *PART_KINDS, *_SAID_AS.values()})
"""What perception can tell in every place."""


def cannot_be_told(commands: Sequence[Command], labels: Collection[str] | None) -> tuple[Command, str] | None:
    """The first command that names a thing which perception cannot tell, with that word; None without one.

    Args:
        commands: What was said.
        labels: The words that perception can tell, in lower case; None: any.
    """
    if labels is None:
        return None
    for command in commands:
        for slot in _SLOTS:
            for word in _things(getattr(command, slot, None)):
                if not is_told(word, labels):
                    return command, word
    return None


def is_told(word: str, labels: Collection[str] | None) -> bool:
    """Whether perception can tell a thing that is called so: a side table is a table.

    Args:
        word: A noun phrase without article, colour or size.
        labels: As for ``cannot_be_told``.
    """
    return labels is None or can_be_told(word, labels) or can_be_told(kind_called(word), labels)


def what_can_be_found(word: str, labels: Collection[str]) -> str:
    """What perception can tell instead of a word: the most alike first, then what is of the place alone."""
    said = {_SAID_AS.get(label, label) for label in labels if label not in INSIDE_KINDS}
    near = difflib.get_close_matches(word, sorted(said), n=2, cutoff=0.6)
    known = sorted(said, key=lambda label: (label in _ANYWHERE, label))
    told = [*near, *(label for label in known if label not in near)]
    more = [] if len(told) <= _MOST_TOLD else [f"{len(told) - _MOST_TOLD} more"]
    return listed([*map(with_article, told[:_MOST_TOLD]), *more])


def _things(said: object) -> Iterator[str]:
    """The words for things in one slot, and in what it is compared with."""
    if isinstance(said, ObjectDescription):
        if said.kind is not None and not _classes(said.kind) & _NO_THINGS:
            yield said.kind
        if said.relation is not None:
            yield from _things(said.relation.to)
    elif isinstance(said, str) and (classes := _classes(said)) & THINGS and not classes & _NO_THINGS:
        yield said


def _classes(word: str) -> frozenset[str]:
    """The classes of all that a word may mean."""
    words = word.lower().split()
    length, readings = vocabulary().match(words)
    return frozenset(one.word_class for one in readings) if length == len(words) else frozenset()
