import numpy as np
import pytest

from kinematics.checking.kinematics import BatchedKinematics
from kinematics.checking.pairs import PairBuilder
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.motion.verdict import FindingKind
from kinematics.scene.planning_scene import PlanningScene, SceneObject


@pytest.fixture(scope="module")
def kinematics(talos):
    return BatchedKinematics(talos)


def scenes():
    """Scenes of the same names that differ in all that decides which pairs are judged."""
    table = SceneObject(
        "table", Box((0.8, 1.2, 0.7)), poses.translation(0.8, 0.0, 0.35), 0.015, movable=False
    )
    cup = SceneObject("cup", Ball(0.04), poses.translation(0.6, 0.2, 0.75), 0.01)
    plain = PlanningScene().with_objects([table, cup])
    links = ("gripper_right_base_link", "gripper_right_fingertip_1_link")
    held = plain.with_attached("cup", "tcp_right", np.eye(4), links)
    return (
        plain,
        plain.with_object(SceneObject("cup", Ball(0.06), poses.translation(0.5, 0.1, 0.76), 0.02)),
        plain.allowing((link, "cup") for link in links),
        plain.allowing([("arm_left_7_link", "table"), ("arm_left_7_link", "torso_2_link")]),
        held,
        plain.with_attached("cup", "tcp_right", np.eye(4), links[:1]),
        plain.with_attached("cup", "tcp_left", np.eye(4), links),
        held.allowing([("cup", "table")]),
        plain.with_objects([cup, table]).allowing((link, "cup") for link in links),
    )


def described(pairs):
    names = [solid.name for solid in pairs.solids]
    return [
        (names[i], names[j], pairs.solids[i].body, float(clearance_m), kind)
        for i, j, clearance_m, kind in zip(
            pairs.first, pairs.second, pairs.clearance_m, pairs.kinds, strict=True
        )
    ]


def test_pairs_of_one_scene_after_another_are_those_of_each_scene_alone(talos, kinematics):
    builder = PairBuilder(talos, kinematics)

    for scene in (*scenes(), *scenes()[::-1]):
        found, expected = builder.pairs(scene), PairBuilder(talos, kinematics).pairs(scene)

        assert described(found) == described(expected)
        assert np.array_equal(found.rate, expected.rate)


def test_no_scene_lets_two_links_of_the_robot_touch(talos, kinematics):
    links = sorted({solid.name for solid in PairBuilder(talos, kinematics).robot})
    loose = PlanningScene().allowing((one, other) for one in links for other in links if one < other)

    found = [PairBuilder(talos, kinematics).pairs(scene) for scene in (PlanningScene(), loose)]

    own = [[kind for kind in pairs.kinds if kind is FindingKind.SELF_COLLISION] for pairs in found]
    assert len(own[0]) == len(own[1]) > 0
