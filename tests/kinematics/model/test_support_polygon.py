import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial import ConvexHull

from kinematics.errors import KinematicsError, UnknownNameError
from kinematics.geometry import poses
from kinematics.model.robot_description import SoleDescription
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon

SOLES = tuple(
    SoleDescription(side, side, "link", (-0.11, 0.10), (-0.065, 0.065), 0.02) for side in ("left", "right")
)


def stance_of(left, right):
    def place(x, y, yaw):
        return poses.transform(poses.rotation_z(yaw), (x, y, 0.0))

    return Stance((("left", place(*left)), ("right", place(*right))))


def corners(stance):
    """The soles' corners, computed by other means than the polygon's."""
    rectangle = np.array([(x, y, 0.0, 1.0) for x in (-0.11, 0.10) for y in (-0.065, 0.065)])
    return np.vstack([(pose @ rectangle.T).T[:, :2] for _, pose in stance.soles])


places = st.tuples(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3), st.floats(-1.5, 1.5))


@given(left=places, right=places, point=arrays(float, 2, elements=st.floats(-0.6, 0.6)))
def test_the_margin_is_that_of_an_independent_convex_hull(left, right, point):
    stance = stance_of(left, right)
    hull = ConvexHull(corners(stance))

    margin = SupportPolygon(stance, SOLES).com_margin_m(point)

    expected = -(hull.equations[:, :2] @ point + hull.equations[:, 2]).max()
    assert margin == pytest.approx(expected, abs=1e-9)


def test_many_points_at_once_have_the_margins_that_they_have_alone():
    polygon = SupportPolygon(stance_of((0, 0.085, 0), (0, -0.085, 0)), SOLES)
    points = np.array([[0.0, 0.0], [0.09, 0.0], [0.2, 0.0]])

    assert polygon.margins_m(points).tolist() == [polygon.com_margin_m(point) for point in points]


@pytest.mark.parametrize(("x", "margin"), [(0.0, 0.1), (0.09, 0.01), (0.1, 0.0), (0.15, -0.05)])
def test_the_margin_falls_to_zero_at_the_toes_and_is_negative_beyond(x, margin):
    polygon = SupportPolygon(stance_of((0, 0.085, 0), (0, -0.085, 0)), SOLES)

    assert polygon.com_margin_m(np.array([x, 0.0])) == pytest.approx(margin)


def test_one_foot_alone_carries_only_above_itself():
    both = stance_of((0, 0.085, 0), (0, -0.085, 0))

    polygon = SupportPolygon(Stance(both.soles[:1]), SOLES)

    assert polygon.com_margin_m(np.array([0.0, 0.085])) == pytest.approx(0.065)
    assert polygon.com_margin_m(np.array([0.0, 0.0])) < 0.0


def test_a_stance_of_unknown_or_no_soles_is_an_error():
    with pytest.raises(UnknownNameError, match="did you mean 'left'"):
        SupportPolygon(Stance((("lefty", np.eye(4)),)), SOLES)
    with pytest.raises(KinematicsError, match="no support polygon"):
        SupportPolygon(Stance(()), SOLES)


def test_the_home_posture_stands_with_its_com_well_inside(talos, stance):
    polygon = SupportPolygon(stance, talos.description.soles)

    assert polygon.com_margin_m(talos.com(talos.q_home)[:2]) > 0.05


def test_standing_puts_the_base_back_where_the_soles_want_it(talos, stance):
    lost = talos.q_home.copy()
    lost[:7] = (0.3, -0.2, 0.7, 0.0, 0.0, np.sin(0.2), np.cos(0.2))

    found = StandingRobot(talos, stance).placed(lost)

    np.testing.assert_allclose(found, talos.q_home, atol=1e-12)
    for (frame, before), (_, after) in zip(stance.soles, stance_at(talos, found).soles, strict=True):
        np.testing.assert_allclose(after, before, atol=1e-12, err_msg=frame)
