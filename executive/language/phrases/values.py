"""What the parts of a sentence mean before references are resolved: frozen values, made by the grammar."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, Literal, get_args

from trees.tasks import RelationKind

Sort = Literal[
    "thing", "furniture", "container", "door", "room", "person", "animal", "me", "you", "name", "any"
]
Reference = Literal["it", "them", "him", "this", "there", "here", "previous", "asker"]
Preposition = Literal["on", "in", "at", "to"]
Role = Literal["is", "from", "to", "either"]
Quantity = Literal["duration", "distance", "angle", "linear_speed", "angular_speed"]

HARMS = "could harm; this robot does not do that"
"""How a refusal ends that explains a sentence better than any question about it."""

EXCEEDS = "exceeds the limit of"
"""What a refusal says of a number that is over a limit, which holds however the rest is read."""


def relation_kind(name: str) -> RelationKind | None:
    """The relation of a name, or None when it is none that a task can have."""
    return next((kind for kind in get_args(RelationKind) if kind == name), None)


@dataclass(frozen=True, slots=True)
class Trouble:
    """A part that is understood and cannot be acted on: a refusal, or with ``asks`` a question.

    With ``rivals`` it is as likely as a reading that can be acted on, so that it is asked all the same.
    """

    message: str
    word: str | None = None
    asks: bool = False
    choices: tuple[str, ...] = ()
    rivals: bool = False


@dataclass(frozen=True, slots=True)
class Feature:
    """One adjective: which slot of a description it fills, and the word."""

    slot: str
    value: str


@dataclass(frozen=True, slots=True)
class Relative:
    """Where something is: its relation to something else."""

    kind: RelationKind
    to: Nominal


@dataclass(frozen=True, slots=True)
class Nominal:
    """A noun phrase; colour, size and the like are as in ``trees.tasks.ObjectDescription``.

    Attributes:
        sort: What sort of thing the noun names; "any" for things of no or an unknown kind.
        kind: Canonical noun, or a person's name.
        counted: Whether it was said how many.
        reference: What it points back to, instead of a noun.
        anaphoric: Whether the noun is "one": the kind that was named before.
        determined, indefinite: Whether an article or the like was there, and whether it was "a".
        paired: Whether it is one thing with a plural name: scissors.
        mass: Whether all of it is meant by "all the milk", without a plural.
        said: The noun as it was said.
        whose: The word before it that tells one of its kind from another: "my", "that".
        owner: To whom it belongs, who may be meant by "her" after it.
    """

    sort: Sort
    kind: str | None = None
    color: str | None = None
    size: str | None = None
    material: str | None = None
    ordinal: str | None = None
    name: str | None = None
    traits: tuple[str, ...] = ()
    relation: Relative | None = None
    count: int | str = 1
    plural: bool = False
    counted: bool = False
    reference: Reference | None = None
    anaphoric: bool = False
    determined: bool = False
    paired: bool = False
    mass: bool = field(default=False, compare=False)
    said: str = field(default="", compare=False)
    indefinite: bool = field(default=False, compare=False)
    whose: str = field(default="", compare=False)
    owner: Nominal | None = field(default=None, compare=False)

    def described(self, feature: Feature) -> Nominal | Trouble | None:
        """With one more feature; a contradiction is trouble, and None is what nobody says of such a thing."""
        if feature.slot == "traits":
            traits = tuple(dict.fromkeys((*self.traits, feature.value)))
            return replace(self, traits=traits) if self.sort == "person" and not self.reference else None
        if feature.value == "small" and self.mass and not self.paired:
            return None  # "a little milk" is said of how much
        present = getattr(self, feature.slot)
        if present is not None and present != feature.value:
            return Trouble(f"{present!r} and {feature.value!r} contradict each other", feature.value)
        changes: Any = {feature.slot: feature.value}
        return replace(self, **changes)

    def counted_from(self, side: str) -> Nominal:
        """The second from the right, of a second one; it may be said that it is from the left."""
        last = "rightmost" if self.ordinal == "first" else f"{self.ordinal}_from_right"
        return self if side == "leftmost" else replace(self, ordinal=last)

    def placed(self, relation: Relative) -> Nominal | Trouble:
        """With where it is; being at two places is trouble."""
        if self.sort in ("me", "you") or (self.sort == "name" and not may_be_found(relation)):
            return Trouble(f"where {self.kind!r} is cannot be chosen; say it as a task of its own", self.kind)
        if self.sort == "person" and relation.kind == "in" and relation.to.sort == "thing":
            worn = relation.to.said or relation.to.kind
            told = "somebody is in a room or at furniture, and wears a garment of some colour"
            return Trouble(f"the {self.kind} in the {worn}: {told}", worn)
        if self.relation is None or self.relation == relation:
            return replace(self, relation=relation)
        inner = self.relation.to.placed(relation) if relation.to.sort == "room" else None
        if not self.relation.to.is_place or not isinstance(inner, Nominal):
            return Trouble("more than one place is named for the same thing", None)
        return replace(self, relation=Relative(self.relation.kind, inner))  # at the desk in the kitchen

    @property
    def is_person(self) -> bool:
        """Whether it is somebody who can be waved at or handed something."""
        return self.sort in ("person", "me", "name") or self.reference == "him"

    @property
    def is_place(self) -> bool:
        """Whether it is somewhere to put things or to go."""
        return self.sort in ("furniture", "container", "door", "room")

    @property
    def is_single(self) -> bool:
        """Whether nobody would call it "them"."""
        return self.count == 1 and not self.plural and not self.paired

    @property
    def is_vague(self) -> bool:
        """Whether nobody knows how many are meant: "some cups", and "many", of which a few are none."""
        return self.count in ("some", "many")

    @property
    def is_plain(self) -> bool:
        """Whether the noun says it all."""
        told = (self.color, self.size, self.material, self.ordinal, self.name, self.relation)
        return not self.traits and all(one is None for one in told)

    @property
    def is_bare_one(self) -> bool:
        """Whether it is no more than "one" of what was named before: "Tom needs a fork, take one to him"."""
        return self.anaphoric and self.is_plain and self.count == 1 and not (self.determined or self.plural)


SEATS = frozenset({"sofa", "armchair", "chair", "bed", "bench", "stool"})


def may_be_found(relation: Relative) -> bool:
    """Whether it is where people are: "Ana in the kitchen", "Ana at the door", but "Ana on the table"?"""
    of = relation.to
    inside = relation.kind == "in" and of.sort == "room"
    beside = relation.kind == "next_to" and of.is_place
    return inside or beside or (relation.kind == "on" and of.kind in SEATS)


@dataclass(frozen=True, slots=True)
class Where:
    """A place that is said of a thing: by a preposition, or as a relation to something.

    Attributes:
        role: Where it "is", where it comes "from", where it goes "to", or "either": is or goes.
        atop: Whether it was said to be on top of it.
        posture: How somebody is there: "sitting".
    """

    role: Role
    of: Nominal
    preposition: Preposition | None = None
    relation: RelationKind | None = None
    atop: bool = False
    posture: str = ""

    @property
    def told(self) -> Relative:
        """The place as a relation."""
        places: dict[str | None, RelationKind] = {"on": "on", "in": "in"}
        return Relative(self.relation or places.get(self.preposition, "next_to"), self.of)


@dataclass(frozen=True, slots=True)
class Hand:
    """Which hand to use."""

    side: str


@dataclass(frozen=True, slots=True)
class Benefit:
    """For whom."""

    person: Nominal


@dataclass(frozen=True, slots=True)
class Item:
    """A thing with what is said of it; ``details`` are Where, Hand and Benefit."""

    of: Nominal
    details: tuple[Any, ...] = ()


@dataclass(frozen=True, slots=True)
class Items:
    """Several things that the same is done to."""

    each: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Measure:
    """A quantity in SI units."""

    of: Quantity
    value: float
    said: str


@dataclass(frozen=True, slots=True)
class Draft:
    """A task whose references are open; ``slots`` are pairs of a name and a value."""

    action: str
    slots: tuple[tuple[str, Any], ...] = ()

    def get(self, name: str) -> Any:
        """The value of a slot, or None."""
        return next((value for key, value in self.slots if key == name), None)

    def with_slot(self, name: str, value: Any) -> Draft:
        """With one more slot; None changes nothing."""
        return self if value is None else replace(self, slots=(*self.slots, (name, value)))

    def replacing(self, name: str, value: Any) -> Draft:
        """With another value in a slot that it has."""
        return replace(self, slots=tuple((key, value if key == name else old) for key, old in self.slots))


@dataclass(frozen=True, slots=True)
class Mention:
    """A thing that a statement names: where it is, in which state, or merely that it ``exists``."""

    of: Nominal
    source: Nominal | None = None
    state: str | None = None
    exists: bool = False


Bundle = tuple[Draft, ...]
"""Drafts that are done one after the other to the same thing."""


@dataclass(frozen=True, slots=True)
class Clause:
    """One command: what to do, the form of its verb, and its words.

    Attributes:
        revokes: The words that take back what was said before them, if these are such words.
        mention: What is stated, of a clause that is no command.
        about: Who and which places are named beside what is done: "Ana is in the kitchen", "for Ana".
        said_before: What another clause names that is said before this one and done after it.
        terse: Whether its first words could belong to what is said before it: "forward 2 m".
        number: Which one of a numbered list it is.
        question: Whether it begins as a question does, and may be meant for "which is ...".
        topic: Whether it begins with its thing, which after "and" may be one more of what precedes.
        said_first: Whether it is said before what is done first: "before you wave, open the fridge".
        hand_first: Whether it begins with the hand to use, which may be said of what follows it as well.
    """

    bundles: tuple[Bundle, ...]
    form: Literal["base", "ing", "ed"]
    text: str = ""
    revokes: str | None = None
    mention: Mention | None = None
    about: tuple[Nominal, ...] = ()
    said_before: tuple[Nominal, ...] = ()
    terse: bool = False
    number: int | None = None
    question: bool = False
    topic: bool = False
    hand_first: bool = False
    said_first: bool = False


def draft(action: str, **slots: Any) -> Draft:
    """A draft of the slots that say something; ``from_`` is the slot "from"."""
    named = tuple((name.rstrip("_"), value) for name, value in slots.items() if value is not None)
    return Draft(action, named)


Meaning = Callable[[tuple[Any, ...]], Any]
"""From the meanings of a production's parts to its own: None when they do not go together."""
