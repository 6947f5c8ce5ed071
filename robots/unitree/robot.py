"""The body on the other side of the wire as ``robots.interface.robot.Robot``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Protocol

import numpy as np

from kinematics.model.robot_description import Hand, RobotDescription
from robots.errors import DescriptionError, RobotsError, SetpointRefusedError
from robots.interface.hardware import Hardware, RobotData
from robots.interface.robot import JointSetpoint, RobotState
from robots.unitree.commands import TAKE_UP_S, LowCommands
from robots.unitree.hands import WiredHand
from robots.unitree.layout import STATES, Record, hand_states
from robots.unitree.motors import motors_of
from robots.unitree.readings import STOP, pressed, readings_of
from robots.unitree.watch import FOLLOWS, LATE_S, Consequence, Wire, WireFinding, WireWatch, by_gravity


class SilentRobotError(RobotsError):
    """No state came over the wire in the time that was waited."""


class Time(Protocol):
    """Seconds from outside."""

    def now_s(self) -> float:
        """Seconds since the clock's own start."""
        ...


class UnitreeRobot:
    """A robot that is somewhere else: time passes by itself, and each period a state comes or does not.

    Setpoints go out with the servos' gains, unfolded: the motors put effort, position and speed together.
    When the wire fails, what goes out is what ``robots.unitree.watch`` declares; afterwards the motors are
    taken up where they are.

    Attributes:
        sent: How many commands were sent.
    """

    def __init__(
        self,
        data: RobotData,
        wire: Wire,
        clock: Time,
        hands: Mapping[Hand, Wire],
        *,
        arms_only: bool = False,
        first_within_s: float = 5.0,
        take_up_s: float = TAKE_UP_S,
    ) -> None:
        """Wait for the first state.

        Args:
            data: The robot's.
            wire: Carries the messages.
            clock: Tells the time.
            hands: Carry the messages of each hand that the robot has.
            arms_only: Command arms and waist by ``arm_sdk``; the maker's own balance keeps the legs.
            first_within_s: For so long the first state is waited for.
            take_up_s: For so long motors are taken up.

        Raises:
            SilentRobotError: None came.
            DescriptionError: A joint has no motor on this wire, or a hand has no wire.
        """
        names = data.description.joints
        self._data, self._wire, self._clock = data, wire, clock
        self._motors = motors_of(names)
        self._watch = WireWatch(self._motors, names, clock.now_s())
        gains = [data.hardware.gains[name] for name in names]
        self._commands = LowCommands(
            self._motors,
            np.array([gain.stiffness for gain in gains]),
            np.array([gain.damping for gain in gains]),
            arms_only=arms_only,
            take_up_s=take_up_s,
        )
        grippers = data.description.grippers
        if missing := [hand for hand in grippers if hand not in hands]:
            raise DescriptionError(f"the {missing[0]} hand has no wire")
        self._hands = {
            hand: WiredHand(data, hand, hands[hand], clock.now_s(), take_up_s) for hand in grippers
        }
        self._count = len(data.description.actuated)
        self._findings: tuple[WireFinding, ...] = ()
        self.sent = 0
        self._wait_for_all(first_within_s)
        self._reading = self._read()

    @property
    def description(self) -> RobotDescription:
        """The robot's data."""
        return self._data.description

    @property
    def hardware(self) -> Hardware:
        """What it is made of."""
        return self._data.hardware

    @property
    def findings(self) -> tuple[WireFinding, ...]:
        """What was wrong with the wire when it was last looked at, the gravest last."""
        return self._findings

    @property
    def taken_up(self) -> bool:
        """Whether all motors follow with all their stiffness."""
        shares = [self._commands.share, *(hand.share for hand in self._hands.values())]
        return min(shares) == 1.0

    def read(self) -> RobotState:
        """Return the readings of the last control period, with their age."""
        return self._reading

    def command(self, setpoint: JointSetpoint) -> None:
        """Send a setpoint, or what the wire's failures ask for in its place.

        Raises:
            SetpointRefusedError: A wrong shape or a value that is not finite: a defect upstream. Nothing is
                sent.
        """
        n, bodies = self._count, len(self._motors)
        for values in (setpoint.q, setpoint.v, setpoint.tau):
            if len(values) != n or not np.isfinite(values).all():
                raise SetpointRefusedError(f"setpoint {setpoint.sequence} is not {n} finite numbers")
        measured, machine, damped = self._reading.q[:bodies], self._watch.machine, self._damped()
        if damped:
            message = self._commands.damp(measured, machine)
        else:
            message = self._commands.follow(setpoint, measured, self._period_s, machine)
        self._wire.send(message)
        for hand in self._hands.values():
            if damped:
                hand.damp()
            else:
                hand.follow(setpoint, self._clock.now_s(), self._period_s)
        self.sent += 1

    def advance(self, period_s: float) -> None:
        """Wait for the next state, for a period at most: time passes by itself."""
        self._period_s = period_s
        self._wire.wait(period_s)
        self._hear()
        self._reading = self._read()

    def reset(self) -> str | None:
        """A person has looked: forget a wire that was lost, or say why not."""
        now_s = self._clock.now_s()
        hands = [one for one in self._of_hands(now_s) if FOLLOWS[one.trouble] is not Consequence.NONE]
        refused = str(hands[-1]) if hands else self._watch.reset(now_s)
        self._reading = self._read()
        return refused

    _period_s = 0.002

    def _damped(self) -> bool:
        grave = (Consequence.DAMP, Consequence.DAMP_UNTIL_RESET)
        return any(FOLLOWS[one.trouble] in grave for one in self._findings)

    def _wait_for_all(self, within_s: float) -> None:
        """Wait for the first state of the body and of each hand."""
        begun_s = self._clock.now_s()
        while unheard := self._unheard():
            left_s = begun_s + within_s - self._clock.now_s()
            if left_s <= 0.0:
                raise SilentRobotError(
                    f"no state on {unheard} within {within_s:g} s ({self._watch.garbled} with a "
                    "wrong check sum); is the robot on, and is this its network interface?"
                )
            self._wire.wait(min(left_s, self._period_s) if self._watch.state is not None else left_s)
            self._hear()

    def _unheard(self) -> str:
        """The first topic on which nothing has come yet; empty when all are heard."""
        if self._watch.state is None:
            return STATES
        return next((hand_states(name) for name, hand in self._hands.items() if not hand.heard), "")

    def _of_hands(self, now_s: float) -> list[WireFinding]:
        """What is wrong with the hands; where the body says nothing either, the wire is what is silent."""
        heard = self._watch.age_s(now_s) <= LATE_S
        return [one for hand in self._hands.values() for one in hand.findings(now_s, heard)]

    def _found(self, now_s: float) -> tuple[WireFinding, ...]:
        return by_gravity([*self._watch.findings(now_s), *self._of_hands(now_s)])

    def _hear(self) -> None:
        now_s = self._clock.now_s()
        for message in self._wire.received():
            self._watch.hear(message, now_s)
        for hand in self._hands.values():
            hand.hear(now_s)
        self._findings = self._found(now_s)

    def _read(self) -> RobotState:
        state, now_s = self._watch.state, self._clock.now_s()
        self._findings = self._found(now_s)
        if state is None:
            raise SilentRobotError("no state has come yet")
        body = readings_of(state, self._motors, now_s, self._watch.age_s(now_s))
        told = (body.q, body.v, body.effort, body.temperature_c, body.motor_error)
        every = np.zeros((len(told), self._count))
        every[:, : len(body.q)] = told
        for hand in self._hands.values():
            every[:, hand.columns] = hand.sensed()
        q, v, effort, heat, codes = every
        alarm, following = self._alarm(state), self.taken_up
        return replace(
            body,
            q=q,
            v=v,
            effort=effort,
            temperature_c=heat,
            motor_error=codes,
            alarm=alarm,
            following=following,
        )

    def _alarm(self, state: Record) -> str:
        if pressed(state) >= STOP:
            return "the remote's stop (L2 and B)"
        grave = [one for one in self._findings if FOLLOWS[one.trouble] is not Consequence.NONE]
        return str(grave[-1]) if grave else ""
