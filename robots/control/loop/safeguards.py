"""Whether motions are taken at all: the emergency stop's latch, and the robot's health."""

from __future__ import annotations

from robots.clock import Clock
from robots.control.events import ControlSink, EmergencyReset, EmergencyStopped, ResetRefused
from robots.control.health.finding import Finding, Response
from robots.control.health.health_monitor import HealthMonitor
from robots.control.loop.control_record import ControlRecord
from robots.control.loop.emergency_stop import EmergencyLatch, EmergencyStop, PersonsReset
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.interface.robot import JointSetpoint, Robot, RobotState, reset_body
from robots.interface.sensed_state import SensedState


class Safeguards:
    """Latches the streamer while the emergency stop is engaged or the robot is not well.

    It says when the robot is to be stopped; stopping it is the control loop's part.
    """

    def __init__(
        self,
        health: HealthMonitor,
        streamer: MotionStreamer,
        record: ControlRecord,
        clock: Clock,
        sink: ControlSink,
        robot: Robot,
    ) -> None:
        """Take motions, until something stands against it.

        Args:
            health: Finds what is wrong with the robot.
            streamer: What refuses motions while it is latched.
            record: Where findings go.
            clock: For stamps.
            sink: Where other events go.
            robot: The body, which may have something to be reset itself.
        """
        self._health = health
        self._streamer = streamer
        self._record = record
        self._clock, self._sink = clock, sink
        self._latch = EmergencyLatch()
        self._powerless = False
        self._robot, self._told_before = robot, False

    @property
    def engaged(self) -> EmergencyStop | None:
        """The emergency stop that is engaged, or None."""
        return self._latch.engaged

    @property
    def defects(self) -> tuple[str, ...]:
        """What is wrong with the robot now, so that it must not move, for people."""
        return self._health.reasons(Response.STOP)

    @property
    def reservations(self) -> tuple[str, ...]:
        """What is wrong so that no new task should be begun, for people."""
        return self._health.reasons(Response.REFUSE)

    def note_late(self, late_s: float) -> None:
        """Tell by how much the coming period begins too late, s; never in lockstep."""
        self._health.note_late(late_s)

    def engage(self, category: int, reason: str) -> bool:
        """Engage the emergency stop; tell whether the robot is to be stopped now.

        Raises:
            ValueError: There is no such category.
        """
        now_s = self._clock.now_s()
        if not self._latch.engage(now_s, category, reason):
            return False
        self._close_or_open()
        self._sink(EmergencyStopped(now_s, category, reason))
        return True

    def reset(self, request: PersonsReset, still: bool) -> str | None:
        """Leave the emergency stop, or say why not.

        Args:
            request: The person's.
            still: Whether nothing is commanded to move.

        Returns:
            None when motions are taken again; else what stands against it.
        """
        if still:
            self._record.health([], self._health.acknowledge())
            self._close_or_open()
        reason = self._latch.why_not_open(still, self.defects) or reset_body(self._robot)
        if reason is not None:
            self._sink(ResetRefused(self._clock.now_s(), request.person, reason))
            return reason
        self._latch.open()
        self._told_before = True
        self._close_or_open()
        self._sink(EmergencyReset(self._clock.now_s(), request.person))
        return None

    def alarm(self, state: RobotState) -> str:
        """Why the body asks for its emergency stop, or nothing; asked once a control period.

        Args:
            state: What was sensed; those of the period in which a person reset speak of the time before.
        """
        before, self._told_before = self._told_before, False
        return "" if before else state.alarm

    def look(self, state: SensedState, setpoint: JointSetpoint, walking: bool) -> Finding | None:
        """Judge the robot's health once a control period.

        Args:
            state: What was sensed.
            setpoint: What the robot was told.
            walking: Whether its feet move.

        Returns:
            What it is to be stopped for, when something new is wrong with it; else None.
        """
        streamer = self._streamer
        standing = streamer.standing and not walking
        new, over = self._health.judge(state, setpoint, standing, streamer.in_contact, walking)
        if not new and not over:
            return None
        self._record.health(new, over)
        self._close_or_open()
        grave = [finding for finding in new if finding.response is not Response.REFUSE]
        return max(grave, key=lambda finding: finding.response is Response.LIMP, default=None)

    def lose_power(self, reason: str) -> None:
        """Refuse motions for good."""
        self._powerless = True
        self._streamer.latch(f"the power was taken away: {reason}")

    def _close_or_open(self) -> None:
        if self._powerless:
            return
        reason = str(self._latch.engaged) if self._latch.engaged is not None else "; ".join(self.defects)
        if reason:
            self._streamer.latch(reason)
        else:
            self._streamer.unlatch()
