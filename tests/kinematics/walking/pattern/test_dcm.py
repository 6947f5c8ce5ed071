"""The closed forms against plain integration."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.quintic import Quintic
from kinematics.walking.pattern.com_motion import SteeredCom
from kinematics.walking.pattern.dcm import ZmpStretch, dcm_after, dcm_before, zmp_that_leads

OMEGA = 3.3
SWAY = ((0.01, -0.2, 0.3, 0.4), (0.0, 0.1, -0.5, 0.2))
metres = st.floats(-0.3, 0.3)


def integrated(stretch, dcm, axis, steps=20000):
    """DCM after a stretch by small steps of its differential equation."""
    dt = stretch.duration_s / steps
    value = dcm[axis]
    for k in range(steps):
        t = (k + 0.5) * dt
        pivot = np.polynomial.polynomial.polyval(t, stretch.pivot(axis))
        value = pivot + (value - pivot) * math.exp(OMEGA * dt)
    return value


def test_the_dcm_after_a_stretch_is_that_of_its_differential_equation():
    stretch = ZmpStretch(0.5, (0.0, 0.1), (0.2, -0.1), SWAY)

    ended = dcm_after([stretch], (0.05, 0.02), OMEGA)

    assert ended[0] == pytest.approx(integrated(stretch, (0.05, 0.02), 0), abs=1e-6)
    assert ended[1] == pytest.approx(integrated(stretch, (0.05, 0.02), 1), abs=1e-6)


@given(metres, metres, metres, metres)
def test_backwards_and_forwards_lead_to_the_same_place(x, y, start, end):
    stretches = [
        ZmpStretch(0.5, (start, end), (start, end), SWAY),
        ZmpStretch(0.12, (start, end), (end, start)),
    ]

    begun = dcm_before(stretches, (x, y), OMEGA)

    assert dcm_after(stretches, begun, OMEGA) == pytest.approx((x, y), abs=1e-9)


@given(metres, metres)
def test_the_point_that_was_asked_for_leads_where_it_should(now, goal):
    def through(knot):
        return [ZmpStretch(0.3, (0.0, 0.0), knot), ZmpStretch(0.3, knot, (0.1, 0.1), SWAY)]

    knot = zmp_that_leads(through, (now, -now), (goal, goal), OMEGA)

    assert dcm_after(through(knot), (now, -now), OMEGA) == pytest.approx((goal, goal), abs=1e-9)


def test_the_com_is_accelerated_away_from_the_pivot():
    motion = SteeredCom(ZmpStretch(0.5, (0.0, 0.0), (0.1, 0.0), SWAY), (0.02, 0.01), (0.05, 0.03), OMEGA)
    h = 1e-4

    before, now, after = (motion.at(0.2 + k * h) for k in (-1, 0, 1))

    for axis in (0, 1):
        acceleration = (after.com[axis] - 2.0 * now.com[axis] + before.com[axis]) / h**2
        velocity = (after.com[axis] - before.com[axis]) / (2.0 * h)
        assert acceleration == pytest.approx(OMEGA**2 * (now.com[axis] - now.pivot[axis]), abs=1e-4)
        assert now.dcm[axis] == pytest.approx(now.com[axis] + velocity / OMEGA, abs=1e-6)


@given(metres, metres, metres, metres)
def test_a_quintic_begins_at_its_state_and_rests_at_its_goal(x, v, a, goal):
    way = Quintic.to_rest(x, v, a, goal, 0.5)

    assert way.at(0.0) == pytest.approx((x, v, a))
    assert way.at(0.5 - 1e-9) == pytest.approx((goal, 0.0, 0.0), abs=1e-4)
    c = way.acceleration_from(0.2)
    assert c[0] + 0.1 * (c[1] + 0.1 * (c[2] + 0.1 * c[3])) == pytest.approx(way.at(0.3)[2], abs=1e-8)


@given(metres, metres, st.floats(-3.0, 3.0))
def test_a_pose_seen_from_itself_is_nowhere(x, y, yaw):
    pose = PlanarPose(x, y, yaw)

    back = pose @ pose.inverse()
    assert (back.x_m, back.y_m, back.yaw_rad) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("far_m", [1e15, 1e18, -1e30])
def test_from_a_dcm_that_is_lost_a_point_is_told_all_the_same(far_m):
    def through(knot):
        return [ZmpStretch(0.3, knot, knot)]

    assert np.isfinite(zmp_that_leads(through, (far_m, 0.0), (0.1, 0.2), OMEGA)).all()
