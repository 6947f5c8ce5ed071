"""What the commander wants to see comes, though two things fall due at once."""

import json

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.fake.fake_robot import FakeRobot
from robots.fake.fake_sensing import FakeRangeSensor
from robots.interface.hardware import RobotData
from robots.live.process.bulletin import Bulletin, Wanted
from robots.live.process.motion_desk import MotionDesk
from robots.models.description import load_robot
from robots.perception.detector import PerceptionFrame

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


class Pictures:
    """A new one each so many polls."""

    def __init__(self, every):
        self.every, self.polls = every, 0

    def latest(self):
        return PerceptionFrame(0.0, self.polls // self.every, ())


class Far:
    """Another end that reads slowly: what was sent has left at some polls only."""

    def __init__(self):
        self.idle, self.heard = True, []

    def send(self, payload):
        self.idle = False
        self.heard.append(json.loads(payload)["type"])


@pytest.mark.parametrize("reads_every", [1, 7, 13])
@pytest.mark.parametrize("picture_every", [1, 17, 50])
def test_scans_come_nearly_ten_times_a_second_beside_pictures(talos, reads_every, picture_every):
    clock, pictures, far = ManualClock(), Pictures(picture_every), Far()
    loop = ControlLoop(
        FakeRobot(RobotData(talos.description, HARDWARE), clock),
        talos,
        clock,
        lambda _event: None,
        PERIOD_S,
    )
    ranging = FakeRangeSensor()
    ranging.points_m = np.ones((3, 3))
    bulletin = Bulletin(loop, clock, pictures, ranging, MotionDesk(loop))

    for poll in range(1000):
        pictures.polls += 1
        bulletin.tell(far, [], Wanted(pictures=True, scans=True))
        far.idle = far.idle or poll % reads_every == 0

    assert far.heard.count("scan") >= 15
    assert far.heard.count("frame") >= 15
