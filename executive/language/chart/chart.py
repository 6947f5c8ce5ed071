"""Every meaning of a sentence: the grammar followed from left to right, each part understood once.

For every rule and place, the meanings of the parts that begin there are kept by where they end, so
that the work grows with the length and not with the number of parses. Parses that mean the same are one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import Any

from executive.language.chart.grammar import Node, Rule
from executive.language.phrases.values import Clause, Items, Meaning, Trouble
from executive.language.text.lattice import Lattice
from executive.language.text.word import Word

MAX_STEPS = 2_500
"""Parts looked at before a sentence counts as too tangled; none of 2,800 collected ones needs 370."""

_REFUSED_COMMANDS = frozenset(
    {"NO_SKILL", "HARM", "THROW", "NEGATION", "ASK", "LIMITLESS", "LEFT_OUT", "REVOKE"}
)
"""Word classes that begin a command which is refused: "say hi and jump"."""

_PARTS = frozenset({"SEP", "AND", "BECAUSE", "BEFORE", "AFTER"})
"""Word classes that part a clause from what stands beside it."""

Spans = dict[int, dict[Any, None]]


def _has_details(part: Any) -> bool:
    return isinstance(part, Items) and any(item.details for item in part.each)


class TooTangledError(Exception):
    """A sentence with more readings than can be followed."""


class Chart:
    """One sentence being understood."""

    def __init__(self, rules: Mapping[str, Rule], meanings: Mapping[str, Meaning], lattice: Lattice) -> None:
        self._rules, self._meanings, self._lattice = rules, meanings, lattice
        self._known: dict[tuple[str, int], Spans] = {}
        self._steps = 0
        self.furthest = 0
        self._expected: dict[int, set[str]] = {}
        self.unfit = False
        """Whether a command reaches the end of the sentence and its parts do not go together."""

    def meanings(self, rule: str = "start", start: int = 0) -> list[Any]:
        """Every meaning of the whole sentence, or of all from a place on, troubles among them.

        Raises:
            TooTangledError: The sentence has too many readings.
        """
        found: dict[Any, None] = {}
        for end, values in self._spans(rule, start).items():
            if self._lattice.ends[end]:
                found.update(dict.fromkeys(values))
        return list(found)

    def expected_at(self, position: int) -> AbstractSet[str]:
        """Word classes with which the grammar goes on at a place."""
        return self._expected.get(position, frozenset())

    def understood(self) -> tuple[int, int] | None:
        """Where the longest part stands that is a command by itself; None where there is none."""
        pieces, best = self._lattice.pieces, None
        starts = [at for at in range(len(pieces)) if self._lattice.may_begin(at) or self._is_apart(at)]
        try:
            for start in starts:
                for end, values in self._spans("clause", start).items():
                    whole = self._lattice.ends[end] or self._is_apart(end) or pieces[end].is_mark
                    orders = any(isinstance(one, Clause) and one.bundles for one in values)
                    if whole and orders and (best is None or end - start > best[1] - best[0]):
                        best = (start, end)
        except TooTangledError:
            return None
        return best

    def _is_apart(self, position: int) -> bool:
        """Whether a clause may begin at a place, for what stands before it parts clauses."""
        if position >= len(self._lattice.pieces):
            return False
        if position > 0 and self._lattice.pieces[position - 1].is_mark:
            return True
        return self._lattice.ends_with(position, _PARTS) or self._lattice.begins_with(position, _PARTS)

    @property
    def verbs(self) -> AbstractSet[str]:
        """Word classes that begin a command."""
        return self._rules["command"].first

    def _spans(self, name: str, start: int) -> Spans:
        known = self._known.get((name, start))
        if known is not None:
            return known
        rule = self._rules[name]
        spans: Spans = {}
        self._known[name, start] = spans
        classes = self._lattice.words[start]
        if not rule.first.isdisjoint(classes) or "TEXT" in rule.first:
            for end, value in self._matches(rule, start):
                if rule.closes and not self._lattice.ends[end]:
                    continue
                if name == "command" and isinstance(value, Clause):
                    value = replace(value, text=self._lattice.text(start, end))
                spans.setdefault(end, {})[value] = None
        else:
            self._missed(start, rule.first)
        return spans

    def _matches(self, rule: Rule, start: int) -> Iterator[tuple[int, Any]]:
        pending: list[tuple[Node, int, tuple[Any, ...]]] = [(rule.root, start, ())]
        while pending:
            node, position, parts = pending.pop()
            self._steps += 1
            if self._steps > MAX_STEPS:
                raise TooTangledError("the sentence can be read in too many ways")
            for function in node.functions:
                value = parts if rule.repeats else self._value(function, parts)
                if value is not None:
                    yield position, value
                elif self._lattice.ends[position] and rule.name in self._rules["command"].root.rules:
                    self.unfit = self.unfit or len(parts) > 2 or any(map(_has_details, parts))
            self._missed(position, node.terminals)
            classes = self._lattice.words[position]
            for word_class, following in node.terminals.items():
                words = self._words(word_class, position, classes)
                pending += [(following, word.end, (*parts, word)) for word in words]
            for name, following in node.rules.items():
                spans = self._spans(name, position)
                repeats = self._rules[name].repeats
                pending += [
                    (following, end, (*parts, *value) if repeats else (*parts, value))
                    for end, values in spans.items()
                    for value in values
                ]

    def _words(self, word_class: str, position: int, classes: Mapping[str, list[Word]]) -> list[Word]:
        if word_class == "TEXT":
            return self._lattice.free_text(position, self._rules["command"].first | _REFUSED_COMMANDS)
        return classes.get(word_class, [])

    def _value(self, function: str, parts: tuple[Any, ...]) -> Any:
        for part in parts:
            if isinstance(part, Trouble):
                return part
        meaning = self._meanings.get(function)
        if meaning is not None:
            return meaning(parts)
        return parts[0] if len(parts) == 1 else None

    def _missed(self, position: int, classes: Any) -> None:
        if classes:
            self.furthest = max(self.furthest, position)
            self._expected.setdefault(position, set()).update(classes)
