"""After a stop for a weak leg the robot goes back to where its legs carried less."""

import numpy as np
import pytest

from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import RoundedPolyline
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.balanced_timing import time_in_balance
from kinematics.timing.curve_timing import Pace
from robots.control.health.finding import Ailment, Finding
from robots.control.streaming.body_track import BodyTrack

PERIOD_S = 0.002
LOW_M = 0.12
KNEE = "leg_left_4_joint"


def deep(talos, down=True):
    """Down by 12 cm from where it is at home, or up to there."""
    stance = stance_at(talos, talos.q_home)
    space = free_coordinates(StandingRobot(talos, stance))
    high = space.from_q(talos.q_home)
    low = high.copy()
    low[2] -= LOW_M
    ends = [high, low] if down else [low, high]
    curve = RoundedPolyline(np.stack(ends), space.weights, 0.3)
    return stance, time_in_balance(StandingRobot(talos, stance), curve, Pace(0.8, 1.0))


@pytest.fixture(name="lowering")
def lowering_fixture(talos):
    """A track half the way down, and its stance."""
    return begun(talos, *deep(talos))


def begun(talos, stance, trajectory):
    track = BodyTrack(StandingRobot(talos, stance), trajectory.q[0], PERIOD_S)
    track.play(trajectory)
    followed(track, seconds=0.5 * trajectory.duration_s)
    return stance, track


def followed(track, until=lambda track: False, seconds=5.0):
    """What is commanded until then, or until it rests."""
    rows = [track.now]
    while not track.resting and not until(track) and len(rows) <= round(seconds / PERIOD_S):
        track.propose()
        track.commit()
        rows.append(track.now)
    return rows


def lowest_m(track):
    return min(row.q[2] for row in followed(track))


@pytest.mark.requirement("F7", "S4")
def test_the_pelvis_rises_again_within_the_limits_and_with_the_feet_in_place(talos, lowering):
    stance, track = lowering
    track.brake(along_path=True, easing=KNEE)
    rows = followed(track)

    heights = np.array([row.q[2] for row in rows])
    a = np.array([row.a for row in rows])
    assert heights[-1] > heights.min() + 0.02
    assert not rows[-1].v.any()
    assert (np.abs(a[:, 6:]) <= talos.acceleration * 1.005).all()
    assert (np.abs(np.diff(a, axis=0)[:, 6:]) / PERIOD_S <= talos.jerk * 1.01).all()
    for frame, world_T_sole in stance.soles:
        np.testing.assert_allclose(talos.frame_pose(rows[-1].q, frame), world_T_sole, atol=1e-9)


def test_who_was_not_told_to_go_back_stays(lowering):
    _, track = lowering
    track.brake(along_path=True)

    assert lowest_m(track) == track.now.q[2]


def test_nobody_goes_back_to_where_the_legs_carried_more(talos):
    _, track = begun(talos, *deep(talos, down=False))
    track.brake(along_path=True, easing=KNEE)
    before_m = track.now.q[2]

    assert lowest_m(track) >= before_m


@pytest.mark.requirement("S2")
@pytest.mark.parametrize("category_1", [True, False])
def test_a_stop_on_the_way_back_stops(lowering, category_1):
    _, track = lowering
    track.brake(along_path=True, easing=KNEE)
    followed(track, until=lambda track: track.now.v[2] > 0.01)
    assert not track.resting

    track.brake(along_path=category_1)

    assert len(followed(track)) * PERIOD_S <= 0.5
    assert track.resting


@pytest.mark.requirement("S2")
def test_a_stop_while_it_brakes_leaves_no_way_back(lowering):
    _, track = lowering
    track.brake(along_path=True, easing=KNEE)
    followed(track, seconds=0.05)

    track.brake(along_path=True)

    assert lowest_m(track) == track.now.q[2]


def played_out(talos):
    """A track that was braked so near the end of its path that it went on to there."""
    for share in np.arange(0.60, 1.0, 0.01):
        stance, lowering = deep(talos)
        track = BodyTrack(StandingRobot(talos, stance), lowering.q[0], PERIOD_S)
        track.play(lowering)
        followed(track, seconds=share * lowering.duration_s)
        track.brake(along_path=True, easing=KNEE)
        if np.allclose(track.destination, lowering.q[-1], atol=1e-9):
            followed(track)
            return track
    raise AssertionError("it was never played out")


@pytest.mark.requirement("S2")
def test_a_motion_that_was_played_out_leaves_no_way_back_to_a_later_pause(talos):
    track = played_out(talos)
    _, rising = deep(talos, down=False)
    track.play(rising)
    followed(track, seconds=0.05)

    assert track.pause()

    assert len(followed(track)) * PERIOD_S <= 0.5
    assert track.paused


@pytest.mark.parametrize(
    ("ailment", "part", "weakens"),
    [
        (Ailment.WEAK, KNEE, True),
        (Ailment.OFFLINE, KNEE, True),
        (Ailment.STUCK, KNEE, False),
        (Ailment.WEAK, "arm_left_4_joint", False),
    ],
)
def test_only_a_weak_leg_is_a_reason(ailment, part, weakens):
    assert Finding(ailment, part, 1.0, 0.5).weakens({KNEE}) is weakens
