"""Arms are drawn in and let out; what holds something stays as it is."""

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry.shapes import Box
from trees.skills.walking.draw_arms_in import DrawArmsIn
from trees.skills.walking.empty_arms import arms_are_tucked


def at(stage, name):
    model = stage.toolbox.model
    return stage.fake.motion.reference()[7 + model.joint_index(name)]


def test_both_empty_arms_are_drawn_in_and_let_out_again(stage):
    tucked, home = stage.toolbox.model.description.walking.tucked.joints, stage.toolbox.model.description.home

    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS
    assert all(at(stage, name) == pytest.approx(value) for name, value in tucked.items())
    assert arms_are_tucked(stage.toolbox)

    assert stage.run(DrawArmsIn("out", stage.toolbox, out=True)) is Status.SUCCESS
    assert all(at(stage, name) == pytest.approx(home[name]) for name in tucked)
    assert not arms_are_tucked(stage.toolbox)


def test_an_arm_that_holds_something_stays_as_it_is(stage, hold_level):
    hold_level(Box((0.06, 0.06, 0.10)))
    before = stage.fake.motion.reference().copy()

    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS

    moved = np.abs(stage.fake.motion.reference() - before)[7:] > 1e-6
    names = np.array(stage.toolbox.model.joints)[moved]
    assert names.size
    assert all(name.startswith("arm_right") for name in names)
    assert arms_are_tucked(stage.toolbox)


def test_a_robot_that_cannot_says_so(stage_with, monkeypatch):
    stage = stage_with()
    monkeypatch.setattr("trees.skills.walking.draw_arms_in.tucked_joints", lambda _: {})

    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.FAILURE
    assert "no arm to draw in" in stage.failed()[0].message


@pytest.mark.requirement("S2")
@pytest.mark.parametrize(("point_m", "come_out"), [((0.35, 0.3, 1.0), False), ((0.9, 0.3, 1.0), True)])
def test_hands_do_not_come_out_into_what_the_range_sensor_sees(stage_with, point_m, come_out):
    stage = stage_with(walks=True)
    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS
    stage.fake.ranging.points_m = np.array([point_m])

    out = stage.run(DrawArmsIn("out", stage.toolbox, out=True))

    assert (out is Status.SUCCESS) is come_out
    assert arms_are_tucked(stage.toolbox) is not come_out


@pytest.mark.requirement("S2")
def test_hands_stay_in_while_the_range_sensor_is_silent(stage_with):
    stage = stage_with(walks=True)
    assert stage.run(DrawArmsIn("in", stage.toolbox)) is Status.SUCCESS
    stage.fake.ranging.silent = True

    assert stage.run(DrawArmsIn("out", stage.toolbox, out=True)) is Status.FAILURE

    assert "range sensor" in stage.failed()[0].message
    assert arms_are_tucked(stage.toolbox)
