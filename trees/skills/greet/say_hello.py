"""Say hello to somebody, and who one is."""

from __future__ import annotations

import math

from trees.api import DONE, Contract, Failure, Leaf, Number, Place, Said, Status, optional, ports
from trees.beliefs.grounding.person_words import called_person, name_of
from trees.readings.odometry import away_m, bearing_rad
from trees.toolbox import Toolbox

_FACED_RAD = math.radians(20.0)
"""People take somebody to face them who is turned aside by no more."""


class SayHello(Leaf):
    """Say hello to the person who was met, by name where it is known."""

    INPUT_PORTS = ports(task=object, place=Place, waved=optional(dict))
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the person was seen, and is faced",
        postcondition="the words were given out; to whom, from how far and whether a hand was waved is told",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Give the words out, to somebody who is faced: a hand that waves does so from a trunk that faces."""
        place: Place = self.get_input("place")
        name, swings = name_of(place), (self.optional("waved") or {}).get("swings", 0)
        beside_rad = bearing_rad(self.toolbox, place)
        if not swings and abs(beside_rad) > _FACED_RAD:
            who = called_person(place)
            return Failure.postcondition(f"{who} is not ahead, and no hand waved", beside_rad=beside_rad)
        words = f"Hello, {name}!" if name else "Hello!"
        if self.get_input("task").introducing:
            words = f"{words} {_introduction(self.toolbox)}"
        self.toolbox.events(Said(self.toolbox.clock.now_s(), words, name))
        evidence: dict[str, Number] = {
            "greeted": place.name,
            "swings": swings,
            "away_m": away_m(self.toolbox, place),
            "bearing_rad": beside_rad,
        }
        self.measured(**evidence)
        self._set_output("evidence", {"said": words, **evidence})
        self.feedback_message = words
        return DONE


def _introduction(toolbox: Toolbox) -> str:
    """Name, the configured one or the model's, and team, as far as they are known."""
    name, team = toolbox.identity.name or toolbox.model.description.name.upper(), toolbox.identity.team
    return f"I am {name}{f', of the team {team}' if team else ''}."
