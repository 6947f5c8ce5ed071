"""What the online checker refuses on the way fails when the robot rests, and not before."""

import pytest
from py_trees.common import Status

from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import FailureKind
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.nodes.yielding_leaf import YieldingLeaf


@pytest.fixture
def leading(stage):
    """A leaf whose motion is in the test's hands."""

    class Leading(YieldingLeaf, register=False):
        INPUT_PORTS = ports()
        OUTPUT_PORTS = ports()
        CONTRACT = Contract("none", "none", 20.0)

        def start(self):
            self.handle = MotionHandle("lead the hand", "test")
            return self.handle

    leaf = stage.ready(Leading("lead", stage.toolbox))
    stage.tick(leaf)
    return leaf


def refused(leaf, progress):
    leaf.handle.progress, leaf.handle.status = progress, MotionStatus.REFUSED
    leaf.handle.reason = "collision of base_link and arm_right_5_link"


def ended_after_s(stage, leaf):
    began_s = stage.toolbox.clock.now_s()
    while stage.tick(leaf) is Status.RUNNING:
        stage.fake.step()
    return stage.toolbox.clock.now_s() - began_s


def test_after_a_refusal_on_the_way_the_stop_is_waited_for(stage, leading):
    refused(leading, 0.07)

    assert ended_after_s(stage, leading) == pytest.approx(0.6, abs=0.05)
    assert leading.failure.kind is FailureKind.REFUSED
    assert "collision of base_link" in leading.failure.message


def test_what_is_refused_at_once_has_nothing_to_wait_for(stage, leading):
    refused(leading, 0.0)

    assert ended_after_s(stage, leading) == pytest.approx(0.0, abs=0.05)
    assert leading.failure.kind is FailureKind.REFUSED
