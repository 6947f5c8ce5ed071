"""Putting things into bowls, drawers and fridges, and what is never claimed to be in there."""

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.requests.pick import PickRequest
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import bowl, cup, table
from robots.perception.truth_view import TrueObject
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from tests.trees.cabinet_seen import CABINET, shown
from tests.trees.household_stage import RED_CUP, asked, run
from trees.beliefs.scene.held_object import HeldObject
from trees.events import LeafFailed
from trees.failures import FailureKind, Reason
from trees.skills.put_in.find_container import FindContainer
from trees.tasks import DescribeTask, ObjectDescription, PutInTask, Relation


def test_a_cup_is_put_into_a_bowl(stage_with):
    stage = stage_with(table(), cup(), bowl())

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    off = stage.fake.world.object("red cup").world_T_object[:2, 3] - (0.45, 0.2)
    assert tree.status == "success"
    assert float(np.linalg.norm(off)) <= 0.10


def test_a_neighbour_that_was_pushed_while_putting_in_is_told(stage_with):
    stage = stage_with(table(), cup(), bowl(), cup("blue cup", "blue", (0.5, -0.4)))
    stage.when("clear the view", lambda: stage.fake.world.move("blue cup", (0.0, -0.03, 0.0)))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "the blue cup was moved" in tree.failure.message


HELD = HeldObject("red cup", "right", Cylinder(0.03, 0.11), np.eye(4))


@pytest.mark.parametrize("remembered", [True, False])
def test_a_bowl_that_no_look_shows_is_taken_to_be_where_it_was_as_a_last_resort(stage_with, remembered):
    stage = stage_with(table(), bowl())
    beside = poses.translation(-0.1, 1.4, 0.93)
    stage.told.update(stage.told.scene.with_object(SceneObject("red bowl", Cylinder(0.1, 0.07), beside)))
    leaf = FindContainer("find it", stage.toolbox, remembered=remembered)
    task = PutInTask("put it in", RED_CUP, ObjectDescription("bowl", "red"))

    status = stage.run(leaf, task=task, held=HELD)

    if remembered:
        assert status is Status.SUCCESS
        assert stage.output("place").name == "red bowl"
        assert stage.output("spots")[0].world_T_object[:2, 3] == pytest.approx(beside[:2, 3])
    else:
        assert leaf.failure.reason is Reason.OUT_OF_VIEW


def test_of_two_bowls_that_no_look_shows_none_is_taken(stage_with):
    stage = stage_with(table())
    bowls = [
        SceneObject(name, Cylinder(0.1, 0.07), poses.translation(x, 1.4, 0.93))
        for name, x in (("red bowl", -0.1), ("red bowl 2", -0.5))
    ]
    stage.told.update(stage.told.scene.with_objects([*stage.told.scene.objects.values(), *bowls]))
    leaf = FindContainer("find it", stage.toolbox, remembered=True)
    task = PutInTask("put it in", RED_CUP, ObjectDescription("bowl", "red"))

    assert stage.run(leaf, task=task, held=HELD) is Status.FAILURE


def test_a_cup_that_is_nowhere_to_be_seen_is_not_claimed_to_be_in_the_bowl(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.hidden.add("red cup"))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "is not seen in the white bowl" in tree.failure.message


def test_what_a_wall_hides_is_seen_from_above(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.hidden.add("red cup"))
    stage.when("lean over it", stage.fake.world.hidden.clear)

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "success"


@pytest.mark.requirement("M2")
def test_a_cup_that_stands_on_top_of_the_bowl_is_not_claimed_to_be_in_it(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (0.0, 0.0, 0.07)))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "the red cup stands on the white bowl, not in it" in [
        event.failure.message for event in stage.events if isinstance(event, LeafFailed)
    ]


def test_a_cup_that_falls_beside_the_bowl_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (0.0, -0.25, 0.0)))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "beside" in tree.failure.message


def chest(opening_m):
    """A chest of drawers ahead, its drawer out so far, as the truth has it."""
    (piece,) = load_scene("drawers").furniture
    fixed = [
        TrueObject(solid.name, "furniture", piece.kind, None, solid.shape, solid.world_T_solid)
        for solid in solids(piece)
    ]
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening_m)
    moving = [
        TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, part @ solid.part_T_solid)
        for solid in moving_solids(piece)
        if solid.kind
    ]
    return *fixed, *moving


ON_THE_CHEST = cup(place_m=(0.85, 0.33), table_height_m=1.05)


