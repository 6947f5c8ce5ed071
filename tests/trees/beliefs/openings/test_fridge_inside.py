"""What is known of the boards behind a door, and of the room on them."""

import dataclasses

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.beliefs.openings.fridge_inside import (
    door_opening_rad,
    front_of,
    hinge_hand,
    inside_of_fridge,
    is_behind_door,
    spots_in_fridge,
    spots_in_sight,
)
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.sight.sight import Glimpse
from trees.beliefs.sight.sight_of_tops import SightOfTops
from trees.failures import Failure, FailureKind
from trees.tasks import ObjectDescription

CAN = HeldObject("green can", "left", Cylinder(0.03, 0.12), np.eye(4))
(PIECE,) = load_scene("fridge").furniture
OPEN_RAD = np.radians(70.0)
# Of the scene's fridge: its boards' upper sides, and the middle of their front edge.
UPPER_M, LOWER_M = 0.65 * 1.70 + 0.01, 0.40 * 1.70 + 0.01
EDGE = floor_pose(PIECE) @ poses.translation(-0.27, 0.0, UPPER_M)


def known(opening_rad, without=lambda name: False):
    """The fridge of the scene `fridge` as a perfect look would have it, its door so far open."""
    told = [(solid.name, PIECE.kind, solid.shape, solid.world_T_solid) for solid in solids(PIECE)]
    part = floor_pose(PIECE) @ furniture_T_part(PIECE) @ opened(PIECE, opening_rad)
    told += [(one.name, one.kind, one.shape, part @ one.part_T_solid) for one in moving_solids(PIECE)]
    counts, scene = {}, PlanningScene()
    for solid, kind, shape, pose in told:
        if kind and not without(solid):
            counts[kind] = counts.get(kind, 0) + 1
            name = kind if counts[kind] == 1 else f"{kind} {counts[kind]}"
            scene = scene.with_object(SceneObject(name, shape, pose, 0.015, movable=False))
    return scene


def feet(spots):
    return [spot.world_T_object[:3, 3] - (0.0, 0.0, 0.06) for spot in spots]


def test_the_boards_are_neither_lid_nor_walls_and_the_one_at_elbow_height_comes_first():
    boards = inside_of_fridge(known(OPEN_RAD)).boards

    tops = [float(board.world_T_object[2, 3]) + 0.5 * board.shape.height_m for board in boards]
    assert tops == pytest.approx([UPPER_M, LOWER_M])


def test_the_upper_board_is_no_lid_when_the_lid_was_never_seen():
    boards = inside_of_fridge(known(OPEN_RAD, without=lambda solid: solid.endswith("/top"))).boards

    assert len(boards) == 2


def test_the_front_edge_is_on_the_side_of_the_door():
    board = inside_of_fridge(known(OPEN_RAD)).boards[0]

    np.testing.assert_allclose(front_of(board), EDGE, atol=1e-9)


@pytest.mark.parametrize("opening_rad", [0.0, np.radians(30.0)])
def test_a_door_that_is_in_the_way_is_told_with_what_to_say_instead(opening_rad):
    answer = inside_of_fridge(known(opening_rad))

    assert isinstance(answer, Failure)
    assert answer.kind is FailureKind.INFEASIBLE
    assert "the fridge is shut: open it first" in answer.message
    assert door_opening_rad(known(opening_rad)) == pytest.approx(opening_rad)


def test_a_fridge_that_nobody_looked_into_is_not_taken_for_shut():
    answer = inside_of_fridge(known(OPEN_RAD, without=lambda solid: "shelf" in solid))

    assert answer.kind is FailureKind.POSTCONDITION
    assert "is not seen" in answer.message


def test_the_hand_beside_the_hinge_reaches_past_an_open_door():
    assert hinge_hand(known(OPEN_RAD)) == PIECE.opens.hinge == "left"
    assert hinge_hand(PlanningScene()) is None


