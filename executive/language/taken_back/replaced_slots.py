"""What a correction does to the slots of tasks: it contrasts with them, adds to them, loses some."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from executive.meaning import Command, command_json

SAME, CONTRASTS, ADDS, LOSES = "same", "contrasts", "adds", "loses"

_PUTS = {"place": ("on", "to"), "put_in": ("to",)}


def change(before: Sequence[Command], after: Sequence[Command], *, earlier: bool, whole: bool) -> str | None:
    """What a correction does to commands.

    None where they are not the same but for what is said anew, where more than that is said anew, or where it
    is open what holds on: in "the cup on the table, no, the bottle", whether the bottle is on the table too.

    Args:
        before: What is meant without it.
        after: What is meant with it.
        earlier: Whether a noun of its own stands for one that other words follow.
        whole: Whether it begins with what to do, so that all that differs must be one slot.
    """
    if len(before) != len(after):
        return None
    kinds: list[str] = []
    for old, new in zip(map(_slots, before), map(_slots, after), strict=True):
        if "say" in (old["action"], new["action"]) or set(old) != set(new) or old["action"] != new["action"]:
            return None
        changed = [name for name in new if new[name] != old[name]]
        relative = "object" in changed and ("from" in new or "relation" in new["object"])
        if relative and earlier:
            return None
        kinds += [_kind_of_change(old[name], new[name]) for name in changed]
    if not kinds:
        return SAME
    if whole and len(kinds) > 1:
        return None
    return next((one for one in (LOSES, ADDS) if one in kinds), CONTRASTS)


def only_slots_that_differ(
    before: Sequence[Command], after: Sequence[Command]
) -> tuple[set[str], set[str], set[str]] | None:
    """Which slots of the same actions differ, and which only the first and only the second have.

    None where they are not the same actions.
    """
    if len(before) != len(after):
        return None
    changed: set[str] = set()
    gone: set[str] = set()
    new: set[str] = set()
    for one, other in zip(map(_slots, before), map(_slots, after), strict=True):
        if one["action"] != other["action"]:
            return None
        gone |= set(one) - set(other)
        new |= set(other) - set(one)
        changed |= {name for name in set(one) & set(other) if one[name] != other[name]}
    return changed, gone, new


def holds(commands: Sequence[Command], part: Sequence[Command]) -> bool:
    """Whether some commands are among others, one after another, and nothing more is done with theirs."""
    all_of, some = _by_themselves(commands), _by_themselves(part)
    return any(
        all_of[start : start + len(some)] == some
        and not any(
            one.get("object") == {"ref": place - index}
            for index, one in enumerate(all_of[start + len(some) :], start + len(some))
            for place in range(start, start + len(some))
        )
        for start in range(len(all_of) - len(some) + 1)
    )


def _by_themselves(commands: Sequence[Command]) -> list[dict[str, Any]]:
    """Commands whose references count from where they stand."""
    return [
        {
            name: {"ref": value["ref"] - index} if isinstance(value, dict) and "ref" in value else value
            for name, value in command_json(command).items()
        }
        for index, command in enumerate(commands)
    ]


def _kind_of_change(old: Any, new: Any) -> str:
    if isinstance(old, list) and isinstance(new, list) and old and new:
        old, new = old[0][-1], new[0][-1]  # where something is put
    if not isinstance(old, dict) or not isinstance(new, dict):
        return CONTRASTS if isinstance(old, dict) == isinstance(new, dict) else ADDS
    if "relation" in old and "relation" in new and old["relation"] != new["relation"]:
        rest = {key: value for key, value in old.items() if key != "relation"}
        if rest == {key: value for key, value in new.items() if key != "relation"}:
            return _kind_of_change(old["relation"]["to"], new["relation"]["to"])
    if old.get("kind") == new.get("kind") and not set(old) <= set(new):
        return LOSES
    return CONTRASTS if set(old) == set(new) else ADDS


def _slots(command: Command) -> dict[str, Any]:
    """A command's slots; putting onto, into and next to is one action with one goal."""
    slots = command_json(command)
    goals = _PUTS.get(slots["action"])
    if goals is not None:
        slots["goal"] = [(slots["action"], name, slots.pop(name)) for name in goals if name in slots]
        slots["action"] = "put"
    return {"count": 1, **slots}
