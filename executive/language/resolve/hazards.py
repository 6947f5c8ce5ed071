"""What would harm although every word of it is known: a fork in a toaster, a knife for a baby.

It is told from the tasks, where "it" is known to be the fork. What is dangerous is data: ``hazards.toml``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from executive.language.phrases.values import HARMS, Trouble
from executive.language.resolve.kinds import listed, rules
from executive.meaning import Command
from trees.beliefs.grounding.articles import with_article
from trees.tasks import HandOverTask, ObjectDescription, ObjectOf, PlaceTask, PutInTask


def harm_in(commands: Sequence[Command]) -> Trouble | None:
    """Why a robot must not do this, or None."""
    for command in commands:
        if not isinstance(command, HandOverTask | PutInTask | PlaceTask):
            continue
        thing = _described(command.object, commands)
        goal = _described(getattr(command, "on", None) or command.to, commands)
        where = goal.kind if isinstance(goal, ObjectDescription) else goal
        if not isinstance(thing, ObjectDescription) or thing.kind is None or not isinstance(where, str):
            continue
        if not any(_harms(rule, thing, where.lower(), command.action) for rule in rules("harm")):
            continue
        if isinstance(command, HandOverTask):
            told = f"the {thing.kind} could harm {with_article(where)}; it is not handed over"
        else:
            relation = "in" if isinstance(command, PutInTask) else "on"
            told = f"the {thing.kind} {relation} the {where} {HARMS}"
        return Trouble(told, thing.kind)
    return None


def _described(thing: Any, commands: Sequence[Command]) -> Any:
    """The description behind "it", which may stand for what "it" stood for before."""
    for _ in commands:
        if not isinstance(thing, ObjectOf) or not 0 <= thing.task < len(commands):
            break
        thing = getattr(commands[thing.task], "object", None)
    return thing


def _harms(rule: Mapping[str, Any], thing: ObjectDescription, where: str, action: str) -> bool:
    """Whether a rule forbids to do this with a thing there."""
    kind = thing.kind or ""
    if (
        action not in rule["actions"]
        or where not in listed(rule["where"])
        or where in _all(rule, "but_where")
    ):
        return False
    if (
        kind in listed("harmless")
        or kind in _all(rule, "but")
        or (kind.startswith("toy ") and not rule.get("toys"))
    ):
        return False
    if rule.get("material") and thing.material is not None:
        return bool(thing.material == rule["material"])
    within = next((kind.removesuffix(end) for end in listed("packs") if kind.endswith(end)), kind)
    named = {kind, within, kind.rpartition(" ")[2], within.rpartition(" ")[2]}
    return any(not named.isdisjoint(listed(one)) for one in rule["things"])


def _all(rule: Mapping[str, Any], name: str) -> frozenset[str]:
    return frozenset().union(*(listed(one) for one in rule.get(name, ())))
