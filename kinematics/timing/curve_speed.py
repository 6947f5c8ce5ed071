"""How fast a curve may be run at each place: limits of joints turned into limits of the parameter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, as_float64
from kinematics.motion.curves import Curve
from kinematics.timing.timing_kernel import fastest_rates

# Intervals of the curve: so many between two knots, and no fewer in all.
PER_PIECE = 8
AT_LEAST = 96
# Joints that change by less than this along a curve, rad, stand still.
STILL = 1e-9
# The least time for a curve along which nothing moves, s.
SHORTEST_S = 1e-3
# What is too fast or too far is corrected by this more than it needs, so that a few rounds suffice.
AIM = 0.01


@dataclass(frozen=True, slots=True)
class CurveGrid:
    """A curve as intervals, on each of which it is taken as the quadratic through three points.

    Attributes:
        step: Length of each interval in the curve's parameter, shape (n,).
        points: Coordinates at the ends and in the middles of the intervals, shape (2 n + 1, size).
    """

    step: Array
    points: Array

    @classmethod
    def along(cls, curve: Curve, per_piece: int = PER_PIECE) -> CurveGrid:
        """Divide a curve between its knots."""
        knots = as_float64(curve.knots, (None,), "knots")
        pieces = max(per_piece, -(-AT_LEAST // (len(knots) - 1)))
        parts = np.linspace(0.0, 1.0, 2 * pieces + 1)[:-1]
        s = (knots[:-1, None] + np.diff(knots)[:, None] * parts).ravel()
        step = np.repeat(np.diff(knots) / pieces, pieces)
        return cls(step, as_float64(curve(np.append(s, 1.0)), what="points"))

    def bounded(self, joints: Array, velocity: Array, acceleration: Array) -> SpeedBounds:
        """What limits of joints mean for the speed along the curve.

        Args:
            joints: Their positions at all points, shape (2 n + 1, k).
            velocity, acceleration: Their limits, shape (k,).
        """
        h = self.step[:, None]
        start, middle, end = joints[:-2:2], joints[1::2], joints[2::2]
        first = (4.0 * middle - 3.0 * start - end) / h
        last = (3.0 * end - 4.0 * middle + start) / h
        bend = 4.0 * (start - 2.0 * middle + end) / h**2
        fast = np.zeros((len(h) + 1, joints.shape[1]))
        fast[:-1] = np.abs(first)
        fast[1:] = np.maximum(fast[1:], np.abs(last))
        top = (1.0 / np.maximum(np.max(fast / velocity, axis=1), SHORTEST_S)) ** 2
        moving = np.ptp(joints, axis=0) > STILL
        first, last, bend = (as_float64((part / acceleration)[:, moving]) for part in (first, last, bend))
        return SpeedBounds(self.step, first, last, bend, top, np.ones(len(h)))


@dataclass(slots=True)
class SpeedBounds:
    """What bounds the speed along a curve of n intervals, as ``fastest_rates`` takes it.

    ``top`` (greatest squared rate of the parameter at each grid point) and ``share`` (of the acceleration
    limits, in each interval) are made smaller where the motion has to be slower.
    """

    step: Array
    first: Array
    last: Array
    bend: Array
    top: Array
    share: Array

    def rates(self) -> Array:
        """Squared rates of the parameter at the grid points that take the least time, shape (n + 1,)."""
        return fastest_rates(self.first, self.last, self.bend, self.share, self.top, self.step)

    def slow_down(
        self, factor: Array, far: Array, t_s: Array, times: Array, window_s: float, rates: Array
    ) -> None:
        """Make a motion slower where it needs it.

        Args:
            factor: By which the time of each segment between the samples is too short, shape (n - 1,).
            far: How far each sample is from the curve, over what is allowed, shape (n,).
            t_s: Times of the samples, shape (n,).
            times: When the grid points are passed, half a window earlier than the samples count.
            window_s: What one sample is the average of.
            rates: Squared rates at the grid points.
        """
        n = len(self.step)
        # the first and the last interval that the average at a sample is made of
        early = np.clip(np.searchsorted(times, t_s - window_s, side="right") - 1, 0, n - 1)
        late = np.clip(np.searchsorted(times, t_s, side="left"), 1, n)
        square = np.ones(n)
        for i in np.flatnonzero(factor > 1.0):
            part = square[early[i] : late[i + 1]]
            np.maximum(part, (factor[i] + AIM) ** 2, out=part)
        # a grid point belongs to the intervals on both of its sides
        both = np.append(square, 1.0)
        both[1:] = np.maximum(both[1:], square)
        self.top /= both
        # a corner is cut in proportion to the speed there and to the acceleration before and after it
        middle = np.clip(np.searchsorted(times, t_s - 0.5 * window_s, side="right") - 1, 0, n - 1)
        for i in np.flatnonzero(far > 1.0):
            k = far[i] + AIM
            part = square[early[i] : late[i]]
            np.maximum(part, k, out=part)
            ends = slice(middle[i], middle[i] + 2)
            self.top[ends] = np.minimum(self.top[ends], rates[ends].max() / k**2)
        self.share /= square
