"""Walks: takes the whole body over from standing, and gives it back where it stands then."""

from __future__ import annotations

import dataclasses

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.walking_settings import UPRIGHT_RAD
from kinematics.walking.pattern.gazing import Gazing
from kinematics.walking.pattern.steering import Steering, VelocitySteering
from robots.clock import Clock
from robots.control.events import ControlSink, MotionEnded, MotionStarted
from robots.control.gate.authority import HOLD, STOP, Authority, together
from robots.control.gate.proposal import Proposal
from robots.control.gate.refusal import Limit, Refusal
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.control.walking.hand_scales import HandScales
from robots.control.walking.walk import Walk
from robots.interface.hardware import Hardware
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState

_GYRO_TIME_S = 4.0
"""What the gyro shows at rest is averaged over this."""
_STOPPING = f"{STOP} of a walk"
_OUT_OF_REACH = Refusal(Limit.REACH, "a leg, whose foot is too far away", 0.0, 0.0)


class Walker:
    """The one walk that may be under way; satisfies ``trees.toolbox.Walking``."""

    def __init__(
        self,
        model: RobotModel,
        hardware: Hardware,
        streamer: MotionStreamer,
        authority: Authority,
        clock: Clock,
        sink: ControlSink,
        period_s: float,
    ) -> None:
        """Stand; whoever moves the standing body is ``streamer``."""
        self._model, self._hardware = model, hardware
        self._streamer, self._authority = streamer, authority
        self._clock, self._sink, self._period_s = clock, sink, period_s
        self._bodies = len(model.joints)
        self._count = 0
        self._handle: MotionHandle | None = None
        self._owner = ""
        self._walk: Walk | None = None
        self._gyro_at_rest = np.zeros(3)
        self._rested = 0
        self._scales = HandScales(model, period_s)
        self._readings: RobotState | None = None
        self._steering: Steering | None = None
        self._pausing = False
        self._interrupted = self._finishing = False

    # ---------------------------------------------------------------- for those who want to walk

    def walk(self, steering: Steering, name: str) -> MotionHandle:
        """Set out from standing.

        Args:
            steering: Where to; the handle is done when it stops by itself.
            name: What it is, for people.

        Returns:
            A running handle, or a refused one with the reason.
        """
        self._count += 1
        handle = MotionHandle(name, f"walk-{self._count}")
        reason = self._why_not()
        if reason is None:
            conflict = self._authority.claim(handle.owner, self._model.joints)
            reason = None if conflict is None else f"{conflict[0]} is held by {conflict[1]}"
        if reason is None:
            self._handle, self._owner, self._steering = handle, handle.owner, steering
            self._finishing = False
            self._pausing = self._streamer.paused
            if not self._pausing:
                self._set_out(steering)
            self._sink(MotionStarted(self._clock.now_s(), handle.name, handle.owner))
            return handle
        handle.status, handle.reason = MotionStatus.REFUSED, reason
        self._sink(MotionEnded(self._clock.now_s(), handle.name, handle.owner, "refused", reason))
        return handle

    def steer(self, handle: MotionHandle, steering: Steering) -> None:
        """Go somewhere else with a walk that is under way; one that has ended is left alone."""
        if handle is self._handle:
            self._steering = steering
            if self._walk is not None and not self._interrupted:
                _steer(self._walk, steering)

    def finish(self, handle: MotionHandle) -> None:
        """Bring a walk to its end within its last steps; its handle is done when the robot stands."""
        if handle is not self._handle:
            return
        self._interrupted, self._finishing = False, True
        if self._walk is not None:
            self._walk.pattern.finish()
        elif not handle.finished:  # it stands because of a pause
            self._handle = None
            handle.progress = 1.0
            self._end(handle, MotionStatus.DONE, "")
            self._authority.release(self._owner)

    def pause(self) -> None:
        """Stand still within the last steps until ``resume``; the walk stays under way."""
        self._pausing = self._handle is not None and not self._finishing
        if self._walk is not None and self._pausing:
            self._interrupted = True
            self._walk.pattern.finish()

    def resume(self) -> None:
        """Set out again for where a pause has stopped the walk, once the robot stands."""
        self._pausing = False

    def go_on(self) -> None:
        """Between two periods: begin again what was paused, if that is over and the robot stands."""
        if (
            self._walk is None
            and self._handle is not None
            and not self._pausing
            and self._steering is not None
        ):
            self._set_out(self._steering)

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Stop a walk within its last steps; one that has ended is left alone."""
        if handle is self._handle:
            self.stop(reason)

    # ---------------------------------------------------------------- for the control loop

    @property
    def active(self) -> bool:
        """Whether it has the body."""
        return self._walk is not None

    @property
    def under_way(self) -> bool:
        """Whether somebody's walk goes on: no last steps after a stop."""
        return self._walk is not None and self._handle is not None

    @property
    def ending(self) -> bool:
        """Whether a walk that is under way was told to end: what it commands brakes from then on."""
        return self._walk is not None and (self._finishing or self._interrupted or self._handle is None)

    @property
    def landings(self) -> list[tuple[Hand, PlanarPose]]:
        """The landings that the walk under way plans next, in the odometry frame."""
        return [] if self._walk is None else self._walk.pattern.landings

    @property
    def held_back(self) -> Refusal | None:
        """What the body of a walk that is under way has met, beside the floor."""
        return self._walk.held_back if self._walk is not None and self._handle is not None else None

    def stop(self, reason: str, status: MotionStatus = MotionStatus.CANCELED) -> None:
        """Bring the feet together and come to rest, with no regard to whoever wanted the walk."""
        self._pausing = self._interrupted = False
        handle, self._handle = self._handle, None
        if self._walk is None:
            if handle is not None:  # it stood because of a pause
                self._end(handle, status, reason)
                self._authority.release(self._owner)
            return
        self._walk.pattern.finish()
        if handle is not None:
            self._end(handle, status, reason)
            self._authority.release(self._owner)
            self._authority.claim(_STOPPING, self._model.joints)
            self._owner = _STOPPING

    def abandon(self) -> None:
        """Forget the walk: the power is gone, and there are no last steps."""
        self._walk = None
        self._authority.release(self._owner)

    def rejoin(self, told_rad: Array) -> None:
        """Go on from where the joints were told to stay for a period, shape (actuated,)."""
        if self._walk is not None:
            self._walk.rejoin(told_rad[: self._bodies])

    def stand_by(self, readings: RobotState) -> None:
        """Take in what the sensors say while nobody walks: where the gyro's zero is, above all."""
        self._readings = readings
        if not self._streamer.resting:
            self._scales.moved()
            return
        self._scales.sense(readings.effort[: self._bodies])
        self._rested += 1
        share = max(1.0 / self._rested, self._period_s / _GYRO_TIME_S)
        self._gyro_at_rest += share * (readings.gyro - self._gyro_at_rest)

    def sense(self, readings: RobotState) -> SensedState:
        """What the robot knows about itself on its way."""
        if self._walk is None:
            raise RuntimeError("nobody walks")
        estimate = self._walk.sense(readings)
        return SensedState(readings, lambda: estimate)

    def propose(self, standing: Proposal) -> Proposal:
        """The next setpoint: the grippers' from those who hold them, the body's from the walk."""
        if self._walk is None:
            raise RuntimeError("nobody walks")
        found = self._walk.next()
        if found is None:
            return dataclasses.replace(standing, owner=self._owner, refusal=_OUT_OF_REACH)
        body, efforts = found
        q, v = standing.q.copy(), standing.v.copy()
        q[: self._bodies], v[: self._bodies] = self._walk.joints(body)
        owners = [self._owner] if standing.owner == HOLD else [self._owner, standing.owner]
        return Proposal(together(owners), q, v, body, standing.refusal, efforts)

    def commit(self) -> tuple[Stance, Array] | None:
        """The last proposal is what the robot follows now.

        Returns:
            Where it stands and in which configuration, when the walk has come to its end.
        """
        walk = self._walk
        if walk is None or not walk.at_rest:
            return None
        standing = walk.standing()
        self._walk = None
        if self._interrupted and self._handle is not None:
            return standing
        self._authority.release(self._owner)
        handle, self._handle = self._handle, None
        if handle is not None:
            handle.progress = 1.0
            self._end(handle, MotionStatus.DONE, "")
        return standing

    # ---------------------------------------------------------------- inside

    def _set_out(self, steering: Steering) -> None:
        self._interrupted = False
        model = self._model.carrying(self._scales.masses_kg(self._streamer.reference()))
        quick = isinstance(steering, VelocitySteering) and steering.quick
        self._walk = Walk(model, self._hardware, self._streamer, self._gyro_at_rest, self._period_s, quick)
        if self._readings is not None:
            self._walk.sense(self._readings)
        _steer(self._walk, steering)

    def _why_not(self) -> str | None:
        if self._model.description.walking is None:
            return f"{self._model.description.name} is not known to walk"
        if self._walk is not None or self._handle is not None:
            return "it walks already"
        if (closed := self._streamer.why_closed) is not None:
            return closed
        if not self._streamer.resting:
            return "the body is moving"
        lean = poses.rotation_from_quaternion(self._streamer.reference()[3:7])[2, 2]
        if lean < np.cos(UPRIGHT_RAD):
            return f"the pelvis leans by {float(np.degrees(np.arccos(lean))):.1f} degrees; go home first"
        return None

    def _end(self, handle: MotionHandle, status: MotionStatus, reason: str) -> None:
        handle.status, handle.reason = status, reason
        self._sink(MotionEnded(self._clock.now_s(), handle.name, handle.owner, status.value, reason))


def _steer(walk: Walk, steering: Steering) -> None:
    """Tell the feet where to go, and the head where to look if that is said."""
    if isinstance(steering, Gazing):
        walk.head.look(steering.pan_rad, steering.tilt_rad)
        steering = steering.steering
    walk.pattern.steer(steering)
