"""What a control loop tells and counts: stops, refusals, findings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from robots.clock import Clock
from robots.control.events import ControlSink, HealthChanged, SetpointRefused, StopStarted
from robots.control.gate.refusal import Refusal
from robots.control.health.finding import Finding


@dataclass(frozen=True, slots=True)
class ControlStatistics:
    """What happened since the start.

    Attributes:
        accepted: Setpoints that reached the robot.
        refused: Setpoints refused by the gate or the online checker.
        checked_trajectories: Trajectories that were streamed.
        stops: Stops that were made, in order.
    """

    accepted: int
    refused: int
    checked_trajectories: int
    stops: tuple[StopStarted, ...]


class ControlRecord:
    """Puts events into the sink, and remembers what is counted.

    Attributes:
        stops: Stops that were made, in order.
        refused_online: Setpoints that the online checker refused.
    """

    def __init__(self, clock: Clock, sink: ControlSink) -> None:
        """Begin with nothing; stamps are the clock's."""
        self._clock, self._sink = clock, sink
        self.stops: list[StopStarted] = []
        self.refused_online = 0

    def stop(self, category: int, reason: str) -> None:
        """A stop begins."""
        stop = StopStarted(self._clock.now_s(), category, reason)
        self.stops.append(stop)
        self._sink(stop)

    def refusal(self, owner: str, refusal: Refusal) -> None:
        """A setpoint was refused, and a stop of category 1 follows from it."""
        self._sink(
            SetpointRefused(
                self._clock.now_s(), owner, refusal.limit.value, refusal.joint, refusal.value, refusal.bound
            )
        )
        self.stop(1, str(refusal))

    def health(self, new: Sequence[Finding], over: Sequence[Finding]) -> None:
        """Findings count from now on, or are over."""
        now_s = self._clock.now_s()
        for finding, present in [*((one, True) for one in new), *((one, False) for one in over)]:
            self._sink(
                HealthChanged(
                    now_s,
                    finding.ailment.value,
                    finding.part,
                    finding.value,
                    finding.bound,
                    finding.response.value,
                    present,
                )
            )
