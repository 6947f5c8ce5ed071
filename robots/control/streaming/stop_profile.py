"""What the body follows while it is stopped: a profile from where it is to rest.

Stop categories: 1 brakes along the path, so that the robot stays where its motion was checked;
2 brings every joint to rest at once, each within its own limits. Both end in holding, with the legs
carrying all the while. Category 0, power off, has no profile.
"""

from __future__ import annotations

import numpy as np

from kinematics.geometry.quintic import rest_to_rest
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample, TrajectorySampler
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.stopping.braking import brake_along, brake_joints, brake_standing, keeps_limits
from kinematics.stopping.prompt_brake import brake_promptly

_LATER_S = (0.02, 0.06)
"""Where a path turns back, or its acceleration steps, no brake can begin at once, but so much later."""
_LATEST_S = 0.45
"""Setpoints that rest by then leave the body time to come to rest within half a second."""
_LED_BACK_S, _LED_BACK_RAD = 0.2, 0.015
"""Legs that stopped each joint on its own are led back to the stance in this time, from this far at most."""
_SHARE_LED_BACK, _LED_ON_S = 0.8, 0.06
"""Of the limits, when they are led back while they brake, the rest being for that; and so long afterwards."""
_STRAY_RAD = 1e-3
"""Legs farther than this from the stance are not straying between samples: something else is wrong."""


class StopProfile:
    """The rows of a stop, one a control period.

    Attributes:
        steps: Whether the setpoints leave a jerk limit, for want of a brake that does not.
    """

    def __init__(self, rows: MotionSample, steps: bool = False) -> None:
        """Take the rows.

        Args:
            rows: Arrays with one row a period, the last at rest.
            steps: Whether the setpoints leave a jerk limit where the path's own acceleration steps.
        """
        self._rows, self.steps = rows, steps

    def __len__(self) -> int:
        """How many periods it takes."""
        return len(self._rows.q)

    def is_late(self, period_s: float) -> bool:
        """Whether it takes longer than a stop may: 0.5 s, less what the body sways on."""
        return len(self) * period_s > _LATEST_S

    def at(self, period: int) -> MotionSample:
        """Row of one period, counted from 0."""
        rows = self._rows
        return MotionSample(rows.q[period], rows.v[period], rows.a[period])

    @classmethod
    def along_path(
        cls, robot: StandingRobot, sampler: TrajectorySampler, t_s: float, period_s: float
    ) -> StopProfile | None:
        """Category 1: brake along a trajectory from a time on it.

        Returns:
            None when nothing within the limits ends before the trajectory itself does.
        """
        brake = brake_along(robot, sampler, t_s, period_s)
        if brake is None:
            return None
        return cls(resting_on_the_stance(robot, brake.rows, period_s), brake.steps)

    @classmethod
    def promptly_along_path(
        cls,
        robot: StandingRobot,
        sampler: TrajectorySampler,
        t_s: float,
        period_s: float,
        after_s: float = 0.0,
    ) -> StopProfile | None:
        """Category 1 where the path turns: go on for a while, if at all, then brake along it at its limits.

        Returns:
            None when that would not be at rest in time.
        """
        at_s = t_s + after_s
        if at_s >= sampler.duration_s:
            return None
        rows = brake_promptly(robot, sampler, at_s, period_s, _LATEST_S - after_s)
        if rows is None:
            return None
        periods = np.arange(1, round(after_s / period_s) + 1, dtype=np.float64)
        if len(periods):
            rows = _joined(sampler.many(t_s + period_s * periods), rows)
        return cls(resting_on_the_stance(robot, rows, period_s))

    @classmethod
    def soon_along_path(
        cls, robot: StandingRobot, sampler: TrajectorySampler, t_s: float, period_s: float
    ) -> StopProfile | None:
        """Category 1 from the first moment at which the path leaves room for it; None when none is soon."""
        tried = (cls.promptly_along_path(robot, sampler, t_s, period_s, after_s) for after_s in _LATER_S)
        return next((profile for profile in tried if profile is not None), None)

    @classmethod
    def standing(cls, robot: StandingRobot, now: MotionSample, period_s: float) -> StopProfile | None:
        """Category 2: every joint comes to rest as soon as its limits let it, with the feet where they are.

        Returns:
            None when the legs have no way to do that.
        """
        rows = brake_standing(robot, now, period_s)
        return None if rows is None else cls(rows)

    @classmethod
    def joint_by_joint(cls, robot: StandingRobot, now: MotionSample, period_s: float) -> StopProfile:
        """Category 2, each joint on its own: the last way out.

        The legs do not stop where the standing feet want them, and push them against each other. They are
        led there, for from where they would be, no motion could begin: while all brakes, where the limits
        have room for both, else once everything rests.
        """
        acceleration, jerk = robot.model.acceleration, robot.model.jerk
        braked = _each_braked(robot, now, _SHARE_LED_BACK, period_s, _LED_ON_S)
        led = resting_on_the_stance(robot, braked, period_s, stray_rad=_LED_BACK_RAD)
        if led is not braked and keeps_limits(led.a[:, 6:], now.a[6:], acceleration, jerk, period_s):
            return cls(led)
        braked = _each_braked(robot, now, 1.0, period_s, _LED_BACK_S)
        after = round(_LED_BACK_S / period_s)
        return cls(resting_on_the_stance(robot, braked, period_s, after, _LED_BACK_RAD))


