"""A whole walk as values: it stays continuous, keeps the ZMP under its feet, and stops in time."""

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.walking.body.whole_body import WholeBody
from kinematics.walking.pattern.pattern import WalkingPattern
from kinematics.walking.pattern.pattern_sample import Phase
from kinematics.walking.pattern.steering import (
    PathSteering,
    StretchSteering,
    VelocitySteering,
    quickened,
)
from robots.models.description import load_description, load_robot

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


class Walk:
    """A pattern from standing at home, with its whole body."""

    def __init__(self, model, quick=False):
        settings = model.description.walking
        self.settings = quickened(settings) if quick else settings
        soles = {sole.side: sole for sole in model.description.soles}
        self.feet = {
            side: PlanarPose.of(model.frame_pose(model.q_home, sole.frame)) for side, sole in soles.items()
        }
        self.body = WholeBody(model, model.q_home, self.feet, PERIOD_S, self.settings.first_shift_s)
        x, y, _ = model.com(model.q_home).tolist()
        self.pattern = WalkingPattern(
            self.settings,
            soles,
            self.feet,
            (x, y),
            self.body.rest_m,
            0.17,
            self.body.omega,
            self.body.sway_s2,
        )

    def samples(self, periods, finish_after=None):
        """The pattern's instants until it rests."""
        found = []
        for k in range(periods):
            if k == finish_after:
                self.pattern.finish()
            found.append(self.pattern.advance(PERIOD_S))
            if found[-1].phase is Phase.REST:
                break
        return found


@pytest.mark.parametrize("velocity", [(0.5, 0.0), (-0.5, 0.0), (0.3, 0.5), (0.0, 1.0)])
def test_com_and_dcm_never_jump(model, velocity):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, *velocity))

    samples = walk.samples(6000, finish_after=2500)

    com = np.array([sample.com.com for sample in samples])
    dcm = np.array([sample.com.dcm for sample in samples])
    assert np.abs(np.diff(com, axis=0)).max() < 1.0 * PERIOD_S
    assert np.abs(np.diff(dcm, axis=0)).max() < 1.5 * PERIOD_S
    assert np.abs(np.diff(com, n=2, axis=0)).max() < 6.0 * PERIOD_S**2


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("velocity", [(0.5, 0.0), (-0.45, 0.33)])
def test_a_walk_stops_within_2_2_seconds_and_two_landings_whenever_it_is_told(model, velocity):
    for told in range(20, 2400, 290):
        walk = Walk(model)
        walk.pattern.steer(VelocitySteering(walk.settings, *velocity))
        walk.samples(told)
        landed = walk.pattern.steps

        samples = walk.samples(2000, finish_after=0)

        assert samples[-1].phase is Phase.REST
        assert len(samples) * PERIOD_S <= 2.2
        assert walk.pattern.steps - landed <= 2


@pytest.mark.requirement("S10")
@pytest.mark.parametrize("velocity", [(0.3, 0.0), (-0.3, 0.0), (0.0, 0.4), (0.3, -0.4), (-0.3, 0.4)])
def test_a_walk_in_quick_steps_rests_within_1_8_seconds_whenever_it_is_told(model, velocity):
    for told in range(20, 2400, 97):
        walk = Walk(model, quick=True)
        walk.pattern.steer(VelocitySteering(model.description.walking, *velocity, quick=True))
        walk.samples(told)

        samples = walk.samples(2000, finish_after=0)

        assert samples[-1].phase is Phase.REST
        assert len(samples) * PERIOD_S <= 1.8


def test_the_zmp_stays_under_the_foot_that_stands(model):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.5, 0.3))
    sole = model.description.soles[0]

    for sample in walk.samples(5000, finish_after=3000):
        if len(sample.carrying) == 1:
            seen = sample.feet[sample.carrying[0]].to(PlanarPose(*sample.com.zmp))
            assert sole.x_m[0] <= seen.x_m <= sole.x_m[1]
            assert sole.y_m[0] <= seen.y_m <= sole.y_m[1]


def test_at_the_end_the_legs_are_at_home_on_parallel_feet(model):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.3, 0.2))

    motions = [walk.body.follow(sample) for sample in walk.samples(5000, finish_after=1500)]
    motions += [walk.body.follow(walk.pattern.advance(PERIOD_S)) for _ in range(3)]

    left, right = walk.pattern.feet["left"], walk.pattern.feet["right"]
    assert right.to(left).y_m == pytest.approx(0.17, abs=1e-9)
    assert right.to(left).yaw_rad == pytest.approx(0.0, abs=1e-9)
    assert np.abs(motions[-1].q[7:] - model.q_home[7:]).max() < 1e-5
    assert np.abs(motions[-1].v).max() < 1e-3


