import numpy as np
import pytest
from py_trees.common import Status

from robots.fake.fake_world import cup, table
from trees.beliefs.sight.sight import in_view
from trees.failures import FailureKind
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.looking.detect import Detect
from trees.skills.looking.look_at import LookAt
from trees.tasks import ObjectDescription, PickTask

RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
A_CUP = PickTask("pick up the cup", ObjectDescription("cup"))


def looking_down(stage):
    """Detect, with a head that looks at the table."""
    stage.run(LookAt("look", stage.toolbox, Gaze("ahead", 0.75)))
    return Detect("detect", stage.toolbox)


@pytest.mark.requirement("M1")
def test_the_object_that_is_meant_is_found_and_everything_is_remembered(stage):
    assert stage.run(looking_down(stage), task=RED_CUP) is Status.SUCCESS

    found = stage.output("target")
    assert (found.name, found.kind, found.color) == ("red cup", "cup", "red")
    assert found.odom_T_object[:3, 3] == pytest.approx((0.45, -0.2, 0.955), abs=1e-9)
    assert set(stage.told.scene.objects) == {"red cup", "table"}


def test_nothing_that_fits_says_what_was_seen_instead(stage_with):
    stage = stage_with(table(), cup("blue cup", "blue"))
    leaf = looking_down(stage)

    assert stage.run(leaf, task=RED_CUP) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.POSTCONDITION
    assert leaf.failure.message == "no red cup seen"
    assert leaf.failure.numbers["seen"] == "blue cup, table"


def test_several_that_fit_are_told_as_choices_from_the_left(stage_with):
    stage = stage_with(table(), cup(place_m=(0.5, -0.15)), cup("blue cup", "blue", (0.5, 0.15)))
    leaf = looking_down(stage)

    assert stage.run(leaf, task=A_CUP) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert leaf.failure.message == "which cup? there are 2"
    assert leaf.failure.numbers["choices"] == "blue cup | red cup"


def test_twins_are_told_apart_by_their_places(stage_with):
    stage = stage_with(table(), cup("a", place_m=(0.5, -0.15)), cup("b", place_m=(0.5, 0.15)))
    leaf = looking_down(stage)

    stage.run(leaf, task=RED_CUP)

    assert leaf.failure.choices == ("left red cup", "right red cup")
    assert [stage.place_y(name) > 0 for name in leaf.failure.choice_names] == [True, False]


def test_a_twin_that_was_seen_before_and_is_out_of_view_now_still_counts(stage_with):
    stage = stage_with(table(), cup("a", place_m=(0.5, -0.15)), cup("b", place_m=(0.5, 0.15)))
    stage.run(looking_down(stage), task=RED_CUP)
    left, right = "left red cup", "right red cup"
    leaf = Detect("detect", stage.toolbox)
    stage.run(LookAt("look", stage.toolbox, Gaze("far left", 0.75, pan_rad=1.0)))

    assert stage.run(leaf, task=RED_CUP) is Status.FAILURE
    assert leaf.failure.choices == (left, right)


@pytest.mark.requirement("M4")
def test_what_only_an_earlier_look_showed_is_no_target_of_a_look_on_its_own(stage):
    assert stage.run(looking_down(stage), task=RED_CUP) is Status.SUCCESS
    leaf = Detect("detect", stage.toolbox)
    stage.run(LookAt("look", stage.toolbox, Gaze("far left", 0.75, pan_rad=1.2)))

    assert stage.run(leaf, task=RED_CUP) is Status.FAILURE
    assert leaf.failure.message == "the red cup was seen before, but is not in view now"


def test_of_both_objects_the_nearer_is_the_target_and_the_other_is_left_for_later(stage_with):
    stage = stage_with(table(), cup("a", place_m=(0.5, -0.15)), cup("b", place_m=(0.45, 0.15)))
    leaf = looking_down(stage)
    both = PickTask("pick up both cups", ObjectDescription("cup"), count="both")

    assert stage.run(leaf, task=both) is Status.SUCCESS
    assert stage.place_y(stage.output("target").name) > 0
    assert [stage.place_y(name) > 0 for name in stage.output("others")] == [False]


@pytest.mark.requirement("S6")
def test_an_object_whose_table_was_not_seen_is_not_gone_for(stage):
    stage.fake.world.hidden.add("table")
    leaf = looking_down(stage)

    assert stage.run(leaf, task=RED_CUP) is Status.FAILURE
    assert leaf.failure.message == "what the red cup stands on is not seen"


