import numpy as np
from py_trees.common import Status

from trees.skills.pick.attach import Attach


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