def test_each_position_follows_from_the_one_before_and_both_velocities(model):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.5, 0.0))
    motions = [walk.body.follow(sample) for sample in walk.samples(3000, finish_after=2000)]

    q, v = np.array([m.q[7:] for m in motions]), np.array([m.v[6:] for m in motions])

    assert np.abs(np.diff(q, axis=0) - 0.5 * PERIOD_S * (v[1:] + v[:-1])).max() < 1e-12
    limits = HARDWARE.walking.joint_acceleration
    most = np.array([limits.get(name, np.inf) for name in model.joints])
    assert (np.abs(np.diff(v, axis=0)) / PERIOD_S <= most).all()


def test_the_soles_are_where_the_pattern_has_them(model):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.3, 0.5))
    samples = walk.samples(1500)
    motions = [walk.body.follow(sample) for sample in samples]

    for k in range(1, 1499, 50):
        for sole in model.description.soles:
            found = model.frame_pose(motions[k].q, sole.frame)
            wanted = samples[k - 1].feet[sole.side]
            assert found[2, 3] == pytest.approx(samples[k - 1].lift_m[sole.side], abs=1e-3)
            assert PlanarPose.of(found).distance_m(wanted) < 1e-3


def at_its_end(model, phase):
    """A walk that was told to finish, in its last phases."""
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.4, 0.0))
    walk.samples(2000)
    walk.pattern.finish()
    while walk.pattern.phase is not phase:
        walk.pattern.advance(PERIOD_S)
    return walk


def middle(walk):
    return PlanarPose.between(walk.pattern.feet["left"], walk.pattern.feet["right"])


@pytest.mark.parametrize("phase", [Phase.CLOSE, Phase.SETTLE])
@pytest.mark.parametrize("error", [(0.13, 0.02), (-0.13, 0.0), (0.0, 0.21), (0.02, -0.21)])
def test_a_body_that_tips_over_both_soles_at_the_end_of_a_walk_steps_on_to_that_side(model, phase, error):
    walk = at_its_end(model, phase)
    stood, landed = middle(walk), walk.pattern.steps

    went_on = walk.pattern.step_on(error)
    samples = walk.samples(4000)
    gone = stood.to(middle(walk))

    assert went_on
    assert samples[-1].phase is Phase.REST
    assert 2 <= walk.pattern.steps - landed <= 4
    assert gone.x_m * error[0] + gone.y_m * error[1] > 0.012
    dcm = np.array([sample.com.dcm for sample in samples])
    assert np.abs(np.diff(dcm, axis=0)).max() < 1.5 * PERIOD_S


@pytest.mark.parametrize("phase", [Phase.CLOSE, Phase.SETTLE])
def test_a_body_that_both_soles_hold_comes_to_rest_where_it_is(model, phase):
    walk = at_its_end(model, phase)
    landed = walk.pattern.steps

    assert not walk.pattern.step_on((0.05, 0.03))
    walk.samples(4000)

    assert walk.pattern.steps == landed


def test_a_foot_in_the_air_is_left_to_what_moves_landings(model):
    walk = at_its_end(model, Phase.SWING)

    assert not walk.pattern.step_on((0.2, 0.0))


def test_who_steps_on_is_not_stopped_in_the_middle_of_that(model):
    walk = at_its_end(model, Phase.CLOSE)
    landed = walk.pattern.steps
    walk.pattern.step_on((0.13, 0.0))
    walk.samples(20)

    samples = walk.samples(4000, finish_after=0)

    assert samples[-1].phase is Phase.REST
    assert walk.pattern.steps - landed >= 2


@pytest.mark.parametrize(
    "goal", [PlanarPose(1.0, 0.4, 1.0), PlanarPose(-0.2, 0.1, -0.3), PlanarPose(0.05, 0.0, 0.0)]
)
def test_a_path_ends_between_the_feet(model, goal):
    walk = Walk(model)
    walk.pattern.steer(PathSteering(walk.settings, (PlanarPose(), goal)))

    samples = walk.samples(30000)

    assert samples[-1].phase is Phase.REST
    off = goal.to(PlanarPose.between(walk.pattern.feet["left"], walk.pattern.feet["right"]))
    assert np.hypot(off.x_m, off.y_m) < 0.008
    assert abs(off.yaw_rad) < 0.01


