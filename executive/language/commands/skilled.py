"""Skills of which the grammar knows only the words, said alone or of whom or what they are aimed at.

"Take a bow", "bow to Ana", "follow Ana from the sofa to the kitchen", "introduce yourself to Ben": whom or
what it is said of fills the slot of the task that is for it (``person``, ``to`` for a place, or ``object``),
where that is fills ``source``. A meaning is the action of a skill, and behind it what is true of its task:
"greet introducing".
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

from executive.language.commands import meanings
from executive.language.commands.gestures import somebody
from executive.language.commands.going import one_of_them, target
from executive.language.phrases.arranging import clause, trouble, unfit
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Bundle, Clause, Item, Items, Nominal, Relative, Where, draft
from executive.language.resolve.kinds import task_type
from executive.language.text.word import Word
from robots.scenes.furniture_names import KNOB


def _skilled(parts: Parts) -> Clause:
    (verb,) = words(parts, "SKILL", "SKILL_AT", "SKILL_TO")
    action, *told = verb.meaning.partition(":")[0].split()
    kind = task_type(action)
    if kind is None:
        raise trouble(f"{verb.said!r}: {action!r} is no skill of this robot", verb.said)
    known = {field.name for field in fields(kind)}
    items = [item for part in parts if isinstance(part, Items) for item in part.each]
    to = next((part for part in parts if isinstance(part, (Nominal, Relative))), None)
    if len(items) > 1 and "to" in known:
        raise trouble("several at once: name one", verb.said)
    if verb.word_class == "SKILL_TO" and not all(item.of.is_person or item.of.reference for item in items):
        raise unfit()
    bundles: list[Bundle] = []
    for item in items or (None,):
        slots: dict[str, Any] = dict.fromkeys(told, True)
        if item is not None:
            of, slots["source"] = _aimed(item)
            if verb.word_class == "SKILL_TO" and to is None:
                raise trouble("where to?", asks=True)
            person = of.is_person or (of.reference == "them" and "person" in known)
            goes = of.is_place and "to" in known and "person" not in known
            slots["person" if person else "to" if goes else "object"] = of
        slots |= {} if to is None else {"to": to}
        _check(verb, known, slots)
        bundles.append((draft(action, **slots),))
    return clause(parts, bundles)


def _switched(parts: Parts) -> Clause:
    """Turn something on or off, with the word behind it, or a knob; other things are turned in other ways."""
    verb, items, *state = parts
    if not state and any(item.of.kind != KNOB for item in items.each):
        raise unfit()
    meaning = "turn_knob off" if state and state[0].meaning == "off" else "turn_knob"
    return _skilled((replace(verb, word_class="SKILL_AT", meaning=meaning), items))


def _aimed(item: Item) -> tuple[Nominal, Nominal | None]:
    """Whom or what an item names, and from where."""
    sources = [one_of_them(one.of) for one in item.details if isinstance(one, Where) and one.role == "from"]
    rest = tuple(one for one in item.details if not (isinstance(one, Where) and one.role == "from"))
    if len(sources) > 1 or any(one.is_person or one.reference for one in sources):
        raise unfit()
    return target(replace(item, details=rest)), next(iter(sources), None)


def _check(verb: Word, known: set[str], slots: Mapping[str, Any]) -> None:
    """Whether a task has all slots that are said of it.

    Raises:
        TroubleError: It has not; a verb that is said of things as well then means something else.
    """
    for slot, value in slots.items():
        if slot in known or value is None:
            continue
        if verb.word_class == "SKILL_TO":
            raise unfit()
        what = value.said or value.kind or "that"
        raise trouble(f"{verb.said!r} is not done to {what!r}", value.kind)


def _answer(parts: Parts) -> Clause:
    """What the robot is asked about the time or itself; ``question`` is which question it is."""
    question = words(parts, "ASKED", "TOLD_OF")[0].meaning
    return clause(parts, [(draft("answer", question=question, person=_listener(parts)),)])


def _tell(parts: Parts) -> Clause:
    """The name, pose, gesture or clothes of somebody, to whoever speaks or to somebody else."""
    about = words(parts, "OF_SOMEBODY")[0].meaning
    of = somebody(target(next(part for part in parts if isinstance(part, Item))), f"the {about} of")
    return clause(parts, [(draft("tell", about=about, of=of, person=_listener(parts)),)])


def _listener(parts: Parts) -> Nominal | None:
    """Who is told it, unless that is who speaks."""
    person = next((part for part in parts if isinstance(part, Nominal)), None)
    if person is None or person.sort == "me":
        return None
    return somebody(person, "telling")


MEANINGS = meanings(
    {
        "skilled": _skilled,
        "switched": _switched,
        "answer": _answer,
        "tell": _tell,
    }
)
