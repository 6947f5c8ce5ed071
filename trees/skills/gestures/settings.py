"""Numbers of waving, pointing and looking at; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class GestureSettings:
    """Numbers of waving, pointing and looking at.

    Attributes:
        wave_swings: How often a waving hand goes from side to side.
        wave_width_m: From one side to the other; an arm that is shorter than TALOS's waves less widely.
        wave_least_m: A swing narrower than this, as measured, does not count; less with such an arm.
        wave_least_swings: Fewer than so many is no waving.
        pointing_tolerance_m: The line through forearm and hand passes its target nearer than this.
        pointing_hold_s: How long the arm stays stretched out.
        centred: What is looked at is this near to the picture's centre, as a share of half the picture.
    """

    wave_swings: int = 4
    wave_width_m: float = 0.26
    wave_least_m: float = 0.15
    wave_least_swings: int = 3
    pointing_tolerance_m: float = 0.10
    pointing_hold_s: float = 1.5
    centred: float = 0.10
