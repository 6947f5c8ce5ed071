from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from kinematics.errors import InvalidMotionError
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, FindingKind, Unsafe
from kinematics.scene.planning_scene import PlanningScene

ELBOW = "arm_right_4_joint"
HEAD = "head_2_joint"


def judge(checker, trajectory):
    return checker.check(trajectory, PlanningScene())


def with_use(motions, kind, fraction, samples=301):
    """A motion of the head that uses a limit to a fraction, and the others less."""
    model = motions.model
    j = model.joint_index(HEAD)
    if kind is FindingKind.VELOCITY_LIMIT:  # a quintic's peaks: 1.875 d/T, 5.7735 d/T^2, 60 d/T^3
        change = 1.0
        duration = 1.875 * change / (fraction * model.velocity[j])
    elif kind is FindingKind.ACCELERATION_LIMIT:
        change = 0.16
        duration = np.sqrt(5.7735 * change / (fraction * model.acceleration[j]))
    else:
        change = 0.02
        duration = np.cbrt(60.0 * change / (fraction * model.jerk[j]))
    return motions.joint(HEAD, change, duration, samples)


@pytest.mark.requirement("S1", "S6")
@pytest.mark.parametrize(
    "kind", [FindingKind.VELOCITY_LIMIT, FindingKind.ACCELERATION_LIMIT, FindingKind.JERK_LIMIT]
)
def test_one_percent_over_a_limit_is_refused_and_just_under_it_is_not(motions, checker, kind, findings_of):
    generous = replace_limits(motions.model, kind)
    motion, fast = with_use(motions, kind, 0.995), with_use(motions, kind, 1.01, 1501)
    with generous:
        assert findings_of(judge(checker, motion)) == set()
        assert findings_of(judge(checker, fast)) == {(kind, HEAD)}


@pytest.mark.requirement("S1", "S6")
@pytest.mark.parametrize(
    "kind", [FindingKind.VELOCITY_LIMIT, FindingKind.ACCELERATION_LIMIT, FindingKind.JERK_LIMIT]
)
def test_a_limit_that_is_passed_by_little_more_than_rounding_is_passed(motions, checker, kind, findings_of):
    j = motions.model.joint_index(HEAD)
    motion = with_use(motions, kind, 0.9)
    generous = replace_limits(motions.model, kind)
    with generous:
        limits, peak = generous.arrays[kind], peak_of(motion, j, kind)
        limits[j] = peak
        assert findings_of(judge(checker, motion)) == set()
        limits[j] = peak / (1.0 + 1e-5)
        assert findings_of(judge(checker, motion)) == {(kind, HEAD)}


def peak_of(motion, j, kind):
    """Largest speed, acceleration or jerk of one joint's cubic pieces, jerk also from piece to piece."""
    t = motion.t_s
    spline = CubicHermiteSpline(t, motion.q[:, 7 + j], motion.v[:, 6 + j])
    if kind is FindingKind.VELOCITY_LIMIT:
        return np.abs(spline(np.concatenate([t, spline.derivative(2).roots(extrapolate=False)]), 1)).max()
    third = spline.derivative(3)(0.5 * (t[1:] + t[:-1]))
    early = spline(t[:-1], 2)
    late = early + third * np.diff(t)
    if kind is FindingKind.ACCELERATION_LIMIT:
        return np.abs([early, late]).max()
    spread = np.diff(0.5 * (early + late)) / np.diff(t)[:-1]
    step = (early[1:] - late[:-1]) / np.diff(t)[:-1]
    return max(np.abs(part).max() for part in (third, spread, step))


class replace_limits:  # noqa: N801 - reads as a statement
    """Raise all limits of the head but one, so that only that one is on trial."""

    def __init__(self, model, kind):
        self.model, self.kind = model, kind
        self.arrays = {
            FindingKind.VELOCITY_LIMIT: model.velocity,
            FindingKind.ACCELERATION_LIMIT: model.acceleration,
            FindingKind.JERK_LIMIT: model.jerk,
        }

    def __enter__(self):
        j = self.model.joint_index(HEAD)
        self.saved = {kind: array[j] for kind, array in self.arrays.items()}
        for kind, array in self.arrays.items():
            if kind is not self.kind:
                array[j] *= 10.0

    def __exit__(self, *_):
        j = self.model.joint_index(HEAD)
        for kind, value in self.saved.items():
            self.arrays[kind][j] = value


