"""Which of the things around the robot a description means: one, several, or none.

Nothing that was said is left out: what perception cannot tell (a material, whose a thing is)
leads to a question among those that fit otherwise.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

from kinematics.geometry import poses
from robots.scenes.furniture_names import kind_called
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.choice_words import from_the_left, told_apart
from trees.beliefs.grounding.furniture_called import called_so, pieces_called, standing_on
from trees.beliefs.grounding.names_of_things import named
from trees.beliefs.grounding.ranking import least, ordered, sized, there_are
from trees.beliefs.grounding.spatial_relation import between_m, lies, lies_from_robot
from trees.beliefs.grounding.things_called import things_called
from trees.beliefs.grounding.unmatched import NoneFitsError, UntellableError
from trees.beliefs.scene.believed_thing import BelievedThing, Surroundings
from trees.beliefs.scene.furniture_pieces import belong_together
from trees.beliefs.scene.labels import CalledBy, called_by, label_in
from trees.tasks import Count, Destination, ObjectDescription, ObjectOf, Relation

_BEFORE_M = 1.0
"""Who stands before furniture is this near to its middle."""
_BOARD_HALF_M = 0.06
"""A solid of furniture that is no thicker is a board, or a table's top."""

ROBOT = ("robot", "you")
"""What a sentence calls the robot itself."""


@dataclass(frozen=True, slots=True)
class Choice:
    """One of several things that fit a description, with words that fit none of the others.

    Attributes:
        name: Its name in the planning scene.
        words: What people call it to tell it from the others: "the left cup".
    """

    name: str
    words: str


@dataclass(frozen=True, slots=True)
class Found:
    """As many things fit as the description asks for.

    Attributes:
        names: Their names in the planning scene, the nearest first when there are several.
        because: Why it is that, for people, where the word that was said is not what it is called: "the red
            can is the only drink that I see".
    """

    names: tuple[str, ...]
    because: str = ""


@dataclass(frozen=True, slots=True)
class Ambiguous:
    """Several things fit, and only a person can say which one is meant.

    Attributes:
        message: What is unclear, as a question.
        choices: All that fit, from the robot's left to its right.
    """

    message: str
    choices: tuple[Choice, ...]


@dataclass(frozen=True, slots=True)
class Missing:
    """Nothing fits of all that the robot believes to be there.

    Attributes:
        message: What is missing, for people.
        seen: Whether things were seen that fit all but the last condition: another look will not help
            as much as another wording.
    """

    message: str
    seen: bool = False


Grounding = Found | Ambiguous | Missing


def ground(
    wanted: ObjectDescription,
    around: Surroundings,
    source: Destination | None = None,
    count: Count = 1,
    among: Sequence[BelievedThing] | None = None,
) -> Grounding:
    """Find what a description means.

    Args:
        wanted: The description; its ``name`` may be a name of the planning scene.
        around: What the robot believes to be around it.
        source: Where it is said to be: a piece of furniture, or a thing that it is in or on. Without one, the
            one is meant that stands where the robot was sent, if any there fits.
        count: How many are meant. For a number more than fit, the nearest ones; "both" needs exactly two.
        among: What is of its kind and colour; None for all objects that are.
    """
    try:
        if among is None:
            among = things_called(wanted, around, several=count != 1)
            if source is None and count == 1 and wanted.relation is None and wanted.name is None:
                there = _where_it_was_sent(among, around)
                if there and not isinstance(found := ground(wanted, around, among=there), Missing):
                    return found
        fitting = _fitting(wanted, list(among), around, source)
    except NoneFitsError as none:
        return Missing(none.message, none.had)
    except UntellableError as untellable:
        return Ambiguous(untellable.message, choices_among(untellable.among))
    return _counted(wanted, fitting, count)


def ground_furniture(wanted: ObjectDescription, around: Surroundings, leaves: str | None = None) -> Grounding:
    """Find the piece of furniture, or the board of one, that a description means: "the top shelf".

    Without words that compare it is the first solid of the kind, which is the one that carries.

    Args:
        wanted: The description.
        around: What is believed to be around.
        leaves: What that stands on which is to be moved: "the other table" is not that one.
    """
    try:
        found = _furniture_meant(wanted, around, leaves)
    except NoneFitsError as none:
        return Missing(none.message, none.had)
    except UntellableError as untellable:
        return Ambiguous(untellable.message, choices_among(untellable.among))
    return _counted(wanted, found, 1) if found else Missing(f"no {wanted} seen")


def says_which(wanted: ObjectDescription) -> bool:
    """Whether a description says which of several is meant."""
    return wanted.ordinal is not None or wanted.relation is not None or wanted.size is not None


