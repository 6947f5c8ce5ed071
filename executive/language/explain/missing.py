"""What a sentence leaves out, asked for: "put the bowl" (where?), "pick up" (what?), "the red cup".

A sentence breaks off where the grammar goes on behind its last word with one of the word classes that
"missing.toml" lists for a gap. Nothing is ever filled in; it is only asked about.
"""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cache
from typing import Any

from executive.language.chart.chart import Chart
from executive.language.explain.examples import is_verb
from executive.language.phrases.values import Item, Items, Where
from executive.language.text.lattice import Lattice
from executive.language.text.word import Word
from executive.meaning import Question

MAX_WORDS = 30
"""Words of a sentence whose end is looked for."""

_LONGEST = 5
"""Words of the last phrase."""

_MORE_VERBS = frozenset({"PICK_UP", "CARRY"})
_TAKES = frozenset({"PICK", "FETCH", "BRING"})
"""Word classes of verbs that may be done without saying where a thing goes: "take the box"."""

_GOALS = frozenset({"ON", "ONTO", "IN", "INTO", "TO", "NEXT_TO", "RELATION"})

_REFUSED_ALONE = frozenset({"NO_SKILL", "HARM", "THROW", "ASK", "PRAISED", "GO_HOME", "STOP"})
"""Word classes of which a noun without an article may be: "iron", "hammer"."""

_NAMED = frozenset({"thing", "container", "furniture", "door"})
_NAMES = frozenset({"NAME", "OWNER"})


@dataclass(frozen=True, slots=True)
class _Gap:
    """Something that may be missing; see the head of "missing.toml"."""

    asks: str
    expects: frozenset[str]
    after: frozenset[str]
    said: frozenset[str]
    unless: frozenset[str]
    verbs: frozenset[str]
    begins: bool
    units: Mapping[str, str]
    no_goal: bool

    @classmethod
    def of(cls, written: Mapping[str, Any]) -> _Gap:
        return cls(
            asks=written["asks"],
            expects=frozenset(written["expects"]),
            after=frozenset(written["after"]),
            said=frozenset(written.get("said", ())),
            unless=frozenset(written.get("unless", ())),
            verbs=frozenset(written.get("verbs", ())),
            begins=written.get("begins", False),
            units=written.get("units", {}),
            no_goal=written.get("no_goal", False),
        )


@cache
def _gaps() -> tuple[_Gap, ...]:
    text = importlib.resources.files("executive.language.explain").joinpath("missing.toml").read_text("utf-8")
    return tuple(_Gap.of(one) for one in tomllib.loads(text)["missing"])


def what_is_missing(lattice: Lattice, chart: Chart) -> Question | None:
    """The question for what a sentence leaves out; None where it is whole, or more than that is wrong.

    Args:
        lattice: The sentence, of which no reading makes sense.
        chart: How far it was followed.
    """
    pieces = lattice.pieces
    if not pieces or len(pieces) > MAX_WORDS or lattice.unknown() is not None:
        return None
    named = _only_named(lattice, chart)
    if named is not None:
        return named
    return next(_questions(lattice, chart), None)


def _questions(lattice: Lattice, chart: Chart) -> Iterator[Question]:
    """The question for each gap that there may be at the end of the sentence."""
    end = _end(lattice, 0)
    if chart.furthest < end or not end:
        return
    before = lattice.plain[: lattice.pieces[end - 1].end]
    behind = lattice.plain[lattice.pieces[end - 1].end :]
    expected = chart.expected_at(end)
    for gap in _gaps():
        if not gap.expects.isdisjoint(expected) and _may_be(gap, lattice, end):
            yield _asked(gap, before, behind, expected)


def _end(lattice: Lattice, start: int) -> int:
    """Where what is said from a place on ends, before the last courtesies."""
    return next(one for one in range(start, len(lattice.pieces) + 1) if lattice.ends[one])


