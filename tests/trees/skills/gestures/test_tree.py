"""Words, waits, waves, pointing and looking: what is done, what is said, and what is never claimed."""

import pytest

from kinematics.requests.gesture import PointRequest, RaiseHandRequest
from kinematics.requests.step import NoPlan
from robots.fake.fake_world import bowl, cup, person, table
from tests.trees.household_stage import ANA, BLUE_CUP, RED_CUP, asked, run, said
from trees.failures import FailureKind
from trees.tasks import (
    HandOverTask,
    LookAtTask,
    ObjectDescription,
    PickTask,
    PlaceTask,
    PointAtTask,
    PutInTask,
    SayTask,
    WaitTask,
    WaveTask,
)


def test_words_are_given_out(stage):
    tree = run(stage, SayTask("say hello", "hello", "Ana"))

    assert tree.status == "success"
    assert said(stage) == ["hello"]


def test_waiting_takes_its_time_and_moves_nothing(stage):
    began_s = stage.fake.clock.now_s()

    tree = run(stage, WaitTask("wait", 0.5))

    assert tree.status == "success"
    assert stage.fake.clock.now_s() - began_s == pytest.approx(0.5, abs=0.05)
    assert not stage.fake.motion.started


def test_a_wave_is_for_the_person_who_is_named(stage_with):
    stage = stage_with(person("Ben", (1.4, -0.6)), person("Ana", (1.3, 0.6)))

    tree = run(stage, WaveTask("wave at Ana", "Ana"))

    assert tree.status == "success"
    assert tree.evidence["swings"] >= 3
    assert asked(stage, RaiseHandRequest)[0].towards_m[1] > 0.5


def test_a_wave_at_nobody_fails_and_says_so(stage):
    tree = run(stage, WaveTask("wave at Ana", "Ana"))

    assert tree.status == "failure"
    assert "no Ana seen" in tree.failure.message
    assert not asked(stage, RaiseHandRequest)


def test_a_hand_that_hardly_swings_is_no_wave(stage_with):
    stage = stage_with(ANA)
    stage.when("swing hand", lambda: setattr(stage.fake.robot, "stuck", set(stage.toolbox.model.joints)))

    tree = run(stage, WaveTask("wave"))

    assert tree.status == "failure"
    assert tree.failure.kind in (FailureKind.POSTCONDITION, FailureKind.EXECUTION)


def test_pointing_is_measured_against_the_thing(stage):
    tree = run(stage, PointAtTask("point at the red cup", RED_CUP))

    assert tree.status == "success"
    assert tree.evidence["off_m"] <= 0.10
    assert asked(stage, PointRequest)


def test_an_arm_is_not_stretched_over_a_table_that_was_not_looked_at(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.45, -0.45)))
    stage.fake.world.hidden.add("blue cup")
    stage.when("look below the way", stage.fake.world.hidden.clear)
    started = []
    stage.when("stretch arm", lambda: started.append(asked(stage, PointRequest)[-1].scene))

    tree = run(stage, PointAtTask("point at the red cup", RED_CUP))

    assert tree.status == "success"
    assert "blue cup" not in asked(stage, PointRequest)[0].scene.objects
    assert ["blue cup" in scene.objects for scene in started] == [True]


def test_an_arm_that_passes_over_nothing_is_stretched_at_once(stage_with):
    stage = stage_with(ANA)

    tree = run(stage, PointAtTask("point at Ana", person="Ana"))

    assert tree.status == "success"
    assert len(asked(stage, PointRequest)) == 1


def test_what_is_looked_at_is_in_the_middle_of_the_picture(stage):
    tree = run(stage, LookAtTask("look at the red cup", RED_CUP))

    assert tree.status == "success"
    assert tree.evidence["off_centre"] <= 0.10


def test_a_look_that_is_barred_by_what_the_hand_holds_is_taken_from_home(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))
    stage.play(stage.pick())
    planning = stage.fake.planning
    stage.when("turn to it", lambda: setattr(planning, "no_plan", NoPlan("no way", {"no path": 1})))
    stage.when("draw the hands in", lambda: setattr(planning, "no_plan", None))

    tree = run(stage, LookAtTask("look at the blue cup", BLUE_CUP))

    assert "no way" in [failure.message for failure in stage.failed()]
    assert tree.status == "success"
    assert tree.evidence["off_centre"] <= 0.10


def test_no_plan_for_a_gesture_is_told(stage_with):
    stage = stage_with(ANA)
    stage.when("raise hand", lambda: None)
    stage.fake.planning.no_plan = NoPlan(
        "no posture of the left arm for that was found", {"out of reach": 14}
    )

    tree = run(stage, WaveTask("wave at Ana", "Ana"))

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE


def test_a_hand_that_holds_something_does_not_wave(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.play(stage.pick(PickTask("pick up the red cup", RED_CUP)))

    tree = run(stage, WaveTask("wave with the right hand", "Ana", "right"))

    assert tree.status == "failure"
    assert "no hand is free" in tree.failure.message


@pytest.mark.requirement("L1", "M3")
@pytest.mark.parametrize(
    "task",
    [
        PlaceTask("put the cup from the shelf on the table", RED_CUP, on="table", source="shelf"),
        PutInTask(
            "put the cup from the shelf in the bowl", RED_CUP, ObjectDescription("bowl"), source="shelf"
        ),
        HandOverTask("give Ana the cup from the shelf", RED_CUP, "Ana", source="shelf"),
    ],
    ids=lambda task: task.action,
)
def test_a_thing_that_is_said_to_be_elsewhere_is_left_where_it_stands(stage_with, task):
    stage = stage_with(table(), cup(), bowl(), ANA)

    tree = run(stage, task)

    assert tree.status == "failure"
    assert "on the shelf" in str(tree.failure)
    assert not stage.toolbox.world.scene.attached
