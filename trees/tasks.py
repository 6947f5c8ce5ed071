"""What a person can ask for, as frozen values; the slots are those of the command-line contract.

Every slot but ``text`` and ``action`` says nothing when it is absent. Which tasks a robot can carry out is
known by ``trees.registry``; a skill may bring a task type of its own.
"""

from __future__ import annotations

from dataclasses import Field, dataclass, field
from typing import Any, ClassVar, Literal, Protocol

from kinematics.model.robot_description import Hand

RelationKind = Literal[
    "left_of", "right_of", "in_front_of", "behind", "next_to", "on", "in", "under", "nearest"
]
Count = int | Literal["both", "all"]

UNSAID = "unsaid"
"""Key in a slot's metadata: the executive alone sets it, neither a sentence nor a model's output does."""


class Task(Protocol):
    """What a person can ask for: a frozen dataclass with its sentence and the name of its action."""

    __dataclass_fields__: ClassVar[dict[str, Field[Any]]]

    @property
    def text(self) -> str:
        """The sentence that it came from."""
        ...

    @property
    def action(self) -> str:
        """The name of the skill that carries it out, "pick"."""
        ...


@dataclass(frozen=True, slots=True)
class ObjectDescription:
    """Which object is meant: absent slots say nothing.

    Attributes:
        kind: Canonical kind, "cup".
        color: Canonical colour, "red".
        name: A name of its own, "Ana's cup".
        size: "small", "big", "smallest", "biggest", ...
        material: "glass", "metal", ...
        ordinal: "leftmost", "rightmost", "first", "second", "other", ...
        relation: Where it is, seen from the robot.
        traits: What is seen of a person: "sitting", "raising right arm", "red shirt".
    """

    kind: str | None = None
    color: str | None = None
    name: str | None = None
    size: str | None = None
    material: str | None = None
    ordinal: str | None = None
    relation: Relation | None = None
    traits: tuple[str, ...] = ()

    def __str__(self) -> str:
        called = (self.name or "").rstrip(
            "0123456789 "
        )  # a name of the scene, "red cup 2", is not for people
        noun = self.kind if self.kind and called.endswith(self.kind) else self.name or self.kind or "thing"
        words = [word for word in (self.ordinal, self.size, self.color, self.material, noun) if word]
        words += [_who_is(trait) for trait in self.traits]
        return " ".join(words) + (f" {self.relation}" if self.relation else "")


def _who_is(trait: str) -> str:
    """What is seen of a person, after the noun: "who is sitting", "in a red shirt"."""
    is_doing = trait.partition(" ")[0].endswith("ing")
    return f"who is {trait}" if is_doing else f"in a {trait}"


@dataclass(frozen=True, slots=True)
class ObjectOf:
    """The object of an earlier task of the same command: "it", "them".

    Attributes:
        task: Index of that task in the command, from 0.
    """

    task: int

    def __str__(self) -> str:
        return "it"


Thing = ObjectDescription | ObjectOf
Destination = Thing | str
"""An object, or the name of a place, a piece of furniture or a person; "me" is who speaks."""

WHERE_IT_WAS = "where it was"
"""The destination of what goes back to where a hand took it from."""


@dataclass(frozen=True, slots=True)
class Relation:
    """Where something is, relative to something else; left and right are the robot's.

    Attributes:
        kind: How it lies.
        to: What it is compared with; for "nearest" it may be "me".
    """

    kind: RelationKind
    to: Destination

    def __str__(self) -> str:
        somebody = isinstance(self.to, str) and (self.to == "me" or not self.to.islower())
        return f"{self.kind.replace('_', ' ')} {'' if somebody else 'the '}{self.to}"


@dataclass(frozen=True, slots=True)
class PickTask:
    """Grasp an object and hold it lifted.

    Attributes:
        text: The sentence that it came from.
        object: What to pick.
        source: Where it is said to be ("table"), or None.
        hand: The hand to use, or None for the better one.
        count: How many.
    """

    text: str
    object: Thing
    source: Destination | None = None
    hand: Hand | None = None
    count: Count = 1

    action = "pick"


@dataclass(frozen=True, slots=True)
class PlaceTask:
    """Put a held object down; an object that is not held is picked first.

    Attributes:
        text: The sentence that it came from.
        object: What to put down; None is what is held.
        on: The surface.
        to: Where else: next to something, to its left.
        hand: The hand that holds it, or None.
        count: How many.
        source: Where an object that is not held is said to be, or None.
    """

    text: str
    object: Thing | None = None
    on: Destination | None = None
    to: Destination | None = None
    hand: Hand | None = None
    count: Count = 1
    source: Destination | None = None

    action = "place"


