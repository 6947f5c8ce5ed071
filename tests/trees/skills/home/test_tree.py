import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.requests.move import MoveRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import SceneObject
from trees.failures import FailureKind
from trees.tasks import GoHomeTask


@pytest.fixture
def away(stage):
    """The fake robot with a turned head."""
    fake = stage.fake
    move = MoveRequest(
        fake.motion.reference(),
        fake.motion.stance(),
        stage.told.scene,
        {"head_2_joint": 0.5},
        keep_others=True,
    )
    step = fake.planning.answer(move).step
    handle = fake.motion.start(fake.planning.verdict(step.question))
    while not handle.finished:
        fake.step()
    return stage


def test_the_robot_ends_at_home(away):
    tree = away.play(away.pick(GoHomeTask("go home")))

    assert tree.status == "success"
    np.testing.assert_allclose(away.fake.motion.reference()[7:], away.toolbox.model.q_home[7:], atol=1e-9)


@pytest.mark.requirement("S9")
def test_who_knows_nothing_looks_where_the_hands_are_before_they_go_home(away):
    tree = away.play(away.pick(GoHomeTask("go home")))

    assert tree.status == "success"
    assert set(away.told.scene.objects) == {"red cup", "table"}


def test_who_has_seen_something_does_not_look_again(away):
    table = SceneObject("table", Box((0.6, 1.2, 0.04)), poses.translation(0.65, 0.0, 0.88), movable=False)
    away.told.update(away.told.scene.with_object(table))
    before = away.told.scene.version

    assert away.play(away.pick(GoHomeTask("go home"))).status == "success"
    assert away.told.scene.version == before


def test_who_is_at_home_does_not_look(stage):
    assert stage.play(stage.pick(GoHomeTask("go home"))).status == "success"
    assert not stage.told.scene.objects


def test_a_way_home_that_is_blocked_is_told(away):
    away.fake.planning.no_plan = NoPlan("the table is in the way", {"collision": 1})

    tree = away.play(away.pick(GoHomeTask("go home")))

    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert tree.failure.message == "could not go home: the table is in the way"
    assert tree.failure.cause.where == "go home/move home"
