"""The checker on trial: random motions with planted defects, judged by an independent referee.

``python -m tools.checking.campaign --count 2000`` is the long form.
"""

import functools

import numpy as np
import pytest

from kinematics.checking.kinematics import BatchedKinematics
from kinematics.checking.pairs import PairBuilder
from kinematics.checking.settings import CheckSettings
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import Unsafe
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description
from tools.checking.generator import DEFECTS, Generator
from tools.checking.referee import Referee

CASES_EACH = 3


@pytest.fixture(scope="module")
def generator(talos):
    return Generator(talos, longest_s=3.0)


def case(generator, kind, number):
    return generator.case(kind, np.random.default_rng([11, number, len(kind)]))


@pytest.fixture(scope="module")
def remembered(generator):
    """A case by kind and number, planted and judged by the referee once for both ways of checking."""
    return functools.cache(functools.partial(case, generator))


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("kind", DEFECTS)
def test_every_defect_that_the_referee_sees_is_refused(remembered, checker, kind):
    for number in range(CASES_EACH):
        planted = remembered(kind, number)

        answer = checker.check(planted.trajectory, planted.scene)

        assert isinstance(answer, Unsafe), (kind, number, planted.verdict)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("number", range(5 * CASES_EACH))
def test_what_the_referee_finds_sound_is_not_refused(remembered, checker, number):
    sound = remembered("sound", number)

    answer = checker.check(sound.trajectory, sound.scene)

    assert not isinstance(answer, Unsafe), (number, str(answer), sound.verdict)


@pytest.fixture(scope="module", params=["panda", "g1"])
def of_another_body(request):
    model = RobotModel(load_description(request.param))
    return Generator(model, longest_s=3.0), TrajectoryChecker(model)


@pytest.mark.requirement("U4")
def test_of_other_bodies_too_defects_are_refused_and_sound_motions_are_not(of_another_body):
    generator, checker = of_another_body
    for kind in (*generator.defects, "sound"):
        planted = case(generator, kind, 0)
        answer = checker.check(planted.trajectory, planted.scene)
        assert isinstance(answer, Unsafe) == (kind != "sound"), (kind, planted.verdict, str(answer))


def missed(checker, cases):
    return [
        planted
        for planted in cases
        if not isinstance(checker.check(planted.trajectory, planted.scene), Unsafe)
    ]


@pytest.fixture(scope="module")
def collisions(remembered):
    return [remembered("scene", number) for number in range(2 * CASES_EACH)]


@pytest.mark.parametrize("compiled", [True, False])
def test_a_checker_that_leaves_out_a_link_is_caught(talos, motions, checker, monkeypatch, compiled):
    foot = "leg_right_6_link"
    item = next(item for item in talos.geometry().geometryObjects if talos.link_of(item) == foot)
    points = item.geometry.points() @ item.placement.rotation.T + item.placement.translation
    world_T_foot = talos.frame_pose(talos.q_home, foot)
    bead = SceneObject("bead", Ball(0.004), world_T_foot @ poses.translation(*points[points[:, 0].argmax()]))
    scene, still = PlanningScene().with_object(bead), motions.still()
    assert Referee(talos).judge(still, scene).unsafe
    assert isinstance(checker.check(still, scene), Unsafe)
    build = PairBuilder.pairs

    def without_the_foot(self, scene):
        pairs = build(self, scene)
        keep = np.array([pairs.solids[i].name != foot for i in pairs.first])
        return pairs.only(np.flatnonzero(keep))

    monkeypatch.setattr(PairBuilder, "pairs", without_the_foot)

    assert not isinstance(TrajectoryChecker(talos, compiled=compiled).check(still, scene), Unsafe)


@pytest.mark.parametrize("compiled", [True, False])
def test_a_checker_that_trusts_the_instants_it_looks_at_is_caught(talos, collisions, monkeypatch, compiled):
    """Without the reach of the links the certificate is a plain check in the middle of its intervals."""
    coarse = CheckSettings(cell_s=0.8, cut_rad=np.inf)
    assert not missed(TrajectoryChecker(talos, coarse, compiled), collisions)

    reaches = BatchedKinematics.reaches

    def nothing(self, *solid):
        return [0.0 * reach for reach in reaches(self, *solid)]

    monkeypatch.setattr(BatchedKinematics, "reaches", nothing)

    assert missed(TrajectoryChecker(talos, coarse, compiled), collisions)


@pytest.mark.parametrize("kind", ["self", "scene", "held", "thin", "jump"])
def test_compiled_code_and_coal_find_the_same(talos, remembered, kind):
    planted = remembered(kind, 1)

    answers = [
        TrajectoryChecker(talos, compiled=way).check(planted.trajectory, planted.scene)
        for way in (True, False)
    ]

    assert all(isinstance(answer, Unsafe) for answer in answers)
    found, coals = ({(f.kind, f.subject): f for f in answer.findings} for answer in answers)
    assert found.keys() == coals.keys()
    for key, finding in found.items():
        # Coal's times are the middles of cells of 40 ms or less
        assert coals[key].t_s - 0.021 <= finding.t_s <= coals[key].t_s + 0.001, key
        assert finding.limit == coals[key].limit
