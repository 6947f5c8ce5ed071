"""Events of the control process, as values of this side: those that it may tell, and no other."""

from typing import get_args

import pytest

from executive.live.control_client.message_values import event_of
from executive.session.events import event_json
from robots.control.events import ControlEvent, SetpointRefused, StopStarted

STOPPED = StopStarted(1.5, 1, "no heartbeat")
REFUSED = SetpointRefused(1.5, "pick", "velocity", "arm_left_2_joint", 3.0, 2.0)


@pytest.mark.parametrize("event", [STOPPED, REFUSED])
def test_an_event_comes_out_as_it_went_in(event):
    assert event_of({"type": "event", **event_json(event)}) == event


@pytest.mark.requirement("F4")
@pytest.mark.parametrize("name", ["dataclass", "Callable", "__loader__", "ControlEvent", "LaterKind"])
def test_what_is_no_event_is_none_whatever_else_has_its_name(name):
    assert event_of({"type": "event", "event": name}) is None


@pytest.mark.requirement("F4")
@pytest.mark.parametrize("kind", get_args(ControlEvent), ids=lambda kind: kind.__name__)
def test_an_event_with_other_fields_than_its_own_is_none(kind):
    assert event_of({"type": "event", "event": kind.__name__, "strange": 1}) is None