def _each_braked(
    robot: StandingRobot, now: MotionSample, share: float, period_s: float, rest_s: float
) -> MotionSample:
    """Come to rest by a share of the limits, the base where the soles put it, and rest for so long."""
    model = robot.model
    limits = share * model.acceleration, share * model.jerk
    q, v, a = brake_joints(now.q[7:], now.v[6:], now.a[6:], *limits, period_s)
    periods = len(q)
    last = robot.placed(np.concatenate([now.q[:7], q[-1]]))
    if last[3:7] @ now.q[3:7] < 0.0:  # the same turn, but blended the short way
        last[3:7] *= -1.0
    part = (np.arange(1, periods + 1) / periods)[:, None]
    base = (1.0 - part) * now.q[:7] + part * last[:7]
    base[:, 3:] /= np.linalg.norm(base[:, 3:], axis=1, keepdims=True)
    base[-1] = last[:7]
    still = np.zeros((periods, 6))
    rows = MotionSample(np.hstack([base, q]), np.hstack([still, v]), np.hstack([still, a]))
    after = round(rest_s / period_s)
    rest = np.zeros((after, model.nv))
    return _joined(rows, MotionSample(np.repeat(rows.q[-1:], after, axis=0), rest, rest))


def _joined(first: MotionSample, second: MotionSample) -> MotionSample:
    return MotionSample(
        np.vstack([first.q, second.q]), np.vstack([first.v, second.v]), np.vstack([first.a, second.a])
    )


def resting_on_the_stance(
    robot: StandingRobot,
    rows: MotionSample,
    period_s: float,
    last: int | None = None,
    stray_rad: float = _STRAY_RAD,
) -> MotionSample:
    """Let the legs end exactly where base and stance put them, in so many of the last rows, or in all.

    Between the samples of a trajectory they stray from there by 1e-5 rad: nothing while it is played, but
    a plan that begins there would have to jump by as much.
    """
    space = free_coordinates(robot)
    exact, reached = space.to_q(space.from_q(rows.q[-1])[None, :])
    gap = exact[0, 7:] - rows.q[-1, 7:]
    if not reached[0] or np.abs(gap).max() > stray_rad:
        return rows
    n = last or len(rows.q)
    u = np.maximum(np.arange(1, len(rows.q) + 1) - (len(rows.q) - n), 0) / n
    s, ds, dds = rest_to_rest(u, n * period_s)
    q, v, a = rows.q.copy(), rows.v.copy(), rows.a.copy()
    q[:, 7:] += s[:, None] * gap
    v[:, 6:] += ds[:, None] * gap
    a[:, 6:] += dds[:, None] * gap
    q[-1, 7:], v[-1], a[-1] = exact[0, 7:], 0.0, 0.0
    return MotionSample(q, v, a)
