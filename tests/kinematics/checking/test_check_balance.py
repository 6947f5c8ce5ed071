from dataclasses import replace

import numpy as np
import pytest

from kinematics.model.stance import Stance
from kinematics.motion.verdict import FindingKind, Unsafe
from kinematics.scene.planning_scene import PlanningScene
from tools.checking.motions import Choreographer, Motion
from tools.checking.profiles import Profile
from tools.checking.referee import Referee


@pytest.fixture(scope="module")
def choreographer(talos):
    return Choreographer(talos)


def shifted(choreographer, direction, shift_m, samples=151, duration_s=3.0):
    motion = Motion({}, {direction: Profile(shift_m)})
    return choreographer.trajectory(motion, duration_s, np.linspace(0.0, duration_s, samples))


@pytest.mark.requirement("S6")
@pytest.mark.parametrize(("direction", "way"), [("x", 1.0), ("x", -1.0), ("y", 1.0), ("y", -1.0)])
def test_a_com_5_mm_outside_its_margin_is_refused(talos, choreographer, checker, direction, way):
    referee, margin = Referee(talos), talos.description.com_margin_m
    shift = 0.0
    while referee.com_margin_m(shifted(choreographer, direction, way * shift, samples=9)) > margin - 0.005:
        shift += 0.002
    reach = shift - 0.012
    within, beyond = (shifted(choreographer, direction, way * s) for s in (reach, shift))

    assert not isinstance(checker.check(within, PlanningScene()), Unsafe)
    answer = checker.check(beyond, PlanningScene())
    assert isinstance(answer, Unsafe)
    assert answer.findings[0].kind is FindingKind.BALANCE
    assert answer.findings[0].limit == margin


@pytest.mark.requirement("S6")
def test_a_motion_too_hasty_for_the_feet_is_refused_for_its_zmp(choreographer, checker, findings_of):
    sway = Motion({}, {"x": Profile(0.0, back=0.05)})
    slow = choreographer.trajectory(sway, 3.0, np.linspace(0.0, 3.0, 151))
    hasty = choreographer.trajectory(sway, 0.6, np.linspace(0.0, 0.6, 151))

    assert findings_of(checker.check(slow, PlanningScene())) == set()
    assert (FindingKind.BALANCE, "ZMP") in findings_of(checker.check(hasty, PlanningScene()))


@pytest.mark.requirement("S6")
@pytest.mark.parametrize(("row", "change"), [(0, 0.0015), (2, 0.0015), (5, 0.004)])
def test_feet_that_leave_their_place_are_refused(motions, checker, findings_of, row, change):
    still = motions.still()
    q = still.q.copy()
    ramp = np.sin(np.pi * still.t_s) ** 2
    q[:, row] += change * ramp
    q[:, 3:7] /= np.linalg.norm(q[:, 3:7], axis=1, keepdims=True)
    kinds = {kind for kind, *_ in findings_of(checker.check(replace(still, q=q), PlanningScene()))}

    assert FindingKind.STANCE in kinds


def test_the_stance_is_judged_between_samples_too(motions, checker, findings_of):
    still = motions.still(1.0, 3)
    v = still.v.copy()
    v[1, 2] = 0.02  # the base bobs by 1.5 mm on both sides of the middle sample

    kinds = {kind for kind, *_ in findings_of(checker.check(replace(still, v=v), PlanningScene()))}

    assert FindingKind.STANCE in kinds


def test_pelvis_motions_with_the_feet_in_place_are_safe(choreographer, checker, findings_of):
    for direction, change in (("x", 0.03), ("y", 0.04), ("z", -0.08), ("yaw", 0.15), ("pitch", 0.1)):
        motion = shifted(choreographer, direction, change)
        assert findings_of(checker.check(motion, PlanningScene())) == set(), direction


def test_nothing_stands_without_a_foot(motions, checker, findings_of):
    floating = replace(motions.still(), stance=Stance(()))

    assert (FindingKind.BALANCE, "CoM") in findings_of(checker.check(floating, PlanningScene()))