@pytest.mark.requirement("S1", "S6")
def test_the_message_names_joint_time_value_and_limit(motions, checker):
    answer = judge(checker, with_use(motions, FindingKind.VELOCITY_LIMIT, 1.2))

    assert isinstance(answer, Unsafe)
    finding = next(f for f in answer.findings if f.kind is FindingKind.VELOCITY_LIMIT)
    assert finding.subject == (HEAD,)
    assert finding.limit == motions.model.velocity[motions.model.joint_index(HEAD)]
    assert finding.value == pytest.approx(1.2 * finding.limit, rel=1e-3)
    assert str(answer).startswith("Unsafe trajectory: ")
    assert HEAD in str(answer)


def test_a_position_limit_passed_between_two_samples_is_found(motions, checker, findings_of):
    motion = motions.still(1.0, 3)
    j = motions.model.joint_index(HEAD)
    q, v = motion.q.copy(), motion.v.copy()
    upper = motions.model.upper_rad[j]
    # both samples are 0.02 rad inside; the cubic between them bows 0.025 rad out
    q[:, 7 + j] = upper - 0.02
    v[1, 6 + j], v[2, 6 + j] = 0.36, -0.36
    motion = replace(motion, q=q, v=v)

    assert (FindingKind.POSITION_LIMIT, HEAD) in findings_of(judge(checker, motion))


def test_a_speed_reached_between_two_samples_is_found(motions, checker, findings_of):
    motion = motions.joint(HEAD, 0.8, 1.3, 3)  # at rest in both neighbours of the fastest instant
    q, v = motion.q[[0, 2]], motion.v[[0, 2]]
    motion = Trajectory(motion.joints, motion.stance, motion.t_s[[0, 2]], q, v)

    over = findings_of(judge(checker, replace(motion, t_s=np.array([0.0, 1.15]))))
    fine = findings_of(judge(checker, replace(motion, t_s=np.array([0.0, 1.3]))))

    assert (FindingKind.VELOCITY_LIMIT, HEAD) in over
    assert (FindingKind.VELOCITY_LIMIT, HEAD) not in fine


@pytest.mark.parametrize("jump_rad", [0.005, 0.05, -0.5])
@pytest.mark.parametrize("length", [1, 2, 40])
def test_a_jump_of_a_joint_is_called_a_discontinuity(motions, checker, findings_of, jump_rad, length):
    motion = motions.joint(ELBOW, 0.3)
    q = motion.q.copy()
    q[70 : 70 + length, 7 + motions.model.joint_index(ELBOW)] += jump_rad

    assert (FindingKind.DISCONTINUITY, ELBOW) in findings_of(judge(checker, replace(motion, q=q)))


def test_velocities_that_do_not_belong_to_the_positions_are_refused(motions, checker, findings_of):
    motion = motions.joint(ELBOW, 0.3)

    answer = judge(checker, replace(motion, v=np.zeros_like(motion.v)))

    assert {name for _, name in findings_of(answer)} == {ELBOW}


def test_a_jump_of_the_base_is_refused(motions, checker, findings_of):
    motion = motions.joint(ELBOW, 0.3)
    q = motion.q.copy()
    q[70:, 2] += 0.005

    kinds = {kind for kind, *_ in findings_of(judge(checker, replace(motion, q=q)))}

    assert {FindingKind.DISCONTINUITY, FindingKind.STANCE} <= kinds


def test_a_step_of_acceleration_is_judged_as_jerk(motions, checker, findings_of):
    # constant acceleration from rest at the first sample on, as of a ramp of speed
    motion = motions.still(1.0, 101)
    j = motions.model.joint_index(HEAD)
    q, v = motion.q.copy(), motion.v.copy()
    late = np.maximum(motion.t_s - 0.5, 0.0)
    q[:, 7 + j] += 0.5 * 1.5 * late**2
    v[:, 6 + j] = 1.5 * late

    found = findings_of(judge(checker, replace(motion, q=q, v=v)))
    assert found == {(FindingKind.JERK_LIMIT, HEAD), (FindingKind.BOUNDARY_VELOCITY, HEAD)}


def test_efforts_beyond_the_motors_are_refused(motions, checker, findings_of, talos):
    j = talos.joint_index("arm_right_2_joint")
    saved, talos.effort[j] = talos.effort[j], 1.0
    try:
        answer = judge(checker, motions.still())
    finally:
        talos.effort[j] = saved

    assert findings_of(answer) == {(FindingKind.EFFORT_LIMIT, "arm_right_2_joint")}


def test_a_trajectory_of_other_joints_is_no_trajectory_of_this_robot(motions, checker):
    motion = motions.still()

    with pytest.raises(InvalidMotionError, match="talos"):
        judge(checker, replace(motion, joints=motion.joints[::-1]))


def test_standing_still_is_safe(motions, checker):
    answer = judge(checker, motions.still())

    assert isinstance(answer, CheckedTrajectory)
    assert answer.min_com_margin_m > 0.05
    assert 0.0 < answer.min_distance_m < 0.05
