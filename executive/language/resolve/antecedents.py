"""What "it", "them" and "the first one" stand for among the things that were named."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from executive.language.phrases.values import Nominal
from executive.language.resolve.discourse import Entity, ask
from executive.language.resolve.repeated_nouns import PUTS_DOWN, RepeatedNouns
from trees.tasks import ObjectOf

_OPENED = ("container", "door")
_COUNTED = ("first", "second", "third", "fourth", "fifth", "last")
_CONTRASTED = ("color", "size", "material", "ordinal")
_MOVES = ("pick", *PUTS_DOWN)


def is_any(_entity: Entity) -> bool:
    """Whatever it is."""
    return True


def _is_alike(source: Any, place: Nominal) -> bool:
    """Whether something is taken from what was named as a place."""
    if not isinstance(source, Nominal) or source.kind is None:
        return False
    said = ("kind", "color", "size", "material", "ordinal")
    return all(getattr(source, slot) in (None, getattr(place, slot)) for slot in said)


class Antecedents(RepeatedNouns):
    """Finds the thing that a word refers to."""

    def _it(self, nominal: Nominal, action: str, out_of: Any = None) -> Any:
        if nominal.reference == "this":
            raise ask("which one is meant?")
        if nominal.reference == "him" or nominal.is_person:
            raise ask("who or what is meant?")
        if action in ("open", "close"):
            return self._opened()
        recent = self._recent(lambda entity: entity.of.sort in ("thing", "any"))
        self._no_animal(recent)
        if not recent and action in ("look_at", "point_at", "find", "describe"):
            recent = self._recent(is_any)
        ahead = [one for one in self._said_before if one.sort in ("thing", "any")]
        if recent and ahead:
            raise ask("which of them does 'it' stand for?", [f"the {one.of.kind}" for one in recent])
        if not recent:
            if len(ahead) == 1 and not self._places and nominal.reference == "it":
                return ahead[0]  # "before you give the cup to Ana, pick it up"
            raise ask("what does 'it' stand for?")
        if nominal.reference == "them":
            raise ask("what does 'them' stand for?")
        if len(recent) > 1:
            raise ask("which of them does 'it' stand for?", [f"the {entity.of.kind}" for entity in recent])
        root = recent[0].task
        if (
            self._put_to is not None
            and self._put_to[0] == recent[0].clause
            and action in _MOVES
            and not _is_alike(out_of, self._put_to[1])  # nothing is taken out of itself
        ):
            names = [f"the {one.kind}" for one in (recent[0].of, self._put_to[1])]
            raise ask("which of them does 'it' stand for?", names)
        if action in PUTS_DOWN and self._held and root not in self._held:
            raise ask("which of them does 'it' stand for?")
        if recent[0].is_several:
            raise ask("which of them does 'it' stand for?")
        return ObjectOf(root)

    def _all_in_the_hands(self) -> list[Entity]:
        """All that was named, if each was taken by itself: "take the cup. Take the plate. Put them ..."."""
        named = {one.task: one for one in self._entities if one.of.sort in ("thing", "any")}
        alone = all(one.task in self._held and one.of.is_single for one in named.values())
        alone = alone and len({one.clause for one in named.values()}) == len(named)
        return list(named.values()) if alone and not self._mentioned and self._put_to is None else []

    def _no_animal(self, recent: Iterable[Entity]) -> None:
        """Ask when "it" may be an animal that was named no earlier than the things that it may be.

        Raises:
            UnresolvedError: It may.
        """
        animals = [one.clause for one in self._entities if one.of.sort == "animal"]
        if animals and any(max(animals) >= one.clause for one in recent):
            raise ask("which of them does 'it' stand for?")

    def _that(self, thing: Nominal) -> Any:
        """What "that drawer" is after "the left drawer": a task's thing, or a place; None if none was named.

        Raises:
            UnresolvedError: It may be one of several.
        """
        if thing.whose not in ("that", "this"):
            return self._told_before(thing)
        if thing.kind is None or not thing.is_plain or thing.plural:
            return None
        same = [one for one in self._entities if one.of.kind == thing.kind]
        acted = {one.task: one.of for one in same}
        beside = any(one.clause == self._clause for one in same)  # "this cup here and that cup there"
        others = [
            one
            for one in dict.fromkeys((*self._places, *self._beside_places, *self._mentioned))
            if one.kind == thing.kind and one not in acted.values()
        ]
        pointed = any(one.whose not in ("", thing.whose) for one in (*acted.values(), *others))
        several = len(acted) + len(others) > 1 or any(not one.is_single for one in acted.values())
        if several or pointed or beside:
            raise ask(f"which {thing.kind} is meant by {thing.whose!r}?")
        if acted:
            return ObjectOf(next(iter(acted)))
        return replace(others[0], whose="") if others else None

    def _opened(self) -> Any:
        """What is opened or closed: a door that a task acts on, or the only one that was named."""
        recent = self._recent(lambda entity: entity.of.sort in _OPENED)
        places = list(dict.fromkeys(place for place in self._places if place.sort in _OPENED))
        named = [place for place in places if place not in [entity.of for entity in recent]]
        if len(recent) == 1 and not named:
            return ObjectOf(recent[0].task)
        if not recent and not places:  # "walk in front of the fridge and open it"
            places = list(dict.fromkeys(one for one in self._beside_places if one.sort in _OPENED))
        if not recent and len(places) == 1:
            return places[0]
        raise ask("what does 'it' stand for?")

    def _looked_into(self) -> ObjectOf:
        """What is looked into: the only thing that was opened, while it is open.

        Raises:
            UnresolvedError: Nothing was, or several things, or it may be what something was put into.
        """
        opened = [index for index, one in enumerate(self._commands) if one.action == "open"]
        since = {one.action for one in self._commands[opened[-1] :]} if opened else set()
        if len(opened) != 1 or since & {"close", "walk_to", "go_home", "move", "place"} or self._mentioned:
            raise ask("into what?")
        return ObjectOf(opened[0])

    def _same_it(self, task: int) -> ObjectOf:
        """What "it" is beside two things of one clause: "put the bottle next to it and the can behind it".

        Raises:
            UnresolvedError: Two different things.
        """
        clause, before = self._it_beside or (-1, task)
        named_then = any(one.task == task and one.clause == clause for one in self._entities)
        if before != task and (clause == self._clause or named_then):
            raise ask("what does 'it' stand for?")
        self._it_beside = (self._clause, task)
        return ObjectOf(task)

    def _only_one(self, thing: Nominal, action: str) -> None:
        """Ask what "the first one" and "the other one" are of several things that were named.

        Raises:
            UnresolvedError: It may be one of them, or another.
        """
        kind = self._same_kind(thing).kind
        same = {entity.task: entity for entity in self._entities if entity.of.kind == kind}
        singles = [one for one in same.values() if not one.is_several]
        if thing.ordinal == "other" and len(singles) > 1:
            raise ask("which one is meant?")  # of the red cup and the blue cup
        held = [one for one in same.values() if one.is_several and one.task in self._held]
        if thing.ordinal in _COUNTED and held:
            raise ask("which of those in the hand is meant?")  # "take both cups, put the first one down"
        if thing.ordinal in _COUNTED and any(self._was_search_for_several(task) for task in same):
            raise ask("which of those that are found is meant?")
        if not thing.anaphoric:
            return
        if kind is None and thing.ordinal == "other":
            raise ask("other than what? nothing was named before" if thing.said else "another what?")
        if kind is None and thing.ordinal == "last":
            raise ask("the last one of what? nothing was named before")
        if thing.ordinal in _COUNTED and any(one.of.ordinal not in _COUNTED for one in singles):
            raise ask(f"the {thing.ordinal} that was named, or from the left?")
        before = [one for one in same.values() if one.clause != self._clause and one.task in self._held]
        if action == "pick" and any(one.is_several for one in before):
            raise ask("one of those in the hand, or another?")

    def _only_kind(self, named: Iterable[Nominal]) -> None:
        """Ask when "the blue one" may be of another kind than what is handled: "the bottle on the right one".

        Raises:
            UnresolvedError: It may.
        """
        kinds = dict.fromkeys(one.kind for one in (*([self._kind] if self._kind else []), *named) if one.kind)
        if len(kinds) > 1:
            raise ask("which one is meant?", [f"the {kind}" for kind in kinds])

    def _not_of_what_is_put(self, place: Nominal, root: int) -> None:
        """Ask what "the left one" is that a can is put onto, if nothing but that very can was named.

        "The red box on the blue one" is on a box: its colour tells that box from the other.

        Raises:
            UnresolvedError: It may be anything.
        """
        handled = self._kind
        is_put = root == len(self._commands) or any(
            one.task == root and handled is not None and one.of.kind == handled.kind for one in self._entities
        )
        told = [slot for slot in _CONTRASTED if getattr(place, slot) is not None]
        if is_put and handled is not None and all(getattr(handled, slot) is None for slot in told):
            raise ask("which one is meant?")

    def _only_contrast(self, other: Nominal) -> None:
        """Ask when "the blue one" beside something may be of a kind that was named just before.

        "The red cup next to the blue one" is next to a blue cup; "pick up the red cup and put the bottle next
        to the blue one" may be next to either.

        Raises:
            UnresolvedError: It may.
        """
        handled = self._kind
        if handled is None:
            return
        told = [slot for slot in _CONTRASTED if getattr(other, slot) is not None]
        lately = [
            one.of for one in self._entities if one.clause >= self._clause - 1 and one.of.sort == "thing"
        ]
        named = [one for one in lately if one.kind != handled.kind]
        if any(getattr(handled, slot) is not None for slot in told):
            named = [one for one in named if any(getattr(one, slot) is not None for slot in told)]
        self._only_kind(named)
