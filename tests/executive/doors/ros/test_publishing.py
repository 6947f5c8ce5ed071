"""What is told to ROS of a robot whose feet have no sensors."""

import pytest

from executive.doors.ros.messages import Time
from executive.doors.ros.publishing import ESTIMATED, diagnostics
from robots.models.description import load_description


@pytest.mark.parametrize(("robot", "told"), [("talos", ["measured"]), ("g1", [ESTIMATED]), ("panda", [])])
def test_diagnostics_tell_whether_foot_wrenches_are_measured(robot, told):
    parts = diagnostics({}, load_description(robot), Time(0, 0)).status

    assert [part.message for part in parts if part.name == "foot wrenches"] == told
