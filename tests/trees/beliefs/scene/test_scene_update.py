from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import lowest_point_m, support_of
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.scene_update import kind_of, updated_scene
from trees.policy import TreePolicy

POLICY = TreePolicy()


def seen(kind="cup", color="red", at=(0.5, 0.0, 0.955), shape=None, category="object"):
    shape = shape or Cylinder(0.03, 0.11)
    return ObjectEstimate(category, kind, color, poses.translation(*at), shape, 0.9, 8, 0.003)


def seen_table(at=(0.65, 0.0, 0.88), size=(0.6, 1.2, 0.04)):
    return seen("table", None, at, Box(size), "furniture")


def look(scene, *estimates, unseen=lambda point: False, may_have_moved=True):
    return updated_scene(scene, estimates, POLICY, unseen, may_have_moved)


def test_things_are_named_by_colour_and_kind_and_numbered():
    scene = look(PlanningScene(), seen(at=(0.5, -0.2, 0.955)), seen(at=(0.5, 0.2, 0.955)), seen_table()).scene

    assert set(scene.objects) == {"red cup", "red cup 2", "table"}


def test_the_top_of_a_table_gets_its_name_and_not_a_leg():
    leg = seen_table(at=(0.4, -0.5, 0.43), size=(0.05, 0.05, 0.86))

    scene = look(PlanningScene(), leg, seen_table()).scene

    assert scene.objects["table"].shape.size_m == (0.6, 1.2, 0.04)


def test_margins_are_those_of_the_policy_and_furniture_is_not_movable():
    scene = look(PlanningScene(), seen(), seen_table()).scene

    assert scene.objects["table"].margin_m == POLICY.furniture_margin_m
    assert not scene.objects["table"].movable
    assert scene.objects["red cup"].margin_m == POLICY.object_margin_m
    assert scene.objects["red cup"].movable


def test_a_name_stays_with_its_object_from_look_to_look():
    first = look(PlanningScene(), seen(at=(0.5, -0.2, 0.955)), seen(at=(0.5, 0.2, 0.955)))
    second = look(first.scene, seen(at=(0.51, 0.2, 0.955)), seen(at=(0.49, -0.2, 0.955)))

    for name in ("red cup", "red cup 2"):
        before = first.scene.objects[name].world_T_object[1, 3]
        assert second.scene.objects[name].world_T_object[1, 3] == pytest.approx(before)


def test_furniture_is_remembered_when_it_is_not_seen_again():
    first = look(PlanningScene(), seen_table())

    assert "table" in look(first.scene, seen()).scene.objects


def test_furniture_seen_again_is_not_doubled():
    first = look(PlanningScene(), seen_table())

    assert list(look(first.scene, seen_table(at=(0.66, 0.01, 0.88))).scene.objects) == ["table"]


def test_an_object_that_should_have_been_seen_and_was_not_is_forgotten():
    first = look(PlanningScene(), seen())

    assert look(first.scene).scene.objects == {}


def test_an_object_that_could_not_be_seen_is_remembered():
    first = look(PlanningScene(), seen())

    assert "red cup" in look(first.scene, unseen=lambda point: True).scene.objects


def test_an_object_that_moved_far_leaves_no_double_behind():
    first = look(PlanningScene(), seen(at=(0.5, -0.2, 0.955)))
    second = look(first.scene, seen(at=(0.5, 0.1, 0.955)), unseen=lambda point: True)

    assert list(second.scene.objects) == ["red cup"]
    assert second.scene.objects["red cup"].world_T_object[1, 3] == 0.1


def test_a_look_makes_the_scene_newer():
    assert look(PlanningScene(version=7)).scene.version == 8


def test_the_number_is_no_part_of_the_words():
    assert (kind_of("red cup 12"), kind_of("table")) == ("red cup", "table")


@given(
    st.floats(-3.1, 3.1),
    st.floats(-1.5, 1.5),
    st.sampled_from([Box((0.1, 0.06, 0.2)), Cylinder(0.03, 0.11), Ball(0.04)]),
)
def test_the_lowest_point_is_that_of_the_solid_as_it_lies(roll, pitch, shape):
    pose = poses.transform(poses.rotation_x(roll) @ poses.rotation_y(pitch), (0.1, 0.2, 1.0))
    angles = np.linspace(0.0, 2.0 * np.pi, 721)
    if isinstance(shape, Box):
        points = 0.5 * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * shape.size_m
    elif isinstance(shape, Cylinder):
        rim = shape.radius_m * np.column_stack([np.cos(angles), np.sin(angles)])
        points = np.vstack([np.column_stack([rim, np.full(721, z * shape.height_m)]) for z in (-0.5, 0.5)])
    else:
        points = np.array([pose[:3, :3].T @ (0.0, 0.0, -shape.radius_m)])

    lowest = float((points @ pose[:3, :3].T + pose[:3, 3])[:, 2].min())

    assert lowest_point_m(SceneObject("it", shape, pose)) == pytest.approx(lowest, abs=1e-4)


