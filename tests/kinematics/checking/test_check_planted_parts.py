"""The referee knows things of convex parts as what they are, and the checker misses none of them."""

import functools

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Box
from kinematics.motion.verdict import Unsafe
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tools.checking.generator import Generator
from tools.checking.placing import shape_of_parts
from tools.checking.solid_world import SolidWorld

_UNIT = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])


@pytest.fixture(scope="module")
def generator(talos):
    return Generator(talos, longest_s=3.0, parts=True)


@pytest.fixture(scope="module")
def remembered(generator):
    """A case by kind and number, planted and judged by the referee once for both ways of checking."""
    return functools.cache(
        lambda kind, number: generator.case(kind, np.random.default_rng([12, number, len(kind)]))
    )


@pytest.mark.parametrize("seed", range(5))
def test_parts_at_random_fill_their_box_and_no_more(seed):
    shape = shape_of_parts(np.random.default_rng(seed), (0.1, 0.2, 0.05))

    assert np.ptp(shape.parts.corners, axis=0) == pytest.approx(shape.size_m)
    assert np.abs(shape.parts.corners).max(axis=0) == pytest.approx(0.5 * np.array(shape.size_m))
    assert len(shape.parts.hulls) >= 2


def test_between_two_parts_there_is_room_in_the_referee_s_world(talos):
    """Two boards far apart: a hand between them touches neither, though the outline holds it."""
    hand = talos.frame_pose(talos.q_home, talos.description.tcp_frames["left"])
    boards = np.concatenate([_UNIT * (0.02, 1.0, 1.0) + (x, 0.0, 0.0) for x in (-0.6, 0.6)])
    thing = Box((1.22, 1.0, 1.0), ConvexParts("boards", boards, (8, 16)))
    place = poses.translation(*hand[:3, 3])

    def gap_m(shape):
        scene = PlanningScene().with_object(SceneObject("thing", shape, place))
        world = SolidWorld(talos, scene, only=frozenset({"thing"}))
        return float(world.gaps(talos.q_home).min()), len(world.solids_of("thing"))

    assert gap_m(Box(thing.size_m))[0] < 0.0
    gap, count = gap_m(thing)
    assert gap > 0.0
    assert count == 2


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("kind", ["scene", "held"])
def test_every_defect_amid_things_of_parts_is_refused(remembered, checker, kind):
    for number in range(3):
        planted = remembered(kind, number)

        answer = checker.check(planted.trajectory, planted.scene)

        assert isinstance(answer, Unsafe), (kind, number, planted.verdict)
        assert all(item.shape.parts is not None for item in planted.scene.objects.values())
