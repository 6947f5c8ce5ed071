"""One control period after the other: sensors, motions, balance, gate, robot."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType

import numpy as np

from kinematics.estimation.base_estimate import base_estimate
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from robots.clock import ManualClock
from robots.control.balance.balance import Balance
from robots.control.balance.contact_watch import ContactWatch
from robots.control.balance.felt_feet import with_felt_feet
from robots.control.balance.sway_damping import SwayDamping
from robots.control.events import ControlSink, MotionPaused, MotionResumed
from robots.control.gate.authority import Authority
from robots.control.gate.proposal import Proposal
from robots.control.gate.refusal import Refusal
from robots.control.gate.setpoint_gate import SetpointGate
from robots.control.grip.grip_keeper import GripKeeper
from robots.control.hands.gripper_control import GripperControl
from robots.control.hands.jogging import JoggingControl
from robots.control.hands.yielding import YieldingControl
from robots.control.health.finding import Response
from robots.control.health.health_monitor import HealthMonitor
from robots.control.loop.control_record import ControlRecord, ControlStatistics
from robots.control.loop.emergency_stop import EmergencyStop, PersonsReset, require_category
from robots.control.loop.resting_start import resting_start
from robots.control.loop.safeguards import Safeguards
from robots.control.loop.state_history import StateHistory
from robots.control.motion_handle import MotionStatus
from robots.control.period import PERIOD_S
from robots.control.streaming.motion_streamer import MotionStreamer
from robots.control.walking.walker import Walker
from robots.interface.hardware import RobotData
from robots.interface.robot import JointSetpoint, Robot, RobotState
from robots.interface.sensed_state import SensedState

_FORGIVEN_PERIODS = 75
"""For so long after a period without a decision (0.15 s) efforts are no sign of contact: a moving joint
came to rest, and gathers speed again."""


class ControlLoop:
    """The control loop of one robot; one call of ``step`` is one control period, whoever calls it.

    Attributes:
        model: The robot's.
        motion: Starts and cancels motions.
        walking: Starts and cancels walks.
        yielding: Starts hands that yield to what they hold.
        jogging: Starts what a person jogs.
        sensing: What the robot knows about itself.
        grippers: One control for each hand.
    """

    def __init__(
        self,
        robot: Robot,
        model: RobotModel,
        clock: ManualClock,
        sink: ControlSink,
        period_s: float = PERIOD_S,
    ) -> None:
        """Take over a robot that stands at rest.

        Args:
            robot: The body.
            model: Its model.
            clock: Time; ``step`` advances it.
            sink: Where events go.
            period_s: Control period.
        """
        self._robot, self._model = with_felt_feet(robot, model), model
        self._clock, self._sink, self._period_s = clock, sink, period_s
        self._bodies = len(model.joints)
        readings, hardware = robot.read(), robot.hardware
        data = RobotData(model.description, hardware)
        q, fingers = resting_start(model, readings.q)
        standing = StandingRobot.of(model, stance_at(model, q))
        authority = Authority(model.description.actuated)
        keepers = {hand: GripKeeper(data, hand, start_rad, period_s) for hand, start_rad in fingers.items()}
        actuated = np.concatenate([q[7:], *(keeper.joints_at for keeper in keepers.values())])
        self._balance = Balance(standing)
        self._sway = SwayDamping(data, period_s)
        self._estimator = base_estimate(standing)
        self._contact = ContactWatch(model, hardware.contact_effort_nm)
        self._gate = SetpointGate(robot, authority, clock, period_s, actuated)
        self._streamer = MotionStreamer(standing, q, keepers, authority, clock, sink, period_s)
        self._keepers = tuple(keepers.values())
        self._tau = np.zeros(len(actuated))
        self._record = ControlRecord(clock, sink)
        self._stuck = False
        self._limp = False
        self._walker = Walker(model, hardware, self._streamer, authority, clock, sink, period_s)
        self._forgiven = 0
        health = HealthMonitor(model, hardware, period_s)
        self._safeguards = Safeguards(health, self._streamer, self._record, clock, sink, self._robot)
        groups = model.description.groups
        self._legs = frozenset((*groups["left_leg"], *groups["right_leg"]))
        self.model = model
        self.motion = self._streamer
        self.walking = self._walker
        self.jogging = JoggingControl(model, self._streamer, hardware)
        self.yielding = YieldingControl(model, hardware.grips, self._streamer)
        self.sensing = StateHistory(self._sense(), period_s)
        self.grippers: Mapping[Hand, GripperControl] = MappingProxyType(
            {hand: GripperControl(data, hand, self._streamer) for hand in keepers}
        )

    @property
    def statistics(self) -> ControlStatistics:
        """Counts since the start."""
        return ControlStatistics(
            self._gate.accepted,
            self._gate.refused + self._record.refused_online,
            self._streamer.trajectories,
            tuple(self._record.stops),
        )

    @property
    def setpoint(self) -> JointSetpoint:
        """What the robot follows now, as the gate let it through."""
        return self._gate.last

    def step(self) -> None:
        """Run one control period: decide, command, let the period pass, and sense.

        Raises:
            Exception: A defect of the control software itself; the robot was told to stay where
                it is, and the period has passed, before it is raised.
        """
        try:
            self._command()
        except Exception as defect:
            self._gate.repeat()
            try:
                self._give_up(f"a defect of the control loop: {defect!r}")
            finally:
                self._pass_period()
            raise
        self._pass_period()

    def catch_up(self, periods: int, each: Callable[[], None] = lambda: None) -> None:
        """Let periods pass that nobody decided about: the robot goes on under the last setpoint.

        What is decided next follows on from that setpoint as if no time had passed, so however late it
        is, nothing jumps. ``each`` is called after each period.
        """
        for _ in range(periods):
            if not self._limp:
                self._look_after_health()  # the sensors went on, and what is summed up must not have gaps
            self._pass_period()
            each()
        if periods > 0:
            self._gate.go_on(self._period_s)
            self._forgiven = _FORGIVEN_PERIODS

    def stop(self, category: int, reason: str) -> None:
        """End all motions and bring the robot to rest; it goes on standing, grips go on pressing.

        Args:
            category: 1 brakes along the path, 2 brings every joint to rest at once, 0 takes the
                power away: the robot sinks down, and nothing but a new control loop moves it again.
            reason: For people, and for the handles of the motions that end.

        Raises:
            ValueError: There is no such category.
        """
        require_category(category)
        self._record.stop(category, reason)
        self._streamer.stop(reason, along_path=category == 1)
        self._walker.stop(reason)
        if category == 0:
            self._limp = True
            self._walker.abandon()
            self._safeguards.lose_power(reason)

    def pause(self, reason: str) -> None:
        """Brake, and hold until ``resume``; what is under way stays under way, and balance goes on.

        Arms brake along their path, a walk makes its last steps, fingers finish their way. A stop ends the
        pause, and with it what was paused. The reason is for people.
        """
        if not self.paused:
            self._sink(MotionPaused(self._clock.now_s(), reason))
            self._streamer.pause()
            self._walker.pause()

    def resume(self) -> None:
        """Go on with what was paused."""
        if self.paused:
            self._sink(MotionResumed(self._clock.now_s()))
            self._streamer.resume()
            self._walker.resume()

    @property
    def paused(self) -> bool:
        """Whether motions wait for ``resume``."""
        return self._streamer.paused

    @property
    def emergency(self) -> EmergencyStop | None:
        """The emergency stop that is engaged, or None."""
        return self._safeguards.engaged

    @property
    def still(self) -> bool:
        """Whether nothing is commanded to move, fingers included."""
        return self._streamer.still and not self._walker.active

    @property
    def defects(self) -> tuple[str, ...]:
        """What is wrong with the robot now, so that it must not move, for people."""
        return self._safeguards.defects

    @property
    def reservations(self) -> tuple[str, ...]:
        """What is wrong so that no new task should be begun, for people."""
        return self._safeguards.reservations

    def note_late(self, late_s: float) -> None:
        """Tell by how much the coming period begins too late, s; never in lockstep."""
        self._safeguards.note_late(late_s)

    def emergency_stop(self, reason: str, category: int = 1) -> None:
        """Stop, and refuse every motion with the reason until a person's ``reset``.

        Engaging it again changes nothing, but for category 0, which is severer than the others.

        Args:
            reason: For people.
            category: As for ``stop``.

        Raises:
            ValueError: There is no such category.
        """
        if self._safeguards.engage(category, reason):
            self.stop(category, reason)

    def reset(self, request: PersonsReset) -> str | None:
        """Leave the emergency stop, or say why not; nothing moves by itself afterwards.

        A person who resets has looked at the robot: joints that were stuck and encoders that slipped
        count as mended until they show again; what can be measured at rest has to be well.

        Args:
            request: The person's.

        Returns:
            None when motions are taken again; else what stands against it.
        """
        return self._safeguards.reset(request, self.still)

    def _command(self) -> None:
        state = self.sensing.state().readings
        if alarm := self._safeguards.alarm(state):
            self.emergency_stop(alarm)
        if not self._limp:
            for keeper in self._keepers:
                keeper.sense(state)
            self._sway.sense(state.v, self._gate.last.v)
            self._look_after_health()
        if self._limp:
            self._gate.go_limp(state.q, state.v)
            return
        self._forgiven = max(0, self._forgiven - 1)
        self._watch_for_contact(state)
        self._walker.go_on()
        if self._walker.active:
            self._command_walk(state)
            return
        proposal = self._streamer.propose(state)
        refusal = self._submit(proposal)
        if refusal is None:
            self._streamer.commit()
            self._stuck = False
            return
        self._tell(proposal.owner, refusal)
        for along_path in (True, False):
            self._streamer.revert()
            self._streamer.stop(str(refusal), along_path, MotionStatus.REFUSED)
            if self._submit(self._streamer.propose(state)) is None:
                self._streamer.commit()
                return
        self._streamer.revert()
        self._gate.repeat()
        self._streamer.halt()
        self._stuck = True

    def _command_walk(self, state: RobotState) -> None:
        """The same while the feet move: standing still on one leg is no way out, so the walk goes on."""
        self._gate.expect_steps(True)
        self._sway.forget()
        proposal = self._walker.propose(self._streamer.propose(state))
        refusal = self._submit(proposal)
        if refusal is None:
            self._streamer.commit()
            self._end_walk()
            self._stuck = False
            return
        self._tell(proposal.owner, refusal)
        self._stuck = True
        self._streamer.revert()
        self._streamer.stop(str(refusal), along_path=False, status=MotionStatus.REFUSED)
        self._walker.stop(str(refusal), MotionStatus.REFUSED)
        self._gate.repeat()
        self._walker.rejoin(self._gate.last.q)

    def _end_walk(self) -> None:
        """Stand where a walk has ended: nothing moves, but feet and base are elsewhere."""
        ended = self._walker.commit()
        if ended is None:
            return
        stance, q = ended
        self._gate.expect_steps(False)
        standing = StandingRobot.of(self._model, stance)
        self._streamer.stand(standing, q)
        self._balance = Balance(standing)
        self._estimator = base_estimate(standing)

    def _watch_for_contact(self, state: RobotState) -> None:
        """When the body pushes against something, end what moves the robot: a walk within two steps."""
        walks = self._walker.under_way
        watched = (self._streamer.carrying_out or walks) and self._forgiven == 0
        if self._forgiven == 0:
            self.jogging.feel(state.effort, self._gate.last.tau)
        self._contact.bear(self._streamer.unweighed, self._streamer.reference)
        contact = self._contact.judge(state.effort, self._gate.last.tau, watched, self._walker.active)
        contact = contact or self._walker.held_back
        if contact is None:
            return
        self._record.stop(1 if walks else 2, str(contact))
        self._streamer.interrupt(str(contact))
        self._walker.stop(str(contact), MotionStatus.REFUSED)

    def _look_after_health(self) -> None:
        finding = self._safeguards.look(self.sensing.state(), self._gate.last, self._walker.active)
        if finding is not None and finding.response is Response.LIMP:
            self.emergency_stop(str(finding), category=0)
        elif finding is not None:
            easing = finding.part if finding.weakens(self._legs) else None
            self._record.stop(1, str(finding))
            self._streamer.stop(str(finding), along_path=True, easing=easing)
            self._walker.stop(str(finding))

    def _give_up(self, reason: str) -> None:
        """End all motions where the robot is; it was told already to stay there."""
        self._record.stop(2, reason)
        self._streamer.stop(reason, along_path=False, status=MotionStatus.REFUSED)
        self._streamer.revert()
        self._streamer.halt()
        self._walker.stop(reason, MotionStatus.REFUSED)
        self._walker.rejoin(self._gate.last.q)

    def _submit(self, proposal: Proposal) -> Refusal | None:
        if proposal.refusal is not None:
            self._record.refused_online += 1
            return proposal.refusal
        tau = self._tau.copy()
        efforts = proposal.efforts
        if efforts is None:
            self._balance.carry(self._streamer.loads)
            tau[: self._bodies] = self._balance.efforts(proposal.body)
            self._sway.add_to(tau)
        else:
            tau[: self._bodies] = efforts
        sequence = self._gate.last.sequence + 1
        now_s = self._clock.now_s()
        return self._gate.submit(JointSetpoint(now_s, sequence, proposal.owner, proposal.q, proposal.v, tau))

    def _tell(self, owner: str, refusal: Refusal) -> None:
        """Report a refusal and the stop that follows; once, while the same state lasts."""
        if self._stuck:
            return
        self._record.refusal(owner, refusal)

    def _pass_period(self) -> None:
        self._robot.advance(self._period_s)
        self._clock.advance(self._period_s)
        self.sensing.add(self._sense())

    def _sense(self) -> SensedState:
        told, estimator = self._robot.read(), self._estimator
        if self._walker.active:
            return self._walker.sense(told)
        self._walker.stand_by(told)
        joints_rad, foot_wrench = told.q[: self._bodies], told.foot_wrench
        estimator.update(told.stamp_s, joints_rad, told.gyro, told.accelerometer, foot_wrench)
        configured = partial(estimator.configuration, joints_rad, foot_wrench, estimator.tilt_rad)
        return SensedState(told, configured)
