"""Numbers of walking behind somebody; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class FollowSettings:
    """Numbers of walking behind somebody.

    Attributes:
        distance_m: From the middle of the person to the middle of the robot, where both stand.
        nearest_m: A walk that has come so near to the person ends: from here a robot that stops at once still
            leaves a hand's breadth between its hands and the person.
        slack_m: The person may be so much farther away than ``distance_m`` before the robot sets out.
        pace: Share of the longest step; the rest is for curves. TALOS comes along at 0.44 m/s with it, and
            falls behind who walks faster.
        lost_s: Not seen for so long, the person is lost; with the way of a picture it is told within 3 s.
        still_s: Somebody who has walked and then stands for so long has arrived.
        still_m: Who moves less than this stands: the sway of the own walk moves what is seen by a third.
        sets_out_s: Somebody who has not set out by then is not going anywhere.
        stays_s: With a goal: who stands elsewhere for so long is not going there.
        near_m: Of ``to``: so near to a piece of furniture or a person is there.
        losses: How often it looks round for somebody whom it has lost.
        longest_s: It ends after so long.
    """

    distance_m: float = 1.0
    nearest_m: float = 0.85
    slack_m: float = 0.25
    pace: float = 0.9
    lost_s: float = 2.2
    still_s: float = 4.0
    still_m: float = 0.12
    sets_out_s: float = 30.0
    stays_s: float = 30.0
    near_m: float = 1.2
    losses: int = 3
    longest_s: float = 300.0
