"""Say hello to somebody, and who one is."""

from __future__ import annotations

from trees.api import DONE, Contract, Leaf, Number, Place, Said, Status, optional, ports
from trees.readings.odometry import away_m, bearing_rad
from trees.skills.meeting.called_person import name_of
from trees.skills.meeting.introduction import introduction


class SayHello(Leaf):
    """Say hello to the person who was met, by name where it is known."""

    INPUT_PORTS = ports(task=object, place=Place, waved=optional(dict))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the person was seen, and is faced",
        postcondition="the words were given out; to whom, from how far and whether a hand was waved is told",
        deadline_s=1.0,
    )

    def step(self) -> Status:
        """Give the words out."""
        place: Place = self.get_input("place")
        name = name_of(place)
        words = f"Hello, {name}!" if name else "Hello!"
        if self.get_input("task").introducing:
            words = f"{words} {introduction(self.toolbox)}"
        self.toolbox.events(Said(self.toolbox.clock.now_s(), words, name))
        swings = (self.optional("waved") or {}).get("swings", 0)
        evidence: dict[str, Number] = {
            "greeted": place.name,
            "swings": swings,
            "away_m": away_m(self.toolbox, place),
            "bearing_rad": bearing_rad(self.toolbox, place),
        }
        self.measured(**evidence)
        self._set_output("evidence", {"said": words, **evidence})
        self.feedback_message = words
        return DONE
