"""A pick can be halted at every one of its ticks."""

import numpy as np
import pytest

from trees.failures import FailureKind


def halted_after(stage, ticks, disturb=lambda stage: None):
    stage.fake.planning.motion_s = 0.04
    disturb(stage)
    tree = stage.play(stage.pick(), ticks)
    if tree.status != "running":
        return None
    tree.halt("the person said stop")
    return tree


def jammed_hand(stage):
    for hand in stage.fake.grippers.values():
        hand.empty = True


def assert_it_holds(stage):
    assert not stage.fake.motion.moving
    stage.fake.step()
    held = stage.fake.sensing.state().q
    fingers = [hand.position_rad for hand in stage.fake.grippers.values()]
    for _ in range(5):
        stage.fake.step()
    np.testing.assert_array_equal(stage.fake.sensing.state().q, held)
    assert [hand.position_rad for hand in stage.fake.grippers.values()] == fingers
    assert all(job.canceled or job.done for job in stage.fake.planning.jobs)


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("ticks", range(60))
def test_a_halt_at_any_tick_leaves_the_robot_holding(stage, ticks):
    tree = halted_after(stage, ticks)

    if tree is not None:
        assert tree.status == "failure"
        assert tree.failure.kind is FailureKind.CANCELED
        assert tree.failure.message == "the person said stop"
        assert_it_holds(stage)


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("ticks", range(40, 80, 4))
def test_a_halt_while_recovering_leaves_the_robot_holding(stage, ticks):
    tree = halted_after(stage, ticks, jammed_hand)

    assert tree is not None
    assert_it_holds(stage)


@pytest.mark.requirement("S7")
def test_after_a_halt_the_same_robot_picks_the_cup_up(stage):
    halted_after(stage, 30)

    assert stage.play(stage.pick()).status == "success"


def test_a_halt_tells_where_the_tree_was(stage):
    tree = halted_after(stage, 20)

    assert tree.failure.where.startswith("pick/")
