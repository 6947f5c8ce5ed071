"""A robot that sees a simulated table with its own camera."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.clock import ManualClock
from robots.errors import DescriptionError, RenderingUnavailableError
from robots.models.description import load_robot
from robots.perception.rgbd.eyes import Eyes
from robots.perception.rgbd.picture_slot import PictureSlotReader
from robots.scenes.scene_file import load_scene
from robots.simulated.camera import camera_perception
from robots.simulated.camera.camera_perception import CameraPerception, require_camera
from robots.simulated.camera.feed import Believed
from robots.simulated.camera.orders import LensFaults, Setup
from robots.simulated.camera.process import CameraProcess
from robots.simulated.world import build_world

FRAME = "rgbd_rgb_optical_frame"


class Stage:
    """A robot that stands still before a scene, and its camera."""

    def __init__(self, seed=3, scene="tabletop", slot=None, beside=()):
        """``beside``: cameras that stand in the room, of another scene."""
        robot, scene = load_robot("talos"), load_scene(scene)
        home = {**robot.description.home, "head_1_joint": 0.7, "torso_2_joint": 0.2}
        robot = replace(robot, description=replace(robot.description, home=home))
        self.world = build_world(robot, scene, np.random.default_rng(0))
        self.clock, model = ManualClock(), RobotModel(robot.description)
        pose = model.frame_pose(model.on_the_floor(home), FRAME)
        state = self.world.robot.read()
        self.believed = lambda: Believed(pose, state.q)
        self.eyes = CameraPerception(
            self.world.physics,
            robot,
            replace(scene, cameras=(*scene.cameras, *beside)),
            self.clock,
            np.random.default_rng(seed),
            self.believed,
            slot=slot,
        )

    def frames(self, count, eye=None):
        told, eye = {}, eye or self.eyes
        while len(told) < count:
            frame = eye.latest()
            if frame is not None:
                told[frame.sequence] = frame
            self.eyes.tick()
            self.clock.advance(0.002)
        return list(told.values())


class InThisProcess:
    """The camera's process without a process."""

    def __init__(self):
        self._replies, self._process = [], None

    def send(self, asked):
        if isinstance(asked, Setup):
            self._process = CameraProcess(asked)
            self._replies.append(self._process.labels)
        else:
            self._replies.append(self._process.answer(asked))

    def recv(self):
        return self._replies.pop(0)

    def poll(self, _timeout_s):
        return bool(self._replies)


@pytest.fixture(scope="module")
def stage():
    return Stage()


@pytest.fixture(scope="module")
def first_two():
    """What a robot alone with its camera is shown first."""
    stage = Stage()
    assert not stage.eyes.cameras
    return stage.frames(2)


@pytest.mark.opengl
@pytest.mark.requirement("P2")
def test_the_camera_shows_the_cup_where_it_is(stage):
    (frame,) = stage.frames(1)

    (cup,) = [seen for seen in frame.detections if (seen.color, seen.kind) == ("red", "cup")]
    truth = stage.world.truth
    camera_T_cup = np.linalg.inv(truth.world_T_camera()) @ truth.world_T_object("red cup")
    assert np.linalg.norm(cup.camera_T_object[:3, 3] - camera_T_cup[:3, 3]) < 0.015
    assert any(seen.kind == "table" for seen in frame.detections)


@pytest.mark.opengl
def test_a_picture_at_which_looking_fails_is_told_and_the_next_is_looked_at(monkeypatch):
    looked = Eyes.detect

    def detect(eyes, picture, sequence):
        if sequence == 0:
            raise ValueError("nothing to join")
        return looked(eyes, picture, sequence)

    monkeypatch.setattr(Eyes, "detect", detect)
    monkeypatch.setattr(camera_perception, "_start", lambda _owner: InThisProcess())
    first, second = Stage().frames(2)

    assert first.trouble == "the picture could not be looked at (ValueError: nothing to join)"
    assert not first.detections
    assert second.trouble is None
    assert second.detections


@pytest.mark.opengl
def test_the_same_seed_tells_the_same_to_the_last_bit(first_two):
    first, second = first_two, Stage().frames(2)

    assert [frame.sequence for frame in first] == [frame.sequence for frame in second]
    for one, other in zip(first, second, strict=True):
        assert len(one.detections) == len(other.detections)
        for a, b in zip(one.detections, other.detections, strict=True):
            assert np.array_equal(a.camera_T_object, b.camera_T_object)
            assert (a.kind, a.color, a.confidence) == (b.kind, b.color, b.confidence)


