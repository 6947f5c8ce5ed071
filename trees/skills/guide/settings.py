"""Numbers of leading somebody somewhere; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class GuideSettings:
    """Numbers of leading somebody somewhere.

    Attributes:
        stretch_m: After so much of the way the robot looks round: a room's length, in which nobody is lost.
        near_m: Who is so near comes along; the robot goes on.
        pan_rad: So far to a side the head looks back, the feet turn by the rest.
        waits_s: For so long it waits for somebody who does not come nearer, or is not seen.
        seen_s: Who was seen so recently is in view.
        no_way_s: For so long it waits for a way that is barred.
        longest_s: It ends after so long.
    """

    stretch_m: float = 2.0
    near_m: float = 2.0
    pan_rad: float = 1.0
    waits_s: float = 20.0
    seen_s: float = 0.4
    no_way_s: float = 15.0
    longest_s: float = 400.0
