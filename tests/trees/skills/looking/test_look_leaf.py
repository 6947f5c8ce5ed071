from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from trees.events import NotSo, Said
from trees.failures import FailureKind, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_leaf import LookLeaf


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
