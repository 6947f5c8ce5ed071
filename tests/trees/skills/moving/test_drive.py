"""Walking at velocities that are sent meanwhile, without a robot that walks."""

import dataclasses

import pytest
from py_trees.common import Status

from robots.control.motion_handle import MotionStatus
from trees.skills.moving.drive import Drive
from trees.tasks import MoveTask
from trees.toolbox import VelocityFeed

from .test_move import FakeWalking, Ranges

NEAR = (0.4, 0.0, 1.0)


@pytest.fixture
def drive(stage):
    """Makes the leaf, on a stage that can walk, with the feed that it listens to."""

    def make(ranges=None):
        walking, feed = FakeWalking(), VelocityFeed()
        more = {"walking": walking, "ranging": ranges or Ranges(), "velocities": feed}
        leaf = Drive("walk", dataclasses.replace(stage.toolbox, **more))
        return stage.ready(leaf, task=MoveTask("go", is_fed=True)), walking, feed

    return make


def ticked(stage, leaf, seconds):
    before_s = leaf.toolbox.clock.now_s()
    while leaf.toolbox.clock.now_s() < before_s + seconds - 1e-6:
        stage.tick(leaf)
        if leaf.status is not Status.RUNNING:
            return


@pytest.mark.requirement("U3")
def test_the_walk_follows_the_newest_velocity(stage, drive):
    leaf, walking, feed = drive()
    feed.hear(0.2, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.3)
    feed.hear(0.3, 0.1, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.2)

    assert (walking.steering.linear_m_s, walking.steering.angular_rad_s) == (0.3, 0.1)
    assert leaf.status is Status.RUNNING


@pytest.mark.requirement("U3")
def test_a_silence_of_a_second_ends_the_walk(stage, drive):
    leaf, walking, feed = drive()
    feed.hear(0.2, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.9)
    assert walking.active
    ticked(stage, leaf, 0.5)

    assert walking.handle.status is MotionStatus.DONE
    assert leaf.status is Status.SUCCESS


def test_a_velocity_of_zero_stands_and_listens_on(stage, drive):
    leaf, walking, feed = drive()
    feed.hear(0.2, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.2)
    feed.hear(0.0, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.3)
    assert (walking.active, leaf.status) == (False, Status.RUNNING)
    feed.hear(0.1, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.3)

    assert walking.active


@pytest.mark.requirement("S1")
def test_a_velocity_beyond_the_limit_ends_the_walk_with_the_limit(stage, drive):
    leaf, walking, feed = drive()
    feed.hear(0.2, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.2)
    feed.hear(0.9, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.1)

    assert leaf.status is Status.FAILURE
    assert leaf.failure.numbers["limit"] == 0.5
    assert walking.handle.status is not MotionStatus.DONE


@pytest.mark.requirement("S2")
def test_it_does_not_set_out_toward_an_obstacle(stage, drive):
    leaf, walking, feed = drive(Ranges(NEAR))
    feed.hear(0.2, 0.0, leaf.toolbox.clock.now_s())
    ticked(stage, leaf, 0.2)

    assert leaf.status is Status.FAILURE
    assert walking.handle is None
