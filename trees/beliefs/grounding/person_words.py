"""What is seen of a person, in words for people."""

from __future__ import annotations

from collections.abc import Collection

from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.destination import Place
from trees.beliefs.grounding.report_words import listed, plural
from trees.beliefs.scene.believed_thing import PERSON
from trees.beliefs.scene.person_looks import posture_in
from trees.beliefs.scene.scene_update import kind_of


def gestures_in(traits: Collection[str]) -> list[str]:
    """What a person does with the arms: "waving", "raising left arm"."""
    posture = posture_in(traits)
    return sorted(one for one in traits if one.partition(" ")[0].endswith("ing") and one != posture)


def clothes_in(traits: Collection[str]) -> list[str]:
    """What a person wears: "red shirt"."""
    return sorted(set(traits) - {posture_in(traits), *gestures_in(traits)})


def doing(trait: str) -> str:
    """A posture or gesture behind "is": "raising the left arm", "pointing to the left"."""
    verb, _, rest = trait.partition(" ")
    if not rest:
        return verb
    return f"{verb} {'the' if rest.endswith('arm') else 'to the'} {rest}"


def worn(clothes: Collection[str]) -> str:
    """Clothes with their articles: "a red shirt and blue trousers"."""
    return listed([one if _is_pair(one) else with_article(one) for one in sorted(clothes)])


def looks_of(traits: Collection[str]) -> str:
    """All that is seen of somebody, behind the name: "is sitting and waving, in a red shirt"; empty for
    nothing.
    """
    posture = posture_in(traits)
    does = [doing(one) for one in ([] if posture is None else [posture]) + gestures_in(traits)]
    wears = worn(clothes_in(traits))
    return ", ".join([*([f"is {listed(does)}"] if does else []), *([f"in {wears}"] if wears else [])])


def people_who(traits: Collection[str], count: int) -> str:
    """So many people of whom so much is seen: "two people who are sitting, in a red shirt"."""
    posture = posture_in(traits)
    does = [doing(one) for one in ([] if posture is None else [posture]) + gestures_in(traits)]
    wears = worn(clothes_in(traits))
    who = f" who {'is' if count == 1 else 'are'} {listed(does)}" if does else ""
    return f"{plural('person', count)}{who}{f' in {wears}' if wears else ''}"


def _is_pair(garment: str) -> bool:
    """Whether it is a plural word: "blue trousers", "black shoes"."""
    return garment.endswith("s") and not garment.endswith("ss")


def name_of(place: Place) -> str:
    """The person's name; empty where nobody recognised the person."""
    name = kind_of(place.name)
    return "" if name == PERSON else name


def called_person(place: Place) -> str:
    """The person as the subject of a sentence: "Ana", "the person"."""
    return name_of(place) or f"the {PERSON}"
