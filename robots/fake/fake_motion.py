"""Motions of the fake robot: carried out exactly, on the injected clock."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from robots.clock import Clock
from robots.control.guarded.guarded_motion import GuardedMotion
from robots.control.motion_handle import MotionHandle, MotionStatus

# A trajectory that starts farther from the reference than this would jump.
_JUMP_RAD = 1e-6


class FakeMotion:
    """Plays checked trajectories; satisfies ``trees.toolbox.MotionControl``.

    Attributes:
        refuse: While it is set, every motion is refused with this reason.
        refuse_midway: Every motion is refused halfway with this reason, as by a gate.
        started: Names of everything that was started, in order.
    """

    def __init__(self, model: RobotModel, clock: Clock) -> None:
        """Hold the home posture."""
        self.refuse = ""
        self.refuse_midway = ""
        self.started: list[str] = []
        self._model, self._clock = model, clock
        self._q = model.q_home.copy()
        self._stance = self._home = stance_at(model, self._q)
        self._active: tuple[CheckedTrajectory, MotionHandle, float] | None = None
        self._others: list[MotionHandle] = []
        self._sampler: tuple[Trajectory, TrajectorySampler] | None = None

    @property
    def moving(self) -> bool:
        """Whether anything is under way."""
        return self._active is not None or any(not handle.finished for handle in self._others)

    def start(self, motion: CheckedTrajectory | GuardedMotion) -> MotionHandle:
        """Begin a checked trajectory.

        Raises:
            TypeError: It is a guarded motion: the fake has no control loop for one.
        """
        if not isinstance(motion, CheckedTrajectory):
            raise TypeError("the fake robot plays checked trajectories only")
        handle = self.note(f"trajectory {len(self.started) + 1}")
        if handle.finished:
            return handle
        self._others.remove(handle)
        if self._active is not None:
            return _refused(handle, "another motion has the body")
        if float(np.abs(motion.trajectory.q[0] - self._q).max()) > _JUMP_RAD:
            return _refused(handle, "it does not start at the reference")
        self._active = motion, handle, self._clock.now_s()
        return handle

    def note(self, name: str) -> MotionHandle:
        """Handle of a motion that somebody else plays, refused when motions are."""
        handle = MotionHandle(name, f"fake {len(self.started)}")
        self.started.append(name)
        if self.refuse:
            return _refused(handle, self.refuse)
        self._others.append(handle)
        return handle

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Stop on the spot and hold."""
        if handle.finished:
            return
        handle.status, handle.reason = MotionStatus.CANCELED, reason
        if self._active is not None and self._active[1] is handle:
            self._active = None

    @property
    def posture(self) -> Array:
        """The same as ``reference``, not to be written to: another array whenever it was changed."""
        return self._q

    def reference(self) -> Array:
        """Configuration that is commanded now, shape (nq,)."""
        return self._q.copy()

    def acceleration(self) -> Callable[[], Array]:
        """Tells that of this instant, shape (nv,), also later: what the efforts are felt from."""
        if self._active is None:
            return self._at_rest
        trajectory, elapsed_s = self._active[0].trajectory, self._clock.now_s() - self._active[2]
        return lambda: self._accelerated(trajectory, elapsed_s)

    def _at_rest(self) -> Array:
        return np.zeros(len(self._q) - 1)

    def _accelerated(self, trajectory: Trajectory, elapsed_s: float) -> Array:
        if self._sampler is None or self._sampler[0] is not trajectory:
            self._sampler = trajectory, TrajectorySampler(trajectory)
        return self._sampler[1].at(min(elapsed_s, trajectory.duration_s)).a

    def stance(self) -> Stance:
        """Both feet as they are at home, wherever they have walked."""
        return self._stance

    def feet(self) -> PlanarPose:
        """The middle between the feet, in the odometry frame."""
        soles = [PlanarPose.of(pose) for _, pose in self._stance.soles]
        return PlanarPose.between(soles[0], soles[-1])

    def step_by(self, step: PlanarPose) -> None:
        """Carry feet and body along, by a pose in the frame of the feet: what walks plays that itself."""
        here = self.feet()
        moved = (here @ step @ here.inverse()).transform()
        self._stance = Stance(tuple((frame, moved @ sole) for frame, sole in self._stance.soles))
        self._q = StandingRobot.of(self._model, self._stance).placed(self._q)

    def unwalked(self) -> Callable[[], Array]:
        """Tells this instant's configuration with the feet where they were at first, shape (nq,), also later.

        It bears the same.
        """
        here = self._q
        if self._stance is self._home:
            return lambda: here
        return lambda: StandingRobot.of(self._model, self._home).placed(here)

    def be_at(self, q: Array) -> None:
        """Be at a configuration, shape (nq,): for a motion that somebody else plays."""
        self._q = q.copy()

    def advance(self) -> None:
        """Follow the trajectory under way to the present time."""
        self._others = [handle for handle in self._others if not handle.finished]
        if self._active is None:
            return
        checked, handle, start_s = self._active
        trajectory = checked.trajectory
        elapsed_s = min(self._clock.now_s() - start_s, trajectory.duration_s)
        handle.progress = elapsed_s / trajectory.duration_s
        after = min(int(np.searchsorted(trajectory.t_s, elapsed_s, side="right")), len(trajectory.t_s) - 1)
        before_s, after_s = trajectory.t_s[after - 1], trajectory.t_s[after]
        share = (elapsed_s - before_s) / (after_s - before_s)
        self._q = trajectory.q[after - 1] + share * (trajectory.q[after] - trajectory.q[after - 1])
        if self.refuse_midway and handle.progress >= 0.5:
            _refused(handle, self.refuse_midway)
            self._active = None
        elif elapsed_s >= trajectory.duration_s:
            handle.status = MotionStatus.DONE
            self._active = None


def _refused(handle: MotionHandle, reason: str) -> MotionHandle:
    handle.status, handle.reason = MotionStatus.REFUSED, reason
    return handle
