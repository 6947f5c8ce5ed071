"""Say what was noted about somebody."""

from __future__ import annotations

from trees.api import DONE, Contract, Leaf, Number, Place, Said, Status, optional, ports
from trees.beliefs.grounding.person_words import name_of
from trees.skills.about_people.about import About


class TellAbout(Leaf):
    """Give out what was noted: to whom it is for, who was met meanwhile, or to everybody."""

    INPUT_PORTS = ports(about=About, place=optional(Place))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="it is in words; whom it is for was met",
        postcondition="the words were given out, and what they rest on is told",
        deadline_s=1.0,
    )

    def step(self) -> Status:
        """Give the words out."""
        about: About = self.get_input("about")
        place: Place | None = self.optional("place")
        to = "" if place is None or place.name == about.whose else name_of(place)
        self.toolbox.events(Said(self.toolbox.clock.now_s(), about.words, to))
        evidence: dict[str, Number] = {
            "of": about.whose,
            "seen": ", ".join(about.traits),
            "known": about.known,
        }
        self.measured(**evidence)
        self._set_output("evidence", {"said": about.words, **evidence})
        self.feedback_message = about.words
        return DONE
