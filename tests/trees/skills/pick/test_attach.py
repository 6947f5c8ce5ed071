import dataclasses

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from trees.skills.pick.attach import Attach


class OnPalm:
    """A model whose fingers close on a palm."""

    def __init__(self, model):
        self._model = model
        grippers = {
            hand: dataclasses.replace(gripper, palm_side_m=0.03)
            for hand, gripper in model.description.grippers.items()
        }
        self.description = dataclasses.replace(model.description, grippers=grippers)

    def __getattr__(self, name):
        return getattr(self._model, name)


def test_the_object_moves_from_the_world_into_the_hand(knowing, planned, target):
    planned.grip()
    leaf = Attach("attach", knowing.toolbox)

    status = knowing.run(leaf, grasp=planned.grasp, target=target, lift=planned.step("lift"))

    assert status is Status.SUCCESS
    body = knowing.told.scene.attached["red cup"]
    assert "red cup" not in knowing.told.scene.objects
    assert body.frame == "tcp_right"
    assert "gripper_right_fingertip_1_link" in body.touch_links
    np.testing.assert_allclose(body.frame_T_object[:3, 3], 0.0, atol=1e-5)


def test_the_lift_is_to_be_checked_with_the_object_in_the_hand(knowing, planned, target):
    planned.grip()
    knowing.run(
        Attach("attach", knowing.toolbox), grasp=planned.grasp, target=target, lift=planned.step("lift")
    )

    lift = knowing.output("held_lift")
    assert "red cup" in lift.scene.attached
    assert lift.world_version == knowing.told.scene.version
    assert "gripper_right_fingertip_1_link" in lift.scene.attached["red cup"].touch_links
    assert lift.concessions == planned.step("lift").concessions


@pytest.mark.requirement("U4")
def test_what_stood_aslant_in_fingers_that_close_on_a_palm_is_believed_along_them(knowing, planned, target):
    planned.grip()
    leaning = target.odom_T_object @ poses.transform(poses.rotation_x(0.3), np.zeros(3))
    aslant = dataclasses.replace(target, odom_T_object=leaning)
    toolbox = dataclasses.replace(knowing.toolbox, model=OnPalm(knowing.toolbox.model))

    knowing.run(Attach("attach", toolbox), grasp=planned.grasp, target=aslant, lift=planned.step("lift"))

    held = knowing.told.scene.attached["red cup"].frame_T_object
    np.testing.assert_allclose(held[:3, 2], [0.0, 0.0, 1.0], atol=1e-9)


@pytest.mark.requirement("U4")
@pytest.mark.parametrize(
    ("palm", "sine", "leans"), [(True, 0.34, {"red cup"}), (True, 0.05, set()), (False, 0.34, set())]
)
def test_what_fingers_on_a_palm_took_steeply_may_lean(
    knowing, planned, target, monkeypatch, palm, sine, leans
):
    planned.grip()
    model = OnPalm(knowing.toolbox.model) if palm else knowing.toolbox.model
    toolbox = dataclasses.replace(knowing.toolbox, model=model)
    there = planned.grasp.world_T_tcp.copy()
    there[2, 0] = -sine
    monkeypatch.setattr(type(knowing.toolbox.model), "frame_pose", lambda *_: there)

    knowing.run(Attach("attach", toolbox), grasp=planned.grasp, target=target, lift=planned.step("lift"))

    assert toolbox.world.leans == leans
