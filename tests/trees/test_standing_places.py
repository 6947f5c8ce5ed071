"""Where to stand: inside a room with space around, and where a handle's way is within reach."""

import itertools
import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.opening_path import DoorArc, DrawerLine
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.load import Load
from kinematics.walking.route.path_planning import clearance_m, footprints
from kinematics.walking.route.room import WalkingRoom
from robots.models.description import load_description
from trees.beliefs.grounding.destination import Place
from trees.beliefs.openings.handles import HandleTarget
from trees.skills.doors.handle_standing import handle_standing_place
from trees.skills.walking.standing_place import standing_place, stands_inside

ROOM = WalkingRoom(load_description("talos").walking)


def room(x=4.0, y=1.0, yaw=0.5, size=(3.0, 4.0)):
    return Place("kitchen", "region", Box((*size, 2.0)), PlanarPose(x, y, yaw).transform(1.0), 1.0)


def test_in_an_empty_room_one_stands_in_the_middle_and_faces_as_it_does():
    place = standing_place(room(), PlanningScene(), PlanarPose(), 0.05)

    assert place.distance_m(PlanarPose(4.0, 1.0)) < 0.2
    assert place.yaw_rad == pytest.approx(0.5)


def test_a_table_in_the_middle_of_a_room_is_kept_away_from():
    table = SceneObject("table", Box((0.8, 0.8, 0.8)), poses.translation(4.0, 1.0, 0.4), movable=False)
    scene = PlanningScene().with_objects([table])

    place = standing_place(room(), scene, PlanarPose(), 0.05)

    assert clearance_m(footprints(scene), place) > 0.55
    assert stands_inside(room(), place)


@pytest.mark.parametrize(("x", "inside"), [(4.0, True), (5.0, True), (5.3, False), (7.0, False)])
def test_who_stands_at_the_border_of_a_room_does_not_stand_inside(x, inside):
    assert stands_inside(room(yaw=0.0), PlanarPose(x, 1.0)) is inside


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("yaw", [0.0, 2.0])
def test_before_a_door_the_hinge_is_ahead_and_on_the_side_of_the_hand(side, yaw):
    arc = DoorArc(np.array([3.0, 1.0]), yaw, side, 0.54, 0.055, 1.0)
    hands = ("left",) if side > 0.0 else ("right",)
    target = HandleTarget("door", "handle", "door", arc, 0.0, hands)

    body = handle_standing_place(target, PlanarPose(), load_description("talos"))
    hinge = body.to(PlanarPose(3.0, 1.0, yaw))

    assert (hinge.x_m, hinge.y_m) == pytest.approx((0.80, side * 0.75))
    assert hinge.yaw_rad == pytest.approx(side * 0.15)


def test_before_a_drawer_one_stands_on_the_side_where_one_is():
    line = DrawerLine(np.array([2.0, 0.0, 0.9]), math.pi / 2.0)
    target = HandleTarget("drawer", "handle", "drawer", line, 0.0, ("left", "right"))

    body = handle_standing_place(target, PlanarPose(3.0, -1.0), load_description("talos"))
    bar = body.to(PlanarPose(2.0, 0.0))

    assert (bar.x_m, abs(bar.y_m)) == pytest.approx((0.66, 0.34))
    assert body.x_m > 2.0


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("opening", [0.1, 1.2])
def test_who_pushes_a_door_shut_stands_beyond_its_hinge_and_as_far_before_it_as_it_is_open(side, opening):
    robot = load_description("g1")
    arc = DoorArc(np.array([3.0, 1.0]), 2.0, side, 0.4, 0.055, 1.0)
    target = HandleTarget("door", "door", "door", arc, opening, ("left",), pushed=True)

    body = handle_standing_place(target, PlanarPose(), robot)
    hinge = body.to(PlanarPose(3.0, 1.0, 2.0))

    out_m = robot.pushing.places_m[0][0] * math.sin(opening)
    assert hinge.x_m == pytest.approx(robot.pushing.before_m + out_m)
    assert side * hinge.y_m == pytest.approx(-robot.pushing.beyond_hinge_m)
    assert hinge.yaw_rad == pytest.approx(0.0, abs=1e-9)