@pytest.mark.parametrize(
    ("place", "stands"),
    [
        ((0.5, 0.0, 0.955), True),
        ((0.5, 0.9, 0.955), False),
        ((0.5, 0.0, 1.10), False),
        ((0.5, 0.0, 0.70), False),
    ],
)
def test_an_object_stands_on_the_furniture_right_below_it(place, stands):
    scene = look(PlanningScene(), seen(at=place), seen_table()).scene

    support = support_of(scene.objects["red cup"], scene, POLICY.support_gap_m)

    assert (support is not None) == stands


@pytest.mark.parametrize("name", ["floor", "arm_left_7_link"])
def test_what_is_called_as_the_floor_or_a_link_is_numbered_from_two_on_and_keeps_its_name(name):
    table = replace(seen_table(), name=name)
    reserved = frozenset({"floor", "arm_left_7_link"})

    first = updated_scene(PlanningScene(), [table], POLICY, lambda _: False, reserved=reserved).scene
    again = updated_scene(first, [table], POLICY, lambda _: False, reserved=reserved).scene

    assert list(first.objects) == list(again.objects) == [f"{name} 2"]
    assert kind_of(f"{name} 2") == name


def seen_person(name="Ana", at=(1.3, 0.2, 0.875)):
    body = seen("person", None, at, Cylinder(0.24, 1.75), "person")
    return replace(body, name=name)


@pytest.mark.parametrize("may_have_moved", [True, False])
def test_somebody_who_has_walked_on_is_one_person(may_have_moved):
    first = look(PlanningScene(), seen_person())
    later = [seen_person(at=(2.4, 0.2, 0.875))]

    second = updated_scene(first.scene, later, POLICY, lambda _: False, may_have_moved)

    assert list(second.seen) == list(second.scene.objects) == ["Ana"]
    assert second.scene.objects["Ana"].world_T_object[0, 3] == pytest.approx(2.4)


def test_somebody_who_is_not_in_view_is_remembered():
    first = look(PlanningScene(), seen_person())
    second = look(first.scene, seen_person("Ben", (1.0, -1.0, 0.875)))

    assert set(second.scene.objects) == {"Ana", "Ben"}


def test_two_people_are_never_in_one_place_so_that_is_one_seen_elsewhere():
    first = look(PlanningScene(), seen_person(None))

    second = look(first.scene, seen_person(None, (1.08, 0.2, 0.875)))

    assert set(second.scene.objects) == {"person"}
    assert second.scene.objects["person"].world_T_object[0, 3] == 1.08


def test_people_without_names_are_told_apart_while_the_head_looks_around():
    first = look(PlanningScene(), seen_person(None))
    later = [seen_person(None, (1.0, -1.0, 0.875))]

    second = updated_scene(first.scene, later, POLICY, lambda _: False, may_have_moved=False)

    assert set(second.scene.objects) == {"person", "person 2"}


def test_what_is_out_of_sight_is_forgotten_where_something_else_is_seen_now():
    """An earlier look took the edge of the cup for a box: two things are never at one place."""
    before = look(PlanningScene(), seen("box", at=(0.51, 0.01, 0.95), shape=Box((0.02, 0.03, 0.1)))).scene

    scene = look(before, seen("cup"), unseen=lambda item: True).scene

    assert set(scene.objects) == {"red cup"}


def test_what_is_out_of_sight_stays_in_the_bowl_that_is_seen_and_on_the_box_that_is():
    ball = seen("ball", "green", at=(0.5, 0.0, 0.95), shape=Ball(0.02))
    can = seen("can", "blue", at=(0.2, 0.0, 1.06), shape=Cylinder(0.03, 0.1))
    before = look(PlanningScene(), ball, can).scene
    bowl = seen("bowl", "white", at=(0.5, 0.0, 0.94), shape=Cylinder(0.08, 0.07))
    box = seen("box", "white", at=(0.2, 0.0, 0.96), shape=Box((0.08, 0.08, 0.1)))

    scene = look(before, bowl, box, unseen=lambda item: True).scene

    assert {"green ball", "blue can"} <= set(scene.objects)


def test_what_is_known_is_not_replaced_by_something_else_that_is_told_unsurely():
    """Half of a cup, the other half behind a hand, looks like a box."""
    before = look(PlanningScene(), seen("cup")).scene
    half = replace(seen("box", at=(0.51, 0.01, 0.95), shape=Box((0.03, 0.05, 0.11))), confidence=0.3)

    scene = look(before, half, unseen=lambda item: True).scene

    assert set(scene.objects) == {"red cup"}


