"""What the robot's perception cannot tell, found out before it looks for it in vain."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterator, Sequence

from executive.meaning import Command
from executive.understanding.canonical_words import vocabulary
from robots.scenes.furniture_names import kind_called
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.report_words import listed
from trees.beliefs.scene.called import can_be_told
from trees.tasks import ObjectDescription

_SLOTS = ("object", "source", "on", "to")
_NO_THINGS = frozenset({"PERSON", "NAME", "ROOM"})
_MOST_TOLD = 12


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
                if not can_be_told(word, labels) and not can_be_told(kind_called(word), labels):
                    return command, word
    return None


def what_can_be_found(word: str, labels: Collection[str]) -> str:
    """What perception can tell instead of a word, what is spelled most alike first: "a can, a cup and ..."."""
    near = difflib.get_close_matches(word, sorted(labels), n=2, cutoff=0.6)
    told = [*near, *(label for label in sorted(labels) if label not in near)]
    more = [] if len(told) <= _MOST_TOLD else [f"{len(told) - _MOST_TOLD} more"]
    return listed([*map(with_article, told[:_MOST_TOLD]), *more])


def _things(said: object) -> Iterator[str]:
    """The words for things in one slot, and in what it is compared with."""
    if isinstance(said, ObjectDescription):
        if said.kind is not None and not _is_no_thing(said.kind, unknown=False):
            yield said.kind
        if said.relation is not None:
            yield from _things(said.relation.to)
    elif isinstance(said, str) and not _is_no_thing(said, unknown=True):
        yield said


def _is_no_thing(word: str, *, unknown: bool) -> bool:
    """Whether a word may mean somebody or a room; ``unknown`` is the answer for what no list has."""
    words = word.lower().split()
    length, readings = vocabulary().match(words)
    if length != len(words) or not readings:
        return unknown
    return any(one.word_class in _NO_THINGS for one in readings)
