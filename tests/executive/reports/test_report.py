"""What a report says of safety is counted from the events."""

from executive.reports.report import SafetyCounts, SafetyTally
from executive.session.events import InputTaken
from robots.control.events import EmergencyStopped, SetpointRefused, StopStarted

REFUSED = SetpointRefused(0.0, "pick", "velocity", "arm_left_2_joint", 3.0, 2.0)


def test_refused_setpoints_and_stops_are_counted_and_nothing_else():
    tally = SafetyTally()

    for event in (REFUSED, StopStarted(0.0, 1, "first"), InputTaken(0.0, "cancel", "enough"), REFUSED):
        tally.add(event)
    for event in (EmergencyStopped(0.0, 1, "a person"), StopStarted(0.0, 2, "second")):
        tally.add(event)

    assert tally.counts(5) == SafetyCounts(5, 2, ("first", "second"))
