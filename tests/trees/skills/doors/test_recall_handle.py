"""What was seen before, and is far away, is gone back to for opening or closing; the near is looked at."""

from dataclasses import replace

import pytest
from py_trees.common import Status

from kinematics.geometry.poses import rotation_z, transform, translation
from kinematics.scene.planning_scene import SceneObject
from robots.scenes.articulated import HANDLE, furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.skills.doors.recall_handle import RecallHandle
from trees.tasks import CloseTask, ObjectDescription

FAR_M = 3.0


def seen_once(scene, x_m, y_m, opening, but=()):
    """What a look would have left in the world model of a fridge or chest, with its door or drawer open."""
    piece = replace(load_scene(scene).furniture[0], position_m=(x_m, y_m))
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening)
    things = [(piece.kind, solid.shape, solid.world_T_solid) for solid in solids(piece)]
    things += [(one.kind, one.shape, part @ one.part_T_solid) for one in moving_solids(piece) if one.kind]
    return [(kind, shape, pose) for kind, shape, pose in things if kind not in but]


@pytest.fixture
def recall(stage):
    def run(things, *, pushed=False, **said):
        numbers = {}
        known = []
        for kind, shape, pose in things:
            numbers[kind] = numbers.get(kind, 0) + 1
            name = kind if numbers[kind] == 1 else f"{kind} {numbers[kind]}"
            known.append(SceneObject(name, shape, pose, 0.0, movable=False))
        stage.told.update(stage.told.scene.with_objects(known))
        leaf = RecallHandle("recall it", stage.toolbox, pushed)
        status = stage.run(leaf, task=CloseTask("close it", ObjectDescription(**said)))
        return stage.output("handle") if status is Status.SUCCESS else leaf.failure

    return run


def test_a_drawer_that_is_far_away_is_gone_back_to(recall):
    handle = recall(seen_once("drawers", FAR_M, 0.5, 0.2), kind="drawer")

    assert handle.kind == "drawer"
    assert handle.opening == pytest.approx(0.2, abs=0.02)
    assert handle.path.closed_m[0] == pytest.approx(FAR_M, abs=0.6)


def test_what_is_near_is_looked_at_from_here(recall):
    failure = recall(seen_once("drawers", 1.1, 0.0, 0.2), kind="drawer")

    assert "near enough" in failure.message


@pytest.mark.parametrize("away_rad", [1.3, 3.1, -2.0])
def test_what_the_robot_stands_before_with_its_back_to_it_is_gone_back_to(recall, away_rad):
    turn = transform(rotation_z(away_rad), (0.0, 0.0, 0.0))
    things = [(kind, shape, turn @ pose) for kind, shape, pose in seen_once("drawers", 1.1, 0.0, 0.2)]

    assert recall(things, kind="drawer").part == "drawer"


def test_a_door_whose_handle_was_not_seen_can_be_pushed_but_not_pulled(recall):
    things = seen_once("fridge", FAR_M, 0.0, 1.2, but=(HANDLE,))

    assert recall(things, pushed=True, kind="fridge").pushed
    assert "no fridge was seen before" in recall(things, kind="fridge").message


def test_what_was_never_seen_is_not_recalled(recall):
    assert "no drawer was seen before" in recall([], kind="drawer").message
    assert "no fridge was seen" in recall(seen_once("drawers", FAR_M, 0.5, 0.2), kind="fridge").message


def test_of_two_the_one_that_was_said_is_gone_back_to(recall):
    two = [*seen_once("drawers", FAR_M, 0.9, 0.0), *seen_once("drawers", FAR_M, -0.9, 0.0)]

    assert recall(two, kind="drawer", ordinal="leftmost").path.closed_m[1] > 0.5
    assert recall(two, kind="drawer", ordinal="rightmost").path.closed_m[1] < -0.5


def test_which_of_two_was_meant_is_asked_where_they_are_seen(recall):
    two = [*seen_once("drawers", FAR_M, 0.9, 0.2), *seen_once("drawers", FAR_M, -0.9, 0.2)]

    assert not recall(two, kind="drawer").choices


def test_of_two_the_open_one_is_closed(recall):
    two = [*seen_once("drawers", FAR_M, 0.9, 0.0), *seen_once("drawers", FAR_M, -0.9, 0.2)]

    assert recall(two, kind="drawer").path.closed_m[1] < -0.5


def test_what_is_far_to_the_side_is_gone_back_to(recall):
    moved = [
        (kind, shape, translation(0.0, 2.5, 0.0) @ pose)
        for kind, shape, pose in seen_once("drawers", 1.1, 0.0, 0.0)
    ]

    assert recall(moved, kind="drawer").part == "drawer"
