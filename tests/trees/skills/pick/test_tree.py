"""The whole pick on the fake robot: what goes wrong, and what the robot then does and says."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.requests.pick import PickRequest
from kinematics.requests.step import NoPlan
from robots.fake.fake_world import cup, table
from robots.models.description import load_robot
from trees.events import NodeChanged
from trees.failures import FailureKind
from trees.skills.pick.settings import PickSettings
from trees.tasks import ObjectDescription, PickTask

HARDWARE = load_robot("talos").hardware

HIT = Finding(FindingKind.SCENE_COLLISION, 0.4, ("arm_right_5_link", "table"), 0.004, 0.015)
RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))


def lifted(stage):
    """The truth: whether the cup is in a hand, and higher than it stood."""
    there = {item.name: item for item in stage.fake.world.solids()}
    item = there.get("red cup")
    held = item is not None and stage.fake.world.carried_by("red cup") is not None
    return held and item.world_T_object[2, 3] > 0.955 + 0.1


def at_home(stage):
    reference, home = stage.fake.motion.reference(), stage.toolbox.model.q_home
    return bool(np.abs(reference[7:] - home[7:]).max() < 0.02)


def places(failure):
    found = []
    while failure is not None:
        found.append(failure.where)
        failure = failure.cause
    return found


@pytest.mark.requirement("M1", "U2")
def test_a_cup_on_a_table_is_picked_up(stage):
    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.failure is None
    assert tree.attempts == 1
    assert lifted(stage)


@pytest.mark.requirement("M2")
def test_the_evidence_comes_from_the_robots_own_sensors(stage):
    tree = stage.play(stage.pick())

    assert tree.evidence["gripper_opening_m"] == pytest.approx(0.06)
    grip = HARDWARE.grips[tree.evidence["hand"]]
    assert tree.evidence["effort_nm"] == pytest.approx(grip.effort_nm)
    assert tree.evidence["lift_m"] == pytest.approx(0.13, abs=1e-3)


@pytest.mark.requirement("S6")
def test_the_whole_pick_is_checked_before_the_arm_moves(stage):
    moved = []
    stage.when("stream reach", lambda: moved.append(len(stage.fake.planning.requests)))

    stage.play(stage.pick())

    before = stage.fake.planning.requests[: moved[0]]
    last_plan = max(i for i, request in enumerate(before) if isinstance(request, PickRequest))
    assert sum(isinstance(request, CheckRequest) for request in before[last_plan:]) == 3


@pytest.mark.requirement("S6")
def test_the_lift_is_checked_once_more_with_the_object_in_the_hand(stage):
    stage.play(stage.pick())

    checks = [request for request in stage.fake.planning.requests if isinstance(request, CheckRequest)]
    assert any("red cup" in check.scene.attached for check in checks)


@pytest.mark.requirement("M4")
def test_a_cup_that_moves_during_the_reach_is_picked_up_where_it_is_then(stage):
    stage.when("stream reach", lambda: stage.fake.world.move("red cup", (0.0, 0.05, 0.0)), 1)

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.attempts == 2
    assert lifted(stage)
    assert "the red cup is not where it was" in [failure.message for failure in stage.failed()]


@pytest.mark.requirement("M4")
def test_a_cup_that_is_seen_elsewhere_while_its_old_place_is_out_of_view_is_not_taken_for_two(stage_with):
    stage = stage_with(table(), cup(place_m=(0.36, -0.10)))
    stage.when("stream reach", lambda: stage.fake.world.move("red cup", (0.20, 0.35, 0.0)), 1)

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert lifted(stage)


@pytest.mark.requirement("M4")
def test_a_detection_four_centimetres_wrong_is_corrected_by_the_second_look(stage):
    stage.fake.detector.offset_m["red cup"] = (0.0, 0.04, 0.0)
    stage.when("stream reach", stage.fake.detector.offset_m.clear)

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert lifted(stage)


@pytest.mark.requirement("M4")
def test_after_an_empty_grasp_another_grasp_is_tried(stage):
    hand = stage.fake.grippers["right"]
    hand.empty = True
    stage.when("release", lambda: setattr(hand, "empty", False))

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.attempts == 2
    plans = [request for request in stage.fake.planning.requests if isinstance(request, PickRequest)]
    assert plans[-1].excluded == {"right side"}


def test_what_stands_out_of_view_beside_the_hands_way_is_seen_before_the_arm_moves(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.42, -0.36)), looks_for_twins=False)
    seen = []
    stage.when("stream reach", lambda: seen.append("blue cup" in stage.told.scene.objects))

    stage.play(stage.pick())

    plans = [request for request in stage.fake.planning.requests if isinstance(request, PickRequest)]
    assert "blue cup" not in plans[0].scene.objects
    assert "blue cup" in plans[-1].scene.objects
    assert seen[-1]


def test_a_look_beside_the_cup_that_overlooks_it_does_not_forget_it(stage):
    stage.when("plan pick", lambda: stage.fake.world.hidden.add("red cup"))
    stage.when("stream reach", stage.fake.world.hidden.clear)

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.attempts == 1


def test_where_somebody_looked_before_nobody_looks_again(stage_with):
    stage = stage_with(table(), cup(), looks_for_twins=False)

    def looks_aside():
        names = [event.where for event in stage.events if isinstance(event, NodeChanged)]
        return sum(name.endswith("where the hand goes/survey") for name in names)

    stage.play(stage.pick())
    once = looks_aside()
    for hand in stage.fake.grippers.values():
        hand.open()
    stage.play(stage.pick())

    assert once > 0
    assert looks_aside() == once


def test_a_twin_outside_the_first_picture_leads_to_a_question(stage_with):
    stage = stage_with(table(), cup(), cup("red cup 2", "red", (0.42, -0.36)))

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert len(tree.failure.choices) == 2
    assert not any(isinstance(request, PickRequest) for request in stage.fake.planning.requests)


@pytest.mark.requirement("M2")
def test_a_cup_that_the_looks_to_the_sides_have_lost_is_looked_for_ahead_once_more(stage):
    stage.when("look to the left", lambda: stage.fake.world.hidden.add("red cup"))
    stage.when("look ahead again", stage.fake.world.hidden.clear)

    stage.play(stage.pick())

    assert lifted(stage)


def test_who_has_seen_the_whole_table_looks_no_further(stage_with):
    def looks_aside(top):
        stage = stage_with(top, cup())
        assert stage.play(stage.pick()).status == "success"
        return [
            event for event in stage.events if getattr(event, "where", "").endswith("look to the left/look")
        ]

    small = replace(table(), shape=Box((0.3, 0.2, 0.04)), world_T_object=poses.translation(0.55, -0.15, 0.88))
    assert looks_aside(table())
    assert not looks_aside(small)


@pytest.mark.requirement("M2", "M4")
def test_a_hand_that_always_misses_gives_up_open_and_at_home(stage):
    for hand in stage.fake.grippers.values():
        hand.empty = True

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert tree.attempts == stage.toolbox.policy.of(PickSettings).pick_attempts
    assert tree.failure.kind is FailureKind.POSTCONDITION
    assert tree.failure.message == "could not pick up the red cup: nothing between the fingers"
    assert places(tree.failure) == ["pick"] + ["pick/grasp/verify hold"] * 4
    assert at_home(stage)
    assert all(hand.reading().opening_m > 0.09 for hand in stage.fake.grippers.values())


@pytest.mark.requirement("M2")
@pytest.mark.parametrize("after_ticks", [0, 3, 6, 9])
def test_a_cup_taken_away_after_the_lift_is_never_claimed(stage, after_ticks):
    stage.when("verify lift", lambda: stage.fake.world.remove("red cup"), after_ticks)

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert tree.evidence == {}
    assert tree.failure.message == "could not pick up the red cup: no red cup seen"
    assert "pick/lift/verify lift" in places(tree.failure)
    assert at_home(stage)


@pytest.mark.requirement("M2", "M4")
def test_a_cup_that_drops_from_the_lift_is_picked_up_again(stage):
    stage.when("verify lift", lambda: stage.fake.world.drop("red cup"), 4)

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.attempts == 2
    assert lifted(stage)


@pytest.mark.requirement("M2", "M4")
def test_a_cup_that_slips_slowly_is_put_back_and_grasped_anew(stage):
    stage.when("verify lift", lambda: stage.fake.world.shift_in_hand("red cup", 0.012), 6)

    tree = stage.play(stage.pick())

    assert "the red cup is slipping" in [failure.message for failure in stage.failed()]
    assert tree.status == "success"
    assert lifted(stage)


@pytest.mark.requirement("M4")
def test_what_cannot_be_put_back_is_kept_and_told(stage):
    def slip():
        stage.fake.world.shift_in_hand("red cup", 0.012)
        stage.fake.planning.no_plan = NoPlan("the way down is blocked", {"blocked": 1})

    stage.when("verify lift", slip, 6)

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert "the right hand still holds the red cup in the air" in tree.failure.message
    assert tree.failure.numbers["still_held"] == "the right hand still holds something"
    assert stage.fake.world.carried_by("red cup") == "right"


def test_a_table_without_the_cup_is_searched_and_nothing_is_claimed(stage_with):
    stage = stage_with(table(), cup("blue cup", "blue"))

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert tree.failure.message == "could not pick up the red cup: no red cup seen"
    assert not any("gripper" in name for name in stage.fake.motion.started)
    assert at_home(stage)


@pytest.mark.requirement("L6")
def test_of_two_cups_that_fit_none_is_touched(stage_with):
    stage = stage_with(table(), cup(place_m=(0.5, -0.15)), cup("blue cup", "blue", (0.5, 0.15)))

    tree = stage.play(stage.pick(PickTask("pick up the cup", ObjectDescription("cup"))))

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert tree.failure.choices == ("blue cup", "red cup")
    assert tree.failure.root.open_choice.unseen == 0
    assert not any("gripper" in name for name in stage.fake.motion.started)


@pytest.mark.requirement("S6")
def test_an_unsafe_reach_moves_no_arm(stage):
    def hits(request):
        reaching = np.abs(request.trajectory.q[-1] - request.trajectory.q[0])
        arms = [7 + stage.toolbox.model.joint_index(f"arm_{side}_4_joint") for side in ("left", "right")]
        return Unsafe((HIT,)) if reaching[arms].max() > 1e-3 else None

    stage.fake.planning.unsafe = hits

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.UNSAFE
    assert "arm_right_5_link and table" in tree.failure.message
    assert tree.attempts == stage.toolbox.policy.of(PickSettings).pick_attempts
    assert at_home(stage)


@pytest.mark.requirement("M4")
def test_an_unreachable_cup_is_declined_after_a_second_look(stage):
    def blocked():
        stage.fake.planning.no_plan = NoPlan("no way to grasp the red cup", {"out of reach": 2})

    stage.when("plan pick", blocked)

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert tree.attempts <= 2


@pytest.mark.requirement("M5")
def test_the_other_hand_is_taken_when_the_first_one_fails(stage):
    stage.fake.grippers["right"].empty = True

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.attempts == 3
    assert tree.evidence["hand"] == "left"
    assert lifted(stage)


def test_a_scene_that_changes_while_the_robot_plans_makes_it_plan_again(stage):
    def somebody_passes():
        stage.told.update(stage.told.scene.with_objects(stage.told.scene.objects.values()))

    stage.when("check reach", somebody_passes)

    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.attempts == 2
    assert any("stale" in failure.message for failure in stage.failed())


@pytest.mark.requirement("S8")
def test_a_planner_that_raises_fails_the_task_and_nothing_else(stage):
    stage.when("plan pick", lambda: setattr(stage.fake.planning, "raises", RuntimeError("Infeasible QP")))

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.ERROR
    assert "Infeasible QP" in tree.failure.message
    assert tree.attempts == 1
    assert not stage.fake.motion.moving
    stage.fake.planning.raises = None
    assert stage.play(stage.pick()).status == "success"


def test_a_planner_that_hangs_runs_into_a_deadline(stage_with, quick):
    stage = stage_with(table(), cup(), policy=replace(quick, task_timeout_s=2.0))
    stage.fake.planning.hangs = True

    tree = stage.play(stage.pick())

    assert tree.failure.kind is FailureKind.TIMEOUT
    assert all(job.canceled for job in stage.fake.planning.jobs)


@pytest.mark.requirement("S1")
def test_a_motion_that_the_gate_refuses_is_told_with_the_reason(stage):
    stage.when(
        "stream approach", lambda: setattr(stage.fake.motion, "refuse_midway", "velocity of arm_right_3")
    )

    tree = stage.play(stage.pick())

    assert tree.status == "failure"
    refused = [failure for failure in stage.failed() if failure.kind is FailureKind.REFUSED]
    assert "velocity of arm_right_3" in refused[0].message


@pytest.mark.requirement("M4")
def test_after_a_refused_reach_the_next_attempt_is_planned_from_home(stage):
    """What stopped the arm may still be under it: from there every next motion would push, too."""
    motion = stage.fake.motion
    stage.when("stream reach", lambda: setattr(motion, "refuse_midway", "unexpected contact"))
    stage.when("release", lambda: setattr(motion, "refuse_midway", ""))

    stage.play(stage.pick())

    first, second = [r for r in stage.fake.planning.requests if isinstance(r, PickRequest)][:2]
    arm = 7 + stage.toolbox.model.group("right_arm")
    np.testing.assert_allclose(second.q_start[arm], first.q_start[arm], atol=0.01)


@pytest.mark.requirement("S9")
def test_every_node_that_ran_was_told(stage):
    stage.play(stage.pick())

    told = {event.where for event in stage.events if isinstance(event, NodeChanged)}
    for where in (
        "pick/plan/plan pick",
        "pick/reach/stream reach",
        "pick/grasp/close gripper",
        "pick/lift/verify lift",
    ):
        assert where in told


def test_the_same_seed_tells_the_same_events(stage_with):
    def events():
        stage = stage_with(table(), cup())
        stage.fake.grippers["right"].empty = True
        stage.play(stage.pick())
        return [repr(event) for event in stage.events]

    assert events() == events()
