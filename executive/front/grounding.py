"""The grounding check: what is named in the tasks that a model proposes, and was not said by the person.

A model may hallucinate, or obey a text that it found on a thing. Every noun, colour, number, name and place
of what it proposes stands in the person's own words, or is a synonym of one; what does not is told and asked.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any

from executive.front.said_words import SaidWords
from executive.meaning import Command
from executive.understanding.provenance import Provenance
from executive.vocabulary.written import split_words
from trees.tasks import WHERE_IT_WAS, ObjectDescription, ObjectOf, Relation

_HERE = frozenset({"me", "you", "in_front", "robot", "start", "here", "person", WHERE_IT_WAS})
"""Whom and what nobody has to name."""
_NOT_NAMED = frozenset({"text", "about", "question"})
"""Slots that name nothing: the sentence, and what a question is about."""
_SIDES = {"leftmost": "left", "rightmost": "right"}
_SHORTEST_SPOKEN = 4
"""Letters from which a word to say must have been said: shorter ones hold a sentence together."""


def ungrounded(
    commands: Sequence[tuple[Command, Provenance]], sentences: Mapping[int, str], said: SaidWords
) -> tuple[str, ...]:
    """What is named in commands and was not said, in words for people, each once.

    Args:
        commands: What a model proposes, and where each command comes from.
        sentences: The sentences among the steps, by the step's index: a number counts as it is written there.
        said: What the person said.
    """
    found = [word for command, source in commands for word in _of(command, source.form == "action", said)]
    for step in sorted({source.step for _, source in commands if source.form == "sentence"}):
        own = SaidWords([sentences[step]])
        found += [
            f"{number:g}"
            for number in sorted(own.amounts)
            if not any(said.measures(number * factor) for factor in own.factors)
        ]
    return tuple(dict.fromkeys(found))


def _of(command: Command, structured: bool, said: SaidWords) -> Iterator[str]:
    for field in fields(command):
        value = getattr(command, field.name)
        if field.name in _NOT_NAMED or value == field.default or value is None:
            continue
        if field.name == "words":
            yield from (word for word, _, _ in split_words(value) if not _spoken(word, said))
        elif isinstance(value, bool):
            continue
        elif isinstance(value, int | float):
            if structured and not said.measures(abs(float(value))):
                yield f"{value:g}"
        else:
            yield from _named(value, said)


def _spoken(word: str, said: SaidWords) -> bool:
    return len(word) < _SHORTEST_SPOKEN or said.says(word) or said.names(word)


def _named(value: Any, said: SaidWords) -> Iterator[str]:
    match value:
        case str():
            if value not in _HERE and not (said.names(value) or said.names(_SIDES.get(value, value))):
                yield value.replace("_", " ")
        case ObjectDescription():
            for field in fields(value):
                part = getattr(value, field.name)
                if field.name == "name" and value.kind is not None and part is not None:
                    yield from () if said.names(part) else (part,)
                elif part is not None:
                    yield from _named(part, said)
        case Relation():
            yield from _named(value.to, said)
        case ObjectOf():
            return
        case tuple():
            for part in value:
                yield from _named(part, said)