@dataclass(frozen=True, slots=True)
class PutInTask:
    """Put an object into something: a box, a bowl, a drawer, the fridge; ``source`` as in ``PlaceTask``."""

    text: str
    object: Thing | None = None
    to: Destination | None = None
    hand: Hand | None = None
    count: Count = 1
    source: Destination | None = None

    action = "put_in"


@dataclass(frozen=True, slots=True)
class HandOverTask:
    """Offer an object to a person, and let go when the person pulls; ``source`` as in ``PlaceTask``."""

    text: str
    object: Thing | None = None
    to: Destination = "me"
    hand: Hand | None = None
    count: Count = 1
    source: Destination | None = None

    action = "hand_over"


@dataclass(frozen=True, slots=True)
class OpenTask:
    """Open a door or drawer."""

    text: str
    object: Thing
    hand: Hand | None = None

    action = "open"


@dataclass(frozen=True, slots=True)
class CloseTask:
    """Close a door or drawer."""

    text: str
    object: Thing
    hand: Hand | None = None

    action = "close"


@dataclass(frozen=True, slots=True)
class TurnKnobTask:
    """Turn a knob, or that of what is switched on or off by it.

    Attributes:
        text: The sentence that it came from.
        object: The knob, or what it belongs to: "stove".
        off: Whether it is turned back, instead of on.
        hand: The hand to use, or None for the better one.
    """

    text: str
    object: Thing
    off: bool = False
    hand: Hand | None = None

    action = "turn_knob"


@dataclass(frozen=True, slots=True)
class PressTask:
    """Press a button, or that of the thing that is named.

    Attributes:
        text: The sentence that it came from.
        object: The button, or what it belongs to.
        hand: The hand to use, or None for the better one.
    """

    text: str
    object: Thing
    hand: Hand | None = None

    action = "press"


@dataclass(frozen=True, slots=True)
class WalkToTask:
    """Walk to a place, a piece of furniture, an object or a person."""

    text: str
    to: Destination

    action = "walk_to"


@dataclass(frozen=True, slots=True)
class MoveTask:
    """Move the base at a velocity.

    Attributes:
        text: The sentence that it came from.
        linear_m_s: Forward speed.
        angular_rad_s: Turning speed, to the left.
        duration_s: For how long; None until stopped.
        distance_m: How far; None for no bound.
        is_fed: True where velocities are sent while it walks, and it ends with them; None otherwise.
    """

    text: str
    linear_m_s: float = 0.0
    angular_rad_s: float = 0.0
    duration_s: float | None = None
    distance_m: float | None = None
    is_fed: Literal[True] | None = field(default=None, metadata={UNSAID: True})

    action = "move"


@dataclass(frozen=True, slots=True)
class WaveTask:
    """Wave at a person: a name, "me", "in_front", or a description."""

    text: str
    person: Destination | None = None
    hand: Hand | None = None

    action = "wave"


@dataclass(frozen=True, slots=True)
class PointAtTask:
    """Point at an object, a place or a person."""

    text: str
    object: Thing | None = None
    to: Destination | None = None
    person: Destination | None = None
    hand: Hand | None = None

    action = "point_at"


@dataclass(frozen=True, slots=True)
class LookAtTask:
    """Turn the head to an object, a place or a person."""

    text: str
    object: Thing | None = None
    to: Destination | None = None
    person: Destination | None = None

    action = "look_at"


@dataclass(frozen=True, slots=True)
class FindTask:
    """Look for an object or a person, from several points of view.

    Attributes:
        text: The sentence that it came from.
        object: What to look for.
        person: Whom to look for.
        source: Where it is said to be, or None.
        count: How many; of several all that are seen are told, and fewer than said are a failure.
    """

    text: str
    object: Thing | None = None
    person: Destination | None = None
    source: Destination | None = None
    count: Count = 1

    action = "find"


@dataclass(frozen=True, slots=True)
class CountTask:
    """Tell how many there are."""

    text: str
    object: ObjectDescription
    source: Destination | None = None

    action = "count"


@dataclass(frozen=True, slots=True)
class DescribeTask:
    """Tell what is seen: everything, a surface, or one object."""

    text: str
    object: Thing | None = None
    source: Destination | None = None

    action = "describe"


@dataclass(frozen=True, slots=True)
class SayTask:
    """Say something.

    Attributes:
        text: The sentence that it came from.
        words: What to say.
        person: To whom.
    """

    text: str
    words: str
    person: Destination | None = None

    action = "say"


@dataclass(frozen=True, slots=True)
class WaitTask:
    """Wait."""

    text: str
    duration_s: float

    action = "wait"


@dataclass(frozen=True, slots=True)
class GoHomeTask:
    """Bring arms, trunk and head to the home posture."""

    text: str

    action = "go_home"


Bringing = PickTask | HandOverTask | PlaceTask | PutInTask
"""What moves an object, and picks it up first when no hand holds it."""
