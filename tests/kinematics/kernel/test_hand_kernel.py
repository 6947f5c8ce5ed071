import numpy as np
import pytest

from kinematics.collision.collision_world import HandCollision
from kinematics.geometry import poses
from kinematics.kernel.hand_kernel import HandKernel, hand_arrays
from kinematics.scene.planning_scene import PlanningScene


@pytest.fixture(scope="module")
def hands(talos):
    return {hand: hand_arrays(talos, hand) for hand in ("left", "right")}


def places(rng, count):
    found = np.empty((count, 4, 4))
    for pose in found:
        turn = rng.normal(size=4)
        rotation = poses.rotation_from_quaternion(turn / np.linalg.norm(turn))
        pose[:] = poses.transform(rotation, rng.uniform([0.2, -0.6, 0.6], [0.9, 0.6, 1.3]))
    return found


@pytest.mark.parametrize("hand", ["left", "right"])
def test_it_agrees_with_coal_on_hands_amid_clutter(hand, hands, talos, make, at_random):
    rng = np.random.default_rng(1)
    collided = 0
    for _ in range(4):
        scene = at_random.scene(rng, talos, make)
        ours = HandKernel(hands[hand], scene, "thing_0", 0.004)
        theirs = HandCollision(talos, hand, scene, "thing_0", 0.004)
        world_T_tcp = places(rng, 60)

        found = ours.collisions(world_T_tcp)

        # its distances: its quick look at corners takes the edges of margins for sharp
        assert found.tolist() == [theirs.clearance_m(pose, 0.03) <= 0.0 for pose in world_T_tcp]
        collided += int(found.sum())
    assert 20 < collided < 220


def test_its_clearance_is_coals(hands, talos, make, at_random):
    rng = np.random.default_rng(2)
    scene = at_random.scene(rng, talos, make)
    ours = HandKernel(hands["right"], scene, "thing_0", 0.004)
    theirs = HandCollision(talos, "right", scene, "thing_0", 0.004)
    compared = 0
    for world_T_tcp in places(rng, 60):
        expected = theirs.clearance_m(world_T_tcp, 0.03)
        if expected > 0.0:
            assert ours.clearance_m(world_T_tcp, 0.03) == pytest.approx(expected, abs=1e-4)
            compared += 1
        else:
            assert ours.clearance_m(world_T_tcp, 0.03) <= 1e-5
    assert compared > 10


def test_with_nothing_around_there_is_all_the_room_that_is_asked_for(hands):
    alone = HandKernel(hands["left"], PlanningScene(), "cup", 0.0)

    assert alone.clearance_m(np.eye(4), 0.03) == 0.03
    assert not alone.collisions(np.eye(4)[None]).any()
