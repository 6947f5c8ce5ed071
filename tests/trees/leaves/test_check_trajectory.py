import pytest
from py_trees.common import Status

from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from trees.failures import FailureKind
from trees.leaves.check_trajectory import CheckTrajectory

HIT = Finding(FindingKind.SCENE_COLLISION, 0.412, ("arm_left_5_link", "table"), 0.004, 0.015)


def test_a_safe_step_is_passed_on_with_the_scene_it_holds_for(knowing, planned):
    leaf = CheckTrajectory("check trajectory", knowing.toolbox)

    assert knowing.run(leaf, step=planned.step("reach")) is Status.SUCCESS
    assert knowing.output("checked").world_version == knowing.told.scene.version


@pytest.mark.requirement("S6")
def test_an_unsafe_step_says_what_collides_and_when(knowing, planned):
    knowing.fake.planning.unsafe = lambda request: Unsafe((HIT,))
    leaf = CheckTrajectory("check trajectory", knowing.toolbox)

    assert knowing.run(leaf, step=planned.step("reach")) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.UNSAFE
    assert leaf.failure.message.startswith("Unsafe trajectory: scene collision of arm_left_5_link and table")
    assert leaf.failure.numbers["t_s"] == 0.412


def test_a_check_that_the_world_has_overtaken_is_thrown_away(knowing, planned):
    leaf = knowing.ready(CheckTrajectory("check trajectory", knowing.toolbox), step=planned.step("reach"))
    knowing.tick(leaf)
    knowing.told.update(knowing.told.scene.with_objects([]))

    while knowing.tick(leaf) is Status.RUNNING:
        pass

    assert "stale" in leaf.failure.message
