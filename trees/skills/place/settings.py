"""Numbers of putting down; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PlaceSettings:
    """Numbers of putting down.

    Attributes:
        rest_s: The hand is felt at rest for so long before it is lowered.
        early_touch_m: A touch so far above where it should come is one with something else.
        further_m: How much farther down each further step goes when nothing was touched.
        shifted_m: What is seen so far from where the hand should have it has shifted in the hand; a bias
            of 5 mm that turns with the hand looks like 7 mm.
        placed_tolerance_m: A placed object is seen this near to where it was meant to stand.
        seen_error_m: Kept of that tolerance where fingers on a palm push an object as they open: it may then
            stand anywhere about there, and a look errs by so much.
    """

    rest_s: float = 0.3
    early_touch_m: float = 0.025
    further_m: float = 0.008
    shifted_m: float = 0.008
    placed_tolerance_m: float = 0.02
    seen_error_m: float = 0.005
