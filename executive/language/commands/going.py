"""Going about: to places, along a direction with exact velocities, waiting, home, stop."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.limits import MAX_DURATION_S, ExceededError, bounded, in_words
from executive.language.phrases.arranging import (
    ME,
    TroubleError,
    arranged,
    clause,
    guarded,
    trouble,
    unfit,
)
from executive.language.phrases.lists import (
    has_company,
    named_together,
    said_again,
    spoken,
)
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import (
    Clause,
    Item,
    Meaning,
    Measure,
    Nominal,
    Relative,
    draft,
    relation_kind,
)

FORWARD_M_S = 0.3
"""Speed of ``move_forward``; backward is its negative."""

TURN_RAD_S = 0.5
"""Speed of ``turn_left``; to the right is its negative."""

_LINEAR = {"forward": FORWARD_M_S, "backward": -FORWARD_M_S}
_ANGULAR = {"left": TURN_RAD_S, "right": -TURN_RAD_S}
NO_DIRECTION = "in which direction?"


def target(item: Item) -> Nominal:
    """Where an item says to go, point or look: a place or person with what tells it from others."""
    (one,) = arranged((item,), has_source=False)
    nominal = one.object
    pointed_out = one.goal is not None and one.goal.of.reference == "here" and not nominal.is_person
    if nominal.reference == "this" or pointed_out:
        raise trouble("which one is meant?", asks=True)  # "look at the cup here": where the speaker points
    if one.is_handled:
        raise unfit()
    if nominal.sort == "you":
        raise unfit()
    if nominal.count != 1 or (nominal.plural and not nominal.reference):
        raise trouble("several at once: name one", nominal.kind)
    if nominal.sort == "any" and nominal.kind is None and not nominal.reference and nominal.is_plain:
        raise trouble("which one is meant?", asks=True)
    return nominal


def _somewhere(item: Item) -> Nominal:
    """Somewhere to walk to: the chairs are a place as one of them is, and an animal is not followed."""
    of = item.of
    if of.sort == "furniture" and of.plural and of.determined and not of.counted:
        item = replace(item, of=replace(of, plural=False, count=1))
    goal = target(item)
    if goal.sort == "animal":
        raise trouble(f"walking after an animal ({goal.kind!r}) is no skill of this robot", goal.kind)
    return goal


_STANDING = frozenset({"stand", "standing", "position", "positioning", "come", "coming"})
"""Verbs with which "by" is where to stop."""

_ADVANCES = frozenset({"advance", "advancing"})
_WALKS = frozenset({"walk", "walking", "go", "going", "drive", "driving"})
"""Verbs that lead forward as far as is said, unless another direction is."""

_INSIDE = frozenset({"in", "inside", "into"})


@dataclass(frozen=True, slots=True)
class _By:
    """A place to go by: "go by the sofa" may be to it, or past it."""

    of: Nominal


def _toward(parts: Parts) -> Nominal | _By:
    """Where to; into something that is no room would be a collision."""
    goal = _somewhere(parts[-1])
    links = words(parts, "TO_ALSO", "IN")
    if goal.kind == "bed" and not goal.determined and links:
        raise trouble("to the bed? it is nothing for this robot to sleep in", goal.kind, asks=True)
    by = any(link.said == "by" for link in words(parts, "NEXT_TO"))
    if by and not goal.is_place:
        raise unfit()
    if links and _INSIDE & set(links[0].said.split()) and goal.sort not in ("room", "any"):
        raise trouble(f"walking {links[0].said} {spoken(goal)} is no skill of this robot", links[0].said)
    return _By(goal) if by else goal


def _toward_where(parts: Parts) -> Nominal:
    """Where the cup is: to the cup."""
    said = words(parts, "WHERE")[0].said
    if said != "where":
        raise unfit()
    return target(next(part for part in parts if isinstance(part, Item)))


def _toward_location(parts: Parts) -> Nominal:
    """The location of the cup: the cup, as far as walking goes."""
    if words(parts, "WHERE")[0].said not in ("the location of", "the position of"):
        raise unfit()
    return target(next(part for part in parts if isinstance(part, Item)))


def _toward_owner(parts: Parts) -> Nominal:
    """Ana's location: Ana."""
    (owner,) = words(parts, "OWNER", "OWNING")
    return Nominal("name" if owner.word_class == "OWNER" else "person", owner.meaning, determined=True)


def _toward_front(parts: Parts) -> Relative:
    goal = target(next(part for part in parts if isinstance(part, Item)))
    if goal.sort not in ("furniture", "container", "door"):
        raise unfit()
    return Relative("in_front_of", goal)


def _toward_me(_parts: Parts) -> Nominal:
    return ME


