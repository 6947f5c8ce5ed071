"""Where handles go."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.scene.opening_measure import fitted_circle, moved_by
from kinematics.scene.opening_path import DoorArc, DrawerLine

ANGLES = st.floats(-0.5, 0.5)
SIDES = st.sampled_from([1.0, -1.0])
OPENINGS = st.floats(0.0, 1.5)


def door(side=1.0, yaw=0.15):
    return DoorArc(np.array([0.8, 0.75 * side]), yaw, side, 0.53, 0.075, 1.0)


@given(SIDES, ANGLES, OPENINGS)
def test_a_handle_stays_at_its_distance_from_the_hinge(side, yaw, s):
    arc = door(side, yaw)

    away = arc.at(s).position_m[:2] - arc.hinge_m

    assert np.linalg.norm(away) == pytest.approx(arc.lever_m)


@given(SIDES, ANGLES, OPENINGS)
def test_opening_a_little_more_moves_the_handle_outwards(side, yaw, s):
    arc = door(side, yaw)

    step = arc.at(s + 1e-4).position_m - arc.at(s).position_m

    assert step / (1e-4 * arc.lever_m) == pytest.approx(arc.at(s).outward, abs=1e-3)
    assert arc.at(s).outward @ arc.at(s).across == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_door_that_opens_comes_towards_who_opens_it(side):
    assert door(side, yaw=0.0).at(0.0).outward[0] < -0.9


@given(SIDES, ANGLES, OPENINGS, OPENINGS)
def test_what_is_on_a_door_moves_with_its_handle(side, yaw, s, t):
    arc = door(side, yaw)
    on_the_bar = poses.translation(*arc.at(s).position_m)

    assert arc.part_moved(on_the_bar, s, t)[:3, 3] == pytest.approx(arc.at(t).position_m)


@given(SIDES, ANGLES, OPENINGS, st.floats(-0.03, 0.03), st.floats(-0.03, 0.03))
def test_a_path_can_be_laid_through_where_a_bar_was_found(side, yaw, s, dx, dy):
    found = door(side, yaw).at(s).position_m + np.array([dx, dy, 0.0])

    assert door(side, yaw).through(found, s).at(s).position_m == pytest.approx(found)


def test_a_drawer_comes_straight_out():
    line = DrawerLine(np.array([0.7, 0.3, 0.9]), 0.0)

    assert line.at(0.25).position_m == pytest.approx([0.45, 0.3, 0.9])
    assert moved_by(np.array([line.at(0.05).position_m, line.at(0.3).position_m]), line) == pytest.approx(
        0.25
    )


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_long_arc_is_measured_about_its_own_centre(side):
    true, believed = door(side), DoorArc(np.array([0.83, 0.73 * side]), 0.15, side, 0.56, 0.075, 1.0)
    points = np.array([true.at(s).position_m for s in np.linspace(0.0, 1.2, 200)])
    points += np.random.default_rng(0).normal(0.0, 0.0005, points.shape)

    centre, radius = fitted_circle(points[:, :2])

    assert centre == pytest.approx(true.hinge_m, abs=0.004)
    assert radius == pytest.approx(true.lever_m, abs=0.004)
    assert moved_by(points, believed) == pytest.approx(1.2, abs=0.01)


def test_a_short_arc_is_measured_about_the_believed_hinge():
    arc = door()
    points = np.array([arc.at(s).position_m for s in np.linspace(0.0, 0.1, 20)])

    assert moved_by(points, arc) == pytest.approx(0.1, abs=1e-6)
