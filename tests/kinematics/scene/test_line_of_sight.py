"""What stands in between hides, and what stands elsewhere does not; rays against points on the way."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.scene.line_of_sight import hidden, near_line
from kinematics.scene.planning_scene import SceneObject

EYE = np.array([0.0, 0.0, 1.5])
SHAPES = [Box((0.2, 0.3, 0.4)), Cylinder(0.12, 0.3), Ball(0.15)]


def inside(item, points):
    """Whether points, shape (n, 3), lie in a solid: an independent reference."""
    inverse = poses.inverse(item.world_T_object)
    local = points @ inverse[:3, :3].T + inverse[:3, 3]
    if isinstance(item.shape, Box):
        return np.all(np.abs(local) <= 0.5 * np.array(item.shape.size_m), axis=1)
    if isinstance(item.shape, Ball):
        return np.linalg.norm(local, axis=1) <= item.shape.radius_m
    high = np.abs(local[:, 2]) <= 0.5 * item.shape.height_m
    return high & (np.linalg.norm(local[:, :2], axis=1) <= item.shape.radius_m)


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: type(shape).__name__)
@settings(max_examples=60, deadline=None)
@given(
    angles=st.tuples(*[st.floats(-3.0, 3.0)] * 3),
    place=st.tuples(st.floats(0.3, 0.7), st.floats(-0.3, 0.3), st.floats(0.8, 1.3)),
    point=st.tuples(st.floats(0.2, 1.2), st.floats(-0.6, 0.6), st.floats(0.5, 1.5)),
)
def test_a_point_is_hidden_when_a_place_on_the_way_lies_in_the_solid(shape, angles, place, point):
    item = SceneObject("thing", shape, poses.transform(poses.rotation_from_vector(np.array(angles)), place))
    along = np.linspace(0.0, 0.998, 2001)[:, None]
    on_the_way = inside(item, EYE + along * (np.array(point) - EYE))

    told = bool(hidden(EYE, np.array([point]), [item])[0])

    if on_the_way.sum() > 2:  # a line that just grazes it may fall between the samples
        assert told
    if told:
        shrunk = inside(item, EYE + np.linspace(0.0, 1.0, 20001)[:, None] * (np.array(point) - EYE))
        assert shrunk.any() or on_the_way.any()


def test_only_lines_that_pass_a_hand_are_near_it():
    points = np.array([[1.0, 0.0, 1.5], [1.0, 0.5, 1.5], [0.2, 0.0, 1.5]])

    near = near_line(EYE, points, np.array([[0.5, 0.05, 1.5]]), 0.1)

    assert near.tolist() == [True, False, False]