def test_who_pushes_a_drawer_stands_before_its_front_as_it_is():
    robot = load_description("g1")
    line = DrawerLine(np.array([2.0, 0.0, 0.8]), 0.0)
    target = HandleTarget("drawer", "drawer", "drawer", line, 0.25, ("left", "right"), pushed=True)

    body = handle_standing_place(target, PlanarPose(), robot)

    assert (body.x_m, body.y_m) == pytest.approx((2.0 - 0.25 - robot.pushing.before_m, 0.0))


def crowd(*places_m):
    people = [
        SceneObject(f"person {k}", Cylinder(0.24, 1.75), poses.translation(x, y, 0.875), movable=False)
        for k, (x, y) in enumerate(places_m)
    ]
    return PlanningScene().with_objects(people)


ANA = Place("Ana", "person", Cylinder(0.24, 1.75), poses.translation(3.0, 0.0, 0.875), 1.75)


def test_before_a_person_one_stands_on_the_side_from_which_one_comes():
    place = standing_place(ANA, crowd((3.0, 3.0)), PlanarPose(), 0.05, ROOM)

    assert (place.x_m, place.y_m, place.yaw_rad) == pytest.approx((1.9, 0.0, 0.0))


def test_where_somebody_else_stands_in_the_way_of_turning_hands_one_goes_around():
    scene = crowd((2.0, 0.9))

    place = standing_place(ANA, scene, PlanarPose(), 0.05, ROOM)

    assert place.distance_m(PlanarPose(3.0, 0.0)) == pytest.approx(1.1)
    assert place.distance_m(PlanarPose(2.0, 0.9)) > 0.24 + 0.83
    assert place.y_m < 0.0


def fridge_with_door(tip_m):
    """A tall box ahead whose open door stands out towards the robot, up to so far from its front."""
    box = SceneObject("fridge", Box((0.6, 0.6, 1.7)), poses.translation(3.0, 0.0, 0.85), movable=False)
    pose = poses.translation(2.7 - 0.5 * tip_m, -0.2, 0.85)
    door = SceneObject("door", Box((tip_m, 0.04, 1.6)), pose, movable=False)
    scene = PlanningScene().with_objects([box, door])
    return Place("fridge", "furniture", box.shape, box.world_T_object, 1.7), scene


@pytest.mark.requirement("S2")
def test_before_an_open_door_one_stands_where_hands_do_not_come_to_it():
    place, scene = fridge_with_door(0.6)

    usual = standing_place(place, scene, PlanarPose(), 0.05)
    stand = standing_place(place, scene, PlanarPose(), 0.05, ROOM)

    assert any(room.hands_meet(scene, [usual], 0.08) for room in ROOM.either_way())
    assert not any(room.hands_meet(scene, [stand], 0.08) for room in ROOM.either_way())
    assert ROOM.either_way()[1].hands_turn(scene, stand)
    assert 0.05 < stand.distance_m(usual) < 0.5
    assert stand.yaw_rad == pytest.approx(usual.yaw_rad)


def test_before_a_door_that_is_nearly_shut_one_stands_as_usual():
    place, scene = fridge_with_door(0.1)

    usual = standing_place(place, scene, PlanarPose(), 0.05)

    assert standing_place(place, scene, PlanarPose(), 0.05, ROOM) == usual


def test_who_stands_well_before_a_door_is_not_sent_on_for_a_centimetre():
    def stand(tip_m, body):
        place, scene = fridge_with_door(tip_m)
        return standing_place(place, scene, body, 0.05, ROOM)

    tips_m = [0.50 + 0.01 * k for k in range(20)]
    moved = [
        (a, b) for a, b in itertools.pairwise(tips_m) if stand(a, PlanarPose()) != stand(b, PlanarPose())
    ]

    assert moved
    for before_m, after_m in moved:
        here = stand(before_m, PlanarPose())
        assert stand(after_m, here) == here


def test_before_an_open_door_drawn_in_arms_have_room_to_turn_away():
    place, scene = fridge_with_door(0.5)
    _, drawn_in = ROOM.either_way()

    stand = standing_place(place, scene, PlanarPose(), 0.05, ROOM)

    assert not drawn_in.hands_turn(scene, standing_place(place, scene, PlanarPose(), 0.05))
    assert drawn_in.hands_turn(scene, stand)


@pytest.mark.parametrize(("gap_m", "side"), [(0.75, "front"), (1.1, "end")])
def test_where_a_wall_leaves_no_way_to_the_nearest_side_one_stands_before_another(gap_m, side):
    shape, pose = Box((0.6, 1.2, 0.04)), poses.translation(0.0, 0.0, 0.88)
    beyond = 0.6 + gap_m + 0.05
    wall = SceneObject("wall", Box((3.0, 0.1, 1.6)), poses.translation(0.0, beyond, 0.8), movable=False)
    table = SceneObject("table", shape, pose, movable=False)
    scene = PlanningScene().with_objects([table, wall])

    stand = standing_place(
        Place("table", "furniture", shape, pose, 0.9), scene, PlanarPose(-0.4, beyond + 1.0), 0.05, ROOM
    )

    assert (stand.y_m > 0.6) == (side == "end")


@pytest.mark.parametrize("yaw", [0.0, 1.0, -2.0])
@pytest.mark.parametrize("behind_m", [0.02, 0.3, 0.6])
def test_for_what_stands_far_back_on_a_shelf_one_stands_before_it_and_not_behind_at_the_wall(yaw, behind_m):
    placed = PlanarPose(1.0, 2.0, yaw)

    def fixed(name, shape, x, y, z):
        return SceneObject(name, shape, (placed @ PlanarPose(x, y)).transform(z), movable=False)

    shelf = fixed("shelf", Box((0.32, 1.1, 0.02)), 0.0, 0.0, 1.1)
    wall = fixed("wall", Box((0.1, 5.0, 0.9)), 0.16 + behind_m + 0.05, 0.0, 0.45)
    cup = SceneObject("cup", Cylinder(0.03, 0.1), (placed @ PlanarPose(0.09, 0.2)).transform(1.16))
    scene = PlanningScene().with_objects([shelf, wall, cup])

    stand = standing_place(
        Place("cup", "object", cup.shape, cup.world_T_object, 1.2), scene, PlanarPose(), 0.05, ROOM
    )

    assert placed.to(stand).x_m < -0.3


HELD = Load(from_m=0.9, front_m=0.5, back_m=-0.3, half_width_m=0.4, radius_m=0.6)


@pytest.mark.requirement("S2")
@pytest.mark.parametrize(("top_m", "steps_back"), [(0.92, True), (0.8, False)])
def test_what_is_held_does_not_come_to_furniture_that_is_taller(top_m, steps_back):
    shape = Box((0.4, 1.0, 0.02))
    shelf = SceneObject("shelf", shape, poses.translation(3.0, 0.0, top_m), movable=False)
    scene = PlanningScene().with_objects([shelf])
    place = Place("shelf", "furniture", shape, shelf.world_T_object, top_m)
    loaded = WalkingRoom(load_description("talos").walking, HELD)

    usual = standing_place(place, scene, PlanarPose(), 0.05, ROOM)
    stand = standing_place(place, scene, PlanarPose(), 0.05, loaded)

    assert loaded.load_meets(scene, [usual]) is steps_back
    assert not loaded.load_meets(scene, [stand])
    assert (stand.x_m < usual.x_m) is steps_back


def test_things_on_furniture_do_not_keep_a_load_away():
    bottle = SceneObject("bottle", Cylinder(0.03, 0.3), poses.translation(0.45, 0.1, 1.0))

    assert not WalkingRoom(load_description("talos").walking, HELD).load_meets(
        PlanningScene().with_objects([bottle]), [PlanarPose()]
    )


def test_a_robot_stands_where_the_bar_of_a_door_of_any_width_is_before_its_shoulder():
    robot = load_description("g1")
    asides = []
    for radius_m in (0.38, 0.54):
        arc = DoorArc(np.array([2.0, 0.5]), 0.3, 1.0, radius_m, 0.075, 0.9)
        target = HandleTarget("door", "bar", "door", arc, 0.0, ("left",))
        body = handle_standing_place(target, PlanarPose(), robot)
        bar = arc.at(0.0).position_m
        asides.append(body.to(PlanarPose(float(bar[0]), float(bar[1]))).y_m)

    assert abs(asides[0] - asides[1]) < 0.02