def compares(wanted: ObjectDescription, count: Count = 1) -> bool:
    """Tell whether one thing that fits is not enough to know what is meant: there may well be others.

    So it is with sizes, orders and counts, and with a mere kind: "the cup" may be one of several.
    """
    if wanted.size is not None or count != 1:
        return True
    if wanted.color is None and wanted.name is None:
        return True
    return wanted.ordinal is not None and wanted.ordinal not in ("nearest", "closest", "other")


def exactly(name: str) -> ObjectDescription:
    """A description that means one known object, and names it as people do."""
    label = label_in(name)
    return ObjectDescription(kind=label.kind, color=label.color, name=name)


def _counted(wanted: ObjectDescription, fitting: list[BelievedThing], count: Count) -> Grounding:
    nearest = sorted(fitting, key=lambda thing: (thing.distance_m, thing.name))
    names = tuple(thing.name for thing in nearest)
    noun = str(wanted)
    if count == "all":
        return Found(names)
    if count == "both":
        if len(names) == 2:
            return Found(names)
        return Missing(f"{there_are(len(names))} {noun} in view, so it is not clear what both are", True)
    if count > len(names):
        return Missing(f"only {len(names)} {noun} in view, not {count}", True)
    if count == 1 and len(names) > 1:
        return Ambiguous(f"which {noun}? there are {len(names)}", choices_among(fitting))
    by = called_by(wanted.kind, nearest[0].label)
    said = _TAKEN_AS[by].format(nearest[0].words, noun) if by in _TAKEN_AS and count == 1 else ""
    return Found(names[:count], said)


_TAKEN_AS: Mapping[CalledBy | None, str] = MappingProxyType(
    {
        CalledBy.CATEGORY: "the {} is the only {} that I see",
        CalledBy.LIKE: "the {} looks as if it might be the {}",
    }
)
"""Why something else is taken than what was said, by how it is called."""


def choices_among(things: Sequence[BelievedThing]) -> tuple[Choice, ...]:
    """Things as the choices of a question, from the left to the right."""
    return tuple(Choice(thing.name, words) for thing, words in told_apart(things))


def _fitting(
    wanted: ObjectDescription,
    fitting: list[BelievedThing],
    around: Surroundings,
    source: Destination | None,
) -> list[BelievedThing]:
    """Those of some things for which everything else holds.

    Raises:
        NoneFitsError: There is none.
        UntellableError: Something cannot be told.
    """
    noun = str(wanted)
    if wanted.relation is not None:
        fitting = _related(wanted.relation, fitting, around, noun)
    if source is not None:
        fitting = _at(source, fitting, around, str(replace(wanted, relation=None)))
    if wanted.traits:
        fitting = _with_traits(wanted, fitting)
    if wanted.name is not None:
        fitting = named(wanted.name, fitting, around.held)
    if wanted.ordinal == "other":
        fitting = _other(fitting, _named_before(wanted, around), noun)
    if wanted.size is not None:
        fitting = sized(wanted.size, fitting, noun)
    if wanted.material is not None:
        raise UntellableError(
            f"which one is made of {wanted.material}? that cannot be seen", from_the_left(fitting)
        )
    if wanted.ordinal not in (None, "other"):
        fitting = ordered(str(wanted.ordinal), fitting, noun)
    return fitting


def _with_traits(wanted: ObjectDescription, people: list[BelievedThing]) -> list[BelievedThing]:
    """Those people of whom all is seen that was said."""
    kept = [one for one in people if set(wanted.traits) <= set(one.label.traits)]
    if not kept:
        raise NoneFitsError(f"no {wanted} seen", True)
    return kept


# --- relations -----------------------------------------------------------------------------------


def _related(
    relation: Relation, fitting: list[BelievedThing], around: Surroundings, noun: str
) -> list[BelievedThing]:
    references: list[BelievedThing] = []
    if relation.to in ROBOT:
        kept = [thing for thing in fitting if lies_from_robot(relation.kind, thing)]
    else:
        references = _references(relation.to, around, fitting)
        kept = [
            thing
            for thing in fitting
            if _stands_on(thing, relation, around)
            or any(lies(relation.kind, thing, other) for other in references)
        ]
    if not kept:
        raise NoneFitsError(f"no {noun} seen", True)
    if relation.kind != "nearest":
        return kept
    return least(
        kept,
        lambda thing: min(
            (between_m(thing, other) for other in references if other is not thing), default=thing.distance_m
        ),
    )


def _stands_on(thing: BelievedThing, relation: Relation, around: Surroundings) -> bool:
    """Whether it stands on any board of the piece that is meant; a reference is only the largest of them."""
    to = relation.to
    if relation.kind not in ("on", "in") or not isinstance(to, str) or thing.support is None:
        return False
    return standing_on(to, around)(thing.support)


