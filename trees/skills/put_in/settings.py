"""Numbers of putting in; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PutInSettings:
    """Numbers of putting in.

    Attributes:
        shelved_tolerance_m: The same on a board behind a door, where being in there was asked for and not a
            spot: as much as such a spot keeps from the board's edges.
    """

    shelved_tolerance_m: float = 0.03
