import numpy as np
import pytest

from kinematics.collision.collision_world import CollisionWorld, HandCollision
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball
from kinematics.scene.planning_scene import PlanningScene, SceneObject


def ball_near_the_hand(talos, gap_m, margin_m):
    """A ball ahead of the right middle finger, so far from the hand's geometry."""
    place = talos.frame_pose(talos.q_home, "tcp_right") @ poses.translation(0.022 + 0.05 + gap_m, -0.058, 0.0)
    return SceneObject("ball", Ball(0.05), place, margin_m=margin_m)


def test_home_is_free(talos):
    assert not CollisionWorld(talos, PlanningScene()).collides(talos.q_home)


def test_an_object_collides_inside_its_margin_only(talos):
    far = PlanningScene().with_object(ball_near_the_hand(talos, 0.03, 0.01))
    near = PlanningScene().with_object(ball_near_the_hand(talos, 0.03, 0.06))

    assert not CollisionWorld(talos, far).collides(talos.q_home)
    pair = CollisionWorld(talos, near).colliding_pair(talos.q_home)
    assert pair is not None
    assert pair[1] == "ball"
    assert pair[0].startswith("gripper_right")


def test_an_allowed_pair_is_not_judged(talos):
    links = talos.description.grippers["right"].links
    scene = PlanningScene().with_object(ball_near_the_hand(talos, -0.02, 0.0))

    assert CollisionWorld(talos, scene).collides(talos.q_home)
    assert not CollisionWorld(talos, scene.allowing((link, "ball") for link in links)).collides(talos.q_home)


def test_a_held_object_moves_with_the_hand_and_collides_for_it(talos, make):
    gripper = talos.description.grippers["right"]
    scene = PlanningScene().with_objects([make.table(), make.cup(x=0.3, y=-0.6, top_m=1.2)])
    held = scene.with_attached("cup", gripper.tcp_frame, np.eye(4), gripper.touch_links)
    place = talos.frame_pose(talos.q_home, gripper.tcp_frame) @ poses.translation(0.0, 0.0, 0.09)
    blocked = held.with_object(SceneObject("block", Ball(0.05), place))

    assert not CollisionWorld(talos, held).collides(talos.q_home)
    assert CollisionWorld(talos, blocked).collides(talos.q_home)


@pytest.mark.parametrize(("height_m", "collides"), [(0.20, False), (0.02, True)])
def test_the_hand_alone_is_judged_without_the_arm(talos, make, height_m, collides):
    scene = PlanningScene().with_objects([make.table(top_m=0.85), make.cup()])
    hand = HandCollision(talos, "right", scene, "cup", 0.0)

    assert hand.collides(poses.translation(0.5, -0.2, 0.85 + height_m)) is collides