def _asked(gap: _Gap, before: str, behind: str, expected: AbstractSet[str]) -> Question:
    """The question for a gap; of units, which of them fit."""
    completes = (f"{before} ", behind)
    fitting = [unit for name, unit in gap.units.items() if name in expected]
    if not fitting:
        return Question(f"{before} {gap.asks}?", completes=completes)
    choices = tuple(f"{before} {unit}{behind}".rstrip(" .!?") for unit in fitting)
    return Question(f"{before} {gap.asks}: {' or '.join(fitting)}?", choices, completes)


# ---- where a sentence may break off


def _may_be(gap: _Gap, lattice: Lattice, end: int) -> bool:
    """Whether it may be missing behind the last phrase, by what that is and what verb stands before it."""
    last = _last_phrase(lattice, end)
    fitting = [word for word in last if word.word_class in gap.after]
    if not fitting or (gap.said and fitting[0].said not in gap.said) or fitting[0].said in gap.unless:
        return False
    start = fitting[0].start
    if gap.begins:
        return _begins_clause(lattice, start)
    if not gap.verbs:
        return start > lattice.first_said
    verb = _verb_before(start, gap.verbs, lattice)
    if verb is None or not _begins_clause(lattice, verb):
        return False
    return not gap.no_goal or not any(lattice.begins_with(one, _GOALS) for one in range(verb + 1, start))


def _last_phrase(lattice: Lattice, end: int) -> list[Word]:
    """The readings of the longest phrase that ends at a place."""
    for start in range(max(0, end - _LONGEST), end):
        found = [word for word in lattice.phrase(start) if word.end == end]
        if found:
            return found
    return []


def _begins_clause(lattice: Lattice, start: int) -> bool:
    """Whether only courtesies, a conjunction or a mark stand before a place."""
    joins = lattice.ends_with(start, frozenset({"SEP", "AND"})) or lattice.pieces[start - 1].is_mark
    return lattice.may_begin(start) or joins


def _verb_before(place: int, verbs: frozenset[str], lattice: Lattice) -> int | None:
    """Where the last verb before a place stands; None if it is of other classes, or whole without a goal."""
    for start in range(place - 1, -1, -1):
        words = lattice.phrase(start)
        longest = max((word.end for word in words), default=start)
        classes = {word.word_class for word in words if word.end == longest}
        if classes & verbs:
            return start if classes.isdisjoint(_TAKES) or "PICK_UP" in verbs else None
        if any(is_verb(one) or one in _MORE_VERBS for one in classes):
            return None
    return None


# ---- things that are only named


def _only_named(lattice: Lattice, chart: Chart) -> Question | None:
    """The question for a sentence that names things and says nothing of them: "red cup, please"."""
    for start in reversed(range(len(lattice.pieces))):
        if not lattice.may_begin(start):
            continue
        said = next((one for one in chart.meanings("items", start) if isinstance(one, Items)), None)
        if said is None or _may_be_done(lattice, start) or not all(map(_is_named, said.each)):
            continue
        words = lattice.text(start, _end(lattice, start))
        if not words:  # "honey", said to the robot
            continue
        called = _called(said.each, words, lattice.begins_with(start, _NAMES))
        return Question(f"what shall be done with {called}?", completes=(f"{words}: ", ""))
    return None


def _is_named(item: Item) -> bool:
    """Whether it is a thing with no more than where it is."""
    placed = all(isinstance(one, Where) and one.role != "to" for one in item.details)
    return placed and item.of.sort in _NAMED and item.of.kind is not None and item.of.reference is None


def _may_be_done(lattice: Lattice, start: int) -> bool:
    """Whether the first word may be what is to be done, and is refused then."""
    return any(word.word_class in _REFUSED_ALONE for word in lattice.phrase(start))


def _called(each: Sequence[Item], words: str, begins_with_a_name: bool) -> str:
    """What things are called within a question: one without an article gets it."""
    said = words if begins_with_a_name else words[0].lower() + words[1:]
    of = each[0].of
    bare = len(each) == 1 and of.is_single and not (of.determined or of.counted or begins_with_a_name)
    return f"the {said}" if bare else said
