"""The one way to the motors: turns checked trajectories and guarded motions into setpoints."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.start_gap import start_gap
from kinematics.model.robot_description import Hand
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.lead_in import lead_in
from kinematics.motion.trajectory import HeldLoad, Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from robots.clock import Clock
from robots.control.events import ControlSink
from robots.control.gate.authority import STOP, Authority, together
from robots.control.gate.proposal import Proposal
from robots.control.gate.refusal import Limit, Refusal
from robots.control.grip.grip_keeper import GripKeeper
from robots.control.guarded.guarded_motion import GuardedMotion
from robots.control.guarded.guarded_track import GuardedTrack
from robots.control.guarded.guarded_tracks import GuardedTracks
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.control.streaming.body_track import BodyTrack
from robots.control.streaming.motion_ledger import MotionLedger
from robots.control.streaming.motion_start import starts_elsewhere, why_not
from robots.interface.robot import RobotState

_TRY_EVERY = 25
"""Control periods from one attempt at a pause to the next: an attempt costs a period's time."""


class MotionStreamer:
    """Streams motions: satisfies ``trees.toolbox.MotionControl``.

    One trajectory at a time has the whole body. Guarded motions hold the joints that they declare;
    those of a gripper may run beside a trajectory.

    Attributes:
        trajectories: How many checked trajectories were begun.
        loads: What the hands carry, as the last of them was checked with.
        unweighed: What they carry besides, of unknown mass.
    """

    def __init__(
        self,
        standing: StandingRobot,
        q: Array,
        keepers: Mapping[Hand, GripKeeper],
        authority: Authority,
        clock: Clock,
        sink: ControlSink,
        period_s: float,
    ) -> None:
        """Hold a configuration.

        Args:
            standing: The robot where it stands.
            q: What it is commanded now, base in the odometry frame, shape (nq,).
            keepers: What the grippers do between motions.
            authority: Book of who moves which joint.
            clock: For the stamps of events.
            sink: Where events go.
            period_s: Control period.
        """
        model = standing.model
        self._standing, self._model = standing, model
        self._guarded = GuardedTracks(model, keepers, authority)
        self._authority = authority
        self._ledger = MotionLedger(clock, sink)
        self._period_s = period_s
        start_gap(model)  # read the robot's solids now, not in the period in which a motion begins
        self._track = BodyTrack(standing, q, period_s)
        self._body_handle: MotionHandle | None = None
        self._body_owner = ""
        self._waiting: tuple[CheckedTrajectory, MotionHandle] | None = None
        self._bodies, self._actuated = len(model.joints), len(model.description.actuated)
        self._closed_for = ""
        self._latched_for = ""
        self._pause_wanted = False
        self._periods_to_try = 0
        self.trajectories = 0
        self.loads: tuple[HeldLoad, ...] = ()
        self.unweighed: tuple[HeldLoad, ...] = ()

    # ---------------------------------------------------------------- for those who want to move

    def start(self, motion: CheckedTrajectory | GuardedMotion) -> MotionHandle:
        """Begin to stream a motion.

        A trajectory that begins where a cancelled one is braking to waits until that rests.

        Returns:
            A running handle, or a refused one with the reason: it does not start at the reference or
            at rest, stands elsewhere, or its joints are held by another motion.

        Raises:
            TypeError: It is neither a checked trajectory nor a guarded motion.
        """
        if isinstance(motion, CheckedTrajectory):
            return self._start_trajectory(motion)
        if not _is_guarded(motion):
            raise TypeError(
                f"only a CheckedTrajectory or a GuardedMotion can be streamed, not {type(motion).__name__}"
            )
        return self._start_guarded(motion)

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Brake a running motion along its path, then hold; a finished one is left alone."""
        if handle.finished:
            return
        if self._waiting is not None and self._waiting[1] is handle:
            self._waiting = None
        elif self._body_handle is handle:
            self._body_handle = None
            self._track.brake(along_path=True)
        elif (track := self._guarded.track_of(handle)) is not None:
            self._drop(track)
        self._ledger.end(handle, MotionStatus.CANCELED, reason)

    def reference(self) -> Array:
        """Configuration that is commanded now, base included, shape (nq,).

        While a motion is being braked: where it will rest, for that is where the next one begins.
        """
        return self._track.destination

    @property
    def planned(self) -> Trajectory | None:
        """The trajectory that is streamed; None while none is."""
        return self._track.planned

    def stance(self) -> Stance:
        """Where the feet stand."""
        return self._standing.stance

    def stand(self, standing: StandingRobot, q: Array) -> None:
        """Hold a configuration on feet that stand elsewhere now: the robot has walked there.

        Args:
            standing: The robot where they stand.
            q: What is commanded, base in the odometry frame, shape (nq,); nothing moves.
        """
        self._standing = standing
        self._track = BodyTrack(standing, q, self._period_s)

    # ---------------------------------------------------------------- pausing

    def pause(self) -> None:
        """Brake what moves the body along its path, and hold until ``resume``; fingers finish their way.

        What is under way stays under way, and what is begun meanwhile waits at its start. A hand that yields
        to what it holds, which no pause may stop halfway, goes on to its end.
        """
        self._pause_wanted, self._periods_to_try = True, 0
        self._try_to_pause()

    def resume(self) -> None:
        """Let what was paused go on, as soon as it has come to rest."""
        self._pause_wanted = False

    @property
    def paused(self) -> bool:
        """Whether it was told to pause, and nothing has ended that since."""
        return self._pause_wanted

    def _try_to_pause(self) -> None:
        """While a pause is wanted: where it is not possible now, try again a little later."""
        if self._body_handle is None or self._track.paused:
            return
        if self._periods_to_try > 0:
            self._periods_to_try -= 1
        elif not self._track.pause():
            self._periods_to_try = _TRY_EVERY

    def _go_on(self, handle: MotionHandle) -> None:
        """The body rests where a pause has braked it to, and no pause is wanted any more."""
        if not self._track.go_on():
            self._body_handle = None
            self._ledger.end(
                handle, MotionStatus.REFUSED, "it cannot be taken up again from where it was paused"
            )

    def keeper(self, hand: Hand) -> GripKeeper:
        """What a gripper does between motions."""
        return self._guarded.keepers[hand]

    # ---------------------------------------------------------------- for the control loop

    @property
    def resting(self) -> bool:
        """Whether nothing moves the body."""
        return self._track.resting and not self._guarded.moves_body

    @property
    def still(self) -> bool:
        """Whether neither body nor grippers are commanded to move."""
        return self._track.resting and self._guarded.still

    @property
    def standing(self) -> bool:
        """Whether the feet are meant to stay where they are: nothing but checked motions moves the body."""
        return not self._guarded.moves_body

    @property
    def in_contact(self) -> bool:
        """Whether a motion runs that holds something which may not move."""
        return self._guarded.in_contact

    @property
    def carrying_out(self) -> bool:
        """Whether a checked trajectory runs."""
        return self._body_handle is not None

    def propose(self, state: RobotState) -> Proposal:
        """Compute the setpoint one period ahead from the newest readings."""
        n = self._actuated
        q, v = np.empty(n), np.empty(n)
        for track in self._guarded.running:
            refusal = self._advance(track, state)
            if refusal is not None:
                return Proposal(track.handle.owner, q, v, self._track.now, refusal)
        body = self._track.propose()
        owners = [] if self._track.resting else [self._body_owner]
        for track in self._guarded.running:
            owners.append(track.handle.owner)
            if track.body is not None:
                body = self._track.place_body(track.body)
            elif track.moves_body:
                inside = track.indices < self._bodies
                body = self._track.place(track.indices[inside], track.q[inside], track.v[inside])
        q[: self._bodies], v[: self._bodies] = body.q[7:], body.v[6:]
        owners += self._guarded.propose_grips(q, v)
        return Proposal(together(owners), q, v, body)

    def commit(self) -> None:
        """The last proposal is what the robot follows now."""
        self._track.commit()
        self._guarded.commit()
        handle = self._body_handle
        if handle is not None:
            handle.progress = self._track.progress
            if self._pause_wanted:
                self._try_to_pause()
            elif self._track.paused and self._track.resting:
                self._go_on(handle)
            if self._track.resting and not self._track.paused and self._body_handle is not None:
                self._body_handle = None
                self._ledger.end(handle, MotionStatus.DONE, "")
        if self._track.resting and not self._track.paused and self._body_owner:
            self._authority.release(self._body_owner)
            self._body_owner = ""
            self._closed_for = ""
            if self._waiting is not None:
                (checked, waiting), self._waiting = self._waiting, None
                # it waited for where the body was braking to, which a halt may have kept it from
                elsewhere = starts_elsewhere(self._model, checked.trajectory, self._track.now.q)
                if elsewhere is None:
                    self._play(checked, waiting)
                else:
                    self._ledger.refuse(waiting, elsewhere)

    def stop(
        self,
        reason: str,
        along_path: bool,
        status: MotionStatus = MotionStatus.CANCELED,
        easing: str | None = None,
    ) -> None:
        """Take everything over: end all motions and bring the body to rest; grips that press go on.

        Args:
            reason: Told to those whose motions end.
            along_path: Brake along the path (stop category 1), else every joint at once (2).
            status: How the motions end.
            easing: A joint for which to go back on the path then, to where that carries less.
        """
        ended = [track.handle for track in self._guarded.running]
        self._pause_wanted = False
        for track in self._guarded.running:
            self._drop(track)
        if self._waiting is not None:
            ended.append(self._waiting[1])
        if self._body_handle is not None:
            ended.append(self._body_handle)
        self._body_handle = self._waiting = None
        self._track.brake(along_path, easing)
        if not self._track.resting:
            self._authority.release(self._body_owner)
            self._body_owner = STOP
            self._closed_for = reason
        for handle in ended:
            self._ledger.end(handle, status, reason)

    def interrupt(self, reason: str) -> None:
        """The body met something: end the running trajectory and rest; what comes next may start at once."""
        handle, self._body_handle = self._body_handle, None
        if handle is not None:
            handle.met_something = True
            self._track.brake(along_path=False)
            self._ledger.end(handle, MotionStatus.REFUSED, reason)

    def latch(self, reason: str) -> None:
        """Refuse every motion with this reason until ``unlatch``, whatever comes to rest meanwhile."""
        self._latched_for = reason

    def unlatch(self) -> None:
        """Take motions again."""
        self._latched_for = ""

    def revert(self) -> None:
        """The last proposal was refused: the grippers' setpoints stay where they were."""
        self._guarded.revert()

    def halt(self) -> None:
        """Rest where the robot was told to stay when nothing else was let through."""
        self._track.halt()
        self._guarded.halt()

    # ---------------------------------------------------------------- inside

    def _start_trajectory(self, checked: CheckedTrajectory) -> MotionHandle:
        handle = self._ledger.open("trajectory")
        reason = self.why_closed or why_not(self._standing, checked.trajectory, self.reference())
        if reason is None and self._track.braking and self._waiting is None:
            self._waiting = (checked, handle)
            return handle
        if reason is None and self._body_owner:
            reason = f"the body is held by {self._body_owner}"
        if reason is None and (conflict := self._authority.claim(handle.owner, self._model.joints)):
            reason = f"{conflict[0]} is held by {conflict[1]}"
        if reason is not None:
            return self._ledger.refuse(handle, reason)
        self._play(checked, handle)
        return handle

    def _play(self, checked: CheckedTrajectory, handle: MotionHandle) -> None:
        self._authority.claim(handle.owner, self._model.joints)
        self._body_handle, self._body_owner = handle, handle.owner
        self._track.play(lead_in(checked.trajectory, self._track.now.q, self._model.acceleration))
        self.trajectories += 1
        self.loads, self.unweighed = checked.loads, checked.unweighed
        self._ledger.begun(handle)
        if self._pause_wanted:
            self._track.pause()

    def _start_guarded(self, motion: GuardedMotion) -> MotionHandle:
        handle = self._ledger.open(motion.name)
        reason = self.why_closed or self._guarded.start(motion, handle, self._standing)
        if reason is not None:
            return self._ledger.refuse(handle, reason)
        self._ledger.begun(handle)
        return handle

    def _advance(self, track: GuardedTrack, state: RobotState) -> Refusal | None:
        """Let one guarded motion go on by a period; ends it when it is done."""
        try:
            refusal = track.advance(self._period_s, state)
        except Exception as error:  # a defect of one motion must not take the loop down with it
            return Refusal(Limit.DEFECT, f"{track.handle.name} ({type(error).__name__}: {error})", 0.0, 0.0)
        if refusal is None and track.done:
            self._drop(track)
            track.handle.progress = 1.0
            self._ledger.end(track.handle, MotionStatus.DONE, "")
        return refusal

    def _drop(self, track: GuardedTrack) -> None:
        """Take the joints back from a guarded motion."""
        self._guarded.drop(track)
        if track.moves_body:
            self._track.brake_what_was_placed()
            if not self._track.resting:
                self._authority.claim(track.handle.owner, self._model.joints)
                self._body_owner = track.handle.owner

    @property
    def why_closed(self) -> str | None:
        """Why nothing may start now, or None."""
        if self._latched_for:
            return self._latched_for
        return f"a stop is under way: {self._closed_for}" if self._closed_for else None


def _is_guarded(motion: object) -> bool:
    return all(hasattr(motion, part) for part in ("name", "bounds", "sample"))
