from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from robots.perception.fusion.cameras import HEAD, PlacedCamera
from robots.perception.position_error import alike_in_all_directions
from trees.events import NotSo, Said
from trees.failures import FailureKind, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.detect import Detect
from trees.skills.looking.folded_look import folded_look
from trees.skills.looking.look_leaf import LookLeaf, estimates_of
from trees.tasks import ObjectDescription, PickTask


class Look(LookLeaf, register=False):
    """Keeps what it gathered."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract("none", "none", deadline_s=1.0)

    def judge(self, views):
        self.views = list(views)
        return DONE


def test_frames_are_gathered_once_each_and_only_new_ones(stage):
    leaf = Look("look", stage.toolbox)
    start_s = stage.fake.clock.now_s()

    assert stage.run(leaf) is Status.SUCCESS
    numbers = [view.frame.sequence for view in leaf.views]
    assert len(set(numbers)) == len(numbers) == stage.toolbox.policy.look_frames
    assert all(view.frame.stamp_s >= start_s for view in leaf.views)


def test_pictures_that_were_taken_before_do_not_count_however_late_they_come(stage, monkeypatch):
    """Their camera may have been elsewhere, and the world another one."""
    for _ in range(5):
        stage.fake.step()
    detector = stage.fake.detector
    fresh = detector.latest
    monkeypatch.setattr(detector, "latest", lambda: replace(fresh(), stamp_s=0.0))
    leaf = Look("look", stage.toolbox)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.TIMEOUT


def test_a_picture_comes_with_the_cameras_pose_at_its_own_time(stage):
    leaf = Look("look", stage.toolbox)
    stage.run(leaf)

    for view in leaf.views:
        q = stage.fake.sensing.state_at(view.frame.stamp_s).q
        pose = stage.toolbox.model.frame_pose(q, stage.toolbox.model.description.camera.frame)
        np.testing.assert_array_equal(view.odom_T_camera, pose)


@pytest.mark.requirement("F3")
def test_a_camera_that_hangs_is_told_within_half_a_second_and_fails_the_look_by_name(stage):
    stage.fake.step()
    stage.fake.detector.frozen = True
    leaf = Look("look", replace(stage.toolbox, policy=replace(stage.toolbox.policy, look_timeout_s=2.0)))
    start_s = stage.fake.clock.now_s()

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.reason is Reason.FRAMES_FROZEN
    (noticed,) = [event for event in stage.events if isinstance(event, NotSo)]
    assert noticed.t_s - start_s <= 0.5
    assert [event.text for event in stage.events if isinstance(event, Said)] == [noticed.failure.message]


@pytest.mark.requirement("F3")
def test_a_camera_that_comes_back_in_time_does_not_fail_the_look(stage):
    stage.fake.step()
    stage.fake.detector.frozen = True
    leaf = Look("look", replace(stage.toolbox, policy=replace(stage.toolbox.policy, look_timeout_s=2.0)))
    stage.ready(leaf)
    for _ in range(30):
        stage.tick(leaf)
    stage.fake.detector.frozen = False

    assert stage.run(leaf) is Status.SUCCESS


@pytest.mark.requirement("F3")
def test_pictures_that_are_too_old_are_refused_by_name(stage, monkeypatch):
    for _ in range(5):
        stage.fake.step()
    detector = stage.fake.detector
    fresh = detector.latest
    monkeypatch.setattr(detector, "latest", lambda: replace(fresh(), stamp_s=fresh().stamp_s - 0.8))
    leaf = Look("look", stage.toolbox)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.reason is Reason.FRAMES_STALE


@pytest.mark.requirement("F3")
@pytest.mark.parametrize(("tilt_rad", "told"), [(0.006, []), (0.033, [Reason.CAMERA_ASKEW])])
def test_a_camera_in_whose_pictures_what_is_level_leans_is_named_and_the_look_counts(stage, tilt_rad, told):
    stage.fake.detector.tilt_rad = tilt_rad

    assert stage.run(Look("look", stage.toolbox)) is Status.SUCCESS
    assert [event.failure.reason for event in stage.events if isinstance(event, NotSo)] == told
    assert all("camera" in event.text for event in stage.events if isinstance(event, Said))


@pytest.mark.requirement("F3")
def test_what_hinders_the_camera_is_told_and_named_where_nothing_is_found(stage, monkeypatch):
    detector = stage.fake.detector
    fresh = detector.latest
    monkeypatch.setattr(detector, "latest", lambda: fresh() and replace(fresh(), hindrance="it is dark"))
    leaf = Detect("detect", stage.toolbox)

    assert stage.run(leaf, task=PickTask("a", ObjectDescription("ball", "blue"))) is Status.FAILURE
    assert leaf.failure.message == "no blue ball seen; the head camera sees badly: it is dark"
    assert Reason.SEES_BADLY in [event.failure.reason for event in stage.events if isinstance(event, NotSo)]


class Ceiling:
    """A second camera, which shows what the robot's own shows, relative to where it is itself."""

    labels = None

    def __init__(self, stage):
        self.stage, self.off_m, self.blind, self.frozen = stage, 0.0, False, None
        self.odom_T_camera = poses.transform(poses.rotation_x(np.pi), (0.5, 0.1, 2.2))
        self.placed = PlacedCamera("ceiling camera", self, self.odom_T_camera)

    def latest(self):
        if self.frozen is not None:
            return self.frozen
        frame = self.stage.fake.detector.latest()
        if frame is None:
            return None
        model, q = self.stage.toolbox.model, self.stage.fake.sensing.state_at(frame.stamp_s).q
        odom_T_head = model.frame_pose(q, model.description.camera.frame)
        moved = poses.inverse(self.odom_T_camera) @ poses.translation(self.off_m, 0.0, 0.0) @ odom_T_head
        seen = [replace(one, camera_T_object=moved @ one.camera_T_object) for one in frame.detections]
        return replace(frame, detections=() if self.blind else tuple(seen))


