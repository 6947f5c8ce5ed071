"""What touches what, as the simulator knows it."""

from dataclasses import replace

from kinematics.geometry import poses
from robots.scenes.scene_file import load_scene


def test_a_hand_that_leans_on_the_table_is_reported(stand, arm_posture):
    scene = load_scene("tabletop")
    high = replace(scene.furniture[0], size_m=(0.6, 1.2, 1.02))
    body = stand(replace(scene, furniture=(high,), objects=()))
    assert body.truth.contacts.robot_with_furniture() == ()

    body.move_to(arm_posture(body.model, "right", poses.translation(0.38, -0.30, 1.03)), 2.0)
    touching = body.truth.contacts.robot_with_furniture()

    assert touching, body.truth.world_T_tcp("right")
    assert {contact.second for contact in touching} == {"table/top"}
    assert all("right" in contact.first for contact in touching)
    assert max(contact.force_n for contact in touching) > 1.0
