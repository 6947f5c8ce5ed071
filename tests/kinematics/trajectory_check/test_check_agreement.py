"""The checker on trial: random motions with planted defects, judged by an independent referee.

``python -m tools.checking.campaign --count 2000`` is the long form.
"""

import numpy as np
import pytest

from kinematics.check_pairs import PairBuilder
from kinematics.check_settings import CheckSettings
from kinematics.check_timeline import Timeline
from kinematics.trajectory import Unsafe
from kinematics.trajectory_check import TrajectoryChecker
from tools.checking.generator import DEFECTS, Generator

CASES_EACH = 4


@pytest.fixture(scope="module")
def generator(talos):
    return Generator(talos, longest_s=3.0)


def case(generator, kind, number):
    return generator.case(kind, np.random.default_rng([11, number, len(kind)]))


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("kind", DEFECTS)
def test_every_defect_that_the_referee_sees_is_refused(generator, checker, kind):
    for number in range(CASES_EACH):
        planted = case(generator, kind, number)

        answer = checker.check(planted.trajectory, planted.scene)

        assert isinstance(answer, Unsafe), (kind, number, planted.verdict)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("number", range(5 * CASES_EACH))
def test_what_the_referee_finds_sound_is_not_refused(generator, checker, number):
    sound = case(generator, "sound", number)

    answer = checker.check(sound.trajectory, sound.scene)

    assert not isinstance(answer, Unsafe), (number, str(answer), sound.verdict)


def missed(checker, cases):
    return [
        planted
        for planted in cases
        if not isinstance(checker.check(planted.trajectory, planted.scene), Unsafe)
    ]


@pytest.fixture(scope="module")
def collisions(generator):
    return [case(generator, "scene", number) for number in range(2 * CASES_EACH)]


def test_a_checker_that_leaves_out_a_link_is_caught(talos, collisions, monkeypatch):
    build = PairBuilder.pairs

    def without_the_touched(self, scene):
        pairs = build(self, scene)
        touched = collisions[0].verdict.violations["scene"][1].split(" and ")[0]
        keep = np.array([pairs.solids[i].name != touched for i in pairs.first])
        return type(pairs)(
            pairs.solids,
            pairs.first[keep],
            pairs.second[keep],
            pairs.clearance_m[keep],
            tuple(kind for kind, kept in zip(pairs.kinds, keep, strict=True) if kept),
            pairs.rate[:, keep],
        )

    monkeypatch.setattr(PairBuilder, "pairs", without_the_touched)

    assert missed(TrajectoryChecker(talos), collisions)


def test_a_checker_that_trusts_the_instants_it_looks_at_is_caught(talos, collisions, monkeypatch):
    """Without path lengths the certificate is a plain check at every cell's middle."""
    coarse = TrajectoryChecker(talos, CheckSettings(cell_s=0.8))
    assert not missed(coarse, collisions)

    lengths = Timeline.path_lengths
    monkeypatch.setattr(Timeline, "path_lengths", lambda self, knots: 0.0 * lengths(self, knots))

    assert missed(coarse, collisions)
