"""Put into words what was seen of somebody."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from types import MappingProxyType

from trees.api import DONE, Contract, Failure, Leaf, Place, Status, ports
from trees.beliefs.grounding.person_words import called_person, clothes_in, doing, gestures_in, name_of, worn
from trees.beliefs.grounding.report_words import listed
from trees.beliefs.scene.person_looks import posture_in
from trees.skills.about_people.about import About

Traits = Collection[str]


def _pose(who: str, traits: Traits) -> str | None:
    posture = posture_in(traits)
    return f"{who} is {posture}" if posture else None


def _gesture(who: str, traits: Traits) -> str | None:
    """Who was seen so well that the posture is known was seen well enough to tell of no gesture."""
    if gestures := gestures_in(traits):
        return f"{who} is {listed([doing(one) for one in gestures])}"
    return f"I see {who} make no gesture" if posture_in(traits) else None


def _clothes(who: str, traits: Traits) -> str | None:
    clothes = clothes_in(traits)
    return f"{who} wears {worn(clothes)}" if clothes else None


_TOLD: Mapping[str, Callable[[str, Traits], str | None]] = MappingProxyType(
    {"pose": _pose, "gesture": _gesture, "clothes": _clothes}
)
"""Answers from what was seen; None where it was not."""
_UNTOLD = MappingProxyType(
    {
        "name": "I do not know the name of {who}",
        "pose": "I cannot tell whether {who} is sitting or standing",
        "gesture": "I cannot tell what {who} does",
        "clothes": "I cannot tell what {who} wears",
    }
)


class NoteAbout(Leaf):
    """Put the answer into words, from what the looks of this task have shown; what they have not is told."""

    INPUT_PORTS = ports(task=object, place=Place)
    OUTPUT_PORTS = ports(about=About)
    CONTRACT = Contract(
        precondition="the person was seen in this task, more than once",
        postcondition="what was seen of the person is in words; what was not seen is told as such",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Put it into words."""
        place: Place = self.get_input("place")
        asked = self.get_input("task").about
        looks = self.toolbox.world.people.get(place.name)
        traits = () if looks is None else looks.traits
        if asked not in _UNTOLD:
            return Failure.infeasible(f"nothing is told of people as {asked!r}, only {listed([*_UNTOLD])}")
        who = called_person(place)
        if asked in _TOLD:
            answer = _TOLD[asked](who, traits)
        else:
            answer = f"the name of the person is {name_of(place)}" if name_of(place) else None
        words = _UNTOLD[asked].format(who=who) if answer is None else answer
        self._set_output("about", About(words, place.name, traits, answer is not None))
        self.feedback_message = words
        return DONE
