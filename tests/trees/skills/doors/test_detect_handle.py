"""Which of several doors or drawers a task means is said by the task, or asked."""

from dataclasses import replace

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.fake.fake_world import cup
from robots.perception.truth_view import TrueObject
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.failures import FailureKind
from trees.skills.doors.choose_handle import ChooseHandle
from trees.skills.doors.detect_handle import DetectHandle
from trees.tasks import ObjectDescription, OpenTask, Relation

LEFT_M, RIGHT_M = 0.45, -0.35
CABINET_POSE = poses.translation(1.0, -0.3, 0.9)


def chest(y_m):
    """What the truth has of a chest of drawers that stands so far to the left, its drawer shut."""
    piece = replace(load_scene("drawers").furniture[0], position_m=(1.1, y_m))
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, 0.0)
    parts = [(piece.kind, solid.shape, solid.world_T_solid) for solid in solids(piece)]
    parts += [
        (solid.kind, solid.shape, part @ solid.part_T_solid) for solid in moving_solids(piece) if solid.kind
    ]
    return [
        TrueObject(f"{kind} {i} at {y_m}", "furniture", kind, None, shape, pose)
        for i, (kind, shape, pose) in enumerate(parts)
    ]


def detect(stage, wanted):
    leaf = DetectHandle("detect handle", stage.toolbox)
    status = stage.run(leaf, task=OpenTask("open it", wanted))
    return leaf, status


@pytest.fixture
def two(stage_with):
    return stage_with(cup(place_m=(1.0, 0.05)), *chest(LEFT_M), *chest(RIGHT_M))


@pytest.mark.parametrize(
    ("said", "y_m"),
    [
        ({"ordinal": "leftmost"}, LEFT_M),
        ({"ordinal": "rightmost"}, RIGHT_M),
        ({"relation": Relation("left_of", ObjectDescription("cup"))}, LEFT_M),
    ],
)
def test_the_one_that_was_said_is_opened(two, said, y_m):
    _, status = detect(two, ObjectDescription("drawer", **said))

    assert status is Status.SUCCESS
    assert two.place_y(two.output("handle").part) == pytest.approx(y_m, abs=0.05)


def test_one_of_two_is_asked_for_and_the_answer_means_it_after_another_look(two):
    leaf, status = detect(two, ObjectDescription("drawer"))

    assert status is Status.FAILURE
    assert leaf.failure.numbers["count"] == 2
    assert leaf.failure.choices == ("left drawer", "right drawer")
    for name in leaf.failure.choice_names:
        place_m = two.place_y(name)
        _, status = detect(two, ObjectDescription("drawer", name=name))
        assert status is Status.SUCCESS
        assert two.place_y(two.output("handle").part) == pytest.approx(place_m, abs=0.05)


def choose(stage, wanted):
    leaf = ChooseHandle("choose", stage.toolbox, pushed=False)
    return leaf, stage.run(leaf, task=OpenTask("open it", wanted))


@pytest.mark.requirement("M2", "L6")
def test_what_is_beside_the_first_one_is_chosen_among_as_well(two):
    _, status = detect(two, ObjectDescription("drawer", ordinal="rightmost"))
    assert status is Status.SUCCESS

    _, status = choose(two, ObjectDescription("drawer", ordinal="leftmost"))

    assert status is Status.SUCCESS
    assert two.place_y(two.output("handle").part) == pytest.approx(LEFT_M, abs=0.05)
    leaf, status = choose(two, ObjectDescription("drawer"))
    assert leaf.failure.choices == ("left drawer", "right drawer")


@pytest.mark.requirement("F1", "L5")
@pytest.mark.parametrize(
    ("said", "told"),
    [
        ({"ordinal": "rightmost"}, "only one drawer seen, and it is on the left"),
        ({"ordinal": "bottom"}, "only one drawer seen"),
        ({"ordinal": "second"}, "no second drawer seen"),
        ({"color": "blue"}, "which one is blue? that is not seen of what opens"),
        ({"material": "wood"}, "which one is made of wood? that cannot be seen"),
        ({"relation": Relation("in", "kitchen")}, "no kitchen seen"),
    ],
)
def test_no_word_about_the_only_one_is_dropped(stage_with, said, told):
    stage = stage_with(*chest(LEFT_M))
    _, status = detect(stage, ObjectDescription("drawer", **said))
    assert status is Status.SUCCESS

    leaf, status = choose(stage, ObjectDescription("drawer", **said))

    assert status is Status.FAILURE
    assert told in leaf.failure.message
    _, status = choose(stage, ObjectDescription("drawer", ordinal="leftmost"))
    assert status is Status.SUCCESS


@pytest.mark.requirement("M2")
def test_once_chosen_no_other_one_is_taken_for_it(two, stage_with):
    detect(two, ObjectDescription("drawer", ordinal="leftmost"))
    chosen = two.output("handle")
    alone = stage_with(*chest(RIGHT_M))
    leaf = DetectHandle("look again", alone.toolbox)

    status = alone.run(leaf, task=OpenTask("open it", ObjectDescription("drawer")), handle=chosen)

    assert status is Status.FAILURE
    assert leaf.failure.message == "the drawer that is meant is not seen from here"


@pytest.mark.requirement("F1")
@pytest.mark.parametrize("name", ["nobody", "fridge door"])
def test_what_has_another_name_is_not_opened(stage_with, name):
    leaf, status = detect(stage_with(*chest(LEFT_M)), ObjectDescription("drawer", name=name))

    assert status is Status.FAILURE
    assert leaf.failure.message == f"no {name} seen"


def test_whose_drawer_it_is_does_not_contradict_its_kind(stage_with):
    _, status = detect(stage_with(*chest(LEFT_M)), ObjectDescription("drawer", name="Ana's drawer"))

    assert status is Status.SUCCESS


def test_what_is_in_furniture_that_has_none_is_told_and_not_looked_for_elsewhere(stage_with):
    cabinet = TrueObject("wooden cabinet", "furniture", "fixture", None, Box((0.3, 0.4, 0.3)), CABINET_POSE)
    stage = stage_with(cup(place_m=(1.0, 0.05)), cabinet)

    said = ObjectDescription("drawer", relation=Relation("in", "cabinet"))
    leaf, _ = detect(stage, said)

    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert leaf.failure.message == "the wooden cabinet has no drawer that I can open or close"


def test_a_drawer_of_something_that_is_not_seen_may_be_elsewhere(stage_with):
    stage = stage_with(cup(place_m=(1.0, 0.05)))

    leaf, _ = detect(stage, ObjectDescription("drawer", relation=Relation("in", "cabinet")))

    assert leaf.failure.message == "no handle of a drawer seen"
