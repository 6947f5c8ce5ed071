"""The thing before the command that names it "it", or once more: "the red cup, pick it up"."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.arranging import Arranged, arranged, guarded
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Bundle, Clause, Item, Nominal, Trouble, Where


def fronted(parts: Parts) -> Clause | Trouble | None:
    """The command with the thing that stands before it."""
    command: Clause = parts[-1]
    topic = next(part for part in parts if isinstance(part, Item))
    if (
        any(mark.meaning not in (",", ":") for mark in words(parts, "PAUSE")[-1:])
        or not command.bundles
        or any(_leans(bundle) for bundle in command.bundles[1:])
    ):
        return None
    listed = any(mark.meaning == "," for mark in words(parts, "PAUSE")[-1:])
    one: Arranged | Trouble | None = _TOPIC((topic,))
    if not isinstance(one, Arranged):
        return one
    of = one.object
    if of.plural and of.determined and not of.counted:
        of = replace(of, count="all")
    first, *rest = command.bundles[0]
    said = first.get("object")
    if said == one.object and len(command.bundles) == 1 and not topic.details:
        return replace(command, terse=True, topic=listed)  # "the cup: bring me the cup"
    if not isinstance(said, Nominal) or said.reference not in _pronouns(of) or of.reference:
        return None
    if of.sort not in ("thing", "container", "door") or (of.plural and of.count == 1):
        return None
    changed = first.replacing("object", of)
    for name, value in (("count", None if of.count == 1 else of.count), ("source", one.source)):
        if value is not None and first.get(name) is not None:
            return None
        changed = changed.with_slot(name, value)
    return replace(command, bundles=((changed, *rest), *command.bundles[1:]), terse=True, topic=listed)


def _pronouns(of: Nominal) -> tuple[str, ...]:
    """What stands for it right behind it: "that one" for one thing, either of the others for scissors."""
    if of.count != 1 or of.plural:
        return ("them",)
    return ("it", "this", "them") if of.paired else ("it", "this")


def _leans(bundle: Bundle) -> bool:
    """Whether what is done to another thing in one breath leans on what was said before: "it and that"."""
    named = bundle[0].get("object")
    return not isinstance(named, Nominal) or named.reference is not None or named.anaphoric


def _topic(parts: Parts) -> Arranged | None:
    (item,) = parts
    stays = all(isinstance(detail, Where) and detail.role in ("is", "either") for detail in item.details)
    (one,) = arranged(parts)
    places_things = item.of.sort == "thing"
    return one if not item.details or (stays and places_things) else None


_TOPIC = guarded(_topic)