def _references(to: Destination, around: Surroundings, fitting: list[BelievedThing]) -> list[BelievedThing]:
    """What a relation compares with; several when several fit, each of which may be meant."""
    if isinstance(to, ObjectOf):
        raise TypeError("the object of an earlier task was not filled in")
    if isinstance(to, ObjectDescription):
        try:
            return _fitting(to, things_called(to, around), around, None)
        except NoneFitsError:
            found = _furniture_meant(to, around)
            if found:
                return found
            raise
    if to == "me":
        people = _people(around)
        if len(people) == 1:
            return people
        raise UntellableError("which one? it cannot be seen who speaks", fitting)
    found = pieces_called(to, around)
    if not found:
        raise NoneFitsError(f"no {to} seen", True)
    return found


def _furniture_meant(
    wanted: ObjectDescription, around: Surroundings, leaves: str | None = None
) -> list[BelievedThing]:
    """Of boards on top of each other all are pieces; of a table the top is."""
    found = pieces_called(wanted.name or wanted.kind or "", around)
    if wanted.name is not None or not says_which(wanted):
        return found
    words = called_so(wanted.kind or "", around.furniture_words)
    fixed = [thing for thing in around.things if not thing.movable]
    pieces = [one for one in fixed if one.kind in words or wanted.kind == kind_called(one.kind)]
    boards = [thing for thing in pieces if thing.half_height_m <= _BOARD_HALF_M]
    if wanted.ordinal == "other":
        return _other_furniture(wanted, boards or pieces, around, leaves)
    return _fitting(wanted, boards or pieces, around, None) if pieces else []


def _other_furniture(
    wanted: ObjectDescription, pieces: list[BelievedThing], around: Surroundings, leaves: str | None
) -> list[BelievedThing]:
    """Another piece, or another board of the same, than the one that is left or stood before."""
    this = next((thing for thing in pieces if thing.name == leaves), None) or _stood_before(pieces, around)
    if this is None:
        return _fitting(wanted, pieces, around, None) if pieces else []
    rest = [thing for thing in pieces if thing is not this]
    kept = [t for t in rest if not belong_together(t.name, t.place_m, this.name, this.place_m)]
    return _fitting(replace(wanted, ordinal=None), kept or rest, around, None) if rest else []


def _stood_before(pieces: list[BelievedThing], around: Surroundings) -> BelievedThing | None:
    """The nearest piece ahead of where the robot was asked, if it stood before one."""
    asked_T_here = poses.inverse(around.here_T_asked)
    away = [(asked_T_here[:2, :3] @ thing.place_m + asked_T_here[:2, 3], thing) for thing in pieces]
    ahead = [(math.hypot(x, y), thing.name, thing) for (x, y), thing in away if x > 0.0]
    nearest = min(ahead, default=None)
    return nearest[2] if nearest is not None and nearest[0] <= _BEFORE_M else None


def _people(around: Surroundings) -> list[BelievedThing]:
    return [thing for thing in around.things if thing.is_person]


def _at(
    source: Destination, fitting: list[BelievedThing], around: Surroundings, noun: str
) -> list[BelievedThing]:
    """Those that are where they are said to be."""
    if isinstance(source, str):
        meant = standing_on(source, around)
        kept = [thing for thing in fitting if thing.support is not None and meant(thing.support)]
        where = f"on the {source}"
    else:
        references = _references(source, around, fitting)
        kept = [
            thing
            for thing in fitting
            if any(lies("on", thing, other) or lies("in", thing, other) for other in references)
        ]
        where = f"in or on the {source}"
    if not kept:
        raise NoneFitsError(f"{with_article(noun)} is seen, but not {where}", True)
    return kept


def _where_it_was_sent(fitting: list[BelievedThing], around: Surroundings) -> list[BelievedThing]:
    """Those that stand on the furniture that the robot was told to walk to; all its boards are that."""
    piece = next((thing for thing in around.things if thing.name == around.sent_to), None)
    if piece is None:
        return []
    boards = {
        thing.name
        for thing in around.things
        if not thing.movable and belong_together(thing.name, thing.place_m, piece.name, piece.place_m)
    }
    return [thing for thing in fitting if thing.support in boards | {piece.name}]


# --- memories ------------------------------------------------------------------------------------


def _named_before(wanted: ObjectDescription, around: Surroundings) -> str | None:
    """What "the other box" is not: the thing that was acted on, if that was a box as well."""
    before = around.last_acted_on
    if before is None or wanted.kind is None or called_by(wanted.kind, around.label(before)) is not None:
        return before
    return None


def _other(fitting: list[BelievedThing], before: str | None, noun: str) -> list[BelievedThing]:
    if before is None and len(fitting) < 2:
        raise NoneFitsError(f"no {noun} seen", True)
    if before is None:
        raise UntellableError(f"other than which? no {noun.removeprefix('other ')} was named before", fitting)
    kept = [thing for thing in fitting if thing.name != before]
    if not kept:
        raise NoneFitsError(f"no {noun} seen", True)
    return kept