@pytest.fixture
def two_cameras(stage):
    stage.fake.detector.error = alike_in_all_directions(0.003, 0.0, 0.01)
    stage.fake.step()
    stage.ceiling = Ceiling(stage)
    stage.toolbox = replace(stage.toolbox, cameras=(stage.ceiling.placed,))
    return stage


def reasons(stage):
    return [event.failure.reason for event in stage.events if isinstance(event, NotSo)]


@pytest.mark.requirement("P3")
def test_two_cameras_that_agree_make_one_estimate_of_each_thing(two_cameras):
    leaf = Look("look", two_cameras.toolbox)

    assert two_cameras.run(leaf) is Status.SUCCESS
    tops = [one for one in estimates_of(leaf.views) if one.kind == "table"]
    assert len(tops) == 1
    assert tops[0].error.covariance_m2[0, 0] == pytest.approx(0.5 * 0.003**2, rel=1e-3)
    folded_look(two_cameras.toolbox, leaf.views)
    assert reasons(two_cameras) == []


@pytest.mark.requirement("P3")
def test_two_cameras_that_differ_are_told(two_cameras):
    two_cameras.ceiling.off_m = 0.03
    leaf = Look("look", two_cameras.toolbox)
    two_cameras.run(leaf)
    folded_look(two_cameras.toolbox, leaf.views)

    assert set(reasons(two_cameras)) == {Reason.CAMERAS_DIFFER}


@pytest.mark.requirement("P3")
def test_a_covered_camera_is_told_and_the_other_goes_on(two_cameras):
    two_cameras.ceiling.blind = True
    leaf = Look("look", two_cameras.toolbox)
    two_cameras.run(leaf)
    update = folded_look(two_cameras.toolbox, leaf.views)

    assert reasons(two_cameras) == [Reason.CAMERA_BLIND]
    assert "table" in update.seen


@pytest.mark.requirement("P3")
def test_where_the_robots_own_camera_hangs_a_look_goes_on_with_the_other(two_cameras):
    detector = two_cameras.fake.detector
    leaf = Look("look", replace(two_cameras.toolbox, detector=Hanging(detector.latest())))

    assert two_cameras.run(leaf) is Status.SUCCESS
    assert {view.source for view in leaf.views} == {"ceiling camera"}
    assert reasons(two_cameras) == [Reason.FRAMES_FROZEN]


class Hanging:
    """A camera that shows one frame for ever."""

    labels = None

    def __init__(self, frame):
        self.frame = frame

    def latest(self):
        return self.frame


