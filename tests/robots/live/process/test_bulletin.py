"""What the commander wants to see comes, though two things fall due at once."""

import json

import numpy as np
import pytest

from kinematics.geometry import poses
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.fake.fake_robot import FakeRobot
from robots.fake.fake_sensing import FakeRangeSensor
from robots.live.documents.camera_message import cameras_json, cameras_of
from robots.live.process.bulletin import Bulletin, Wanted
from robots.live.process.motion_desk import MotionDesk
from robots.live.wire.errors import ProtocolError
from robots.models.description import load_robot
from robots.perception.detector import PerceptionFrame
from robots.perception.fusion.cameras import PlacedCamera

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
        self.idle, self.heard, self.sources = True, [], []

    def send(self, payload):
        self.idle = False
        message = json.loads(payload)
        self.heard.append(message["type"])
        self.sources.append(message.get("source"))


def loop_of(talos, clock):
    body = FakeRobot(talos, HARDWARE, clock)
    return ControlLoop(body, talos, clock, lambda _event: None, PERIOD_S)


@pytest.mark.parametrize("reads_every", [1, 7, 13])
@pytest.mark.parametrize("picture_every", [1, 17, 50])
def test_scans_come_nearly_ten_times_a_second_beside_pictures(talos, reads_every, picture_every):
    clock, pictures, far = ManualClock(), Pictures(picture_every), Far()
    loop = loop_of(talos, clock)
    ranging = FakeRangeSensor()
    ranging.points_m = np.ones((3, 3))
    bulletin = Bulletin(loop, clock, pictures, ranging, MotionDesk(loop))

    for poll in range(1000):
        pictures.polls += 1
        bulletin.tell(far, [], Wanted(pictures=True, scans=True))
        far.idle = far.idle or poll % reads_every == 0

    assert far.heard.count("scan") >= 15
    assert far.heard.count("frame") >= 15


@pytest.mark.requirement("P3")
@pytest.mark.parametrize("picture_every", [1, 17])
def test_frames_of_two_cameras_come_in_turn_each_with_its_name(talos, picture_every):
    clock, own, room, far = ManualClock(), Pictures(picture_every), Pictures(picture_every), Far()
    loop = loop_of(talos, clock)
    camera = PlacedCamera("room camera", room, np.eye(4))
    bulletin = Bulletin(loop, clock, own, None, MotionDesk(loop), (camera,))

    for poll in range(400):
        own.polls += 1
        room.polls += 1
        bulletin.tell(far, [], Wanted(pictures=True, scans=False))
        far.idle = far.idle or poll % 7 == 0

    told = [source for source in far.sources if source is not None]
    assert abs(told.count("head camera") - told.count("room camera")) <= 1
    assert told.count("room camera") >= 15


@pytest.mark.requirement("P3")
def test_a_camera_of_the_room_is_told_of_and_read_back():
    camera = PlacedCamera("room camera", None, poses.translation(1.0, 0.5, 2.0), (1.2, 0.9), (0.4, 6.0))

    (back,) = cameras_of(json.loads(json.dumps(cameras_json([camera]))), lambda name: name)

    assert (back.name, back.detector) == ("room camera", "room camera")
    assert (back.field_of_view_rad, back.range_m) == ((1.2, 0.9), (0.4, 6.0))
    assert np.array_equal(back.odom_T_camera, camera.odom_T_camera)


def test_a_camera_that_is_none_is_refused():
    with pytest.raises(ProtocolError, match="camera"):
        cameras_of([{"name": "room camera"}], lambda name: name)