def test_an_unsure_sighting_of_something_else_says_that_what_is_known_is_still_there():
    before = look(PlanningScene(), seen("cup")).scene
    half = replace(seen("can", at=(0.51, 0.01, 0.93), shape=Cylinder(0.03, 0.08)), confidence=0.4)

    scene = look(before, half, unseen=lambda item: False).scene

    assert set(scene.objects) == {"red cup"}


def test_what_was_surely_seen_keeps_its_size_when_a_part_of_it_is_seen_again():
    before = look(PlanningScene(), seen("cup")).scene
    part = replace(seen("cup", at=(0.51, 0.01, 0.93), shape=Cylinder(0.02, 0.06)), confidence=0.4)

    update = updated_scene(before, [part], POLICY, lambda _: False, before={"red cup": seen("cup")})

    assert update.scene.objects["red cup"].shape == Cylinder(0.03, 0.11)
    assert update.seen["red cup"].shape == Cylinder(0.03, 0.11)


@pytest.mark.requirement("P2")
def test_a_side_of_a_box_that_the_picture_cuts_off_is_no_second_box():
    box = seen("box", "brown", at=(0.5, 0.0, 0.94), shape=Box((0.17, 0.19, 0.07)))
    before = look(PlanningScene(), box).scene
    shown = seen("box", "brown", at=(0.5, -0.09, 0.94), shape=Box((0.17, 0.016, 0.07)))
    side = replace(shown, confidence=0.2)

    update = updated_scene(before, [side], POLICY, lambda _: True, before={"brown box": box})

    assert update.scene.objects["brown box"].shape == box.shape
    assert update.seen["brown box"].shape == box.shape


WALL = seen("box", "blue", at=(0.5, -0.09, 0.94), shape=Box((0.037, 0.016, 0.07)))


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("middle_m", [0.0, -0.02])
@pytest.mark.parametrize("cut", [True, False])
def test_a_wall_of_an_open_box_that_the_picture_cuts_off_is_no_thing_in_it(middle_m, cut):
    """Nor beside it, where the box was seen too small, or cut off as well."""
    shown = replace(WALL, odom_T_object=poses.translation(0.5, -0.09 + middle_m, 0.94), cut=True)
    box = seen("box", "brown", at=(0.5, 0.0, 0.94), shape=Box((0.17, 0.19, 0.07)))
    before = look(PlanningScene(), box).scene

    update = updated_scene(
        before, [shown], POLICY, lambda _: True, before={"brown box": replace(box, cut=cut)}
    )

    assert set(update.scene.objects) == {"brown box"}


@pytest.mark.requirement("P2")
def test_a_box_of_which_the_picture_shows_a_part_is_seen_with_what_is_in_it():
    box = seen("box", "brown", at=(0.5, 0.0, 0.94), shape=Box((0.17, 0.19, 0.07)))
    before = look(PlanningScene(), box).scene
    half = replace(seen("box", "brown", at=(0.5, 0.06, 0.94), shape=Box((0.17, 0.07, 0.07))), cut=True)
    can = seen("can", at=(0.5, 0.03, 0.95), shape=Cylinder(0.027, 0.11))

    update = updated_scene(before, [half, can], POLICY, lambda _: True, before={"brown box": box})

    assert update.seen["brown box"].shape == box.shape
    assert set(update.scene.objects) == {"brown box", "red can"}


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("cut", "count"), [(True, 1), (False, 2)])
def test_what_was_cut_off_is_a_part_of_what_is_seen_whole_where_it_was(cut, count):
    box = seen("box", "brown", at=(0.5, 0.0, 0.94), shape=Box((0.17, 0.19, 0.07)))
    part = replace(WALL, cut=cut)
    before = look(PlanningScene(), part).scene

    update = updated_scene(before, [box], POLICY, lambda _: True, before={"blue box": part})

    assert len(update.scene.objects) == count