@pytest.mark.requirement("P3")
def test_where_the_other_camera_hangs_a_look_goes_on_with_the_robots_own(two_cameras):
    two_cameras.ceiling.frozen = two_cameras.ceiling.latest()
    leaf = Look("look", two_cameras.toolbox)

    assert two_cameras.run(leaf) is Status.SUCCESS
    assert leaf.views[-1].source == HEAD


def test_a_look_says_what_is_wrong_with_the_camera_within_half_a_second(stage, monkeypatch):
    detector = stage.fake.detector
    fresh = detector.latest

    def troubled():
        frame = fresh()
        return None if frame is None else replace(frame, detections=(), trouble="the picture is too dark")

    monkeypatch.setattr(detector, "latest", troubled)
    leaf = Look("look", stage.toolbox)
    start_s = stage.fake.clock.now_s()

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.reason is Reason.CANNOT_SEE
    assert "the picture is too dark" in leaf.failure.message
    assert stage.fake.clock.now_s() - start_s < 0.7


def test_a_picture_with_something_wrong_is_no_look_at_nothing(stage, monkeypatch):
    """Things that it does not show have not gone."""
    detector = stage.fake.detector
    fresh = detector.latest

    def flickering():
        frame = fresh()
        bad = frame is not None and frame.sequence % 2 == 0
        return replace(frame, detections=(), trouble="the picture is outshone") if bad else frame

    monkeypatch.setattr(detector, "latest", flickering)
    leaf = Look("look", stage.toolbox)

    assert stage.run(leaf) is Status.SUCCESS
    assert all(view.frame.trouble is None for view in leaf.views)


def troubled(detector):
    """A detector whose every picture has something wrong."""
    fresh = detector.latest

    class Troubled:
        labels = None

        def latest(self):
            frame = fresh()
            return None if frame is None else replace(frame, detections=(), trouble="the picture is too dark")

    return Troubled()


@pytest.mark.requirement("P3")
def test_where_the_robots_own_camera_is_covered_it_is_told_and_a_look_goes_on_with_the_other(two_cameras):
    leaf = Look("look", replace(two_cameras.toolbox, detector=troubled(two_cameras.fake.detector)))

    assert two_cameras.run(leaf) is Status.SUCCESS
    assert {view.source for view in leaf.views} == {"ceiling camera"}
    assert reasons(two_cameras) == [Reason.CAMERA_BLIND]


@pytest.mark.requirement("P3")
def test_where_the_other_camera_is_covered_it_is_told_and_a_look_goes_on_with_the_robots_own(two_cameras):
    placed = replace(two_cameras.ceiling.placed, detector=troubled(two_cameras.fake.detector))
    leaf = Look("look", replace(two_cameras.toolbox, cameras=(placed,)))

    assert two_cameras.run(leaf) is Status.SUCCESS
    assert {view.source for view in leaf.views} == {HEAD}
    assert reasons(two_cameras) == [Reason.CAMERA_BLIND]


@pytest.mark.requirement("P3")
def test_where_both_cameras_are_covered_a_look_says_so_within_a_second(two_cameras):
    dark = troubled(two_cameras.fake.detector)
    placed = replace(two_cameras.ceiling.placed, detector=dark)
    leaf = Look("look", replace(two_cameras.toolbox, detector=dark, cameras=(placed,)))
    start_s = two_cameras.fake.clock.now_s()

    assert two_cameras.run(leaf) is Status.FAILURE
    assert leaf.failure.reason is Reason.CANNOT_SEE
    assert two_cameras.fake.clock.now_s() - start_s < 1.0


@pytest.mark.requirement("P3")
def test_a_camera_that_looks_elsewhere_is_not_taken_for_a_covered_one(two_cameras):
    two_cameras.ceiling.blind = True
    away = replace(two_cameras.ceiling.placed, odom_T_camera=poses.translation(0.3, 0.1, 2.0))  # it looks up
    leaf = Look("look", replace(two_cameras.toolbox, cameras=(away,)))
    two_cameras.run(leaf)
    folded_look(replace(two_cameras.toolbox, cameras=(away,)), leaf.views)

    assert reasons(two_cameras) == []
