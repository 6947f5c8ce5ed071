import numpy as np
import pytest
from py_trees.common import Status

from trees.readings.held import held_objects
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.pick.attach import Attach
from trees.skills.place.see_held import SeeHeld


@pytest.fixture
def carrying(knowing, planned, target):
    """The stage with the cup lifted in the right hand, and the head turned to it."""
    planned.grip()
    inputs = {"grasp": planned.grasp, "target": target}
    knowing.run(Attach("attach", knowing.toolbox), lift=planned.step("lift"), **inputs)
    planned.play("lift")
    knowing.run(LookAtTarget("look", knowing.toolbox), **inputs)
    return knowing


def see(stage):
    leaf = SeeHeld("see it in the hand", stage.toolbox)
    stage.fake.step()
    assert stage.run(leaf, held=held_objects(stage.toolbox)[0]) is Status.SUCCESS


def believed(stage):
    return stage.told.scene.attached["red cup"].frame_T_object[:3, 3]


def true_place(stage):
    body = stage.told.scene.attached["red cup"]
    q = stage.toolbox.sensing.state().q
    world_T_tcp = stage.toolbox.model.frame_pose(q, body.frame)
    return (np.linalg.inv(world_T_tcp) @ stage.fake.world.object("red cup").world_T_object)[:3, 3]


@pytest.mark.requirement("M4")
def test_what_has_shifted_in_the_hand_is_believed_to_be_where_it_is_seen(carrying):
    carrying.fake.world.shift_in_hand("red cup", 0.015)
    version = carrying.told.scene.version

    see(carrying)

    assert carrying.output("shifted") is True
    off = believed(carrying) - true_place(carrying)
    assert off[[0, 2]] == pytest.approx(0.0, abs=2e-3)  # y is along the opening, where the fingers hold it
    assert carrying.output("held_now").tcp_T_object[:3, 3] == pytest.approx(believed(carrying))
    assert carrying.told.scene.version != version


def test_nothing_climbs_in_a_hand(carrying):
    carrying.fake.world.shift_in_hand("red cup", -0.015)

    see(carrying)

    assert carrying.output("shifted") is False


def test_what_is_where_it_was_leaves_all_plans_good(carrying):
    carrying.fake.world.shift_in_hand("red cup", 0.003)
    version = carrying.told.scene.version

    see(carrying)

    assert carrying.output("shifted") is False
    assert carrying.told.scene.version == version


def test_what_is_not_seen_is_taken_to_be_where_it_was(carrying):
    carrying.fake.world.hidden.add("red cup")

    see(carrying)

    assert carrying.output("shifted") is False


def test_without_pictures_it_goes_on_with_what_was_believed(carrying, monkeypatch):
    monkeypatch.setattr(carrying.fake.detector, "latest", lambda: None)

    see(carrying)

    assert carrying.output("shifted") is False
