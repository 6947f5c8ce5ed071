"""Numbers of handing over; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class HandOverSettings:
    """Numbers of handing over.

    Attributes:
        offer_rest_s: An offering hand is felt at rest for so long first.
        pull_n: A change of the force on an offering hand that is a pull; a touch of 2 N is none.
        pull_s: It has to last so long.
        take_within_s: Nobody has taken it by then: it is taken back.
        after_giving_s: Between letting go and looking where it went.
    """

    offer_rest_s: float = 0.5
    pull_n: float = 3.0
    pull_s: float = 0.15
    take_within_s: float = 15.0
    after_giving_s: float = 0.8