def test_a_cup_is_put_into_an_open_drawer(stage_with):
    stage = stage_with(*chest(0.3), ON_THE_CHEST)

    tree = run(stage, PutInTask("put the red cup in the drawer", RED_CUP, "drawer"))

    place = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert tree.status == "success"
    assert tree.evidence["in"] == "drawer"
    assert 0.45 < place[0] < 0.72
    assert 0.2 < place[1] < 0.56


@pytest.mark.parametrize(("place", "is_open"), [("bottom", True), ("top", False)])
def test_a_cup_is_put_into_the_drawer_that_is_said_if_that_one_is_open(stage_with, place, is_open):
    stage = stage_with(*shown(CABINET, bottom_drawer=0.13), cup(place_m=(0.69, -0.27), table_height_m=1.285))
    to = ObjectDescription("drawer", ordinal=place, relation=Relation("in", "cabinet"))

    tree = run(stage, PutInTask("put it in", RED_CUP, to))

    front = next(one for one in shown(CABINET) if one.name == "cabinet/bottom drawer/front")
    away = stage.fake.world.object("red cup").world_T_object[:2, 3] - front.world_T_object[:2, 3]
    assert tree.status == ("success" if is_open else "failure")
    assert bool(np.linalg.norm(away) < 0.12) is is_open


@pytest.mark.requirement("F1")
def test_a_shut_drawer_is_told_before_anything_is_picked_up(stage_with):
    stage = stage_with(*chest(0.0), ON_THE_CHEST)

    tree = run(stage, PutInTask("put the red cup in the drawer", RED_CUP, "drawer"))

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "the drawer is shut: open it first" in tree.failure.message
    assert not asked(stage, PickRequest)


def fridge(opening_rad):
    """A fridge ahead to the left, its door so far open, as the truth has it; and a table to the right."""
    (piece,) = load_scene("fridge").furniture
    fixed = [
        TrueObject(solid.name, "furniture", piece.kind, None, solid.shape, solid.world_T_solid)
        for solid in solids(piece)
    ]
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening_rad)
    moving = [
        TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, part @ solid.part_T_solid)
        for solid in moving_solids(piece)
        if solid.kind
    ]
    return *fixed, *moving


@pytest.mark.requirement("M3")
def test_a_cup_is_put_on_a_board_of_an_open_fridge(stage_with):
    stage = stage_with(*fridge(1.25), table(), cup())

    tree = run(stage, PutInTask("put the red cup in the fridge", RED_CUP, "fridge"))

    place = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert tree.status == "success"
    assert tree.evidence["on"].startswith("fridge")
    assert place[2] == pytest.approx(0.65 * 1.70 + 0.01 + 0.055, abs=0.02)


@pytest.mark.parametrize(("opening_rad", "status"), [(0.0, "failure"), (1.25, "success")])
def test_what_is_in_a_shut_fridge_is_not_told(stage_with, opening_rad, status):
    stage = stage_with(*fridge(opening_rad), table(), cup())

    tree = run(stage, DescribeTask("what is in the fridge?", source="fridge"))

    assert tree.status == status
    told = tree.evidence["said"] if status == "success" else tree.failure.message
    assert ("in the fridge I see" if status == "success" else "the fridge is shut: open it first") in told


@pytest.mark.requirement("F1")
def test_a_shut_fridge_is_told_before_anything_is_picked_up(stage_with):
    stage = stage_with(*fridge(0.0), table(), cup())

    tree = run(stage, PutInTask("put the red cup in the fridge", RED_CUP, "fridge"))

    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "the fridge is shut: open it first" in tree.failure.message
    assert not asked(stage, PickRequest)


def test_a_cup_that_falls_off_its_board_is_not_claimed_to_be_in_the_fridge(stage_with):
    stage = stage_with(*fridge(1.25), table(), cup())
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (-0.2, 0.0, -0.4)))

    tree = run(stage, PutInTask("put the red cup in the fridge", RED_CUP, "fridge"))

    assert tree.status == "failure"


def test_a_cup_that_lies_on_the_chest_afterwards_is_not_claimed_to_be_in_the_drawer(stage_with):
    stage = stage_with(*chest(0.3), ON_THE_CHEST)
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.2)))

    tree = run(stage, PutInTask("put the red cup in the drawer", RED_CUP, "drawer"))

    assert tree.status == "failure"
    assert "red cup" in tree.failure.message
