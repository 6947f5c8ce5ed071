"""Hulls that reach into each other, against an independent program's answer."""

import coal
import numpy as np
import pytest

from robots.scenes.hull_overlap import hulls_overlap


def hull(rng, middle):
    return middle + rng.uniform(0.02, 0.1) * rng.normal(size=(20, 3))


def depth_by_coal(one, other):
    shapes = []
    for corners in (one, other):
        points = coal.StdVec_Vec3s()
        points.extend(list(corners))
        shapes.append(coal.Convex.convexHull(points, True, ""))
    result = coal.DistanceResult()
    request = coal.DistanceRequest()
    coal.distance(shapes[0], coal.Transform3s(), shapes[1], coal.Transform3s(), request, result)
    return -result.min_distance


@pytest.mark.parametrize("seed", range(4))
def test_hulls_overlap_where_an_independent_program_says_so(seed):
    rng = np.random.default_rng(seed)
    for _ in range(60):
        one, other = hull(rng, np.zeros(3)), hull(rng, rng.uniform(-0.25, 0.25, 3))
        depth = depth_by_coal(one, other)
        if abs(depth - 5e-4) < 1e-3:
            continue

        assert hulls_overlap([one], [other], 5e-4) == (depth > 5e-4)


def test_what_stands_on_something_does_not_overlap_it():
    box = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)

    assert not hulls_overlap([box], [box * (0.5, 0.5, 1.0) + (0.2, 0.2, 1.0)], 5e-4)
    assert hulls_overlap([box], [box * (0.5, 0.5, 1.0) + (0.2, 0.2, 0.99)], 5e-4)
