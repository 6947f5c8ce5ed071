"""What is known of the room in an open drawer."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.beliefs.openings.drawer_inside import (
    DrawerInside,
    inside_of_drawer,
    spots_in_drawer,
    without_drawn,
)
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, FailureKind

OPEN_M = 0.30
CUP = HeldObject("red cup", "left", Cylinder(0.03, 0.11), np.eye(4))


def known(opening_m, without=()):
    """The chest of the scene `drawers` as a perfect look would have it, its drawer out so far."""
    (piece,) = load_scene("drawers").furniture
    told = [(piece.kind, solid.shape, solid.world_T_solid) for solid in solids(piece)]
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening_m)
    told += [(solid.kind, solid.shape, part @ solid.part_T_solid) for solid in moving_solids(piece)]
    counts, scene = {}, PlanningScene()
    for kind, shape, pose in told:
        if kind and kind not in without:
            counts[kind] = counts.get(kind, 0) + 1
            name = kind if counts[kind] == 1 else f"{kind} {counts[kind]}"
            scene = scene.with_object(SceneObject(name, shape, pose, 0.015, movable=False))
    return scene


def test_the_room_is_between_front_and_chest_and_between_the_walls():
    inside = inside_of_drawer(known(OPEN_M))

    length, width, height = inside.size_m
    assert length == pytest.approx(OPEN_M + 0.01, abs=0.002)  # a gap closes with the front
    assert 0.34 < width < 0.38
    assert 0.14 < height < 0.17
    assert inside.odom_T_middle[:2, 3] == pytest.approx([0.73 - 0.5 * OPEN_M + 0.02, 0.38], abs=0.02)


@pytest.mark.parametrize("opening_m", [0.0, 0.03])
def test_a_shut_drawer_is_told_with_what_to_say_instead(opening_m):
    answer = inside_of_drawer(known(opening_m))

    assert isinstance(answer, Failure)
    assert answer.kind is FailureKind.INFEASIBLE
    assert "the drawer is shut: open it first" in answer.message


def test_a_drawer_that_nobody_looked_into_is_not_taken_for_shut():
    answer = inside_of_drawer(known(OPEN_M, without=("drawer bottom", "drawer wall")))

    assert isinstance(answer, Failure)
    assert answer.kind is FailureKind.POSTCONDITION
    assert "is not seen" in answer.message


def test_what_stands_on_its_bottom_is_in_it_and_what_lies_on_the_chest_is_not():
    inside = inside_of_drawer(known(OPEN_M))
    middle = inside.odom_T_middle[:3, 3]

    assert inside.holds(middle + np.array([0.0, 0.0, 0.05]))
    assert not inside.holds(middle + np.array([0.0, 0.0, 0.25]))
    assert not inside.holds(middle + np.array([0.25, 0.0, 0.05]))
    assert not inside.holds(middle + np.array([0.0, 0.25, 0.05]))


def test_the_foot_of_a_cup_goes_as_low_as_the_bottom_and_comes_in_over_the_front():
    inside = inside_of_drawer(known(OPEN_M))

    spots = spots_in_drawer(CUP, inside)

    floor_m = inside.odom_T_middle[2, 3]
    feet = [spot.world_T_object[2, 3] - 0.055 - floor_m for spot in spots]
    assert feet == sorted(feet)
    assert feet[0] == pytest.approx(0.005)
    for spot, foot in zip(spots, feet, strict=True):
        assert foot + spot.hover_m >= inside.size_m[2] + 0.02
        assert inside.holds(spot.world_T_object[:3, 3]) or foot > 0.05
        assert {"drawer", "drawer bottom", "drawer wall"} <= set(spot.touches)


def test_what_is_too_wide_has_no_spot():
    narrow = DrawerInside(poses.translation(0.5, 0.0, 0.9), (0.09, 0.4, 0.15), ("drawer",))

    assert spots_in_drawer(CUP, narrow) == ()


def test_what_stands_in_a_drawer_goes_along_with_it_and_what_lies_on_the_chest_does_not():
    scene = known(OPEN_M)
    middle = inside_of_drawer(scene).odom_T_middle[:3, 3]
    inside, on_top = middle + np.array([0.0, 0.0, 0.06]), middle + np.array([0.4, 0.0, 0.3])
    things = [SceneObject("red can", Cylinder(0.03, 0.11), poses.translation(*inside))]
    things.append(SceneObject("blue can", Cylinder(0.03, 0.11), poses.translation(*on_top)))

    left = without_drawn(scene.with_objects([*scene.objects.values(), *things])).objects

    assert "red can" not in left
    assert "blue can" in left
    assert not [name for name in left if name.startswith(("drawer bottom", "drawer wall"))]
    assert [name for name in left if name.startswith("drawer")]
