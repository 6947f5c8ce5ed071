"""Arms drawn in: as narrow as the room that a walk keeps for them, and narrower than hands at home."""

import itertools

import numpy as np
import pinocchio as pin
import pytest

from kinematics.collision.collision_world import CollisionWorld
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.pattern.steering import PathSteering, foreseen
from kinematics.walking.route.room import WalkingRoom
from robots.models.description import load_description

DESCRIPTION = load_description("talos")
SETTINGS = DESCRIPTION.walking
HOME, TUCKED = WalkingRoom(SETTINGS), WalkingRoom(SETTINGS, tucked=True)


@pytest.fixture(scope="module")
def talos():
    return RobotModel(DESCRIPTION)


def drawn_in(talos, sides):
    """At home but for the arms of some sides."""
    q = talos.q_home.copy()
    for name, at in SETTINGS.tucked.joints.items():
        if name.split("_")[1] in sides:
            q[7 + talos.joint_index(name)] = at
    return q


def post(x_m, y_m, height_m=1.4):
    """Something thin that stands somewhere."""
    pose = poses.translation(x_m, y_m, 0.5 * height_m)
    return PlanningScene().with_objects(
        [SceneObject("post", Box((0.04, 0.04, height_m)), pose, movable=False)]
    )


def turn_by(angle_rad):
    """Where the body comes by as it turns on the spot."""
    return foreseen(PathSteering(SETTINGS, (PlanarPose(), PlanarPose(yaw_rad=angle_rad))), PlanarPose())


def corners(talos, q, links):
    """Corners of the boxes around some links, in the world, shape (n, 3)."""
    geometry, data = talos.geometry(), talos.pin.createData()
    pin.forwardKinematics(talos.pin, data, q)
    found = []
    for item in geometry.geometryObjects:
        if not talos.link_of(item).startswith(links):
            continue
        item.geometry.computeLocalAABB()
        low, high = item.geometry.aabb_local.min_, item.geometry.aabb_local.max_
        local = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, -1).T
        pose = data.oMi[item.parentJoint].homogeneous @ item.placement.homogeneous
        found.append(local @ pose[:3, :3].T + pose[:3, 3])
    return np.concatenate(found)


@pytest.mark.requirement("S2")
def test_arms_that_are_drawn_in_take_the_room_that_is_kept_for_them(talos):
    tucked, spare_m = SETTINGS.tucked, 0.03  # boxes around round links are wider than they are
    q = drawn_in(talos, ("left", "right"))

    x, y, z = (corners(talos, q, ("arm", "wrist", "gripper")) - [*talos.q_home[:2], 0.0]).T

    assert x.max() <= tucked.front_m + spare_m
    assert np.abs(y).max() <= tucked.half_width_m + spare_m
    assert np.hypot(x, y).max() <= tucked.radius_m + spare_m
    assert z.min() >= tucked.from_m
    assert not CollisionWorld(talos, PlanningScene(), self_margin_m=0.008).collides(q)


def test_one_arm_that_is_drawn_in_keeps_clear_of_the_other_one_at_home(talos):
    for side in ("left", "right"):
        assert not CollisionWorld(talos, PlanningScene(), self_margin_m=0.008).collides(
            drawn_in(talos, (side,))
        )


@pytest.mark.requirement("S2")
def test_a_hand_that_turns_comes_to_a_post_that_drawn_in_arms_pass():
    beside = post(0.0, -0.75)

    assert HOME.hands_meet(beside, turn_by(2.0))
    assert not TUCKED.hands_meet(beside, turn_by(2.0))
    assert not HOME.hands_meet(post(0.0, -0.75, height_m=0.8), turn_by(2.0))


def test_only_what_a_hand_comes_by_is_in_its_way():
    ahead = post(0.6, 0.3)

    assert not HOME.hands_meet(ahead, [PlanarPose()])
    assert not HOME.hands_meet(ahead, turn_by(0.1))
    assert HOME.hands_meet(ahead, turn_by(-1.2))
    assert not HOME.hands_meet(PlanningScene(), turn_by(-1.2))


@pytest.mark.parametrize("x_m", [0.01 * k for k in range(-8, 9)])
def test_the_edge_of_a_thin_door_does_not_slip_between_two_points_of_the_outline(x_m):
    edge = SceneObject("door", Box((0.03, 0.5, 1.6)), poses.translation(x_m, 0.68, 0.8), movable=False)
    scene = PlanningScene().with_objects([edge])

    assert TUCKED.hands_meet(scene, [PlanarPose()], 0.0)


def test_a_walk_that_is_foreseen_ends_where_it_is_to_end():
    goal = PlanarPose(1.5, 1.0, 2.5)

    way = foreseen(PathSteering(SETTINGS, (PlanarPose(), PlanarPose(1.5, 0.0), goal)), PlanarPose())

    assert way[-1].distance_m(goal) < 0.01
    assert abs(way[-1].to(goal).yaw_rad) < 0.01
    assert max(a.distance_m(b) for a, b in itertools.pairwise(way)) <= SETTINGS.forward_m / 4


def test_drawn_in_arms_turn_nearer_to_what_is_seen():
    seen = np.array([(0.0, 0.64, 1.2)])

    assert HOME.tightest_seen(seen).lack_m > 0.0
    assert TUCKED.tightest_seen(seen).lack_m < 0.0
