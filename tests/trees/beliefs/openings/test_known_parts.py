"""Doors and drawers of pieces that a detector recognises by their models."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.object_estimate import fuse_frames
from robots.scenes.furniture import solids
from tests.trees.cabinet_seen import CABINET, MICROWAVE, believed, estimate, seen, shown
from trees.beliefs.openings.drawer_inside import DrawerInside, inside_of_drawer
from trees.beliefs.openings.handles import OPEN_TO, beside_bar, goes_with, handles_in, opening_in, same_front
from trees.beliefs.openings.moved_parts import without_moved_parts
from trees.beliefs.scene.scene_update import updated_scene
from trees.failures import FailureKind
from trees.policy import TreePolicy

ROW = ("top drawer", "middle drawer", "bottom drawer")


def target_of(look, part):
    return next(one for one in handles_in(look) if one.moves.part == part)


@pytest.mark.parametrize("part", ROW)
def test_each_bar_is_on_the_drawer_that_its_model_says(part):
    target = target_of(seen(CABINET, top_drawer=0.12), part)

    assert target.opening == pytest.approx(0.12 if part == "top drawer" else 0.0, abs=1e-9)
    assert target.open_to == pytest.approx(0.92 * 0.14)
    assert target.open_enough < target.open_to < OPEN_TO["drawer"]


@pytest.mark.parametrize("opening", [0.0, 0.5, 1.2])
def test_a_door_is_known_with_the_hinge_and_the_side_of_its_model(opening):
    (target,) = handles_in(seen(MICROWAVE, door=opening))
    (shut,) = handles_in(seen(MICROWAVE))

    assert target.opening == pytest.approx(opening, abs=1e-9)
    assert target.hands == ("left", "right")
    np.testing.assert_allclose(target.path.hinge_m, shut.path.hinge_m, atol=1e-9)
    np.testing.assert_allclose(target.path.at(0.0).position_m, shut.path.at(0.0).position_m, atol=1e-9)


def test_how_far_one_is_open_is_measured_at_its_own_front():
    look = seen(CABINET, middle_drawer=0.1)
    scene = believed(look)

    for part, opening in (("top drawer", 0.0), ("middle drawer", 0.1)):
        target = target_of(look, part)
        assert opening_in(look.values(), "drawer", scene, target) == pytest.approx(opening, abs=1e-9)
    alone = [one for one in look.values() if one.moves.part == "top drawer"]
    assert opening_in(alone, "drawer", scene, target_of(look, "middle drawer")) is None


def test_a_drawer_is_the_same_however_far_it_is_open_and_the_next_one_is_not():
    shut, drawn = seen(CABINET), seen(CABINET, top_drawer=0.13)
    known = target_of(shut, "top drawer")

    assert same_front(known, handles_in(drawn), believed(drawn)).moves.part == "top drawer"
    others = [one for one in handles_in(drawn) if one.moves.part != "top drawer"]
    assert same_front(known, others, believed(drawn)) is None


def test_what_is_seen_anew_keeps_its_name_and_the_one_out_of_view_stays():
    shut = seen(CABINET)
    scene = believed(shut)
    name = {one.moves.part: key for key, one in shut.items() if one.kind == "handle"}
    look = [one for one in seen(CABINET).values() if one.moves.part != "top drawer"]

    left = without_moved_parts(scene, look)
    update = updated_scene(left, look, TreePolicy(), lambda _: True)

    for part in ROW:
        item = update.scene.objects[name[part]]
        np.testing.assert_allclose(item.world_T_object, shut[name[part]].odom_T_object, atol=1e-9)


def test_a_bar_that_its_front_has_taken_along_out_of_sight_is_not_where_it_was():
    scene = believed(seen(CABINET))
    drawn = seen(CABINET, top_drawer=0.13)
    fronts = [one for one in drawn.values() if one.kind == "drawer"]

    left = without_moved_parts(scene, fronts)

    bars = {item.moves.part for item in left.objects.values() if item.moves and "/" not in item.name}
    handles = [item.moves.part for name, item in left.objects.items() if name.startswith("handle")]
    assert set(handles) == {"middle drawer", "bottom drawer"}
    assert "middle drawer" in bars


def test_the_next_handle_is_beside_a_bar_and_its_own_front_is_not():
    look = seen(CABINET)
    scene = believed(look)
    target = target_of(look, "middle drawer")

    names = beside_bar(target, scene)

    parts = {(look[name].kind, look[name].moves.part) for name in names}
    assert {("handle", "top drawer"), ("handle", "bottom drawer")} <= parts
    assert ("drawer", "middle drawer") not in parts
    assert not any(look[name].kind == "drawer bottom" for name in names)


@pytest.mark.parametrize("who", ["Ana", "person 2"])
def test_nobody_who_stands_at_a_bar_may_be_touched(who):
    look = seen(CABINET)
    target = target_of(look, "top drawer")
    body = SceneObject(
        who, Box((0.3, 0.4, 1.7)), poses.translation(*target.path.at(0.0).position_m), 0.1, False
    )

    assert who not in beside_bar(target, believed(look).with_object(body))


def test_of_an_open_drawer_what_is_beside_its_bar_once_it_is_shut_counts_as_well():
    look = seen(CABINET, top_drawer=0.13)

    names = beside_bar(target_of(look, "top drawer"), believed(look))

    assert ("handle", "middle drawer") in {(look[name].kind, look[name].moves.part) for name in names}


def test_the_room_in_the_drawer_that_is_open_is_measured_within_its_own_walls():
    scene = with_body(believed(seen(CABINET, bottom_drawer=0.12)))
    shut = with_body(believed(seen(CABINET)))

    room = inside_of_drawer(scene)

    assert isinstance(room, DrawerInside)
    assert {scene.objects[name].moves.part for name in room.solids} == {"bottom drawer"}
    assert room.size_m[0] == pytest.approx(0.12, abs=0.015)
    assert inside_of_drawer(shut).kind is FailureKind.INFEASIBLE
    top = next(name for name, item in scene.objects.items() if is_front(item, "top drawer"))
    assert inside_of_drawer(scene, top).kind is FailureKind.INFEASIBLE


def is_front(item, part):
    return item.name.startswith("drawer") and item.moves is not None and item.moves.part == part


def with_body(scene):
    """A scene with what does not move of the cabinet."""
    for number, one in enumerate(solids(CABINET), start=1):
        name = "cabinet" if number == 1 else f"cabinet {number}"
        scene = scene.with_object(SceneObject(name, one.shape, one.world_T_solid, 0.01, movable=False))
    return scene


def test_only_what_is_in_a_drawer_goes_along_with_its_front():
    look = seen(CABINET, middle_drawer=0.1)
    target = target_of(look, "middle drawer")
    goes = {
        item.moves.part
        for name, item in believed(look).objects.items()
        if name.startswith("drawer ") and goes_with(item, target)
    }

    assert goes == {"middle drawer"}


def test_frames_of_neighbours_are_not_taken_for_one():
    """Two handles nearer to each other than the gate of furniture, each with its own error."""
    rng = np.random.default_rng(3)
    bars = [one for one in shown(CABINET) if one.kind == "handle"][:2]
    apart = poses.translation(0.0, 0.0, bars[0].world_T_object[2, 3] - bars[1].world_T_object[2, 3] - 0.004)
    near = [bars[0].world_T_object, apart @ bars[1].world_T_object]
    frames = [
        PerceptionFrame(
            0.03 * k,
            k,
            tuple(
                Detection(
                    "furniture",
                    "handle",
                    None,
                    poses.translation(*rng.normal(0.0, 0.004, 3)) @ pose,
                    one.shape,
                    0.9,
                    moves=one.moves,
                )
                for one, pose in zip(bars, near, strict=True)
            ),
        )
        for k in range(8)
    ]

    told = fuse_frames([(np.eye(4), frame) for frame in frames])

    assert sorted(one.moves.part for one in told) == ["middle drawer", "top drawer"]
    for one in told:
        own = next(bar for bar in bars if bar.moves.part == one.moves.part)
        assert one.moves.shut[2, 3] == pytest.approx(own.moves.shut[2, 3], abs=1e-3)


def test_where_it_is_shut_is_told_by_all_frames_together():
    rng = np.random.default_rng(5)
    front = next(one for one in shown(MICROWAVE, door=0.8) if one.kind == "door")
    camera = poses.transform(poses.rotation_z(0.4), (0.2, 0.1, 1.5))
    frames = []
    for k in range(12):
        seen_at = poses.inverse(camera) @ poses.translation(*rng.normal(0.0, 0.002, 3)) @ front.world_T_object
        told = type(front.moves)(
            poses.inverse(camera) @ front.moves.shut, 1.7, "microwave", "door", 1.0, front.moves.hinge_m
        )
        one = Detection("furniture", "door", None, seen_at, front.shape, 0.9, moves=told)
        frames.append((camera, PerceptionFrame(0.03 * k, k, (one,))))

    (found,) = fuse_frames(frames)

    np.testing.assert_allclose(found.moves.shut, estimate(front).moves.shut, atol=2e-3)
