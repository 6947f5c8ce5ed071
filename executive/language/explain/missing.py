"""What a sentence leaves out, asked for: "put the bowl" (where?), "pick up" (what?), "the red cup".

A sentence breaks off where the grammar goes on behind its last word with one of the word classes that
"explanations.toml" lists for a gap. Nothing is ever filled in; it is only asked about.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from typing import Any

from executive.language.chart.chart import Chart
from executive.language.explain.refusals import begins_clause, explanations
from executive.language.phrases.values import Item, Items, Where
from executive.language.text.lattice import Lattice
from executive.language.text.word import Word
from executive.meaning import Question

MAX_WORDS, _LONGEST = 30, 5
"""Words of a sentence whose end is looked for, and of its last phrase."""

_NAMED = frozenset({"thing", "container", "furniture", "door"})


def what_is_missing(lattice: Lattice, chart: Chart) -> Question | None:
    """The question for what a sentence leaves out; None where it is whole, or more than that is wrong."""
    if not lattice.pieces or len(lattice.pieces) > MAX_WORDS or lattice.unknown():
        return None
    return _only_named(lattice, chart) or next(_questions(lattice, chart), None)


def _questions(lattice: Lattice, chart: Chart) -> Iterator[Question]:
    """The question for each gap that there may be at the end of the sentence."""
    end = _end(lattice, 0)
    if chart.furthest < end or not end:
        return
    before = lattice.plain[: lattice.pieces[end - 1].end]
    behind = lattice.plain[lattice.pieces[end - 1].end :]
    expected = chart.expected_at(end)
    last = _last_phrase(lattice, end)
    for gap in explanations()["missing"]:
        fitting = [word.start for word in last if word.word_class in gap["after"]]
        begins = not gap.get("begins") or any(begins_clause(lattice, start) for start in fitting)
        follows = begins and not expected.isdisjoint(gap["expects"])
        if fitting and follows and _is_behind(lattice, fitting[0], gap, chart):
            yield _asked(gap, before, behind, expected)


def _end(lattice: Lattice, start: int) -> int:
    """Where what is said from a place on ends, before the last courtesies."""
    return next(one for one in range(start, len(lattice.pieces) + 1) if lattice.ends[one])


def _asked(gap: Mapping[str, Any], before: str, behind: str, expected: AbstractSet[str]) -> Question:
    """The question for a gap; of units, which of them fit."""
    completes = (f"{before} ", behind)
    fitting = [unit for name, unit in gap.get("units", {}).items() if name in expected]
    if not fitting:
        return Question(f"{before} {gap['asks']}?", completes=completes)
    choices = tuple(f"{before} {unit}{behind}".rstrip(" .!?") for unit in fitting)
    return Question(f"{before} {gap['asks']}: {' or '.join(fitting)}?", choices, completes)


def _last_phrase(lattice: Lattice, end: int) -> list[Word]:
    """The readings of the longest phrase that ends at a place."""
    phrases = (
        [one for one in lattice.phrases[at] if one.end == end] for at in range(max(0, end - _LONGEST), end)
    )
    return next(filter(None, phrases), [])


def _is_behind(lattice: Lattice, place: int, gap: Mapping[str, Any], chart: Chart) -> bool:
    """Whether the last verb before a place is one that leaves the gap, if that matters."""
    for start in range(place - 1, -1, -1) if "verbs" in gap else ():
        longest = max((word.end for word in lattice.phrases[start]), default=start)
        classes = {word.word_class for word in lattice.phrases[start] if word.end == longest}
        if not classes.isdisjoint(chart.verbs):
            return not classes.isdisjoint(gap["verbs"]) and classes.isdisjoint(gap.get("whole", ()))
    return "verbs" not in gap


def _only_named(lattice: Lattice, chart: Chart) -> Question | None:
    """The question for a sentence that names things and says nothing of them: "red cup, please"."""
    alone = frozenset(explanations()["nouns_too"])
    for start in reversed(range(len(lattice.pieces))):
        if not lattice.may_begin(start) or any(one.word_class in alone for one in lattice.phrases[start]):
            continue
        said = next((one for one in chart.meanings("items", start) if isinstance(one, Items)), None)
        words = lattice.text(start, _end(lattice, start))
        if said is None or not words or not all(map(_is_named, said.each)):
            continue  # "honey", said to the robot, leaves no words
        return Question(f"what shall be done with {words!r}?", completes=(f"{words}: ", ""))
    return None


def _is_named(item: Item) -> bool:
    """Whether it is a thing with no more than where it is."""
    placed = all(isinstance(one, Where) and one.role != "to" for one in item.details)
    return placed and item.of.sort in _NAMED and item.of.kind is not None and item.of.reference is None
