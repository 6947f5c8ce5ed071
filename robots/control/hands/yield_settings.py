"""How a hand yields, and what it tells of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from kinematics.arrays import Array, Sealed
from kinematics.following.opening_motion import GATHERING

Outcome = Literal["running", "arrived", "stuck", "lost"]


@dataclass(frozen=True, slots=True)
class YieldSettings:
    """How a hand yields; measured on doors of 8 to 20 kg and drawers.

    Attributes:
        force_limit_n: The pull is bounded by this: below what slips out of the fingers, and the estimate may
            overshoot it by some newtons; at 80 N the robot tipped once.
        stop_force_n: The same where a stop is expected.
        eased_n: What has met its stop is pressed no harder than this when the hand has come to rest.
        ease_m: From a stop that it met, the hand goes back at least so far.
        slow_share: From this share of the limit on it slows down, to a stand at the limit.
        give_ns_m: Resistance of the hand across the path: the smaller, the softer.
        give_m_s: Fastest yielding.
        deadband_n: Less is not yielded to: noise of the estimate.
        stuck_speed_share, stuck_s: Slower than this share of its speed for so long is stuck.
        acceleration, deceleration: Of the way along the path, shares of its speed per second.
        force_share: Of a new estimate in the filtered one, each tick.
        lean_s: For shifting the CoM before the pull.
        settle_s: At the end, and after the gripper has closed.
        close_share: Of the speed before something gives way, and over the last piece of a closing door: the
            estimate is late by some hundredths of a second, in which a quick pull grows beyond its limit.
        bias_ticks: The first estimates, before anything is touched, are averaged into what counts as none.
        lost_s: The gripper may read empty for this long.
    """

    force_limit_n: float = 58.0
    stop_force_n: float = 40.0
    eased_n: float = 10.0
    ease_m: float = 0.0
    slow_share: float = 0.7
    give_ns_m: float = 300.0
    give_m_s: float = 0.15
    deadband_n: float = 2.0
    stuck_speed_share: float = 0.05
    stuck_s: float = 0.7
    acceleration: float = GATHERING
    deceleration: float = 6.0
    force_share: float = 0.3
    lean_s: float = 0.6
    settle_s: float = 0.3
    close_share: float = 0.35
    bias_ticks: int = 15
    lost_s: float = 0.1


USUAL = YieldSettings()
"""For doors and drawers."""


@dataclass(frozen=True, slots=True)
class YieldReport(Sealed):
    """What a yielding hand has felt and how far it came.

    Attributes:
        outcome: How it ended.
        s: Where along the path it was led.
        peak_force_n: Largest estimated force.
        peak_pull_n: Largest part of it against the way.
        bias: Of the estimate, force and moment, shape (6,).
    """

    outcome: Outcome
    s: float
    peak_force_n: float
    peak_pull_n: float
    bias: Array