@pytest.mark.parametrize("speed", [0.3, -0.25])
def test_a_stretch_is_as_long_as_was_asked_for(model, speed):
    walk = Walk(model)
    walk.pattern.steer(StretchSteering(walk.settings, PlanarPose(), speed, 0.7))

    walk.samples(10000)

    body = PlanarPose.between(walk.pattern.feet["left"], walk.pattern.feet["right"])
    assert body.x_m == pytest.approx(0.7 if speed > 0.0 else -0.7, abs=0.008)


@pytest.mark.parametrize("shift", [PlanarPose(0.02, 0.0), PlanarPose(0.0, -0.02), PlanarPose(0.0, 0.0, 0.05)])
def test_a_robot_found_elsewhere_during_its_last_step_stands_before_it_steps_again(model, shift):
    walk = Walk(model)
    walk.pattern.steer(PathSteering(walk.settings, (PlanarPose(), PlanarPose(0.3, 0.0))))
    apart = 0.0

    for _ in range(15000):
        sample = walk.pattern.advance(PERIOD_S)
        walk.body.follow(sample)  # raises when the pattern runs away from its feet
        apart = max(apart, float(np.hypot(*np.subtract(sample.com.dcm, sample.com.com))))
        if sample.phase is Phase.SWING:
            beside = sample.feet[sample.carrying[0]].to(walk.pattern.goal)
            if abs(beside.x_m) < 1e-3 and abs(abs(beside.y_m) - 0.17) < 1e-3:
                walk.pattern.odom_T_plan = shift
        if sample.phase is Phase.REST:
            break

    assert sample.phase is Phase.REST
    assert apart < 0.15


def test_a_body_that_is_at_the_goal_of_a_path_goes_there_straight_wherever_the_path_goes(model):
    goal = PlanarPose(0.5, 0.05, 0.0)
    path = (PlanarPose(), PlanarPose(1.5, 0.0), PlanarPose(1.5, 0.05), goal)
    steering = PathSteering(model.description.walking, path)

    step = steering.advance(PlanarPose(0.5, 0.0), PlanarPose())

    assert step == PlanarPose(0.0, 0.05, 0.0)


def test_a_turn_in_which_the_soles_twist_is_planned_narrower(model):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.0, 1.0))
    twist_rad, turned_rad, found, before = 0.05, 0.0, PlanarPose(), Phase.REST

    for _ in range(6000):  # each landing twists the plan a little to the left
        sample = walk.pattern.advance(PERIOD_S)
        if sample.phase is Phase.SWING and before is not Phase.SWING:
            found = found @ PlanarPose(yaw_rad=twist_rad)
            walk.pattern.locate(found)
            heading = found.yaw_rad + PlanarPose.between(sample.feet["left"], sample.feet["right"]).yaw_rad
            step_rad, turned_rad = heading - turned_rad, heading
        before = sample.phase

    assert step_rad == pytest.approx(walk.settings.step_s, rel=0.03)


def test_a_stretch_is_not_turned_by_soles_that_twist(model):
    walk = Walk(model)
    walk.pattern.locate(PlanarPose(yaw_rad=0.1))
    walk.pattern.steer(VelocitySteering(walk.settings, 0.3, 0.0))

    samples = walk.samples(2000)

    assert max(abs(pose.yaw_rad) for sample in samples for pose in sample.feet.values()) < 1e-3


def test_the_landings_that_are_planned_are_those_that_come(model):
    walk = Walk(model)
    walk.pattern.steer(VelocitySteering(walk.settings, 0.3, 0.1))
    planned, landed, feet = [], [], dict(walk.pattern.feet)
    for _ in range(3000):
        walk.pattern.advance(PERIOD_S)
        if walk.pattern.phase is Phase.SWING and len(planned) == len(landed):
            planned.append(walk.pattern.landings[0])
            assert len(walk.pattern.landings) > 1
        for side, pose in walk.pattern.feet.items():
            if pose != feet[side]:
                landed.append((side, pose))
        feet = dict(walk.pattern.feet)

    assert len(landed) > 5
    assert planned[: len(landed)] == landed


def test_at_rest_no_landing_is_planned(model):
    assert Walk(model).pattern.landings == []
