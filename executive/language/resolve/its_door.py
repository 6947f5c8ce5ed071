"""Which door "the door" is: that of the fridge after "put the milk in the fridge", else one of a room."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.language.phrases.lists import another_of
from executive.language.phrases.values import Nominal, Relative, Trouble
from executive.language.resolve.discourse import Discourse, UnresolvedError, ask
from trees import tasks
from trees.beliefs.grounding.articles import with_article
from trees.tasks import ObjectOf

_WITH_A_DOOR = frozenset(
    {"fridge", "freezer", "oven", "microwave", "dishwasher", "washing machine", "dryer", "cupboard"}
    | {"wardrobe", "closet", "linen closet", "supply closet", "coat closet", "broom closet", "locker", "safe"}
    | {"storage closet", "walk-in closet", "pantry", "medicine cabinet", "spice cabinet", "display cabinet"}
    | {"shoe cabinet", "tool cabinet"}
)
"""Containers of which "the door" may be said."""

_DONE = {"open": "opened", "close": "closed"}
_LEVELS = frozenset({"top", "bottom", "middle", "first", "second", "third"})
"""How shelves above one another are told apart."""

_LEAVES = frozenset({"walk_to", "move", "go_home"})
"""Tasks after which another door may be nearer."""


def _is_any_door(thing: Nominal) -> bool:
    """Whether it is "the door", of which no more is said."""
    plain = thing.sort == "door" and thing.kind == "door" and thing.is_plain and thing.is_single
    return plain and thing.owner is None and not thing.whose and not thing.indefinite and not thing.anaphoric


class ItsDoor(Discourse):
    """Knows of which container "the door" is said."""

    def _door_of_what(self, thing: Nominal, action: str) -> Any:
        """The container whose door is meant, named or as what a task opened; the door itself if none is.

        Raises:
            UnresolvedError: It may be one of several.
        """
        if action not in ("open", "close") or not _is_any_door(thing):
            return thing
        if action == "open":
            return self._walked_up_to() or thing
        just_named = [one for clause, one in self._named_in if clause == self._clause - 1]
        here = [one for clause, one in self._named_in if clause == self._clause]
        if here or any(one.sort == "door" for one in just_named):
            return thing  # "close the fridge and the door"
        beside = list(dict.fromkeys(one for one in just_named if one.kind in _WITH_A_DOOR))
        standing = self._standing_open()
        both = list(dict.fromkeys((*beside, *standing)))
        doors = any(_is_any_door(entity.of) for entity in self._entities)
        closed = bool(both) and not standing and self._was_closed(both[0])
        left = bool(standing) and not beside and self._has_left(standing[both[0]])
        if not both:
            both = self._still_near()
            closed = bool(both)
        if len(both) > 1 or (both and (closed or left or doors)):
            others = ["another door"] if len(both) == 1 else []
            raise ask("which door?", [*(f"the door of the {one.kind}" for one in both), *others])
        if not both:
            return thing
        return ObjectOf(standing[both[0]]) if both[0] in standing else both[0]

    def _another_door(self, thing: Nominal, action: str) -> Nominal:
        """What "the bottom one" is after "the top drawer" of a task before, if nothing else can be opened.

        Raises:
            UnresolvedError: Nothing was named that opens, or several sorts of it.
        """
        opened = [one.of for one in self._entities if one.of.sort in ("container", "door")]
        named = [*opened, *(one for one in self._places if one.sort in ("container", "door"))]
        meant = another_of(thing, opened[-1:])
        last = self._kind.kind if self._kind is not None else None
        if meant.kind is None or meant.kind != last or any(one.kind != meant.kind for one in named):
            if last is None and not named and thing.ordinal == "other":
                raise ask("other than what? nothing was named before")
            what = last or "thing"
            told = f"to {action} {with_article(what)} ({what!r}) is nothing that this robot can do"
            raise (
                UnresolvedError(Trouble(told, what)) if not named else ask(f"what shall be {_DONE[action]}?")
            )
        return meant

    def _still_near(self) -> list[Nominal]:
        """What has a door, was named before the last clause and not left since."""
        if any(one.action in _LEAVES or one.action in ("open", "close") for one in self._commands):
            return []
        return list(dict.fromkeys(one for _, one in self._named_in if one.kind in _WITH_A_DOOR))

    def _walked_up_to(self) -> Nominal | None:
        """The container that the task before walks to: "go to the fridge and open the door"."""
        last = self._commands[-1] if self._commands else None
        goal = self._named_in[-1] if isinstance(last, tasks.WalkToTask) and self._named_in else None
        fits = goal is not None and goal[0] == self._clause - 1 and goal[1].kind in _WITH_A_DOOR
        return goal[1] if goal is not None and fits else None

    def _standing_open(self) -> dict[Nominal, int]:
        """What has a door and was opened and not closed, by the task that opened it."""
        found: dict[Nominal, int] = {}
        for index, one in enumerate(self._commands):
            if isinstance(one, (tasks.OpenTask, tasks.CloseTask)):
                task = one.object.task if isinstance(one.object, ObjectOf) else index
                named = [entity.of for entity in self._entities if entity.task == task]
                for of in named[:1]:
                    if isinstance(one, tasks.CloseTask):
                        found.pop(of, None)
                    elif of.kind in _WITH_A_DOOR:
                        found[of] = index
        return found

    def _shelf_of_what_is_open(self, place: Any) -> Any:
        """The top shelf of the fridge that stands open: "open the fridge, put the milk on the top shelf".

        Raises:
            UnresolvedError: It is said before the fridge is: "before you put it on the top shelf, open ...".
        """
        if not isinstance(place, Nominal) or place.kind != "shelf" or place.relation is not None:
            return place
        standing = self._standing_open()
        if place.ordinal not in _LEVELS or place.owner is not None or len(standing) != 1:
            return place
        ((container, since),) = standing.items()
        if self._has_left(since):
            return place
        named_in = next(one.clause for one in self._entities if one.of == container)
        if self._said_first and named_in in self._said_late:
            raise ask(f"the {place.ordinal} shelf of the {container.kind}, or another one?")
        return replace(place, relation=Relative("in", container))

    def _was_closed(self, of: Nominal) -> bool:
        """Whether a task before closes it."""
        closed = [index for index, one in enumerate(self._commands) if isinstance(one, tasks.CloseTask)]
        roots = [getattr(getattr(self._commands[one], "object", None), "task", one) for one in closed]
        return any(entity.task in roots and entity.of == of for entity in self._entities)

    def _has_left(self, since: int) -> bool:
        """Whether the robot goes elsewhere after a task."""
        return any(one.action in _LEAVES for one in self._commands[since:])
