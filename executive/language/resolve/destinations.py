"""Places, people and descriptions as a task's slots hold them: what "there", "back" and "her" stand for."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.language.commands.placing import HOLDERS
from executive.language.phrases.values import Nominal, Relative, Trouble, Where
from executive.language.resolve.antecedents import Antecedents, is_any
from executive.language.resolve.discourse import Entity, UnresolvedError, ask, is_them
from executive.language.resolve.genders import may_be
from trees import tasks
from trees.tasks import ObjectDescription, ObjectOf

_ADDRESSES = frozenset({"wave", "say", "look_at", "point_at"})
"""What is done to somebody who stays in front of the robot."""


_TAKEN_OR_SEEN = frozenset({"count", "find", "pick", "hand_over"})
_SEES = frozenset({"count", "find", "look_at", "describe"})
"""Tasks after which what was opened is still looked into."""


class Destinations(Antecedents):
    """Finds where a thing goes or is, and to whom."""

    def _inner(self, excluded: int, *, into: bool) -> Any:
        """A reference inside a place: "in it", "next to it"."""

        def fits(entity: Entity) -> bool:
            return (
                entity.of.sort in ("thing", "any")
                or (entity.of.sort == "container" and into)
                or entity.of.is_place
            )

        recent = self._recent(fits, excluded)
        places = [
            place
            for place in self._places
            if (place.sort == "container" if into else place.sort in ("furniture", "container"))
        ]
        if into:
            recent = [entity for entity in recent if entity.of.sort in ("container", "thing", "any")]
        if not into and (walked := self._walked_to_just_now()) is not None:
            opened = [one for one in recent if one.of.sort == "container"]
            if len(opened) == len(recent) and opened and not self._mentioned:
                return self._destination(walked)  # "close the fridge, walk to the table, put the cup on it"
        gone = bool(self._commands) and self._commands[-1].action in ("walk_to", "go_home")
        if gone and not into and any(one.of.sort == "container" for one in recent):
            raise ask("what does 'it' stand for?")  # "close the fridge, walk to the kitchen, put it on it"
        roots = [entity.of for entity in recent]
        others = [place for place in dict.fromkeys(places) if place not in roots]
        if len(recent) != 1 or others or self._mentioned:
            if not recent and len(others) == 1:
                return self._destination(others[0])
            raise ask("what does 'it' stand for?")
        if recent[0].task in self._held or recent[0].is_several:
            raise ask("what does 'it' stand for?")
        if recent[0].task in self._given:
            raise ask(f"the {recent[0].of.kind or 'one'} is given away by then: shall it be put there?")
        return self._same_it(recent[0].task)

    def _walked_to_just_now(self) -> Nominal | None:
        """The furniture that the task before walked to, where nothing else was named as a place since."""
        if not self._commands or self._commands[-1].action != "walk_to" or not self._walks:
            return None
        last = self._walks[-1]
        is_last = last.sort == "furniture" and not last.reference and self._places[-1:] == [last]
        return last if is_last else None

    def _out_of(self, root: int) -> dict[str, Any]:
        """The slot of what "out" is out of where that is not said: the only container, if it is open."""
        places = list(dict.fromkeys(one for one in self._places if one.sort in ("container", "furniture")))
        if len(places) != 1 or places[0].sort != "container":
            return {}
        opened = [index for index, one in enumerate(self._commands) if one.action == "open"]
        if not opened:
            if places[0] not in (*self._said_before, *self._stated):
                return {}
            self._sources[root] = places[0]  # "the dishwasher is full, take out the plates"
            return {"source": self._destination(places[0])}
        since = {one.action for one in self._commands[opened[-1] :]}
        inside = [one for one in self._entities if one.task in opened and one.of == places[0]]
        if len(opened) > 1 or not inside or since & {"close", "walk_to", "go_home", "move"}:
            return {}
        self._sources[root] = places[0]
        return {"source": ObjectOf(opened[0])}

    def _seen_in(self, named: Nominal, root: int, action: str) -> dict[str, Any]:
        """The slot of where a thing is right after a container was looked into, if no hand has it."""
        if action not in _TAKEN_OR_SEEN or (action == "hand_over" and self._held):
            return {}
        here = {one.task for one in self._entities if one.clause == self._clause}
        before = [one for one, task in self._did if task not in here or one.get("source") is not None]
        last = before[-1] if before else None  # "look in the fridge and bring me the milk and the juice"
        if last is None or not last.get("looks_in") or named.sort not in ("thing", "any"):
            return {}
        if named.relation is not None or named.reference:
            return {}
        self._sources[root] = last.get("to")
        return {"source": self._destination(last.get("to"))}

    def _counted_in(self, named: Nominal) -> dict[str, Any]:
        """The slot of where things are counted right after the only container that stands open was opened."""
        opened = [index for index, one in enumerate(self._commands) if one.action == "open"]
        if (
            self._said_first
            or len(opened) != 1
            or named.sort not in ("thing", "any")
            or named.relation is not None
        ):
            return {}
        since = {one.action for one in self._commands[opened[0] + 1 :]}
        inside = [one for one in self._entities if one.task == opened[0] and one.of.sort == "container"]
        return {"source": ObjectOf(opened[0])} if inside and since <= _SEES else {}

    def _description(self, nominal: Nominal) -> Any:
        self._note_name(nominal)
        if nominal.owner is not None:
            self._name_place(nominal.owner)
        if nominal.sort == "name" and nominal.relation is None:
            return nominal.kind
        if nominal.sort == "name":
            nominal = replace(nominal, kind=None, name=nominal.kind)
        relation = nominal.relation
        if relation is not None and relation.to.reference == "there":
            relation = self._there_relation(nominal)
        resolved = None
        if relation is not None:
            if nominal.kind is not None and not nominal.is_place:
                self._kind = nominal
            resolved = tasks.Relation(relation.kind, self._related(relation.to))
            self._beside_places += [relation.to] if relation.to.is_place else []
        return ObjectDescription(
            kind=nominal.kind,
            color=nominal.color,
            name=nominal.name,
            size=nominal.size,
            material=nominal.material,
            ordinal=nominal.ordinal,
            relation=resolved,
            traits=nominal.traits,
        )

    def _there_relation(self, thing: Nominal) -> Relative:
        """Where "the cabinet there" is: in the room, or on the furniture, that was gone to."""
        place = self._only_place(Nominal("any", reference="there"), -1)
        if place.sort == "room":
            return Relative("in", place)
        if place.sort == "furniture" and thing.sort == "thing":
            return Relative("on", place)
        raise ask("which place does 'there' stand for?")

    def _related(self, nominal: Nominal) -> Any:
        return self._beside(nominal, -1)

    def _beside(self, nominal: Nominal, root: int) -> Any:
        """What a relation is to: a thing rather than the furniture that it stands on."""
        if nominal.reference == "it":
            recent = self._recent(lambda entity: entity.of.sort in ("thing", "any"), root)
            if len(recent) == 1 and recent[0].task in self._held:
                kind = recent[0].of.kind or "one"
                raise ask(f"the {kind} is in the hand by then: shall it be put down first?")
            if len(recent) == 1 and not recent[0].is_several and not self._mentioned:
                return self._same_it(recent[0].task)
        if nominal.anaphoric:
            self._only_kind(self._mentioned)
            self._only_contrast(nominal)
        return self._place(nominal, root, beside=True)

    def _destination(self, nominal: Nominal) -> Any:
        """A place, a person or a thing as the value of a slot."""
        before = self._that(nominal)
        if isinstance(before, ObjectOf) and (nominal.is_single or nominal.whose):
            return before
        nominal = before if isinstance(before, Nominal) else nominal
        named = self._same_kind(nominal)
        if nominal.anaphoric and nominal.is_plain:
            raise ask("which one is meant?")  # "put the box in that one"
        if named.sort in ("me", "you"):
            return named.kind
        if named.sort == "name":
            return self._description(named)
        if named.count != 1 or (named.plural and not named.reference):
            raise UnresolvedError(Trouble(f"several places at once ({named.kind!r}): name one", named.kind))
        if named.is_place and named.is_plain:
            self._note_name(named)
            return named.kind
        if named.sort == "person" and named.relation is not None:
            plain = replace(named, relation=None).is_plain
            if (
                named.relation.kind == "in_front_of"
                and named.relation.to.sort == "you"
                and plain
                and named.kind == "person"
            ):
                return "in_front"
        if named.sort == "any" and named.kind is None and named.is_plain:
            raise ask("which one is meant?")
        if named.sort in ("thing", "any"):
            self._mentioned.append(named)
            self._mentioned_in.append((self._clause, named))
        return self._description(named)

    def _place(self, value: Any, root: int, *, into: bool = False, beside: bool = False) -> Any:
        if isinstance(value, Relative):
            relation = tasks.Relation(value.kind, self._beside(value.to, root))
            return ObjectDescription(relation=relation)
        if value.reference == "him" or (value.sort == "person" and value.whose):
            return self._person(value)
        if value.reference == "asker":
            met = self._met() if value.name in ("there", "met") else None
            if met is not None:
                return self._destination(met)
            if value.name == "met" and not self._people and not self._came_to_asker():
                raise ask("to whom?")
            if self._people:
                raise ask("to whom?", ["me", *(f"{person.kind}" for person in dict.fromkeys(self._people))])
            return value.kind
        if value.reference == "there":
            return self._there_place(value, root)
        if value.reference in ("it", "previous"):
            return self._inner(root, into=into)
        if value.reference:
            raise ask("which place is meant?")
        if value.anaphoric and not beside:
            holder = self._holder_like(into=into)
            if holder is not None:
                return self._destination(
                    replace(value, kind=holder.kind, sort=holder.sort, anaphoric=False, said="")
                )
            self._only_kind((*self._places, *self._mentioned))
            self._not_of_what_is_put(value, root)
        return self._destination(value)

    def _holder_like(self, *, into: bool) -> Nominal | None:
        """What "the blue one" is that something is put into or onto, which cannot hold anything itself.

        Raises:
            UnresolvedError: Nothing was named that holds things, or what was is in the hand: nobody puts
                anything onto that.
        """
        handled = self._kind
        if handled is None or handled.is_place or handled.kind in HOLDERS:
            return None
        lately = (one.of for one in self._entities)
        named = dict.fromkeys((*self._places, *self._mentioned, *lately))
        holders = [one for one in named if one.is_place or one.kind in HOLDERS]
        in_hand = {one.of for one in self._entities if one.task in self._held}
        if (into and not holders) or (not into and not in_hand.isdisjoint(holders)):
            raise ask("which one is meant?")
        return holders[0] if len({one.kind for one in holders}) == 1 else None

    def _came_to_asker(self) -> bool:
        """Whether the robot has gone to who speaks just before."""
        came = bool(self._commands) and self._commands[-1].action == "walk_to" and bool(self._walks)
        return came and self._walks[-1].sort == "me"

    def _met(self) -> Nominal | None:
        """Whom the robot has gone to just before, when nobody else was named since.

        Raises:
            UnresolvedError: It went to where somebody is, who may be meant or not.
        """
        since = len(self._commands)
        while since and self._commands[since - 1].action in _ADDRESSES:
            since -= 1
        if not since or self._commands[since - 1].action != "walk_to" or not self._walks:
            return None
        last = self._walks[-1]
        if last.relation is not None and last.relation.to.is_person and not last.is_person:
            raise ask("to whom?", ["me", f"{last.relation.to.kind}"])
        if last.sort not in ("person", "name") or last.reference or not self._people:
            return None
        told = {replace(one, relation=None) for one in dict.fromkeys(self._people)}
        plain = replace(last, relation=None)
        alone = told == {plain}
        return (
            last
            if replace(self._people[-1], relation=None) == plain and (alone or since == len(self._commands))
            else None
        )

    def _there_place(self, value: Nominal, root: int) -> Any:
        if value.name == "back":
            source = self._sources.get(root)
            if source is None:
                raise ask("where shall it be put back to?")
            return self._destination(source)
        return self._destination(self._only_place(value, root))

    def _only_place(self, value: Nominal, root: int) -> Nominal:
        """The one place that was named and that the thing is not at already."""
        if value.name == "back":
            raise ask("which place is meant?")
        held_at = self._sources.get(root)
        named = dict.fromkeys((*self._places, *self._beside_places))
        places = [place for place in named if place != held_at]
        if self._commands and self._commands[-1].action == "walk_to":
            if not self._walks:  # in front of something is no place of its own
                raise ask("which place does 'there' stand for?")
            sent = self._walks[-1]  # just now, unless another place was named since
            places = [place for place in places if place == sent == self._places[-1]]
            beside = [place for place in self._walked_together if place != held_at] if places else []
            places = [*beside, *places]
        if len(places) != 1:
            raise ask("which place does 'there' stand for?", [f"the {place.kind}" for place in places])
        return places[0]

    def _there(self, where: Where, root: int) -> dict[str, Any]:
        """Slots of a place task whose place was named before."""
        is_back = where.of.name == "back"
        if is_back and self._remembers and root not in self._sources:
            return {"to": tasks.WHERE_IT_WAS}
        place = self._sources.get(root) if is_back else self._only_place(where.of, root)
        value = self._there_place(where.of, root)
        if place is not None and place.sort in ("thing", "any"):
            raise ask(f"into the {place.kind}, or on it?")
        if place is not None and place.sort == "door":
            raise ask("which place does 'there' stand for?")
        if place is not None and place.sort == "container":
            return {"action": "put_in", "to": value}
        return {"to": value} if place is not None and place.sort == "room" else {"on": value}

    def _walk(self, value: Any) -> Any:
        if isinstance(value, Nominal) and value.reference == "there" and value.name == "back":
            if len(self._walks) != 1:
                raise ask(
                    "back to where?", ["the start", *(f"the {place.kind}" for place in self._walks[:-1])]
                )
            self._walks.append(Nominal("room", "start"))
            return "start"
        if is_them(value) and self._people and not self._recent(is_any):
            return self._person(value)  # "find a person and go to them"
        if isinstance(value, Nominal) and value.reference in ("it", "them"):
            recent = self._recent(is_any)
            places = list(dict.fromkeys(self._places))
            if not recent and len(places) == 1 and value.reference == "it":
                return self._walk(places[0])  # "point at the door and walk to it"
            if len(recent) != 1:
                raise ask("what does 'it' stand for?")
            if recent[0].of.sort == "animal":
                kind = recent[0].of.kind
                told = f"walking after an animal ({kind!r}) is no skill of this robot"
                raise UnresolvedError(Trouble(told, kind))
            return ObjectOf(recent[0].task)
        resolved = self._place(value, -1)
        if isinstance(value, Nominal):
            self._walks.append(value)
        elif value.to.is_place and not value.to.reference:
            self._beside_places.append(value.to)
        return resolved

    def _person(self, value: Nominal, *, anew: bool = False) -> Any:
        """Who is meant; ``anew`` where it is said where he is: "find the guest in the hall"."""
        if value.reference == "him" or is_them(value):
            named = dict.fromkeys(self._people)
            people = [one for one in named if may_be(value.said, one)] or list(named)
            if len(people) != 1 or (is_them(value) and self._is_several()):
                raise ask("who is meant?", [str(person.kind) for person in people])
            if not may_be(value.said, people[0]):
                raise ask(f"who is meant by {value.said!r}?")
            if people[0].count != 1:
                raise ask("who of them is meant?")  # "find all the people and wave to them"
            return self._destination(people[0])
        if value.reference in ("it", "this"):
            raise ask("who is meant?")
        if value.sort == "person" and value.whose in ("that", "this") and value.is_plain:
            same = [one for one in dict.fromkeys(self._people) if one.kind == value.kind]
            if len(same) > 1:
                raise ask(f"which {value.kind} is meant by {value.whose!r}?")
            value = same[0] if same else value  # "find the man in the kitchen and wave to that man"
        value = value if anew else self._as_before(value)
        self._name_place(value)
        return self._destination(value)