def test_an_object_on_the_floor_is_refused_as_such_and_not_looked_for_elsewhere(stage_with):
    stage = stage_with(table(), cup(place_m=(1.3, -0.9), table_height_m=0.0))
    stage.run(LookAt("look", stage.toolbox, Gaze("to the right", 0.75, -0.6)))
    leaf = Detect("detect", stage.toolbox)

    assert stage.run(leaf, task=RED_CUP) is Status.FAILURE
    assert leaf.failure.message == "the red cup is on the floor; hands take only what is on furniture"
    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert looking_elsewhere_is_useless(leaf.failure)


def test_an_object_on_other_furniture_than_asked_for_does_not_fit(stage):
    leaf = looking_down(stage)
    task = PickTask("pick the red cup from the shelf", ObjectDescription("cup", "red"), source="shelf")

    assert stage.run(leaf, task=task) is Status.FAILURE
    assert leaf.failure.message == "a red cup is seen, but not on the shelf"


def test_an_object_on_the_furniture_asked_for_fits(stage):
    leaf = looking_down(stage)
    task = PickTask("pick the red cup from the table", ObjectDescription("cup", "red"), source="table")

    assert stage.run(leaf, task=task) is Status.SUCCESS


def test_frames_from_before_the_look_do_not_count(stage):
    leaf = looking_down(stage)
    stage.fake.detector.frozen = True

    assert stage.run(leaf, task=RED_CUP) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.TIMEOUT


def test_what_a_hand_holds_does_not_become_an_obstacle(stage):
    leaf = looking_down(stage)
    stage.run(leaf, task=RED_CUP)
    stage.told.update(stage.told.scene.with_attached("red cup", "tcp_right", np.eye(4), []))
    hand = stage.toolbox.model.frame_pose(stage.fake.sensing.state().q, "tcp_right")
    place = hand[:3, 3] - stage.fake.world.object("red cup").world_T_object[:3, 3]
    stage.fake.world.move("red cup", tuple(place))
    looked = Detect("detect", stage.toolbox)
    stage.fake.detector.offset_m = {}

    stage.run(looked, task=RED_CUP)

    assert "red cup" not in stage.told.scene.objects


def cut_off(stage, name, toward):
    """Turn the head until a cup's middle is in the picture, and its edge is not."""
    model, item = stage.toolbox.model, stage.told.scene.objects[name]
    middle = item.world_T_object[:3, 3]
    for pan in np.arange(0.0, 1.0, 0.02):
        for aim in (-0.5, toward * float(pan)):  # a small turn alone would be left out
            stage.run(LookAt("look", stage.toolbox, Gaze("aside", 0.75, pan_rad=aim)))
        eye = model.frame_pose(stage.fake.motion.reference(), model.description.camera.frame)
        edge = middle - (0.0, toward * 0.015, 0.0)
        if in_view(model.description.camera, eye, middle) and not in_view(
            model.description.camera, eye, edge
        ):
            return
    raise AssertionError("it never was at the edge")


@pytest.mark.requirement("L6")
@pytest.mark.parametrize("part", ["side", "last"])
def test_a_twin_that_the_pictures_edge_cuts_off_is_not_forgotten(stage_with, part):
    stage = stage_with(table(), cup("a", place_m=(0.5, -0.15)), cup("b", place_m=(0.5, 0.15)))
    stage.run(looking_down(stage), task=RED_CUP)
    left, right = sorted(("red cup", "red cup 2"), key=stage.place_y, reverse=True)
    cut_off(stage, right, toward=1.0)
    stage.fake.world.hidden.add("a")
    stage.fake.step()

    stage.run(Detect("detect", stage.toolbox, part=part), task=RED_CUP)

    assert {left, right} <= set(stage.told.scene.objects)


def test_what_would_be_seen_and_is_not_is_forgotten(stage_with):
    stage = stage_with(table(), cup("a", place_m=(0.5, -0.15)), cup("b", place_m=(0.5, 0.15)))
    stage.run(looking_down(stage), task=RED_CUP)
    right = min(("red cup", "red cup 2"), key=stage.place_y)
    stage.fake.world.hidden.add("a")
    stage.fake.step()

    stage.run(Detect("detect", stage.toolbox), task=RED_CUP)

    assert right not in stage.told.scene.objects
