"""Sampled surfaces: on the solid, outward, the same each time."""

import numpy as np
import pytest

from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.perception.surface import surface_points


@pytest.mark.parametrize("shape", [Cylinder(0.03, 0.1), Box((0.1, 0.2, 0.3)), Ball(0.04)], ids=str)
def test_points_lie_on_the_surface_with_outward_normals(shape):
    points, normals = surface_points(shape)

    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0)
    assert np.all(np.einsum("ij,ij->i", points, normals) > 0.0)
    np.testing.assert_allclose([_distance(shape, point) for point in points], 0.0, atol=2e-4)


@pytest.mark.parametrize("shape", [Cylinder(0.03, 0.1), Box((0.1, 0.1, 0.1)), Ball(0.04)], ids=str)
def test_about_half_of_a_compact_solid_faces_any_side(shape):
    _, normals = surface_points(shape)
    directions = np.random.default_rng(0).normal(size=(50, 3))

    shares = np.mean(normals @ directions.T > 1e-9, axis=0)

    assert np.all((shares > 0.3) & (shares < 0.6))


def _distance(shape, point):
    """Signed distance by definition, for each solid on its own."""
    x, y, z = np.abs(point)
    if isinstance(shape, Ball):
        return np.linalg.norm(point) - shape.radius_m
    if isinstance(shape, Cylinder):
        return max(np.hypot(x, y) - shape.radius_m, z - 0.5 * shape.height_m)
    return max(np.array([x, y, z]) - 0.5 * np.array(shape.size_m))
