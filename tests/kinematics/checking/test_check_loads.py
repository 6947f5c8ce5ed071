"""What the hands carry counts in balance and efforts."""

import numpy as np
import pytest

from kinematics.checking.kinematics import BatchedKinematics
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.motion.verdict import CheckedTrajectory, FindingKind
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tools.checking.motions import Choreographer, Motion
from tools.checking.profiles import Profile
from tools.checking.referee import Referee


@pytest.fixture(scope="module")
def holding(talos):
    def hold(mass_kg):
        gripper = talos.description.grippers["left"]
        scene = PlanningScene().with_object(SceneObject("bottle", Cylinder(0.03, 0.16), np.eye(4)))
        place = poses.translation(0.0, 0.0, 0.0)
        return scene.with_attached("bottle", gripper.tcp_frame, place, gripper.touch_links, mass_kg)

    return hold


@pytest.fixture(scope="module")
def near_the_edge(talos):
    """The pelvis leans to the side to where the CoM of the empty robot is just inside its margin."""
    choreographer, referee, shift = Choreographer(talos), Referee(talos), 0.0

    def leaning(shift_m):
        motion = Motion({}, {"y": Profile(shift_m)})
        return choreographer.trajectory(motion, 3.0, np.linspace(0.0, 3.0, 151))

    while referee.com_margin_m(leaning(shift + 0.002)) > talos.description.com_margin_m + 0.001:
        shift += 0.002
    return leaning(shift)


def test_a_com_that_a_held_mass_takes_beyond_its_margin_is_refused(
    near_the_edge, holding, checker, findings_of
):
    assert findings_of(checker.check(near_the_edge, holding(0.0))) == set()
    assert (FindingKind.BALANCE, "CoM") in findings_of(checker.check(near_the_edge, holding(3.0)))


def test_the_margin_with_a_held_mass_is_that_of_an_independent_referee(talos, motions, holding, checker):
    still, scene = motions.still(), holding(1.0)

    checked = checker.check(still, scene)

    assert isinstance(checked, CheckedTrajectory)
    assert checked.min_com_margin_m == pytest.approx(
        Referee(talos).judge(still, scene).com_margin_m, abs=1e-6
    )


def test_efforts_that_a_held_mass_takes_beyond_the_limit_are_refused(motions, holding, checker, findings_of):
    raised = motions.joint("arm_left_4_joint", -0.2)

    kinds = {kind for kind, *_ in findings_of(checker.check(raised, holding(60.0)))}

    assert FindingKind.EFFORT_LIMIT in kinds
    assert FindingKind.EFFORT_LIMIT not in {
        kind for kind, *_ in findings_of(checker.check(raised, holding(0.0)))
    }


def test_the_empty_hand_is_judged_as_before_after_a_load(motions, holding, checker):
    before = checker.check(motions.still(), PlanningScene())
    checker.check(motions.still(), holding(1.0))
    after = checker.check(motions.still(), PlanningScene())

    assert after.min_com_margin_m == before.min_com_margin_m


def test_a_checked_motion_says_what_the_hands_carry_in_it(motions, holding, checker):
    checked = checker.check(motions.still(), holding(1.0))

    assert [(load.frame, load.mass_kg) for load in checked.loads] == [("tcp_left", 1.0)]


def test_a_load_weighs_the_same_to_the_checker_as_to_the_model(talos):
    frame = talos.description.tcp_frames["left"]
    masses = [(frame, 0.7, np.array([0.1, -0.02, 0.03])), (frame, 0.4, np.array([0.0, 0.05, 0.0]))]

    carrying = BatchedKinematics(talos).carrying(talos, masses)

    loaded = BatchedKinematics(talos.with_point_masses(masses))
    for name in ("mass_kg", "lever_m", "inertia"):
        np.testing.assert_allclose(getattr(carrying, name), getattr(loaded, name), rtol=1e-12, atol=1e-12)