def goal_of(reached: Any) -> Nominal | Relative:
    """Where a ``toward`` or an item leads; who "is by" a place does not pass it."""
    if isinstance(reached, _By):
        return reached.of
    return target(reached) if isinstance(reached, Item) else reached


def _toward_inside(parts: Parts) -> Nominal:
    """Into what one walks into, though it is no room: "go in the pantry"."""
    (place,) = words(parts, "WALK_IN")
    return Nominal("container", place.meaning, determined=True, said=place.said)


def _toward_relation(parts: Parts) -> Relative:
    kind = relation_kind(words(parts, "RELATION")[0].meaning)
    if kind is None:
        raise unfit()
    if kind == "under":
        raise trouble("walking under something is no skill of this robot", words(parts, "RELATION")[0].said)
    return Relative(kind, _somewhere(parts[-1]))


def _walk(parts: Parts) -> Clause:
    verb = words(parts, "WALK")[0].said
    passed = next((part.of for part in parts if isinstance(part, _By)), None)
    if passed is not None and not _STANDING & set(verb.split()):
        raise trouble(f"to the {passed.kind}, or past it?", asks=True)
    reached = [part.of if isinstance(part, _By) else part for part in parts]
    goals = [part for part in reached if isinstance(part, (Nominal, Relative))]
    if has_company(parts):
        raise unfit()
    for before, after in itertools.pairwise(one for one in goals if isinstance(one, Nominal)):
        again = said_again(before, after, parts)
        if again is not None:
            raise trouble(again.message, asks=True)
    *earlier, last = (draft("walk_to", to=goal) for goal in goals)
    last = last.with_slot("together", named_together(goals, parts) or None)
    return clause(parts, [(one,) for one in (*earlier, last)])


def _walk_at_speed(parts: Parts) -> Clause:
    """To somewhere at a speed: within the limits it cannot be chosen either."""
    measure = next(part for part in parts if isinstance(part, Measure))
    if measure.of not in ("linear_speed", "angular_speed"):
        raise unfit()
    bounded(measure)
    raise trouble("how fast to walk to a place cannot be chosen", in_words(measure))


def _walk_bare(parts: Parts) -> Clause:
    """Terse: "go kitchen", "walk table"."""
    item: Item = parts[-1]
    if item.details or item.of.determined or not (item.of.is_place and item.of.is_plain):
        raise unfit()
    return clause(parts, [(draft("walk_to", to=target(item)),)])


def _walk_item(parts: Parts) -> Clause:
    goal = _somewhere(parts[-1])
    reached = any(word.said.startswith("reach") for word in words(parts, "APPROACH"))
    if reached and not (goal.is_place and goal.is_plain):
        raise unfit()  # with a hand, or on foot?
    return clause(parts, [(draft("walk_to", to=goal),)])


def _meet_me(parts: Parts) -> Clause:
    """Meet me in the kitchen: to the kitchen."""
    goal = parts[-1]
    if not goal.is_place or (words(parts, "IN") and goal.sort != "room"):
        raise unfit()
    return clause(parts, [(draft("walk_to", to=goal),)])


def _come(parts: Parts) -> Clause:
    return clause(parts, [(draft("walk_to", to=ME),)])


def _come_to_tell(parts: Parts) -> Clause:
    """To whoever asked, to tell what was counted or found, which the references know."""
    return clause(parts, [(draft("walk_to", to=ME, tells=True),)])


def _go_back(parts: Parts) -> Clause:
    return clause(parts, [(draft("walk_to", to=Nominal("any", reference="there", name="back")),)])


def _go_there(parts: Parts) -> Clause:
    return clause(parts, [(draft("walk_to", to=Nominal("any", reference="there")),)])


def _go_somewhere(_parts: Parts) -> Clause:
    raise trouble("where to?", asks=True)


def _move(parts: Parts) -> Clause:
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        raise unfit()  # "move a bit forward. 2 m"
    measures: dict[str, float] = {}
    for one in (part for part in parts if isinstance(part, Measure)):
        if one.of in measures:
            raise unfit()
        measures[one.of] = bounded(one)
    if words(parts, "A_LITTLE") and not {"distance", "duration", "angle"} & set(measures):
        raise unfit()  # "a little bit forward at 0.2 m/s" does not say how far
    if words(parts, "SLOWLY") and not {"linear_speed", "angular_speed"} & set(measures):
        raise unfit()  # how slowly?
    linear, angular = _direction(parts, measures)
    if "linear_speed" in measures:
        linear = math.copysign(measures["linear_speed"], linear)
    if "angular_speed" in measures:
        angular = math.copysign(measures["angular_speed"], angular)
    duration, distance = measures.get("duration"), measures.get("distance")
    if "angle" in measures:
        duration = measures["angle"] / abs(angular)
        if duration > MAX_DURATION_S:
            raise unfit()
    move = draft(
        "move",
        linear_m_s=round(linear, 3),
        angular_rad_s=round(angular, 3),
        duration_s=None if duration is None else round(duration, 3),
        distance_m=None if distance is None else round(distance, 3),
    )
    return clause(parts, [(move,)])


