import pytest
from py_trees.common import Status

from kinematics.requests.step import NoPlan
from trees.failures import FailureKind, Reason
from trees.skills.pick.plan_pick import PlanPick, hands_to_try
from trees.tasks import ObjectDescription, PickTask

TASK = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
LEFT = PickTask("pick up the red cup", ObjectDescription("cup", "red"), hand="left")


def plan(stage, target, task=TASK, **inputs):
    leaf = PlanPick("plan pick", stage.toolbox)
    return leaf, stage.run(leaf, task=task, target=target, **inputs)


def test_grasp_and_steps_are_for_the_present_scene(knowing, target):
    _, status = plan(knowing, target)

    assert status is Status.SUCCESS
    assert knowing.output("grasp").hand == "right"
    for name in ("reach", "approach", "lift"):
        assert knowing.output(name).world_version == knowing.told.scene.version


@pytest.mark.requirement("M5")
def test_both_hands_are_offered_unless_one_is_asked_for(knowing, target):
    plan(knowing, target)
    plan(knowing, target, LEFT)

    assert [set(request.hands) for request in knowing.fake.planning.requests] == [{"left", "right"}, {"left"}]


@pytest.mark.requirement("M4")
def test_grasps_that_were_tried_are_left_out(knowing, target):
    plan(knowing, target, tried=frozenset({"right side"}))

    assert knowing.output("grasp").label == "top"


@pytest.mark.requirement("F1")
def test_a_target_that_a_later_look_knows_no_more_is_a_failure_of_its_own(knowing, target):
    world = knowing.toolbox.world
    world.update(world.scene.without_object(target.name))
    leaf, status = plan(knowing, target)

    assert status is Status.FAILURE
    assert leaf.failure.reason is Reason.GONE_SINCE_LOOK
    assert knowing.fake.planning.requests == []


def test_no_plan_is_infeasible_with_its_reasons(knowing, target):
    knowing.fake.planning.no_plan = NoPlan("out of reach", {"out of reach": 2}, {"distance_m": 1.4})
    leaf, status = plan(knowing, target)

    assert status is Status.FAILURE
    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert leaf.failure.numbers == {"out of reach": 2, "distance_m": 1.4}


@pytest.mark.requirement("S8")
def test_a_planner_that_raises_fails_the_leaf_alone(knowing, target):
    knowing.fake.planning.raises = RuntimeError("Infeasible QP")
    leaf, status = plan(knowing, target)

    assert status is Status.FAILURE
    assert leaf.failure.kind is FailureKind.ERROR
    assert "Infeasible QP" in leaf.failure.message


def test_a_planner_that_hangs_is_given_up_and_its_job_cancelled(knowing, target):
    knowing.fake.planning.hangs = True
    leaf = knowing.ready(PlanPick("plan pick", knowing.toolbox), task=TASK, target=target)
    assert knowing.tick(leaf) is Status.RUNNING
    knowing.fake.clock.advance(leaf.deadline_s)

    assert knowing.tick(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.TIMEOUT
    assert knowing.fake.planning.jobs[0].canceled


def test_an_answer_to_another_question_is_a_defect(knowing, target):
    knowing.fake.planning.answer = lambda request: 42
    leaf, _ = plan(knowing, target)

    assert leaf.failure.kind is FailureKind.ERROR


@pytest.mark.requirement("M5")
@pytest.mark.parametrize(
    ("named", "tried", "hands"),
    [
        (None, (), {"left", "right"}),
        (None, ("right side",), {"left", "right"}),
        (None, ("right side", "right top"), {"left"}),
        (None, ("right side", "right top", "left side", "left top"), {"left", "right"}),
        ("right", ("right side", "right top"), {"right"}),
    ],
)
def test_a_hand_that_failed_twice_leaves_its_turn_to_the_other(named, tried, hands):
    assert set(hands_to_try(named, frozenset(tried), frozenset(), ("left", "right"))) == hands


def test_a_robot_with_one_hand_tries_it_again():
    tried = frozenset({"right side", "right top"})

    assert hands_to_try(None, tried, frozenset({"right"}), ("right",)) == ("right",)
