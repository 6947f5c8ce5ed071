import numpy as np
import pytest

from kinematics.requests import CheckRequest, MoveRequest, NoPlan
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
    handle = fake.motion.start(fake.planning.answer(CheckRequest(step.trajectory, step.scene)))
    while not handle.finished:
        fake.step()
    return stage


def test_the_robot_ends_at_home(away):
    tree = away.play(away.pick(GoHomeTask("go home")))

    assert tree.status == "success"
    np.testing.assert_allclose(away.fake.motion.reference()[7:], away.toolbox.model.q_home[7:], atol=1e-9)


def test_a_way_home_that_is_blocked_is_told(away):
    away.fake.planning.no_plan = NoPlan("the table is in the way", {"collision": 1})

    tree = away.play(away.pick(GoHomeTask("go home")))

    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert tree.failure.message == "could not go home: the table is in the way"
    assert tree.failure.cause.where == "go home/move home"
