"""Commands of the shape that a field's exam draws at random, each with what a robot has to do for it.

A command is a beginning ("take the apple from the shelf", "go to the kitchen", "meet Ana in the office") and
one or two follow-ups, drawn from the verbs, rooms, furniture, things and names that an arena declares. What
is expected is built beside the words: the names of the actions in their order, and of each the thing or the
place that it must name. Actions that this robot does not have are not drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

TOLD = ("dinner is ready", "the doctor is here", "we are leaving")
SIZES = ("biggest", "smallest", "largest")

GO = ("go to", "navigate to", "walk to")
TAKE = ("take", "get", "grasp", "pick up")
FIND = ("find", "locate", "look for")
PUT = ("put it on", "place it on")
BRING = ("bring it to", "deliver it to", "give it to")
SPEAK = ("tell", "say to")


@dataclass(frozen=True, slots=True)
class FieldCommand:
    """A sentence and its meaning.

    Attributes:
        says: The sentence.
        does: For each task its action and what it must name somewhere, or an empty text.
    """

    says: str
    does: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class FieldWords:
    """What an arena declares.

    Attributes:
        rooms, furniture, things: Their names.
        kinds: Of things that are counted, in the plural.
        names: Of people.
        where: The furniture on which a thing is, for those of which a command must tell it rightly.
        room_of: The room of a person, or of what things are on.
    """

    rooms: tuple[str, ...]
    furniture: tuple[str, ...]
    things: tuple[str, ...]
    kinds: tuple[str, ...]
    names: tuple[str, ...]
    where: Mapping[str, str] = field(default_factory=dict)
    room_of: Mapping[str, str] = field(default_factory=dict)


ANY_ARENA = FieldWords(
    rooms=("kitchen", "bedroom", "living room", "office", "hallway", "bathroom"),
    furniture=(
        "shelf", "kitchen table", "desk", "sofa", "side table", "counter", "coffee table", "nightstand",
    ),
    things=(
        "apple", "cup", "bottle", "sponge", "cereal box", "tennis ball", "orange", "bowl", "spoon", "plate",
        "can",
    ),
    kinds=("cups", "bottles", "apples", "spoons", "plates", "bowls"),
    names=("Ana", "Paris", "Charlie", "Robin", "Jules", "Simone", "Morgan", "Angel"),
)  # fmt: skip
"""Words for sentences alone: nothing is anywhere."""

Part = tuple[str, tuple[tuple[str, str], ...]]


class Drawn:
    """Commands drawn from one seed."""

    def __init__(self, seed: int, words: FieldWords = ANY_ARENA) -> None:
        self._rng = np.random.default_rng(seed)
        self._words = words

    def _one(self, words: tuple[str, ...]) -> str:
        return words[int(self._rng.integers(len(words)))]

    def objects(self, many: int) -> Iterator[FieldCommand]:
        """Commands about things."""
        for _ in range(many):
            yield self._joined(self._of_objects[int(self._rng.integers(len(self._of_objects)))](self))

    def people(self, many: int) -> Iterator[FieldCommand]:
        """Commands about people, as far as they are told by name or by where they are."""
        for _ in range(many):
            yield self._joined(self._of_people[int(self._rng.integers(len(self._of_people)))](self))

    def _joined(self, parts: list[Part]) -> FieldCommand:
        joint = self._one((" and ", ", then ", " then "))
        return FieldCommand(
            joint.join(words for words, _ in parts), tuple(one for _, does in parts for one in does)
        )

    def _place_of(self, thing: str) -> str:
        return self._words.where.get(thing) or self._one(self._words.furniture)

    def _room_of(self, what: str) -> str:
        return self._words.room_of.get(self._words.where.get(what, what)) or self._one(self._words.rooms)

    # ---- what is done with a thing that is held

    def _held(self) -> Part:
        if self._rng.random() < 0.5:
            place = self._one(self._words.furniture)
            return f"{self._one(PUT)} the {place}", (("place", place),)
        person = self._one((*self._words.names, "me"))
        return f"{self._one(BRING)} {person}", (("hand_over", person),)

    def _seen(self) -> list[Part]:
        if self._rng.random() < 0.4:
            return [(f"{self._one(('take', 'get', 'grasp'))} it", (("pick", ""),)), self._held()]
        return [
            (
                f"bring it to {(who := self._one((*self._words.names, 'me')))}",
                (("pick", ""), ("hand_over", who)),
            )
        ]

    # ---- beginnings about things

    def _taken(self) -> list[Part]:
        place = self._place_of(thing := self._one(self._words.things))
        return [(f"{self._one(TAKE)} the {thing} from the {place}", (("pick", thing),)), self._held()]

    def _sought(self) -> list[Part]:
        room = self._room_of(thing := self._one(self._words.things))
        article = "an" if thing[0] in "aeiou" else "a"
        return [
            (f"{self._one(FIND)} {article} {thing} in the {room}", (("find", thing),)),
            *self._seen(),
        ]

    def _gone(self) -> list[Part]:
        if self._words.where:
            room = self._room_of(thing := self._one(self._words.things))
        else:
            room, thing = self._one(self._words.rooms), self._one(self._words.things)
        begun: Part = (f"{self._one(GO)} the {room}", (("walk_to", room),))
        return [begun, (f"{self._one(FIND)} the {thing}", (("find", thing),)), *self._seen()]

    def _brought(self) -> list[Part]:
        place = self._place_of(thing := self._one(self._words.things))
        article = "an" if thing[0] in "aeiou" else "a"
        verb = self._one(("bring me", "give me"))
        does = ("hand_over", thing) if verb == "give me" else ("pick", thing)
        more = () if verb == "give me" else (("hand_over", "me"),)
        return [(f"{verb} {article} {thing} from the {place}", (does, *more))]

    def _counted(self) -> list[Part]:
        kinds, place = self._one(self._words.kinds), self._one(self._words.furniture)
        return [(f"tell me how many {kinds} there are on the {place}", (("count", kinds.rstrip("s")),))]

    def _ranked(self) -> list[Part]:
        size, place = self._one(SIZES), self._one(self._words.furniture)
        return [(f"tell me what is the {size} object on the {place}", (("describe", ""),))]

    _of_objects = (_taken, _taken, _sought, _gone, _brought, _counted, _ranked)

    # ---- beginnings about people

    def _spoken(self, person: str) -> Part:
        if person in self._words.names and self._rng.random() < 0.3:
            return "wave to them", (("wave", person),)
        words = self._one(TOLD)
        return f"tell them that {words}", (("say", words),)

    def _met(self) -> list[Part]:
        person = self._one(self._words.names)
        met = self._one(("meet", "find"))
        return [
            (f"{met} {person} in the {self._room_of(person)}", (("", person),)),
            self._spoken(person),
        ]

    def _reached(self) -> list[Part]:
        room = self._room_of(person := self._one(self._words.names))
        words = self._one(TOLD)
        return [
            (f"{self._one(GO)} the {room}", (("walk_to", room),)),
            (f"tell {person} that {words}", (("say", words),)),
        ]

    def _greeted(self) -> list[Part]:
        room = self._room_of(person := self._one(self._words.names))
        return [
            (f"{self._one(GO)} the {room}", (("walk_to", room),)),
            self._hello(person),
        ]

    def _hello(self, person: str) -> Part:
        if self._rng.random() < 0.3:
            return f"wave to {person}", (("wave", person),)
        verb = self._one(("greet", "salute", "say hello to", "introduce yourself to"))
        return f"{verb} {person}", (("greet", person),)

    def _led(self) -> list[Part]:
        room = self._room_of(person := self._one(self._words.names))
        action = self._one(("follow", "guide"))
        verb = "follow" if action == "follow" else self._one(("guide", "escort", "take", "lead"))
        return [
            (f"{verb} {person} from the {self._one(self._words.furniture)} to the {room}", ((action, room),))
        ]

    def _answered(self) -> list[Part]:
        room = self._room_of(person := self._one(self._words.names))
        told = self._one(("the time", "what day is today", "your teams name", "something about yourself"))
        found = f"{self._one(FIND)} {person} in the {room}"
        return [(found, (("find", person),)), (f"tell {told}", (("answer", ""),))]

    def _people_counted(self) -> list[Part]:
        return [
            (
                f"tell me how many people are in the {(room := self._one(self._words.rooms))}",
                (("count", room),),
            )
        ]

    def _served(self) -> list[Part]:
        thing, person = self._one(self._words.things), self._one(self._words.names)
        place = self._place_of(thing)
        return [
            (
                f"{self._one(('bring', 'deliver'))} the {thing} from the {place} to {person}",
                (("pick", thing), ("hand_over", person)),
            )
        ]

    _of_people = (_met, _reached, _greeted, _people_counted, _served, _led, _answered)