@pytest.mark.requirement("P2")
def test_a_wide_box_that_is_seen_to_be_elsewhere_within_itself_is_one_box():
    narrow = seen("box", "brown", at=(0.57, 0.01, 0.94), shape=Box((0.17, 0.08, 0.09)))
    wide = seen("box", "brown", at=(0.55, -0.055, 0.94), shape=Box((0.17, 0.13, 0.09)))

    before = look(PlanningScene(), narrow).scene
    scene = look(before, wide, unseen=lambda item: True, may_have_moved=False).scene

    assert set(scene.objects) == {"brown box"}


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("confidence", "count"), [(0.5, 1), (0.95, 2)])
def test_the_other_half_of_a_box_that_is_seen_unsurely_is_no_second_box(confidence, count):
    left = seen("box", "brown", at=(0.54, 0.07, 0.94), shape=Box((0.20, 0.10, 0.07)))
    right = seen("box", "brown", at=(0.54, -0.04, 0.94), shape=Box((0.17, 0.09, 0.07)))
    before = look(PlanningScene(), replace(left, confidence=0.3))

    half = replace(right, confidence=confidence)
    update = updated_scene(before.scene, [half], POLICY, lambda _: True, False, before=before.seen)

    assert len(update.scene.objects) == count


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("task", ["this one", "an earlier one"])
def test_what_another_task_saw_may_be_what_appears_elsewhere_though_its_place_is_hidden(task):
    here, there = seen("cup", at=(0.34, 0.26, 0.78)), seen("cup", at=(0.38, 0.33, 0.78))
    known = look(PlanningScene(), here)
    before = known.seen if task == "this one" else {}

    update = updated_scene(known.scene, [there], POLICY, lambda _: True, False, before=before)

    assert len(update.scene.objects) == (2 if task == "this one" else 1)


def test_boxes_on_top_of_each_other_are_two():
    low = seen("box", "brown", at=(0.5, 0.0, 0.94), shape=Box((0.17, 0.17, 0.09)))
    high = seen("box", "brown", at=(0.5, 0.0, 1.03), shape=Box((0.17, 0.17, 0.09)))

    scene = look(look(PlanningScene(), low).scene, low, high, may_have_moved=False).scene

    assert set(scene.objects) == {"brown box", "brown box 2"}


@pytest.mark.requirement("P2")
def test_what_is_seen_unsurely_in_a_bowl_is_no_contradiction_to_the_bowl():
    bowl = seen("bowl", "white", at=(0.5, 0.0, 0.94), shape=Cylinder(0.08, 0.07))
    before = look(PlanningScene(), bowl).scene
    can = replace(seen("can", at=(0.5, 0.02, 0.96), shape=Cylinder(0.03, 0.1)), confidence=0.5)

    update = updated_scene(before, [can], POLICY, lambda _: True, before={"white bowl": bowl})

    assert set(update.seen) == {"red can"}


@pytest.mark.requirement("P2")
def test_a_bottle_of_which_the_picture_shows_no_more_than_a_cup_is_still_that_bottle():
    bottle = seen("bottle", "red", at=(0.43, 0.31, 0.97), shape=Cylinder(0.027, 0.157))
    before = look(PlanningScene(), bottle).scene
    low = replace(seen("cup", "red", at=(0.43, 0.31, 0.95), shape=Cylinder(0.027, 0.112)), cut=True)

    update = updated_scene(before, [low], POLICY, lambda _: True, before={"red bottle": bottle})

    assert set(update.scene.objects) == {"red bottle"}


@pytest.mark.requirement("P2")
def test_a_bottle_that_looks_like_a_cup_or_a_bottle_is_seen():
    bottle = seen("bottle", "green", at=(0.43, 0.31, 0.97), shape=Cylinder(0.034, 0.2))
    before = look(PlanningScene(), bottle).scene
    low = seen("cup", "green", at=(0.43, 0.31, 0.957), shape=Cylinder(0.034, 0.174))

    update = look(before, replace(low, alike=("bottle",)), unseen=lambda item: True)

    assert update.seen["green bottle"].shape == bottle.shape


@pytest.mark.requirement("P2")
def test_what_is_as_long_as_a_bowl_is_wide_is_the_bowl_seen_badly():
    bowl = seen("bowl", "white", at=(0.5, 0.0, 0.94), shape=Cylinder(0.086, 0.081))
    before = look(PlanningScene(), bowl).scene
    box = seen("box", "white", at=(0.5, -0.027, 0.94), shape=Box((0.11, 0.165, 0.081)))

    update = updated_scene(
        before, [replace(box, confidence=0.27)], POLICY, lambda _: True, before={"white bowl": bowl}
    )

    assert set(update.scene.objects) == {"white bowl"}


@pytest.mark.requirement("P2")
def test_what_is_seen_to_be_one_kind_or_the_other_stays_the_one_that_is_known():
    """A cup of which the picture's edge cuts off the top is a can as well."""
    before = look(PlanningScene(), seen("cup")).scene
    part = replace(seen("can", at=(0.51, 0.01, 0.93), shape=Cylinder(0.03, 0.06)), alike=("cup",))

    assert look(before, part, unseen=lambda item: False).scene.objects == before.objects


def test_what_was_seen_unsurely_is_told_anew_by_an_unsure_look():
    before = look(PlanningScene(), seen("cup")).scene
    part = replace(seen("cup", at=(0.51, 0.01, 0.93), shape=Cylinder(0.02, 0.06)), confidence=0.4)

    assert look(before, part).scene.objects["red cup"].shape == Cylinder(0.02, 0.06)
