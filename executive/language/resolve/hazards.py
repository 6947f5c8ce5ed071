"""What would harm although every word of it is known: a fork in a toaster, a knife for a baby.

It is told from the tasks, where "it" is known to be the fork. What is dangerous is data: ``hazards.toml``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from executive.language.phrases.values import Trouble
from executive.language.resolve.kinds import listed
from executive.meaning import Command
from trees.beliefs.grounding.articles import with_article
from trees.tasks import HandOverTask, ObjectDescription, ObjectOf, PlaceTask, PutInTask


def harm_in(commands: Sequence[Command]) -> Trouble | None:
    """Why a robot must not do this, or None."""
    for command in commands:
        if not isinstance(command, HandOverTask | PutInTask | PlaceTask):
            continue
        given = _described(command.object, commands)
        thing = given.kind if isinstance(given, ObjectDescription) else None
        if thing is None:
            continue
        if isinstance(command, HandOverTask):
            person = _kind(command.to, commands)
            if person is not None and _stands_in("children", person) and _hurts_a_child(thing, person):
                return Trouble(f"the {thing} could harm {with_article(person)}; it is not handed over", thing)
            continue
        place = command.on if isinstance(command, PlaceTask) and command.on is not None else command.to
        where = _kind(place, commands)
        into = isinstance(command, PutInTask)
        if where is not None and _is_dangerous(thing, given.material, where, into=into):
            relation = "in" if into else "on"
            return Trouble(
                f"the {thing} {relation} the {where} could harm; this robot does not do that", thing
            )
    return None


def _described(thing: Any, commands: Sequence[Command]) -> Any:
    """The description behind "it", which may stand for what "it" stood for before."""
    for _ in commands:
        if not isinstance(thing, ObjectOf) or not 0 <= thing.task < len(commands):
            break
        thing = getattr(commands[thing.task], "object", None)
    return thing


def _kind(place: Any, commands: Sequence[Command]) -> str | None:
    described = _described(place, commands)
    if isinstance(described, ObjectDescription):
        return None if described.kind is None else described.kind.lower()
    return described.lower() if isinstance(described, str) else None


def _is(kind: str, *lists: str) -> bool:
    """Whether a kind is in one of the lists, or made of what is: a "bread knife" is a knife."""
    return any(kind in listed(one) or kind.rpartition(" ")[2] in listed(one) for one in lists)


def _stands_in(one: str, kind: str) -> bool:
    """Whether a kind is in a list as a whole."""
    return kind in listed(one)


def _poisons(thing: str) -> bool:
    bottle = thing.removesuffix(" bottle").removesuffix(" box").removesuffix(" can")
    return not _stands_in("harmless", thing) and (_is(thing, "poison") or _is(bottle, "poison"))


def _hurts_a_child(thing: str, person: str) -> bool:
    if thing.startswith("toy ") or _stands_in("harmless", thing):
        return False
    swallows = _stands_in("small_children", person) and _is(thing, "medicine")
    return swallows or _is(thing, "sharp", "fire") or _poisons(thing)


def _is_dangerous(thing: str, material: str | None, where: str, *, into: bool) -> bool:
    heats = _stands_in("heats", where)
    if thing.startswith("toy ") and not heats:
        return False
    if _stands_in("cribs", where):
        return _is(thing, "sharp", "fire") or _poisons(thing)
    if heats and _is(thing, "explodes", "electric"):
        return True
    if not into:
        return False
    burns = _is(thing, "burns") and not _stands_in("baked_in", thing)
    if heats and burns and not _stands_in("open_fire", where):
        return True
    sparks = material == "metal" or (material is None and _is(thing, "metal"))
    if sparks and _stands_in("sparks", where):
        return True
    if _stands_in("water", where) and _is(thing, "electric"):
        return True
    return _stands_in("swallowed", where) and _poisons(thing)
