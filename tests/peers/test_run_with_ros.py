"""A run with ROS on the wire: whoever listens hears what the terminal tells."""

import subprocess
import sys
import time

import pytest

from executive.doors.ros.graph import RosNode, reliable, taken
from executive.doors.ros.messages import String
from executive.doors.ros.settings import RosSettings

pytestmark = [pytest.mark.requirement("U3"), pytest.mark.timeout(300)]
DOMAIN = 43
SENTENCE = "wait for 1 second"


def test_a_listener_hears_of_the_order_and_how_it_ended(tmp_path):
    node = RosNode(RosSettings(DOMAIN, node="listener"))
    reader = node.reader("/ai/status", String, reliable(100))
    command = [sys.executable, "-m", "executive", "run", SENTENCE, "--ros", "--ros-domain", str(DOMAIN)]
    with subprocess.Popen(
        [*command, "--record", str(tmp_path)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as run:
        heard = []
        while run.poll() is None:
            heard += [one.data for one in taken(reader)]
            time.sleep(0.05)
        told = run.stdout.read().strip()

    assert run.returncode == 0
    assert told.startswith("done: ")
    assert any("accepted" in line for line in heard)
    assert [line for line in heard if line.startswith("done: ")] == [told]
