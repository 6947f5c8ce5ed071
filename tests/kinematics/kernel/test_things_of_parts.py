import numpy as np
import pytest

from kinematics.collision.collision_world import CollisionWorld, HandCollision
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.kernel.hand_kernel import HandKernel, hand_arrays
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tests.kinematics.parts_of_things import arch, random_parts


def with_things_of_parts(rng, scene, count=4):
    for k in range(count):
        turn = rng.normal(size=4)
        place = poses.transform(
            poses.rotation_from_quaternion(turn / np.linalg.norm(turn)),
            rng.uniform([0.3, -0.7, 0.7], [0.8, 0.7, 1.4]),
        )
        scene = scene.with_object(
            SceneObject(f"part {k}", random_parts(rng, f"part {k}"), place, rng.uniform(0, 0.02))
        )
    return scene


@pytest.mark.parametrize("seed", range(4))
def test_the_kernel_agrees_with_coal_amid_things_of_parts(
    seed, arrays, talos, stance, space, make, at_random
):
    rng = np.random.default_rng(seed)
    scene = with_things_of_parts(rng, at_random.scene(rng, talos, make, held=seed % 2 == 1))
    kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene, 0.004, 0.005)
    world = CollisionWorld(talos, scene, 0.004, 0.005)
    q = space.to_q(np.array([at_random.point(rng, talos, space) for _ in range(150)]))[0]

    ours, theirs = [kernel.collides(c) for c in q], [world.collides(c) for c in q]

    assert 10 < sum(theirs) < 145
    assert ours == theirs


@pytest.mark.parametrize("seed", range(3))
def test_it_agrees_with_coal_about_a_thing_of_parts_in_the_hand(
    seed, arrays, talos, stance, space, make, at_random
):
    rng = np.random.default_rng(50 + seed)
    gripper = talos.description.grippers["right"]
    scene = with_things_of_parts(rng, at_random.scene(rng, talos, make), 2)
    scene = scene.with_object(SceneObject("held", random_parts(rng, "held"), np.eye(4), 0.01))
    scene = scene.with_attached("held", gripper.tcp_frame, poses.translation(0.05, 0, 0), gripper.touch_links)
    kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene, 0.004, 0.005)
    world = CollisionWorld(talos, scene, 0.004, 0.005)
    q = space.to_q(np.array([at_random.point(rng, talos, space) for _ in range(150)]))[0]

    assert [kernel.collides(c) for c in q] == [world.collides(c) for c in q]


def test_an_edge_amid_things_of_parts_that_is_proven_free_is_free_wherever_coal_looks(
    arrays, talos, stance, space, make, at_random
):
    rng = np.random.default_rng(7)
    proven = 0
    for _ in range(5):
        scene = with_things_of_parts(rng, PlanningScene().with_object(make.table()), 3)
        kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene, 0.004, 0.005)
        world = CollisionWorld(talos, scene, 0.004, 0.005)
        for _ in range(60):
            a = at_random.point(rng, talos, space)
            b = a.copy()
            b[[space.index(joint) for joint in talos.description.groups["right_arm"]]] += (
                rng.normal(size=7) / 8
            )
            if kernel.edge_is_free(a, b):
                proven += 1
                between = a + np.linspace(0.0, 1.0, 12)[:, None] * (b - a)
                assert not any(world.collides(q) for q in space.to_q(between)[0])
    assert proven > 20


def test_a_hand_fits_between_two_parts_whose_hull_it_would_be_in(talos):
    thing = SceneObject("arch", arch(apart_m=0.5), poses.translation(0.6, 0.0, 1.0), 0.01)
    scene = PlanningScene().with_object(thing)
    filled = PlanningScene().with_object(
        SceneObject("post", Cylinder(0.24, 0.3), poses.translation(0.6, 0.0, 1.0))
    )
    between = poses.translation(0.6, 0.0, 1.0)[None]
    in_a_plate = poses.translation(0.6, 0.25, 1.0)[None]
    hand = hand_arrays(talos, "right")

    ours, coals = (
        HandKernel(hand, scene, "nothing", 0.0),
        HandCollision(talos, "right", scene, "nothing", 0.0),
    )

    assert not ours.collisions(between)[0]
    assert ours.collisions(in_a_plate)[0]
    assert HandKernel(hand, filled, "nothing", 0.0).collisions(between)[0]
    assert not coals.collisions(between)[0]
    assert coals.collisions(in_a_plate)[0]
    assert ours.clearance_m(between[0], 0.5) == pytest.approx(coals.clearance_m(between[0], 0.5), abs=1e-4)
