"""The people of a scene who take what is offered to them."""

from __future__ import annotations

from robots.simulated.body.physics import Physics
from robots.simulated.people.taking_person import TakingPerson
from robots.simulated.truth.truth import SimulatorTruth


class TakingPeople:
    """The people of a scene who take what is held out; ``tick`` is called once each control period."""

    def __init__(self, physics: Physics, truth: SimulatorTruth) -> None:
        """Have those take who do so in the scene."""
        self._truth = truth
        self._people = [TakingPerson(physics, truth, one.name) for one in physics.scene.people if one.takes]
        self._ticked_s = truth.time_s

    def see_offer(self, to: str) -> None:
        """The robot holds something out: whom it is for takes it, else the nearest of those who take things.

        Args:
            to: Whom the robot looks at.
        """
        held = sorted(self._truth.contacts.in_pads_only())
        if not held or not self._people:
            return
        meant = [person for person in self._people if person.name == to]
        person, thing = min(
            ((person, thing) for person in meant or self._people for thing in held),
            key=lambda one: one[0].distance_m(one[1]),
        )
        person.offer(thing, self._truth.time_s)

    def tick(self) -> None:
        """Go on with what is being taken."""
        now_s = self._truth.time_s
        for person in self._people:
            if person.offered:  # till then the hand rests by itself
                person.tick(now_s - self._ticked_s)
        self._ticked_s = now_s
