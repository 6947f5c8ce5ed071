"""Which of the people around the robot a description means."""

from __future__ import annotations

from trees.beliefs.grounding.choice_words import from_the_left
from trees.beliefs.grounding.grounding import Ambiguous, Choice, Grounding, Missing, ground
from trees.beliefs.scene.believed_thing import PERSON, Surroundings
from trees.tasks import ObjectDescription


def compares_people(wanted: ObjectDescription, somebody: bool = False) -> bool:
    """Whether it says more of a person than that it is one: who was seen first is not taken for them then.

    Args:
        wanted: A description.
        somebody: Whether a person is meant, whatever the words are.
    """
    if wanted.name or not (somebody or wanted.kind == PERSON):
        return False
    said = (wanted.ordinal, wanted.relation, wanted.size, wanted.color, wanted.material)
    return wanted.kind != PERSON or bool(wanted.traits) or any(one is not None for one in said)


def person_meant(wanted: ObjectDescription, around: Surroundings) -> Grounding:
    """Find somebody by order and place; what cannot be seen of people leads to a question.

    Args:
        wanted: A description of somebody: "the person on the left", "the guest".
        around: What is believed to be around.
    """
    people = tuple(thing for thing in around.things if thing.is_person)
    if not people:
        return Missing(f"no {wanted} seen")
    if wanted.kind == PERSON and wanted.color is None:
        return ground(wanted, around, among=people)
    choices = tuple(Choice(thing.name, thing.name) for thing in from_the_left(people))
    return Ambiguous(f"which one is the {wanted}? that cannot be seen of people", choices)
