"""The soonest rest on a path: a brake that uses at each instant what the limits leave it there.

A brake of one slope and one bend (``kinematics.stopping.braking``) asks as much of the path where it turns as
where it runs straight, so just before a turn it has to be slow all the way. This one falls period after
period as steeply as the next setpoint may, and rests by the first even bend that keeps the limits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample, TrajectorySampler
from kinematics.stopping.braking import keeps_jerk, keeps_limits, stays_upright

_SHARES = (0.97, 0.8, 0.65)
"""Shares of the limits of acceleration and jerk: 3 % are for what lies between two looks, and a robot that
would tip is braked more gently. Far less is too little for a path that uses 0.9 of a limit itself."""
_STEEPEST_1_S = 12.0
"""Largest slope of the rate: where a path turns back all its joints rest for an instant and bound nothing."""
_LEAST_RATE = 0.02
"""A fall ends here, if no bend has left it before."""
_MOVING_RAD_S = 1e-9
_LOOKS: Array = np.linspace(0.0, 1.0, 13).astype(np.float64)
"""Shares of the time of a bend at which its accelerations and jerks are looked at."""
_AHEAD_S = 1e-3
"""Spacing of the instants of the path that stand for it there."""


@dataclass(frozen=True, slots=True)
class _Clock:
    """How the time along the path passes: the time, its rate and the slope of that, shape (n,) or more."""

    passed: Array
    rate: Array
    slope: Array


def brake_promptly(
    robot: StandingRobot,
    sampler: TrajectorySampler,
    t_s: float,
    period_s: float,
    latest_s: float,
) -> MotionSample | None:
    """Slow a trajectory down to rest without leaving its path, nearly as soon as its limits let it.

    Args:
        robot: Where it stands.
        sampler: The trajectory.
        t_s: Where along it the braking begins.
        period_s: Time between two rows of the answer.
        latest_s: When it has to be at rest, from the beginning of the brake.

    Returns:
        One row a period, the first at one period after the beginning, the last at rest; None when nothing
        was found that keeps the limits, keeps the robot upright and rests in time.
    """
    model, here = robot.model, sampler.at(t_s)
    before = sampler.at(max(t_s - period_s, 0.0)).v[6:]
    for share in _SHARES:
        clock = _Search(sampler, t_s, period_s, latest_s, model.acceleration, model.jerk, share).found()
        if clock is None:
            return None
        motion = sampler.many(t_s + clock.passed, clock.rate, clock.slope)
        motion.v[-1], motion.a[-1] = 0.0, 0.0
        told = np.vstack([before, here.v[6:], motion.v[:, 6:]])
        if not (
            keeps_limits(motion.a[:, 6:], here.a[6:], model.acceleration, model.jerk, period_s)
            and keeps_jerk(told, model.jerk, period_s)
        ):
            return None
        rows = np.unique(((len(motion.q) - 1) * _LOOKS).astype(np.intp))
        if stays_upright(robot, MotionSample(motion.q[rows], motion.v[rows], motion.a[rows])):
            return motion
    return None


@dataclass(frozen=True, slots=True)
class _Search:
    """One search for a clock that falls to rest; limits of the joints, shape (n,), and the share of them."""

    sampler: TrajectorySampler
    t_s: float
    period_s: float
    latest_s: float
    acceleration: Array
    jerk: Array
    share: float

    def found(self) -> _Clock | None:
        """The steepest fall, left for the bend that rests soonest: one row a period, without the present."""
        fall = self._fall()
        falling = np.flatnonzero(fall.slope < 0.0)
        begins, rate, slope = fall.passed[falling], fall.rate[falling], fall.slope[falling]
        # Rate s and slope -p reach 0 together by a change of slope of p^2 / 2s, in 2s / p, after 2s^2 / 3p.
        change, lasts_s = 0.5 * slope**2 / rate, -2.0 * rate / slope
        ends_s = falling * self.period_s + lasts_s
        fits = (ends_s <= self.latest_s) & (
            self.t_s + begins + rate * lasts_s / 3.0 <= self.sampler.duration_s
        )
        some = np.flatnonzero(fits)
        some = some[np.argsort(ends_s[some])]
        if len(some) == 0:
            return None
        columns = (begins[some, None], rate[some, None], slope[some, None], change[some, None])
        good = np.flatnonzero(self._allowed(_bend(*columns, lasts_s[some, None] * _LOOKS), columns[-1]))
        if len(good) == 0:
            return None
        best = int(some[good[0]])
        periods = int(np.ceil(lasts_s[best] / self.period_s - 1e-9))
        at_s = np.minimum(self.period_s * np.arange(1, periods + 1), lasts_s[best])
        bend = _bend(begins[best], rate[best], slope[best], change[best], at_s)
        return _joined(fall, int(falling[best]), bend)

    def _fall(self) -> _Clock:
        """Let the rate fall as steeply as each next setpoint may, from the present on, a row a period."""
        h = self.period_s
        here = self.sampler.at(self.t_s)
        told = self.sampler.at(max(self.t_s - h, 0.0)).v[6:], here.v[6:]
        bend, passed, rate, slope = here.a[6:], 0.0, 1.0, 0.0
        rows = [(passed, rate, slope)]
        for _ in range(int(self.latest_s / h)):
            passed += h * (rate + 0.5 * h * slope)
            if self.t_s + passed >= self.sampler.duration_s:
                break
            path = self.sampler.at(self.t_s + passed)
            straight = rate + h * slope
            change = max(
                self._least_change(path.v[6:], path.a[6:], straight, slope, bend, told),
                (-_STEEPEST_1_S - slope) / h,
            )
            rate, slope = straight + 0.5 * h * h * change, slope + h * change
            if rate > 1.0:  # the path's own motion leaves no room yet: it is followed as it is
                rate, slope = 1.0, 0.0
            if rate <= _LEAST_RATE:
                break
            rows.append((passed, rate, slope))
            bend = rate * rate * path.a[6:] + slope * path.v[6:]
            told = told[1], rate * path.v[6:]
        return _Clock(*np.array(rows).T)

    def _least_change(
        self, v: Array, a: Array, straight: float, slope: float, bend: Array, told: tuple[Array, Array]
    ) -> float:
        """Most negative change of slope over one period that the limits allow.

        Args:
            v, a: Of the path where the period ends.
            straight, slope: Rate there and slope if that does not change.
            bend: Accelerations now.
            told: Speeds one period ago and now.
        """
        h = self.period_s
        moves = np.abs(v) > _MOVING_RAD_S
        v, a, bend, jerk = v[moves], a[moves], bend[moves], self.jerk[moves]
        # More than the limit's share is kept to where the path itself uses more.
        most = np.maximum(self.share * self.acceleration[moves], np.abs(bend))
        low, high = (
            np.maximum(-most, bend - h * self.share * jerk),
            np.minimum(most, bend + h * self.share * jerk),
        )
        by_acceleration = _least(
            0.5 * (low + high) - straight * straight * a - slope * v,
            0.5 * (high - low),
            h * v + h * h * straight * a,
        )
        # The path's acceleration steps at its samples; differences of the speeds see that elsewhere.
        even = 2.0 * told[1][moves] - told[0][moves] - straight * v
        return max(by_acceleration, _least(even, h * h * jerk, 0.5 * h * h * v))

    def _allowed(self, bends: _Clock, change: Array) -> NDArray[np.bool_]:
        """Which of many bends, shape (n, k), keep the limits wherever they are looked at."""
        first, last = float(bends.passed.min()), float(bends.passed.max())
        ahead = self.sampler.many(
            self.t_s + np.arange(first, last + 2.0 * _AHEAD_S, _AHEAD_S, dtype=np.float64)
        )
        moves = np.flatnonzero(np.abs(ahead.v[:, 6:]).max(axis=0) > _MOVING_RAD_S)
        v, a = ahead.v[:, 6 + moves], ahead.a[:, 6 + moves]
        turn = np.gradient(a, _AHEAD_S, axis=0)
        k = np.rint((bends.passed - first) / _AHEAD_S).astype(np.intp)
        rate, slope, change = bends.rate[..., None], bends.slope[..., None], change[..., None]
        accelerations = rate**2 * a[k] + slope * v[k]
        jerks = rate**3 * turn[k] + 3.0 * rate * slope * a[k] + change * v[k]
        gentle = np.abs(accelerations) <= self.share * self.acceleration[moves]
        smooth = np.abs(jerks) <= self.share * self.jerk[moves]
        return np.asarray((gentle & smooth).all(axis=(1, 2)))


def _least(middle: Array, half: Array, gain: Array) -> float:
    """Smallest x for which every ``gain * x`` is within ``half`` of ``middle``, as far as one may go down."""
    gain = np.where(gain == 0.0, _MOVING_RAD_S, gain)
    return float(np.max(middle / gain - half / np.abs(gain), initial=-np.inf))


def _bend(passed: Array, rate: Array, slope: Array, change: Array, at_s: Array) -> _Clock:
    """The time along the path while its slope changes evenly."""
    return _Clock(
        passed + at_s * (rate + at_s * (slope / 2.0 + at_s * change / 6.0)),
        rate + at_s * (slope + at_s * change / 2.0),
        slope + at_s * change,
    )


def _joined(fall: _Clock, until: int, bend: _Clock) -> _Clock:
    """A fall up to one of its rows, and then a bend."""
    return _Clock(
        np.concatenate([fall.passed[1 : until + 1], bend.passed]),
        np.concatenate([fall.rate[1 : until + 1], bend.rate]),
        np.concatenate([fall.slope[1 : until + 1], bend.slope]),
    )
