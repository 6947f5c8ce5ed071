"""Contacts with things of several convex parts, by both of the checker's certificates."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.motion.verdict import CheckedTrajectory, FindingKind
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tests.kinematics.parts_of_things import CORNERS, moved, of_hulls, outlined

SHOULDER = "arm_right_1_joint"


@pytest.fixture(scope="module")
def swing(motions):
    return motions.joint(SHOULDER, 0.5, 1.6, 161)


def two_plates(half_gap_m):
    """Above and below the origin."""
    plate = CORNERS * (0.3, 0.6, 0.02)
    return outlined(of_hulls(f"plates {half_gap_m}", [moved(plate, z=side * half_gap_m) for side in (-1, 1)]))


def at_hand(talos, q):
    return poses.translation(*talos.frame_pose(q, "tcp_right")[:3, 3])


@pytest.mark.requirement("S6")
def test_a_hand_may_be_between_two_parts(talos, checker, swing):
    thing = SceneObject("frame", two_plates(0.45), at_hand(talos, swing.q[80]))

    assert isinstance(checker.check(swing, PlanningScene().with_object(thing)), CheckedTrajectory)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("seed", range(6))
def test_each_of_its_parts_is_found(seed, talos, checker, swing, findings_of):
    rng = np.random.default_rng(seed)
    small = 0.01 * rng.normal(size=(12, 3))
    others = [small + rng.uniform(-1, 1, 3) + (0, 0, 1.5) for _ in range(int(rng.integers(1, 5)))]
    hulls = [*others]
    hulls.insert(int(rng.integers(len(hulls) + 1)), small)
    thing = SceneObject("mobile", outlined(of_hulls(f"mobile {seed}", hulls)), at_hand(talos, swing.q[110]))
    far = SceneObject("mobile", outlined(of_hulls(f"far {seed}", others)), thing.world_T_object)

    found = findings_of(checker.check(swing, PlanningScene().with_object(thing)))

    assert any(kind is FindingKind.SCENE_COLLISION and "mobile" in names for kind, *names in found)
    assert isinstance(checker.check(swing, PlanningScene().with_object(far)), CheckedTrajectory)


@pytest.mark.requirement("S6")
def test_a_part_that_is_held_is_judged_against_what_is_around_and_not_against_its_like(
    talos, checker, swing, findings_of
):
    gripper = talos.description.grippers["right"]
    stick = CORNERS * 0.02
    held = outlined(of_hulls("stick", [stick, moved(stick, z=0.015), moved(stick, z=-0.35)]))
    scene = PlanningScene().with_object(SceneObject("stick", held, np.eye(4)))
    scene = scene.with_attached("stick", gripper.tcp_frame, np.eye(4), gripper.touch_links)
    end = talos.frame_pose(swing.q[100], gripper.tcp_frame) @ poses.translation(0.0, 0.0, -0.35)
    post = SceneObject("post", outlined(of_hulls("post", [0.5 * stick])), poses.translation(*end[:3, 3]))

    alone, hit = checker.check(swing, scene), checker.check(swing, scene.with_object(post))

    assert isinstance(alone, CheckedTrajectory)
    assert {kind for kind, *_ in findings_of(hit)} == {FindingKind.HELD_OBJECT_COLLISION}