@pytest.mark.opengl
def test_no_picture_is_drawn_that_nobody_looks_at(stage):
    stage.frames(3)
    before = len(stage.eyes.looked_s)

    for _ in range(500):
        stage.eyes.tick()
        stage.clock.advance(0.002)

    assert len(stage.eyes.looked_s) == before


@pytest.mark.opengl
def test_a_frozen_camera_is_noticed_within_half_a_second(stage):
    stage.frames(1)
    since = stage.clock.now_s()
    stage.eyes.faults.frozen = True
    told = [frame for frame in stage.frames(6) if frame.stamp_s > since]
    stage.eyes.faults.frozen = False

    troubled = [frame for frame in told if frame.trouble is not None]
    assert troubled
    assert troubled[0].stamp_s - since < 0.5
    assert "same picture" in troubled[0].trouble


@pytest.mark.opengl
def test_the_picture_that_was_looked_at_is_shown_to_who_wants_it_and_those_of_the_room_are_not(tmp_path):
    slot = tmp_path / "picture"
    stage, reader = Stage(scene="watched", slot=slot), PictureSlotReader(slot)
    reader.want(True)

    stage.frames(1, stage.eyes.cameras[0])
    of_the_room = reader.newest()
    (frame,) = stage.frames(1)
    shown = reader.newest()
    reader.want(False)

    assert of_the_room is None
    assert (shown.frame, shown.color.shape) == (FRAME, (480, 640, 3))
    assert shown.stamp_s >= frame.stamp_s
    assert 0.3 < np.median(shown.depth_mm[shown.depth_mm > 0]) / 1000.0 < 3.0


def test_a_robot_without_a_camera_is_refused_with_what_its_data_lack():
    with pytest.raises(DescriptionError, match=r"\[\[rgbd\]\]"):
        require_camera(load_robot("g1"))


def test_without_opencv_one_line_says_what_to_install(monkeypatch):
    monkeypatch.setattr(camera_perception.importlib.util, "find_spec", lambda name: None)

    with pytest.raises(RenderingUnavailableError, match=r"humanoid-executive\[camera\]"):
        require_camera(load_robot("talos"))


@pytest.fixture(scope="module")
def watched():
    return Stage(scene="watched")


@pytest.mark.opengl
@pytest.mark.requirement("P3")
def test_a_camera_that_stands_in_the_room_shows_the_same_cup(watched):
    (camera,) = watched.eyes.cameras
    (frame,) = watched.frames(1, camera)

    (cup,) = [seen for seen in frame.detections if (seen.color, seen.kind) == ("red", "cup")]
    place = load_scene("watched").cameras[0].world_T_camera @ cup.camera_T_object
    truth = watched.world.truth.world_T_object("red cup")
    assert np.linalg.norm(place[:3, 3] - truth[:3, 3]) < 0.015


@pytest.mark.opengl
@pytest.mark.requirement("P3")
def test_a_second_camera_changes_nothing_of_what_the_first_one_shows(first_two):
    both = Stage(beside=load_scene("watched").cameras)

    first, second = first_two, both.frames(2)

    assert len(both.eyes.cameras) == len(load_scene("watched").cameras) > 0
    assert len(first) == len(second)

    for one, other in zip(first, second, strict=True):
        for a, b in zip(one.detections, other.detections, strict=True):
            assert np.array_equal(a.camera_T_object, b.camera_T_object)


@pytest.mark.opengl
@pytest.mark.requirement("P3")
def test_one_of_two_cameras_is_covered_and_the_other_shows_what_it_showed(watched):
    (camera,) = watched.eyes.cameras
    camera.faults.lens = LensFaults(covered=True)
    for _ in range(100):  # what was on its way comes yet
        camera.latest()
        watched.eyes.tick()
        watched.clock.advance(0.002)
    (frame,) = watched.frames(1, camera)
    (own,) = watched.frames(1)
    camera.faults.lens = LensFaults()

    assert frame.trouble is not None
    assert own.trouble is None
    assert own.detections


@pytest.mark.opengl
@pytest.mark.requirement("P3")
def test_the_camera_declares_how_wrong_it_may_be_and_what_all_things_share_of_that(watched):
    (frame,) = watched.frames(1)

    (cup,) = [seen for seen in frame.detections if (seen.color, seen.kind) == ("red", "cup")]
    sigma = np.sqrt(np.diag(cup.error.covariance_m2))
    assert (sigma > 0.0015).all()
    assert (sigma < 0.008).all()
    assert np.trace(cup.error.own_m2) < np.trace(cup.error.shared_m2)
