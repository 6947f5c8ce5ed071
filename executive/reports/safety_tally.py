"""What the gate refused and what was stopped while something was carried out, counted from the events."""

from __future__ import annotations

from dataclasses import dataclass

from executive.reports.report import SafetyCounts
from executive.session.events import Event
from robots.control.events import SetpointRefused, StopStarted


@dataclass(slots=True)
class SafetyTally:
    """Counts on; a report takes what it has come to.

    Attributes:
        refused: Setpoints that the gate or the online checker refused.
        stops: Why a stop profile took over, each time.
    """

    refused: int = 0
    stops: tuple[str, ...] = ()

    def add(self, event: Event) -> None:
        """Take one more event in."""
        if isinstance(event, SetpointRefused):
            self.refused += 1
        elif isinstance(event, StopStarted):
            self.stops = (*self.stops, event.reason)

    def counts(self, checked: int) -> SafetyCounts:
        """For the report, beside so many trajectories that the checker let pass."""
        return SafetyCounts(checked, self.refused, self.stops)
