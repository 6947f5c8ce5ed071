"""What the body is commanded now: it plays a trajectory, brakes, or holds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.lead_in import lead_in
from kinematics.motion.sampler import MotionSample, TrajectorySampler
from kinematics.motion.trajectory import Trajectory
from kinematics.stopping.resuming import rest_of
from robots.control.streaming.motion_start import starts_elsewhere
from robots.control.streaming.stop_profile import StopProfile
from robots.control.streaming.way_back import way_back

_AHEAD = 100
"""Instants of a trajectory that are computed at once: many cost little more than one."""
_PLAY_OUT_S = 0.3
"""A trajectory that cannot be braked before it ends is played out if it ends within this."""


class BodyTrack:
    """The body's reference, one control period after the other.

    ``propose`` computes the next instant, ``commit`` accepts it; without the commit nothing has
    happened, so that a refused setpoint leaves the reference where the robot really is.

    Attributes:
        now: What is commanded now, base in the odometry frame.
    """

    def __init__(self, standing: StandingRobot, q: Array, period_s: float) -> None:
        """Hold a configuration, shape (nq,)."""
        self._robot, self._model = standing, standing.model
        self._period_s = period_s
        self._sampler: TrajectorySampler | None = None
        self._elapsed_s = 0.0
        self._periods = 0
        self._ahead: tuple[int, MotionSample] | None = None
        self._profile: StopProfile | None = None
        self._row = 0
        self._next: MotionSample | None = None
        self._playing_out = False
        self._trajectory: Trajectory | None = None
        self._paused_at_s: float | None = None
        self._passed = 0.0
        self._braked_on: tuple[TrajectorySampler, float, int] | None = None
        self._going_back = False
        self.now = self._at_rest(q)
        self._last_v = self.now.v

    @property
    def resting(self) -> bool:
        """Whether it holds."""
        return self._sampler is None and self._profile is None

    @property
    def braking(self) -> bool:
        """Whether it is coming to rest because it was told to."""
        return self._profile is not None or self._playing_out

    @property
    def progress(self) -> float:
        """Share of the trajectory that has passed, 0 to 1."""
        if self._sampler is None:
            return self._passed if self.paused else 1.0
        return self._passed + (1.0 - self._passed) * min(1.0, self._elapsed_s / self._sampler.duration_s)

    @property
    def paused(self) -> bool:
        """Whether a trajectory waits to go on from where it was braked to."""
        return self._paused_at_s is not None

    @property
    def planned(self) -> Trajectory | None:
        """The trajectory that is played; None while it brakes, holds or is placed."""
        return self._trajectory if self._sampler is not None else None

    @property
    def destination(self) -> Array:
        """Configuration where it is going to rest after braking; where it is when it does not brake."""
        if self._profile is not None:
            return self._profile.at(len(self._profile) - 1).q.copy()
        if self._playing_out and self._sampler is not None:
            return self._sampler.at(self._sampler.duration_s).q
        return self.now.q.copy()

    def play(self, trajectory: Trajectory) -> None:
        """Begin a trajectory; the first instant of it is the present one."""
        self._passed, self._paused_at_s = 0.0, None
        self._begin(trajectory)

    def _begin(self, trajectory: Trajectory) -> None:
        self._trajectory = trajectory
        self._sampler = TrajectorySampler(trajectory)
        self._profile = self._ahead = None
        self._elapsed_s, self._periods = 0.0, 0

    def pause(self) -> bool:
        """Brake along the path, to go on from there; tells whether that is possible now.

        Near the end, and where the path turns too sharply, it is not: try again later.
        """
        sampler = self._sampler
        if sampler is None or self._playing_out:
            return sampler is None
        at_s, braking_s = self._elapsed_s, 0.0
        if at_s > 0.0:
            profile = StopProfile.along_path(self._robot, sampler, at_s, self._period_s)
            if profile is None:
                return False
            self._start(profile)
            braking_s = 0.5 * self._period_s * len(profile)  # a brake takes half its time of the path
        self._passed += (1.0 - self._passed) * min(1.0, (at_s + braking_s) / sampler.duration_s)
        self._paused_at_s, self._sampler = at_s + braking_s, None
        return True

    def go_on(self) -> bool:
        """Begin with what a pause left of a trajectory; tells whether there is a way to. Call it at rest."""
        at_s, trajectory, self._paused_at_s = self._paused_at_s, self._trajectory, None
        if at_s is None or trajectory is None:
            return False
        rest = rest_of(self._robot, trajectory, self.now.q, at_s, self._period_s)
        if rest is None or starts_elsewhere(self._model, rest, self.now.q) is not None:
            return False
        self._begin(lead_in(rest, self.now.q, self._model.acceleration))
        return True

    def brake(self, along_path: bool, easing: str | None = None) -> None:
        """Begin to stop: along the path if there is one, else every joint on its own.

        Args:
            along_path: Whether to stay on the path.
            easing: A joint for which to go back on it afterwards, to where that carries less.
        """
        self._paused_at_s, self._braked_on = None, None
        if self.resting:
            return
        if self._going_back:
            self._going_back = False
            self._start(self._stop_at_once(None))
            return
        if along_path and self.braking:
            return
        profile = None
        sampler, self._sampler, self._playing_out = self._sampler, None, False
        if along_path and sampler is not None:
            profile = StopProfile.along_path(self._robot, sampler, self._elapsed_s, self._period_s)
            if profile is None and sampler.duration_s - self._elapsed_s <= _PLAY_OUT_S:
                self._sampler, self._playing_out = sampler, True
                return
            if profile is None or profile.steps or profile.is_late(self._period_s):
                profile = self._stop_promptly(sampler, profile)
        if easing is not None and sampler is not None:
            self._braked_on = sampler, self._elapsed_s, self._model.joint_index(easing)
        self._start(profile or self._stop_at_once(sampler))

    def _stop_at_once(self, sampler: TrajectorySampler | None) -> StopProfile:
        """Stop with the feet in place; where the legs cannot do that in time, along the path.

        Only where there is none each joint stops on its own.
        """
        standing = self._standing()
        if sampler is not None and (standing is None or standing.is_late(self._period_s)):
            of = self._robot, sampler, self._elapsed_s, self._period_s
            prompt = StopProfile.promptly_along_path(*of)
            if prompt is not None:
                return prompt
        if standing is not None:
            return standing
        return StopProfile.joint_by_joint(self._robot, self._followed(), self._period_s)

    def _followed(self) -> MotionSample:
        """What is commanded now, with the acceleration that the last two setpoints show.

        Where a trajectory's acceleration steps, a brake that began with the new one would add its jerk.
        """
        shown = (self.now.v - self._last_v) / self._period_s
        return MotionSample(self.now.q, self.now.v, shown)

    def _standing(self) -> StopProfile | None:
        return StopProfile.standing(self._robot, self._followed(), self._period_s)

    def _stop_promptly(self, sampler: TrajectorySampler, late: StopProfile | None) -> StopProfile | None:
        """Stop where an even brake along the path takes too long, or is none.

        Without any, the feet stay in place and each arm stops on its own before the path is gone on with.
        """
        of = self._robot, sampler, self._elapsed_s, self._period_s
        return (
            StopProfile.promptly_along_path(*of)
            or (None if late else self._standing())
            or StopProfile.soon_along_path(*of)
            or late
        )

    def brake_what_was_placed(self) -> None:
        """Bring joints to rest that ``place`` has moved."""
        if self.now.v.any():
            self._start(self._stop_at_once(None))

    def halt(self) -> None:
        """Rest right here: the robot was told so already."""
        self._sampler = self._profile = self._next = self._braked_on = None
        self._playing_out = self._going_back = False
        self._paused_at_s = None
        self.now = self._at_rest(self._robot.placed(self.now.q))
        self._last_v = self.now.v

    def place(self, joints: NDArray[np.intp], q: Array, v: Array) -> MotionSample:
        """Propose that something else moves some body joints; the rest holds."""
        q_next, v_next = self.now.q.copy(), np.zeros_like(self.now.v)
        q_next[7 + joints] = q
        v_next[6 + joints] = v
        self._next = MotionSample(q_next, v_next, (v_next - self.now.v) / self._period_s)
        return self._next

    def place_body(self, sample: MotionSample) -> MotionSample:
        """Propose what a whole-body motion made: base and all joints."""
        self._next = sample
        return sample

    def propose(self) -> MotionSample:
        """Compute the instant one period ahead."""
        if self._profile is not None:
            self._next = self._profile.at(self._row)
        elif self._sampler is not None:
            self._next = self._played(self._sampler, self._periods + 1)
            if (self._periods + 1) * self._period_s >= self._sampler.duration_s:
                self._next = self._at_rest(self._next.q)
        else:
            # The very same object, so that what depends on it need not be computed again.
            self._next = self.now
        return self._next

    def commit(self) -> None:
        """The proposed instant is what the robot follows now."""
        if self._next is None:
            return
        self._last_v = self.now.v
        self.now, self._next = self._next, None
        if self._profile is not None:
            self._row += 1
            if self._row >= len(self._profile):
                self._profile, self._going_back = None, False
                self.now = self._at_rest(self.now.q)
                self._go_back()
        elif self._sampler is not None:
            self._periods += 1
            self._elapsed_s = self._periods * self._period_s
            if self._elapsed_s >= self._sampler.duration_s:
                self._sampler, self._playing_out = None, False

    def _go_back(self) -> None:
        """After the brake, if that was asked for."""
        braked_on, self._braked_on = self._braked_on, None
        if braked_on is None:
            return
        sampler, t_s, joint = braked_on
        back = way_back(self._robot, sampler, t_s, self.now, joint, self._period_s)
        if back is not None:
            self._start(back)
            self._going_back = True

    def _played(self, sampler: TrajectorySampler, period: int) -> MotionSample:
        """Instant of the trajectory after so many periods."""
        first, rows = self._ahead or (period + 1, None)
        if rows is None or not first <= period < first + _AHEAD:
            first, rows = (
                period,
                sampler.many(self._period_s * np.arange(period, period + _AHEAD, dtype=np.float64)),
            )
            self._ahead = first, rows
        k = period - first
        return MotionSample(rows.q[k], rows.v[k], rows.a[k])

    def _start(self, profile: StopProfile) -> None:
        self._profile, self._row = profile, 0
        self._next = None

    def _at_rest(self, q: Array) -> MotionSample:
        rest = np.zeros(self._model.nv)
        return MotionSample(q.copy(), rest, rest)
