"""A motion that begins or ends moving cannot be played, so it is not safe."""

from dataclasses import replace

import pytest

from kinematics.motion.verdict import CheckedTrajectory, FindingKind
from kinematics.scene.planning_scene import PlanningScene

HEAD = "head_1_joint"


def with_speed(motion, column, speed, *, at):
    v = motion.v.copy()
    v[at, column] = speed
    return replace(motion, v=v)


@pytest.mark.parametrize(("at", "t_s"), [(0, 0.0), (-1, 1.0)])
def test_a_joint_that_moves_at_an_end_is_found_there(talos, checker, motions, at, t_s):
    moving = with_speed(motions.still(), 6 + talos.joint_index(HEAD), 0.0015, at=at)

    found = checker.check(moving, PlanningScene()).findings

    assert [(f.kind, f.subject, f.t_s, f.value) for f in found] == [
        (FindingKind.BOUNDARY_VELOCITY, (HEAD,), t_s, 0.0015)
    ]


@pytest.mark.parametrize(("column", "subject"), [(2, "base velocity"), (4, "base angular velocity")])
def test_a_base_that_moves_at_the_end_is_found(checker, motions, findings_of, column, subject):
    moving = with_speed(motions.still(), column, -0.002, at=-1)

    assert (FindingKind.BOUNDARY_VELOCITY, subject) in findings_of(checker.check(moving, PlanningScene()))


def test_what_moves_at_both_ends_is_one_finding_with_the_larger_speed(talos, checker, motions):
    column = 6 + talos.joint_index(HEAD)
    moving = with_speed(with_speed(motions.still(), column, 0.0012, at=0), column, -0.0016, at=-1)

    found = checker.check(moving, PlanningScene()).findings

    assert [(f.t_s, f.value) for f in found if f.kind is FindingKind.BOUNDARY_VELOCITY] == [(0.0, 0.0016)]


def test_a_speed_that_the_streamer_takes_for_rest_is_safe(talos, checker, motions):
    resting = with_speed(motions.still(), 6 + talos.joint_index(HEAD), 0.0009, at=-1)

    assert isinstance(checker.check(resting, PlanningScene()), CheckedTrajectory)
