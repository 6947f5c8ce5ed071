"""Where each sole finds the floor: on a plate before the plan's floor, beside it below."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from kinematics.model.robot_description import Hand
from kinematics.walking.pattern.pattern_sample import PatternSample, Phase

_EARLY_M = 0.003
"""A sole that feels the floor nearer to its place than this has landed as planned."""
_BRAKE_M_S2 = 9.0
"""Of a sole on its way down that has touched: with 12 a knee that swings at 0.4 m/s passes 150 rad/s^2."""
_LATE_S = 0.04
"""A sole that is to carry feels the floor by then on a level floor."""
_LOWERING_M_S, _LOWERING_M_S2 = 0.15, 6.0
_DEEPEST_M = 0.02
"""Under the plan's floor nothing is looked for any more."""
_LEVELLING_S, _LEVELLING_M_S, _LEVELLING_M_S2 = 2.0, 0.005, 0.05
"""So fast the plan's floor goes to the mean of those that carry: what was found wrongly does not add up."""
_RETURN_S = 0.3
"""After the lift-off, until the sole heads for the plan's floor again."""


@dataclass(slots=True)
class _Sole:
    """One of them.

    Attributes:
        height_m: Of the floor that it has found, over the plan's.
        rate_m_s: How fast it is moved beside the plan.
        planned_m: The height that the plan had it at last.
        since_s: Since its last lift-off or landing.
        aloft: Whether it is in the air by the plan.
        left_m: ``height_m`` at the last lift-off.
        speed_m_s: Its own once it has touched early, and nothing before.
        found: Whether it has felt the floor since it was to land.
    """

    height_m: float = 0.0
    rate_m_s: float = 0.0
    planned_m: float = 0.0
    since_s: float = 0.0
    aloft: bool = False
    left_m: float = 0.0
    speed_m_s: float | None = None
    found: bool = True


class FloorFinding:
    """Moves soles up and down beside the plan: held where they touch, lowered where nothing is felt.

    A sole that is pressed on down to the plan's floor lifts the robot off its other foot; one that is left
    hanging above a lower floor lets the robot tip over to it. What was found is kept until the next lift-off.
    """

    def __init__(self, heights_m: Mapping[Hand, float], period_s: float) -> None:
        """Stand on what is known.

        Args:
            heights_m: Of each sole over the plan's floor.
            period_s: The control period.
        """
        self._soles = {side: _Sole(height_m) for side, height_m in heights_m.items()}
        self._period_s = period_s
        self._levelling_m_s = 0.0

    @property
    def heights_m(self) -> Mapping[Hand, float]:
        """Of the floor under each sole, over the plan's."""
        return {side: sole.height_m for side, sole in self._soles.items()}

    def under(self, plan: PatternSample, loads_n: Mapping[Hand, float]) -> PatternSample:
        """The plan's next instant with the soles where the floor is.

        Args:
            plan: The instant.
            loads_n: On each sole, 0 for less than what carries.
        """
        sunk_m = self._level(plan)
        lift_m: dict[Hand, float] = {}
        for side, sole in self._soles.items():
            sole.height_m -= sunk_m
            sole.left_m -= sunk_m
            self._advance(sole, plan.lift_m[side], side not in plan.carrying, loads_n[side] > 0.0)
            lift_m[side] = plan.lift_m[side] + sole.height_m
        return replace(plan, lift_m=lift_m)

    def _level(self, plan: PatternSample) -> float:
        """How much lower every floor is seen from the plan's, which goes up or down with the body, m."""
        dt, wanted = self._period_s, 0.0
        if plan.phase not in (Phase.SETTLE, Phase.REST):
            mean_m = sum(self._soles[side].height_m for side in plan.carrying) / len(plan.carrying)
            wanted = min(max(mean_m / _LEVELLING_S, -_LEVELLING_M_S), _LEVELLING_M_S)
        most = _LEVELLING_M_S2 * dt
        self._levelling_m_s += min(max(wanted - self._levelling_m_s, -most), most)
        return self._levelling_m_s * dt

    def _advance(self, sole: _Sole, planned_m: float, aloft: bool, felt: bool) -> None:
        dt = self._period_s
        sole.since_s += dt
        if aloft != sole.aloft:
            sole.aloft, sole.since_s = aloft, 0.0
            if aloft:
                sole.left_m, sole.speed_m_s, sole.rate_m_s = sole.height_m, None, 0.0
            else:
                sole.found = sole.speed_m_s is not None
        sinking_m_s = (planned_m - sole.planned_m) / dt
        if aloft and sole.speed_m_s is None:
            share = min(sole.since_s / _RETURN_S, 1.0)
            back = share * share * share * (10.0 - 15.0 * share + 6.0 * share * share)
            sole.height_m = (1.0 - back) * sole.left_m
            if felt and sinking_m_s < 0.0 and share >= 1.0 and planned_m > _EARLY_M:
                sole.speed_m_s = sinking_m_s
        if sole.speed_m_s is not None:
            held_m = sole.planned_m + sole.height_m
            sole.speed_m_s = min(sole.speed_m_s + _BRAKE_M_S2 * dt, 0.0)
            sole.height_m = held_m + sole.speed_m_s * dt - planned_m
        elif not aloft:
            sole.found = sole.found or felt
            lowering = not sole.found and sole.since_s > _LATE_S and sole.height_m > -_DEEPEST_M
            wanted, most = (-_LOWERING_M_S if lowering else 0.0), _LOWERING_M_S2 * dt
            sole.rate_m_s += min(max(wanted - sole.rate_m_s, -most), most)
            sole.height_m += sole.rate_m_s * dt
        sole.planned_m = planned_m
