"""A motion that a leaf plans by itself: one that the checker refuses is planned anew, once."""

import pytest
from py_trees.common import Status

from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from kinematics.requests.move import MoveRequest
from trees.failures import FailureKind
from trees.skills.walking.draw_arms_in import DrawArmsIn

HIT = Finding(FindingKind.SCENE_COLLISION, 2.1, ("gripper_left_fingertip_1_link", "fridge 2"), 0.0149, 0.015)


@pytest.mark.parametrize(("refusals", "status"), [(1, Status.SUCCESS), (2, Status.FAILURE)])
def test_a_refused_motion_is_planned_once_more(stage, refusals, status):
    answers = iter([Unsafe((HIT,))] * refusals)
    planning = stage.fake.planning
    planning.unsafe = lambda _: next(answers, None)

    assert stage.run(DrawArmsIn("in", stage.toolbox)) is status
    moves = [request for request in planning.requests if isinstance(request, MoveRequest)]
    assert len(moves) == 2
    assert moves[0].seed != moves[1].seed
    if status is Status.FAILURE:
        assert stage.failed()[-1].kind is FailureKind.UNSAFE


def test_what_is_planned_anew_is_for_the_scene_that_is_believed_by_then(stage):
    planning, world = stage.fake.planning, stage.toolbox.world

    def refuse_once(_request):
        planning.unsafe = lambda _: None
        world.update(world.scene.allowing([("table", "table")]))
        return Unsafe((HIT,))

    planning.unsafe = refuse_once

    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS
