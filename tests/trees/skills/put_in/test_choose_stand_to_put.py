"""Where to stand to put something behind a door is where a placing on a board has a plan, in sight."""

import dataclasses

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Cylinder
from kinematics.requests.place import PlaceRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import SceneObject
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_file import load_scene
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.skills.put_in.choose_stand_to_put import ChooseStandToPut

(PIECE,) = load_scene("fridge").furniture
CAN = HeldObject("green can", "left", Cylinder(0.03, 0.12), np.eye(4))
OPEN_RAD = float(np.radians(70.0))
FRONT = PlanarPose.of(floor_pose(PIECE)) @ PlanarPose(-0.5 * PIECE.size_m[0])


def fridge():
    told = [(PIECE.kind, solid.shape, solid.world_T_solid) for solid in solids(PIECE)]
    part = floor_pose(PIECE) @ furniture_T_part(PIECE) @ opened(PIECE, OPEN_RAD)
    told += [(one.kind, one.shape, part @ one.part_T_solid) for one in moving_solids(PIECE) if one.kind]
    return [
        SceneObject(kind if kind == "door" else f"{kind} {number}", shape, pose, 0.015, movable=False)
        for number, (kind, shape, pose) in enumerate(told, start=2)
    ]


@pytest.fixture
def before_the_fridge(stage):
    """The leaf's run, with a fridge ahead that is open, for a robot that walks."""
    scene = stage.told.scene.with_objects(fridge())
    q, frame = stage.fake.motion.reference(), stage.toolbox.model.description.tcp_frames["left"]
    can = SceneObject(CAN.name, CAN.shape, stage.toolbox.model.frame_pose(q, frame), 0.01)
    links = stage.toolbox.model.description.grippers["left"].touch_links
    stage.told.update(scene.with_object(can).with_attached(CAN.name, frame, np.eye(4), links))
    boards = [item for name, item in scene.objects.items() if name.startswith("fridge")]
    place = Place(boards[0].name, "furniture", boards[0].shape, boards[0].world_T_object, 0.9)
    toolbox = dataclasses.replace(stage.toolbox, walking=object())

    def run(answers):
        asked = []

        def answer(request):
            asked.append(request)
            return answers(request)

        stage.fake.planning.answer = answer
        status = stage.run(ChooseStandToPut("choose", toolbox), place=place, held=CAN)
        return status, asked, place

    return stage, run


def body_of(request):
    left, right = (PlanarPose.of(sole) for _, sole in request.stance.soles)
    return PlanarPose.between(left, right)


def test_the_first_place_with_a_plan_is_taken_and_it_is_beside_the_door(before_the_fridge):
    stage, run = before_the_fridge
    plan = stage.fake.planning.answer

    status, asked, place = run(plan)

    assert status is Status.SUCCESS
    assert all(isinstance(request, PlaceRequest) for request in asked)
    stand = FRONT.to(stage.output("stand").body(place))
    assert stand.y_m < -0.2  # the hinge is on the left
    assert -1.0 < stand.x_m < 0.0


def test_the_posture_is_carried_along_with_the_feet(before_the_fridge):
    stage, run = before_the_fridge

    _, asked, _ = run(stage.fake.planning.answer)

    reference = stage.fake.motion.reference()
    for request in asked:
        base = poses.transform(poses.rotation_from_quaternion(request.q_start[3:7]), request.q_start[:3])
        before = poses.transform(poses.rotation_from_quaternion(reference[3:7]), reference[:3])
        off = body_of(request).to(PlanarPose.of(base))
        was = PlanarPose().to(PlanarPose.of(before))
        assert (off.x_m, off.y_m, off.yaw_rad) == pytest.approx((was.x_m, was.y_m, was.yaw_rad), abs=0.02)
        np.testing.assert_array_equal(request.q_start[7:], reference[7:])


def test_a_place_has_to_serve_on_both_sides_of_where_one_arrives(before_the_fridge):
    stage, run = before_the_fridge
    plan, count = stage.fake.planning.answer, iter(range(1000))

    def answers(request):  # the first place serves, and what is beside it on one side, but not on the other
        return NoPlan("out of reach", {}) if next(count) == 2 else plan(request)

    _, asked, place = run(answers)

    assert stage.output("stand").body(place).distance_m(body_of(asked[0])) > 0.01


def test_where_no_place_serves_on_all_sides_the_one_that_serves_on_most_is_taken(before_the_fridge):
    stage, run = before_the_fridge
    plan, served = stage.fake.planning.answer, []

    def answers(request):  # one place serves, and what is beside it on one side; others serve nowhere
        number = len(served)
        served.append(body_of(request))
        return plan(request) if number in (0, 2, 3) else NoPlan("out of reach", {})

    status, asked, place = run(answers)

    assert status is Status.SUCCESS
    assert asked[-1].quick is False  # more patiently there was no better one
    assert stage.output("stand").body(place).distance_m(served[2]) < 0.01


def test_all_places_are_asked_about_quickly_before_any_is_asked_about_patiently(before_the_fridge):
    stage, run = before_the_fridge
    plan = stage.fake.planning.answer

    def answers(request):
        return NoPlan("out of reach", {}) if request.quick else plan(request)

    status, asked, place = run(answers)

    patient = [request for request in asked if not request.quick]
    assert status is Status.SUCCESS
    assert asked[-len(patient) :] == patient
    assert len(patient) == 3  # the best place, and what is beside it
    assert stage.output("stand").body(place).distance_m(body_of(asked[0])) < 0.01


def test_where_nothing_has_a_plan_nobody_walks(before_the_fridge):
    _, run = before_the_fridge

    status, _, _ = run(lambda _request: NoPlan("out of reach", {}))

    assert status is Status.FAILURE
