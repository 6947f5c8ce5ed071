"""What was understood, as one line for people: the slots of a command in plain words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from trees.beliefs.scene.scene_update import kind_of
from trees.registry import skill_called
from trees.tasks import WHERE_IT_WAS

_DESCRIPTION = ("ordinal", "size", "color", "material")
_NO_ARTICLE = ("me", "you", "in_front", "start")
_MEASURES = (
    ("linear_m_s", "at {:.3g} m/s"),
    ("angular_rad_s", "turning at {:.3g} rad/s"),
    ("distance_m", "for {:.3g} m"),
    ("duration_s", "for {:.3g} s"),
)


def meaning_words(meaning: Mapping[str, Any]) -> str:
    """The plainest words for a command's slots, which are those of ``meaning.command_json``."""
    action = str(meaning.get("action", ""))
    skill = skill_called(action)
    verb = action.replace("_", " ") if skill is None else skill.words
    toward = "" if skill is None else skill.toward
    words = [verb]
    if "object" in meaning:
        words.append(_called(meaning["object"], "every" if action == "count" else "the"))
    if "text" in meaning:
        words.append(f'"{meaning["text"]}"')
    words += [f"about {meaning[slot]}" for slot in ("question", "about") if slot in meaning]
    if "of" in meaning:
        words.append(_aim("of", meaning["of"]))
    where = "to" if "person" in meaning else toward
    for slot, before in (("person", toward), ("to", where), ("on", "on"), ("from", "from")):
        if slot in meaning:
            words.append(_aim(before, meaning[slot]))
    if "hand" in meaning:
        words.append(f"with the {meaning['hand']} hand")
    words += [text.format(meaning[slot]) for slot, text in _MEASURES if meaning.get(slot)]
    if "count" in meaning:
        words.append(f"({meaning['count']})")
    return " ".join(words)


def _aim(before: str, value: Any) -> str:
    """Where something goes or comes from; a spot that only a relation tells needs no word before it."""
    if value == WHERE_IT_WAS:
        return f"back {value}"
    if isinstance(value, Mapping) and set(value) == {"relation"}:
        return _relation(value["relation"])
    return f"{before} {_called(value)}".lstrip()


def _called(value: Any, article: str = "the") -> str:
    """A thing, a place or a person as people call it: "the red cup left of the bottle"."""
    if not isinstance(value, Mapping):
        word = str(value)
        is_name = not word.islower() or word in _NO_ARTICLE
        return word.replace("_", " ") if is_name else f"{article} {word}"
    if "ref" in value:
        return "it"
    noun = kind_of(str(value.get("name") or value.get("kind") or "thing"))
    said = [str(value[key]) for key in _DESCRIPTION if key in value]
    words = [] if "'s " in noun else [article]
    words += [*(word for word in said if word not in noun.split()), noun]
    if "relation" in value:
        words.append(_relation(value["relation"]))
    return " ".join(words)


def _relation(value: Mapping[str, Any]) -> str:
    return f"{str(value['is']).replace('_', ' ')} {_called(value['to'])}"
