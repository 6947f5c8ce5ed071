"""What the looks of one task have told of a person: a look may leave out what another one tells."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from robots.scenes.scene_description import POSTURES

ENOUGH_LOOKS = 2
"""What of a person two looks have not told is taken not to be there."""


@dataclass(frozen=True, slots=True)
class PersonLooks:
    """What the looks of one task have told of a person.

    Attributes:
        looks: How many have shown the person.
        traits: What they have told together, sorted; of postures the newest.
    """

    looks: int = 0
    traits: tuple[str, ...] = ()

    @property
    def posture(self) -> str | None:
        """How the person is: "sitting"; None where no look has told it."""
        return posture_in(self.traits)

    @property
    def enough(self) -> bool:
        """Whether another look would hardly tell more."""
        return self.looks >= ENOUGH_LOOKS and self.posture is not None

    def and_seen(self, traits: Iterable[str]) -> PersonLooks:
        """With one more look.

        Args:
            traits: What it has told.
        """
        told = set(traits)
        before = {one for one in self.traits if one not in POSTURES or posture_in(told) is None}
        return PersonLooks(self.looks + 1, tuple(sorted(told | before)))


def posture_in(traits: Iterable[str]) -> str | None:
    """How a person is of whom so much is told: "sitting"; None where that was not told."""
    return next((trait for trait in sorted(traits) if trait in POSTURES), None)
