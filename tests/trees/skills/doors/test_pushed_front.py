"""What a look at an open door tells of where to push it, with its handle out of sight."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.beliefs.openings.handles import handles_in
from trees.skills.doors.pushed_front import fronts_in, with_known_bars


def estimate(kind, shape, pose):
    return ObjectEstimate("furniture", kind, None, pose, shape, 0.9, 8, 0.0)


def seen(opening, without=(), scene="fridge"):
    """A perfect look at the fridge, with its door opened so far, or at another piece."""
    (piece,) = load_scene(scene).furniture
    found = {
        f"{piece.kind} {i}": estimate(piece.kind, solid.shape, solid.world_T_solid)
        for i, solid in enumerate(solids(piece), start=2)
    }
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening)
    for solid in moving_solids(piece):
        if solid.kind and solid.kind not in without:
            found[solid.kind] = estimate(solid.kind, solid.shape, part @ solid.part_T_solid)
    return found


@pytest.mark.parametrize("opening", [0.2, 0.4, 0.9, 1.25])
def test_a_door_is_known_by_its_front_as_by_its_handle(opening):
    (by_handle,) = handles_in(seen(opening))
    (by_front,) = fronts_in(seen(opening, without=("handle",)))

    assert isinstance(by_front.path, DoorArc)
    assert by_front.opening == pytest.approx(opening, abs=1e-9)
    assert by_front.hands == by_handle.hands
    assert by_front.pushed
    assert by_front.handle == by_front.part, "the bar was not seen"
    assert by_front.path.hinge_m == pytest.approx(by_handle.path.hinge_m, abs=0.02)
    assert by_front.path.closed_yaw_rad == pytest.approx(by_handle.path.closed_yaw_rad, abs=1e-9)


def test_a_bar_that_is_seen_is_remembered_with_the_front():
    (target,) = fronts_in(seen(0.9))

    assert target.handle == "handle"


def test_a_panel_that_is_seen_the_wrong_way_round_is_the_same_door():
    look = seen(0.9, without=("handle",))
    turned = look["door"].odom_T_object @ np.diag([-1.0, -1.0, 1.0, 1.0])
    look["door"] = estimate("door", look["door"].shape, turned)

    (target,) = fronts_in(look)

    assert target.opening == pytest.approx(0.9, abs=1e-9)
    assert target.hands == ("left",)


def test_a_door_that_is_nearly_closed_tells_its_side_by_its_handle_alone():
    (target,) = fronts_in(seen(0.05))

    assert target.pushed
    assert target.hands == ("left",)
    assert fronts_in(seen(0.05, without=("handle",))) == []


@pytest.mark.parametrize("without", [(), ("handle",)])
def test_a_drawer_is_known_by_its_front_for_a_robot_that_pushes_drawers(without):
    look = seen(0.25, without, "drawers")

    (target,) = fronts_in(look, drawers=True)

    assert fronts_in(look) == []
    assert (target.kind, target.pushed) == ("drawer", True)
    assert target.opening == pytest.approx(0.25, abs=1e-9)
    front = look[target.part].odom_T_object
    assert target.path.at(0.25).outward == pytest.approx(-front[:3, 0], abs=1e-9)
    assert target.path.at(0.25).position_m[2] == pytest.approx(front[2, 3], abs=0.01)


def test_without_its_body_a_door_tells_no_angle():
    look = {"door": seen(0.9)["door"]}

    assert fronts_in(look) == []


def test_a_bar_that_is_out_of_sight_now_goes_with_the_front_on_which_it_was_seen():
    look = seen(0.9)
    scene = PlanningScene().with_objects(
        SceneObject(name, item.shape, item.odom_T_object, movable=False) for name, item in look.items()
    )
    fronts = fronts_in(seen(0.9, without=("handle",)))

    (known,) = with_known_bars(fronts, scene)
    elsewhere = replace(scene.objects["handle"], world_T_object=poses.translation(0.0, 3.0, 1.0))
    (unknown,) = with_known_bars(fronts, scene.with_object(elsewhere))

    assert (known.handle, unknown.handle) == ("handle", "door")
