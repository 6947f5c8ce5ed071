"""A thing of any shape is put down as its hull rests."""

import numpy as np
import pytest

from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.importing.resting import rests_of
from trees.skills.place.placement import how_it_stands


def leaning(rng, lean_rad):
    """A prism whose foot is not level when its own z is up."""
    wide, high = rng.uniform(0.03, 0.05), rng.uniform(0.06, 0.1)
    corners = np.array([[x, y, 0.0] for x in (-wide, wide) for y in (-wide, wide)])
    corners[:, 2] = np.tan(lean_rad) * corners[:, 0] - 0.5 * high
    corners = np.concatenate([corners, corners * (1, 1, 0) + (0, 0, 0.5 * high)])
    rests = rests_of(corners, corners.mean(axis=0)).up
    return ConvexParts("leaning", corners, (len(corners),), rests=rests)


@pytest.mark.parametrize("seed", range(5))
def test_what_leans_by_itself_stands_on_the_whole_of_its_foot(seed):
    rng = np.random.default_rng(seed)
    lean = rng.uniform(0.05, 0.25)
    parts = leaning(rng, lean)

    turn, height_m = how_it_stands(Box((0.1, 0.1, 0.1), parts))

    placed = parts.corners @ turn.T + (0.0, 0.0, height_m)
    assert placed[:, 2].min() == pytest.approx(0.0, abs=1e-9)
    assert np.sum(placed[:, 2] < 1e-3) == 4
    assert np.arccos(turn[2, 2]) == pytest.approx(lean, abs=1e-3)


def test_what_never_rests_nearly_upright_and_what_has_no_parts_stand_as_they_are_told():
    lying = ConvexParts("lying", np.eye(4)[:, :3], (4,), rests=np.array([[1.0, 0.0, 0.0]]))

    for shape in (Cylinder(0.03, 0.12, lying), Cylinder(0.03, 0.12)):
        turn, height_m = how_it_stands(shape)
        assert np.array_equal(turn, np.eye(3))
        assert height_m == 0.06
