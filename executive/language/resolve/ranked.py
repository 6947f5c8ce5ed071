"""A thing that is ranked as one before it was: "the biggest cup on the table and the smallest".

Whoever ranks two things of a kind ranks them among the same ones, so that what is said of the first, where it
is, holds for the other too.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.language.phrases.features import SUPERLATIVES
from executive.language.phrases.values import Bundle, Draft, Nominal, Relative
from executive.language.resolve.discourse import Discourse, Entity, ask
from trees import tasks

_HAS_SOURCE = frozenset({"pick", "place", "put_in", "hand_over", "find", "describe"})
_GOALS = ("to", "on")


def _is_ranked(of: Nominal) -> bool:
    """Whether it is told by its place among others of its kind."""
    return of.size in SUPERLATIVES or (of.ordinal is not None and of.ordinal != "other")


def _is_open(of: Any) -> bool:
    """Whether it is ranked among things of which nothing else is said: "the smallest one"."""
    return isinstance(of, Nominal) and of.anaphoric and of.relation is None and _is_ranked(of)


class Ranked(Discourse):
    """Knows among which things the next rank of the same kind is."""

    def _ranked_alike(self, bundle: Bundle) -> Bundle:
        """With where things are that are ranked as one before them was that was told so.

        Raises:
            UnresolvedError: The robot went elsewhere since, where others may be meant.
        """
        before = self._entities[-1] if self._entities else None
        if before is None or not _is_ranked(before.of) or before.of.sort not in ("thing", "any"):
            return bundle
        return tuple(self._among_the_same(one, before) for one in bundle)

    def _among_the_same(self, one: Draft, before: Entity) -> Draft:
        thing = one.get("object")
        if _is_open(thing) and one.get("source") is None:
            source = self._sources.get(before.task)
            if source is not None and one.action in _HAS_SOURCE:
                self._no_others_since(before, source)
                return one.with_slot("source", source)
            return one.replacing("object", self._beside_the_same(thing, before))
        for slot in _GOALS:
            goal = one.get(slot)
            if _is_open(goal):
                one = one.replacing(slot, self._beside_the_same(goal, before))
            elif isinstance(goal, Relative) and _is_open(goal.to):
                one = one.replacing(slot, replace(goal, to=self._beside_the_same(goal.to, before)))
        return one

    def _beside_the_same(self, of: Nominal, before: Entity) -> Nominal:
        source, relation = self._sources.get(before.task), before.of.relation
        if source is None and relation is None:
            return of
        self._no_others_since(before, source)
        if relation is None and source is not None:
            relation = Relative("in" if source.sort in ("container", "room") else "on", source)
        return replace(of, relation=relation)

    def _no_others_since(self, before: Entity, source: Nominal | None) -> None:
        walked = any(isinstance(one, tasks.WalkToTask) for one in self._commands[before.task + 1 :])
        if walked or (source is not None and source.reference is not None):
            raise ask("which one is meant?")