def _move_on(parts: Parts) -> Clause:
    """Terse: "forward 2 m", "left 90 degrees"; a mere "left" is no turn, "back" may be to where it was."""
    turned = any(isinstance(one, Measure) and one.of == "angle" for one in parts)
    said = words(parts, "FORWARD", "BACKWARD", *(("TURN_SIDE",) if turned else ()))
    if not said:
        raise unfit()
    if said[0].said == "back" and len(parts) == 1:
        raise trouble("back to where, or backward?", asks=True)
    if words(parts, "TURN_SIDE") and words(parts, "PAUSE"):
        raise unfit()  # "right, 90 degrees": that may be how one begins to speak
    try:
        return replace(_move(parts), terse=True)
    except ExceededError:
        raise
    except TroubleError:
        raise unfit() from None  # what is wrong is said of the reading with a verb


def _direction(parts: Parts, measures: Mapping[str, float]) -> tuple[float, float]:
    said = [
        one.meaning.partition(":")[0]
        for one in words(parts, "FORWARD", "BACKWARD", "BRIDGE", "BACK_UP", "TURN_SIDE", "LEFT_RIGHT")
    ]
    turns = bool(words(parts, "TURN", "A_TURN")) or said[:1] in (["left"], ["right"])
    if turns and not words(parts, "TURN", "A_TURN", "BRIDGE") and "angle" not in measures:
        raise trouble(f"moving sideways ({said[0]!r}) is no skill of this robot", said[0])
    wrong = {"distance", "linear_speed"} if turns else {"angle", "angular_speed"}
    if wrong & set(measures) or ("duration" in measures and {"distance", "angle"} & set(measures)):
        raise unfit()
    if not measures and [one.said for one in words(parts, "MOVE", "FORWARD")] == ["go", "ahead"]:
        raise trouble("walk ahead, or go on with what?", asks=True)
    if _is_return(parts, measures):
        raise trouble("back to where, or backward?", asks=True)
    verbs = {word.said.split()[0] for word in words(parts, "MOVE")}
    if not said and (verbs & _ADVANCES or ("distance" in measures and verbs & _WALKS)):
        said = ["forward"]
    if not said:
        raise trouble("to the left or to the right?" if turns else NO_DIRECTION, asks=True)
    return (0.0, _ANGULAR[said[0]]) if turns else (_LINEAR[said[0]], 0.0)


def _is_return(parts: Parts, measures: Mapping[str, float]) -> bool:
    """Whether it may mean to go back to where the robot was: "go back"."""
    heading, verb = words(parts, "BACKWARD"), words(parts, "MOVE")
    return bool(
        heading
        and heading[0].said == "back"
        and not measures
        and verb
        and verb[0].said.split()[0] not in ("move", "step", "take")
    )


def _turn_around(parts: Parts) -> Clause:
    duration_s = round(math.pi / TURN_RAD_S, 3)
    return clause(parts, [(draft("move", linear_m_s=0.0, angular_rad_s=TURN_RAD_S, duration_s=duration_s),)])


def _go_home(parts: Parts) -> Clause:
    bare = words(parts, "GO_HOME")[0].said in ("home", "homing")
    return replace(clause(parts, [(draft("go_home"),)]), terse=bare)


def _stop(parts: Parts) -> Clause:
    return clause(parts, [(draft("stop"),)])


def _revoke(parts: Parts) -> Clause:
    return replace(_stop(parts), revokes=words(parts, "REVOKE")[0].said)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        name: guarded(meaning)
        for name, meaning in {
            "toward": _toward,
            "toward_where": _toward_where,
            "toward_location": _toward_location,
            "toward_owner": _toward_owner,
            "toward_front": _toward_front,
            "toward_me": _toward_me,
            "toward_inside": _toward_inside,
            "toward_relation": _toward_relation,
            "walk": _walk,
            "approach": _walk_item,
            "walk_item": _walk_item,
            "meet_me": _meet_me,
            "come": _come,
            "come_to_tell": _come_to_tell,
            "go_back": _go_back,
            "go_there": _go_there,
            "go_somewhere": _go_somewhere,
            "move": _move,
            "move_on": _move_on,
            "walk_bare": _walk_bare,
            "walk_at_speed": _walk_at_speed,
            "turn_around": _turn_around,
            "go_home": _go_home,
            "stop": _stop,
            "revoke": _revoke,
        }.items()
    }
)
