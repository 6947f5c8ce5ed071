"""Source: statics. A wrench moves by the moment of its force; what is pressed outside itself tips."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.dynamics.sole_shares import SoleShares
from kinematics.geometry import poses
from kinematics.model.stance import Stance
from kinematics.model.support_polygon import SupportPolygon


def standing(talos, feet):
    """A stance of soles at x, y, yaw, and its shares."""
    frames = [sole.frame for sole in talos.description.soles]
    soles = tuple(
        (frame, poses.transform(poses.rotation_z(yaw), (x, y, 0.0)))
        for frame, (x, y, yaw) in zip(frames, feet, strict=False)
    )
    stance = Stance(soles)
    return stance, SoleShares(stance, talos.description.soles)


def wrench_at(zmp, lift_n, shear_n, twist_nm):
    """The ground's wrench about the world's origin with a ZMP at (x, y)."""
    force = np.array([*shear_n, lift_n])
    moment = np.cross([*zmp, 0.0], force) + np.array([0.0, 0.0, twist_nm])
    return np.concatenate([force, moment])


def pressed_at(wrench):
    return np.array([-wrench[4], wrench[3]]) / wrench[2]


SIDE_BY_SIDE = ((0.0, 0.085, 0.0), (0.0, -0.085, 0.0))
TURNED = tuple((1.0 - y * np.sin(0.4), 2.0 + y * np.cos(0.4), 0.4) for y in (0.12, -0.12))
ASTRIDE = ((0.15, 0.1, 0.1), (-0.05, -0.1, -0.2))

around = st.floats(-0.2, 0.2)
small = st.floats(-50.0, 50.0)


@given(x=around, y=around, fx=small, fy=small, twist=small, lift=st.floats(10.0, 2000.0))
@pytest.mark.parametrize("feet", [SIDE_BY_SIDE, TURNED, ASTRIDE, SIDE_BY_SIDE[:1]])
def test_soles_together_give_what_the_ground_has_to(talos, feet, x, y, fx, fy, twist, lift):
    net = wrench_at((x, y), lift, (fx, fy), twist)

    wrenches = standing(talos, feet)[1].wrenches(net).reshape(-1, 6)

    np.testing.assert_allclose(wrenches.sum(axis=0), net, atol=1e-8)
    assert (wrenches[:, 2] >= 0.0).all()


@given(along=st.floats(-0.2, 0.2), across=st.floats(-0.2, 0.2))
@pytest.mark.parametrize("feet", [SIDE_BY_SIDE, TURNED])
def test_no_sole_side_by_side_is_asked_to_press_outside_itself_while_the_zmp_is_inside(
    talos, feet, along, across
):
    stance, shares = standing(talos, feet)
    middle = np.mean([pose[:2, 3] for _, pose in stance.soles], axis=0)
    zmp = middle + np.array([along, across])
    polygon = SupportPolygon(stance, talos.description.soles)
    if polygon.margins_m(zmp[None])[0] < 1e-6:
        return

    wrenches = shares.wrenches(wrench_at(zmp, 900.0, (5.0, -3.0), 2.0)).reshape(-1, 6)

    for (frame, _), wrench in zip(stance.soles, wrenches, strict=True):
        if wrench[2] < 1e-6:
            continue
        alone = Stance(tuple(sole for sole in stance.soles if sole[0] == frame))
        own = SupportPolygon(alone, talos.description.soles)
        assert own.margins_m(pressed_at(wrench)[None])[0] >= -1e-6


def test_halfway_to_the_edge_each_sole_is_pressed_halfway_to_its_own(talos):
    _, shares = standing(talos, SIDE_BY_SIDE)

    left, right = shares.wrenches(wrench_at((0.02, -0.075), 900.0, (0.0, 0.0), 0.0)).reshape(-1, 6)

    assert left[2] == pytest.approx(0.25 * 900.0)
    np.testing.assert_allclose(pressed_at(left), [0.02, 0.085 - 0.0325], atol=1e-9)
    np.testing.assert_allclose(pressed_at(right), [0.02, -0.085 - 0.0325], atol=1e-9)


def test_more_than_two_soles_are_refused(talos):
    one = standing(talos, SIDE_BY_SIDE[:1])[0].soles[0]

    with pytest.raises(ValueError, match="3 soles"):
        SoleShares(Stance((one, one, one)), talos.description.soles)


def test_soles_on_a_platform_take_the_parts_that_they_take_on_the_floor(talos):
    stance, shares = standing(talos, SIDE_BY_SIDE)
    up = poses.translation(0.0, 0.0, 0.1)
    raised = Stance(tuple((frame, up @ pose) for frame, pose in stance.soles))
    force = np.array([40.0, -60.0, 900.0])
    below = np.concatenate([force, np.cross([0.02, 0.03, 0.0], force)])
    above = np.concatenate([force, np.cross([0.02, 0.03, 0.1], force)])

    on_floor = shares.wrenches(below).reshape(-1, 6)
    on_platform = SoleShares(raised, talos.description.soles).wrenches(above).reshape(-1, 6)

    np.testing.assert_allclose(on_platform[:, :3], on_floor[:, :3], atol=1e-9)
