"""What somebody is called who was seen."""

from __future__ import annotations

from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.believed_thing import PERSON
from trees.beliefs.scene.scene_update import kind_of


def name_of(place: Place) -> str:
    """The person's name; empty where nobody recognised the person."""
    name = kind_of(place.name)
    return "" if name == PERSON else name


def called_person(place: Place) -> str:
    """The person as the subject of a sentence: "Ana", "the person"."""
    return name_of(place) or f"the {PERSON}"
