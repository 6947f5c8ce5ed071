"""What a look at a door or drawer tells of the way of its handle."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.opening_path import DoorArc
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.beliefs.openings.handles import handles_in, opening_in

HINGE = np.array([0.8, 0.75])


def estimate(kind, shape, pose):
    return ObjectEstimate("furniture", kind, None, pose, shape, 0.9, 8, 0.0)


def seen(scene_name, opening=0.0):
    """A perfect look at a scene's furniture, opened so far."""
    (piece,) = load_scene(scene_name).furniture
    world = floor_pose(piece)
    found = {
        f"{piece.kind} {i}": estimate(piece.kind, solid.shape, solid.world_T_solid)
        for i, solid in enumerate(solids(piece), start=2)
    }
    part = world @ furniture_T_part(piece) @ opened(piece, opening)
    for solid in moving_solids(piece):
        if solid.kind:
            found[solid.kind] = estimate(solid.kind, solid.shape, part @ solid.part_T_solid)
    return found


@pytest.mark.parametrize("opening", [0.0, 0.6, 1.2])
def test_a_door_is_known_with_its_hinge_its_side_and_its_angle(opening):
    (target,) = handles_in(seen("fridge", opening))

    assert isinstance(target.path, DoorArc)
    assert target.opening == pytest.approx(opening, abs=1e-9)
    assert target.hands == ("left",)
    assert target.path.hinge_m == pytest.approx(HINGE, abs=0.02)


def test_the_way_of_an_open_door_leads_back_to_where_its_handle_was():
    (closed,) = handles_in(seen("fridge"))
    (half_open,) = handles_in(seen("fridge", 0.8))

    assert half_open.path.at(0.0).position_m == pytest.approx(closed.path.at(0.0).position_m, abs=1e-9)


@pytest.mark.parametrize("opening", [0.0, 0.15, 0.3])
def test_a_drawer_is_known_with_how_far_it_is_out(opening):
    (target,) = handles_in(seen("drawers", opening))

    assert target.opening == pytest.approx(opening, abs=1e-9)
    assert target.path.at(0.0).outward == pytest.approx([-1.0, 0.0, 0.0], abs=1e-9)


def test_a_front_without_its_body_tells_no_opening():
    only_the_door = [item for item in seen("fridge").values() if item.kind == "door"]

    assert opening_in(only_the_door, "door") is None
    assert opening_in(seen("fridge", 0.5).values(), "door") == pytest.approx(0.5)


def test_a_handle_far_from_any_front_is_not_one_of_a_door():
    found = seen("fridge")
    bar = found["handle"]
    found["handle"] = estimate("handle", bar.shape, poses.translation(-2.0, 0.0, 1.0))

    assert handles_in(found) == []


def test_the_hinge_is_on_the_side_away_from_the_handle():
    found = seen("fridge")
    door, bar = found["door"], found["handle"]
    assert isinstance(door.shape, Box)
    left = door.odom_T_object[:3, 1]
    moved = bar.odom_T_object.copy()
    moved[:3, 3] += 2.0 * ((door.odom_T_object[:3, 3] - moved[:3, 3]) @ left) * left
    found["handle"] = estimate("handle", bar.shape, moved)

    (target,) = handles_in(found)

    assert target.hands == ("right",)
    assert math.copysign(1.0, target.path.side) == -1.0


def test_the_hand_for_a_drawer_is_on_its_side_wherever_the_robot_stands():
    found = seen("drawers")
    x, y = found["handle"].odom_T_object[:2, 3]

    hands = {side: handles_in(found, PlanarPose(x - 0.7, y + side * 0.3))[0].hands[0] for side in (-1.0, 1.0)}

    assert hands == {-1.0: "left", 1.0: "right"}
