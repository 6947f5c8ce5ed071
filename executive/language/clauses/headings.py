"""Headings before a command, which say nothing to do: "Scene one: ...", "Top priority: ..."."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from executive.language.clauses.before_command import NOTHING, STEPS, Numbered, step_number
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Meaning
from executive.language.words.word import Word

_TAKE, _ALONE, _VERB, _PLAN = "take", "alone", "verb", "plan"
"""Meanings: what stands only behind another heading, with nothing beside it, with something; plans."""

_OTHER = "other"
"""Meaning of words with which a plan may take the place of the one before it: "another plan: ..."."""

_PARTS_HEADINGS = frozenset({",", "-", "."})


@dataclass(frozen=True, slots=True)
class _Heading:
    """One part of a heading: "scene one" of "scene one, take two"."""

    sort: str
    number: int | None


def _caption_part(parts: Parts) -> _Heading | None:
    (noun,) = words(parts, "CAPTION")
    counted = words(parts, "NUM", "AMOUNT", "LETTER")
    ordinals = words(parts, "ORDINAL")
    if (noun.meaning == _ALONE and len(parts) > 1) or (noun.meaning == _VERB and len(parts) == 1):
        return None
    if noun.meaning == _PLAN and any(one.meaning == _OTHER for one in words(parts, "CAPTION_WORD")):
        return None
    if len(ordinals) + len(counted) > 1 or any(
        one.meaning not in (*STEPS, "last", "top") for one in ordinals
    ):
        return None
    if counted:
        numbered = step_number(parts)
        return None if numbered is None else _Heading(noun.meaning, numbered.number)
    told = ordinals[0].meaning if ordinals else ""
    return _Heading(noun.meaning, STEPS.index(told) + 1 if told in STEPS else None)


def _captioned(parts: Parts) -> Any:
    *said, last = parts
    if not isinstance(last, Word) or last.meaning != ":":
        return None
    headings = [one for one in said if isinstance(one, _Heading)]
    if any(mark.meaning not in _PARTS_HEADINGS for mark in words(tuple(said), "PAUSE")):
        return None
    if headings[0].sort == _TAKE:
        return None  # "take two: ..." may be an order
    number = headings[0].number
    return NOTHING if number is None else Numbered(number)


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"caption_part": _caption_part, "captioned": _captioned})
