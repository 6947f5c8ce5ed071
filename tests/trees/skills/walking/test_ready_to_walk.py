"""Ready to walk: at home, or with the arms drawn in where there is no room for hands at home."""

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry.shapes import Cylinder
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import SceneObject
from trees.skills.walking.draw_arms_in import DrawArmsIn
from trees.skills.walking.empty_arms import arms_are_tucked
from trees.skills.walking.ready_to_walk import ReadyToWalk


@pytest.mark.parametrize(("drawn_in", "status"), [(True, Status.SUCCESS), (False, Status.FAILURE)])
def test_only_arms_that_are_drawn_in_may_stay_where_home_is_out_of_reach(stage, drawn_in, status):
    if drawn_in:
        assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS
    else:
        stage.fake.motion._q[7 + stage.toolbox.model.joint_index("arm_left_4_joint")] += 0.3
    stage.fake.planning.no_plan = NoPlan("no motion to the posture was found", {})

    assert stage.run(ReadyToWalk("ready", stage.toolbox)) is status


def test_arms_are_drawn_in_where_the_way_home_is_barred(stage):
    planning = stage.fake.planning
    answer = planning.answer
    home = NoPlan("gripper_left_base_link collides with handle", {})
    planning.answer = lambda request: home if not getattr(request, "joints", True) else answer(request)
    stage.fake.motion._q[7 + stage.toolbox.model.joint_index("arm_left_4_joint")] += 0.3

    assert stage.run(ReadyToWalk("ready", stage.toolbox)) is Status.SUCCESS
    assert arms_are_tucked(stage.toolbox)


@pytest.mark.parametrize(("lean_rad", "moves"), [(0.0, False), (0.03, False), (0.12, True)])
def test_who_only_has_to_be_upright_keeps_the_arms_where_they_are(stage, lean_rad, moves):
    stage.fake.motion._q[7 + stage.toolbox.model.joint_index("arm_left_4_joint")] += 0.3
    stage.fake.motion._q[3:7] = (0.0, np.sin(0.5 * lean_rad), 0.0, np.cos(0.5 * lean_rad))

    assert stage.run(ReadyToWalk("ready", stage.toolbox, only_if_it_leans=True)) is Status.SUCCESS
    assert bool(stage.fake.motion.started) is moves


@pytest.mark.requirement("S2")
@pytest.mark.parametrize(("point_m", "come_out"), [((0.35, 0.3, 1.0), False), ((0.9, 0.3, 1.0), True)])
@pytest.mark.parametrize("lean_rad", [0.0, 0.12])
def test_drawn_in_arms_stay_in_where_the_range_sensor_sees_something_beside(
    stage_with, point_m, come_out, lean_rad
):
    stage = stage_with(walks=True)
    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS
    stage.fake.motion._q[3:7] = (0.0, np.sin(0.5 * lean_rad), 0.0, np.cos(0.5 * lean_rad))
    stage.fake.ranging.points_m = np.array([point_m])

    assert stage.run(ReadyToWalk("ready", stage.toolbox)) is Status.SUCCESS
    assert arms_are_tucked(stage.toolbox) is not come_out
    assert abs(stage.fake.motion.reference()[4]) < 1e-3


@pytest.mark.parametrize("only_if_it_leans", [False, True])
@pytest.mark.parametrize(("in_hand", "status"), [("red cup", Status.FAILURE), ("blue can", Status.SUCCESS)])
def test_nobody_walks_with_what_may_lean_in_the_hand(stage, in_hand, status, only_if_it_leans):
    frame = stage.toolbox.model.description.tcp_frames["right"]
    thing = SceneObject(in_hand, Cylinder(0.03, 0.1), np.eye(4))
    stage.told.update(stage.told.scene.with_object(thing).with_attached(in_hand, frame, np.eye(4), ()))
    stage.toolbox.world.leans = frozenset({"red cup"})
    leaf = ReadyToWalk("ready", stage.toolbox, only_if_it_leans=only_if_it_leans)

    assert stage.run(leaf) is status
    if status is Status.FAILURE:
        assert "the red cup was taken steeply and may lean in the hand" in leaf.failure.message
        assert not stage.fake.motion.started