def test_spots_are_on_the_boards_near_their_front_clear_of_the_walls():
    scene = known(OPEN_RAD)

    spots = spots_in_fridge(CAN, inside_of_fridge(scene), scene)

    assert {spot.touches for spot in spots[:12]} == {(inside_of_fridge(scene).boards[0].name,)}
    for foot in feet(spots):
        deep, aside, _ = (poses.inverse(EDGE) @ np.append(foot, 1.0))[:3]
        assert 0.06 <= deep <= 0.25
        assert abs(aside) <= 0.5 * 0.56 - 0.03 - 0.05
        assert foot[2] == pytest.approx(UPPER_M) or foot[2] == pytest.approx(LOWER_M)


def test_nothing_is_put_where_something_stands_on_the_same_board():
    stands = EDGE @ poses.translation(0.10, 0.0, 0.08)
    bottle = SceneObject("black bottle", Cylinder(0.035, 0.16), stands, 0.01)
    scene = known(OPEN_RAD).with_object(bottle)

    spots = spots_in_fridge(CAN, inside_of_fridge(scene), scene)

    away = [np.linalg.norm(foot[:2] - stands[:2, 3]) for foot in feet(spots) if foot[2] > 1.0]
    assert away
    assert min(away) >= 0.03 + 0.035 + 0.05
    below = [np.linalg.norm(foot[:2] - stands[:2, 3]) for foot in feet(spots) if foot[2] < 1.0]
    assert min(below) < 0.05


def looking(eye_m, camera):
    """A look from a place into the fridge."""
    ahead = EDGE[:3, 3] + (0.15, 0.0, 0.0) - np.array(eye_m)
    z = ahead / np.linalg.norm(ahead)
    x = np.cross(z, (0.0, 0.0, 1.0))
    x /= np.linalg.norm(x)
    pose = np.eye(4)
    pose[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    pose[:3, 3] = eye_m
    return SightOfTops((Glimpse(pose, ()),), camera, 0.10)


def test_only_what_was_looked_at_is_free_and_a_board_hides_the_one_below(model):
    scene, camera = known(OPEN_RAD), model.description.camera
    inside = inside_of_fridge(scene)

    assert not spots_in_fridge(CAN, inside, scene, SightOfTops((), camera, 0.10))
    seen = spots_in_fridge(CAN, inside, scene, looking((0.75, 0.42, 1.65), camera))

    assert seen
    assert {spot.touches for spot in seen} == {(inside.boards[0].name,)}


def test_who_stands_beside_the_door_sees_no_spot_behind_the_wall_on_that_side():
    scene = known(OPEN_RAD)
    spots = spots_in_fridge(CAN, inside_of_fridge(scene), scene)
    eye = (EDGE @ [-0.5, -0.8, 0.5, 1.0])[:3]

    seen = spots_in_sight(spots, CAN, scene, eye)

    aside = [(poses.inverse(EDGE) @ np.append(foot, 1.0))[1] for foot in feet(seen)]
    assert seen
    assert len(seen) < len(spots)
    assert min(aside) > -0.1


def test_what_stands_in_the_line_of_sight_leaves_the_place_behind_it_unknown(model):
    camera = model.description.camera
    wall = SceneObject(
        "board", dataclasses.replace(CAN.shape, radius_m=0.25), poses.translation(0.5, 0.35, 1.4)
    )
    scene = known(OPEN_RAD).with_object(wall)

    assert not spots_in_fridge(CAN, inside_of_fridge(scene), scene, looking((0.1, 0.2, 1.65), camera))


@pytest.mark.parametrize(
    ("to", "behind"),
    [
        ("fridge", True),
        (ObjectDescription("fridge"), True),
        ("drawer", False),
        (ObjectDescription("bowl"), False),
    ],
)
def test_only_what_has_a_door_is_put_behind_one(to, behind):
    assert is_behind_door(to) is behind
