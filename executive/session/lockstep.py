"""Simulated time passes a tick at a time: control periods, and what runs beside them."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from typing import Protocol

from executive.session.events import EventSink, InputTaken, SensorsNoted
from executive.session.supervisor import Supervisor
from robots.clock import Clock
from robots.control.period import PERIOD_S
from trees.toolbox import Sensing

PERIODS_A_TICK = 10
"""Control periods from one tick of the tree to the next: 20 ms."""

SETTLE_TICKS = 10
"""Ticks before the first task: the body finds its weight, the sensors have something to say."""

NOTED_EVERY_TICKS = 25
"""Ticks from one noted hash of the sensors to the next: 0.5 s."""


class Periods(Protocol):
    """What lets one control period pass: the control loop."""

    @property
    def sensing(self) -> Sensing:
        """What the robot knows about itself."""
        ...

    def step(self) -> None:
        """Let one control period pass."""
        ...


class Lockstep:
    """Lets simulated time pass in whole ticks, and has everything beside the loop called each period.

    Args:
        loop: Steps the robot.
        clock: Simulated time.
        sink: Takes hashes of what was sensed, and stops that were asked for.
        beside: Called after each control period, in this order.
        supervisor: Told before each control period; without one, nobody is.
    """

    def __init__(
        self,
        loop: Periods,
        clock: Clock,
        sink: EventSink,
        beside: Sequence[Callable[[], None]],
        supervisor: Supervisor | None,
    ) -> None:
        self._loop, self._clock, self._sink = loop, clock, sink
        self._beside = list(beside)
        self._supervisor = supervisor
        self._ticks = 0
        self._settled = False
        self._stops_asked: list[str] = []

    def watch(self, call: Callable[[], None]) -> None:
        """Have something called after each control period."""
        self._beside.append(call)

    def note_stop(self, words: str) -> None:
        """Tell of a stop that was asked for, in the period before which it takes effect."""
        self._stops_asked.append(words)

    def settle(self) -> None:
        """Before the first task, let the robot come to rest; does nothing later."""
        if not self._settled:
            self.tick(SETTLE_TICKS)
            self._settled = True

    def let_pass(self, seconds: float) -> None:
        """Let simulated time pass, in whole ticks."""
        self.tick(round(seconds / (PERIOD_S * PERIODS_A_TICK)))

    def tick(self, count: int = 1) -> None:
        """Let one tick pass, or several."""
        for _ in range(count):
            for _ in range(PERIODS_A_TICK):
                self._period()
            self._ticks += 1
            if self._ticks % NOTED_EVERY_TICKS == 0:
                self._sink(SensorsNoted(self._clock.now_s(), self._sensors_sha256()))

    def _period(self) -> None:
        if self._supervisor is not None:
            asked, self._stops_asked = self._stops_asked, []
            for words in asked:
                self._sink(InputTaken(self._clock.now_s(), "emergency_stop", words))
            self._supervisor.before_period()
        self._loop.step()
        for call in self._beside:
            call()

    def _sensors_sha256(self) -> str:
        state = self._loop.sensing.state()
        readings = state.readings
        digest = hashlib.sha256()
        for array in (state.q, readings.q, readings.v, readings.effort, readings.foot_wrench):
            digest.update(array.tobytes())
        return digest.hexdigest()
